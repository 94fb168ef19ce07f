//! What may be written to the parameters of PDOs at run time (CiA 301 §7.5.2.35 to §7.5.2.38).

use super::mapping::Mapped;
use super::{NOT_VALID, is_event_driven};
use crate::frame::can_id;
use crate::{Abort, Dictionary};

const BOOLEAN: u8 = 0x01;

/// The length in bits of the data types 1 to 7, which are dummies in an RPDO.
const DUMMIES: [u32; 7] = [1, 8, 16, 32, 8, 16, 32];

/// Checks the new value of an entry against the rules for PDOs; entries of other objects have none.
pub(super) fn check<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Abort> {
    match index {
        0x1400..=0x15FF | 0x1800..=0x19FF => check_communication(dictionary, index, sub, value),
        0x1600..=0x17FF | 0x1A00..=0x1BFF => check_mapping(dictionary, index, sub, value),
        _ => Ok(()),
    }
}

fn is_valid<D: Dictionary + ?Sized>(dictionary: &mut D, communication: u16) -> bool {
    dictionary.number(communication, 1).is_ok_and(|cob_id| cob_id as u32 & NOT_VALID == 0)
}

fn check_communication<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Abort> {
    let is_tpdo = index >= 0x1800;
    let may_change = !is_valid(dictionary, index) || dictionary.number(index, sub) == Ok(value);
    let is_accepted = match sub {
        1 => is_cob_id(dictionary, index, value as u32),
        2 => value <= 240 || (value <= 0xFF && is_event_driven(value as u8)),
        3 if is_tpdo => may_change,
        6 if is_tpdo => may_change && value <= 240,
        _ => true,
    };
    if is_accepted { Ok(()) } else { Err(Abort::InvalidValue) }
}

/// Bits 0 to 29 of a valid PDO stay as they are until the PDO is not valid; there are no CAN-IDs of 29 bits.
fn is_cob_id<D: Dictionary + ?Sized>(dictionary: &mut D, index: u16, new: u32) -> bool {
    const BEYOND_11_BITS: u32 = 0x3FFF_F800;
    const BITS_0_TO_29: u32 = 0x3FFF_FFFF;
    let stays = |old: u64| (old as u32 ^ new) & BITS_0_TO_29 == 0;
    let may_change = !is_valid(dictionary, index) || dictionary.number(index, 1).is_ok_and(stays);
    new & BEYOND_11_BITS == 0 && (new & NOT_VALID != 0 || (may_change && !is_restricted(can_id(new))))
}

/// CAN-IDs of other services (CiA 301 §7.3.5).
const fn is_restricted(id: u16) -> bool {
    matches!(id, 0..=0x07F | 0x101..=0x180 | 0x581..=0x5FF | 0x601..=0x67F | 0x6E0..=0x6FF | 0x701..=0x7FF)
}

/// A mapping changes while the PDO is not valid: first its number of entries to 0, then the entries, then their number.
fn check_mapping<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Abort> {
    let is_rpdo = index < 0x1A00;
    if is_valid(dictionary, index - 0x200) || (sub != 0 && dictionary.number(index, 0)? != 0) {
        return Err(Abort::UnsupportedAccess);
    }
    match (sub, value) {
        (0, 0..=64) => {
            let mut bits = 0;
            for sub in 1..=value as u8 {
                let mapped = dictionary.number(index, sub).map_err(|_| Abort::PdoTooLong)?;
                bits += bits_of(dictionary, Mapped::of(mapped), is_rpdo)?;
            }
            if bits <= 64 { Ok(()) } else { Err(Abort::PdoTooLong) }
        }
        (0, _) => Err(Abort::PdoTooLong),
        // an empty entry; counted ones are checked with the number
        (_, 0) => Ok(()),
        _ => bits_of(dictionary, Mapped::of(value), is_rpdo).map(drop),
    }
}

/// The length of a mapped entry, which must exist, be mappable, and be as long as its value.
fn bits_of<D: Dictionary + ?Sized>(dictionary: &mut D, mapped: Mapped, is_rpdo: bool) -> Result<u32, Abort> {
    let is_accepted = if is_rpdo && mapped.is_dummy() {
        DUMMIES.get(usize::from(mapped.index) - 1) == Some(&mapped.bits)
    } else {
        let entry = dictionary.attributes(mapped.index, mapped.sub).map_err(|_| Abort::NotMappable)?;
        let bits = mapped.bits as usize;
        let fits_length = match entry.data_type {
            BOOLEAN => bits == 1 || bits == 8,
            // texts, bytes and DOMAIN may be shorter than their room
            0x09..=0x0B | 0x0F => bits > 0 && bits.is_multiple_of(8) && bits <= 8 * entry.size,
            _ => bits == 8 * entry.size,
        };
        fits_length && if is_rpdo { entry.fits_rpdo } else { entry.fits_tpdo }
    };
    if !is_accepted {
        return Err(Abort::NotMappable);
    }
    if mapped.bits <= 64 { Ok(mapped.bits) } else { Err(Abort::PdoTooLong) }
}
