//! Groups of links: entries of a producer that are sent in the same way to the same nodes.

use std::collections::HashMap;

use super::ends::{Carried, Flow, NodeNames};
use crate::diagnostic::{Diagnostic, Findings, Severity, Text, say};
use crate::model::PdoKind;
use crate::rules::TWO_PRODUCERS;
use crate::source::Span;
use crate::{Link, LinkParameters, Network};

/// Entries that share PDOs, in the order of the links.
#[derive(Clone, Debug)]
pub(super) struct LinkGroup {
    /// The position of its first link.
    pub(super) link: usize,
    /// The place of its first link.
    pub(super) at: Span,
    /// The producer, or the consumer of data from a manager without a description.
    pub(super) lead: usize,
    /// The direction of the lead's PDOs.
    pub(super) kind: PdoKind,
    /// The nodes that receive all of it. Others may receive parts of it.
    pub(super) partners: Vec<usize>,
    pub(super) parameters: LinkParameters,
    pub(super) signals: Vec<LeadSignal>,
}

/// An entry of the lead with all described nodes that receive it.
#[derive(Clone, Debug)]
pub(super) struct LeadSignal {
    pub(super) entry: Carried,
    pub(super) receivers: Vec<Receiver>,
    /// The timeout in milliseconds of the receiver, if the lead and a manager without a description are the
    /// two ends.
    pub(super) deadline: Option<u16>,
}

impl LeadSignal {
    pub(super) fn has(&self, receiver: &Receiver) -> bool {
        self.receivers.contains(receiver)
    }
}

/// An entry of a consumer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Receiver {
    pub(super) node: usize,
    pub(super) entry: Carried,
    /// The position of the link.
    pub(super) link: usize,
    /// The place of the link.
    pub(super) at: Span,
    /// The timeout in milliseconds.
    pub(super) deadline: Option<u16>,
}

/// The groups of all links, in the order of the first link of each. An additional link at the end only adds
/// receivers to groups, unless it has the same nodes and parameters.
pub(super) fn collect(network: &Network, findings: &mut Findings) -> Vec<LinkGroup> {
    let names = NodeNames::new(network);
    let mut collection = Collection::default();
    for (position, link) in network.links.iter().enumerate() {
        match names.flows(link, |finding| findings.push(finding)) {
            Ok(flows) => {
                for flow in &flows {
                    let twice = collection.written_twice(network, link, flow);
                    twice.into_iter().for_each(|finding| findings.push(finding));
                    collection.add((position, link), flow);
                }
            }
            Err(finding) => findings.push(*finding),
        }
    }
    collection.groups
}

/// The node that configures the first PDO of a group, and the direction.
type Lead = (usize, PdoKind);

/// The source of a consumer's entry: the producer, its entry, and the place of the link.
type ValueSource = (Option<usize>, Carried, Span);

#[derive(Default)]
struct Collection {
    groups: Vec<LinkGroup>,
    /// Streams by lead, partners and parameters.
    alike: HashMap<(Lead, Vec<usize>, LinkParameters), usize>,
    /// The location of a lead's entry: group and signal.
    sent: HashMap<(Lead, u16, u8), Vec<(usize, usize)>>,
    /// The source of each consumer's entry; a manager without a description is not a node.
    written: HashMap<(usize, u16, u8), ValueSource>,
}

impl Collection {
    fn add(&mut self, (number, link): (usize, &Link), flow: &Flow) {
        let deadline = link.deadline.map(|said| said.value);
        for (position, entry) in flow.lead.1.iter().enumerate() {
            let receivers = flow.consumers.iter().map(|(node, entries)| Receiver {
                node: *node,
                entry: entries[position],
                link: number,
                at: link.at,
                deadline,
            });
            let signal = self.signal((number, link), *entry, flow);
            for receiver in receivers {
                let known = &mut signal.receivers;
                // a repeated link needs no second receiver
                if known.iter().all(|other| (other.node, other.entry) != (receiver.node, receiver.entry)) {
                    known.push(receiver);
                }
            }
            let own = deadline.filter(|time| flow.has_manager && *time > 0);
            signal.deadline = signal.deadline.into_iter().chain(own).min();
        }
    }

    /// Entries of consumers that a previous link already writes.
    fn written_twice(&mut self, network: &Network, link: &Link, flow: &Flow) -> Vec<Diagnostic> {
        let (lead, entries) = &flow.lead;
        // data from a manager without a description has only the consumer's entries
        let producer = (flow.kind == PdoKind::Tpdo).then_some(*lead);
        let of_lead = producer.is_none().then_some(&flow.lead);
        let name = |producer: Option<usize>| match producer {
            Some(node) => &network.nodes[node].name.value,
            None => network.manager.as_ref().map_or(&link.from.node, |manager| &manager.name.value),
        };
        let mut findings = Vec::new();
        for (consumer, targets) in flow.consumers.iter().chain(of_lead) {
            let end = link.to.iter().find(|end| end.node == *name(Some(*consumer)));
            let at = end.map_or(link.at, |end| end.at);
            let mut twice = Vec::new();
            for (entry, target) in entries.iter().zip(targets) {
                let new = (producer, *entry, at);
                let first = *self.written.entry((*consumer, target.index, target.sub)).or_insert(new);
                if first != new {
                    twice.push((*target, *entry, first));
                }
            }
            twice.sort_by_key(|(_, entry, first)| (first.0, first.1) == (producer, *entry));
            let Some((target, entry, (other, sent, place))) = twice.first() else { continue };
            let consumer = name(Some(*consumer));
            let (what, are): (Text, _) = match twice.len() {
                1 => (say!("`{}` of `{}`", target.name(), consumer), "is"),
                2 => (say!("`{}` of `{}` and 1 more entry", target.name(), consumer), "are"),
                count => {
                    (say!("`{}` of `{}` and {} more entries", target.name(), consumer, count - 1), "are")
                }
            };
            let finding =
                |message| Diagnostic::new(&TWO_PRODUCERS, at, message).label(*place, "the other link");
            findings.push(match (*other, *sent) == (producer, *entry) {
                true => {
                    let finding = finding(say!("{} {} linked twice to `{}`", what, are, name(producer)));
                    finding.severity(Severity::Warning).help("remove one of the links")
                }
                false => {
                    let source = |producer: Option<usize>, entry: &Carried| match producer {
                        Some(_) => say!("`{}` of `{}`", entry.name(), name(producer)),
                        None => say!("`{}`", name(producer)),
                    };
                    let (first, second) = (source(*other, sent), source(producer, entry));
                    finding(say!("two links write {}: from {} and {}", what, first, second))
                        .help("link each producer to its own entry")
                }
            });
        }
        findings
    }

    /// The signal of an entry: one that is already sent with these parameters, otherwise a new one.
    fn signal(&mut self, (number, link): (usize, &Link), entry: Carried, flow: &Flow) -> &mut LeadSignal {
        let groups = &mut self.groups;
        let lead = (flow.lead.0, flow.kind);
        let sent = self.sent.entry((lead, entry.index, entry.sub)).or_default();
        let present = sent.iter().find(|(group, _)| groups[*group].parameters.satisfy(&link.parameters));
        let (group, signal) = match present {
            Some(found) => *found,
            None => {
                let mut partners: Vec<usize> = flow.consumers.iter().map(|(node, _)| *node).collect();
                partners.sort_unstable();
                partners.dedup();
                let key = (lead, partners, link.parameters);
                let group = *self.alike.entry(key).or_insert_with_key(|(_, partners, parameters)| {
                    groups.push(LinkGroup {
                        link: number,
                        at: link.at,
                        lead: lead.0,
                        kind: lead.1,
                        partners: partners.clone(),
                        parameters: *parameters,
                        signals: Vec::new(),
                    });
                    groups.len() - 1
                });
                let signals = &mut groups[group].signals;
                signals.push(LeadSignal { entry, receivers: Vec::new(), deadline: None });
                let found = (group, signals.len() - 1);
                sent.push(found);
                found
            }
        };
        &mut groups[group].signals[signal]
    }
}
