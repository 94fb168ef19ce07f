//! The services' view of an object dictionary.
//!
//! The services depend only on this trait. They accept frames and the time, return frames, and report their next
//! due time (`next`), so they are tested without a bus.

use crate::table::{Data, Entry, Table};
use crate::{Abort, ObjectSet};

/// The properties of an entry except its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attributes {
    /// The maximum length of a value in bytes; 0 for a DOMAIN whose data the application transfers.
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

impl Attributes {
    /// Whether the length of values varies, up to the size: strings, bytes and DOMAIN.
    #[must_use]
    pub const fn has_length(&self) -> bool {
        matches!(self.data_type, 0x09..=0x0B | 0x0F)
    }
}

/// The location of an entry in a dictionary, so that a PDO need not search for it again. Only the dictionary interprets
/// the number; all ones mean no entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place(pub u32);

/// The values that a reset restores (CiA 301 §7.3.2.2.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Scope {
    /// Values of 1000h to 1FFFh: reset communication.
    Communication,
    /// All: power-on and reset node.
    All,
}

impl Scope {
    /// Whether the values of an object are restored.
    #[must_use]
    pub const fn contains(self, index: u16) -> bool {
        matches!(self, Self::All) || matches!(index, 0x1000..=0x1FFF)
    }
}

/// An object dictionary as SDO servers and PDOs use it: values are little-endian bytes.
///
/// Override the methods with a default for more features: values that are transferred in pieces, and storage.
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

    /// Replaces a value that the device itself changes, such as the error register, regardless of its SDO
    /// access.
    ///
    /// # Errors
    /// If there is no such entry, it is a constant, or the value does not fit; the value is unchanged.
    fn replace(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;

    /// Restores the power-on values, for a different node-ID if it has changed.
    fn restart(&mut self, scope: Scope, node_id: u8);

    /// The value of an entry as an unsigned number.
    ///
    /// # Errors
    /// Like [`Dictionary::read`]; [`Abort::OutOfMemory`] for more than eight bytes.
    fn number(&mut self, index: u16, sub: u8) -> Result<u64, Abort> {
        let mut bytes = [0; 8];
        // a dictionary may use the rest of the buffer
        let length = self.read(index, sub, &mut bytes)?;
        Ok(number(bytes.get(..length).unwrap_or(&bytes)))
    }

    /// Locates an entry, for [`Dictionary::number_at`] and [`Dictionary::write_at`].
    ///
    /// # Errors
    /// Like [`Dictionary::attributes`].
    fn locate(&self, index: u16, sub: u8) -> Result<Place, Abort> {
        self.attributes(index, sub).map(|_| Place(u32::from(index) << 8 | u32::from(sub)))
    }

    /// The attributes of an entry.
    ///
    /// # Errors
    /// Like [`Dictionary::attributes`].
    fn attributes_at(&self, place: Place) -> Result<Attributes, Abort> {
        self.attributes((place.0 >> 8) as u16, place.0 as u8)
    }

    /// The value of an entry as an unsigned number.
    ///
    /// # Errors
    /// Like [`Dictionary::number`].
    fn number_at(&mut self, place: Place) -> Result<u64, Abort> {
        self.number((place.0 >> 8) as u16, place.0 as u8)
    }

    /// Replaces a value as an RPDO does.
    ///
    /// # Errors
    /// Like [`Dictionary::write`].
    fn write_at(&mut self, place: Place, bytes: &[u8]) -> Result<(), Abort> {
        self.write((place.0 >> 8) as u16, place.0 as u8, bytes)
    }

    /// Begins an upload. Returns `None` if [`Dictionary::read`] copies the value as a whole, or the length in bytes of
    /// a value that is then read in pieces, so that it may be longer than the server's buffer.
    ///
    /// # Errors
    /// Why the upload is aborted.
    fn begin_read(&mut self, index: u16, sub: u8) -> Result<Option<usize>, Abort> {
        let _ = (index, sub);
        Ok(None)
    }

    /// Fills a piece of an upload with the bytes at an offset. A client may request a piece again.
    ///
    /// # Errors
    /// Why the upload is aborted.
    fn read_piece(&mut self, index: u16, sub: u8, offset: usize, piece: &mut [u8]) -> Result<(), Abort> {
        let _ = (index, sub, offset, piece);
        Err(Abort::NoData)
    }

    /// Begins a download, whose length in bytes a client may state. Returns whether it arrives in pieces, so that it
    /// may be longer than the server's buffer; otherwise [`Dictionary::write`] gets the value as a whole. An unfinished
    /// previous download is abandoned.
    ///
    /// # Errors
    /// Why the download cannot succeed.
    fn begin_write(&mut self, index: u16, sub: u8, length: Option<usize>) -> Result<bool, Abort> {
        let _ = (index, sub, length);
        Ok(false)
    }

    /// Writes a piece of a download. The pieces arrive in order and without gaps.
    ///
    /// # Errors
    /// Why the download is aborted.
    fn write_piece(&mut self, index: u16, sub: u8, offset: usize, piece: &[u8]) -> Result<(), Abort> {
        let _ = (index, sub, offset, piece);
        Err(Abort::CannotStore)
    }

    /// Ends a download in pieces, all of which have arrived.
    ///
    /// # Errors
    /// Why the download is aborted.
    fn end_write(&mut self, index: u16, sub: u8, length: usize) -> Result<(), Abort> {
        let _ = (index, sub, length);
        Err(Abort::CannotStore)
    }

    /// Whether the application serves features that this crate does not: TPDOs on request (transmission types 252 and
    /// 253), multiplexed PDOs, 29-bit CAN-IDs, sending TIME, and more SDO channels and monitored nodes than a
    /// [`Node`](crate::Node) has. Otherwise writes that require them are rejected.
    fn serves_more(&self) -> bool {
        false
    }

    /// The communication objects, to omit services of missing ones at compile time. A dictionary that adds objects to a
    /// table, or transfers values in pieces, keeps the default.
    fn objects(&self) -> ObjectSet {
        ObjectSet::ANY
    }

    /// The node-ID of the values, if known: a node does not monitor itself.
    fn own_node_id(&self) -> Option<u8> {
        None
    }

    /// Whether values can be stored by a sub-index of 1010h.
    fn can_store(&self, sub: u8) -> bool {
        let _ = sub;
        false
    }

    /// Stores the values that a sub-index of 1010h names. The signature was correct.
    ///
    /// # Errors
    /// The reason why the values are not stored.
    fn store(&mut self, sub: u8) -> Result<(), Abort> {
        let _ = sub;
        Err(Abort::CannotStore)
    }

    /// Restores the defaults of the values that a sub-index of 1011h selects at the next reset. The signature
    /// was correct.
    ///
    /// # Errors
    /// The reason why the stored values are kept.
    fn restore(&mut self, sub: u8) -> Result<(), Abort> {
        let _ = sub;
        Err(Abort::CannotStore)
    }
}

/// Converts at most eight bytes to a number.
pub(crate) fn number(bytes: &[u8]) -> u64 {
    bytes.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte))
}

/// The lowest 32 bits of a number, or a default if it is missing. Not inlined: it has many callers, and needs
/// less flash than its result.
#[inline(never)]
pub(crate) fn word<D: Dictionary + ?Sized>(dictionary: &mut D, index: u16, sub: u8, default: u32) -> u32 {
    dictionary.number(index, sub).map_or(default, |number| number as u32)
}

/// Methods of [`Dictionary`] that forward to the dictionary in a field.
macro_rules! forward {
    ($field:ident: $(fn $name:ident($this:ident: $Receiver:ty $(, $argument:ident: $Type:ty)*) $(-> $Answer:ty)?;)+) => {
        $(fn $name($this: $Receiver $(, $argument: $Type)*) $(-> $Answer)? {
            $this.$field.$name($($argument),*)
        })+
    };
}
pub(crate) use forward;

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

/// The entry in a row of the table.
pub(crate) fn entry_at<D: Table>(place: Place) -> Result<&'static Entry<D>, Abort> {
    D::ENTRIES.get(place.0 as usize).ok_or(Abort::NoObject)
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

    fn replace(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.write_entry(Entry::find(index, sub)?, bytes)
    }

    fn restart(&mut self, scope: Scope, node_id: u8) {
        self.set_defaults(node_id, |index| scope.contains(index));
    }

    #[inline(always)]
    fn objects(&self) -> ObjectSet {
        const { ObjectSet::of::<D>() }
    }

    fn own_node_id(&self) -> Option<u8> {
        Some(self.node_id())
    }

    fn locate(&self, index: u16, sub: u8) -> Result<Place, Abort> {
        let row = Entry::<D>::find(index, sub)?.row();
        row.and_then(|row| u32::try_from(row).ok()).map(Place).ok_or(Abort::NoObject)
    }

    fn attributes_at(&self, place: Place) -> Result<Attributes, Abort> {
        entry_at::<D>(place).map(Attributes::from)
    }

    fn number_at(&mut self, place: Place) -> Result<u64, Abort> {
        let entry = entry_at(place)?;
        if !entry.is_readable() {
            return Err(Abort::WriteOnly);
        }
        let mut bytes = [0; 8];
        self.read_entry(entry, &mut bytes)?;
        Ok(u64::from_le_bytes(bytes))
    }

    fn write_at(&mut self, place: Place, bytes: &[u8]) -> Result<(), Abort> {
        let entry = entry_at(place)?;
        if entry.is_writable() { self.write_entry(entry, bytes) } else { Err(Abort::ReadOnly) }
    }

    fn begin_write(&mut self, index: u16, sub: u8, _: Option<usize>) -> Result<bool, Abort> {
        // a constant, or a DOMAIN without storage
        if Entry::<D>::find(index, sub)?.is_variable() { Ok(false) } else { Err(Abort::CannotStore) }
    }
}
