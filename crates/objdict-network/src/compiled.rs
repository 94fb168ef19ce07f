//! The nodes of a network with their configurations.
//!
//! `Slave::device` is the only effective dictionary of a node: its description, configured values and
//! downloads. PDOs, messages, load, checks, pages and all targets are computed from it. Only
//! `DcfgenMode::Exact` also uses the requests, because dcfgen does.

use std::collections::BTreeMap;

use std::cell::OnceCell;

use crate::configure::PdoName;
use crate::diagnostic::Findings;
use crate::download::{ConciseDcf, PlanError};
use crate::model::{Device, MappedObject, Services};
use crate::source::Span;

/// A node with its configuration.
#[derive(Clone, Debug)]
pub struct Slave {
    /// Its position in [`Network::nodes`](crate::Network::nodes).
    pub node: usize,
    /// Its node-ID.
    pub node_id: u8,
    /// The effective dictionary: the description, its configured values, then every download in order. All findings and
    /// files about the node are based on it.
    pub device: Device,
    /// Its services, computed on demand.
    pub(crate) services: OnceCell<Services>,
    /// The positions of final values in the network file.
    pub(crate) origins: Origins,
    /// The positions of overridden values in the network file, by index.
    pub(crate) former: Vec<(u16, Span)>,
    /// The downloads that configure it.
    pub downloads: ConciseDcf,
    /// The result of [`arranged`](Self::arranged), once requested.
    pub(crate) arranged: OnceCell<Result<ConciseDcf, PlanError>>,
    /// The number of downloads at the end that are sent even if the node already has their values.
    pub(crate) unconditional: usize,
    /// Whether all of them concern the monitoring of the manager.
    pub(crate) has_only_consumers: bool,
    /// Its PDOs after the configuration, RPDOs before TPDOs, by number.
    pub pdos: Vec<PdoState>,
    /// Producer heartbeat time in milliseconds; 0: none.
    pub heartbeat: u16,
    /// COB-ID of EMCY; `None` if the node does not send EMCY, or the description does not state the COB-ID.
    pub emcy: Option<u32>,
    /// Guard time in milliseconds, if the node is guarded; otherwise 0.
    pub guard_time: u16,
    /// Device type (1000h), vendor-ID, product code, revision number and serial number (1018h); 0 if not
    /// stated.
    pub identity: [u32; 5],
}

/// How closely the records follow dcfgen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DcfgenMode {
    /// The records and the order of dcfgen 2.4.2, without its errors.
    #[default]
    Corrected,
    /// Including its bugs.
    Exact,
}

/// The configurations of the nodes. A node without a node-ID is omitted.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// The nodes but the manager, in the order of the network.
    pub slaves: Vec<Slave>,
    /// The manager, if it has a description: its own configuration, and its expectations of the nodes.
    pub manager: Option<Slave>,
    /// The problems of the configurations.
    pub findings: Findings,
}

impl Slave {
    /// The services of the node after its configuration.
    pub fn services(&self) -> &Services {
        self.services.get_or_init(|| self.device.services())
    }
}

impl Compiled {
    /// All nodes with a node-ID.
    pub fn nodes(&self) -> impl Iterator<Item = &Slave> {
        self.slaves.iter().chain(&self.manager)
    }

    /// The node at a position of [`Network::nodes`](crate::Network::nodes), if it has a node-ID.
    pub(crate) fn node(&self, position: usize) -> Option<&Slave> {
        self.nodes().find(|slave| slave.node == position)
    }
}

/// A PDO after the configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PdoState {
    /// The PDO.
    pub pdo: PdoName,
    /// COB-ID with its flags.
    pub cob_id: u32,
    /// Whether the PDO remains enabled; `false` only in [`DcfgenMode::Exact`], whose COB-IDs are the
    /// requested ones.
    pub is_enabled: bool,
    /// Transmission type.
    pub transmission: u8,
    /// Inhibit time in multiples of 100 µs; for an RPDO, that of the sending manager.
    pub inhibit_time: u16,
    /// Event timer in milliseconds; for an RPDO, that of the sending manager.
    pub event_timer: u16,
    /// The timeout of a receiver in milliseconds; for a TPDO, that of the receiving manager.
    pub deadline: u16,
    /// SYNC start value; for an RPDO, that of the sending manager.
    pub sync_start: u8,
    /// The number of mapped objects according to the node.
    pub(crate) count: u8,
    /// The mapped objects by sub-index, without unused ones.
    pub mapping: BTreeMap<u8, MappedObject>,
}

/// The transmission type of an RPDO: a PDO on request is an event for who receives it (CiA 301 §7.5.2.35).
pub(crate) const fn received_type(number: u8) -> u8 {
    match number {
        241..=253 => 255,
        number => number,
    }
}

/// Communication and mapping parameter.
pub(crate) fn indexes(pdo: PdoName) -> (u16, u16) {
    let index = pdo.kind.communication_index(pdo.number).unwrap_or_default();
    (index, index + 0x200)
}

/// The positions of final values in the network file.
pub(crate) type Origins = BTreeMap<(u16, u8), Span>;
