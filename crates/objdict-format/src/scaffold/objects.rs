//! Objects as documents describe them.

use super::demanded::Demanded;
use super::number;
use objdict_model::model::{
    Access, CobId, DataType, Device, Entry, ObjFlags, Object, ObjectType, PdoMapping, Value, predefined,
};
use objdict_profile::{EntryFacts, Mapping, ObjectFacts, Profile};

/// Creates objects from the documents; the general document is first.
pub struct ObjectMaker<'a> {
    /// The profile and the features.
    pub plan: Demanded,
    /// The documents that require objects.
    pub documents: &'a [&'a Profile],
}

impl ObjectMaker<'_> {
    /// Adds an object, with the sub-indexes that it needs.
    pub fn add(&self, device: &mut Device, index: u16) {
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
            self.count(object, index);
        } else if let Some((_, entry)) = entries.into_iter().next() {
            let (name, object_type) = (std::mem::take(&mut object.main.name), object.main.object_type);
            object.main = Entry { name, object_type, ..entry };
        }
    }

    /// Writes the numbers of sub-indexes into an object.
    pub fn count(&self, object: &mut Object, index: u16) {
        // sub-index 0 of the error history is the number of errors
        let highest = if index == 0x1003 { 0 } else { object.highest_sub().unwrap_or(0) };
        if let Some(entry) = object.subs.get_mut(0) {
            entry.default = number(highest.into(), DataType::UNSIGNED8);
        }
        object.sub_number = u8::try_from(object.subs.len()).ok();
    }

    /// Adds the required objects from this index on, until the documents require no more.
    pub(super) fn complete(&self, device: &mut Device, first: u16) {
        while let Some(index) = self.missing(device, first) {
            self.add(device, index);
        }
    }

    /// The first required object that the device lacks.
    fn missing(&self, device: &Device, first: u16) -> Option<u16> {
        let is_missing = |facts: &ObjectFacts<'_>| {
            // conditions are costly
            facts.first >= first && !device.objects.contains_key(&facts.first) && facts.is_demanded(device, 0)
        };
        let mut objects = self.documents.iter().flat_map(|document| document.objects());
        objects.find(is_missing).map(|facts| facts.first)
    }

    /// Whether the profile defines an object, and not only for other devices.
    pub(super) fn is_for(&self, device: &Device, index: u16) -> bool {
        let facts = self.documents.last().and_then(|document| document.object(index));
        facts.is_some_and(|facts| facts.is_for(device, 0))
    }

    /// The definition of an object in the last document that contains it.
    pub fn described(&self, index: u16) -> Option<Object> {
        let facts = self.facts(index);
        let facts = facts.iter().rfind(|facts| facts.states_type())?;
        let mut object = Object::default();
        object.main.name = facts.name.into();
        object.main.object_type = Some(facts.object_type());
        Some(object)
    }

    /// Whether a document describes an entry.
    pub fn knows(&self, index: u16, sub: u8) -> bool {
        self.facts(index).iter().any(|facts| facts.entry(sub).is_some())
    }

    /// The definitions of an object in the documents.
    fn facts(&self, index: u16) -> Vec<ObjectFacts<'_>> {
        self.documents.iter().filter_map(|document| document.object(index)).collect()
    }

    /// The sub-indexes of an object: the required ones, and one per channel.
    fn subs(&self, device: &Device, index: u16) -> impl Iterator<Item = u8> + use<> {
        let count = self.plan.count(index);
        let mut needed = [false; 256];
        for facts in self.facts(index).iter().flat_map(ObjectFacts::entries) {
            needed[usize::from(facts.first)] |= facts.first == 0 || facts.need.is_there(device, 0);
            if count.is_some() || facts.last > facts.first {
                (facts.first..=facts.last.min(count.unwrap_or(1)))
                    .for_each(|sub| needed[usize::from(sub)] = true);
            }
        }
        (0..=254u8).filter(move |&sub| needed[usize::from(sub)])
    }

    /// An entry as the documents describe it; the profile takes precedence.
    pub fn entry(&self, index: u16, sub: u8) -> Entry {
        let facts = self.facts(index);
        let facts: Vec<EntryFacts<'_>> = facts.iter().rev().filter_map(|facts| facts.entry(sub)).collect();
        let data_type = facts.iter().find_map(|facts| facts.data_types.first().copied());
        let mapping = facts.iter().find_map(|facts| facts.mapping);
        let access = facts.iter().find_map(|facts| facts.access.first().copied());
        let default = facts.iter().find_map(|facts| facts.default.cloned());
        let range =
            facts.iter().find(|facts| facts.first <= sub && sub <= facts.last && facts.last > facts.first);
        let name = facts.iter().map(|facts| facts.name).find(|name| !name.is_empty());
        // version 1 of the profiles used this name for the number of errors, and a version always generates
        // the same device
        let name = name.filter(|_| (index, sub) != (0x1003, 0));
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
            // writing stores or restores parameters or executes a command, which a configuration download
            // must not do
            flags: matches!((index, sub), (0x1010 | 0x1011, 1..) | (0x1023, 1)).then_some(ObjFlags(1)),
            default: self.value(index, sub).or(default).or_else(|| first_value(data_type?, &facts)),
            ..Entry::default()
        }
    }

    /// The value of an entry that depends on the device, or the default for a new device if the documents do
    /// not specify one.
    fn value(&self, index: u16, sub: u8) -> Option<Value> {
        let Demanded { profile, features } = &self.plan;
        let is_on = |feature| feature == Some(true);
        Some(match (index, sub) {
            (0x1000, 0) => Value::Unsigned(self.plan.device_type().into()),
            (0x1005, 0) => {
                let role = if is_on(features.sync_producer) { CobId::BIT_30 } else { 0 };
                Value::Unsigned((u32::from(predefined::SYNC) | role).into())
            }
            (0x1006, 0) if is_on(features.sync_producer) => Value::Unsigned(SYNC_PERIOD),
            // groups of parameters are stored and restored on command
            (0x1010 | 0x1011, 1..) => Value::Unsigned(1),
            (0x1012, 0) => {
                let role = if is_on(features.time_producer) { CobId::BIT_30 } else { CobId::BIT_31 };
                Value::Unsigned((u32::from(predefined::TIME) | role).into())
            }
            (0x1014, 0) => predefined::per_node(predefined::EMCY).to_value(),
            (0x1017, 0) => Value::Unsigned(HEARTBEAT),
            (0x1200, 1) => predefined::per_node(predefined::SDO_REQUEST).to_value(),
            (0x1200, 2) => predefined::per_node(predefined::SDO_RESPONSE).to_value(),
            (0x1028, 1..) | (0x1201..=0x12FF, 1 | 2) => Value::Unsigned(CobId::BIT_31.into()),
            (0x1201..=0x12FF, 3) => Value::Unsigned(1),
            (0x6502, 0) if *profile == 402 => Value::Unsigned(features.modes.unwrap_or_default().into()),
            (index, sub) if *profile == 402 && MOVING.contains(&(index, sub)) => Value::Unsigned(1),
            (index, 1 | 2) if *profile == 402 && RATIOS.contains(&index) => Value::Unsigned(1),
            (0x6112, 1..) if *profile == 404 => Value::Unsigned(NORMAL_OPERATION),
            // an encoder measures at least one step of one revolution
            (0x6001 | 0x6002 | 0x6501 | 0x6502, 0) | (0x6005, 1 | 2) if *profile == 406 => Value::Unsigned(1),
            _ => return None,
        })
    }
}

/// Microseconds between two SYNC messages of a new device that produces them.
const SYNC_PERIOD: u64 = 10_000;

/// Speeds, ramps, slopes and times of drives, which do not move with 0: the smallest value that allows
/// motion.
const MOVING: [(u16, u8); 12] = [
    (0x6046, 2),
    (0x6048, 1),
    (0x6048, 2),
    (0x6073, 0),
    (0x6081, 0),
    (0x6083, 0),
    (0x6087, 0),
    (0x6099, 1),
    (0x6099, 2),
    (0x60C2, 1),
    (0x60E0, 0),
    (0x60E1, 0),
];

/// Factors of drives: a numerator and a denominator.
const RATIOS: [u16; 10] = [0x604B, 0x604C, 0x6090, 0x6092, 0x6093, 0x6094, 0x6095, 0x6096, 0x6097, 0x60A2];

/// The operating mode of an enabled channel (CiA 404).
const NORMAL_OPERATION: u64 = 1;

/// Milliseconds between two heartbeats of a new device.
const HEARTBEAT: u64 = 1000;

/// A writable entry that an RPDO carries is a process output.
fn directed(access: Access, mapping: Option<Mapping>) -> Access {
    match (access, mapping) {
        (Access::Rw, Some(Mapping::Rpdo)) => Access::Rww,
        (Access::Rw, Some(Mapping::Tpdo)) => Access::Rwr,
        (access, _) => access,
    }
}

/// Zero, or the first allowed value.
fn first_value(data_type: DataType, facts: &[EntryFacts<'_>]) -> Option<Value> {
    let allowed = facts.iter().find(|facts| !facts.values.is_empty());
    let number = match allowed {
        Some(facts) if !facts.accepts_value(0) => *facts.values.first()?.start(),
        _ => 0,
    };
    Value::from_integer(number, data_type)
}

/// Communication objects have lower indexes; no PDO carries one by default.
const FIRST_OF_MANUFACTURER: u16 = 0x2000;
