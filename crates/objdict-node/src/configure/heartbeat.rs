//! Heartbeat consumers (1016h).

use super::{Configurator, Wrong};
use crate::model::{Address, Value};

const CONSUMERS: u16 = 0x1016;

impl Configurator<'_> {
    /// Monitors a node: reuses the entry that already monitors it, else takes the first free one.
    pub(super) fn watch(&mut self, node_id: u8, milliseconds: u16) -> Result<(), Wrong> {
        if node_id == self.node_id {
            return Err(Wrong::new("a node cannot monitor its own heartbeat"));
        }
        let Some(object) = self.device.object(CONSUMERS) else {
            return Err(self.no_object(CONSUMERS));
        };
        let subs: Vec<u8> =
            object.entries().map(|(sub, _)| sub).filter(|sub| (1..=0x7F).contains(sub)).collect();
        let watched = |sub: &u8| {
            let consumer = self.number(CONSUMERS, *sub).unwrap_or_default();
            let (time, node) = (consumer & 0xFFFF, consumer >> 16 & 0xFF);
            if time == 0 || node == 0 { 0 } else { node }
        };
        let own = subs.iter().copied().find(|sub| watched(sub) == u64::from(node_id));
        let free = subs.iter().copied().find(|sub| watched(sub) == 0);
        let Some(sub) = own.or(free) else {
            let wrong = Wrong::new(format!("all {} entries of 1016h monitor other nodes", subs.len()));
            return Err(wrong.help("free one of them first with `--set 1016:1=0`"));
        };
        let (sub, entry) = self.writable(Address { index: CONSUMERS, sub: Some(sub) })?;
        let consumer = u64::from(node_id) << 16 | u64::from(milliseconds);
        self.put(CONSUMERS, sub, &entry, Value::Unsigned(consumer))
    }
}
