//! The nodes of a bus and their entries as text.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::iter;

use super::sdo::Transfers;
use super::stale::Stale;
use crate::dbc::{Scaled, scaling_of};
use crate::describe::{Decoder, ValueReader};
use crate::model::{Assignment, DataType, Device, Entry, MappedObject, Meanings, Object, PdoKind, Value};
use crate::profile;

/// The maximum number of entries that a node has beyond its description.
const MAX_LEARNT: usize = 4096;

/// A node whose frames are read. Its device has the current values of the node.
#[derive(Clone, Copy, Debug)]
pub struct Talker<'a> {
    /// The name.
    pub name: &'a str,
    /// The node-ID, 1 to 127.
    pub node_id: u8,
    /// The device.
    pub device: &'a Device,
    /// Whether its PDOs carry entries of other nodes, which describe them, because it has no description of
    /// its own.
    pub is_counterpart: bool,
}

/// A node with the values that the frames have shown.
#[derive(Debug)]
pub(super) struct TalkingNode<'a> {
    pub(super) name: Cow<'a, str>,
    pub(super) node_id: u8,
    pub(super) is_described: bool,
    pub(super) is_counterpart: bool,
    /// Whether its mapping was written, and no answer confirms it.
    pub(super) is_unconfirmed: bool,
    /// Whether the profile of a node without a description is one that it does not state.
    is_assumed: bool,
    /// Whether a node without a description has used a word, and another object of a drive.
    used: [bool; 2],
    /// The description, and the meanings of all values.
    described: Cow<'a, Device>,
    /// The values after a reset.
    start: Cow<'a, Device>,
    pub(super) device: Cow<'a, Device>,
    /// The entries of `device` that no description has, or for which none has a value.
    learnt: BTreeSet<(u16, u8)>,
    /// The entries whose values may differ between `start` and `device`.
    written: BTreeSet<(u16, u8)>,
    /// What depends on them.
    changed: BTreeSet<Stale>,
}

impl<'a> TalkingNode<'a> {
    fn of_talker(Talker { name, node_id, device, is_counterpart }: Talker<'a>) -> Self {
        let node = Self::of_device(node_id, Cow::Borrowed(device));
        Self { name: Cow::Borrowed(name), is_counterpart, ..node }
    }

    fn of_device(node_id: u8, device: Cow<'a, Device>) -> Self {
        Self {
            name: Cow::default(),
            node_id,
            is_described: true,
            is_counterpart: false,
            is_unconfirmed: false,
            is_assumed: false,
            used: [false; 2],
            described: device.clone(),
            start: device.clone(),
            device,
            learnt: BTreeSet::new(),
            written: BTreeSet::new(),
            changed: BTreeSet::new(),
        }
    }
}

/// The nodes of a bus.
#[derive(Debug)]
pub(super) struct Nodes<'a> {
    all: Vec<TalkingNode<'a>>,
    /// Positions of node-IDs.
    by_id: [Option<u8>; 128],
    /// The device profile of nodes without a description.
    pub(super) profile: Option<u16>,
}

impl<'a> Nodes<'a> {
    pub(super) fn new(talkers: Vec<Talker<'a>>) -> Self {
        let mut nodes = Self { all: Vec::new(), by_id: [None; 128], profile: None };
        talkers.into_iter().for_each(|talker| nodes.add(TalkingNode::of_talker(talker)));
        nodes
    }

    /// Of two nodes with the same node-ID, the first is used.
    fn add(&mut self, node: TalkingNode<'a>) {
        let place = self.by_id.get_mut(usize::from(node.node_id)).filter(|place| place.is_none());
        if let Some((place, at)) = place.zip(u8::try_from(self.all.len()).ok()) {
            *place = Some(at);
            self.all.push(node);
        }
    }

    /// A node that no description covers, from now on.
    pub(super) fn add_unknown(&mut self, node_id: u8) {
        if self.get(node_id).is_none() {
            let (name, node) = (format!("node {node_id}"), TalkingNode::of_device(node_id, Cow::default()));
            let mut node = TalkingNode { name: Cow::Owned(name), is_described: false, ..node };
            if let Some(profile) = self.profile {
                node.assume(profile);
            }
            self.add(node);
        }
    }

    /// Adds the description of a node, which may have been seen without one.
    pub(super) fn describe(&mut self, talker: Talker<'a>) {
        let mut node = TalkingNode::of_talker(talker);
        match self.by_id.get(usize::from(node.node_id)).copied().flatten() {
            Some(at) => {
                let former = &mut self.all[usize::from(at)];
                node.take_over(former);
                *former = node;
            }
            None => self.add(node),
        }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &TalkingNode<'a>> {
        self.all.iter()
    }

    pub(super) fn get(&self, node_id: u8) -> Option<&TalkingNode<'a>> {
        let at = self.by_id.get(usize::from(node_id)).copied().flatten()?;
        self.all.get(usize::from(at))
    }

    pub(super) fn get_mut(&mut self, node_id: u8) -> Option<&mut TalkingNode<'a>> {
        let at = self.by_id.get(usize::from(node_id)).copied().flatten()?;
        self.all.get_mut(usize::from(at))
    }

    /// The name of a node.
    pub(super) fn name(&self, node_id: u8) -> String {
        self.get(node_id).map_or_else(|| format!("node {node_id}"), |node| node.name.clone().into_owned())
    }

    /// Information about an entry's value in a transfer.
    pub(super) fn transferred<'t>(
        &self,
        transfers: &'t Transfers,
        channel: (u8, u16),
        entry: (u16, u8),
    ) -> &'t [u8] {
        let length = || self.get(channel.0)?.data_type(entry)?.byte_length();
        transfers.value(channel, length)
    }

    /// `1017:00 Producer heartbeat time`.
    pub(super) fn entry(&self, node_id: u8, entry: (u16, u8)) -> String {
        named(entry, &self.get(node_id).map_or(Cow::default(), |node| node.entry_name(entry)))
    }

    /// The entry, and whether the description has it.
    pub(super) fn marked_entry(&self, node_id: u8, entry: (u16, u8)) -> String {
        self.entry(node_id, entry) + self.get(node_id).map_or("", |node| node.missing_mark(entry))
    }

    /// The entry with a value, and with its length if that differs from the description.
    pub(super) fn value(&self, node_id: u8, entry: (u16, u8), bytes: &[u8]) -> String {
        let node = self.get(node_id);
        let words = node.and_then(|node| node.words(entry, bytes)).unwrap_or_else(|| raw_bytes(bytes));
        let length = node.and_then(|node| node.data_type(entry)?.byte_length());
        let other = length.and_then(|length| other_length(bytes.len(), length.into())).unwrap_or_default();
        format!("{} = {words}{other}", self.marked_entry(node_id, entry))
    }
}

/// `1017:00 Producer heartbeat time`; without a name only the address.
pub(super) fn named((index, sub): (u16, u8), name: &str) -> String {
    if name.is_empty() { format!("{index:04X}:{sub:02X}") } else { format!("{index:04X}:{sub:02X} {name}") }
}

/// Bytes without a type that interprets them: `01h 25h`.
pub fn raw_bytes(bytes: &[u8]) -> String {
    let digits: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}h")).collect();
    digits.join(" ")
}

/// A string whose last character may be a control character: `STT<00h>`.
fn escaped_end(text: &str) -> String {
    match text.strip_suffix(char::is_control) {
        Some(start) => format!("{start}<{:02X}h>", text[start.len()..].chars().next().map_or(0, u32::from)),
        None => text.to_owned(),
    }
}

/// The differing length of a value or a PDO: ` (6 bytes, expected 3)`.
pub(super) fn other_length(is: usize, expected: usize) -> Option<String> {
    let unit = if is == 1 { "byte" } else { "bytes" };
    (is != expected).then(|| format!(" ({is} {unit}, expected {expected})"))
}

/// The mark for content that the description of its node lacks.
pub(super) const MISSING: &str = " (not in the description)";

impl TalkingNode<'_> {
    /// The name of an entry in the device, otherwise in the documents of its profile, CiA 301 and CiA 302.
    pub(super) fn entry_name(&self, (index, sub): (u16, u8)) -> Cow<'_, str> {
        let own = self.device.entry(index, sub).map(|entry| entry.name.to_string());
        match own.filter(|name| !name.is_empty()) {
            Some(name) => name.into(),
            None => profile::entry(&self.device, index, sub).map_or("", |(name, _)| name).into(),
        }
    }

    /// The mark for an entry that the description lacks.
    pub(super) fn missing_mark(&self, (index, sub): (u16, u8)) -> &'static str {
        if self.is_described && self.described.entry(index, sub).is_none() { MISSING } else { "" }
    }

    /// The type of an entry.
    pub(super) fn data_type(&self, entry: (u16, u8)) -> Option<DataType> {
        self.data_types(entry).next()
    }

    /// The types of an entry in the device and in the documents.
    fn data_types(&self, (index, sub): (u16, u8)) -> impl Iterator<Item = DataType> {
        let own = || {
            let object = self.device.object(index)?;
            let of_count =
                || DataType::of_sub_0(index).filter(|_| sub == 0 && object.object_type().has_subs());
            object.entry(sub)?.implied_type().or_else(of_count)
        };
        // most values are as the device has them
        let of_documents = iter::once_with(move || profile::entry(&self.device, index, sub)?.1);
        own().into_iter().chain(of_documents.flatten())
    }

    /// The value of the bytes of an SDO. If the length differs from the description, the type in the
    /// documents may apply.
    pub(super) fn value_of(&self, entry: (u16, u8), bytes: &[u8]) -> Option<Value> {
        self.typed(entry, bytes).map(|(value, _)| value)
    }

    fn typed(&self, entry: (u16, u8), bytes: &[u8]) -> Option<(Value, DataType)> {
        self.data_types(entry).find_map(|data_type| Some((Value::from_bytes(bytes, data_type)?, data_type)))
    }

    /// A value with its meaning or its unit: `1591 (state: operation enabled)`, `1200 (120 mm)`.
    fn words(&self, entry: (u16, u8), bytes: &[u8]) -> Option<String> {
        let (value, data_type) = self.typed(entry, bytes)?;
        let scaling = || scaling_of(&self.described, &self.meanings(), entry);
        Some(self.words_in(entry, &value, Some(data_type), scaling))
    }

    /// The value with a known type, scale and unit, as text.
    pub(super) fn words_in(
        &self,
        (index, sub): (u16, u8),
        value: &Value,
        data_type: Option<DataType>,
        scaling: impl FnOnce() -> Option<Scaled>,
    ) -> String {
        let node_id = Some(self.node_id);
        let short = match value {
            Value::Bytes(bytes) => raw_bytes(bytes),
            Value::Text(text) if text.contains(char::is_control) => {
                text.split_inclusive(char::is_control).map(escaped_end).collect()
            }
            value => ValueReader { index, node_id }.short(Some(value), data_type),
        };
        let description = Some(&*self.described).filter(|_| self.is_described);
        let decoder = Decoder { description, ..Decoder::english(&self.device, node_id) };
        match decoder.of(index, sub, value) {
            Some(meaning) => match self.command(index, value) {
                Some(command) => format!("{short} (command: {command}, {meaning})"),
                None => format!("{short} ({meaning})"),
            },
            None => match scaling().and_then(|scaled| scaled.of(value)) {
                Some(scaled) if scaled.split(' ').next() == Some(&short) => scaled,
                Some(scaled) => format!("{short} ({scaled})"),
                None => short,
            },
        }
    }

    /// The name of a value if it is a state, a mode, a command or similar.
    pub(super) fn state(&self, (index, sub): (u16, u8), value: &Value) -> Option<String> {
        if let Some(command) = self.command(index, value) {
            return Some(command.to_owned());
        }
        let number = value.as_integer()?;
        if let Some(name) = scaling_of(&self.start, &self.start.meanings(), (index, sub))
            .and_then(|scaled| scaled.name(number).map(str::to_owned))
        {
            return Some(name);
        }
        // fields consist of bits, even in negative numbers
        let bits = (number & i128::from(u64::MAX)) as u64;
        let fields = profile::of_object(&self.device, index).filter(|(profile, _)| profile.group != "cia301");
        let mut fields = fields.filter_map(|(_, facts)| facts.entry(sub)).flat_map(|facts| facts.bits());
        let field = fields.find(|field| field.meanings().len() > 1)?;
        field.meaning(bits).map(str::to_owned)
    }

    /// The command in a word of the device profile's state machine: `shutdown`.
    fn command(&self, index: u16, value: &Value) -> Option<&'static str> {
        // the state machines of documents receive their commands in the profile area
        let machine =
            (0x6000..0xA000).contains(&index).then(|| profile::of_device(&self.device)?.state_machine())?;
        let machine = machine.filter(|machine| machine.command == index)?;
        let number = value.as_integer()?;
        let is_given = |mask: &str| {
            let bits = mask.bytes().rev().filter(|byte| *byte != b' ');
            bits.enumerate().all(|(bit, wanted)| match wanted {
                b'0' | b'1' => number >> bit & 1 == i128::from(wanted == b'1'),
                _ => true,
            })
        };
        machine.commands.iter().find(|(mask, _)| is_given(mask)).map(|(_, name)| *name)
    }

    /// The scale and the unit of an entry.
    pub(super) fn scaling(&self, meanings: &Meanings<'_>, entry: (u16, u8)) -> Option<Scaled> {
        scaling_of(&self.described, meanings, entry)
    }

    pub(super) fn meanings(&self) -> Meanings<'_> {
        self.described.meanings()
    }

    /// Adds the entries that PDOs map and no description has.
    pub(super) fn learn_mapped(&mut self) {
        let slots = self.device.pdos().flat_map(|pdo| pdo.slots);
        let mapped: Vec<MappedObject> = slots.filter_map(|slot| slot.object).collect();
        mapped.into_iter().filter(|object| !object.is_unused()).for_each(|object| self.learn(object.entry()));
    }

    /// Has a device profile, as far as the node does not state one.
    fn assume(&mut self, profile: u16) -> bool {
        self.is_assumed = self.device.profile().is_none();
        if self.is_assumed {
            self.learn((0x1000, 0));
            let value = Value::Unsigned(profile.into());
            self.device.to_mut().assign(&[Assignment { index: 0x1000, sub: 0, value }]);
        }
        self.is_assumed
    }

    /// A node without a description that uses controlword or statusword, and modes, positions or velocities, is a drive
    /// (CiA 402); whether this shows it.
    pub(super) fn note_use(&mut self, (index, _): (u16, u8)) -> bool {
        self.used[0] |= matches!(index, 0x6040 | 0x6041);
        self.used[1] |= matches!(index, 0x6060 | 0x6061 | 0x6064 | 0x606C | 0x607A | 0x60FF);
        self.used == [true; 2] && !self.is_described && !self.is_assumed && self.assume(402)
    }

    /// Adds an entry that was read or written, and the one that a mapping entry maps by it; which one that is.
    pub(super) fn learn_written(&mut self, entry: (u16, u8), bytes: &[u8]) -> Option<(u16, u8)> {
        self.learn(entry);
        if let ((index, 1..), &[bits, sub, low, high]) = (entry, bytes)
            && PdoKind::of_mapping(index).is_some()
        {
            let mapped = MappedObject::from_number(u32::from_le_bytes([bits, sub, low, high]));
            if !mapped.is_unused() {
                self.learn(mapped.entry());
                return Some(mapped.entry());
            }
        }
        None
    }

    /// Adds an entry that no description has, as the documents define it, so that it can have a value.
    pub(super) fn learn(&mut self, (index, sub): (u16, u8)) {
        if self.learnt.len() >= MAX_LEARNT || self.device.object(index).is_some_and(|object| object.has(sub))
        {
            return;
        }
        let facts = profile::of_object(&self.device, index)
            .find_map(|(_, facts)| Some((facts.name, facts.object_type(), facts.entry(sub)?)));
        let Some((name, object_type, facts)) = facts else { return };
        let described = self.device.object(index);
        if described.is_some_and(|object| object.object_type().has_subs() != object_type.has_subs()) {
            // content of the description would change its meaning
            return;
        }
        self.learnt.insert((index, sub));
        let entry_name = if facts.name.is_empty() { name } else { facts.name };
        let entry = Entry {
            name: entry_name.into(),
            data_type: facts.data_types.first().copied(),
            ..Entry::default()
        };
        let object = self.device.to_mut().objects.get_or_insert_with(index, || {
            let main = Entry { name: name.into(), object_type: Some(object_type), ..Entry::default() };
            Object { main, ..Object::default() }
        });
        if object_type.has_subs() {
            object.subs.insert(sub, entry);
        } else {
            object.main = Entry { object_type: Some(object_type), ..entry };
        }
    }

    /// Records a current value of the node; returns whether it is new.
    pub(super) fn take(&mut self, entry: (u16, u8), bytes: &[u8]) -> bool {
        let (index, sub) = entry;
        let Some(value) = self.value_of(entry, bytes) else { return false };
        self.is_assumed &= entry != (0x1000, 0);
        let object = self.device.object(index);
        let is_known = object.and_then(|object| object.value(sub)).is_some_and(|known| {
            let reader = ValueReader { index, node_id: Some(self.node_id) };
            *known == value || reader.resolve(&known, self.data_type(entry)) == value
        });
        if !is_known {
            self.changed.extend(Stale::of(entry));
            if object.is_some_and(|object| object.has(sub)) {
                self.written.insert(entry);
            }
            self.device.to_mut().assign(&[Assignment { index, sub, value }]);
            let is_stated = self.start.object(index).is_some_and(|object| object.value(sub).is_some());
            if !is_stated && self.learnt.len() < MAX_LEARNT {
                self.learnt.insert((index, sub));
            }
        }
        !is_known
    }

    /// Whether no value was written or stored since the start.
    fn is_as_described(&self) -> bool {
        matches!(self.start, Cow::Borrowed(_)) && self.written.is_empty() && self.learnt.is_empty()
    }

    /// Keeps the present values over a reset (1010h).
    pub(super) fn store(&mut self) {
        if !self.is_as_described() {
            self.start = Cow::Owned(self.device.clone().into_owned());
            self.written.clear();
            self.changed.clear();
        }
    }

    /// Discards stored values and those of the configuration: after the next reset the values are the
    /// defaults (1011h).
    pub(super) fn restore(&mut self) {
        if self.is_described {
            self.start = Cow::Owned(self.described.unconfigured().into_owned());
            self.changed.insert(Stale::All);
        }
    }

    /// Restores the values after a reset; returns the resulting changes, if there are any.
    pub(super) fn reset(&mut self) -> Option<BTreeSet<Stale>> {
        if !self.is_described || self.is_as_described() {
            return None;
        }
        let mut kept = std::mem::take(&mut self.learnt);
        // a reset does not change the device type
        kept.insert((0x1000, 0));
        let (written, changed) = (std::mem::take(&mut self.written), std::mem::take(&mut self.changed));
        if changed.contains(&Stale::All) {
            let running = std::mem::replace(&mut self.device, self.start.clone());
            self.take_seen(&running, &kept);
        } else {
            // most nodes are written again as before, to the same copies of their objects
            written.difference(&kept).for_each(|entry| self.revert(*entry));
            self.written = written.intersection(&kept).copied().collect();
            let has =
                |device: &Device, index, sub| device.object(index).is_some_and(|object| object.has(sub));
            let is_added =
                |&(index, sub): &(u16, u8)| has(&self.device, index, sub) && !has(&self.start, index, sub);
            self.learnt = kept.into_iter().filter(is_added).collect();
            self.learn((0x1000, 0));
        }
        Some(changed)
    }

    /// Gives an entry the value after a reset.
    fn revert(&mut self, (index, sub): (u16, u8)) {
        let (start, device) = (self.start.object(index), self.device.to_mut().objects.get_mut(&index));
        let Some((start, object)) = start.zip(device) else { return };
        if let Some((start, entry)) = start.subs.get(sub).zip(object.subs.get_mut(sub)) {
            return entry.configured.clone_from(&start.configured);
        }
        object.main.configured.clone_from(&start.main.configured);
        if let Some((start, compact)) = start.compact.as_ref().zip(object.compact.as_mut()) {
            compact.values.clone_from(&start.values);
        }
    }

    /// Takes over the observations of a node from before its description was known.
    fn take_over(&mut self, former: &Self) {
        if !former.is_described {
            let is_seen = |entry: &&(u16, u8)| !former.is_assumed || **entry != (0x1000, 0);
            self.take_seen(&former.device, &former.learnt.iter().filter(is_seen).copied().collect());
        }
    }

    /// Copies the values of entries from a device.
    fn take_seen(&mut self, from: &Device, entries: &BTreeSet<(u16, u8)>) {
        for &(index, sub) in entries {
            self.learn((index, sub));
            let value = |device: &Device| device.entry(index, sub).and_then(|entry| entry.value().cloned());
            if let Some(value) = value(from).filter(|seen| value(&self.device).as_ref() != Some(seen)) {
                self.written.insert((index, sub));
                self.device.to_mut().assign(&[Assignment { index, sub, value }]);
            }
        }
    }
}
