//! Converts groups of signals to PDOs of their producers and consumers.

use std::collections::BTreeMap;

use super::can_ids::{CanIds, User, plain, predefined};
use super::ends::Carried;
use super::frame::{GroupFrame, Share};
use super::groups::{LeadSignal, LinkGroup};
use super::obstacles;
use super::pdos::{CandidatePdo, NewMapping, NodePdos, Obstacle};
use crate::compiled::{Compiled, Slave, indexes, received_type};
use crate::configure::PdoName;
use crate::diagnostic::{At, Diagnostic, Findings, Severity, say};
use crate::lock::NetworkLock;
use crate::model::{CobId, Pdo, PdoKind};
use crate::rules::{CONTRADICTION, FIXED_PDO, LINK_TOO_LONG, MOVED_CAN_ID, NO_FREE_CAN_ID, NO_FREE_PDO};
use crate::source::Span;
use crate::{Link, LinkParameters, Network, Node, PdoRequest, RequestedCobId, Said, Service};

/// The PDOs of all groups with their nodes, in the order of the groups.
pub(super) fn pack(
    network: &Network,
    compiled: &Compiled,
    groups: Vec<LinkGroup>,
    findings: &mut Findings,
) -> Vec<(usize, PdoRequest)> {
    let pdos =
        network.nodes.iter().enumerate().map(|(position, node)| NodePdos::of(node, compiled.node(position)));
    let mut packer = FramePacker {
        nodes: &network.nodes,
        pdos: pdos.collect(),
        can_ids: CanIds::new(network, compiled),
        requests: Vec::new(),
        links: &network.links,
        lock: &network.lock,
        compiled,
        findings: Findings::new(),
    };
    // in the order of the links, so that later ones do not affect earlier ones
    let mut order = 0..;
    let mut ordered = |group: LinkGroup| ((group.link, order.next()), group);
    let mut groups: BTreeMap<_, LinkGroup> = groups.into_iter().map(&mut ordered).collect();
    while let Some((_, group)) = groups.pop_first() {
        match packer.place(&group) {
            Ok(alone) => groups.extend(alone.into_iter().map(&mut ordered)),
            Err(finding) => findings.push(*finding),
        }
    }
    findings.append(std::mem::take(&mut packer.findings));
    for slave in compiled.nodes() {
        if let Some(at) = network.switches_off(slave.node) {
            packer.switch_off(network, slave, at, findings);
        }
    }
    packer.requests
}

struct FramePacker<'a> {
    nodes: &'a [Node],
    pdos: Vec<NodePdos>,
    can_ids: CanIds,
    requests: Vec<(usize, PdoRequest)>,
    links: &'a [Link],
    lock: &'a NetworkLock,
    compiled: &'a Compiled,
    /// PDOs that leave their predefined CAN-IDs.
    findings: Findings,
}

/// A PDO of a consumer for a share of a frame.
struct ConsumerPdo {
    node: usize,
    /// Its position among the PDOs of the node.
    pdo: usize,
    mapping: NewMapping,
    deadline: Option<u16>,
    at: Span,
}

/// The obstacles of a node's PDOs, by position.
type Obstacles = Vec<(usize, Obstacle)>;

/// A frame with PDOs at both ends.
struct Transfer<'a> {
    frame: GroupFrame<'a>,
    /// The position of the lead's PDO.
    pdo: usize,
    receivers: Receivers,
}

/// Who receives a frame.
#[derive(Default)]
struct Receivers {
    receptions: Vec<ConsumerPdo>,
    /// Parts of this frame that nodes outside the group cannot receive.
    left: Vec<Share>,
    /// The CAN-ID that the nodes leave no choice of.
    can_id: Option<u32>,
}

/// The reason why a transfer is impossible.
struct TransferRefusal {
    node: usize,
    kind: PdoKind,
    /// The obstacles of the node's PDOs, by position. Others have a constant mapping without the entry.
    obstacles: Obstacles,
}

impl FramePacker<'_> {
    /// Assigns as many PDOs to a group as needed. Parts that single consumers cannot receive from them are
    /// returned as separate groups.
    fn place(&mut self, group: &LinkGroup) -> Result<Vec<LinkGroup>, Box<Diagnostic>> {
        let bits: u32 = group.signals.iter().map(|signal| u32::from(signal.entry.bits)).sum();
        if group.parameters.can_id.is_some() && bits > Pdo::FRAME_BITS {
            let message =
                say!("{} bits are linked with one CAN-ID, but a PDO has at most {}", bits, Pdo::FRAME_BITS);
            let help = "omit the CAN-ID, or split the entries into links with different CAN-IDs";
            return Err(Box::new(Diagnostic::new(&LINK_TOO_LONG, group.at, message).help(help)));
        }
        let mut alone = Vec::new();
        let mut rest: Vec<&LeadSignal> = group.signals.iter().collect();
        // signals of an earlier build come first, in their order
        rest.sort_by_cached_key(|signal| {
            let carrier = self.carrier(group.lead, group.kind, signal.entry);
            (carrier.is_none(), carrier)
        });
        while !rest.is_empty() {
            let transfer = match self.transfer(group, &rest) {
                Ok(transfer) => transfer,
                Err(refusal) => return Err(Box::new(self.refused(group, rest[0], &refusal))),
            };
            let count = rest.len();
            rest.retain(|signal| !transfer.frame.carries(signal));
            if let Some(can_id) = group.parameters.can_id.filter(|_| !rest.is_empty()) {
                return Err(Box::new(self.split(group, &transfer, can_id, (count - rest.len(), count))));
            }
            alone.extend(transfer.receivers.left.iter().map(|share| separate(group, &transfer.frame, share)));
            self.commit(group, transfer)?;
        }
        Ok(alone)
    }

    /// The PDO that carried an entry in an earlier build.
    fn carrier(&self, node: usize, kind: PdoKind, entry: Carried) -> Option<(PdoName, usize)> {
        self.lock.carrier(&self.nodes[node].name.value, kind, (entry.index, entry.sub))
    }

    /// The unused PDOs of a node for an entry, best first: the one that carried it in an earlier build, those that carried nothing, then
    /// the others.
    fn candidates(&self, node: usize, kind: PdoKind, first: Carried) -> Vec<usize> {
        let pdos = &self.pdos[node];
        let mut candidates = pdos.candidates(kind, first);
        let carrier = self.carrier(node, kind, first).map(|(pdo, _)| pdo);
        let name = &self.nodes[node].name.value;
        candidates.sort_by_cached_key(|at| {
            let pdo = pdos.pdos[*at].name;
            (carrier != Some(pdo), self.lock.pdo(name, pdo).is_some())
        });
        candidates
    }

    /// A PDO for the first of the signals and as many more as possible.
    fn transfer<'a>(
        &self,
        group: &LinkGroup,
        rest: &[&'a LeadSignal],
    ) -> Result<Transfer<'a>, TransferRefusal> {
        let pdos = &self.pdos[group.lead];
        let mut of_lead = TransferRefusal { node: group.lead, kind: group.kind, obstacles: Vec::new() };
        let mut of_consumer = None;
        for pdo in self.candidates(group.lead, group.kind, rest[0].entry) {
            let candidate = &pdos.pdos[pdo];
            // entries of a different PDO of an earlier build remain there
            let is_here = |signal: &&&LeadSignal| {
                let carrier = self.carrier(group.lead, group.kind, signal.entry);
                carrier.is_none_or(|(carrier, _)| carrier == candidate.name)
            };
            let others = rest[1..].iter().filter(is_here).copied();
            let rest: &[_] = &[rest[0]].into_iter().chain(others).collect::<Vec<_>>();
            let can_id = match self.can_lead(group, candidate, rest) {
                Ok(can_id) => can_id,
                Err(obstacle) => {
                    of_lead.obstacles.push((pdo, obstacle));
                    continue;
                }
            };
            let mut frame = match candidate.mapping() {
                Ok(slots) => GroupFrame::of(rest, slots),
                Err(mapped) => GroupFrame::of_fixed(rest, mapped),
            };
            if frame.len() == 0 {
                of_lead.obstacles.push((pdo, candidate.other_mapping()));
            }
            while frame.len() > 0 {
                match self.receivers(group, &frame, can_id) {
                    Ok(receivers) => return Ok(Transfer { frame, pdo, receivers }),
                    Err(refused) => of_consumer = Some(refused),
                }
                frame = match candidate.is_fixed() {
                    true => break,
                    false => GroupFrame::of(rest, frame.len() - 1),
                };
            }
        }
        Err(of_consumer.unwrap_or(of_lead))
    }

    /// The CAN-ID that a link requires, or that a PDO of the lead has permanently.
    fn can_lead(
        &self,
        group: &LinkGroup,
        candidate: &CandidatePdo,
        rest: &[&LeadSignal],
    ) -> Result<Option<u32>, Obstacle> {
        let demanded = group.parameters.can_id;
        let constant = candidate.constant_can_id()?;
        if let Some(constant) = constant.filter(|constant| demanded.is_some_and(|id| id != *constant)) {
            return Err(Obstacle::CanId(constant));
        }
        let transmission = group.parameters.transmission;
        candidate.can_have(&match group.kind {
            PdoKind::Tpdo => group.parameters,
            // the other times belong to the manager
            PdoKind::Rpdo => LinkParameters {
                transmission: transmission.map(received_type),
                event_timer: rest.iter().filter_map(|signal| signal.deadline).min(),
                ..LinkParameters::default()
            },
        })?;
        Ok(constant.or(demanded))
    }

    /// The RPDOs for a frame: partners must receive it; others may, but do not affect its CAN-ID.
    fn receivers(
        &self,
        group: &LinkGroup,
        frame: &GroupFrame<'_>,
        can_id: Option<u32>,
    ) -> Result<Receivers, TransferRefusal> {
        let is_partner = |share: &Share| group.partners.contains(&share.node);
        let (partners, others): (Vec<_>, Vec<_>) = frame.shares().into_iter().partition(is_partner);
        let mut receivers = Receivers { can_id, ..Receivers::default() };
        for share in partners {
            let can_id = receivers.can_id;
            let reception = self.reception(&share, frame.bits, &receivers.receptions, |fixed| {
                can_id.is_none_or(|can_id| can_id == fixed)
            });
            let (reception, fixed) = reception.map_err(|obstacles| {
                let (node, kind) = (share.node, PdoKind::Rpdo);
                TransferRefusal { node, kind, obstacles }
            })?;
            receivers.can_id = can_id.or(fixed);
            receivers.receptions.push(reception);
        }
        for share in others {
            let can_id = receivers.can_id;
            match self.reception(&share, frame.bits, &receivers.receptions, |fixed| can_id == Some(fixed)) {
                Ok((reception, _)) => receivers.receptions.push(reception),
                Err(_) => receivers.left.push(share),
            }
        }
        Ok(receivers)
    }

    /// The best RPDO for a share, and its CAN-ID if that cannot be changed; otherwise the obstacle of each.
    fn reception(
        &self,
        share: &Share,
        bits: u32,
        others: &[ConsumerPdo],
        is_possible: impl Fn(u32) -> bool,
    ) -> Result<(ConsumerPdo, Option<u32>), Obstacles> {
        let pdos = &self.pdos[share.node];
        let entries = share.entries();
        let deadline = share.deadline();
        let wanted = LinkParameters { event_timer: deadline, ..LinkParameters::default() };
        let mut obstacles = Vec::new();
        // each share has an entry
        for (pdo, (_, first)) in share.receivers.first().into_iter().flat_map(|first| {
            self.candidates(share.node, PdoKind::Rpdo, first.1.entry).into_iter().map(move |pdo| (pdo, first))
        }) {
            let candidate = &pdos.pdos[pdo];
            let found = candidate.constant_can_id().and_then(|fixed| {
                candidate.can_have(&wanted)?;
                match fixed {
                    _ if others.iter().any(|other| (other.node, other.pdo) == (share.node, pdo)) => {
                        Err(Obstacle::Taken)
                    }
                    Some(fixed) if !is_possible(fixed) => Err(Obstacle::CanId(fixed)),
                    _ => Ok((pdos.received(pdo, &entries, bits)?, fixed)),
                }
            });
            match found {
                Ok((mapping, fixed)) => {
                    let reception = ConsumerPdo { node: share.node, pdo, mapping, deadline, at: first.at };
                    return Ok((reception, fixed));
                }
                Err(obstacle) => obstacles.push((pdo, obstacle)),
            }
        }
        Err(obstacles)
    }

    /// Reserves the PDOs of a transfer, assigns a CAN-ID, and adds the requests of the nodes.
    fn commit(&mut self, group: &LinkGroup, transfer: Transfer<'_>) -> Result<(), Box<Diagnostic>> {
        let lead = group.lead;
        let own = self.take(lead, transfer.pdo);
        let Receivers { receptions, can_id, .. } = transfer.receivers;
        let rpdos: Vec<PdoName> =
            receptions.iter().map(|reception| self.take(reception.node, reception.pdo)).collect();
        let user = User::Pdo(lead, own);
        let can_id = match can_id {
            Some(can_id) => can_id,
            None => {
                let of_lead = predefined(&self.nodes[lead], own);
                let of_consumers = receptions.iter().zip(&rpdos);
                let of_consumers = of_consumers.filter(|(to, _)| group.partners.contains(&to.node));
                let of_consumers =
                    of_consumers.filter_map(|(to, pdo)| predefined(&self.nodes[to.node], *pdo));
                let of_sender = of_lead.filter(|_| group.kind == PdoKind::Tpdo);
                let locked = self.lock.pdo(&self.nodes[lead].name.value, own).map(|locked| locked.can_id);
                let chosen = self
                    .can_ids
                    .keep(locked)
                    .or_else(|| self.can_ids.choose(of_sender, of_lead.into_iter().chain(of_consumers)));
                let chosen = chosen.ok_or_else(|| Box::new(no_can_id(group.at)))?;
                if let Some(wanted) = of_lead.filter(|wanted| *wanted != chosen) {
                    let moved = self.moved(group, own, (wanted, chosen));
                    self.findings.push(moved);
                }
                chosen
            }
        };
        self.can_ids.add(can_id, user);
        let extended = if can_id > 0x7FF { CobId::FRAME } else { 0 };
        for (reception, pdo) in receptions.into_iter().zip(rpdos) {
            self.can_ids.add(can_id, User::Pdo(reception.node, pdo));
            let (node, at) = (reception.node, reception.pdo);
            let request = self.received(group, reception, pdo, can_id | extended);
            self.request(node, at, request);
        }
        let request = self.led(group, &transfer.frame, transfer.pdo, can_id | extended);
        self.request(lead, transfer.pdo, request);
        Ok(())
    }

    /// Reports a PDO whose CAN-ID is not its predefined one, with the place of the PDO that uses that one.
    fn moved(&self, group: &LinkGroup, own: PdoName, (wanted, chosen): (u32, u32)) -> Diagnostic {
        let named =
            |node: usize, pdo: PdoName| format!("{} of `{}`", Service::Pdo(pdo), self.nodes[node].name.value);
        let user = self.can_ids.sender(wanted).or_else(|| self.can_ids.users(wanted).next());
        let (who, at, is_set) = match user {
            Some(User::Pdo(node, pdo)) => {
                let of_link = self.requests.iter().find(|(at, request)| (*at, request.pdo) == (node, pdo));
                let slave = self.compiled.node(node);
                let entry = (indexes(pdo).0, 1);
                let said = of_link.map(|(_, request)| request.at);
                let said = said.or_else(|| slave?.said(entry.0, entry.1));
                let described = || At::Node(node, self.nodes[node].device.value_place(entry.0, entry.1));
                let mut candidates = self.pdos[node].pdos.iter();
                let is_set = candidates.any(|candidate| candidate.name == pdo && candidate.stated.is_some());
                (named(node, pdo), Some(said.map_or_else(described, At::Span)), is_set)
            }
            _ => {
                let link = self.links.iter().find(|link| link.parameters.can_id == Some(wanted));
                ("a different link or service".to_owned(), link.map(|link| At::Span(link.at)), false)
            }
        };
        let message = say!(
            "{} gets CAN-ID {:X}h because its predefined CAN-ID {:X}h is used by {}",
            named(group.lead, own),
            chosen,
            wanted,
            who
        );
        let finding =
            Diagnostic::new(&MOVED_CAN_ID, group.at, message).label_each(at, "the predefined CAN-ID");
        // `set` and `sdo` are the last resort, and typing errors in them go unnoticed
        let severity = if is_set { Severity::Warning } else { Severity::Note };
        finding.severity(severity).help("give one of them a different CAN-ID")
    }

    /// The lead's request.
    fn led(&self, group: &LinkGroup, frame: &GroupFrame<'_>, pdo: usize, cob_id: u32) -> PdoRequest {
        let candidate = &self.pdos[group.lead].pdos[pdo];
        let parameters = group.parameters;
        // only a TPDO has bit 30, which disables remote requests
        let (no_rtr, transmission) = match group.kind {
            PdoKind::Tpdo => (candidate.cob_id.unwrap_or(0) & CobId::BIT_30, parameters.transmission),
            PdoKind::Rpdo => (0, parameters.transmission.map(received_type)),
        };
        let said = |value| Said::new(value, group.at);
        let cob_id = candidate.cob_id_for(cob_id | no_rtr);
        PdoRequest {
            cob_id: Some(Said::new(RequestedCobId::Number(cob_id), group.at)),
            transmission: transmission.map(|value| Said::new(value, group.at)),
            inhibit_time: parameters.inhibit_time.map(said),
            event_timer: parameters.event_timer.map(said),
            deadline: frame.deadline().map(said),
            mapping: spanned(candidate.changed(&frame.mapped), group.at),
            ..PdoRequest::new(candidate.name, group.at)
        }
    }

    /// Adds the request of a node, unless its PDO permanently meets it.
    fn request(&mut self, node: usize, pdo: usize, request: PdoRequest) {
        if !self.pdos[node].pdos[pdo].is_for_ever(&request) {
            self.requests.push((node, request));
        }
    }

    /// The request of a consumer.
    fn received(&self, group: &LinkGroup, reception: ConsumerPdo, pdo: PdoName, cob_id: u32) -> PdoRequest {
        let ConsumerPdo { node, at, mapping, deadline, .. } = reception;
        let transmission = group.parameters.transmission.map(received_type);
        let candidate = &self.pdos[node].pdos[reception.pdo];
        PdoRequest {
            cob_id: Some(Said::new(RequestedCobId::Number(candidate.cob_id_for(cob_id)), at)),
            transmission: transmission
                .filter(|_| candidate.is_writable(2))
                .map(|number| Said::new(number, at)),
            deadline: deadline.map(|time| Said::new(time, at)),
            mapping: spanned(mapping, at),
            ..PdoRequest::new(pdo, at)
        }
    }

    /// Disables the valid PDOs of a node that no link and no key uses. A constant COB-ID is a finding.
    fn switch_off(&mut self, network: &Network, slave: &Slave, at: Span, findings: &mut Findings) {
        let pdos = self.pdos[slave.node].pdos.iter();
        let unused = pdos.filter(|pdo| !pdo.is_used && pdo.valid_cob_id().is_some());
        // implied PDOs have no entries to write
        let is_there = |pdo: &&CandidatePdo| slave.pdos.iter().any(|state| state.pdo == pdo.name);
        let unused = unused.filter(is_there).filter(|pdo| slave.stated(network, pdo.name).is_none());
        let (constant, others): (Vec<_>, Vec<_>) = unused.partition(|pdo| pdo.is_cob_id_constant());
        let off =
            |pdo: &CandidatePdo| (slave.node, PdoRequest { enabled: false, ..PdoRequest::new(pdo.name, at) });
        self.requests.extend(others.into_iter().map(off));
        findings.push(match constant.as_slice() {
            [] => return,
            stay => obstacles::stay_valid(stay, (slave.node, &network.nodes[slave.node]), at),
        });
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

    /// A link with one CAN-ID that does not fit into one PDO.
    fn split(
        &self,
        group: &LinkGroup,
        transfer: &Transfer<'_>,
        can_id: u32,
        (fitting, count): (usize, usize),
    ) -> Diagnostic {
        let pdo = self.pdos[group.lead].pdos[transfer.pdo].name;
        let message = say!(
            "{} {} of `{}` carries {} of {} entries that are linked with the CAN-ID {:X}h",
            pdo.kind,
            pdo.number,
            self.nodes[group.lead].name.value,
            fitting,
            count,
            can_id
        );
        let help = "omit the CAN-ID, or split the entries into links with different CAN-IDs";
        Diagnostic::new(&LINK_TOO_LONG, group.at, message).help(help)
    }

    /// A PDO for a signal whose COB-ID or mapping the network file sets to a conflicting value.
    fn contradicted(
        &self,
        group: &LinkGroup,
        signal: &LeadSignal,
        refusal: &TransferRefusal,
    ) -> Option<Diagnostic> {
        let TransferRefusal { node, kind, .. } = *refusal;
        let entry = match kind {
            PdoKind::Tpdo => signal.entry,
            PdoKind::Rpdo => {
                signal.receivers.iter().find(|to| to.node == node).map_or(signal.entry, |to| to.entry)
            }
        };
        let stated = self.pdos[node].pdos.iter().filter(|pdo| pdo.name.kind == kind && pdo.stated.is_some());
        let mut stated = stated.filter(|pdo| group.parameters.can_id.is_some() || pdo.maps(entry));
        let pdo = stated.clone().find(|pdo| pdo.maps(entry)).or_else(|| stated.next())?;
        let (name, number) = (&self.nodes[node].name.value, pdo.name.number);
        let is = match pdo.valid_cob_id() {
            Some(cob_id) => format!("is set to the CAN-ID {:X}h", plain(cob_id)),
            None => "is set to be not valid".to_owned(),
        };
        let message = match group.parameters.can_id {
            Some(can_id) => say!(
                "the link of `{}` has the `can-id` {:X}h, but {} {} of `{}` {} by `set` or `sdo`",
                entry.name(),
                can_id,
                kind,
                number,
                name,
                is
            ),
            None => say!(
                "the link of `{}` needs {} {} of `{}`, which {} by `set` or `sdo`",
                entry.name(),
                kind,
                number,
                name,
                is
            ),
        };
        let finding = Diagnostic::new(&CONTRADICTION, group.at, message);
        let stated = pdo.stated.map(crate::diagnostic::At::Span);
        Some(finding.label_each(stated, "the other value").help("remove one of the two"))
    }

    fn refused(&self, group: &LinkGroup, signal: &LeadSignal, refusal: &TransferRefusal) -> Diagnostic {
        let TransferRefusal { node, kind, .. } = *refusal;
        let name = &self.nodes[node].name.value;
        let own = || self.pdos[node].pdos.iter().filter(|pdo| pdo.name.kind == kind);
        let entry = match kind {
            PdoKind::Tpdo => Some(signal.entry),
            PdoKind::Rpdo => signal.receivers.iter().find(|to| to.node == node).map(|to| to.entry),
        };
        let entry = entry.unwrap_or(signal.entry).name();
        if own().all(|pdo| pdo.is_used) {
            if let Some(finding) = self.contradicted(group, signal, refusal) {
                return finding;
            }
            let message = say!("`{}` has no {} left for `{}`", name, kind, entry);
            let help = match own().count() {
                0 => say!("the description has no {}", kind),
                count => {
                    say!("all {} are in use: link fewer entries, or put more of them in one PDO", count)
                }
            };
            return Diagnostic::new(&NO_FREE_PDO, group.at, message).help(help);
        }
        let message = say!("no {} of `{}` can be configured to carry `{}` as linked", kind, name, entry);
        let finding = Diagnostic::new(&FIXED_PDO, group.at, message);
        obstacles::explained(finding, (node, &self.nodes[node]), &self.pdos[node], kind, &refusal.obstacles)
    }
}

/// A separate group for the part of a frame that a consumer cannot receive.
fn separate(group: &LinkGroup, frame: &GroupFrame<'_>, share: &Share) -> LinkGroup {
    let first = share.receivers.iter().map(|(_, receiver)| receiver).min_by_key(|receiver| receiver.link);
    let parts = frame.signals().flat_map(|signal| {
        let receivers = share.receivers.iter().filter(|(_, receiver)| signal.has(receiver));
        receivers.map(|(_, receiver)| LeadSignal {
            entry: signal.entry,
            receivers: vec![*receiver],
            deadline: None,
        })
    });
    LinkGroup {
        link: first.map_or(group.link, |receiver| receiver.link),
        at: first.map_or(group.at, |receiver| receiver.at),
        lead: group.lead,
        kind: group.kind,
        partners: vec![share.node],
        parameters: LinkParameters { can_id: None, ..group.parameters },
        signals: parts.collect(),
    }
}

fn no_can_id(at: Span) -> Diagnostic {
    Diagnostic::new(&NO_FREE_CAN_ID, at, "no CAN-ID is left for the link")
        .help("give the link a CAN-ID, or make unneeded PDOs invalid")
}

fn spanned(mapping: NewMapping, at: Span) -> Option<Vec<Said<crate::model::Address>>> {
    Some(mapping?.into_iter().map(|address| Said::new(address, at)).collect())
}
