//! PDOs by function, as objects with the names and types of CiA 301.

use super::keys::PDO;
use super::words::{index, quoted, sub, value_of};
use crate::scaffold::{self, Features};
use objdict_keyed::notation::NO_TRANSMISSION;
use objdict_keyed::rules::WRONG_TYPE;
use objdict_keyed::section::{KeyedTable, wrong};
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::{Diagnostic, Findings, say};
use objdict_model::model::{
    CobId, DataType, Device, MappedObject, Object, Objects, PdoKind, Value, predefined,
};
use objdict_node::configure::{transmission_type, transmission_word};

/// Sub-indexes of a communication parameter that keys set.
const TRANSMISSION: u8 = 2;
const INHIBIT: u8 = 3;
const EVENT_TIMER: u8 = 5;
const SYNC_START: u8 = 6;

/// The key that sets a sub-index of a communication parameter.
pub(super) fn key_of(sub: u8) -> Option<&'static str> {
    Some(match sub {
        1 => "cob-id",
        TRANSMISSION => "transmission",
        INHIBIT => "inhibit",
        EVENT_TIMER => "event-timer",
        SYNC_START => "sync-start",
        _ => return None,
    })
}

/// The keys of a PDO.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct PdoSaid {
    map: Option<Vec<MappedObject>>,
    cob_id: Option<Value>,
    transmission: Option<u8>,
    inhibit: Option<u16>,
    event_timer: Option<u16>,
    sync_start: Option<u8>,
}

/// Whether an object belongs to a PDO.
pub(super) fn is_pdo(index: u16) -> bool {
    PdoKind::of_communication(index).is_some() || PdoKind::of_mapping(index).is_some()
}

/// Reads the PDOs of a direction into a device that already has the other objects.
pub(super) fn read(root: &KeyedTable<'_>, kind: PdoKind, device: &mut Device, findings: &mut Findings) {
    let name = if kind == PdoKind::Rpdo { "rpdo" } else { "tpdo" };
    let mut standard = Standard::default();
    for (number, tree) in root.numbered(name, findings) {
        let Some(section) = KeyedTable::new(name, tree.value, PDO, findings) else { continue };
        let said = PdoSaid {
            map: section.get("map").map(|_| mapped(&section, device, findings)),
            cob_id: section.get("cob-id").and_then(|tree| cob_id(tree, kind, number, findings)),
            transmission: section
                .parsed("transmission", transmission_type, NO_TRANSMISSION, findings)
                .map(|said| said.value),
            inhibit: section.time("inhibit", findings).map(|time| time.value),
            event_timer: section.time("event-timer", findings).map(|time| time.value),
            sync_start: section.integer("sync-start", findings).map(|value| value.value),
        };
        said.apply(kind, u16::try_from(number).unwrap_or(1), &mut device.objects, &mut standard);
    }
}

fn cob_id(tree: &KeyedTree, kind: PdoKind, number: i128, findings: &mut Findings) -> Option<Value> {
    if tree.text() == Some("off") {
        return Some(usual_cob_id(kind, u16::try_from(number).unwrap_or(1)).disabled().to_value());
    }
    let is_flag = matches!(&*tree.kind, Kind::Bool(_));
    let value = value_of(tree, Some(DataType::UNSIGNED32)).filter(|_| !is_flag);
    if value.is_none() {
        findings.push(wrong("cob-id", tree, "a COB-ID").help("write a number, `$NODEID+0x180`, or `off`"));
    }
    value
}

fn usual_cob_id(kind: PdoKind, number: u16) -> CobId {
    kind.predefined_can_id(number).map_or(CobId::new(CobId::BIT_31), predefined::per_node)
}

fn mapped(section: &KeyedTable<'_>, device: &Device, findings: &mut Findings) -> Vec<MappedObject> {
    let mut mapped = Vec::new();
    for text in section.texts("map", findings) {
        match mapped_object(text.value, device) {
            Ok(found) => mapped.push(found),
            Err(message) => {
                let finding = Diagnostic::new(
                    &WRONG_TYPE,
                    text.at,
                    say!("`{}` cannot be mapped: {}", text.value, message),
                );
                findings.push(finding.help("write an index and a sub-index of the device, as in `6000:1`"));
            }
        }
    }
    mapped
}

fn mapped_object(text: &str, device: &Device) -> Result<MappedObject, &'static str> {
    const NO_ADDRESS: &str = "it is not an address";
    let (address, bits) = match text.split_once('/') {
        Some((address, bits)) => (address, Some(bits.parse().map_err(|_| "its number of bits is none")?)),
        None => (text, None),
    };
    let (object, entry) = address.split_once(':').unwrap_or((address, "0"));
    let (index, sub) = (index(object).ok_or(NO_ADDRESS)?, sub(entry).ok_or(NO_ADDRESS)?);
    let bits = bits
        .or_else(|| bits_of(index, sub, device))
        .ok_or("the device has no such entry of a known length")?;
    Ok(MappedObject { index, sub, bits })
}

fn bits_of(index: u16, sub: u8, device: &Device) -> Option<u8> {
    let data_type = match device.entry(index, sub) {
        Some(entry) => entry.implied_type()?,
        None => Some(DataType(index)).filter(|data_type| data_type.is_dummy())?,
    };
    data_type.bit_length()
}

/// The objects of PDOs without any key, created on demand.
#[derive(Default)]
pub(super) struct Standard(Option<Device>);

impl Standard {
    fn object(&mut self, index: u16, kind: PdoKind, number: u16) -> Object {
        let enough = |device: &Device| device.objects.contains_key(&index);
        if !self.0.as_ref().is_some_and(enough) {
            let mut features = Features::default();
            let count = if kind == PdoKind::Rpdo { &mut features.rpdos } else { &mut features.tpdos };
            *count = Some(number.max(8));
            (features.rpdo_parameters, features.tpdo_parameters) =
                (Some(SYNC_START.into()), Some(SYNC_START.into()));
            features.mapping_entries = Some(64);
            self.0 = scaffold::base(301, 1, &features).ok();
        }
        let device = self.0.as_ref();
        device.and_then(|device| device.object(index)).cloned().unwrap_or_default()
    }
}

impl PdoSaid {
    /// Creates the objects of a PDO, or changes existing ones.
    pub(super) fn apply(&self, kind: PdoKind, number: u16, objects: &mut Objects, standard: &mut Standard) {
        let indexes = kind.communication_index(number).zip(kind.mapping_index(number));
        let Some((communication, mapping)) = indexes else { return };
        self.communicate(kind, number, communication, objects, standard);
        let is_new = !objects.contains_key(&mapping);
        let full = standard.object(mapping, kind, number);
        let object = objects.get_mut(&mapping).cloned().unwrap_or_else(|| full.clone());
        let object = match &self.map {
            Some(map) => with_map(object, map, &full, is_new),
            None if is_new => with_map(object, &[], &full, true),
            None => object,
        };
        objects.insert(mapping, object);
    }

    fn communicate(
        &self,
        kind: PdoKind,
        number: u16,
        index: u16,
        objects: &mut Objects,
        standard: &mut Standard,
    ) {
        let full = standard.object(index, kind, number);
        let is_new = !objects.contains_key(&index);
        let mut object = objects.get(&index).cloned().unwrap_or_else(|| full.clone());
        let numbers = [
            (TRANSMISSION, self.transmission.map(u64::from)),
            (INHIBIT, self.inhibit.map(u64::from)),
            (EVENT_TIMER, self.event_timer.map(u64::from)),
            (SYNC_START, self.sync_start.map(u64::from)),
        ];
        if is_new {
            let usual: &[u8] = if kind == PdoKind::Rpdo { &[0, 1, 2] } else { &[0, 1, 2, 3, 5] };
            let said = |sub: u8| numbers.iter().any(|(of, number)| *of == sub && number.is_some());
            let subs = object.subs.iter().filter(|(sub, _)| usual.contains(sub) || said(*sub));
            object.subs = subs.map(|(sub, entry)| (sub, entry.clone())).collect();
        }
        for (sub, number) in numbers {
            let Some(number) = number else { continue };
            if object.subs.get(sub).is_none() {
                take(&mut object, sub, &full);
            }
            if let Some(entry) = object.subs.get_mut(sub) {
                entry.default = Some(Value::Unsigned(number));
            }
        }
        if let Some(entry) = object.subs.get_mut(1) {
            let maps = self.map.as_ref().is_some_and(|map| !map.is_empty());
            let enabled =
                entry.default.as_ref().and_then(CobId::from_value).filter(|_| maps).map(CobId::enabled);
            let enabled = enabled.map(CobId::to_value);
            entry.default = self.cob_id.clone().or(enabled).or(entry.default.take());
        }
        counted(&mut object);
        objects.insert(index, object);
    }

    /// The keys that turn a PDO into that of a device; `None` if an object is missing.
    pub(super) fn of(device: &Device, kind: PdoKind, number: u16) -> Option<Self> {
        let pdo = device.pdo(kind, number)?;
        let (communication, mapping) = (pdo.communication?, pdo.mapping?);
        let value = |sub: u8| communication.subs.get(sub)?.default.as_ref()?.as_integer();
        let count = mapping.subs.get(0)?.default.as_ref()?.as_integer()?;
        let slot = |sub: u8| {
            let number = mapping.subs.get(sub)?.default.as_ref()?.as_integer()?;
            Some(MappedObject::from_number(u32::try_from(number).ok()?))
        };
        let map: Option<Vec<MappedObject>> = (1..=u8::try_from(count).ok()?).map(slot).collect();
        Some(Self {
            map,
            cob_id: communication.subs.get(1)?.default.clone(),
            transmission: value(TRANSMISSION).and_then(|number| u8::try_from(number).ok()),
            inhibit: value(INHIBIT).and_then(|number| u16::try_from(number).ok()),
            event_timer: value(EVENT_TIMER).and_then(|number| u16::try_from(number).ok()),
            sync_start: value(SYNC_START).and_then(|number| u8::try_from(number).ok()),
        })
    }

    /// The minimum of keys that produce the same objects from the existing ones.
    pub(super) fn least(
        self,
        kind: PdoKind,
        number: u16,
        objects: &Objects,
        standard: &mut Standard,
    ) -> Self {
        let made = |said: &Self, standard: &mut Standard| {
            let mut objects: Objects = [kind.communication_index(number), kind.mapping_index(number)]
                .into_iter()
                .flatten()
                .filter_map(|index| Some((index, objects.get(&index)?.clone())))
                .collect();
            said.apply(kind, number, &mut objects, standard);
            objects
        };
        let wanted = made(&self, standard);
        let mut least = self;
        let without: [fn(&mut Self); 6] = [
            |said| said.cob_id = None,
            |said| said.transmission = None,
            |said| said.inhibit = None,
            |said| said.event_timer = None,
            |said| said.sync_start = None,
            |said| said.map = None,
        ];
        for without in without {
            let mut less = least.clone();
            without(&mut less);
            if made(&less, standard) == wanted {
                least = less;
            }
        }
        least
    }

    /// The lines of the table of a PDO.
    pub(super) fn lines(&self, device: &Device, kind: PdoKind, number: u16) -> Vec<String> {
        let mut lines = Vec::new();
        if let Some(map) = &self.map {
            let entries: Vec<String> = map.iter().map(|mapped| quoted(&address(*mapped, device))).collect();
            lines.push(format!("map = [{}]", entries.join(", ")));
        }
        if let Some(value) = &self.cob_id {
            let is_off = *value == usual_cob_id(kind, number).disabled().to_value();
            let text =
                if is_off { quoted("off") } else { super::words::spelled(value, true).unwrap_or_default() };
            lines.push(format!("cob-id = {text}"));
        }
        if let Some(number) = self.transmission {
            lines.push(format!("transmission = {}", quoted(&transmission_word(number))));
        }
        if let Some(time) = self.inhibit {
            lines.push(format!("inhibit = {}", quoted(&milliseconds(u32::from(time)))));
        }
        if let Some(time) = self.event_timer {
            lines.push(format!("event-timer = {}", quoted(&format!("{time}ms"))));
        }
        lines.extend(self.sync_start.map(|number| format!("sync-start = {number}")));
        lines
    }
}

/// Tenths of a millisecond.
fn milliseconds(tenths: u32) -> String {
    if tenths.is_multiple_of(10) { format!("{}ms", tenths / 10) } else { format!("{}us", tenths * 100) }
}

fn address(mapped: MappedObject, device: &Device) -> String {
    let MappedObject { index, sub, bits } = mapped;
    let bits = Some(bits).filter(|bits| bits_of(index, sub, device) != Some(*bits));
    let bits = bits.map(|bits| format!("/{bits}")).unwrap_or_default();
    if sub == 0 { format!("{index:04X}{bits}") } else { format!("{index:04X}:{sub:X}{bits}") }
}

/// A mapping parameter with these entries; further ones come from the full object.
fn with_map(mut object: Object, map: &[MappedObject], full: &Object, is_new: bool) -> Object {
    if is_new {
        let count = if map.is_empty() { 8 } else { map.len() };
        let subs = full.subs.iter().filter(|(sub, _)| usize::from(*sub) <= count);
        object.subs = subs.map(|(sub, entry)| (sub, entry.clone())).collect();
    }
    for (sub, mapped) in (1..=64u8).zip(map) {
        if object.subs.get(sub).is_none() {
            take(&mut object, sub, full);
        }
        if let Some(entry) = object.subs.get_mut(sub) {
            entry.default = Some(Value::Unsigned(mapped.to_number().into()));
        }
    }
    for (sub, entry) in object.subs.iter_mut() {
        if usize::from(sub) > map.len() && entry.default.is_some() {
            entry.default = Some(Value::Unsigned(0));
        }
    }
    if let Some(entry) = object.subs.get_mut(0) {
        entry.default = u64::try_from(map.len()).ok().map(Value::Unsigned);
    }
    object.sub_number = u8::try_from(object.subs.len()).ok();
    object
}

/// Sets the number of entries of a communication parameter after adding a sub-index.
fn counted(object: &mut Object) {
    let highest = object.highest_sub().map(|highest| Value::Unsigned(highest.into()));
    if let Some(entry) = object.subs.get_mut(0) {
        entry.default = highest;
    }
    object.sub_number = u8::try_from(object.subs.len()).ok();
}

/// Copies an entry from another object.
fn take(object: &mut Object, sub: u8, full: &Object) {
    if let Some(entry) = full.subs.get(sub) {
        object.subs.insert(sub, entry.clone());
    }
}
