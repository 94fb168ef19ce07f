//! Streams become PDOs of their producers and consumers.

use std::collections::BTreeMap;

use super::can_ids::{CanIds, User, plain, predefined};
use super::frame::{Frame, MAX_BITS, Share};
use super::pdos::{Mapping, NodePdos};
use super::streams::{Signal, Stream};
use crate::configure::PdoName;
use crate::diagnostic::{At, Diagnostic, Findings, say};
use crate::model::{CobId, PdoKind, Place};
use crate::rules::{FIXED_PDO, LINK_TOO_LONG, NO_FREE_CAN_ID, NO_FREE_PDO};
use crate::source::Span;
use crate::stream::{Compiled, indexes};
use crate::{CobIdWish, LinkParameters, Network, Node, PdoWish, Said};

/// The PDOs of all streams with their nodes, in the order of the streams.
pub(super) fn pack(
    network: &Network,
    compiled: &Compiled,
    streams: Vec<Stream>,
    findings: &mut Findings,
) -> Vec<(usize, PdoWish)> {
    let slave = |position| compiled.nodes().find(|slave| slave.node == position);
    let pdos = network.nodes.iter().enumerate().map(|(position, node)| NodePdos::of(node, slave(position)));
    let mut packer = Packer {
        nodes: &network.nodes,
        pdos: pdos.collect(),
        can_ids: CanIds::new(network, compiled),
        wishes: Vec::new(),
    };
    // in the order of the links, so that those at the end take nothing from others
    let mut order = 0..;
    let mut ordered = |stream: Stream| ((stream.link, order.next()), stream);
    let mut streams: BTreeMap<_, Stream> = streams.into_iter().map(&mut ordered).collect();
    while let Some((_, stream)) = streams.pop_first() {
        match packer.place(&stream) {
            Ok(alone) => streams.extend(alone.into_iter().map(&mut ordered)),
            Err(finding) => findings.push(*finding),
        }
    }
    packer.wishes
}

struct Packer<'a> {
    nodes: &'a [Node],
    pdos: Vec<NodePdos>,
    can_ids: CanIds,
    wishes: Vec<(usize, PdoWish)>,
}

/// A PDO of a consumer for a share of a frame.
struct Reception {
    node: usize,
    /// Its position among the PDOs of the node.
    pdo: usize,
    mapping: Mapping,
    deadline: Option<u16>,
    at: Span,
}

/// A frame with PDOs at both ends.
struct Transfer<'a> {
    frame: Frame<'a>,
    /// The position of the TPDO.
    pdo: usize,
    receivers: Receivers,
}

/// Who receives a frame.
#[derive(Default)]
struct Receivers {
    receptions: Vec<Reception>,
    /// What nodes that are no partners cannot take from this frame.
    left: Vec<Share>,
    /// The CAN-ID that the nodes leave no choice of.
    can_id: Option<u32>,
}

/// Why there is no transfer.
#[derive(Clone, Copy)]
struct Refusal {
    node: usize,
    kind: PdoKind,
}

impl Packer<'_> {
    /// Gives a stream as many PDOs as needed. What single consumers cannot take from them is returned as streams of their own.
    fn place(&mut self, stream: &Stream) -> Result<Vec<Stream>, Box<Diagnostic>> {
        let bits: u32 = stream.signals.iter().map(|signal| u32::from(signal.entry.bits)).sum();
        if stream.parameters.can_id.is_some() && bits > MAX_BITS {
            let message =
                say!("{} bits are linked with one CAN-ID, but a PDO has at most {}", bits, MAX_BITS);
            let help = "leave the CAN-ID out, or give links with other CAN-IDs a part of the entries";
            return Err(Box::new(Diagnostic::new(&LINK_TOO_LONG, stream.at, message).help(help)));
        }
        let mut alone = Vec::new();
        let mut rest: Vec<&Signal> = stream.signals.iter().collect();
        while !rest.is_empty() {
            let transfer = match self.transfer(stream, &rest) {
                Ok(transfer) => transfer,
                Err(refusal) => return Err(Box::new(self.refused(stream, rest[0], refusal))),
            };
            rest.retain(|signal| !transfer.frame.carries(signal));
            alone
                .extend(transfer.receivers.left.iter().map(|share| separate(stream, &transfer.frame, share)));
            self.commit(stream, transfer)?;
        }
        Ok(alone)
    }

    /// A PDO for the first of the signals and as many more as possible.
    fn transfer<'a>(&self, stream: &Stream, rest: &[&'a Signal]) -> Result<Transfer<'a>, Refusal> {
        let pdos = &self.pdos[stream.producer];
        let mut refusal = Refusal { node: stream.producer, kind: PdoKind::Tpdo };
        for pdo in pdos.candidates(PdoKind::Tpdo, rest[0].entry) {
            let candidate = &pdos.pdos[pdo];
            let Ok(fixed) = candidate.fixed_cob_id() else { continue };
            if !candidate.can_have(&stream.parameters) {
                continue;
            }
            let mut frame = match candidate.mapping() {
                Ok(slots) => Frame::of(rest, slots),
                Err(mapped) => Frame::of_fixed(rest, mapped),
            };
            while frame.len() > 0 {
                match self.receivers(stream, &frame, fixed.map(plain)) {
                    Ok(receivers) => return Ok(Transfer { frame, pdo, receivers }),
                    Err(refused) => refusal = refused,
                }
                frame = match candidate.is_fixed() {
                    true => break,
                    false => Frame::of(rest, frame.len() - 1),
                };
            }
        }
        Err(refusal)
    }

    /// RPDOs for a frame: partners must receive it, others may, but have no say in its CAN-ID.
    fn receivers(
        &self,
        stream: &Stream,
        frame: &Frame<'_>,
        fixed: Option<u32>,
    ) -> Result<Receivers, Refusal> {
        let demanded = stream.parameters.can_id;
        if fixed.is_some() && demanded.is_some() && fixed != demanded {
            return Err(Refusal { node: stream.producer, kind: PdoKind::Tpdo });
        }
        let is_partner = |share: &Share| stream.partners.contains(&share.node);
        let (partners, others): (Vec<_>, Vec<_>) = frame.shares().into_iter().partition(is_partner);
        let mut receivers = Receivers { can_id: fixed.or(demanded), ..Receivers::default() };
        for share in partners {
            let can_id = receivers.can_id;
            let reception = self.reception(&share, frame.bits, &receivers.receptions, |fixed| {
                can_id.is_none_or(|can_id| can_id == fixed)
            });
            let (reception, fixed) = reception.ok_or(Refusal { node: share.node, kind: PdoKind::Rpdo })?;
            receivers.can_id = can_id.or(fixed);
            receivers.receptions.push(reception);
        }
        for share in others {
            let can_id = receivers.can_id;
            match self.reception(&share, frame.bits, &receivers.receptions, |fixed| can_id == Some(fixed)) {
                Some((reception, _)) => receivers.receptions.push(reception),
                None => receivers.left.push(share),
            }
        }
        Ok(receivers)
    }

    /// The best RPDO for a share, and its CAN-ID if it cannot be changed.
    fn reception(
        &self,
        share: &Share,
        bits: u32,
        others: &[Reception],
        is_possible: impl Fn(u32) -> bool,
    ) -> Option<(Reception, Option<u32>)> {
        let pdos = &self.pdos[share.node];
        let entries = share.entries();
        let (_, first) = share.receivers.first()?;
        let deadline = share.deadline();
        let wanted = LinkParameters { event_timer: deadline, ..LinkParameters::default() };
        pdos.candidates(PdoKind::Rpdo, first.entry).into_iter().find_map(|pdo| {
            let candidate = &pdos.pdos[pdo];
            let fixed = candidate.fixed_cob_id().ok()?.map(plain);
            let is_free = !others.iter().any(|other| (other.node, other.pdo) == (share.node, pdo));
            let is_usable = is_free && candidate.can_have(&wanted) && fixed.is_none_or(&is_possible);
            let mapping = pdos.received(pdo, &entries, bits).filter(|_| is_usable)?;
            Some((Reception { node: share.node, pdo, mapping, deadline, at: first.at }, fixed))
        })
    }

    /// Takes the PDOs of a transfer, gives them a CAN-ID, and adds the wishes of the nodes.
    fn commit(&mut self, stream: &Stream, transfer: Transfer<'_>) -> Result<(), Box<Diagnostic>> {
        let producer = stream.producer;
        let tpdo = self.take(producer, transfer.pdo);
        let Receivers { receptions, can_id, .. } = transfer.receivers;
        let rpdos: Vec<PdoName> =
            receptions.iter().map(|reception| self.take(reception.node, reception.pdo)).collect();
        let user = User::Pdo(producer, tpdo);
        let can_id = match can_id {
            Some(can_id) => can_id,
            None => {
                let of_producer = predefined(&self.nodes[producer], tpdo);
                let of_consumers = receptions.iter().zip(&rpdos);
                let of_consumers = of_consumers.filter(|(to, _)| stream.partners.contains(&to.node));
                let of_consumers =
                    of_consumers.filter_map(|(to, pdo)| predefined(&self.nodes[to.node], *pdo));
                let chosen = self.can_ids.choose(of_producer.into_iter().chain(of_consumers));
                chosen.ok_or_else(|| Box::new(no_can_id(stream.at)))?
            }
        };
        self.can_ids.add(can_id, user);
        let extended = if can_id > 0x7FF { CobId::FRAME } else { 0 };
        for (reception, pdo) in receptions.into_iter().zip(rpdos) {
            self.can_ids.add(can_id, User::Pdo(reception.node, pdo));
            let (node, at) = (reception.node, reception.pdo);
            let wish = self.received(stream, reception, pdo, can_id | extended);
            self.wish(node, at, wish);
        }
        let candidate = &self.pdos[producer].pdos[transfer.pdo];
        // only a TPDO says by bit 30 that it cannot be requested
        let no_rtr = candidate.cob_id.unwrap_or(0) & CobId::BIT_30;
        let said = |value| Said::new(value, stream.at);
        let wish = PdoWish {
            cob_id: Some(Said::new(CobIdWish::Number(can_id | extended | no_rtr), stream.at)),
            transmission: stream.parameters.transmission.map(|value| Said::new(value, stream.at)),
            inhibit_time: stream.parameters.inhibit_time.map(said),
            event_timer: stream.parameters.event_timer.map(said),
            mapping: spanned(candidate.changed(&transfer.frame.mapped), stream.at),
            ..PdoWish::new(tpdo, stream.at)
        };
        self.wish(producer, transfer.pdo, wish);
        Ok(())
    }

    /// Adds the wish of a node, unless its PDO is so for ever.
    fn wish(&mut self, node: usize, pdo: usize, wish: PdoWish) {
        if !self.pdos[node].pdos[pdo].is_for_ever(&wish) {
            self.wishes.push((node, wish));
        }
    }

    /// The wish of a consumer.
    fn received(&self, stream: &Stream, reception: Reception, pdo: PdoName, cob_id: u32) -> PdoWish {
        let Reception { node, at, mapping, deadline, .. } = reception;
        // a PDO on request is an event for who receives it (CiA 301 §7.5.2.35)
        let transmission = stream.parameters.transmission.map(|number| match number {
            241..=253 => 255,
            number => number,
        });
        let candidate = &self.pdos[node].pdos[reception.pdo];
        PdoWish {
            cob_id: Some(Said::new(CobIdWish::Number(cob_id), at)),
            transmission: transmission
                .filter(|_| candidate.is_writable(2))
                .map(|number| Said::new(number, at)),
            deadline: deadline.map(|time| Said::new(time, at)),
            mapping: spanned(mapping, at),
            ..PdoWish::new(pdo, at)
        }
    }

    fn take(&mut self, node: usize, pdo: usize) -> PdoName {
        let candidate = &mut self.pdos[node].pdos[pdo];
        candidate.is_used = true;
        let name = candidate.name;
        if let Some(cob_id) = candidate.valid_cob_id() {
            self.can_ids.release(plain(cob_id), User::Pdo(node, name));
        }
        name
    }

    fn refused(&self, stream: &Stream, signal: &Signal, refusal: Refusal) -> Diagnostic {
        let Refusal { node, kind } = refusal;
        let name = &self.nodes[node].name.value;
        let own = || self.pdos[node].pdos.iter().filter(|pdo| pdo.name.kind == kind);
        let entry = match kind {
            PdoKind::Tpdo => Some(signal.entry),
            PdoKind::Rpdo => signal.receivers.iter().find(|to| to.node == node).map(|to| to.entry),
        };
        let entry = entry.unwrap_or(signal.entry).name();
        if own().all(|pdo| pdo.is_used) {
            let message = say!("`{}` has no {} left for `{}`", name, kind, entry);
            let help = match own().count() {
                0 => say!("the description has no {}", kind),
                count => {
                    say!("all {} are in use: link fewer entries, or take more of them in one PDO", count)
                }
            };
            return Diagnostic::new(&NO_FREE_PDO, stream.at, message).help(help);
        }
        let free =
            own().filter(|pdo| !pdo.is_used).map(|pdo| pdo.name.to_string()).collect::<Vec<_>>().join(", ");
        let message = say!("no {} of `{}` can be configured to carry `{}` as linked", kind, name, entry);
        let help = say!(
            "left are {}, whose mapping, COB-ID or parameters cannot be changed as needed: link what they carry by default",
            free
        );
        let places = own().filter(|pdo| !pdo.is_used).map(|pdo| {
            let (communication, mapping) = indexes(pdo.name);
            At::Node(node, Place::object(if pdo.is_fixed() { mapping } else { communication }))
        });
        Diagnostic::new(&FIXED_PDO, stream.at, message).label_each(places, "not writable").help(help)
    }
}

/// A stream for what a consumer cannot take from a frame.
fn separate(stream: &Stream, frame: &Frame<'_>, share: &Share) -> Stream {
    let first = share.receivers.iter().map(|(_, receiver)| receiver).min_by_key(|receiver| receiver.link);
    let parts = frame.signals().flat_map(|signal| {
        let receivers = share.receivers.iter().filter(|(_, receiver)| signal.has(receiver));
        receivers.map(|(_, receiver)| Signal { entry: signal.entry, receivers: vec![*receiver] })
    });
    Stream {
        link: first.map_or(stream.link, |receiver| receiver.link),
        at: first.map_or(stream.at, |receiver| receiver.at),
        producer: stream.producer,
        partners: vec![share.node],
        parameters: LinkParameters { can_id: None, ..stream.parameters },
        signals: parts.collect(),
    }
}

fn no_can_id(at: Span) -> Diagnostic {
    Diagnostic::new(&NO_FREE_CAN_ID, at, "no CAN-ID is left for the link")
        .help("give the link a CAN-ID, or make PDOs invalid that are not needed")
}

fn spanned(mapping: Mapping, at: Span) -> Option<Vec<Said<crate::model::Address>>> {
    Some(mapping?.into_iter().map(|address| Said::new(address, at)).collect())
}
