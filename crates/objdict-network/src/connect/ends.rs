//! Resolves the ends of links: nodes, and their entries that a PDO can carry.

use std::collections::HashMap;

use objdict_node::download::transferred_type;
use objdict_node::{ObjectName, resolve};

use crate::diagnostic::{At, Diagnostic, RuleInfo, Text, listing, misspelled, nearest, say};
use crate::model::{Address, DataType, Device, Field, MappedObject, Object, PdoKind, Place};
use crate::names::unknown_node;
use crate::origin::{because, refusing_field};
use crate::rules::{LINK_DIRECTION, LINK_MISMATCH, LINK_TOO_LONG, LINK_TYPE, UNKNOWN_ENTRY, UNKNOWN_NODE};
use crate::{Link, LinkEnd, LinkedEntries, Network, Node};

/// An entry in a PDO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Carried {
    pub(super) index: u16,
    pub(super) sub: u8,
    pub(super) data_type: DataType,
    pub(super) bits: u8,
}

impl Carried {
    pub(super) const fn mapped(self) -> MappedObject {
        MappedObject { index: self.index, sub: self.sub, bits: self.bits }
    }

    pub(super) const fn address(self) -> Address {
        Address { index: self.index, sub: Some(self.sub) }
    }

    /// As in messages: `6000:1`.
    pub(super) fn name(self) -> String {
        name(self.address())
    }

    /// Whether a value keeps its meaning in an entry of this type.
    fn means_the_same(self, other: Self) -> bool {
        let is_signed = |data_type: DataType| data_type.integer_range().map(|(low, _)| low < 0);
        self.data_type == other.data_type
            || is_signed(self.data_type).is_some_and(|signed| is_signed(other.data_type) == Some(signed))
    }
}

/// The entries at a link end, or the finding about it.
type Found<T> = Result<T, Box<Diagnostic>>;

/// A node with some of its entries.
pub(super) type NodeEntries = (usize, Vec<Carried>);

/// The data flow of a link.
pub(super) struct Flow {
    /// The producer, or the consumer of data from a manager without a description.
    pub(super) lead: NodeEntries,
    /// The direction of the lead's PDO.
    pub(super) kind: PdoKind,
    /// The consumers with a description, each with as many entries as the lead.
    pub(super) consumers: Vec<NodeEntries>,
    /// Whether a manager without a description is the counterpart.
    pub(super) has_manager: bool,
}

/// The nodes by name.
pub(super) struct NodeNames<'a> {
    network: &'a Network,
    positions: HashMap<&'a str, usize>,
}

impl<'a> NodeNames<'a> {
    pub(super) fn new(network: &'a Network) -> Self {
        let positions = network.nodes.iter().enumerate().rev().map(|(at, node)| (&*node.name.value, at));
        Self { network, positions: positions.collect() }
    }

    /// The flows of a link; unsuitable consumers are findings.
    pub(super) fn flows(&self, link: &Link, mut report: impl FnMut(Diagnostic)) -> Found<Vec<Flow>> {
        if self.is_undescribed_manager(&link.from) {
            return self.sent_by_manager(link, report);
        }
        let from = self.end(&link.from, PdoKind::Tpdo)?;
        let mut consumers = Vec::with_capacity(link.to.len());
        let mut has_manager = false;
        for end in &link.to {
            if self.is_undescribed_manager(end) {
                has_manager = true;
                continue;
            }
            let to = match self.end(end, PdoKind::Rpdo) {
                Ok(to) => to,
                Err(finding) => {
                    report(*finding);
                    continue;
                }
            };
            match self.compare(link, end, &from, &to) {
                Err(finding) if finding.rule.id != LINK_TYPE.id => report(*finding),
                result => {
                    result.err().into_iter().for_each(|finding| report(*finding));
                    consumers.push(to);
                }
            }
        }
        let is_received = has_manager || !consumers.is_empty();
        let flow = Flow { lead: from, kind: PdoKind::Tpdo, consumers, has_manager };
        Ok(if is_received { vec![flow] } else { Vec::new() })
    }

    /// A manager without a description sends a separate PDO to each consumer.
    fn sent_by_manager(&self, link: &Link, mut report: impl FnMut(Diagnostic)) -> Found<Vec<Flow>> {
        if link.parameters.can_id.is_some() && link.to.len() > 1 {
            let message = say!("`{}` sends a PDO to each of {} consumers", link.from.node, link.to.len());
            let help = "omit the CAN-ID, or write a link for each consumer";
            return Err(wrong(&LINK_TOO_LONG, &link.from, message, help));
        }
        let mut flows = Vec::with_capacity(link.to.len());
        for end in &link.to {
            let found = match self.is_undescribed_manager(end) {
                true => Err(self.to_itself(link, end)),
                false => self.end(end, PdoKind::Rpdo),
            };
            match found {
                Ok(lead) => {
                    let consumers = Vec::new();
                    flows.push(Flow { lead, kind: PdoKind::Rpdo, consumers, has_manager: true });
                }
                Err(finding) => report(*finding),
            }
        }
        Ok(flows)
    }

    /// Whether an end is a manager without a description, which is the counterpart of every PDO.
    fn is_undescribed_manager(&self, end: &LinkEnd) -> bool {
        end.entries.is_none() && !self.positions.contains_key(&*end.node) && self.is_manager(&end.node)
    }

    fn is_manager(&self, name: &str) -> bool {
        self.network.manager.as_ref().is_some_and(|manager| manager.name.value == name)
    }

    fn end(&self, end: &LinkEnd, kind: PdoKind) -> Found<NodeEntries> {
        let position = *self.positions.get(&*end.node).ok_or_else(|| self.unknown_node(end))?;
        let node = &self.network.nodes[position];
        let Some(entries) = &end.entries else {
            let message = say!("the link has no entries of `{}`", end.node);
            let help = say!("add them after a dot, as in `{}.6000:1-5`", end.node);
            return Err(wrong(&UNKNOWN_ENTRY, end, message, help));
        };
        Ok((position, NamedPart { position, node, end, entries, kind }.entries()?))
    }

    fn unknown_node(&self, end: &LinkEnd) -> Box<Diagnostic> {
        if self.is_manager(&end.node) {
            let message = say!("the manager `{}` has no description and so no entries", end.node);
            let help = say!("write only `{}`: it has the other side of each PDO", end.node);
            return wrong(&UNKNOWN_NODE, end, message, help);
        }
        let message = say!("unknown node `{}`", end.node);
        let manager = self.network.manager.as_ref().map(|manager| &manager.name);
        let names = self.positions.keys().copied().chain(manager.map(|name| &*name.value));
        let finding = unknown_node(end.at, &end.node, message, names);
        // a manager without a description may have any name
        let meant = manager.filter(|name| misspelled(&end.node, [&*name.value]).is_some());
        Box::new(finding.label_each(meant.map(|name| At::Span(name.at)), "the name of the manager"))
    }

    fn to_itself(&self, link: &Link, end: &LinkEnd) -> Box<Diagnostic> {
        let message = say!("`{}` is linked to itself", end.node);
        let help = "link it to a different node; a node does not receive its own PDOs";
        Box::new(wrong(&LINK_DIRECTION, end, message, help).label(link.from.at, "the producer"))
    }

    /// Compares the two ends of a link, entry by entry.
    fn compare(&self, link: &Link, end: &LinkEnd, from: &NodeEntries, to: &NodeEntries) -> Found<()> {
        let related = |rule, message, help: &'static str| {
            wrong(rule, end, message, help).label(link.from.at, "the producer")
        };
        if from.0 == to.0 {
            return Err(self.to_itself(link, end));
        }
        if from.1.len() != to.1.len() {
            let message = say!("{} entries are linked to {}", from.1.len(), to.1.len());
            let help = "name as many entries of the consumer as of the producer";
            return Err(Box::new(related(&LINK_MISMATCH, message, help)));
        }
        let pairs = || from.1.iter().zip(&to.1);
        let other_length = pairs().find(|(from, to)| from.bits != to.bits);
        let Some((sent, taken)) =
            other_length.or_else(|| pairs().find(|(from, to)| !from.means_the_same(**to)))
        else {
            return Ok(());
        };
        let finding = if other_length.is_some() {
            let message =
                say!("`{}` has {} bits, but `{}` has {}", sent.name(), sent.bits, taken.name(), taken.bits);
            let help = "link entries of the same length; bits of a PDO are received by position";
            related(&LINK_MISMATCH, message, help)
        } else {
            let message =
                say!("`{}` is {}, `{}` is {}", sent.name(), sent.data_type, taken.name(), taken.data_type);
            let help = "link entries of the same type, or convert the value in the consumer";
            related(&LINK_TYPE, message, help)
        };
        let data_type = |position: usize, entry: &Carried| {
            let place = self.network.nodes[position].device.entry_place(entry.index, entry.sub);
            At::Node(position, place.field(Field::DataType))
        };
        let finding = finding.label(data_type(to.0, taken), say!("the data type of `{}`", taken.name()));
        Err(Box::new(finding.label(data_type(from.0, sent), say!("the data type of `{}`", sent.name()))))
    }
}

fn wrong(
    rule: &'static RuleInfo,
    end: &LinkEnd,
    message: impl Into<Text>,
    help: impl Into<Text>,
) -> Box<Diagnostic> {
    Box::new(Diagnostic::new(rule, end.at, message).help(help))
}

/// The entries at an end of a link.
struct NamedPart<'a> {
    position: usize,
    node: &'a Node,
    end: &'a LinkEnd,
    entries: &'a LinkedEntries,
    kind: PdoKind,
}

impl NamedPart<'_> {
    /// The entries, in the order of their sub-indexes.
    fn entries(&self) -> Found<Vec<Carried>> {
        let at = self.address()?;
        let object = self.node.device.object(at.index).ok_or_else(|| self.unknown_entry())?;
        let entry = |sub| self.carried(at.index, sub);
        match (at.sub, &self.entries.subs) {
            (Some(_), Some(_)) => Err(self.unknown_entry()),
            (Some(sub), None) => Ok(vec![entry(sub)?]),
            (None, Some(subs)) => subs.clone().map(entry).collect(),
            (None, None) if !object.object_type().has_subs() => Ok(vec![entry(0)?]),
            (None, None) => all(&self.node.device, at.index, object, self.kind)
                .ok_or_else(|| self.because(self.direction(at), Place::object(at.index))),
        }
    }

    fn address(&self) -> Found<Address> {
        let text = match &self.entries.object {
            ObjectName::Address(at) => return Ok(*at),
            ObjectName::Text(text) => text,
        };
        match *resolve(&self.node.device, text) {
            [at] => Ok(at),
            [] => Err(self.unknown_entry()),
            ref several => {
                let names = several.iter().take(5).map(|at| ObjectName::Address(*at).to_string());
                let message = say!("`{}` names several entries of `{}`", text, self.node.name.value);
                let help = say!("write the index of one: {}", listing(names));
                let place = |at: &Address| match at.sub {
                    Some(sub) => self.node.device.entry_place(at.index, sub),
                    None => Place::object(at.index),
                };
                let places = several.iter().take(5).map(|at| place(at).field(Field::ParameterName));
                let places = places.map(|place| At::Node(self.position, place));
                let finding = wrong(&UNKNOWN_ENTRY, self.end, message, help);
                Err(Box::new(finding.label_each(places, "the name")))
            }
        }
    }

    fn carried(&self, index: u16, sub: u8) -> Found<Carried> {
        let at = Address { index, sub: Some(sub) };
        let device = &self.node.device;
        let place = |field| device.entry_place(index, sub).field(field);
        let Some(entry) = device.entry(index, sub) else {
            let message = say!("`{}` has no entry `{}`", self.node.name.value, name(at));
            let finding = wrong(&UNKNOWN_ENTRY, self.end, message, list_subs(device, index));
            return Err(self.because(finding, Place::object(index)));
        };
        let refusing = || place(refusing_field(&entry, self.kind));
        if !entry.is_mappable() {
            let message = say!("no PDO of `{}` can carry `{}`", self.node.name.value, name(at));
            let help = "link an entry with `PDOMapping=1`; the manager can write others by SDO";
            let finding = wrong(&LINK_DIRECTION, self.end, message, help);
            return Err(self.because(finding, refusing()));
        }
        if !entry.fits_pdo(self.kind) {
            return Err(self.because(self.direction(at), refusing()));
        }
        typed(device, index, sub).ok_or_else(|| {
            let message = say!("`{}` of `{}` has no fixed length", name(at), self.node.name.value);
            let help = "link entries whose data type has a fixed length";
            let finding = wrong(&LINK_DIRECTION, self.end, message, help);
            self.because(finding, place(Field::DataType))
        })
    }

    fn direction(&self, at: Address) -> Box<Diagnostic> {
        let (node, name) = (&self.node.name.value, name(at));
        let message = match self.kind {
            PdoKind::Tpdo => say!("`{}` cannot send `{}`", node, name),
            PdoKind::Rpdo => say!("`{}` cannot receive `{}`", node, name),
        };
        wrong(&LINK_DIRECTION, self.end, message, "swap `from` and `to`, or link a different entry")
    }

    fn unknown_entry(&self) -> Box<Diagnostic> {
        let message = say!("`{}` has no entry `{}`", self.node.name.value, self.entries.to_string());
        let near = match &self.entries.object {
            ObjectName::Text(text) => nearest(text, self.node.device.objects.values().map(Object::name)),
            ObjectName::Address(_) => None,
        };
        let help = match near {
            Some(name) => say!("did you mean `{}`?", name),
            None => say!("`objdict show {}` lists the entries", self.node.file.value),
        };
        wrong(&UNKNOWN_ENTRY, self.end, message, help)
    }

    fn because(&self, finding: Box<Diagnostic>, place: Place) -> Box<Diagnostic> {
        Box::new(because(*finding, self.position, place))
    }
}

/// An entry or object as in messages: `6000:1`.
fn name(at: Address) -> String {
    ObjectName::Address(at).to_string()
}

/// Each entry of an object that a PDO can carry; `None` without any.
fn all(device: &Device, index: u16, object: &Object, kind: PdoKind) -> Option<Vec<Carried>> {
    let subs = object
        .entries()
        .filter(|(sub, entry)| (1..=0xFE).contains(sub) && entry.is_mappable() && entry.fits_pdo(kind));
    let carried: Option<Vec<_>> = subs.map(|(sub, _)| typed(device, index, sub)).collect();
    carried.filter(|carried| !carried.is_empty())
}

/// The entry with its type; `None` if a PDO cannot carry values of this type.
fn typed(device: &Device, index: u16, sub: u8) -> Option<Carried> {
    let data_type = transferred_type(device, index, sub)?;
    Some(Carried { index, sub, data_type, bits: data_type.bit_length()? })
}

fn list_subs(device: &Device, index: u16) -> String {
    match device.object(index).and_then(Object::highest_sub) {
        Some(highest) => format!("{index:04X}h has sub-indexes up to {highest:X}h"),
        None => format!("the description has no object {index:04X}h"),
    }
}
