//! Rules for writes to communication objects (CiA 301 §7.5.2).

use super::super::Download;
use super::super::settings::Key;
use super::node::{Judgement, Node, number};
use super::{AbortCode, ObjectionKind};
use crate::model::{CobId, Object, PdoKind, restricted};

/// The identifier and frame format bits of a COB-ID.
const IDENTIFIER: u32 = 0x3FFF_FFFF;

/// Bits 30 and 31 of 1012h: the device consumes and produces TIME.
const USES_TIME: u32 = CobId::BIT_30 | CobId::BIT_31;

/// A changed COB-ID.
#[derive(Clone, Copy)]
pub(super) struct CobIdChange {
    /// The present COB-ID; `None` if unknown.
    pub(super) present: Option<u32>,
    /// The new COB-ID.
    pub(super) new: u32,
}

impl CobIdChange {
    /// Checks a changed identifier: it may change only while the service `is_off`, and must be free when the
    /// new COB-ID makes the service valid.
    pub(super) fn judge(self, is_off: impl Fn(u32) -> bool, how: &'static str) -> Judgement {
        if !is_off(self.new) {
            free(self.new)?;
        }
        self.in_use(is_off, how)
    }

    /// Checks only that the service is not valid while its identifier changes.
    fn in_use(self, is_off: impl Fn(u32) -> bool, how: &'static str) -> Judgement {
        let Self { present, new } = self;
        match present.filter(|&present| !is_off(present) && (present ^ new) & IDENTIFIER != 0) {
            None => Ok(None),
            Some(present) if is_off(new) => Ok(Some(ObjectionKind::RenamedWhileSwitchedOff { present })),
            Some(present) => Err(ObjectionKind::InUse { present, how }),
        }
    }
}

/// Rejects a CAN-ID of a service that cannot be configured.
fn free(cob_id: u32) -> Result<(), ObjectionKind> {
    let cob_id = CobId::new(cob_id);
    let can_id = cob_id.can_id(0);
    match restricted(can_id).filter(|_| !cob_id.is_extended()) {
        Some(owner) => Err(ObjectionKind::RestrictedCanId { can_id, owner }),
        None => Ok(()),
    }
}

/// Whether bit 31 marks the service as not valid.
pub(super) fn is_invalid(cob_id: u32) -> bool {
    !CobId::new(cob_id).is_valid()
}

/// The values of a node that the rules about communication objects ask for.
pub trait Present {
    /// The value of an entry as a number; `None` if the node does not have the entry, or the value is not known.
    fn number(&mut self, index: u16, sub: u8) -> Option<u64>;

    /// The sub-indexes of an object.
    fn subs(&self, index: u16) -> Vec<u8>;
}

impl Present for Node<'_> {
    fn number(&mut self, index: u16, sub: u8) -> Option<u64> {
        Node::number(self, (index, sub))
    }

    fn subs(&self, index: u16) -> Vec<u8> {
        self.device.object(index).into_iter().flat_map(Object::entries).map(|(sub, _)| sub).collect()
    }
}

impl Node<'_> {
    /// Checks a write to a communication object.
    pub(super) fn judge_service(&mut self, download: &Download) -> Judgement {
        let (index, sub) = (download.index, download.sub);
        let Some(new) = number(&download.data) else { return Ok(None) };
        if let Some((kind, pdo)) = PdoKind::of_communication(index) {
            return self.judge_communication(kind, pdo, sub, new);
        }
        if let Some((kind, pdo)) = PdoKind::of_mapping(index) {
            return self.judge_mapping(kind, pdo, sub, new).map(|()| None);
        }
        Services(self).judge(index, sub, new)
    }
}

/// The code with which a node aborts a write to a communication object that is no PDO, by the rules of CiA 301 §7.5.2 about its values;
/// `None` if it accepts the write.
pub fn refusal(present: &mut dyn Present, index: u16, sub: u8, data: &[u8]) -> Option<AbortCode> {
    Services(present).judge(index, sub, number(data)?).err()?.abort()
}

/// A node with its services.
struct Services<'p>(&'p mut dyn Present);

impl Services<'_> {
    fn number(&mut self, (index, sub): Key) -> Option<u64> {
        self.0.number(index, sub)
    }

    fn word(&mut self, key: Key) -> Option<u32> {
        u32::try_from(self.number(key)?).ok()
    }

    fn judge(&mut self, index: u16, sub: u8, new: u64) -> Judgement {
        let word = u32::try_from(new).unwrap_or(u32::MAX);
        match (index, sub) {
            (0x1003, 0) if new != 0 => {
                Err(ObjectionKind::Undefined("only 0 is valid, which clears the history"))
            }
            (0x1005, 0) => {
                let change = CobIdChange { present: self.word((index, sub)), new: word };
                change.judge(|cob_id| cob_id & CobId::BIT_30 == 0, "clear bit 30 of 1005h")
            }
            (0x1019, 0) => self.judge_counter(new),
            (0x1012, 0) => {
                let change = CobIdChange { present: self.word((index, sub)), new: word };
                change.judge(|cob_id| cob_id & USES_TIME == 0, "clear bits 30 and 31 of 1012h")
            }
            (0x1014, 0) | (0x1028, 1..=0x7F) => {
                let change = CobIdChange { present: self.word((index, sub)), new: word };
                change.judge(is_invalid, "set bit 31")
            }
            (0x1016, 1..=0x7F) => self.judge_consumer(sub, word),
            (0x100C | 0x100D | 0x1017, 0) => Ok(self.judge_error_control(index, new)),
            (0x1200..=0x12FF, 1 | 2) => self.judge_sdo(index, sub, word),
            (0x1010, 1..=0x7F) => signature(new, "save"),
            (0x1011, 1..=0x7F) => signature(new, "load"),
            _ => Ok(None),
        }
    }

    /// 1019h: the counter overflow.
    fn judge_counter(&mut self, new: u64) -> Judgement {
        if new == 1 || new > 240 {
            return Err(ObjectionKind::Undefined("the counter overflow is 0, or 2 to 240"));
        }
        let changes = self.number((0x1019, 0)) != Some(new);
        match changes && self.number((0x1006, 0)).is_some_and(|period| period != 0) {
            true => Err(ObjectionKind::PeriodRuns),
            false => Ok(None),
        }
    }

    /// 1016h: two entries must not monitor the same node. A time without a node-ID is accepted, but usually
    /// the node-ID is missing; a node-ID without a time disables the entry.
    fn judge_consumer(&mut self, sub: u8, new: u32) -> Judgement {
        let Some(node_id) = watched(new) else {
            let [low, high, node_id, _] = new.to_le_bytes();
            let time = u16::from_le_bytes([low, high]);
            return Ok((time != 0).then_some(ObjectionKind::WatchesNobody { node_id, time }));
        };
        let others = self.0.subs(0x1016).into_iter();
        for other in others.filter(|&other| other != 0 && other != sub) {
            if self.word((0x1016, other)).and_then(watched) == Some(node_id) {
                return Err(ObjectionKind::WatchedTwice { node_id, sub: other });
            }
        }
        Ok(None)
    }

    /// 100Ch, 100Dh, 1017h: heartbeat and guarding exclude each other.
    fn judge_error_control(&mut self, index: u16, new: u64) -> Option<ObjectionKind> {
        let mut runs = |other: u16| {
            let present = if other == index { Some(new) } else { self.number((other, 0)) };
            present.is_some_and(|number| number != 0)
        };
        (new != 0 && runs(0x1017) && runs(0x100C) && runs(0x100D)).then_some(ObjectionKind::TwoErrorControls)
    }

    /// 1200h to 12FFh: an SDO is valid while bit 31 of both COB-IDs is clear. A client may use the default
    /// SDO of another node.
    fn judge_sdo(&mut self, index: u16, sub: u8, new: u32) -> Judgement {
        let other = self.word((index, 3 - sub));
        let present = self.word((index, sub)).filter(|_| !other.is_some_and(is_invalid));
        let change = CobIdChange { present, new };
        let is_default_sdo = matches!(new, 0x581..=0x5FF | 0x601..=0x67F);
        let how = "set bit 31 of one of its COB-IDs";
        match index >= 0x1280 && is_default_sdo {
            true => change.in_use(is_invalid, how),
            false => change.judge(is_invalid, how),
        }
    }
}

/// The node-ID in an entry of 1016h.
fn watched(consumer: u32) -> Option<u8> {
    let [low, high, node_id, _] = consumer.to_le_bytes();
    ((low | high) != 0 && (1..=127).contains(&node_id)).then_some(node_id)
}

fn signature(new: u64, expected: &'static str) -> Judgement {
    match new.to_le_bytes().starts_with(expected.as_bytes()) {
        true => Ok(None),
        false => Err(ObjectionKind::Signature { expected }),
    }
}
