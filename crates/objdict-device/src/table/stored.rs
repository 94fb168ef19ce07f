use super::{BOOLEAN, Data, Entry, Table};

/// A storage group: values that are saved together, as an image of `IMAGE` bytes.
///
/// An image consists of the layout (a hash, four bytes), the values and a CRC-16, all little-endian. A string
/// occupies its full capacity after its length.
#[derive(Clone, Copy, Debug)]
pub struct Group<D, const IMAGE: usize> {
    /// The offset of the first value.
    pub(super) first: u32,
    /// A hash of index, sub-index, data type and length of all entries.
    pub(super) layout: u32,
    store_sub_index: Option<u8>,
    table: core::marker::PhantomData<fn() -> D>,
}

impl<D: Table, const IMAGE: usize> Group<D, IMAGE> {
    /// A group of all values from an offset on, as many as the image has.
    #[must_use]
    pub const fn new(first: u32, layout: u32, store_sub_index: Option<u8>) -> Self {
        Self { first, layout, store_sub_index, table: core::marker::PhantomData }
    }

    /// Size of an image in bytes.
    #[must_use]
    pub const fn image_size(self) -> usize {
        IMAGE
    }

    /// The sub-index of objects 1010h and 1011h for the group, if `CiA` 301 defines it.
    #[must_use]
    pub const fn store_sub_index(self) -> Option<u8> {
        self.store_sub_index
    }

    /// The places of the values.
    pub(super) const fn places(self) -> core::ops::Range<usize> {
        let first = self.first as usize;
        first..first + IMAGE - 6
    }
}

/// Why an image of a storage group is rejected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum ImageError {
    /// The length differs.
    Length,
    /// It belongs to a group with different entries, data types or lengths, or was never saved.
    Layout,
    /// Wrong CRC.
    Checksum,
    /// A value is not valid for its data type.
    Value,
}

impl core::fmt::Display for ImageError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Length => "the image has a different length",
            Self::Layout => "the image has a different layout",
            Self::Checksum => "the CRC of the image does not match",
            Self::Value => "a value of the image is not valid for its data type",
        })
    }
}

impl core::error::Error for ImageError {}

impl<D: Table, const RAM: usize> Data<D, RAM> {
    /// Writes the values of a group to an image for non-volatile memory.
    pub fn save<const IMAGE: usize>(&self, group: Group<D, IMAGE>, image: &mut [u8; IMAGE]) {
        let values = self.bytes.get(group.places()).unwrap_or(&[]);
        save(values, group.layout, image);
    }

    /// Reads the values of a group from an image without checking limits.
    ///
    /// # Errors
    /// The reason why the image is not valid; no value changes.
    pub fn load<const IMAGE: usize>(
        &mut self,
        group: Group<D, IMAGE>,
        image: &[u8],
    ) -> Result<(), ImageError> {
        self.take(group.places(), check(image, IMAGE, group.layout)?, |_| true)
    }

    pub(super) fn take(
        &mut self,
        places: core::ops::Range<usize>,
        values: &[u8],
        is_taken: impl Fn(u16) -> bool,
    ) -> Result<(), ImageError> {
        if members::<D>(places.clone()).any(|entry| entry.saved(places.start, values).is_none()) {
            return Err(ImageError::Value);
        }
        for entry in members::<D>(places.clone()).filter(|entry| is_taken(entry.index())) {
            if let Some(bytes) = entry.saved(places.start, values) {
                self.keep(entry, bytes);
            }
        }
        Ok(())
    }

    /// Sets the values of a group to their defaults.
    pub fn reset<const IMAGE: usize>(&mut self, group: Group<D, IMAGE>) {
        for entry in members::<D>(group.places()) {
            self.set_default(entry);
        }
    }
}

pub(super) fn members<D: Table>(places: core::ops::Range<usize>) -> impl Iterator<Item = &'static Entry<D>> {
    D::ENTRIES.iter().filter(move |entry| places.contains(&entry.ram()))
}

impl<D: Table> Entry<D> {
    /// The value in the image of a group, if it is valid for its data type.
    fn saved<'a>(&self, first: usize, values: &'a [u8]) -> Option<&'a [u8]> {
        let value = values.get(self.ram().checked_sub(first)?..)?;
        let value = value.get(..self.ram_size())?;
        if !self.has_length() {
            return (self.data_type() != BOOLEAN || matches!(value, [0 | 1])).then_some(value);
        }
        let (length, text) = value.split_first_chunk()?;
        text.get(..usize::from(u16::from_le_bytes(*length)))
    }
}

pub(super) fn save(values: &[u8], layout: u32, image: &mut [u8]) {
    let Some((head, rest)) = image.split_first_chunk_mut() else { return };
    let Some((body, crc)) = rest.split_last_chunk_mut() else { return };
    *head = layout.to_le_bytes();
    for (place, value) in body.iter_mut().zip(values) {
        *place = *value;
    }
    *crc = crc16(crc16(0, head), body).to_le_bytes();
}

/// The values of an image.
pub(super) fn check(image: &[u8], size: usize, layout: u32) -> Result<&[u8], ImageError> {
    if image.len() != size {
        return Err(ImageError::Length);
    }
    let (saved, crc) = image.split_last_chunk().ok_or(ImageError::Length)?;
    let (head, values) = saved.split_first_chunk().ok_or(ImageError::Length)?;
    if u32::from_le_bytes(*head) != layout {
        Err(ImageError::Layout)
    } else if u16::from_le_bytes(*crc) != crc16(0, saved) {
        Err(ImageError::Checksum)
    } else {
        Ok(values)
    }
}

/// The CRC of `CiA` 301: x^16 + x^12 + x^5 + 1, initial value 0.
fn crc16(crc: u16, bytes: &[u8]) -> u16 {
    bytes.iter().fold(crc, |crc, &byte| {
        (0..8).fold(crc ^ (u16::from(byte) << 8), |crc, _| {
            (crc << 1) ^ if crc & 0x8000 == 0 { 0 } else { 0x1021 }
        })
    })
}
