//! What a PDO carries: the values of its mapped entries, bit after bit.

use crate::{Abort, Dictionary};

/// One mapped entry: a value of 1600h to 17FFh and 1A00h to 1BFFh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Mapped {
    pub(super) index: u16,
    pub(super) sub: u8,
    /// Length in bits.
    pub(super) bits: u32,
}

impl Mapped {
    pub(super) const fn of(value: u64) -> Self {
        Self { index: (value >> 16) as u16, sub: (value >> 8) as u8, bits: (value & 0xFF) as u32 }
    }

    /// Whether an RPDO leaves out these bits: the index is that of a data type.
    pub(super) const fn is_dummy(self) -> bool {
        matches!(self.index, 1..=7) && self.sub == 0
    }
}

/// Calls a function for each mapped entry with the position of its first bit, and returns the length of the PDO in bits.
fn walk<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    mapping: u16,
    mut each: impl FnMut(&mut D, Mapped, u32) -> Result<(), Abort>,
) -> Result<u32, Abort> {
    let count = dictionary.number(mapping, 0)?.min(64) as u8;
    let mut first = 0;
    for sub in 1..=count {
        let mapped = Mapped::of(dictionary.number(mapping, sub)?);
        if mapped.bits == 0 {
            return Err(Abort::NotMappable);
        }
        if first + mapped.bits > 64 {
            return Err(Abort::PdoTooLong);
        }
        each(dictionary, mapped, first)?;
        first += mapped.bits;
    }
    Ok(first)
}

/// The number of bytes of the PDO.
pub(super) fn length<D: Dictionary + ?Sized>(dictionary: &mut D, mapping: u16) -> Result<u8, Abort> {
    walk(dictionary, mapping, |_, _, _| Ok(())).map(|bits| bits.div_ceil(8) as u8)
}

/// The frame with the present values, and its length in bytes.
pub(super) fn pack<D: Dictionary + ?Sized>(dictionary: &mut D, mapping: u16) -> Result<(u64, u8), Abort> {
    let mut frame = 0;
    let bits = walk(dictionary, mapping, |dictionary, mapped, first| {
        let value = dictionary.number(mapped.index, mapped.sub)?;
        frame |= (value & lowest(mapped.bits)) << first;
        Ok(())
    })?;
    Ok((frame, bits.div_ceil(8) as u8))
}

/// Writes the values of a frame. One that is refused stays as it is, and does not keep the others from being written.
pub(super) fn unpack<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    mapping: u16,
    frame: u64,
) -> Result<(), Abort> {
    let mut answer = Ok(());
    walk(dictionary, mapping, |dictionary, mapped, first| {
        if !mapped.is_dummy() {
            answer = answer.and(write(dictionary, mapped, frame >> first));
        }
        Ok(())
    })?;
    answer
}

/// Writes the lowest bits to a mapped entry. A description may map a part of a number, whose other bits follow its sign.
fn write<D: Dictionary + ?Sized>(dictionary: &mut D, mapped: Mapped, bits: u64) -> Result<(), Abort> {
    let entry = dictionary.attributes(mapped.index, mapped.sub)?;
    let mask = lowest(mapped.bits);
    let is_negative = matches!(entry.data_type, 0x02..=0x04 | 0x10 | 0x12..=0x15) && bits & mask > mask >> 1;
    let value = if is_negative { bits | !mask } else { bits & mask };
    // texts, bytes and DOMAIN have the length that is mapped
    let length = match entry.data_type {
        0x09..=0x0B | 0x0F => mapped.bits.div_ceil(8) as usize,
        _ => entry.size,
    };
    let bytes = value.to_le_bytes();
    dictionary.write(mapped.index, mapped.sub, bytes.get(..length).unwrap_or(&bytes))
}

/// A mask of so many bits, 1 to 64.
const fn lowest(bits: u32) -> u64 {
    u64::MAX >> (64 - bits)
}
