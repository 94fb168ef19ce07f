//! Writes to communication objects (CiA 301 §7.5.2): explains the rules of `objdict-device`, and adds probable mistakes
//! that a node accepts.

use objdict_device::{Dictionary, Refusal};

use super::super::settings::EntryKey;
use super::ObjectionKind;
use super::node::AcceptingNode;
use crate::model::{CobId, DataType, MappedObject, PdoKind, restricted};

/// The identifier and frame format bits of a COB-ID.
const IDENTIFIER: u32 = 0x3FFF_FFFF;

/// Bits 30 and 31 of 1012h: the device consumes and produces TIME.
const USES_TIME: u32 = CobId::BIT_30 | CobId::BIT_31;

/// Whether a value of a COB-ID marks the service as not in use.
type IsOff = fn(u32) -> bool;

/// Whether the service of a COB-ID is not in use, and how to achieve that; `None` for other entries.
fn service((index, sub): EntryKey) -> Option<(IsOff, &'static str)> {
    let is_invalid: IsOff = |cob_id| !CobId::new(cob_id).is_valid();
    Some(match (index, sub) {
        (0x1005, 0) => (|cob_id| cob_id & CobId::BIT_30 == 0, "clear bit 30 of 1005h"),
        (0x1012, 0) => (|cob_id| cob_id & USES_TIME == 0, "clear bits 30 and 31 of 1012h"),
        (0x1014, 0) | (0x1028, 1..=0x7F) => (is_invalid, "set bit 31"),
        (0x1201..=0x12FF, 1 | 2) => (is_invalid, "set bit 31 of one of its COB-IDs"),
        (0x1400..=0x15FF | 0x1800..=0x19FF, 1) => (is_invalid, "set bit 31 of the COB-ID"),
        _ => return None,
    })
}

/// Why the entry does not have a value.
const fn undefined((index, sub): EntryKey, cob_id: u32) -> &'static str {
    match (index, sub) {
        (0x1003, _) => "only 0 is valid, which clears the history",
        (0x1016, _) => "a node does not monitor itself",
        (0x1029, _) => "3 to 127 are reserved",
        (0x1019, _) => "the counter overflow is 0, or 2 to 240",
        (0x1005, _) if CobId::new(cob_id).stray_bits() == 0 => "without 1006h the device does not send SYNC",
        (0x1200, _) => "the COB-IDs of the default SDO server do not change",
        (0x1400..=0x19FF, 2) => "the transmission type is reserved",
        (0x1400..=0x19FF, 6) => "the SYNC start value is 0 to 240",
        _ => "bits 11 to 28 are not 0 in a COB-ID with an 11-bit CAN-ID",
    }
}

impl AcceptingNode<'_> {
    /// A refusal of the rules, with the values that explain it.
    pub(super) fn explain(&mut self, refusal: Refusal, key: EntryKey, new: u64) -> ObjectionKind {
        let ((index, sub), new) = (key, u32::try_from(new).unwrap_or(u32::MAX));
        let pdo = PdoKind::of_communication(index).or_else(|| PdoKind::of_mapping(index));
        let (kind, number) = pdo.unwrap_or((PdoKind::Rpdo, 0));
        let can_id = CobId::new(new).can_id(0);
        // the mapping entry being written, or a counted one
        let mut mapped = |at| {
            let number = if at == sub { Some(new) } else { self.word((index, at)) };
            MappedObject::from_number(number.unwrap_or_default())
        };
        match refusal {
            Refusal::RestrictedCanId => {
                ObjectionKind::RestrictedCanId { can_id, owner: restricted(can_id).unwrap_or("reserved") }
            }
            Refusal::SharedWithSync => ObjectionKind::SharedWithSync { can_id },
            Refusal::InUse => {
                let how = service(key).map_or("", |(_, how)| how);
                ObjectionKind::InUse { present: self.word(key).unwrap_or_default(), how }
            }
            Refusal::Signature => {
                ObjectionKind::Signature { expected: if index == 0x1010 { "save" } else { "load" } }
            }
            Refusal::MonitoredTwice(sub) => {
                ObjectionKind::WatchedTwice { node_id: new.to_le_bytes()[2], sub }
            }
            Refusal::PeriodRuns => ObjectionKind::PeriodRuns,
            Refusal::PdoIsValid => ObjectionKind::PdoIsValid(kind, number),
            Refusal::MappingIsValid => ObjectionKind::MappingIsValid(kind, number),
            Refusal::MappingInUse => ObjectionKind::MappingInUse,
            Refusal::NotMappable(at) => ObjectionKind::NotMappable(mapped(at), kind),
            Refusal::MappedLength(at) => {
                let mapped = mapped(at);
                match self.bits_of(mapped) {
                    Some(bits) => ObjectionKind::MappedLength { mapped, bits },
                    None => ObjectionKind::NotMappable(mapped, kind),
                }
            }
            Refusal::NothingMapped(sub) => ObjectionKind::NothingMapped { sub },
            Refusal::NoMappingEntry(sub) => ObjectionKind::NoMappingEntry { sub },
            Refusal::PdoTooLong(bits) => ObjectionKind::PdoTooLong { bits: bits.into() },
            Refusal::NoRoom | Refusal::Undefined => ObjectionKind::Undefined(undefined(key, new)),
        }
    }

    /// The length of a mapped entry in bits; `None` without a fixed length.
    fn bits_of(&self, mapped: MappedObject) -> Option<u32> {
        if mapped.is_dummy() {
            return DataType(mapped.index).bit_length().map(u32::from);
        }
        let entry = self.attributes(mapped.index, mapped.sub).ok().filter(|entry| !entry.has_length())?;
        let bits = if entry.data_type == 1 { 1 } else { 8 * entry.size };
        u32::try_from(bits).ok()
    }

    /// A write to a communication object that is accepted, but is probably a mistake.
    pub(super) fn doubt(&mut self, key: EntryKey, new: u64) -> Option<ObjectionKind> {
        let word = u32::try_from(new).ok()?;
        match key {
            (0x1016, 1..=0x7F) => watches_nobody(word),
            (0x100C | 0x100D | 0x1017, 0) => self.two_error_controls(key.0, word),
            _ => {
                let (is_off, _) = service(key)?;
                let is_sdo = matches!(key.0, 0x1201..=0x12FF);
                // the other COB-ID of the channel marks it as not valid
                if is_sdo && self.word((key.0, 3 - key.1)).is_some_and(is_off) {
                    return None;
                }
                let present = self.word(key).filter(|&present| !is_off(present))?;
                let is_renamed = is_off(word) && (present ^ word) & IDENTIFIER != 0;
                is_renamed.then_some(ObjectionKind::RenamedWhileSwitchedOff { present })
            }
        }
    }

    /// 100Ch, 100Dh, 1017h: heartbeat and guarding exclude each other.
    fn two_error_controls(&mut self, index: u16, new: u32) -> Option<ObjectionKind> {
        let mut runs = |other: u16| {
            let present = if other == index { Some(new) } else { self.word((other, 0)) };
            present.is_some_and(|number| number != 0)
        };
        (new != 0 && runs(0x1017) && runs(0x100C) && runs(0x100D)).then_some(ObjectionKind::TwoErrorControls)
    }
}

/// 1016h: a time without a node-ID is accepted, but usually the node-ID is missing; a node-ID without a time disables the entry.
fn watches_nobody(consumer: u32) -> Option<ObjectionKind> {
    let [low, high, node_id, _] = consumer.to_le_bytes();
    let time = u16::from_le_bytes([low, high]);
    (time != 0 && !(1..=127).contains(&node_id)).then_some(ObjectionKind::WatchesNobody { node_id, time })
}
