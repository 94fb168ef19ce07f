//! The nodes of a network with their configurations.
//!
//! `Slave::device` is the one effective dictionary of a node: its description, configured values and downloads.
//! PDOs, messages, load, checks, pages and all targets are computed from it. Only `DcfgenMode::Exact` also uses
//! the requests, because dcfgen does.

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
    /// The effective dictionary: the description, its configured values, then every download in order. All that is said and
    /// written about the node comes from it.
    pub device: Device,
    /// Its services, once they were asked for.
    pub(crate) services: OnceCell<Services>,
    /// Where the network file has the final values of entries.
    pub(crate) origins: Origins,
    /// Where it has values that later ones replace, by index.
    pub(crate) former: Vec<(u16, Span)>,
    /// The downloads that configure it.
    pub downloads: ConciseDcf,
    /// Those of [`arranged`](Self::arranged), once they were asked for.
    pub(crate) arranged: OnceCell<Result<ConciseDcf, PlanError>>,
    /// How many of them, at the end, are sent also of values that the node already has.
    pub(crate) unconditional: usize,
    /// Whether all of them are about the monitoring of the manager.
    pub(crate) has_only_consumers: bool,
    /// Its PDOs after the configuration, RPDOs before TPDOs, by number.
    pub pdos: Vec<PdoState>,
    /// Producer heartbeat time in milliseconds; 0: none.
    pub heartbeat: u16,
    /// COB-ID of EMCY; `None` if the node sends none, or the description does not say which.
    pub emcy: Option<u32>,
    /// Guard time in milliseconds, if the node is guarded; else 0.
    pub guard_time: u16,
    /// Device type (1000h), vendor-ID, product code, revision number and serial number (1018h); 0 where not stated.
    pub identity: [u32; 5],
}

/// How close the records are to those of dcfgen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DcfgenMode {
    /// The records and the order of dcfgen 2.4.2, without its errors.
    #[default]
    Corrected,
    /// With its errors.
    Exact,
}

/// The configurations of the nodes. One without a node-ID is left out.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// The nodes but the manager, in the order of the network.
    pub slaves: Vec<Slave>,
    /// The manager, if it has a description: its own configuration, and what it expects of the nodes.
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
    /// Whether the network file leaves the PDO on; `false` only in [`DcfgenMode::Exact`], whose COB-IDs are the wanted ones.
    pub is_enabled: bool,
    /// Transmission type.
    pub transmission: u8,
    /// Inhibit time in multiples of 100 µs; of an RPDO that of the manager that sends it.
    pub inhibit_time: u16,
    /// Event timer in milliseconds; of an RPDO that of the manager that sends it.
    pub event_timer: u16,
    /// The time in milliseconds after which a receiver misses the PDO; of a TPDO that of the manager that receives it.
    pub deadline: u16,
    /// SYNC start value; of an RPDO that of the manager that sends it.
    pub sync_start: u8,
    /// The number of mapped objects as the node counts them.
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

/// Where the network file has the final values of entries.
pub(crate) type Origins = BTreeMap<(u16, u8), Span>;
