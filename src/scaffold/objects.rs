//! Objects as documents describe them.

use super::{Functions, Wanted, number};
use crate::model::{Access, DataType, Device, Entry, Object, ObjectType, PdoMapping, Value, predefined};
use crate::profile::{EntryFacts, Mapping, ObjectFacts, Profile};

/// Makes objects of what the documents say of them, the general document first.
pub(super) struct Maker<'a> {
    /// What is wanted of a new device; `None` for an existing one.
    pub(super) wanted: Option<&'a Wanted>,
    pub(super) functions: Functions,
    pub(super) documents: &'a [&'a Profile],
}

impl Maker<'_> {
    /// Adds an object, with the sub-indexes that it needs.
    pub(super) fn add(&self, device: &mut Device, index: u16) {
        let facts: Vec<ObjectFacts<'_>> = self.facts(index);
        let has_subs = facts.iter().any(|facts| facts.states_type() && facts.object_type().has_subs());
        let object_type =
            facts.iter().find(|facts| facts.states_type()).map(objdict_profile::ObjectFacts::object_type);
        let mut object = Object::default();
        object.main.name = self.facts(index).last().map_or("", |facts| facts.name).into();
        object.main.object_type = Some(object_type.unwrap_or(ObjectType::Var));
        device.objects.insert(index, object);
        let entries: Vec<(u8, Entry)> = match has_subs {
            true => self.subs(device, index).map(|sub| (sub, self.entry(index, sub))).collect(),
            false => vec![(0, self.entry(index, 0))],
        };
        let Some(object) = device.objects.get_mut(&index) else { return };
        if has_subs {
            object.subs = entries.into_iter().collect();
            // sub-index 0 of the error history is the number of errors
            let highest = if index == 0x1003 { 0 } else { object.highest_sub().unwrap_or(0) };
            if let Some(entry) = object.subs.get_mut(0) {
                entry.default = number(highest.into(), DataType::UNSIGNED8);
            }
            object.sub_number = u8::try_from(object.subs.len()).ok();
        } else if let Some((_, entry)) = entries.into_iter().next() {
            let (name, object_type) = (std::mem::take(&mut object.main.name), object.main.object_type);
            object.main = Entry { name, object_type, ..entry };
        }
    }

    /// What the documents say of an object.
    fn facts(&self, index: u16) -> Vec<ObjectFacts<'_>> {
        self.documents.iter().filter_map(|document| document.object(index)).collect()
    }

    /// The sub-indexes of an object: those that it needs, and as many as there are channels.
    fn subs(&self, device: &Device, index: u16) -> impl Iterator<Item = u8> {
        let facts = self.facts(index);
        let count = self.functions.count(index);
        let is_needed = move |sub: u8| {
            // a product is identified by its complete identity
            let is_identity = index == 0x1018;
            facts.iter().filter_map(|facts| facts.entry(sub)).any(|facts| {
                let is_demanded = facts.first == sub && facts.need.is_there(device, 0);
                is_demanded || is_identity || sub == 0 || (facts.last > facts.first && sub <= count)
            })
        };
        (0..=254u8).filter(move |&sub| is_needed(sub)).collect::<Vec<_>>().into_iter()
    }

    /// An entry as the documents describe it; where both say something, as that of the profile does.
    pub(super) fn entry(&self, index: u16, sub: u8) -> Entry {
        let facts = self.facts(index);
        let facts: Vec<EntryFacts<'_>> = facts.iter().rev().filter_map(|facts| facts.entry(sub)).collect();
        let data_type = facts.iter().find_map(|facts| facts.data_types.first().copied());
        let mapping = facts.iter().find_map(|facts| facts.mapping);
        let access = facts.iter().find_map(|facts| facts.access.first().copied());
        let default = facts.iter().find_map(|facts| facts.default.cloned());
        let range =
            facts.iter().find(|facts| facts.first <= sub && sub <= facts.last && facts.last > facts.first);
        let name = facts.iter().map(|facts| facts.name).find(|name| !name.is_empty());
        let name = match (name, range) {
            (Some(name), Some(_)) => format!("{name} {sub}"),
            (Some(name), None) => name.to_owned(),
            (None, _) if sub == 0 => "Highest sub-index supported".to_owned(),
            (None, _) => format!("Sub-index {sub}"),
        };
        Entry {
            name: name.into(),
            object_type: Some(ObjectType::Var),
            data_type,
            access: access.map(|access| directed(access, mapping)),
            pdo_mapping: Some(match mapping {
                None | Some(Mapping::No) => PdoMapping::No,
                Some(_) if index < FIRST_OF_MANUFACTURER => PdoMapping::No,
                Some(_) => PdoMapping::Optional,
            }),
            default: self.value(index, sub).or(default).or_else(|| first_value(data_type?, &facts)),
            ..Entry::default()
        }
    }

    /// The value of an entry that depends on the device.
    fn value(&self, index: u16, sub: u8) -> Option<Value> {
        let is_encoder = matches!(self.functions, Functions::Encoder(_));
        Some(match (index, sub) {
            (0x1000, 0) => Value::Unsigned(self.functions.device_type().into()),
            (0x1005, 0) => Value::Unsigned(predefined::SYNC.into()),
            (0x1008, 0) => Value::Text(self.wanted?.product_name.as_str().into()),
            (0x1014, 0) => predefined::per_node(predefined::EMCY).to_value(),
            (0x1017, 0) => Value::Unsigned(HEARTBEAT),
            // an encoder sees at least one step of one revolution
            (0x6001 | 0x6002 | 0x6501 | 0x6502, 0) | (0x6005, 1 | 2) if is_encoder => Value::Unsigned(1),
            (0x1018, 1) => Value::Unsigned(self.wanted?.vendor_id.into()),
            (0x1018, 2) => Value::Unsigned(self.wanted?.product_code.into()),
            (0x1018, 3) => Value::Unsigned(self.wanted?.revision.into()),
            _ => return None,
        })
    }
}

/// Milliseconds between two heartbeats of a new device.
const HEARTBEAT: u64 = 1000;

/// What can be written and goes into an RPDO is a process output.
fn directed(access: Access, mapping: Option<Mapping>) -> Access {
    match (access, mapping) {
        (Access::Rw, Some(Mapping::Rpdo)) => Access::Rww,
        (Access::Rw, Some(Mapping::Tpdo)) => Access::Rwr,
        (access, _) => access,
    }
}

/// Zero, or the first value that is allowed.
fn first_value(data_type: DataType, facts: &[EntryFacts<'_>]) -> Option<Value> {
    let allowed = facts.iter().find(|facts| !facts.values.is_empty());
    let number = match allowed {
        Some(facts) if !facts.accepts_value(0) => *facts.values.first()?.start(),
        _ => 0,
    };
    Value::from_integer(number, data_type)
}

/// Communication objects lie below; no PDO carries one by default.
const FIRST_OF_MANUFACTURER: u16 = 0x2000;
