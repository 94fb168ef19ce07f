//! The senders and receivers of each CAN-ID.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::{Serialize, Serializer};

use crate::Language;
use crate::compiled::{Compiled, PdoState, Slave, indexes};
use crate::configure::PdoName;
use crate::model::{CobId, Object, PdoKind, SdoChannel, predefined};
use crate::network::{Manager, Network};
use crate::source::Span;

const NMT: MessageId = MessageId::base(predefined::NMT as u32);

/// A CAN-ID; base frames before extended ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MessageId {
    /// Whether it has 29 bits.
    pub is_extended: bool,
    /// The bits.
    pub number: u32,
}

impl MessageId {
    /// The CAN-ID of 11 bits of a service.
    pub(crate) const fn base(number: u32) -> Self {
        Self { is_extended: false, number }
    }

    fn of(cob_id: u32) -> Self {
        let cob_id = CobId::new(cob_id);
        Self { is_extended: cob_id.is_extended(), number: cob_id.can_id(0) }
    }
}

/// `18Bh`, `1ABCDEFFh`.
impl std::fmt::Display for MessageId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let width = if self.is_extended { 8 } else { 3 };
        write!(f, "{:0width$X}h", self.number)
    }
}

/// `"0x18B"`, `"0x1ABCDEFF"`.
impl Serialize for MessageId {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let width = if self.is_extended { 10 } else { 5 };
        serializer.collect_str(&format_args!("{:#0width$X}", self.number))
    }
}

impl Serialize for Service {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(feature = "schema")]
objdict_model::inline_schemas! {
    MessageId: |_| schemars::json_schema!({ "type": "string", "pattern": "^0x([0-9A-F]{3}|[0-9A-F]{8})$" });
    Service: |_| schemars::json_schema!({ "type": "string" });
}

/// A service of CiA 301, as one node uses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Service {
    /// NMT commands.
    Nmt,
    /// SYNC.
    Sync,
    /// TIME.
    Time,
    /// EMCY.
    Emcy,
    /// A PDO of the node.
    Pdo(PdoName),
    /// The request of an SDO channel.
    SdoRequest,
    /// The response of an SDO channel.
    SdoResponse,
    /// Heartbeat, boot-up and guarding.
    ErrorControl,
}

impl Service {
    /// A PDO of a node.
    pub const fn pdo(kind: PdoKind, number: u16) -> Self {
        Self::Pdo(PdoName { kind, number })
    }

    /// `TPDO 1`, `SDO request`.
    pub fn name(self, language: Language) -> Cow<'static, str> {
        Cow::Borrowed(match self {
            Self::Pdo(PdoName { kind, number }) => return Cow::Owned(format!("{kind} {number}")),
            Self::Nmt => "NMT",
            Self::Sync => "SYNC",
            Self::Time => "TIME",
            Self::Emcy => "EMCY",
            Self::SdoRequest => language.pick("SDO request", "SDO-Anfrage"),
            Self::SdoResponse => language.pick("SDO response", "SDO-Antwort"),
            Self::ErrorControl => language.pick("heartbeat", "Heartbeat"),
        })
    }
}

// The name in English.
objdict_model::messages! { Service: { service => "{}", service.name(Language::English); } }

/// A node that sends or receives a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Party {
    /// Its position in [`Network::nodes`].
    pub node: usize,
    /// The service that it uses.
    pub service: Service,
    /// The position in the network file, at least of the node's name.
    pub at: Span,
}

/// A CAN-ID with its senders and receivers.
#[derive(Clone, Debug, Default)]
pub struct Message {
    /// Who sends it: one, where the network is sound.
    pub senders: Vec<Party>,
    /// Who receives it.
    pub receivers: Vec<Party>,
}

/// All messages of a network by CAN-ID, which is also their priority.
#[derive(Clone, Debug, Default)]
pub struct Messages(pub BTreeMap<MessageId, Message>);

impl Messages {
    /// The messages on the bus after the configuration.
    pub fn new(network: &Network, compiled: &Compiled) -> Self {
        let mut messages = Self::default();
        messages.nmt(network);
        for slave in compiled.nodes() {
            messages.node(network, slave);
        }
        if let Some(manager) = &network.manager {
            messages.manager(manager, compiled);
        }
        messages.other_sync(network, compiled);
        messages
    }

    /// Nodes that expect SYNC with a CAN-ID that no node uses for it.
    fn other_sync(&mut self, network: &Network, compiled: &Compiled) {
        let is_sync = |message: &Message| message.senders.iter().any(|party| party.service == Service::Sync);
        let sent: Vec<MessageId> =
            self.0.iter().filter(|(_, message)| is_sync(message)).map(|(can_id, _)| *can_id).collect();
        for slave in compiled.nodes().filter(|_| !sent.is_empty()) {
            let own = slave.sync_can_id().filter(|own| own.number != 0 && !sent.contains(own));
            let Some(own) = own else { continue };
            let at = slave.said(0x1005, 0).unwrap_or(network.nodes[slave.node].name.at);
            self.receive(own, Party { node: slave.node, service: Service::Sync, at });
        }
    }

    fn send(&mut self, can_id: MessageId, party: Party) {
        add(&mut self.0.entry(can_id).or_default().senders, party);
    }

    fn receive(&mut self, can_id: MessageId, party: Party) {
        add(&mut self.0.entry(can_id).or_default().receivers, party);
    }

    fn node(&mut self, network: &Network, slave: &Slave) {
        let node = &network.nodes[slave.node];
        let at = node.node_id.map_or(node.name.at, |node_id| node_id.at);
        let party = |service| Party { node: slave.node, service, at };
        for state in slave.pdos.iter().filter(|state| state.is_active()) {
            let said = node.pdos.iter().find(|request| request.pdo == state.pdo);
            let requested = || said.map(|request| request.cob_id.map_or(request.at, |cob_id| cob_id.at));
            let at = slave.said(indexes(state.pdo).0, 1).or_else(requested).unwrap_or(node.name.at);
            let party = Party { at, ..party(Service::Pdo(state.pdo)) };
            match state.pdo.kind {
                PdoKind::Tpdo => self.send(state.can_id(), party),
                PdoKind::Rpdo => self.receive(state.can_id(), party),
            }
        }
        self.services(slave, &party);
    }

    /// SYNC, TIME, EMCY, SDO and error control of a node.
    fn services(&mut self, slave: &Slave, party: &dyn Fn(Service) -> Party) {
        let services = slave.services();
        let number = |cob_id: CobId| cob_id.on_node(slave.node_id);
        let stated = |service, (index, sub)| {
            let party = party(service);
            Party { at: slave.said(index, sub).unwrap_or(party.at), ..party }
        };
        if let Some((sync, can_id)) = services.sync.zip(slave.sync_can_id()) {
            if sync.bit_30() && services.communication_cycle_period.unwrap_or(0) != 0 {
                self.send(can_id, stated(Service::Sync, (0x1005, 0)));
            } else if slave.pdos.iter().any(|state| state.is_active() && state.is_synchronous()) {
                self.receive(can_id, stated(Service::Sync, (0x1005, 0)));
            }
        }
        if let Some(time) = services.time.map(number) {
            if time & CobId::BIT_30 != 0 {
                self.send(MessageId::of(time), stated(Service::Time, (0x1012, 0)));
            }
            if time & CobId::BIT_31 != 0 {
                self.receive(MessageId::of(time), stated(Service::Time, (0x1012, 0)));
            }
        }
        if let Some(emcy) = slave.emcy {
            self.send(MessageId::of(emcy), stated(Service::Emcy, (0x1014, 0)));
        }
        let of_node = |base: u16| MessageId::base(u32::from(base) + u32::from(slave.node_id));
        self.receive(of_node(predefined::SDO_REQUEST), party(Service::SdoRequest));
        self.send(of_node(predefined::SDO_RESPONSE), party(Service::SdoResponse));
        for SdoCanId { can_id, entry, is_sent } in slave.sdo_channels() {
            let service = if entry.1 == 1 { Service::SdoRequest } else { Service::SdoResponse };
            match is_sent {
                true => self.send(can_id, stated(service, entry)),
                false => self.receive(can_id, stated(service, entry)),
            }
        }
        self.send(of_node(predefined::ERROR_CONTROL), party(Service::ErrorControl));
        for consumer in &services.heartbeat_consumers {
            let watched = u32::from(predefined::ERROR_CONTROL) + u32::from(consumer.node_id);
            self.receive(MessageId::base(watched), party(Service::ErrorControl));
        }
        let emergencies = slave.device.object(0x1028).into_iter().flat_map(Object::entries);
        for (_, entry) in emergencies.filter(|(sub, _)| (1..=127).contains(sub)) {
            let cob_id = entry.value().and_then(CobId::from_value);
            // 0 is NMT, and in many descriptions the value of unused entries
            if let Some(cob_id) = cob_id.map(number).filter(|cob_id| cob_id >> 31 == 0 && *cob_id != 0) {
                self.receive(MessageId::of(cob_id), party(Service::Emcy));
            }
        }
    }

    /// NMT commands, which only the manager may send.
    fn nmt(&mut self, network: &Network) {
        let Some(manager) = &network.manager else { return };
        let Some(own) = manager.node else { return };
        let party = |node| Party { node, service: Service::Nmt, at: manager.name.at };
        self.send(NMT, party(own));
        network.slaves().for_each(|(position, _)| self.receive(NMT, party(position)));
    }

    /// The manager configures the nodes, with the default SDO of each.
    fn manager(&mut self, manager: &Manager, compiled: &Compiled) {
        let Some(node) = manager.node else { return };
        let party = |service| Party { node, service, at: manager.name.at };
        for slave in &compiled.slaves {
            let of_node = |base: u16| MessageId::base(u32::from(base) + u32::from(slave.node_id));
            self.send(of_node(predefined::SDO_REQUEST), party(Service::SdoRequest));
            self.receive(of_node(predefined::SDO_RESPONSE), party(Service::SdoResponse));
        }
    }
}

/// Adds a party unless it exists: the manager may also list the SDO channels that it uses in 1280h and up.
fn add(parties: &mut Vec<Party>, party: Party) {
    if parties.iter().all(|other| (other.node, other.service) != (party.node, party.service)) {
        parties.push(party);
    }
}

/// The CAN-ID of a request or response of an SDO channel.
pub(crate) struct SdoCanId {
    pub(crate) can_id: MessageId,
    /// Index and sub-index of the entry that has it: 1 for the request, 2 for the response.
    pub(crate) entry: (u16, u8),
    /// Whether the node sends it.
    is_sent: bool,
}

impl Slave {
    /// The CAN-ID of SYNC (1005h).
    pub(crate) fn sync_can_id(&self) -> Option<MessageId> {
        Some(MessageId::of(self.services().sync?.on_node(self.node_id)))
    }

    /// The valid SDO channels of the node, without the default one that every node has.
    pub(crate) fn sdo_channels(&self) -> Vec<SdoCanId> {
        let can_id = |cob_id: Option<CobId>| {
            let cob_id = cob_id.filter(|cob_id| cob_id.is_valid())?;
            Some(MessageId::of(cob_id.on_node(self.node_id))).filter(|can_id| can_id.number != 0)
        };
        let services = self.services();
        let servers = services.sdo_servers.iter().filter(|server| server.number > 1);
        let channels = servers.map(|server| (server, false));
        let channels = channels.chain(services.sdo_clients.iter().map(|client| (client, true)));
        let valid = channels.filter_map(|(SdoChannel { index, request, response, .. }, is_client)| {
            let (request, response) = can_id(*request).zip(can_id(*response))?;
            Some([
                SdoCanId { can_id: request, entry: (*index, 1), is_sent: is_client },
                SdoCanId { can_id: response, entry: (*index, 2), is_sent: !is_client },
            ])
        });
        valid.flatten().collect()
    }
}

impl PdoState {
    /// Whether the PDO is finally enabled and not empty.
    pub fn is_active(&self) -> bool {
        self.cob_id >> 31 == 0 && self.is_enabled && !self.mapping.is_empty()
    }

    /// Its CAN-ID.
    pub fn can_id(&self) -> MessageId {
        MessageId::of(self.cob_id)
    }

    /// Whether SYNC triggers it.
    pub fn is_synchronous(&self) -> bool {
        self.transmission <= 240 || self.transmission == 252 && self.pdo.kind == PdoKind::Tpdo
    }

    /// The bits that it carries.
    pub fn bits(&self) -> u32 {
        self.mapping.values().map(|object| u32::from(object.bits)).sum()
    }
}

impl Compiled {
    /// The PDO that a party sends or receives.
    pub(crate) fn pdo(&self, party: &Party) -> Option<&PdoState> {
        let Service::Pdo(pdo) = party.service else { return None };
        self.node(party.node)?.pdos.iter().find(|state| state.pdo == pdo)
    }
}
