//! The data that PDOs carry between nodes.

use std::fmt;

use super::{ConfiguredNetwork, End};
use crate::compiled::PdoState;
use crate::messages::{Message, MessageId, Party, Service};
use crate::model::{Address, Device, Entry, MappedObject};

/// A PDO from its sender to one receiver.
#[derive(Clone, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LinkRow {
    /// The CAN-ID.
    pub can_id: MessageId,
    /// The sender; `None` if no node sends it.
    pub sender: Option<End>,
    /// The receiver; `None` if no node receives it.
    pub receiver: Option<End>,
    /// The entries of sender and receiver, in bit order.
    pub entries: Vec<CarriedEntry>,
}

/// A part of a PDO.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CarriedEntry {
    /// The first bit in the PDO.
    pub bit: u32,
    /// The number of bits.
    pub bits: u32,
    /// The entry of the sender; `None` if its mapping is unknown or has a different layout.
    pub from: Option<MappedEntry>,
    /// The entry of the receiver.
    pub to: Option<MappedEntry>,
}

/// A mapped entry with its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MappedEntry {
    /// The entry, or the object if that is its only entry; `None` for a data type as a dummy.
    pub address: Option<Address>,
    /// The names of object and entry: `Statusword`, `Read input / Input 1 to 8`; empty if the description does not have it.
    pub name: String,
}

/// `6041h Statusword`, `6000h:01 Read input / Input 1 to 8`, `dummy`.
impl fmt::Display for MappedEntry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.address {
            None => return f.write_str(&self.name),
            Some(Address { index, sub: None }) => write!(f, "{index:04X}h")?,
            Some(Address { index, sub: Some(sub) }) => write!(f, "{index:04X}h:{sub:02X}")?,
        }
        if self.name.is_empty() { Ok(()) } else { write!(f, " {}", self.name) }
    }
}

impl serde::Serialize for MappedEntry {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(feature = "schema")]
objdict_model::inline_schemas! {
    MappedEntry: |_| schemars::json_schema!({ "type": "string" });
}

impl ConfiguredNetwork<'_> {
    /// The links of a message; none if it is not a PDO.
    pub(super) fn links(self, can_id: MessageId, message: &Message) -> Vec<LinkRow> {
        let is_pdo = |party: &&Party| matches!(party.service, Service::Pdo(_));
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
        let parts = |party: Option<Party>| -> Vec<CarriedBits> {
            let state = party.and_then(|party| Some((self.compiled.pdo(&party)?, party.node)));
            state.map_or_else(Vec::new, |(state, node)| self.parts(state, node))
        };
        let (sent, received) = (parts(sender), parts(receiver));
        let is_same = |one: &CarriedBits, other: &CarriedBits| (one.bit, one.bits) == (other.bit, other.bits);
        let mut entries: Vec<CarriedEntry> = Vec::new();
        for part in &sent {
            let to = received.iter().find(|other| is_same(part, other)).map(|other| other.entry.clone());
            entries.push(CarriedEntry { bit: part.bit, bits: part.bits, from: Some(part.entry.clone()), to });
        }
        for part in received.iter().filter(|part| !sent.iter().any(|other| is_same(part, other))) {
            let to = Some(part.entry.clone());
            entries.push(CarriedEntry { bit: part.bit, bits: part.bits, from: None, to });
        }
        entries.sort_by_key(|entry| (entry.bit, entry.bits));
        entries
    }

    fn parts(self, pdo: &PdoState, node: usize) -> Vec<CarriedBits> {
        let placed = MappedObject::placed(pdo.mapping.values(), |object| object.bits);
        let part = |(bit, object): (u32, &MappedObject)| {
            let mut entry = self.named(&self.network.nodes[node].device, *object);
            // the entries of a generated description name the node and its entry
            if let Some((_, name)) = entry.name.split_once(" / ").filter(|_| self.network.is_made(node)) {
                entry.name = name.to_owned();
            }
            CarriedBits { bit, bits: object.bits.into(), entry }
        };
        placed.map(part).collect()
    }

    fn named(self, device: &Device, mapped: MappedObject) -> MappedEntry {
        if mapped.is_dummy() {
            let name = self.language.pick("dummy", "unbenutzt").to_owned();
            return MappedEntry { address: None, name };
        }
        self.entry(device, mapped.index, mapped.sub)
    }

    /// An entry with its name.
    pub(super) fn entry(self, device: &Device, index: u16, sub: u8) -> MappedEntry {
        let Some(object) = device.object(index) else {
            return MappedEntry { address: Some(Address { index, sub: Some(sub) }), name: String::new() };
        };
        let of_object = self.name(&object.main);
        match object.entry(sub).filter(|_| object.object_type().has_subs()) {
            Some(entry) => MappedEntry {
                address: Some(Address { index, sub: Some(sub) }),
                name: format!("{of_object} / {}", self.name(&entry)),
            },
            None => MappedEntry { address: Some(Address { index, sub: None }), name: of_object.to_owned() },
        }
    }

    /// The name in the language of the tables, otherwise as in the file.
    fn name(self, entry: &Entry) -> &str {
        let label = entry.parameter.as_ref().and_then(|parameter| parameter.labels.name_in(self.tag));
        label.map(str::trim).filter(|label| !label.is_empty()).unwrap_or(&entry.name)
    }
}

/// A mapped object in its PDO.
struct CarriedBits {
    bit: u32,
    bits: u32,
    entry: MappedEntry,
}
