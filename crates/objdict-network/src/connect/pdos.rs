//! The PDOs of a node that links may use, and the possible content of each.

use super::can_ids::{on_node, plain};
use super::ends::Carried;
use crate::compiled::Slave;
use crate::configure::PdoName;
use crate::model::{Access, Address, CobId, DataType, Device, MappedObject, Object, Pdo, PdoKind};
use crate::source::Span;
use crate::{LinkParameters, Node, PdoRequest};

/// The PDOs of a node.
pub(crate) struct NodePdos {
    /// RPDOs, then TPDOs, by number.
    pub(super) pdos: Vec<CandidatePdo>,
    dummies: Vec<Dummy>,
}

/// A PDO before a link uses it.
#[derive(Debug)]
pub(crate) struct CandidatePdo {
    pub(super) name: PdoName,
    /// Whether a link uses it, or the network file states its COB-ID or mapping.
    pub(super) is_used: bool,
    /// The position where `set` or `sdo` states its COB-ID or mapping.
    pub(super) stated: Option<Span>,
    /// The COB-ID with its flags.
    pub(super) cob_id: Option<u32>,
    is_cob_id_fixed: bool,
    is_mapping_fixed: bool,
    parameters: Vec<CommunicationParameter>,
    mapped: Vec<MappedObject>,
    /// The maximum number of mapped entries; `None` if the mapping cannot change.
    slots: Option<usize>,
}

/// A communication parameter: sub-index, number, and whether it can be written.
#[derive(Debug)]
struct CommunicationParameter(u8, u32, bool);

/// A data type that fills gaps in RPDOs.
struct Dummy {
    data_type: DataType,
    bits: u8,
}

/// A mapping; `None` keeps the current one.
pub(super) type NewMapping = Option<Vec<Address>>;

/// Why a PDO cannot be as a link needs it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Obstacle {
    /// The mapping is constant and differs.
    Mapping,
    /// The COB-ID is constant, so the PDO cannot be disabled during a change.
    Locked,
    /// The maximum number of mapped entries, and the larger number needed.
    Slots(usize, usize),
    /// No data type that the device allows as a dummy fills a gap of this many bits.
    Gap(u32),
    /// The COB-ID is constant and not valid.
    Invalid,
    /// The CAN-ID is constant and differs.
    CanId(u32),
    /// The communication parameter with this sub-index is constant and differs, or is missing.
    Parameter(u8),
    /// A different part of the same link uses it.
    Taken,
}

impl NodePdos {
    /// The PDOs of a node, from its effective dictionary if it has one.
    pub(crate) fn of(node: &Node, slave: Option<&Slave>) -> Self {
        let device = slave.map_or(&node.device, |slave| &slave.device).with_implicit_pdos();
        let stated = |pdo: &Pdo<'_>| {
            let (communication, mapping) = (pdo.communication_index(), pdo.mapping_index());
            let slave = slave?;
            let mapped = || slave.origins.range((mapping, 0)..=(mapping, 64)).next().map(|(_, at)| *at);
            slave.said(communication, 1).or_else(mapped)
        };
        let pdos = device.pdos().filter(|pdo| pdo.communication.is_some());
        let pdos = pdos.map(|pdo| {
            let mut candidate = CandidatePdo::of(&pdo, node.node_id.map(|said| said.value));
            let is_requested = node.pdos.iter().any(|request| request.pdo == name_of(&pdo));
            candidate.stated = stated(&pdo).filter(|_| !is_requested);
            candidate.is_used = is_requested || candidate.stated.is_some();
            candidate
        });
        Self { pdos: pdos.collect(), dummies: dummies(&device) }
    }

    /// The unused PDOs of a kind for an entry, best first: those that map it, then disabled ones, then the
    /// others.
    pub(super) fn candidates(&self, kind: PdoKind, first: Carried) -> Vec<usize> {
        let unused = self.pdos.iter().enumerate();
        let unused = unused.filter(|(_, pdo)| pdo.name.kind == kind && !pdo.is_used);
        let mut ranked: Vec<(u8, usize)> =
            unused.filter_map(|(at, pdo)| Some((pdo.rank(first)?, at))).collect();
        ranked.sort_unstable();
        ranked.into_iter().map(|(_, at)| at).collect()
    }

    /// The mapping of an RPDO with entries at these positions of a frame, and dummies for the rest of the
    /// frame if there is space.
    pub(super) fn received(
        &self,
        pdo: usize,
        wanted: &[(u32, Carried)],
        frame: u32,
    ) -> Result<NewMapping, Obstacle> {
        let candidate = &self.pdos[pdo];
        let Some(slots) = candidate.slots else {
            return candidate.receives(wanted, frame).then_some(None).ok_or(candidate.other_mapping());
        };
        let mut mapping = Vec::new();
        let mut end = 0;
        for &(position, entry) in wanted {
            // entries of a frame do not overlap
            let gap = position.saturating_sub(end);
            mapping.extend(self.fill(gap).ok_or(Obstacle::Gap(gap))?);
            mapping.push(entry.mapped());
            end = position + u32::from(entry.bits);
        }
        if mapping.len() > slots {
            return Err(Obstacle::Slots(slots, mapping.len()));
        }
        mapping.extend(self.rest(slots - mapping.len(), frame.saturating_sub(end)).unwrap_or_default());
        Ok(candidate.changed(&mapping))
    }

    /// The dummies for the rest of a frame in this many slots.
    fn rest(&self, slots: usize, bits: u32) -> Option<Vec<MappedObject>> {
        self.fill(bits).filter(|dummies| dummies.len() <= slots)
    }

    /// Whether dummies of this many bits can be mapped after the entries of an RPDO.
    pub(crate) fn has_room(&self, pdo: PdoName, bits: u32) -> bool {
        let candidate = self.pdos.iter().find(|candidate| candidate.name == pdo);
        candidate.is_some_and(|candidate| {
            let free = candidate.slots.and_then(|slots| slots.checked_sub(candidate.mapped.len()));
            free.is_some_and(|free| self.rest(free, bits).is_some())
        })
    }

    /// The minimum number of dummies that fill this many bits, at most one frame.
    fn fill(&self, gap: u32) -> Option<Vec<MappedObject>> {
        if gap > Pdo::FRAME_BITS {
            return None;
        }
        let mut fewest: Vec<Option<Vec<MappedObject>>> = vec![Some(Vec::new())];
        for bits in 1..=gap as usize {
            let with = |dummy: &Dummy| {
                let mut filled = fewest[bits.checked_sub(dummy.bits.into())?].clone()?;
                filled.push(MappedObject { index: dummy.data_type.0, sub: 0, bits: dummy.bits });
                Some(filled)
            };
            let best = self.dummies.iter().filter_map(with).min_by_key(Vec::len);
            fewest.push(best);
        }
        fewest.pop().flatten()
    }
}

impl CandidatePdo {
    fn of(pdo: &Pdo<'_>, node_id: Option<u8>) -> Self {
        let name = name_of(pdo);
        let is_writable = |object: Option<&Object>, sub| {
            let entry = object.and_then(|object| object.entry(sub));
            entry.is_some_and(|entry| entry.access.is_none_or(Access::is_writable))
        };
        let [communication, mapping] = [pdo.communication, pdo.mapping];
        let slots = (1..=64).take_while(|sub| is_writable(mapping, *sub)).count();
        let parameters = [
            (2, pdo.transmission_type.map(u32::from)),
            (3, pdo.inhibit_time.map(u32::from)),
            (5, pdo.event_timer.map(u32::from)),
        ];
        let is_cob_id_fixed = !is_writable(communication, 1);
        // the inhibit time may change only while the PDO is not valid (CiA 301 §7.5.2.37)
        let can_change = |sub| is_writable(communication, sub) && !(is_cob_id_fixed && sub == 3);
        let parameter = |(sub, number): (u8, Option<u32>)| {
            CommunicationParameter(sub, number.unwrap_or(0), can_change(sub))
        };
        let cob_id = pdo.cob_id.and_then(|cob_id| on_node(cob_id, node_id));
        let is_locked = is_cob_id_fixed && cob_id.is_some_and(|cob_id| cob_id & CobId::BIT_31 == 0);
        let is_mapping_fixed = slots == 0 || !is_writable(mapping, 0);
        Self {
            name,
            is_used: false,
            stated: None,
            cob_id,
            is_cob_id_fixed,
            is_mapping_fixed,
            parameters: parameters.into_iter().map(parameter).collect(),
            mapped: pdo.mapped().collect(),
            slots: Some(slots).filter(|_| !is_mapping_fixed && !is_locked),
        }
    }

    /// The reason why the mapping cannot change.
    pub(super) const fn other_mapping(&self) -> Obstacle {
        if self.is_mapping_fixed { Obstacle::Mapping } else { Obstacle::Locked }
    }

    /// The COB-ID with the CAN-ID and flags that a link needs; a constant one is kept.
    pub(super) fn cob_id_for(&self, cob_id: u32) -> u32 {
        self.cob_id.filter(|_| self.is_cob_id_fixed).unwrap_or(cob_id)
    }

    /// The present COB-ID, if the PDO is valid.
    pub(super) fn valid_cob_id(&self) -> Option<u32> {
        self.cob_id.filter(|cob_id| cob_id & CobId::BIT_31 == 0)
    }

    /// The CAN-ID that cannot be changed, if the PDO has one.
    pub(super) fn constant_can_id(&self) -> Result<Option<u32>, Obstacle> {
        if !self.is_cob_id_fixed {
            return Ok(None);
        }
        self.valid_cob_id().map(plain).map(Some).ok_or(Obstacle::Invalid)
    }

    pub(super) const fn is_fixed(&self) -> bool {
        self.slots.is_none()
    }

    pub(super) fn maps(&self, entry: Carried) -> bool {
        self.mapped.iter().any(|mapped| (mapped.index, mapped.sub) == (entry.index, entry.sub))
    }

    fn rank(&self, first: Carried) -> Option<u8> {
        match self.maps(first) {
            true => Some(0),
            false if self.is_fixed() => None,
            false if self.valid_cob_id().is_none() || self.mapped.is_empty() => Some(1),
            false => Some(2),
        }
    }

    /// Whether the PDO has these parameters or can get them.
    pub(super) fn can_have(&self, wanted: &LinkParameters) -> Result<(), Obstacle> {
        let wanted = [
            wanted.transmission.map(u32::from),
            wanted.inhibit_time.map(u32::from),
            wanted.event_timer.map(u32::from),
        ];
        let mut pairs = wanted.into_iter().zip(&self.parameters);
        let refused = pairs.find(|(wanted, CommunicationParameter(_, present, is_writable))| {
            !is_writable && wanted.is_some_and(|wanted| wanted != *present)
        });
        refused.map_or(Ok(()), |(_, CommunicationParameter(sub, ..))| Err(Obstacle::Parameter(*sub)))
    }

    /// Whether the PDO already meets the request, and its COB-ID, which starts and ends each change, cannot
    /// be written.
    pub(super) fn is_for_ever(&self, request: &PdoRequest) -> bool {
        // the other times belong to the manager
        let (inhibit_time, timer, of_manager) = match self.name.kind {
            PdoKind::Tpdo => (request.inhibit_time, request.event_timer, request.deadline),
            PdoKind::Rpdo => (None, request.deadline, request.inhibit_time.or(request.event_timer)),
        };
        let wanted = [
            request.transmission.map(|said| said.value.into()),
            inhibit_time.map(|said| said.value.into()),
            timer.map(|said| said.value.into()),
        ];
        let mut pairs = wanted.into_iter().zip(&self.parameters);
        self.is_cob_id_fixed
            && request.mapping.is_none()
            && of_manager.is_none()
            && pairs.all(|(wanted, CommunicationParameter(_, present, _))| {
                wanted.is_none_or(|wanted: u32| wanted == *present)
            })
    }

    /// Whether the COB-ID is constant.
    pub(super) const fn is_cob_id_constant(&self) -> bool {
        self.is_cob_id_fixed
    }

    /// Whether a communication parameter can be written.
    pub(super) fn is_writable(&self, sub: u8) -> bool {
        self.parameters.iter().any(|parameter| parameter.0 == sub && parameter.2)
    }

    /// The objects of a fixed mapping; for others how many entries can be mapped.
    pub(super) fn mapping(&self) -> Result<usize, &[MappedObject]> {
        self.slots.ok_or(&self.mapped)
    }

    /// The mapping to write; `None` if it already exists.
    pub(super) fn changed(&self, mapping: &[MappedObject]) -> NewMapping {
        let address = |mapped: &MappedObject| Address { index: mapped.index, sub: Some(mapped.sub) };
        (self.mapped != mapping).then(|| mapping.iter().map(address).collect())
    }

    /// Whether the fixed mapping receives exactly these entries from a frame of this many bits.
    fn receives(&self, wanted: &[(u32, Carried)], frame: u32) -> bool {
        let wanted = wanted.iter().map(|(at, entry)| (*at, entry.mapped()));
        let placed = MappedObject::placed(self.mapped.iter().copied(), |mapped| mapped.bits);
        let length = self.mapped.iter().map(|mapped| u32::from(mapped.bits)).sum::<u32>();
        length <= frame && placed.filter(|(_, mapped)| !mapped.is_dummy()).eq(wanted)
    }
}

const fn name_of(pdo: &Pdo<'_>) -> PdoName {
    PdoName { kind: pdo.kind, number: pdo.number }
}

/// The data types that the device allows as dummies, of each length one.
fn dummies(device: &Device) -> Vec<Dummy> {
    let Some(usage) = &device.dummy_usage else { return Vec::new() };
    let allowed = usage.types.iter().filter(|(data_type, is_allowed)| **is_allowed && data_type.is_dummy());
    let mut dummies: Vec<Dummy> = allowed
        .filter_map(|(data_type, _)| Some(Dummy { data_type: *data_type, bits: data_type.bit_length()? }))
        .collect();
    // devices are more likely to support unsigned types than signed ones
    dummies
        .sort_by_key(|dummy| (dummy.bits, dummy.data_type.integer_range().is_some_and(|(low, _)| low < 0)));
    dummies.dedup_by_key(|dummy| dummy.bits);
    dummies
}
