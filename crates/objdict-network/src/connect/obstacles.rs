//! Explains why a node's PDOs are unsuitable for a link.

use super::pdos::{CandidatePdo, NodePdos, Obstacle};
use crate::Node;
use crate::compiled::indexes;
use crate::diagnostic::{At, Diagnostic, Severity, joined, say};
use crate::model::{Access, Part, PdoKind, Place};
use crate::rules::FIXED_PDO;
use crate::source::Span;

/// The maximum number of labelled PDOs in a finding.
const MAX_LABELS: usize = 4;

/// The maximum number of named PDOs with the same obstacle.
const MAX_NAMES: usize = 8;

/// A finding with the obstacle of each unused PDO of a direction. A PDO without a recorded obstacle has a constant
/// mapping.
pub(super) fn explained(
    mut finding: Diagnostic,
    (position, node): (usize, &Node),
    pdos: &NodePdos,
    kind: PdoKind,
    obstacles: &[(usize, Obstacle)],
) -> Diagnostic {
    let unused = pdos.pdos.iter().enumerate().filter(|(_, pdo)| pdo.name.kind == kind && !pdo.is_used);
    let mut groups: Vec<(Obstacle, String, Vec<String>)> = Vec::new();
    for (number, (at, pdo)) in unused.enumerate() {
        // if several frames were tried, the last one is the smallest
        let known = obstacles.iter().rev().find(|(other, _)| *other == at);
        let obstacle = known.map_or(pdo.other_mapping(), |(_, obstacle)| *obstacle);
        let (communication, mapping) = indexes(pdo.name);
        let words = obstacle.words(node, communication);
        if number < MAX_LABELS {
            let place = obstacle.place(node, communication, mapping);
            finding = finding.label(At::Node(position, place), words.clone());
        }
        let name = format!("{kind} {}", pdo.name.number);
        match groups.iter_mut().find(|(_, other, _)| *other == words) {
            Some((.., names)) => names.push(name),
            None => groups.push((obstacle, words, vec![name])),
        }
    }
    let advice = match groups.as_slice() {
        [(obstacle, ..)] => obstacle.advice(),
        _ => "link only entries that one of them can carry",
    };
    let reasons = groups.iter().map(|(_, words, names)| {
        let shown = names.get(..MAX_NAMES).unwrap_or(names).join(", ");
        let rest = if names.len() > MAX_NAMES { ", …" } else { "" };
        format!("{shown}{rest}: {words}")
    });
    finding.help(format!("{advice} ({})", reasons.collect::<Vec<_>>().join("; ")))
}

/// PDOs that no link uses and that cannot be disabled.
pub(super) fn stay_valid(pdos: &[&CandidatePdo], (position, node): (usize, &Node), at: Span) -> Diagnostic {
    let names = pdos.iter().take(MAX_NAMES).map(|pdo| format!("{} {}", pdo.name.kind, pdo.name.number));
    let rest = if pdos.len() > MAX_NAMES { ", …" } else { "" };
    let name = &node.name.value;
    let listed = joined(names, ", ");
    let message = say!("`{}` cannot switch off PDOs with a constant COB-ID: {}{}", name, listed, rest);
    let places = pdos.iter().take(MAX_LABELS).map(|pdo| node.device.value_place(indexes(pdo.name).0, 1));
    let finding = Diagnostic::new(&FIXED_PDO, at, message).severity(Severity::Warning);
    let finding = finding.label_each(places.map(|place| At::Node(position, place)), "constant");
    finding.help("link the entries that the PDO carries, or write `unused-pdos = \"keep\"` for this node")
}

impl Obstacle {
    /// Advice for changing the link.
    const fn advice(self) -> &'static str {
        match self {
            Self::Mapping | Self::Locked => "link the entries that the PDO carries by default",
            Self::Slots(..) => "link fewer entries",
            Self::Gap(_) => "let the consumer receive the entries of the gap too",
            Self::CanId(_) => "link it with this CAN-ID",
            Self::Parameter(_) => "remove the parameter from the link",
            Self::Invalid | Self::Taken => "transfer them by SDO instead",
        }
    }

    fn words(self, node: &Node, communication: u16) -> String {
        match self {
            Self::Mapping => "the mapping is constant".to_owned(),
            Self::Locked => "the COB-ID is constant, so the mapping cannot change".to_owned(),
            Self::Slots(slots, needed) => format!("room for {slots} of {needed} entries"),
            Self::Gap(bits) => format!("no dummy fills a gap of {bits} bits"),
            Self::Invalid => "not valid, and the COB-ID is constant".to_owned(),
            Self::CanId(can_id) => format!("the CAN-ID {can_id:X}h is constant"),
            Self::Parameter(sub) => {
                let name = match sub {
                    2 => "transmission type",
                    3 => "inhibit time",
                    _ => "event timer",
                };
                let is_writable = |access: Option<Access>| access.is_none_or(Access::is_writable);
                match node.device.entry(communication, sub) {
                    Some(entry) if is_writable(entry.access) => {
                        format!("the COB-ID is constant, so the {name} cannot change")
                    }
                    Some(_) => format!("the {name} is constant"),
                    None => format!("without {name}"),
                }
            }
            Self::Taken => "uses a different part of the frame".to_owned(),
        }
    }

    /// The place of the obstacle in the description.
    fn place(self, node: &Node, communication: u16, mapping: u16) -> Place {
        match self {
            Self::Gap(_) if node.device.dummy_usage.is_some() => Place::of(Part::DummyUsage),
            Self::Mapping | Self::Slots(..) | Self::Gap(_) | Self::Taken => Place::object(mapping),
            Self::Invalid | Self::Locked | Self::CanId(_) => node.device.value_place(communication, 1),
            Self::Parameter(sub) if node.device.entry(communication, sub).is_some() => {
                node.device.value_place(communication, sub)
            }
            Self::Parameter(_) => Place::object(communication),
        }
    }
}
