//! The communication of a device, evaluated once for all rules.

use std::borrow::Cow;
use std::ops::RangeInclusive;

#[cfg(feature = "catalogue")]
use crate::Srdo;
use crate::diagnostic::{Argument, Sayable, say};
use crate::model::{
    CobId, DataType, Device, DeviceKind, Entry, Field, MappedObject, Object, Pdo, PdoKind, TypeKind, Value,
    predefined, restricted,
};
use crate::{Options, stated};

/// The communication of a device.
pub(crate) struct Facts<'a> {
    pub device: &'a Device,
    /// The options of the check.
    pub options: &'a Options,
    /// The PDOs, first RPDOs, then TPDOs, by number; without those that `CompactPDO` implies.
    pub pdos: Vec<PdoFacts<'a>>,
    /// Every COB-ID that an object states, PDOs last; without those of SRDOs.
    pub cob_ids: Vec<CobIdUse>,
    /// The SRDOs, by number.
    #[cfg(feature = "catalogue")]
    pub srdos: Vec<Srdo<'a>>,
}

/// A PDO with the targets of its mapping entries.
pub(crate) struct PdoFacts<'a> {
    pub pdo: Pdo<'a>,
    /// The slots in use that refer to an object, in the order of the frame.
    pub mapped: Vec<MappingFact<'a>>,
}

/// A mapping entry in use.
pub(crate) struct MappingFact<'a> {
    /// The sub-index in the mapping parameter.
    pub slot: u8,
    /// The object that the entry refers to.
    pub object: MappedObject,
    /// The target of the entry.
    pub target: MappedTo<'a>,
}

/// The target of a mapping entry.
pub(crate) enum MappedTo<'a> {
    /// A data type: a dummy entry.
    Dummy,
    /// The object is described, but the sub-index is not.
    NoEntry,
    /// The object is not described.
    NoObject,
    /// Not described, but a module or a dynamic channel may provide it.
    Elsewhere,
    /// Sub-index 0 of an ARRAY or RECORD, the number of entries.
    Count,
    /// An entry with a value.
    Entry(Cow<'a, Entry>),
}

/// A COB-ID with its entry and its service.
pub(crate) struct CobIdUse {
    pub index: u16,
    pub sub: u8,
    pub service: CobIdService,
    pub cob_id: CobId,
}

/// The service of a COB-ID.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CobIdService {
    Sync,
    Time,
    Emcy,
    /// EMCY of a different node.
    EmcyConsumer,
    /// From client to server, for a server of this device.
    ServerRequest(u16),
    /// From server to client.
    ServerResponse(u16),
    ClientRequest(u16),
    ClientResponse(u16),
    Pdo(PdoKind, u16),
}

impl<'a> Facts<'a> {
    pub(crate) fn new(device: &'a Device, options: &'a Options) -> Self {
        let pdos: Vec<PdoFacts<'a>> = device.pdos().map(|pdo| PdoFacts::new(device, pdo)).collect();
        let cob_ids = cob_ids(device, &pdos);
        Self {
            device,
            options,
            pdos,
            cob_ids,
            #[cfg(feature = "catalogue")]
            srdos: Srdo::all(device),
        }
    }

    /// The node-IDs to which the description applies: the one in the options or in a DCF, otherwise all.
    pub(crate) fn node_ids(&self) -> RangeInclusive<u8> {
        match self.options.node_id.or(self.device.node_id()) {
            Some(node_id) => node_id..=node_id,
            None => 1..=127,
        }
    }

    /// The configured number of a sub-index; a formula is evaluated for the first applicable
    /// node-ID.
    pub(crate) fn number(&self, index: u16, sub: u8) -> Option<i128> {
        self.device.value(index, sub)?.integer_for(*self.node_ids().start())
    }

    /// The first valid TPDO that maps an object of a range and is sent on events only, without an event timer.
    #[cfg(feature = "catalogue")]
    pub(crate) fn waiting_tpdo(&self, mapped: &RangeInclusive<u16>) -> Option<&Pdo<'a>> {
        self.pdos.iter().map(|pdo| &pdo.pdo).find(|pdo| {
            let is_sent = pdo.kind == PdoKind::Tpdo && pdo.is_valid() == Some(true);
            let on_event_only = pdo.is_event_driven() && pdo.event_timer.unwrap_or(0) == 0;
            is_sent && on_event_only && pdo.mapped().any(|object| mapped.contains(&object.index))
        })
    }

    /// Whether all values of an object are 0 or false in a configuration, where they are set or by default.
    #[cfg(feature = "catalogue")]
    pub(crate) fn is_configured_off(&self, index: u16) -> bool {
        let is_zero = |value: &Value| *value == Value::Boolean(false) || value.as_integer() == Some(0);
        let Some(object) = self.device.object(index).filter(|_| self.device.kind == DeviceKind::Node) else {
            return false;
        };
        let counts = u8::from(object.object_type().has_subs());
        let mut values =
            object.entries().filter(|(sub, _)| *sub >= counts).map(|(sub, _)| object.value(sub)).peekable();
        values.peek().is_some() && values.all(|value| value.is_some_and(|value| is_zero(&value)))
    }

    /// Whether the device follows a device profile according to 1000h.
    pub(crate) fn has_profile(&self) -> bool {
        self.device.profile().is_some_and(|profile| profile != 0)
    }
}

impl Facts<'_> {
    /// The predefined base of a COB-ID in an EDS that is in the predefined connection set but has no
    /// node-ID. A DCF describes one node and may contain numbers.
    pub(crate) fn base_without_node_id(&self, cob_id: &CobIdUse) -> Option<u16> {
        let base = match cob_id.service {
            CobIdService::Emcy => predefined::EMCY,
            CobIdService::Pdo(kind, number) => kind.predefined_can_id(number)?,
            _ => return None,
        };
        let fixed = self.device.kind == DeviceKind::Type && !cob_id.cob_id.depends_on_node_id();
        let is_number =
            fixed && !cob_id.cob_id.is_extended() && cob_id.is_in_use() && cob_id.wrong_bits() == 0;
        let in_set = (u32::from(base)..=u32::from(base) + 127).contains(&cob_id.cob_id.can_id(0));
        (is_number && in_set).then_some(base)
    }
}

impl Facts<'_> {
    /// The other service that owns the CAN-ID of an active service on a node, if there is one. SDO channels
    /// may use the identifiers of other nodes' default SDOs, which then own them.
    pub(crate) fn owner(&self, cob_id: &CobIdUse, node: u8) -> Option<&'static str> {
        let is_readable = cob_id.is_in_use() && !cob_id.cob_id.is_extended() && cob_id.wrong_bits() == 0;
        let can_id = cob_id.cob_id.can_id(node);
        let by_right = match cob_id.service {
            CobIdService::ServerRequest(1) | CobIdService::ServerResponse(1) => true,
            CobIdService::ServerRequest(_)
            | CobIdService::ServerResponse(_)
            | CobIdService::ClientRequest(_)
            | CobIdService::ClientResponse(_) => (0x580..0x680).contains(&can_id),
            _ => false,
        };
        if !is_readable || by_right || self.base_without_node_id(cob_id).is_some() {
            return None;
        }
        restricted(can_id)
    }

    /// Whether another service owns the CAN-ID of a service on every node that the description applies to.
    pub(crate) fn is_restricted(&self, cob_id: &CobIdUse) -> bool {
        self.node_ids().all(|node| self.owner(cob_id, node).is_some())
    }
}

impl Facts<'_> {
    /// The owner of the CAN-ID of an active PDO or additional SDO channel in the predefined connection set,
    /// if it is SYNC, TIME or EMCY. `None` if a service of the device also uses the CAN-ID, which other
    /// rules report.
    pub(crate) fn foreign_service(&self, cob_id: &CobIdUse) -> Option<&'static str> {
        let node = *self.node_ids().start();
        let is_fixed = matches!(
            cob_id.service,
            CobIdService::Sync | CobIdService::Time | CobIdService::Emcy | CobIdService::EmcyConsumer
        );
        let is_readable = cob_id.is_in_use() && !cob_id.cob_id.is_extended() && cob_id.wrong_bits() == 0;
        let can_id = cob_id.cob_id.can_id(node);
        let owner = match can_id {
            0x80 => "SYNC",
            0x81..=0xFF => "an EMCY",
            0x100 => "TIME",
            _ => return None,
        };
        (is_readable && !is_fixed && !self.is_shared(cob_id)).then_some(owner)
    }

    /// Whether another active service of the device uses the same CAN-ID, in either direction.
    pub(crate) fn is_shared(&self, cob_id: &CobIdUse) -> bool {
        let node = *self.node_ids().start();
        let is_type = self.device.node_id().is_none();
        let key = |one: &CobIdUse| (is_type && one.cob_id.depends_on_node_id(), one.cob_id.can_id(node));
        let others =
            self.cob_ids.iter().filter(|other| (other.index, other.sub) != (cob_id.index, cob_id.sub));
        others.filter(|other| other.is_in_use()).any(|other| key(other) == key(cob_id))
    }

    /// The two COB-IDs of each SDO channel: from client to server, from server to client.
    pub(crate) fn sdo_channels(&self) -> impl Iterator<Item = (&CobIdUse, &CobIdUse)> {
        self.cob_ids.windows(2).filter_map(|pair| match pair {
            [request, response] if request.index == response.index => match request.service {
                CobIdService::ServerRequest(_) | CobIdService::ClientRequest(_) => Some((request, response)),
                _ => None,
            },
            _ => None,
        })
    }
}

impl<'a> PdoFacts<'a> {
    fn new(device: &'a Device, pdo: Pdo<'a>) -> Self {
        let used = pdo.used_slots().filter_map(|slot| Some((slot.sub, slot.object?)));
        let used = used.filter(|(_, object)| !object.is_unused());
        let mapped =
            used.map(|(slot, object)| MappingFact { slot, object, target: target(device, object) }).collect();
        Self { pdo, mapped }
    }

    /// The communication parameter, if it is described as a RECORD.
    pub(crate) fn communication_record(&self) -> Option<&'a Object> {
        self.pdo.communication.filter(|object| !object.orphan && object.object_type().has_subs())
    }

    /// The COB-ID, if it is stated.
    pub(crate) fn cob_id(&self) -> Option<CobIdUse> {
        let (index, service) =
            (self.pdo.communication_index(), CobIdService::Pdo(self.pdo.kind, self.pdo.number));
        self.pdo.cob_id.map(|cob_id| CobIdUse { index, sub: 1, service, cob_id })
    }

    /// Whether all mapped objects are described and have the mapped length, so that their total is
    /// meaningful.
    pub(crate) fn lengths_are_right(&self) -> bool {
        self.mapped.iter().all(|mapped| mapped.wrong_length().is_none() && !mapped.target.is_missing())
    }
}

impl MappingFact<'_> {
    /// The correct length, if the mapped one differs.
    pub(crate) fn wrong_length(&self) -> Option<u8> {
        let MappedTo::Entry(entry) = &self.target else { return None };
        entry.data_type?.bit_length().filter(|&bits| bits != self.object.bits)
    }

    /// The data type of the object if it has no fixed length. A string that has the length of the mapping
    /// can be mapped.
    pub(crate) fn variable_type(&self) -> Option<DataType> {
        let MappedTo::Entry(entry) = &self.target else { return None };
        let data_type = entry.data_type.filter(|data_type| stated::is_unmappable(data_type.kind()))?;
        let bytes = match entry.value() {
            Some(Value::Text(text)) => Some(text.len()),
            Some(Value::Bytes(bytes)) => Some(bytes.len()),
            _ => None,
        };
        let has_length = match (data_type.kind(), bytes) {
            (TypeKind::VisibleString | TypeKind::OctetString, Some(bytes)) => {
                bytes * 8 == usize::from(self.object.bits)
            }
            (TypeKind::OctetString, None) => {
                matches!(self.object.bits, 8..=64) && self.object.bits.is_multiple_of(8)
            }
            _ => false,
        };
        (!has_length).then_some(data_type)
    }
}

impl<'a> MappedTo<'a> {
    /// The target of a mapped object.
    #[cfg(feature = "catalogue")]
    pub(crate) fn of(device: &'a Device, mapped: MappedObject) -> Self {
        target(device, mapped)
    }

    /// Whether the target is not described.
    pub(crate) fn is_missing(&self) -> bool {
        matches!(self, Self::NoEntry | Self::NoObject)
    }
}

fn target(device: &Device, mapped: MappedObject) -> MappedTo<'_> {
    if mapped.is_dummy() {
        return MappedTo::Dummy;
    }
    let Some(object) = device.object(mapped.index) else {
        return if comes_from_elsewhere(device, mapped.index) {
            MappedTo::Elsewhere
        } else {
            MappedTo::NoObject
        };
    };
    if mapped.sub == 0 && (object.object_type().has_subs() || object.compact.is_some()) {
        return MappedTo::Count;
    }
    match object.entry(mapped.sub) {
        Some(entry) => MappedTo::Entry(entry),
        None if comes_from_elsewhere(device, mapped.index) => MappedTo::Elsewhere,
        None => MappedTo::NoEntry,
    }
}

/// Whether a module provides an object or new sub-indexes of it, or the index belongs to a dynamic channel.
fn comes_from_elsewhere(device: &Device, index: u16) -> bool {
    let by_module = device.modules.as_ref().is_some_and(|modules| {
        let mut modules = modules.supported.values();
        modules.any(|module| module.fixed.contains_key(&index) || module.extensions.contains_key(&index))
    });
    let network_variables = (0xA000..=0xBFFF).contains(&index) && device.dynamic_channels.is_some();
    by_module || network_variables
}

fn cob_ids(device: &Device, pdos: &[PdoFacts<'_>]) -> Vec<CobIdUse> {
    let mut uses = Vec::new();
    let mut take = |index: u16, sub: u8, service: CobIdService| {
        let cob_id = device.value(index, sub).and_then(|value| CobId::from_value(&value));
        uses.extend(cob_id.map(|cob_id| CobIdUse { index, sub, service, cob_id }));
    };
    take(0x1005, 0, CobIdService::Sync);
    take(0x1012, 0, CobIdService::Time);
    take(0x1014, 0, CobIdService::Emcy);
    if device.objects.contains_key(&0x1028) {
        (1..=127).for_each(|sub| take(0x1028, sub, CobIdService::EmcyConsumer));
    }
    for (&index, _) in device.objects.range(0x1200..=0x127F) {
        take(index, 1, CobIdService::ServerRequest(index - 0x1200 + 1));
        take(index, 2, CobIdService::ServerResponse(index - 0x1200 + 1));
    }
    for (&index, _) in device.objects.range(0x1280..=0x12FF) {
        take(index, 1, CobIdService::ClientRequest(index - 0x1280 + 1));
        take(index, 2, CobIdService::ClientResponse(index - 0x1280 + 1));
    }
    uses.extend(pdos.iter().filter_map(PdoFacts::cob_id));
    uses
}

impl CobIdUse {
    /// Whether the device sends or receives frames with the COB-ID. SYNC is always received.
    pub(crate) fn is_in_use(&self) -> bool {
        match self.service {
            CobIdService::Sync => true,
            CobIdService::Time => self.cob_id.bit_30() || !self.cob_id.is_valid(),
            // many stacks write 0, the CAN-ID of NMT, to an unused channel
            CobIdService::ServerRequest(_)
            | CobIdService::ServerResponse(_)
            | CobIdService::ClientRequest(_)
            | CobIdService::ClientResponse(_) => self.cob_id.is_valid() && self.cob_id != CobId::new(0),
            _ => self.cob_id.is_valid(),
        }
    }

    /// Whether the device sends frames with the COB-ID; otherwise it receives them.
    pub(crate) fn is_sent(&self) -> bool {
        match self.service {
            CobIdService::Sync | CobIdService::Time => self.cob_id.bit_30(),
            CobIdService::EmcyConsumer | CobIdService::ServerRequest(_) | CobIdService::ClientResponse(_) => {
                false
            }
            CobIdService::Emcy | CobIdService::ServerResponse(_) | CobIdService::ClientRequest(_) => true,
            CobIdService::Pdo(kind, _) => kind == PdoKind::Tpdo,
        }
    }

    /// The set bits that belong neither to the flags of the service nor to its CAN-ID.
    pub(crate) fn wrong_bits(&self) -> u32 {
        let reserved = match self.service {
            CobIdService::Emcy | CobIdService::EmcyConsumer => self.cob_id.number() & CobId::BIT_30,
            _ => 0,
        };
        self.cob_id.stray_bits() | reserved
    }
}

impl Sayable for CobIdService {
    fn argument(&self) -> Argument {
        match self {
            Self::Sync => "SYNC".argument(),
            Self::Time => "TIME".argument(),
            Self::Emcy => "EMCY".argument(),
            Self::EmcyConsumer => "EMCY consumer".argument(),
            Self::ServerRequest(number) | Self::ServerResponse(number) => {
                say!("SDO server {}", number).argument()
            }
            Self::ClientRequest(number) | Self::ClientResponse(number) => {
                say!("SDO client {}", number).argument()
            }
            Self::Pdo(kind, number) => say!("{} {}", kind, number).argument(),
        }
    }
}

/// Whether a sub-index exists without any value in the description, valid or invalid.
pub(crate) fn is_unstated(object: &Object, sub: u8) -> bool {
    if !object.has(sub) || object.value(sub).is_some() {
        return false;
    }
    let item = Field::Item(sub.into());
    let in_list = object.compact.as_ref().is_some_and(|compact| compact.invalid_values.get(&item).is_some());
    let entry = object.subs.get(sub).unwrap_or(&object.main);
    let unreadable = [Field::DefaultValue, Field::ParameterValue];
    !in_list && unreadable.iter().all(|field| entry.invalid_values.get(field).is_none())
}
