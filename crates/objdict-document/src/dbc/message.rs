//! Messages: the frames of a CAN-ID.

use super::identifier::{DbcName, DbcNames};
use super::signal::DbcSignal;

/// A message.
#[derive(Clone, Debug)]
pub(super) struct DbcMessage {
    pub(super) id: DbcCanId,
    pub(super) name: DbcName,
    /// Length in bytes.
    pub(super) length: u32,
    /// The nodes that send it.
    pub(super) senders: Vec<usize>,
    /// In the order of the frame, with their names.
    pub(super) signals: Vec<(DbcName, DbcSignal)>,
    pub(super) comment: String,
    /// The time between two frames in milliseconds, if it is stated.
    pub(super) cycle: Option<u32>,
    names: DbcNames,
}

/// A CAN-ID: base frames first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct DbcCanId {
    pub(super) is_extended: bool,
    pub(super) number: u32,
}

impl DbcCanId {
    /// A CAN-ID of 11 bits.
    pub(super) const fn base(number: u32) -> Self {
        Self { is_extended: false, number }
    }

    /// The number in the file, where bit 31 marks an extended frame.
    pub(super) const fn in_file(self) -> u32 {
        if self.is_extended { self.number | 1 << 31 } else { self.number }
    }
}

impl DbcMessage {
    pub(super) fn new(id: DbcCanId, name: DbcName, length: u32, comment: impl Into<String>) -> Self {
        Self {
            id,
            name,
            length,
            senders: Vec::new(),
            signals: Vec::new(),
            comment: comment.into(),
            cycle: None,
            names: DbcNames::default(),
        }
    }

    /// Adds a signal.
    pub(super) fn push(&mut self, signal: DbcSignal) {
        let name = self.names.claim(&signal.words, &signal.suffix);
        self.signals.push((name, signal));
    }

    /// Adds a node that receives all signals.
    pub(super) fn received_by(&mut self, node: usize) {
        for (_, signal) in &mut self.signals {
            signal.receivers.insert(node);
        }
    }
}
