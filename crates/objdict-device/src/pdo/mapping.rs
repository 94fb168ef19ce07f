//! The content of a PDO: the values of its mapped entries, bit by bit.

use crate::dictionary::{Place, word};
use crate::{Abort, Dictionary};

/// The number of mapped entries that are located once, when the mapping is loaded; further ones are searched
/// each time.
const KEPT: usize = 8;

/// One mapped entry: a value of 1600h to 17FFh and 1A00h to 1BFFh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mapped {
    pub(crate) index: u16,
    pub(crate) sub: u8,
    /// Length in bits.
    pub(crate) bits: u8,
}

impl Mapped {
    pub(crate) const fn of(value: u64) -> Self {
        Self { index: (value >> 16) as u16, sub: (value >> 8) as u8, bits: value as u8 }
    }

    /// Whether an RPDO skips these bits: the index is that of a data type.
    pub(crate) const fn is_dummy(self) -> bool {
        matches!(self.index, 1..=7) && self.sub == 0
    }
}

/// A mapped entry that was found.
#[derive(Clone, Copy, Debug)]
struct FoundEntry {
    place: Place,
    bits: u8,
}

/// The place of a dummy.
const DUMMY: Place = Place(u32::MAX);

impl FoundEntry {
    fn of<D: Dictionary + ?Sized>(dictionary: &mut D, mapping: u16, sub: u8) -> Result<Self, Abort> {
        let mapped = Mapped::of(dictionary.number(mapping, sub)?);
        if mapped.bits == 0 {
            return Err(Abort::NotMappable);
        }
        let is_dummy = mapping < 0x1A00 && mapped.is_dummy();
        let place = if is_dummy { DUMMY } else { dictionary.locate(mapped.index, mapped.sub)? };
        Ok(Self { place, bits: mapped.bits })
    }
}

/// The mapping of a PDO.
#[derive(Clone, Copy, Debug)]
pub(super) struct ActiveMapping {
    count: u8,
    /// Length in bits, or the reason why the mapping is not valid.
    bits: Result<u8, Abort>,
    /// The locations of the first entries and their lengths in bits, stored separately to halve their memory.
    places: [Place; KEPT],
    lengths: [u8; KEPT],
}

impl ActiveMapping {
    pub(super) const fn new() -> Self {
        Self { count: 0, bits: Ok(0), places: [Place(0); KEPT], lengths: [0; KEPT] }
    }

    /// Locates the mapped entries of an object, such as 1A00h.
    pub(super) fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, index: u16) {
        self.count = word(dictionary, index, 0, 0).min(64) as u8;
        self.bits = self.find(dictionary, index);
    }

    fn find<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, index: u16) -> Result<u8, Abort> {
        let mut bits = 0;
        for at in 0..self.count {
            let found = FoundEntry::of(dictionary, index, at + 1)?;
            bits += found.bits.min(65);
            if bits > 64 {
                return Err(Abort::PdoTooLong);
            }
            let (at, FoundEntry { place, bits }) = (usize::from(at), found);
            if let (Some(kept), Some(length)) = (self.places.get_mut(at), self.lengths.get_mut(at)) {
                (*kept, *length) = (place, bits);
            }
        }
        Ok(bits)
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The number of bytes of the PDO.
    pub(super) fn length(&self) -> Result<u8, Abort> {
        self.bits.map(|bits| bits.div_ceil(8))
    }

    /// Calls a function for each mapped entry that is not a dummy, with its length and the position of its first bit.
    fn walk<D: Dictionary + ?Sized>(
        &self,
        dictionary: &mut D,
        index: u16,
        mut each: impl FnMut(&mut D, Place, u8, u8) -> Result<(), Abort>,
    ) -> Result<(), Abort> {
        self.bits?;
        let mut first = 0_u8;
        for at in 0..self.count {
            let kept = (self.places.get(usize::from(at)), self.lengths.get(usize::from(at)));
            let found = match kept {
                (Some(&place), Some(&bits)) => FoundEntry { place, bits },
                _ => FoundEntry::of(dictionary, index, at + 1)?,
            };
            // an application may have changed the mapping since it was loaded
            let end = first.saturating_add(found.bits);
            if end > 64 {
                return Err(Abort::PdoTooLong);
            }
            if found.place != DUMMY {
                each(dictionary, found.place, found.bits, first)?;
            }
            first = end;
        }
        Ok(())
    }

    /// The frame with the current values, and its length in bytes.
    pub(super) fn pack<D: Dictionary + ?Sized>(
        &self,
        dictionary: &mut D,
        index: u16,
    ) -> Result<(u64, u8), Abort> {
        let mut frame = 0;
        self.walk(dictionary, index, |dictionary, place, bits, first| {
            frame |= (dictionary.number_at(place)? & lowest(bits)) << first;
            Ok(())
        })?;
        Ok((frame, self.length()?))
    }

    /// Writes the values of a frame. A rejected value remains unchanged, and the others are still written.
    pub(super) fn unpack<D: Dictionary + ?Sized>(
        &self,
        dictionary: &mut D,
        index: u16,
        frame: u64,
    ) -> Result<(), Abort> {
        let mut answer = Ok(());
        self.walk(dictionary, index, |dictionary, place, bits, first| {
            answer = answer.and(write(dictionary, place, bits, frame >> first));
            Ok(())
        })?;
        answer
    }
}

/// Writes the lowest bits to a mapped entry. A description may map a part of a number, whose other bits are
/// then sign-extended.
fn write<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    place: Place,
    bits: u8,
    frame: u64,
) -> Result<(), Abort> {
    let entry = dictionary.attributes_at(place)?;
    let mask = lowest(bits);
    let is_negative = matches!(entry.data_type, 0x02..=0x04 | 0x10 | 0x12..=0x15) && frame & mask > mask >> 1;
    let value = if is_negative { frame | !mask } else { frame & mask };
    // texts, bytes and DOMAIN have the length that is mapped
    let length = if entry.has_length() { usize::from(bits.div_ceil(8)) } else { entry.size };
    let bytes = value.to_le_bytes();
    dictionary.write_at(place, bytes.get(..length).unwrap_or(&bytes))
}

/// A mask of this many bits, 1 to 64.
// a shift of 64 bits is longer than a call
#[inline(never)]
const fn lowest(bits: u8) -> u64 {
    u64::MAX >> (64_u8.saturating_sub(bits) & 63)
}
