//! What the ends of links name: nodes and the entries that a PDO of them can carry.

use std::collections::HashMap;

use objdict_node::download::transferred_type;
use objdict_node::{ObjectName, resolve};

use crate::diagnostic::{Diagnostic, RuleInfo, Text, listing, nearest, say};
use crate::model::{Address, DataType, Device, Object, PdoKind};
use crate::rules::{LINK_DIRECTION, LINK_MISMATCH, LINK_TYPE, UNKNOWN_ENTRY, UNKNOWN_NODE};
use crate::{Link, LinkEnd, Network, Node};

/// An entry in a PDO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Carried {
    pub(super) index: u16,
    pub(super) sub: u8,
    pub(super) data_type: DataType,
    pub(super) bits: u8,
}

impl Carried {
    pub(super) const fn address(self) -> Address {
        Address { index: self.index, sub: Some(self.sub) }
    }

    /// As in messages: `6000:1`.
    pub(super) fn name(self) -> String {
        ObjectName::Address(self.address()).to_string()
    }

    /// Whether a value keeps its meaning in an entry of this type.
    fn means_the_same(self, other: Self) -> bool {
        let is_signed = |data_type: DataType| data_type.integer_range().map(|(low, _)| low < 0);
        self.data_type == other.data_type
            || is_signed(self.data_type).is_some_and(|signed| is_signed(other.data_type) == Some(signed))
    }
}

/// What an end names, or the finding about it.
type Found<T> = Result<T, Box<Diagnostic>>;

/// A node with some of its entries.
pub(super) type End = (usize, Vec<Carried>);

/// The nodes by name.
pub(super) struct Names<'a> {
    network: &'a Network,
    positions: HashMap<&'a str, usize>,
}

impl<'a> Names<'a> {
    pub(super) fn new(network: &'a Network) -> Self {
        let positions = network.nodes.iter().enumerate().rev().map(|(at, node)| (&*node.name.value, at));
        Self { network, positions: positions.collect() }
    }

    /// The producer and the consumers of a link, each with as many entries; consumers that do not fit are findings.
    pub(super) fn ends(&self, link: &Link, mut report: impl FnMut(Diagnostic)) -> Found<(End, Vec<End>)> {
        let from = self.end(&link.from, PdoKind::Tpdo)?;
        let mut consumers = Vec::with_capacity(link.to.len());
        for end in &link.to {
            let to = match self.end(end, PdoKind::Rpdo) {
                Ok(to) => to,
                Err(finding) => {
                    report(*finding);
                    continue;
                }
            };
            match compare(link, end, &from, &to) {
                Err(finding) if finding.rule.id != LINK_TYPE.id => report(*finding),
                result => {
                    result.err().into_iter().for_each(|finding| report(*finding));
                    consumers.push(to);
                }
            }
        }
        Ok((from, consumers))
    }

    fn end(&self, end: &LinkEnd, kind: PdoKind) -> Found<End> {
        let position = *self.positions.get(&*end.node).ok_or_else(|| self.unknown_node(end))?;
        Ok((position, entries(&self.network.nodes[position], end, kind)?))
    }

    fn unknown_node(&self, end: &LinkEnd) -> Box<Diagnostic> {
        let manager = self.network.manager.as_ref().is_some_and(|manager| manager.name.value == end.node);
        let help = match nearest(&end.node, self.positions.keys().copied()) {
            _ if manager => {
                "give the manager a node with a description, which has the entries for the link".into()
            }
            Some(name) => say!("write `{}`, or describe the node", name),
            None => "describe the node, or write the name of one that is described".into(),
        };
        wrong(&UNKNOWN_NODE, end, say!("there is no node `{}`", end.node), help)
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

/// The entries at an end, in the order of their sub-indexes.
fn entries(node: &Node, end: &LinkEnd, kind: PdoKind) -> Found<Vec<Carried>> {
    let at = address(node, end)?;
    let unknown = || unknown_entry(node, end);
    let object = node.device.object(at.index).ok_or_else(unknown)?;
    let entry = |sub| carried(node, end, (at.index, sub), kind);
    match (at.sub, &end.entries.subs) {
        (Some(_), Some(_)) => Err(unknown()),
        (Some(sub), None) => Ok(vec![entry(sub)?]),
        (None, Some(subs)) => subs.clone().map(entry).collect(),
        (None, None) if !object.object_type().has_subs() => Ok(vec![entry(0)?]),
        (None, None) => all(&node.device, at.index, object, kind)
            .ok_or_else(|| direction(node, end, &ObjectName::Address(at).to_string(), kind)),
    }
}

fn address(node: &Node, end: &LinkEnd) -> Found<Address> {
    let text = match &end.entries.object {
        ObjectName::Address(at) => return Ok(*at),
        ObjectName::Text(text) => text,
    };
    match *resolve(&node.device, text) {
        [at] => Ok(at),
        [] => Err(unknown_entry(node, end)),
        ref several => {
            let names = several.iter().take(5).map(|at| ObjectName::Address(*at).to_string());
            let message = say!("`{}` names several entries of `{}`", text, node.name.value);
            let help = say!("write the index of one: {}", listing(names));
            Err(wrong(&UNKNOWN_ENTRY, end, message, help))
        }
    }
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

fn carried(node: &Node, end: &LinkEnd, (index, sub): (u16, u8), kind: PdoKind) -> Found<Carried> {
    let name = ObjectName::Address(Address { index, sub: Some(sub) }).to_string();
    let Some(entry) = node.device.entry(index, sub) else {
        let message = say!("`{}` has no entry `{}`", node.name.value, name);
        return Err(wrong(&UNKNOWN_ENTRY, end, message, list_subs(&node.device, index)));
    };
    if !entry.is_mappable() {
        let message = say!("no PDO of `{}` can carry `{}`", node.name.value, name);
        return Err(wrong(
            &LINK_DIRECTION,
            end,
            message,
            "link an entry with `PDOMapping=1`; the manager can write others by SDO",
        ));
    }
    if !entry.fits_pdo(kind) {
        return Err(direction(node, end, &name, kind));
    }
    typed(&node.device, index, sub).ok_or_else(|| {
        let message = say!("`{}` of `{}` has no fixed length", name, node.name.value);
        wrong(&LINK_DIRECTION, end, message, "link entries whose data type has a fixed length")
    })
}

fn direction(node: &Node, end: &LinkEnd, name: &str, kind: PdoKind) -> Box<Diagnostic> {
    let message = match kind {
        PdoKind::Tpdo => say!("`{}` cannot send `{}`", node.name.value, name),
        PdoKind::Rpdo => say!("`{}` cannot receive `{}`", node.name.value, name),
    };
    wrong(&LINK_DIRECTION, end, message, "exchange `from` and `to`, or link another entry")
}

fn unknown_entry(node: &Node, end: &LinkEnd) -> Box<Diagnostic> {
    let message = say!("`{}` has no entry `{}`", node.name.value, end.entries.to_string());
    let near = match &end.entries.object {
        ObjectName::Text(text) => nearest(text, node.device.objects.values().map(Object::name)),
        ObjectName::Address(_) => None,
    };
    let help = match near {
        Some(name) => say!("did you mean `{}`?", name),
        None => say!("`objdict show {}` lists the entries", node.file.value),
    };
    wrong(&UNKNOWN_ENTRY, end, message, help)
}

fn list_subs(device: &Device, index: u16) -> String {
    match device.object(index).and_then(Object::highest_sub) {
        Some(highest) => format!("{index:04X}h has sub-indexes up to {highest:X}h"),
        None => format!("the description has no object {index:04X}h"),
    }
}

/// Compares the two ends of a link, entry by entry.
fn compare(link: &Link, end: &LinkEnd, from: &End, to: &End) -> Found<()> {
    let related = |rule, message, help: &'static str| {
        let finding = *wrong(rule, end, message, help);
        Box::new(finding.label(link.from.at, "the producer"))
    };
    if from.0 == to.0 {
        let message = say!("`{}` is linked to itself", end.node);
        return Err(related(
            &LINK_DIRECTION,
            message,
            "link it to another node; a node does not receive its own PDOs",
        ));
    }
    if from.1.len() != to.1.len() {
        let message = say!("{} entries are linked to {}", from.1.len(), to.1.len());
        return Err(related(
            &LINK_MISMATCH,
            message,
            "name as many entries of the consumer as of the producer",
        ));
    }
    let pairs = || from.1.iter().zip(&to.1);
    if let Some((from, to)) = pairs().find(|(from, to)| from.bits != to.bits) {
        let message = say!("`{}` has {} bits, `{}` has {}", from.name(), from.bits, to.name(), to.bits);
        return Err(related(
            &LINK_MISMATCH,
            message,
            "link entries of the same length; bits of a PDO are received by position",
        ));
    }
    match pairs().find(|(from, to)| !from.means_the_same(**to)) {
        Some((from, to)) => {
            let message =
                say!("`{}` is {}, `{}` is {}", from.name(), from.data_type, to.name(), to.data_type);
            Err(related(
                &LINK_TYPE,
                message,
                "link entries of the same type, or convert the value in the consumer",
            ))
        }
        None => Ok(()),
    }
}
