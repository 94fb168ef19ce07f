//! A network as tables: its nodes, its messages with their content, and its boot procedure.

mod boot;
mod downloads;
mod entries;

pub use self::boot::{BootPlan, BootStep};
pub use self::downloads::DownloadRow;
pub use self::entries::{CarriedEntry, LinkRow, MappedEntry};
use crate::Language;
use crate::compiled::{Compiled, PdoState, Slave};
use crate::messages::{Message, MessageId, Messages, Party, Service};
use crate::model::Device;
use crate::network::Network;
use crate::traffic::{Sync, Traffic, Uncounted};
use crate::unlinked::UnlinkedPdos;

/// A network and its behaviour, ready for display.
#[derive(Clone, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Overview {
    /// The language of the text.
    #[serde(skip)]
    pub language: Language,
    /// The name of the network.
    pub name: Option<String>,
    /// The bit rate in kbit/s.
    pub bit_rate: Option<u16>,
    /// The load by cyclic messages in thousandths of the bit rate, with maximum bit stuffing; `None` without a bit
    /// rate.
    pub load: Option<u64>,
    /// Messages that are not included in the load.
    pub uncounted: Uncounted,
    /// All nodes by node-ID; those without one are last.
    pub nodes: Vec<NodeRow>,
    /// The content of PDOs, by CAN-ID: a link for each receiver, and one without for a PDO that no node
    /// receives.
    pub links: Vec<LinkRow>,
    /// The PDOs that are valid by default and have no counterpart, by node.
    pub unlinked: Vec<UnlinkedRow>,
    /// All messages by CAN-ID, so in order of priority.
    pub messages: Vec<MessageRow>,
    /// How the manager boots the network; `None` without a manager.
    pub boot: Option<BootPlan>,
}

/// A node.
#[derive(Clone, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NodeRow {
    /// The node-ID.
    pub node_id: Option<u8>,
    /// The name in the network.
    pub name: String,
    /// The product name in the description, otherwise its file.
    pub description: String,
    /// Whether the node boots the others.
    pub is_manager: bool,
    /// The producer heartbeat time in milliseconds; 0: none.
    pub heartbeat: u16,
    /// The guard time in milliseconds; 0: none.
    pub guard_time: u16,
    /// How many downloads configure the node.
    pub downloads: usize,
    /// The size of its concise DCF in bytes; 0 without downloads.
    pub bytes: usize,
    /// These downloads, in the order of transmission.
    pub configuration: Vec<DownloadRow>,
    /// The position in [`Network::nodes`].
    #[serde(skip)]
    pub position: usize,
}

/// The PDOs of a node that have their default configuration, and that no other node sends or receives.
#[derive(Clone, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct UnlinkedRow {
    /// The name of the node.
    pub node: String,
    /// The position in [`Network::nodes`].
    #[serde(skip)]
    pub position: usize,
    /// RPDOs, then TPDOs, by CAN-ID.
    pub pdos: Vec<UnlinkedEnd>,
}

/// A PDO without a counterpart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct UnlinkedEnd {
    /// The CAN-ID.
    pub can_id: MessageId,
    /// The PDO: `TPDO 1`.
    pub service: Service,
}

/// A message on the bus.
#[derive(Clone, Debug, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MessageRow {
    /// The CAN-ID.
    pub can_id: MessageId,
    /// Who sends it.
    pub senders: Vec<End>,
    /// Who receives it.
    pub receivers: Vec<End>,
    /// The maximum length in bytes; `None` if the description does not state it.
    pub bytes: Option<u8>,
    /// The lengths of several senders, in their order, if they differ; otherwise empty.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub lengths: Vec<u8>,
    /// Its trigger, as text.
    pub trigger: String,
    /// The minimum interval in microseconds; `None` for aperiodic messages.
    pub period: Option<u64>,
}

impl MessageRow {
    /// Its length as text; one for each sender if they differ.
    pub fn length(&self) -> String {
        match self.lengths.as_slice() {
            [] => self.bytes.map(|bytes| bytes.to_string()).unwrap_or_default(),
            lengths => lengths.iter().map(u8::to_string).collect::<Vec<_>>().join(", "),
        }
    }
}

/// A node that sends or receives a message.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct End {
    /// The name of the node.
    pub node: String,
    /// The position in [`Network::nodes`].
    #[serde(skip)]
    pub position: usize,
    /// The service that it uses: `TPDO 1`, `SYNC`.
    pub service: Service,
}

impl End {
    pub(crate) fn new(network: &Network, party: &Party) -> Self {
        Self {
            node: network.nodes[party.node].name.value.clone(),
            position: party.node,
            service: party.service,
        }
    }
}

// `TPDO 1 of drive`.
objdict_model::messages! { End: { Self { service, node, .. } => "{service} of {node}"; } }

impl Overview {
    /// The tables of a network in English.
    pub fn new(network: &Network, compiled: &Compiled) -> Self {
        Self::in_language(network, compiled, Language::default().tag())
    }

    /// The tables with the names of entries in a language, if a description has it (RFC 5646, such as `de`). Other text
    /// is in that language if objdict supports it ([`Language::of_tag`]), otherwise in English.
    pub fn in_language(network: &Network, compiled: &Compiled, tag: &str) -> Self {
        let messages = Messages::new(network, compiled);
        let language = Language::of_tag(tag).unwrap_or_default();
        let view = ConfiguredNetwork { network, compiled, tag, language };
        let traffic = Traffic { network, compiled, messages: &messages };
        let sync = traffic.sync();
        let row = |(can_id, message): (&MessageId, &Message)| view.message(*can_id, message, sync.as_ref());
        let nodes = view.nodes();
        Self {
            language,
            name: network.name.clone(),
            bit_rate: network.bit_rate.map(|rate| rate.value),
            load: traffic.load(),
            uncounted: traffic.uncounted(),
            boot: network.manager.as_ref().map(|manager| BootPlan::new(manager, view, &nodes)),
            nodes,
            links: messages.0.iter().flat_map(|(can_id, message)| view.links(*can_id, message)).collect(),
            unlinked: view.unlinked(&messages),
            messages: messages.0.iter().map(row).collect(),
        }
    }
}

impl Overview {
    /// Whether an end without a counterpart is one of the [`unlinked`](Self::unlinked) PDOs.
    pub fn is_unlinked(&self, can_id: MessageId, end: &End) -> bool {
        let pdo = UnlinkedEnd { can_id, service: end.service };
        self.unlinked.iter().any(|row| row.position == end.position && row.pdos.contains(&pdo))
    }
}

/// A network with the configuration of its nodes.
#[derive(Clone, Copy)]
struct ConfiguredNetwork<'n> {
    network: &'n Network,
    compiled: &'n Compiled,
    /// The language of the names of entries.
    tag: &'n str,
    /// The language of other text.
    language: Language,
}

impl<'n> ConfiguredNetwork<'n> {
    fn nodes(self) -> Vec<NodeRow> {
        let rows = self.network.nodes.iter().enumerate().map(|(position, node)| {
            let slave = self.compiled.node(position);
            let configured = slave.filter(|_| !self.network.is_made(position));
            let sent = configured.map(Slave::arranged_or_stated).filter(|sent| !sent.0.is_empty());
            NodeRow {
                node_id: node.node_id.map(|node_id| node_id.value),
                name: node.name.value.clone(),
                description: product_name(&node.device).unwrap_or(&node.file.value).to_owned(),
                is_manager: self.network.is_manager(position),
                heartbeat: slave.map_or(0, |slave| slave.heartbeat),
                guard_time: slave.map_or(0, |slave| slave.guard_time),
                downloads: sent.map_or(0, |sent| sent.0.len()),
                bytes: sent.and_then(|sent| sent.write().ok()).map_or(0, |bytes| bytes.len()),
                configuration: slave
                    .zip(sent)
                    .map_or_else(Vec::new, |(slave, sent)| self.downloads(&slave.device, sent)),
                position,
            }
        });
        let mut rows: Vec<NodeRow> = rows.collect();
        rows.sort_by_key(|row| row.node_id.unwrap_or(u8::MAX));
        rows
    }

    fn unlinked(self, messages: &Messages) -> Vec<UnlinkedRow> {
        let mut rows: Vec<UnlinkedRow> = Vec::new();
        for ((position, _), pdos) in UnlinkedPdos::new(self.network, self.compiled, messages).default {
            let pdos = pdos.iter().map(|pdo| UnlinkedEnd { can_id: pdo.can_id, service: pdo.party.service });
            match rows.last_mut().filter(|row| row.position == position) {
                Some(row) => row.pdos.extend(pdos),
                None => {
                    let node = self.network.nodes[position].name.value.clone();
                    rows.push(UnlinkedRow { node, position, pdos: pdos.collect() });
                }
            }
        }
        rows
    }

    fn end(self, party: &Party) -> End {
        End::new(self.network, party)
    }

    fn message(self, can_id: MessageId, message: &Message, sync: Option<&Sync>) -> MessageRow {
        let ends = |parties: &[Party]| parties.iter().map(|party| self.end(party)).collect();
        let mut parties = message.senders.iter().chain(&message.receivers);
        let pdo = parties.clone().find_map(|party| self.compiled.pdo(party));
        let (bytes, trigger, period) = match (pdo, parties.next()) {
            (Some(pdo), _) => (u8::try_from(pdo.bytes()).ok(), self.triggered(pdo), pdo.period(sync)),
            (None, Some(party)) => self.service(message, party, sync),
            (None, None) => (None, String::new(), None),
        };
        let length = |party| u8::try_from(self.compiled.pdo(party)?.bytes()).ok();
        let mut lengths: Vec<u8> = message.senders.iter().filter_map(length).collect();
        if lengths.iter().all(|length| *length == lengths[0]) {
            lengths.clear();
        }
        MessageRow {
            can_id,
            senders: ends(&message.senders),
            receivers: ends(&message.receivers),
            bytes: lengths.iter().copied().max().or(bytes),
            lengths,
            trigger,
            period,
        }
    }

    /// Length, trigger and period of a message that is not a PDO.
    fn service(
        self,
        message: &Message,
        party: &Party,
        sync: Option<&Sync>,
    ) -> (Option<u8>, String, Option<u64>) {
        let said = |english: &str, german: &str| self.language.pick(english, german).to_owned();
        match party.service {
            Service::Nmt => (Some(2), said("a command", "ein Kommando"), None),
            Service::Sync => {
                let bytes = sync.and_then(|sync| u8::try_from(sync.bytes).ok());
                (bytes, said("cyclic", "zyklisch"), sync.map(|sync| sync.period))
            }
            Service::Time => (Some(6), said("the application", "die Anwendung"), None),
            Service::Emcy => (Some(8), said("an error", "ein Fehler"), None),
            Service::SdoRequest | Service::SdoResponse => {
                (Some(8), said("an SDO transfer", "ein SDO-Transfer"), None)
            }
            Service::ErrorControl => self.error_control(message),
            Service::Pdo(_) => (None, String::new(), None),
        }
    }

    fn error_control(self, message: &Message) -> (Option<u8>, String, Option<u64>) {
        let slave = message.senders.first().and_then(|party| self.compiled.node(party.node));
        let times = slave.map(|slave| (slave.heartbeat, slave.guard_time));
        let (trigger, time) = match times.unwrap_or_default() {
            (0, 0) => return (Some(1), self.language.pick("boot-up", "Boot-up").to_owned(), None),
            (0, time) => (self.language.pick("guarding", "Guarding"), time),
            (time, _) => (self.language.pick("cyclic", "zyklisch"), time),
        };
        (Some(1), trigger.to_owned(), Some(u64::from(time) * 1000))
    }

    /// The trigger of a PDO, in the notation of the settings: `sync/1`, `event, inhibit 5 ms`.
    fn triggered(self, pdo: &PdoState) -> String {
        let kind = match pdo.transmission {
            number @ 0..=240 => format!("sync/{number}"),
            252 => "rtr-sync".to_owned(),
            253 => "rtr".to_owned(),
            254 => "event-vendor".to_owned(),
            255 => "event".to_owned(),
            number => format!("{} {number}", self.language.pick("reserved type", "reservierter Typ")),
        };
        let mut words = vec![kind];
        if pdo.inhibit_time != 0 && pdo.transmission >= 254 {
            let (whole, tenth) = (pdo.inhibit_time / 10, pdo.inhibit_time % 10);
            let fraction = if tenth == 0 { String::new() } else { format!(".{tenth}") };
            words.push(format!("{} {whole}{fraction} ms", self.language.pick("inhibit", "Inhibit-Time")));
        }
        if pdo.event_timer != 0 && pdo.transmission >= 254 {
            words.push(format!("{} {} ms", self.language.pick("timer", "Event-Timer"), pdo.event_timer));
        }
        words.join(", ")
    }
}

/// The name of the product, if there is one.
fn product_name(device: &Device) -> Option<&str> {
    let name = device.device_info.as_ref()?.product_name.as_deref()?.trim();
    (!name.is_empty()).then_some(name)
}
