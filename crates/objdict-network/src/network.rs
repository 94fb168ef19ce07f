//! The wanted network.

use std::collections::BTreeMap;

use crate::configure::{PdoName, Setting};
use crate::download::{ConciseDcf, Order};
use crate::model::{Address, Device};
pub use crate::source::Said;
use crate::source::Span;
use crate::{IdentityLevel, Link, NetworkLock};

/// The bit rate in kbit/s that dcfgen writes if its file does not state one.
const DCFGEN_BIT_RATE: u16 = 1000;

/// A network as its file describes it. Nodes are known by their positions in [`nodes`](Self::nodes).
#[derive(Clone, Debug, Default)]
pub struct Network {
    /// The name of the network.
    pub name: Option<String>,
    /// The bit rate in kbit/s.
    pub bit_rate: Option<Said<u16>>,
    /// The manager, which configures and starts the other nodes (CiA 302-2).
    pub manager: Option<Manager>,
    /// Whether the file contains a manager that cannot be read, so that it is missing for the other nodes.
    pub lacks_manager: bool,
    /// The nodes, in file order. A manager that the file does not describe is the last one once the network is
    /// resolved.
    pub nodes: Vec<Node>,
    /// The links between entries, in file order.
    pub links: Vec<Link>,
    /// The order in which Lely's master configures the nodes: dcfgen's for its files, which list downloads
    /// separately.
    pub order: Order,
    /// The numbers of the nodes that the manager checks; `None`: all stated ones.
    pub identity: Option<IdentityLevel>,
    /// The treatment of PDOs without a link and without a key; `None` keeps them.
    pub unused_pdos: Option<Said<UnusedPdos>>,
    /// The folder in which the running manager finds the nodes' configurations.
    pub run_time_folder: String,
    /// Whether the network consists of descriptions that are already configured, so that the manager's
    /// expectations are in its own description.
    pub is_as_described: bool,
    /// The PDOs of an earlier build, whose CAN-IDs and numbers are kept.
    pub lock: NetworkLock,
}

/// A node and its wanted configuration.
#[derive(Clone, Debug, Default)]
pub struct Node {
    /// The name, unique in the network.
    pub name: Said<String>,
    /// The file with its description, as the network file names it.
    pub file: Said<String>,
    /// The description, with plugged modules.
    pub device: Device,
    /// The node-ID from the network file, otherwise from the description; `None` without either.
    pub node_id: Option<Said<u8>>,
    /// Heartbeat, as producer and as consumer.
    pub heartbeat: Heartbeat,
    /// Guard time in milliseconds (100Ch) and life time factor (100Dh).
    pub guarding: (Option<Said<u16>>, Option<Said<u8>>),
    /// COB-ID of TIME (1012h).
    pub time_cob_id: Option<Said<u32>>,
    /// The reaction of the node to an error of each class (1029h), by sub-index.
    pub error_behavior: Vec<(u8, Said<u8>)>,
    /// PDOs, in the order of configuration: RPDOs before TPDOs.
    pub pdos: Vec<PdoRequest>,
    /// The treatment of PDOs without a link and without a key; `None`: as in the
    /// [network](Network::unused_pdos).
    pub unused_pdos: Option<Said<UnusedPdos>>,
    /// Settings implied by keys of the network, such as those of SYNC.
    pub implied: Vec<Said<Setting>>,
    /// Values by entry, checked like settings of `objdict configure`.
    pub settings: Vec<Said<Setting>>,
    /// Downloads at the end of the configuration, in this order, also of values that the node already has.
    pub downloads: Vec<Said<DownloadRequest>>,
    /// The configurations of the node in the manager's description. In a network that is as described, they are the
    /// last downloads.
    pub stored: Vec<Stored>,
    /// How the manager boots the node.
    pub boot: Boot,
    /// The numbers that the manager checks; `None`: as in the [network](Network::identity).
    pub identity: Option<IdentityLevel>,
    /// The expected revision number (1F87h).
    pub revision_number: Option<Said<u32>>,
    /// The expected serial number (1F88h).
    pub serial_number: Option<Said<u32>>,
    /// The folder of [`Network::run_time_folder`] for this node.
    pub run_time_folder: Option<String>,
}

/// A configuration for a node in the manager's description (CiA 302-3).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stored {
    /// The object of the manager: 1F20h for a DCF, 1F22h for a concise DCF.
    pub index: u16,
    /// Its downloads.
    pub downloads: ConciseDcf,
}

/// Heartbeat of a node.
#[derive(Clone, Debug, PartialEq)]
pub struct Heartbeat {
    /// Producer heartbeat time in milliseconds (1017h).
    pub producer: Option<Said<u16>>,
    /// The number of producer heartbeat times after which consumers consider the node lost.
    pub factor: f64,
    /// Whether the node monitors the manager; for the manager, whether it monitors the nodes.
    pub consumer: Option<Said<bool>>,
    /// Further nodes that it monitors.
    pub watched: Vec<Said<Watch>>,
}

impl Heartbeat {
    /// The default of dcfgen and most managers.
    pub const DEFAULT_FACTOR: f64 = 3.0;

    /// The consumer time for a producer time, both in milliseconds; `None` if it does not fit 1016h.
    pub fn consumer_time(&self, producer: u16) -> Option<u16> {
        let time = (f64::from(producer) * self.factor).trunc();
        // a float that is in range and whole converts without loss
        (0.0..=65535.0).contains(&time).then_some(time as u16)
    }
}

impl Default for Heartbeat {
    fn default() -> Self {
        Self { producer: None, factor: Self::DEFAULT_FACTOR, consumer: None, watched: Vec::new() }
    }
}

/// A node whose heartbeat is monitored.
#[derive(Clone, Debug, PartialEq)]
pub struct Watch {
    /// The name of the node.
    pub node: String,
    /// The consumer heartbeat time.
    pub time: WatchTime,
}

/// A consumer heartbeat time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WatchTime {
    /// A number of producer heartbeat times.
    Times(f64),
    /// Milliseconds.
    Milliseconds(u16),
}

/// A PDO and its requested configuration; `None` keeps the setting of the description.
#[derive(Clone, Debug, PartialEq)]
pub struct PdoRequest {
    /// The position in the network file.
    pub at: Span,
    /// The PDO.
    pub pdo: PdoName,
    /// Whether it is valid in the end.
    pub enabled: bool,
    /// COB-ID.
    pub cob_id: Option<Said<RequestedCobId>>,
    /// Transmission type.
    pub transmission: Option<Said<u8>>,
    /// Inhibit time in multiples of 100 µs.
    pub inhibit_time: Option<Said<u16>>,
    /// Event timer in milliseconds.
    pub event_timer: Option<Said<u16>>,
    /// The timeout of a receiver in milliseconds.
    pub deadline: Option<Said<u16>>,
    /// SYNC start value.
    pub sync_start: Option<Said<u8>>,
    /// The mapped entries; for an RPDO also data types as dummies.
    pub mapping: Option<Vec<Said<Address>>>,
}

impl PdoRequest {
    /// A PDO without changes.
    pub const fn new(pdo: PdoName, at: Span) -> Self {
        Self {
            at,
            pdo,
            enabled: true,
            cob_id: None,
            transmission: None,
            inhibit_time: None,
            event_timer: None,
            deadline: None,
            sync_start: None,
            mapping: None,
        }
    }

    /// Whether anything except the COB-ID is requested.
    pub fn has_parameters(&self) -> bool {
        let Self { transmission, inhibit_time, event_timer, deadline, sync_start, mapping, .. } = self;
        let has_time = inhibit_time.or(*event_timer).or(*deadline).is_some();
        has_time || transmission.or(*sync_start).is_some() || mapping.is_some()
    }
}

/// The treatment of a valid PDO that neither a link nor the network file refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnusedPdos {
    /// It is kept.
    Keep,
    /// A download switches it off.
    Off,
}

/// The COB-ID of a PDO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RequestedCobId {
    /// From the predefined connection set; a free one for PDO 5 and above.
    Auto,
    /// The value of sub-index 1, with its flags.
    Number(u32),
}

/// A download.
#[derive(Clone, Debug, PartialEq)]
pub struct DownloadRequest {
    /// The index of the object.
    pub index: u16,
    /// The sub-index of the entry.
    pub sub: u8,
    /// The value.
    pub value: RequestedValue,
}

/// A value as spelled in the network file; its type follows from the data type of the entry.
#[derive(Clone, Debug, PartialEq)]
pub enum RequestedValue {
    /// A whole number.
    Integer(i128),
    /// A number with a fraction.
    Real(f64),
    /// A string, spelled as in a DCF.
    Text(String),
}

/// How the manager boots a node (1F81h and related objects).
#[derive(Clone, Debug, PartialEq)]
pub struct Boot {
    /// Whether it configures and starts the node.
    pub boot: bool,
    /// Whether the network stops without the node.
    pub mandatory: bool,
    /// Whether it may reset the communication of a node that is operational.
    pub reset_communication: bool,
    /// How often an error control service may fail; for node guarding.
    pub retry_factor: Said<u8>,
    /// The program for the node (1F58h), as a file of the manager.
    pub software_file: Option<String>,
    /// The expected software identification (1F55h); 0 is not checked.
    pub software_version: Said<u32>,
    /// The sub-index of 1011h that restores the defaults before the configuration (1F8Ah); 0 restores none.
    pub restore_configuration: Said<u8>,
}

impl Boot {
    /// The value of 1F81h for the node; the guard time is in milliseconds (CiA 302-2). Without one the retry factor has no
    /// effect and is 0.
    pub fn to_number(&self, guard_time: u16) -> u32 {
        let retry_factor = if guard_time == 0 { 0 } else { self.retry_factor.value };
        1 | u32::from(self.boot) << 2
            | u32::from(self.mandatory) << 3
            | u32::from(!self.reset_communication) << 4
            | u32::from(self.software_version.value != 0) << 5
            | u32::from(self.software_file.is_some()) << 6
            | u32::from(self.restore_configuration.value != 0) << 7
            | u32::from(retry_factor) << 8
            | u32::from(guard_time) << 16
    }
}

impl Default for Boot {
    fn default() -> Self {
        Self {
            boot: true,
            mandatory: false,
            reset_communication: true,
            retry_factor: Said::new(3, Span::empty(0)),
            software_file: None,
            software_version: Said::default(),
            restore_configuration: Said::default(),
        }
    }
}

/// The manager. Times are in the units of its objects.
#[derive(Clone, Debug, Default)]
pub struct Manager {
    /// Its name in the network file.
    pub name: Said<String>,
    /// Its node-ID.
    pub node_id: Option<Said<u8>>,
    /// Its position in [`Network::nodes`]; `None` if the file does not describe it and the network is not resolved yet.
    pub node: Option<usize>,
    /// Whether the file does not describe it, so that its description is generated from the needs of the
    /// network.
    pub is_made: bool,
    /// Vendor-ID, product code and revision number (1018h).
    pub identity: [u32; 3],
    /// Serial number (1018h:04).
    pub serial_number: u32,
    /// Communication cycle period in microseconds (1006h); 0: no SYNC.
    pub sync_period: Said<u32>,
    /// Synchronous window length in microseconds (1007h).
    pub sync_window: Said<u32>,
    /// Synchronous counter overflow value (1019h).
    pub sync_overflow: Said<u8>,
    /// COB-ID of TIME (1012h).
    pub time_cob_id: Option<Said<u32>>,
    /// Inhibit time of EMCY in multiples of 100 µs (1015h).
    pub emcy_inhibit_time: u16,
    /// Inhibit time of NMT commands in multiples of 100 µs (102Ah).
    pub nmt_inhibit_time: u16,
    /// Its heartbeat; it monitors the nodes unless that is disabled.
    pub heartbeat: Heartbeat,
    /// Its reaction to an error of each class (1029h), by sub-index.
    pub error_behavior: BTreeMap<u8, u8>,
    /// How it starts the network.
    pub startup: Startup,
    /// The time in milliseconds in which all mandatory nodes must boot (1F89h); 0: unlimited.
    pub boot_time: Said<u32>,
}

impl Manager {
    /// Whether it monitors the heartbeats of the nodes.
    pub fn monitors_nodes(&self) -> bool {
        self.heartbeat.consumer.is_none_or(|consumer| consumer.value)
    }
}

/// NMT startup (1F80h).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Startup {
    /// Whether the manager becomes operational automatically.
    pub start: bool,
    /// Whether it starts the nodes.
    pub start_nodes: bool,
    /// Whether it starts all nodes by one command.
    pub start_all_nodes: bool,
    /// Whether it resets all nodes when a mandatory one fails.
    pub reset_all_nodes: bool,
    /// Whether it stops all nodes when a mandatory one fails.
    pub stop_all_nodes: bool,
}

impl Startup {
    /// The value of 1F80h of a manager (CiA 302-2).
    pub const fn to_number(self) -> u32 {
        1 | (self.start_all_nodes as u32) << 1
            | (!self.start as u32) << 2
            | (!self.start_nodes as u32) << 3
            | (self.reset_all_nodes as u32) << 4
            | (self.stop_all_nodes as u32) << 6
    }

    /// Decodes a value of 1F80h.
    pub const fn from_number(number: u32) -> Self {
        Self {
            start: number >> 2 & 1 == 0,
            start_nodes: number >> 3 & 1 == 0,
            start_all_nodes: number >> 1 & 1 != 0,
            reset_all_nodes: number >> 4 & 1 != 0,
            stop_all_nodes: number >> 6 & 1 != 0,
        }
    }
}

impl Default for Startup {
    fn default() -> Self {
        Self {
            start: true,
            start_nodes: true,
            start_all_nodes: false,
            reset_all_nodes: false,
            stop_all_nodes: false,
        }
    }
}

impl Network {
    /// Sets a missing bit rate: dcfgen's default for its files, otherwise the common one of all descriptions that state
    /// one.
    pub fn settle_bit_rate(&mut self) {
        let of_dcfgen = self.manager.as_ref().filter(|_| self.order == Order::Dcfgen);
        let of_dcfgen = of_dcfgen.map(|manager| Said::new(DCFGEN_BIT_RATE, manager.name.at));
        let stated = |node: &Node| {
            let rate = node.device.commissioning.as_ref()?.baud_rate.filter(|rate| *rate != 0)?;
            Some(Said::new(rate, node.file.at))
        };
        let mut rates = self.nodes.iter().filter_map(stated);
        let first = rates.next().filter(|first| rates.all(|rate| rate.value == first.value));
        self.bit_rate = self.bit_rate.or(of_dcfgen).or(first);
    }

    /// The position in the network file that disables the unused PDOs of a node.
    pub(crate) fn switches_off(&self, node: usize) -> Option<Span> {
        let said = self.nodes[node].unused_pdos.or(self.unused_pdos);
        said.filter(|said| said.value == UnusedPdos::Off).map(|said| said.at)
    }

    /// Whether a node is the manager.
    pub(crate) fn is_manager(&self, node: usize) -> bool {
        self.manager.as_ref().is_some_and(|manager| manager.node == Some(node))
    }

    /// Whether a node is the manager with a [made](Manager::is_made) description.
    pub fn is_made(&self, node: usize) -> bool {
        self.is_manager(node) && self.manager.as_ref().is_some_and(|manager| manager.is_made)
    }

    /// The nodes that the manager boots: all except itself.
    pub fn slaves(&self) -> impl Iterator<Item = (usize, &Node)> {
        self.nodes.iter().enumerate().filter(|(position, _)| !self.is_manager(*position))
    }
}
