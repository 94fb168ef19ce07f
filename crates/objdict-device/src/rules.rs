//! Validity of writes to communication objects (CiA 301 §7.5.2). Nodes apply these rules at run time and tools apply
//! them to downloads, so nodes and tools accept the same configurations.

use crate::dictionary::word;
use crate::frame::{EXTENDED, NOT_VALID, can_id};
use crate::heartbeat::{CONSUMER_TIME, monitored};
use crate::pdo::mapping::Mapped;
use crate::pdo::transmission_type::is_event_driven;
use crate::services::{ERROR_BEHAVIOUR, RESTORE, STARTUP, STORE, Services};
use crate::{Abort, Dictionary, ObjectSet, errors, sync};

const BOOLEAN: u8 = 0x01;

/// The length in bits of the data types 1 to 7, which are dummies in an RPDO.
const DUMMIES: [u8; 7] = [1, 8, 16, 32, 8, 16, 32];

/// The COB-ID of TIME; bits 30 and 31 select whether the node sends and receives it.
const TIME: u16 = 0x1012;
const SENDS_TIME: u32 = 1 << 30;
const RECEIVES_TIME: u32 = 1 << 31;

/// The SYNC window, and node guarding.
const SYNC_WINDOW: u16 = 0x1007;
const GUARD_TIME: u16 = 0x100C;
const LIFE_TIME_FACTOR: u16 = 0x100D;
/// The bits of 1F80h that make the node a master, or that affect only a master. Bit 3 enables nothing.
const MASTER_BITS: u64 = 0b0111_0011;

/// Disables remote frames in the COB-ID of a TPDO.
const NO_REMOTE_FRAMES: u32 = 1 << 30;

/// The COB-IDs of the emergency messages of other nodes.
const EMCY_CONSUMER: u16 = 0x1028;

/// The bits of a COB-ID between a CAN-ID of 11 bits and bit 29.
const STRAY_BITS: u32 = 0x1FFF_F800;

/// The CAN-ID and the bits that define its transmission.
const BITS_0_TO_29: u32 = 0x3FFF_FFFF;

/// The reason why a node rejects a value of a communication object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Refusal {
    /// The value is not defined for the entry, or no service supports it.
    Undefined,
    /// The CAN-ID belongs to a service that cannot be configured.
    RestrictedCanId,
    /// SYNC already uses the CAN-ID; for SYNC itself, a valid PDO does.
    SharedWithSync,
    /// Bits 0 to 29 of a COB-ID change while the service is valid.
    InUse,
    /// 1010h, 1011h: not the signature.
    Signature,
    /// 1016h: this sub-index monitors the node already.
    MonitoredTwice(u8),
    /// 1019h: the period (1006h) is not 0.
    PeriodRuns,
    /// The node has no capacity for another service of this kind.
    NoRoom,
    /// The inhibit time or the SYNC start value changes while the PDO is valid.
    PdoIsValid,
    /// The mapping changes while the PDO is valid.
    MappingIsValid,
    /// The mapping changes while its sub-index 0 is not 0.
    MappingInUse,
    /// The entry mapped by this sub-index does not exist, or no PDO of this direction can carry it.
    NotMappable(u8),
    /// The length of the entry mapped by this sub-index differs.
    MappedLength(u8),
    /// This sub-index is included in the number of entries but maps nothing.
    NothingMapped(u8),
    /// The mapping does not have this sub-index.
    NoMappingEntry(u8),
    /// This many bits are mapped, more than 64.
    PdoTooLong(u16),
}

impl From<Refusal> for Abort {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Undefined
            | Refusal::RestrictedCanId
            | Refusal::SharedWithSync
            | Refusal::InUse
            | Refusal::PdoIsValid => Self::InvalidValue,
            Refusal::Signature => Self::CannotStore,
            Refusal::MonitoredTwice(_) => Self::Incompatible,
            Refusal::PeriodRuns => Self::DeviceState,
            Refusal::NoRoom => Self::InternalIncompatible,
            Refusal::MappingIsValid | Refusal::MappingInUse => Self::UnsupportedAccess,
            Refusal::NotMappable(_) | Refusal::MappedLength(_) | Refusal::NothingMapped(_) => {
                Self::NotMappable
            }
            Refusal::NoMappingEntry(_) | Refusal::PdoTooLong(_) => Self::PdoTooLong,
        }
    }
}

/// Services without limits of their own.
struct AnyServices;

impl Services for AnyServices {
    const PRODUCES_SYNC: bool = true;

    fn follow<D: Dictionary + ?Sized>(&mut self, _: &mut D, _: u16, _: u8) {}
}

/// Checks the new value of an entry like [`Node::guard`](crate::Node::guard), for a node with capacity for all
/// services. The entry must be writable and have the length of the value. Entries of other objects have no rules.
///
/// # Errors
/// The reason why a node rejects the value.
pub fn check_write<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Refusal> {
    check::<D, AnyServices>(dictionary, index, sub, value)
}

/// Checks the new value of an entry against the rules of its service; entries of other objects have none.
pub(crate) fn check<D: Dictionary + ?Sized, S: Services>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Refusal> {
    let word = value as u32;
    let objects = dictionary.objects();
    if switches_on(objects, index, sub, value) && !dictionary.serves_more() {
        defined(dictionary.number(index, sub) == Ok(value))?;
    }
    match (index, sub) {
        (errors::HISTORY, 0) if objects.writes(errors::HISTORY) => defined(value == 0),
        (sync::COB_ID, 0) if objects.writes(sync::COB_ID) => check_sync::<D, S>(dictionary, word),
        (STORE, 1..) => ensure(value == u32::from_le_bytes(*b"save").into(), Refusal::Signature),
        (RESTORE, 1..) => ensure(value == u32::from_le_bytes(*b"load").into(), Refusal::Signature),
        (sync::OVERFLOW, 0) if objects.writes(sync::OVERFLOW) => check_overflow(dictionary, value),
        (TIME, 0) if objects.writes(TIME) => {
            check_cob_id(dictionary, index, sub, word, |old| old & (SENDS_TIME | RECEIVES_TIME) == 0)
        }
        (ERROR_BEHAVIOUR, 1..) if objects.writes(ERROR_BEHAVIOUR) => {
            defined(matches!(value, 0..=2) || value >= 0x80 && dictionary.serves_more())
        }
        (errors::COB_ID, 0) | (EMCY_CONSUMER, 1..=0x7F)
            if objects.writes(errors::COB_ID) || objects.writes(EMCY_CONSUMER) =>
        {
            check_cob_id(dictionary, index, sub, word, is_not_valid)
        }
        (CONSUMER_TIME, 1..) if objects.writes(CONSUMER_TIME) => {
            check_consumer::<D, S>(dictionary, sub, value)
        }
        (0x1200..=0x12FF, 1 | 2)
            if objects.writes(0x1200) || objects.writes(0x1201) || objects.writes(0x1280) =>
        {
            check_sdo::<D, S>(dictionary, index, sub, word)
        }
        (0x1400..=0x15FF | 0x1800..=0x19FF, _) if objects.writes(0x1400) => {
            check_communication(dictionary, index, sub, value)
        }
        (0x1600..=0x17FF | 0x1A00..=0x1BFF, _) if objects.writes(0x1600) => {
            check_mapping(dictionary, index, sub, value)
        }
        _ => Ok(()),
    }
}

/// Whether a value enables a service that only an application provides.
const fn switches_on(objects: ObjectSet, index: u16, sub: u8, value: u64) -> bool {
    let word = value as u32;
    match (index, sub) {
        (SYNC_WINDOW, 0) if objects.writes(SYNC_WINDOW) => value != 0,
        (GUARD_TIME | LIFE_TIME_FACTOR, 0)
            if objects.writes(GUARD_TIME) || objects.writes(LIFE_TIME_FACTOR) =>
        {
            value != 0
        }
        (TIME, 0) if objects.writes(TIME) => word & (SENDS_TIME | RECEIVES_TIME) != 0,
        (EMCY_CONSUMER, 1..=0x7F) | (0x1280..=0x12FF, 1 | 2)
            if objects.writes(EMCY_CONSUMER) || objects.writes(0x1280) =>
        {
            value != 0 && !is_not_valid(word)
        }
        (STARTUP, 0) if objects.writes(STARTUP) => value & MASTER_BITS != 0,
        _ => false,
    }
}

const fn ensure(is_accepted: bool, refusal: Refusal) -> Result<(), Refusal> {
    if is_accepted { Ok(()) } else { Err(refusal) }
}

const fn defined(is_defined: bool) -> Result<(), Refusal> {
    ensure(is_defined, Refusal::Undefined)
}

const fn is_not_valid(cob_id: u32) -> bool {
    cob_id & NOT_VALID != 0
}

/// Checks a COB-ID: bits 0 to 29 may change only while the service is not valid, and a valid service must not use the
/// CAN-ID of a different one.
fn check_cob_id<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    new: u32,
    is_free: impl Fn(u32) -> bool,
) -> Result<(), Refusal> {
    let is_extended = new & EXTENDED != 0;
    defined(if is_extended { dictionary.serves_more() } else { new & STRAY_BITS == 0 })?;
    if is_free(new) {
        return Ok(());
    }
    ensure(is_extended || !is_restricted(can_id(new)), Refusal::RestrictedCanId)?;
    let old = word(dictionary, index, sub, NOT_VALID);
    ensure(is_free(old) || is_same_id(old, new), Refusal::InUse)
}

/// CAN-IDs of other services (CiA 301 §7.3.5).
const fn is_restricted(id: u16) -> bool {
    matches!(id, 0..=0x07F | 0x101..=0x180 | 0x581..=0x5FF | 0x601..=0x67F | 0x6E0..=0x6FF | 0x701..=0x7FF)
}

const fn is_same_id(one: u32, other: u32) -> bool {
    (one ^ other) & BITS_0_TO_29 == 0
}

/// 1005h. The node also receives SYNC, so its CAN-ID is always in use and must differ from every PDO's.
fn check_sync<D: Dictionary + ?Sized, S: Services>(dictionary: &mut D, new: u32) -> Result<(), Refusal> {
    let can_send = S::PRODUCES_SYNC && dictionary.attributes(sync::PERIOD, 0).is_ok();
    let is_free = |old: u32| old & sync::PRODUCES == 0;
    defined(is_free(new) || can_send)?;
    check_cob_id(dictionary, sync::COB_ID, 0, new, is_free)?;
    ensure(new & EXTENDED != 0 || !is_restricted(can_id(new)), Refusal::RestrictedCanId)?;
    ensure(is_sync(dictionary, new) || !has_pdo(dictionary, new), Refusal::SharedWithSync)
}

/// 1019h: its value may change only while there is no period.
fn check_overflow<D: Dictionary + ?Sized>(dictionary: &mut D, value: u64) -> Result<(), Refusal> {
    defined(matches!(value, 0 | 2..=240))?;
    let stays = dictionary.number(sync::OVERFLOW, 0) == Ok(value);
    ensure(stays || word(dictionary, sync::PERIOD, 0, 0) == 0, Refusal::PeriodRuns)
}

/// 1016h: each node is monitored once.
fn check_consumer<D: Dictionary + ?Sized, S: Services>(
    dictionary: &mut D,
    sub: u8,
    value: u64,
) -> Result<(), Refusal> {
    let Some((node_id, _)) = monitored(value) else { return Ok(()) };
    defined(dictionary.own_node_id() != Some(node_id))?;
    let mut is_it = |other: u8| {
        let other = if other == sub { None } else { dictionary.number(CONSUMER_TIME, other).ok() };
        other.and_then(monitored).is_some_and(|(other, _)| other == node_id)
    };
    if let Some(other) = (1..=0x7F).find(|other| is_it(*other)) {
        return Err(Refusal::MonitoredTwice(other));
    }
    let has_room = S::CONSUMERS.is_none_or(|most| usize::from(sub) <= most);
    ensure(has_room || dictionary.serves_more(), Refusal::NoRoom)
}

/// 1200h and the channels after it, and clients from 1280h on. No device can change the COB-IDs of 1200h. A channel is
/// valid while bit 31 of both COB-IDs is clear; a client may use the default channel of a different node.
fn check_sdo<D: Dictionary + ?Sized, S: Services>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    new: u32,
) -> Result<(), Refusal> {
    let old = dictionary.number(index, sub);
    if index == 0x1200 {
        return defined(old == Ok(new.into()));
    }
    let other_is_free = is_not_valid(word(dictionary, index, 3 - sub, 0));
    let is_client_of_default = index >= 0x1280 && matches!(new, 0x581..=0x5FF | 0x601..=0x67F);
    match check_cob_id(dictionary, index, sub, new, is_not_valid) {
        Err(Refusal::RestrictedCanId) if is_client_of_default => {
            let stays = old.is_ok_and(|old| is_not_valid(old as u32) || is_same_id(old as u32, new));
            ensure(stays || other_is_free, Refusal::InUse)?;
        }
        Err(Refusal::InUse) if other_is_free => {}
        checked => checked?,
    }
    let number = usize::from(index - 0x1200);
    let is_served = index >= 0x1280 || S::CHANNELS.is_none_or(|channels| number < channels);
    ensure(is_not_valid(new) || is_served || dictionary.serves_more(), Refusal::NoRoom)
}

fn is_valid<D: Dictionary + ?Sized>(dictionary: &mut D, communication: u16) -> bool {
    !is_not_valid(word(dictionary, communication, 1, NOT_VALID))
}

fn check_communication<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Refusal> {
    let is_tpdo = index >= 0x1800;
    match sub {
        1 => {
            let new = value as u32;
            // a master that never sets bit 30 disables the PDO first, and is supported
            let answers_remote = is_tpdo && new & (NOT_VALID | NO_REMOTE_FRAMES) == 0;
            if answers_remote && !dictionary.serves_more() {
                let had = word(dictionary, index, 1, NO_REMOTE_FRAMES) & NO_REMOTE_FRAMES == 0;
                defined(had)?;
            }
            check_cob_id(dictionary, index, 1, new, is_not_valid)?;
            ensure(is_not_valid(new) || !is_sync(dictionary, new), Refusal::SharedWithSync)
        }
        2 => defined(match u8::try_from(value) {
            Ok(0..=240) => true,
            // on request
            Ok(252 | 253) => is_tpdo && dictionary.serves_more(),
            other => other.is_ok_and(is_event_driven),
        }),
        3 | 6 if is_tpdo => {
            defined(sub == 3 || value <= 240)?;
            let may_change = !is_valid(dictionary, index) || dictionary.number(index, sub) == Ok(value);
            ensure(may_change, Refusal::PdoIsValid)
        }
        _ => Ok(()),
    }
}

/// Whether a PDO has a CAN-ID.
fn has_pdo<D: Dictionary + ?Sized>(dictionary: &mut D, cob_id: u32) -> bool {
    let has_it = |old: u32| !is_not_valid(old) && is_same_id(old, cob_id);
    let mut pdos = (0x1400..=0x15FF).chain(0x1800..=0x19FF);
    pdos.any(|index| has_it(word(dictionary, index, 1, NOT_VALID)))
}

/// Whether a CAN-ID belongs to SYNC: each SYNC would be the data of a PDO with it.
fn is_sync<D: Dictionary + ?Sized>(dictionary: &mut D, cob_id: u32) -> bool {
    is_same_id(sync::cob_id(dictionary), cob_id)
}

/// A mapping may change only while the PDO is not valid: first its number of entries is set to 0, then the
/// entries are written, then their number.
fn check_mapping<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    index: u16,
    sub: u8,
    value: u64,
) -> Result<(), Refusal> {
    let is_rpdo = index < 0x1A00;
    ensure(!is_valid(dictionary, index - 0x200), Refusal::MappingIsValid)?;
    if sub != 0 {
        ensure(word(dictionary, index, 0, 0) == 0, Refusal::MappingInUse)?;
        // an empty entry; counted ones are checked with the number
        return if value == 0 { Ok(()) } else { bits_of(dictionary, sub, value, is_rpdo).map(drop) };
    }
    let count = match u8::try_from(value) {
        Ok(count @ 0..=64) => count,
        // multiplexed: each frame names its entry
        Ok(254 | 255) if dictionary.serves_more() => return Ok(()),
        _ => return Err(Refusal::NoMappingEntry(65)),
    };
    // before the existing entries, which may be empty
    let has_all = count == 0 || dictionary.attributes(index, count).is_ok();
    ensure(has_all, Refusal::NoMappingEntry(count))?;
    let mut bits = 0;
    for before in 0..count {
        let sub = before + 1;
        let mapped = dictionary.number(index, sub).map_err(|_| Refusal::NoMappingEntry(sub))?;
        ensure(mapped != 0, Refusal::NothingMapped(sub))?;
        bits += u16::from(bits_of(dictionary, sub, mapped, is_rpdo)?);
    }
    ensure(bits <= 64, Refusal::PdoTooLong(bits))
}

/// The length of the entry that a sub-index maps: it must exist, be mappable, and match the mapped length.
fn bits_of<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    sub: u8,
    mapped: u64,
    is_rpdo: bool,
) -> Result<u8, Refusal> {
    let mapped = Mapped::of(mapped);
    let is_fitting = if is_rpdo && mapped.is_dummy() {
        DUMMIES.get(usize::from(mapped.index) - 1) == Some(&mapped.bits)
    } else {
        let entry = dictionary.attributes(mapped.index, mapped.sub);
        let entry = entry.ok().filter(|entry| if is_rpdo { entry.fits_rpdo } else { entry.fits_tpdo });
        let entry = entry.ok_or(Refusal::NotMappable(sub))?;
        let bits = usize::from(mapped.bits);
        match entry.data_type {
            BOOLEAN => bits == 1 || bits == 8,
            // texts, bytes and DOMAIN may be shorter than their room
            _ if entry.has_length() => bits > 0 && bits.is_multiple_of(8) && bits <= 8 * entry.size,
            _ => bits == 8 * entry.size,
        }
    };
    ensure(is_fitting, Refusal::MappedLength(sub))?;
    ensure(mapped.bits <= 64, Refusal::PdoTooLong(mapped.bits.into()))?;
    Ok(mapped.bits)
}
