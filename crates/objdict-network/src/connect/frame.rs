//! The content of the lead's PDO, and the part that each consumer uses.

use std::collections::BTreeMap;

use super::ends::Carried;
use super::groups::{LeadSignal, Receiver};
use crate::model::{MappedObject, Pdo};

/// The entries of a group in a PDO.
pub(super) struct GroupFrame<'a> {
    /// Signals by the position of their first bit.
    signals: Vec<(u32, &'a LeadSignal)>,
    /// The lead's mapping.
    pub(super) mapped: Vec<MappedObject>,
    /// The length of the PDO.
    pub(super) bits: u32,
}

/// The part of a frame that a node receives with one RPDO.
pub(super) struct Share {
    pub(super) node: usize,
    pub(super) receivers: Vec<(u32, Receiver)>,
}

impl<'a> GroupFrame<'a> {
    /// As many consecutive signals as fit.
    pub(super) fn of(signals: &[&'a LeadSignal], slots: usize) -> Self {
        let mut frame = Self { signals: Vec::new(), mapped: Vec::new(), bits: 0 };
        for signal in signals.iter().take(slots) {
            let mapped = signal.entry.mapped();
            if frame.bits + u32::from(mapped.bits) > Pdo::FRAME_BITS {
                break;
            }
            frame.signals.push((frame.bits, signal));
            frame.mapped.push(mapped);
            frame.bits += u32::from(mapped.bits);
        }
        frame
    }

    /// The signals that a fixed mapping contains.
    pub(super) fn of_fixed(signals: &[&'a LeadSignal], mapped: &[MappedObject]) -> Self {
        let placed = MappedObject::placed(mapped, |object| object.bits);
        let carried = placed.filter_map(|(first, object)| {
            Some((first, *signals.iter().find(|signal| signal.entry.mapped() == *object)?))
        });
        let bits = mapped.iter().map(|object| u32::from(object.bits)).sum();
        Self { signals: carried.collect(), mapped: mapped.to_vec(), bits }
    }

    /// The number of signals.
    pub(super) const fn len(&self) -> usize {
        self.signals.len()
    }

    pub(super) fn carries(&self, signal: &LeadSignal) -> bool {
        self.signals.iter().any(|(_, carried)| std::ptr::eq(*carried, signal))
    }

    pub(super) fn signals(&self) -> impl Iterator<Item = &'a LeadSignal> + '_ {
        self.signals.iter().map(|(_, signal)| *signal)
    }

    /// The shortest timeout of the lead, or of the manager that receives from it.
    pub(super) fn deadline(&self) -> Option<u16> {
        self.signals().filter_map(|signal| signal.deadline).min()
    }

    /// The share of each consumer, in the order of the nodes; a node with two entries for a signal receives
    /// it twice.
    pub(super) fn shares(&self) -> Vec<Share> {
        let mut shares: BTreeMap<(usize, usize), Share> = BTreeMap::new();
        for (position, signal) in &self.signals {
            let mut times: BTreeMap<usize, usize> = BTreeMap::new();
            for receiver in &signal.receivers {
                let time = times.entry(receiver.node).or_default();
                let share = shares.entry((receiver.node, *time));
                let share = share.or_insert(Share { node: receiver.node, receivers: Vec::new() });
                share.receivers.push((*position, *receiver));
                *time += 1;
            }
        }
        shares.into_values().collect()
    }
}

impl Share {
    /// The entries by the position of their first bit.
    pub(super) fn entries(&self) -> Vec<(u32, Carried)> {
        self.receivers.iter().map(|(position, receiver)| (*position, receiver.entry)).collect()
    }

    /// The shortest timeout of the node for the PDO.
    pub(super) fn deadline(&self) -> Option<u16> {
        self.receivers.iter().filter_map(|(_, receiver)| receiver.deadline).filter(|time| *time > 0).min()
    }
}
