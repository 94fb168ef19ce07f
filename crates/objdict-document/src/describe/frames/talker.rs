//! The nodes of a bus and their entries in words.

use std::borrow::Cow;

use super::sdo::Transfers;
use crate::dbc::{Scaled, scaling_of};
use crate::describe::{Decoder, ValueReader};
use crate::model::{Assignment, DataType, Device, Entry, Meanings, Object, Value};
use crate::profile;

/// The most entries that are added to a node without a description.
const MAX_LEARNT: usize = 4096;

/// A node whose frames are read. Its device has the values with which the node runs.
#[derive(Clone, Copy, Debug)]
pub struct Talker<'a> {
    /// The name.
    pub name: &'a str,
    /// The node-ID, 1 to 127.
    pub node_id: u8,
    /// The device.
    pub device: &'a Device,
}

/// A node with the values that the frames have shown.
#[derive(Debug)]
pub(super) struct TalkingNode<'a> {
    pub(super) name: Cow<'a, str>,
    pub(super) node_id: u8,
    pub(super) is_described: bool,
    /// The description, and the meanings of all values.
    described: Cow<'a, Device>,
    /// The values after a reset.
    start: Cow<'a, Device>,
    pub(super) device: Cow<'a, Device>,
    learnt: usize,
}

impl<'a> TalkingNode<'a> {
    fn of_talker(Talker { name, node_id, device }: Talker<'a>) -> Self {
        Self {
            name: Cow::Borrowed(name),
            node_id,
            is_described: true,
            described: Cow::Borrowed(device),
            start: Cow::Borrowed(device),
            device: Cow::Borrowed(device),
            learnt: 0,
        }
    }
}

/// The nodes of a bus.
#[derive(Debug)]
pub(super) struct Nodes<'a> {
    all: Vec<TalkingNode<'a>>,
    /// Positions of node-IDs.
    by_id: [Option<u8>; 128],
}

impl<'a> Nodes<'a> {
    pub(super) fn new(talkers: Vec<Talker<'a>>) -> Self {
        let mut nodes = Self { all: Vec::new(), by_id: [None; 128] };
        talkers.into_iter().for_each(|talker| nodes.add(TalkingNode::of_talker(talker)));
        nodes
    }

    /// The first of two nodes with one node-ID counts.
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
            let name = Cow::Owned(format!("node {node_id}"));
            let [described, start, device] = std::array::from_fn(|_| Cow::Owned(Device::default()));
            self.add(TalkingNode { name, node_id, is_described: false, described, start, device, learnt: 0 });
        }
    }

    /// Describes a node, which so far may be one without a description.
    pub(super) fn describe(&mut self, talker: Talker<'a>) {
        let node = TalkingNode::of_talker(talker);
        match self.by_id.get(usize::from(node.node_id)).copied().flatten() {
            Some(at) => self.all[usize::from(at)] = node,
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

    /// What is known of the value of an entry that a transfer has.
    pub(super) fn transferred<'t>(
        &self,
        transfers: &'t Transfers,
        channel: (u8, u16),
        entry: (u16, u8),
    ) -> &'t [u8] {
        let length = || self.get(channel.0)?.data_type(entry)?.byte_length();
        transfers.value(channel, length())
    }

    /// `1017:00 Producer heartbeat time`.
    pub(super) fn entry(&self, node_id: u8, (index, sub): (u16, u8)) -> String {
        let entry = self.get(node_id).and_then(|node| Some(node.device.entry(index, sub)?.name.clone()));
        match entry.filter(|name| !name.is_empty()) {
            Some(name) => format!("{index:04X}:{sub:02X} {name}"),
            None => format!("{index:04X}:{sub:02X}"),
        }
    }

    /// The same with a value.
    pub(super) fn value(&self, node_id: u8, entry: (u16, u8), bytes: &[u8]) -> String {
        let value = self.get(node_id).and_then(|node| Some((node, node.value_of(entry, bytes)?)));
        match value {
            Some((node, value)) => node.described(entry, &value),
            None => format!("{} = {}", self.entry(node_id, entry), digits(bytes)),
        }
    }
}

/// `01 0A`.
pub(super) fn digits(bytes: &[u8]) -> String {
    let digits: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
    digits.join(" ")
}

impl TalkingNode<'_> {
    /// The type of an entry.
    pub(super) fn data_type(&self, (index, sub): (u16, u8)) -> Option<DataType> {
        let object = self.device.object(index)?;
        let entry = object.entry(sub)?;
        let of_count = || DataType::of_sub_0(index).filter(|_| sub == 0 && object.object_type().has_subs());
        entry.implied_type().or_else(of_count)
    }

    /// The value that bytes of an SDO are.
    pub(super) fn value_of(&self, entry: (u16, u8), bytes: &[u8]) -> Option<Value> {
        Value::from_bytes(bytes, self.data_type(entry)?)
    }

    /// An entry with a value: `6041:00 Statusword = 1591 (state: operation enabled)`.
    pub(super) fn described(&self, (index, sub): (u16, u8), value: &Value) -> String {
        let entry = self.device.entry(index, sub);
        let name = entry.as_ref().map_or("", |entry| &entry.name);
        let named = if name.is_empty() { String::new() } else { format!(" {name}") };
        format!("{index:04X}:{sub:02X}{named} = {}", self.words((index, sub), value))
    }

    /// A value with its meaning or its unit: `1591 (state: operation enabled)`, `1200 (120 mm)`.
    fn words(&self, (index, sub): (u16, u8), value: &Value) -> String {
        let scaling = || scaling_of(&self.described, &self.meanings(), (index, sub));
        self.words_in((index, sub), value, scaling)
    }

    /// The same with a scale and a unit that are known.
    pub(super) fn words_in(
        &self,
        (index, sub): (u16, u8),
        value: &Value,
        scaling: impl FnOnce() -> Option<Scaled>,
    ) -> String {
        let node_id = Some(self.node_id);
        let short = ValueReader { index, node_id }.short(Some(value), self.data_type((index, sub)));
        let decoder = Decoder { is_complete: self.is_described, ..Decoder::english(&self.device, node_id) };
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

    /// The name of a value where it is a state, a mode, a command or another of few that have names.
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
        // fields are those of the bits, of negative numbers too
        let bits = (number & i128::from(u64::MAX)) as u64;
        let fields = profile::of_object(&self.device, index).filter(|(profile, _)| profile.group != "cia301");
        let mut fields = fields.filter_map(|(_, facts)| facts.entry(sub)).flat_map(|facts| facts.bits());
        let field = fields.find(|field| field.meanings().len() > 1)?;
        field.meaning(bits).map(str::to_owned)
    }

    /// The command that a word of the state machine of the device profile gives: `shutdown`.
    fn command(&self, index: u16, value: &Value) -> Option<&'static str> {
        // the state machines of documents take their commands from the profile area
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

    /// Adds an entry that no description has, as the documents define it, so that it has a name and a type.
    pub(super) fn learn(&mut self, (index, sub): (u16, u8)) {
        if self.is_described || self.learnt >= MAX_LEARNT || self.device.entry(index, sub).is_some() {
            return;
        }
        let facts = profile::of_object(&self.device, index)
            .find_map(|(_, facts)| Some((facts.name, facts.object_type(), facts.entry(sub)?)));
        let Some((name, object_type, facts)) = facts else { return };
        self.learnt += 1;
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

    /// Takes a value that the node has now; whether it is new.
    pub(super) fn take(&mut self, entry: (u16, u8), bytes: &[u8]) -> bool {
        let (index, sub) = entry;
        let Some(value) = self.value_of(entry, bytes) else { return false };
        let is_known = self.device.object(index).and_then(|object| object.value(sub)).is_some_and(|known| {
            let data_type = self.data_type(entry);
            let known = ValueReader { index, node_id: Some(self.node_id) }.resolve(&known, data_type);
            known == value
        });
        if !is_known {
            self.device.to_mut().assign(&[Assignment { index, sub, value }]);
        }
        !is_known
    }

    /// Keeps the present values over a reset (1010h).
    pub(super) fn store(&mut self) {
        if let Cow::Owned(device) = &self.device {
            self.start = Cow::Owned(device.clone());
        }
    }

    /// Forgets kept values and those of the configuration: after the next reset the values are the defaults (1011h).
    pub(super) fn restore(&mut self) {
        if self.is_described {
            self.start = Cow::Owned(self.described.unconfigured().into_owned());
            // so that a reset finds other values, also where none was written
            self.device.to_mut();
        }
    }

    /// Goes back to the values that it has after a reset; whether they are others.
    pub(super) fn reset(&mut self) -> bool {
        if !self.is_described || matches!(self.device, Cow::Borrowed(_)) {
            return false;
        }
        self.device = self.start.clone();
        true
    }
}
