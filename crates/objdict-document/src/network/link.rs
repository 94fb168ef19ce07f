//! PDOs from node to node, and their entries and CAN-IDs in words.

use objdict_network::{CarriedEntry, LinkRow, MappedEntry, MessageId};

use crate::anchor::Anchor;
use crate::describe::spelled;
use crate::model::Address;

/// A PDO from its sender to one receiver.
pub(super) struct PdoLink<'a> {
    pub(super) row: &'a LinkRow,
    pub(super) can_id: String,
    /// Whether the receiver expects more bits than are sent, and therefore ignores the PDO.
    pub(super) is_too_short: bool,
}

impl<'a> PdoLink<'a> {
    pub(super) fn new(row: &'a LinkRow) -> Self {
        let end = |of: fn(&CarriedEntry) -> &Option<MappedEntry>| {
            let mapped = row.entries.iter().filter(|entry| of(entry).is_some());
            mapped.map(|entry| entry.bit + entry.bits).max().unwrap_or(0)
        };
        let (sent, received) = (end(|entry| &entry.from), end(|entry| &entry.to));
        Self { row, can_id: can_id(row.can_id), is_too_short: sent != 0 && sent < received }
    }

    /// The node that sends it.
    pub(super) fn sender(&self) -> Option<usize> {
        self.row.sender.as_ref().map(|end| end.position)
    }

    /// The node that receives it.
    pub(super) fn receiver(&self) -> Option<usize> {
        self.row.receiver.as_ref().map(|end| end.position)
    }

    /// The lines of the link in a table.
    pub(super) fn rows(&self) -> usize {
        self.row.entries.len().max(1)
    }

    /// The entries in short: `0x6000:01–05, 0x6401:01`; those of the sender, where they are known.
    pub(super) fn span(&self) -> String {
        let entries = self.row.entries.iter().filter_map(|entry| entry.from.as_ref().or(entry.to.as_ref()));
        let mut spans: Vec<(Address, u8)> = Vec::new();
        for Address { index, sub } in entries.filter_map(|entry| entry.address) {
            let number = sub.unwrap_or(0);
            match spans.last_mut() {
                Some((first, last)) if first.index == index && last.checked_add(1) == Some(number) => {
                    *last = number;
                }
                _ => spans.push((Address { index, sub }, number)),
            }
        }
        let shown = |(first, last): (Address, u8)| {
            let anchor = Anchor { index: first.index, sub: first.sub };
            let is_one = first.sub.unwrap_or(0) == last;
            if is_one { anchor.spoken() } else { format!("{}–{last:02X}", anchor.spoken()) }
        };
        spans.into_iter().map(shown).collect::<Vec<_>>().join(", ")
    }
}

/// `0x185`; eight digits for an extended frame.
pub(super) fn can_id(id: MessageId) -> String {
    spelled(id.number, id.is_extended)
}

/// `0x6000:01`; empty for a dummy.
pub(super) fn spoken(entry: &MappedEntry) -> String {
    entry.address.map_or_else(String::new, |Address { index, sub }| Anchor { index, sub }.spoken())
}
