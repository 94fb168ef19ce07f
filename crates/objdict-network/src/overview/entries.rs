//! What PDOs carry from node to node.

use super::{End, View};
use crate::messages::{Message, MessageId, Party, Service};
use crate::model::{Device, MappedObject};
use crate::stream::PdoState;

/// A PDO from its sender to one receiver.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LinkRow {
    /// The CAN-ID.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::hex"))]
    pub can_id: MessageId,
    /// Who sends it; `None` if no node does.
    pub sender: Option<End>,
    /// Who receives it; `None` if no node does.
    pub receiver: Option<End>,
    /// What goes from which entry to which, in the order of the bits.
    pub entries: Vec<CarriedEntry>,
}

/// A part of a PDO.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CarriedEntry {
    /// The first bit in the PDO.
    pub bit: u32,
    /// The number of bits.
    pub bits: u32,
    /// The entry of the sender with its name: `6041h Statusword`; `None` where its mapping is not known or has another
    /// layout.
    pub from: Option<String>,
    /// The entry of the receiver.
    pub to: Option<String>,
}

impl View<'_> {
    /// The links of a message; none if it is no PDO.
    pub(super) fn links(self, can_id: MessageId, message: &Message) -> Vec<LinkRow> {
        let is_pdo = |party: &&Party| matches!(party.service, Service::Pdo(_) | Service::MirroredPdo);
        let of = |parties: &[Party]| -> Vec<Option<Party>> {
            let parties: Vec<_> = parties.iter().filter(is_pdo).map(|party| Some(*party)).collect();
            if parties.is_empty() { vec![None] } else { parties }
        };
        let link = |sender: Option<Party>, receiver: Option<Party>| LinkRow {
            can_id,
            sender: sender.map(|party| self.end(&party)),
            receiver: receiver.map(|party| self.end(&party)),
            entries: self.linked(sender, receiver),
        };
        let (senders, receivers) = (of(&message.senders), of(&message.receivers));
        let pairs = senders.iter().flat_map(|sender| receivers.iter().map(|receiver| (*sender, *receiver)));
        let pairs = pairs.filter(|(sender, receiver)| sender.is_some() || receiver.is_some());
        pairs.map(|(sender, receiver)| link(sender, receiver)).collect()
    }

    fn linked(self, sender: Option<Party>, receiver: Option<Party>) -> Vec<CarriedEntry> {
        let parts = |party: Option<Party>| -> Vec<Part> {
            let state = party.and_then(|party| Some((self.state(&party)?, party.node?)));
            state.map_or_else(Vec::new, |(state, node)| parts(state, &self.network.nodes[node].device))
        };
        let (sent, received) = (parts(sender), parts(receiver));
        let is_same = |one: &Part, other: &Part| (one.bit, one.bits) == (other.bit, other.bits);
        let mut entries: Vec<CarriedEntry> = Vec::new();
        for part in &sent {
            let to = received.iter().find(|other| is_same(part, other)).map(|other| other.name.clone());
            entries.push(CarriedEntry { bit: part.bit, bits: part.bits, from: Some(part.name.clone()), to });
        }
        for part in received.iter().filter(|part| !sent.iter().any(|other| is_same(part, other))) {
            let to = Some(part.name.clone());
            entries.push(CarriedEntry { bit: part.bit, bits: part.bits, from: None, to });
        }
        entries.sort_by_key(|entry| (entry.bit, entry.bits));
        entries
    }
}

/// A mapped object in its PDO.
struct Part {
    bit: u32,
    bits: u32,
    name: String,
}

fn parts(pdo: &PdoState, device: &Device) -> Vec<Part> {
    let mut next = 0;
    let part = |object: &MappedObject| {
        let bit = next;
        next += u32::from(object.bits);
        Part { bit, bits: object.bits.into(), name: named(device, *object) }
    };
    pdo.mapping.values().map(part).collect()
}

/// `6041h Statusword`, `6000h:01 Read input / Input 1 to 8`, `dummy`.
fn named(device: &Device, mapped: MappedObject) -> String {
    if mapped.is_dummy() {
        return "dummy".to_owned();
    }
    let MappedObject { index, sub, .. } = mapped;
    let Some(object) = device.object(index) else { return format!("{index:04X}h:{sub:02X}") };
    match object.entry(sub).filter(|_| object.object_type().has_subs()) {
        Some(entry) => format!("{index:04X}h:{sub:02X} {} / {}", object.name(), entry.name),
        None => format!("{index:04X}h {}", object.name()),
    }
}
