//! Links as streams: entries of a producer that are sent in the same way to the same nodes.

use std::collections::HashMap;

use super::ends::{Carried, End, Names};
use crate::diagnostic::{Diagnostic, Findings, Severity, Text, say};
use crate::rules::TWO_PRODUCERS;
use crate::source::Span;
use crate::{Link, LinkParameters, Network};

/// Entries that share PDOs, in the order of the links.
#[derive(Clone, Debug)]
pub(super) struct Stream {
    /// The position of its first link.
    pub(super) link: usize,
    /// The place of its first link.
    pub(super) at: Span,
    /// The producer.
    pub(super) producer: usize,
    /// The nodes that receive all of it. Others may receive parts.
    pub(super) partners: Vec<usize>,
    pub(super) parameters: LinkParameters,
    pub(super) signals: Vec<Signal>,
}

/// An entry of the producer with all that receive it.
#[derive(Clone, Debug)]
pub(super) struct Signal {
    pub(super) entry: Carried,
    pub(super) receivers: Vec<Receiver>,
}

impl Signal {
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
    /// The time in milliseconds after which it misses the PDO.
    pub(super) deadline: Option<u16>,
}

/// The streams of all links, in the order of the first link of each. A link at the end changes no stream but by adding
/// receivers to it, unless it has the same nodes and parameters.
pub(super) fn collect(network: &Network, findings: &mut Findings) -> Vec<Stream> {
    let names = Names::new(network);
    let mut collection = Collection::default();
    for (position, link) in network.links.iter().enumerate() {
        match names.ends(link, |finding| findings.push(finding)) {
            Ok((from, consumers)) if !consumers.is_empty() => {
                for to in &consumers {
                    if let Some(finding) = collection.written_twice(network, link, &from, to) {
                        findings.push(finding);
                    }
                }
                collection.add((position, link), &from, &consumers);
            }
            Ok(_) => {}
            Err(finding) => findings.push(*finding),
        }
    }
    collection.streams
}

#[derive(Default)]
struct Collection {
    streams: Vec<Stream>,
    /// Streams by producer, partners and parameters.
    alike: HashMap<(usize, Vec<usize>, LinkParameters), usize>,
    /// Where an entry of a producer is: stream and signal.
    sent: HashMap<(usize, u16, u8), Vec<(usize, usize)>>,
    /// What an entry of a consumer receives: the producer, its entry, and the place of the link.
    written: HashMap<(usize, u16, u8), (usize, Carried, Span)>,
}

impl Collection {
    fn add(&mut self, (number, link): (usize, &Link), (producer, entries): &End, consumers: &[End]) {
        for (position, entry) in entries.iter().enumerate() {
            let receiver = |(node, entries): &End| Receiver {
                node: *node,
                entry: entries[position],
                link: number,
                at: link.at,
                deadline: link.deadline.map(|said| said.value),
            };
            let receivers = &mut self.signal((number, link), *producer, *entry, consumers).receivers;
            for receiver in consumers.iter().map(receiver) {
                // a link that is there twice needs no second place
                if receivers.iter().all(|other| (other.node, other.entry) != (receiver.node, receiver.entry))
                {
                    receivers.push(receiver);
                }
            }
        }
    }

    /// Entries of a consumer that another link writes already.
    fn written_twice(
        &mut self,
        network: &Network,
        link: &Link,
        (producer, entries): &End,
        (consumer, targets): &End,
    ) -> Option<Diagnostic> {
        let name = |node: usize| &network.nodes[node].name.value;
        let end = link.to.iter().find(|end| end.node == *name(*consumer));
        let at = end.map_or(link.at, |end| end.at);
        let mut twice = Vec::new();
        for (entry, target) in entries.iter().zip(targets) {
            let new = (*producer, *entry, at);
            let first = *self.written.entry((*consumer, target.index, target.sub)).or_insert(new);
            if first != new {
                twice.push((*target, *entry, first));
            }
        }
        twice.sort_by_key(|(_, entry, first)| (first.0, first.1) == (*producer, *entry));
        let (target, entry, (other, sent, place)) = twice.first()?;
        let what: Text = match twice.len() {
            1 => say!("`{}` of `{}`", target.name(), name(*consumer)),
            count => say!("`{}` of `{}` and {} more entries", target.name(), name(*consumer), count - 1),
        };
        let finding = |message| Diagnostic::new(&TWO_PRODUCERS, at, message).label(*place, "the other link");
        Some(match (*other, *sent) == (*producer, *entry) {
            true => {
                let finding = finding(say!("{} is linked twice to `{}`", what, name(*producer)));
                finding.severity(Severity::Warning).help("remove one of the links")
            }
            false => {
                let first = say!("`{}` of `{}`", sent.name(), name(*other));
                let second = say!("`{}` of `{}`", entry.name(), name(*producer));
                finding(say!("two links write {}: from {} and {}", what, first, second))
                    .help("link each producer to an entry of its own")
            }
        })
    }

    /// The signal of an entry: one that is sent as the link says, else a new one.
    fn signal(
        &mut self,
        (number, link): (usize, &Link),
        producer: usize,
        entry: Carried,
        consumers: &[End],
    ) -> &mut Signal {
        let streams = &mut self.streams;
        let sent = self.sent.entry((producer, entry.index, entry.sub)).or_default();
        let present = sent.iter().find(|(stream, _)| streams[*stream].parameters.satisfy(&link.parameters));
        let (stream, signal) = match present {
            Some(found) => *found,
            None => {
                let mut partners: Vec<usize> = consumers.iter().map(|(node, _)| *node).collect();
                partners.sort_unstable();
                partners.dedup();
                let key = (producer, partners, link.parameters);
                let stream = *self.alike.entry(key).or_insert_with_key(|(_, partners, parameters)| {
                    let partners = partners.clone();
                    let signals = Vec::new();
                    streams.push(Stream {
                        link: number,
                        at: link.at,
                        producer,
                        partners,
                        parameters: *parameters,
                        signals,
                    });
                    streams.len() - 1
                });
                let signals = &mut streams[stream].signals;
                signals.push(Signal { entry, receivers: Vec::new() });
                let found = (stream, signals.len() - 1);
                sent.push(found);
                found
            }
        };
        &mut streams[stream].signals[signal]
    }
}
