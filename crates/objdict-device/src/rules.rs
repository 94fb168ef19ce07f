//! What may be written to communication objects at run time (CiA 301 §7.5.2), so that a node accepts only what it then does.

use crate::errors;
use crate::frame::can_id;
use crate::guard::Services;
use crate::heartbeat::{CONSUMER_TIME, monitored};
use crate::pdo::mapping::Mapped;
use crate::pdo::{NOT_VALID, is_event_driven};
use crate::sync;
use crate::{Abort, Dictionary};

const BOOLEAN: u8 = 0x01;

/// The length in bits of the data types 1 to 7, which are dummies in an RPDO.
const DUMMIES: [u8; 7] = [1, 8, 16, 32, 8, 16, 32];

/// The COB-ID of TIME; its bits 30 and 31 say that the node sends and receives it.
const TIME: u16 = 0x1012;
const SENDS_TIME: u32 = 1 << 30;

/// The bits of a COB-ID for CAN-IDs of 29 bits, which nothing here sends.
const BEYOND_11_BITS: u32 = 0x3FFF_F800;

/// The CAN-ID and the bits that say how it is sent.
const BITS_0_TO_29: u32 = 0x3FFF_FFFF;

/// Checks the new value of an entry against the rules of its service; entries of other objects have none.
pub(crate) fn check<D: Dictionary + ?Sized, S: Services>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Abort> {
    match (index, sub) {
        (errors::HISTORY, 0) => valid(value == 0),
        (sync::COB_ID, 0) => check_sync::<D, S>(dictionary, value as u32),
        (sync::OVERFLOW, 0) => check_overflow(dictionary, value),
        (TIME, 0) => {
            let is_free = |old: u32| old & (SENDS_TIME | NOT_VALID) == 0;
            valid(value as u32 & SENDS_TIME == 0 && is_cob_id(dictionary, index, sub, value as u32, is_free))
        }
        (errors::COB_ID, 0) => valid(is_cob_id(dictionary, index, sub, value as u32, is_not_valid)),
        (CONSUMER_TIME, 1..) => check_consumer::<D, S>(dictionary, sub, value),
        (0x1200..=0x127F, 1 | 2) => check_server::<D, S>(dictionary, index, sub, value as u32),
        (0x1400..=0x15FF | 0x1800..=0x19FF, _) => check_communication(dictionary, index, sub, value),
        (0x1600..=0x17FF | 0x1A00..=0x1BFF, _) => check_mapping(dictionary, index, sub, value),
        _ => Ok(()),
    }
}

const fn valid(is_valid: bool) -> Result<(), Abort> {
    if is_valid { Ok(()) } else { Err(Abort::InvalidValue) }
}

const fn is_not_valid(cob_id: u32) -> bool {
    cob_id & NOT_VALID != 0
}

/// Whether a COB-ID may have this value: bits 0 to 29 stay as they are until the service does not use them any more, and the CAN-ID
/// of a service that is in use is not that of another one.
fn is_cob_id<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    new: u32,
    is_free: impl Fn(u32) -> bool,
) -> bool {
    let old = dictionary.number(index, sub).map_or(NOT_VALID, |old| old as u32);
    if new & BEYOND_11_BITS != 0 {
        return false;
    }
    is_free(new) || ((is_free(old) || (old ^ new) & BITS_0_TO_29 == 0) && !is_restricted(can_id(new)))
}

/// CAN-IDs of other services (CiA 301 §7.3.5).
const fn is_restricted(id: u16) -> bool {
    matches!(id, 0..=0x07F | 0x101..=0x180 | 0x581..=0x5FF | 0x601..=0x67F | 0x6E0..=0x6FF | 0x701..=0x7FF)
}

/// 1005h. The node also receives SYNC, so its CAN-ID always counts, and is that of no PDO.
fn check_sync<D: Dictionary + ?Sized, S: Services>(dictionary: &mut D, new: u32) -> Result<(), Abort> {
    let can_send = S::PRODUCES_SYNC && dictionary.attributes(sync::PERIOD, 0).is_ok();
    let is_free = |old: u32| old & sync::PRODUCES == 0;
    let is_accepted = (is_free(new) || can_send)
        && is_cob_id(dictionary, sync::COB_ID, 0, new, is_free)
        && !is_restricted(can_id(new))
        && (is_sync(dictionary, new) || !has_pdo(dictionary, new));
    valid(is_accepted)
}

/// 1019h: its value changes while there is no period.
fn check_overflow<D: Dictionary + ?Sized>(dictionary: &mut D, value: u64) -> Result<(), Abort> {
    valid(matches!(value, 0 | 2..=240))?;
    let stays = dictionary.number(sync::OVERFLOW, 0) == Ok(value);
    let runs = dictionary.number(sync::PERIOD, 0).is_ok_and(|period| period != 0);
    if runs && !stays { Err(Abort::DeviceState) } else { Ok(()) }
}

/// 1016h: each node is monitored once.
fn check_consumer<D: Dictionary + ?Sized, S: Services>(
    dictionary: &mut D,
    sub: u8,
    value: u64,
) -> Result<(), Abort> {
    let Some((node_id, _)) = monitored(value) else { return Ok(()) };
    let is_twice = |other: u8| {
        let other = if other == sub { None } else { dictionary.number(CONSUMER_TIME, other).ok() };
        other.and_then(monitored).is_some_and(|(other, _)| other == node_id)
    };
    if (1..=0x7F).any(is_twice) {
        return Err(Abort::Incompatible);
    }
    if S::CONSUMERS.is_some_and(|most| usize::from(sub) > most) {
        Err(Abort::InternalIncompatible)
    } else {
        Ok(())
    }
}

/// 1200h and the channels after it. That of 1200h has COB-IDs that no device can change.
fn check_server<D: Dictionary + ?Sized, S: Services>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    new: u32,
) -> Result<(), Abort> {
    let stays = dictionary.number(index, sub) == Ok(u64::from(new));
    let is_accepted = match index {
        0x1200 => stays,
        _ => is_cob_id(dictionary, index, sub, new, is_not_valid),
    };
    valid(is_accepted)?;
    let number = usize::from(index & 0x7F);
    let is_served = is_not_valid(new) || S::CHANNELS.is_none_or(|channels| number < channels);
    if is_served { Ok(()) } else { Err(Abort::InternalIncompatible) }
}

fn is_valid<D: Dictionary + ?Sized>(dictionary: &mut D, communication: u16) -> bool {
    dictionary.number(communication, 1).is_ok_and(|cob_id| !is_not_valid(cob_id as u32))
}

fn check_communication<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Abort> {
    let is_tpdo = index >= 0x1800;
    let may_change = !is_valid(dictionary, index) || dictionary.number(index, sub) == Ok(value);
    valid(match sub {
        1 => {
            let new = value as u32;
            is_cob_id(dictionary, index, 1, new, is_not_valid)
                && (is_not_valid(new) || !is_sync(dictionary, new))
        }
        2 => value <= 240 || (value <= 0xFF && is_event_driven(value as u8)),
        3 if is_tpdo => may_change,
        6 if is_tpdo => may_change && value <= 240,
        _ => true,
    })
}

/// Whether a PDO has a CAN-ID.
fn has_pdo<D: Dictionary + ?Sized>(dictionary: &mut D, cob_id: u32) -> bool {
    let has_it = |old: u32| !is_not_valid(old) && can_id(old) == can_id(cob_id);
    let mut pdos = (0x1400..=0x15FF).chain(0x1800..=0x19FF);
    pdos.any(|index| dictionary.number(index, 1).is_ok_and(|old| has_it(old as u32)))
}

/// Whether a CAN-ID is that of SYNC: each SYNC would be the data of a PDO with it.
fn is_sync<D: Dictionary + ?Sized>(dictionary: &mut D, cob_id: u32) -> bool {
    can_id(sync::cob_id(dictionary)) == can_id(cob_id)
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
        // before the entries that there are, which may be empty
        (0, 1..=64) if dictionary.attributes(index, value as u8).is_err() => Err(Abort::PdoTooLong),
        (0, 0..=64) => {
            let mut bits = 0;
            for sub in 1..=value as u8 {
                let mapped = dictionary.number(index, sub).map_err(|_| Abort::PdoTooLong)?;
                bits += u32::from(bits_of(dictionary, Mapped::of(mapped), is_rpdo)?);
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
fn bits_of<D: Dictionary + ?Sized>(dictionary: &mut D, mapped: Mapped, is_rpdo: bool) -> Result<u8, Abort> {
    let is_accepted = if is_rpdo && mapped.is_dummy() {
        DUMMIES.get(usize::from(mapped.index) - 1) == Some(&mapped.bits)
    } else {
        let entry = dictionary.attributes(mapped.index, mapped.sub).map_err(|_| Abort::NotMappable)?;
        let bits = usize::from(mapped.bits);
        let fits_length = match entry.data_type {
            BOOLEAN => bits == 1 || bits == 8,
            // texts, bytes and DOMAIN may be shorter than their room
            _ if entry.has_length() => bits > 0 && bits.is_multiple_of(8) && bits <= 8 * entry.size,
            _ => bits == 8 * entry.size,
        };
        fits_length && if is_rpdo { entry.fits_rpdo } else { entry.fits_tpdo }
    };
    if !is_accepted {
        return Err(Abort::NotMappable);
    }
    if mapped.bits <= 64 { Ok(mapped.bits) } else { Err(Abort::PdoTooLong) }
}
