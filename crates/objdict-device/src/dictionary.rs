//! What a server needs of an object dictionary.

use crate::Abort;
use crate::table::{Data, Entry, Table};

/// What is known of an entry without its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attributes {
    /// The longest value in bytes; 0 for a DOMAIN whose data the application transfers.
    pub size: usize,
    /// The index of the data type, such as 07h for UNSIGNED32; 0 for a type of the device.
    pub data_type: u8,
    /// Whether it is readable by SDO.
    pub readable: bool,
    /// Whether it is writable by SDO.
    pub writable: bool,
    /// Whether it is mappable to TPDOs.
    pub fits_tpdo: bool,
    /// Whether it is mappable to RPDOs.
    pub fits_rpdo: bool,
}

/// An object dictionary as SDO servers and PDOs use it: values are little-endian bytes.
pub trait Dictionary {
    /// The attributes of an entry.
    ///
    /// # Errors
    /// [`Abort::NoObject`] or [`Abort::NoSubIndex`].
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort>;

    /// Copies a value to the start of a buffer and returns its length in bytes. The application may update the value first.
    ///
    /// # Errors
    /// Why an SDO upload of this entry is aborted; [`Abort::OutOfMemory`] when the buffer is shorter than the value.
    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort>;

    /// Replaces a value if access, length and limits allow it.
    ///
    /// # Errors
    /// Why an SDO download to this entry is aborted; the value is unchanged.
    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;

    /// The value of an entry as an unsigned number.
    ///
    /// # Errors
    /// Those of [`Dictionary::read`]; [`Abort::OutOfMemory`] for more than eight bytes.
    fn number(&mut self, index: u16, sub: u8) -> Result<u64, Abort> {
        let mut bytes = [0; 8];
        // a dictionary may use the rest of the buffer
        let length = self.read(index, sub, &mut bytes)?.min(8);
        bytes.iter_mut().skip(length).for_each(|byte| *byte = 0);
        Ok(u64::from_le_bytes(bytes))
    }
}

impl<D: Table> From<&Entry<D>> for Attributes {
    fn from(entry: &Entry<D>) -> Self {
        Self {
            size: entry.size(),
            data_type: entry.data_type(),
            readable: entry.is_readable(),
            writable: entry.is_writable(),
            fits_tpdo: entry.fits_tpdo(),
            fits_rpdo: entry.fits_rpdo(),
        }
    }
}

impl<D: Table, const RAM: usize> Dictionary for Data<D, RAM> {
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        Entry::<D>::find(index, sub).map(Attributes::from)
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        Self::read(self, index, sub, buffer)
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        Self::write(self, index, sub, bytes)
    }
}
