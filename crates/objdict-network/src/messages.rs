//! Who sends and who receives which CAN-ID.

use std::borrow::Cow;
use std::collections::BTreeMap;

use crate::Language;
use crate::configure::PdoName;
use crate::model::{CobId, Object, PdoKind, predefined};
use crate::network::{Manager, Network};
use crate::source::Span;
use crate::stream::{Compiled, PdoState, Slave, indexes};

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
    /// A PDO that the manager has the other side of, without a number that anybody has to know.
    MirroredPdo,
    /// The request of the default SDO.
    SdoRequest,
    /// The response of the default SDO.
    SdoResponse,
    /// Heartbeat, boot-up and guarding.
    ErrorControl,
}

impl Service {
    /// `TPDO 1`, `SDO request`.
    pub fn name(self, language: Language) -> Cow<'static, str> {
        Cow::Borrowed(match self {
            Self::Pdo(PdoName { kind, number }) => return Cow::Owned(format!("{kind} {number}")),
            Self::Nmt => "NMT",
            Self::Sync => "SYNC",
            Self::Time => "TIME",
            Self::Emcy => "EMCY",
            Self::MirroredPdo => "PDO",
            Self::SdoRequest => language.pick("SDO request", "SDO-Anfrage"),
            Self::SdoResponse => language.pick("SDO response", "SDO-Antwort"),
            Self::ErrorControl => language.pick("heartbeat", "Heartbeat"),
        })
    }
}

/// The name in English.
impl std::fmt::Display for Service {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.name(Language::English))
    }
}

/// A node that sends or receives a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Party {
    /// Its position in [`Network::nodes`]; `None` for a manager without a description.
    pub node: Option<usize>,
    /// With which of its services.
    pub service: Service,
    /// Where the network file says so, at least the name of the node.
    pub at: Span,
}

/// A CAN-ID with those who use it.
#[derive(Clone, Debug, Default)]
pub struct Message {
    /// Who sends it: one, where the network is sound.
    pub senders: Vec<Party>,
    /// Who receives it.
    pub receivers: Vec<Party>,
}

/// All messages of a network by their CAN-IDs, which are their priorities too.
#[derive(Clone, Debug, Default)]
pub struct Messages(pub BTreeMap<MessageId, Message>);

impl Messages {
    /// What goes over the bus after the configuration.
    pub fn new(network: &Network, compiled: &Compiled) -> Self {
        let mut messages = Self::default();
        for slave in compiled.nodes() {
            messages.node(network, slave);
        }
        if let Some(manager) = &network.manager {
            messages.manager(manager, compiled);
        }
        messages
    }

    fn send(&mut self, can_id: MessageId, party: Party) {
        self.0.entry(can_id).or_default().senders.push(party);
    }

    fn receive(&mut self, can_id: MessageId, party: Party) {
        self.0.entry(can_id).or_default().receivers.push(party);
    }

    fn node(&mut self, network: &Network, slave: &Slave) {
        let node = &network.nodes[slave.node];
        let at = node.node_id.map_or(node.name.at, |node_id| node_id.at);
        let party = |service| Party { node: Some(slave.node), service, at };
        for state in slave.pdos.iter().filter(|state| state.is_active()) {
            let said = node.pdos.iter().find(|wish| wish.pdo == state.pdo);
            let wished = || said.map(|wish| wish.cob_id.map_or(wish.at, |cob_id| cob_id.at));
            let at = slave.said(indexes(state.pdo).0, 1).or_else(wished).unwrap_or(node.name.at);
            let party = Party { at, ..party(Service::Pdo(state.pdo)) };
            match state.pdo.kind {
                PdoKind::Tpdo => self.send(state.can_id(), party),
                PdoKind::Rpdo => self.receive(state.can_id(), party),
            }
        }
        self.services(slave, &party);
    }

    /// SYNC, TIME, EMCY, SDO and error control of a described node.
    fn services(&mut self, slave: &Slave, party: &dyn Fn(Service) -> Party) {
        let services = slave.device.services();
        let number = |cob_id: CobId| cob_id.on_node(slave.node_id);
        let stated = |service, index| {
            let party = party(service);
            Party { at: slave.said(index, 0).unwrap_or(party.at), ..party }
        };
        if let Some(sync) = services.sync.map(number) {
            if sync & CobId::BIT_30 != 0 && services.communication_cycle_period.unwrap_or(0) != 0 {
                self.send(MessageId::of(sync), stated(Service::Sync, 0x1005));
            } else if slave.pdos.iter().any(|state| state.is_active() && state.is_synchronous()) {
                self.receive(MessageId::of(sync), stated(Service::Sync, 0x1005));
            }
        }
        if let Some(time) = services.time.map(number) {
            if time & CobId::BIT_30 != 0 {
                self.send(MessageId::of(time), stated(Service::Time, 0x1012));
            }
            if time & CobId::BIT_31 != 0 {
                self.receive(MessageId::of(time), stated(Service::Time, 0x1012));
            }
        }
        if let Some(emcy) = slave.emcy {
            self.send(MessageId::of(emcy), stated(Service::Emcy, 0x1014));
        }
        let node_id = u32::from(slave.node_id);
        self.receive(
            MessageId::base(u32::from(predefined::SDO_REQUEST) + node_id),
            party(Service::SdoRequest),
        );
        self.send(
            MessageId::base(u32::from(predefined::SDO_RESPONSE) + node_id),
            party(Service::SdoResponse),
        );
        self.send(
            MessageId::base(u32::from(predefined::ERROR_CONTROL) + node_id),
            party(Service::ErrorControl),
        );
        for consumer in services.heartbeat_consumers {
            let watched = u32::from(predefined::ERROR_CONTROL) + u32::from(consumer.node_id);
            self.receive(MessageId::base(watched), party(Service::ErrorControl));
        }
        let emergencies = slave.device.object(0x1028).into_iter().flat_map(Object::entries);
        for (_, entry) in emergencies.filter(|(sub, _)| (1..=127).contains(sub)) {
            let cob_id = entry.value().and_then(|value| CobId::from_value(value));
            // 0 is NMT, and the value of entries that are not in use in many descriptions
            if let Some(cob_id) = cob_id.map(number).filter(|cob_id| cob_id >> 31 == 0 && *cob_id != 0) {
                self.receive(MessageId::of(cob_id), party(Service::Emcy));
            }
        }
    }

    /// The other side of the manager: it configures the nodes and, without a description, has all of their PDOs.
    fn manager(&mut self, manager: &Manager, compiled: &Compiled) {
        let party = |service| Party { node: manager.node, service, at: manager.name.at };
        for slave in &compiled.slaves {
            let node_id = u32::from(slave.node_id);
            self.send(
                MessageId::base(u32::from(predefined::SDO_REQUEST) + node_id),
                party(Service::SdoRequest),
            );
            self.receive(
                MessageId::base(u32::from(predefined::SDO_RESPONSE) + node_id),
                party(Service::SdoResponse),
            );
            // a described manager has 1016h and 1028h
            if manager.node.is_some() {
                continue;
            }
            if manager.monitors_nodes() && slave.heartbeat != 0 {
                self.receive(
                    MessageId::base(u32::from(predefined::ERROR_CONTROL) + node_id),
                    party(Service::ErrorControl),
                );
            }
            if let Some(emcy) = slave.emcy {
                self.receive(MessageId::of(emcy), party(Service::Emcy));
            }
        }
        if manager.node.is_some() {
            return;
        }
        if manager.sync_period.value != 0 {
            let party = Party { at: manager.sync_period.at, ..party(Service::Sync) };
            self.send(MessageId::base(predefined::SYNC.into()), party);
        }
        if let Some(time) = manager.time_cob_id.filter(|time| time.value & CobId::BIT_30 != 0) {
            self.send(MessageId::of(time.value), Party { at: time.at, ..party(Service::Time) });
        }
        if let Some(node_id) = manager.node_id {
            let own = |base: u16| MessageId::base(u32::from(base) + u32::from(node_id.value));
            let party = |service| Party { at: node_id.at, ..party(service) };
            self.send(own(predefined::EMCY), party(Service::Emcy));
            self.send(own(predefined::ERROR_CONTROL), party(Service::ErrorControl));
        }
        // a CAN-ID that a node sends goes from node to node, and the manager listens
        let pdos = |message: &Message| {
            let is_pdo = |party: &&Party| matches!(party.service, Service::Pdo(_));
            (
                message.senders.iter().any(|party| is_pdo(&party)),
                message.receivers.iter().any(|party| is_pdo(&party)),
            )
        };
        for message in self.0.values_mut() {
            match pdos(message) {
                (true, _) => message.receivers.push(party(Service::MirroredPdo)),
                (false, true) => message.senders.push(party(Service::MirroredPdo)),
                (false, false) => {}
            }
        }
    }
}

impl PdoState {
    /// Whether the PDO is on in the end and carries something.
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
