//! What came of a simulated boot.

use std::collections::BTreeMap;

use objdict_device::NmtState;

use crate::diagnostic::{say, series};
use crate::frame::BusFrame;
use crate::manager::Milestone;
use crate::model::{CobId, Device, PdoKind};
use crate::node::MILLISECOND;

/// What happened on the bus from the time when the manager was switched on. Times are in nanoseconds.
#[derive(Clone, Debug)]
pub struct Run {
    /// In the order of time.
    pub events: Vec<Event>,
    /// The manager, then the other nodes by node-ID.
    pub nodes: Vec<NodeRun>,
    /// When the last node became operational that had to; `None` if one did not, or if the application has to start them.
    pub operational: Option<u64>,
    /// Whether starting the nodes is left to the application (1F80h): then they are booted when they are configured and monitored.
    pub waits_for_application: bool,
    /// When the simulation ended.
    pub end: u64,
    /// How long the bus was in use.
    pub busy: u64,
    /// How long the frame that waited longest at the end had waited for the bus.
    pub waiting: u64,
    /// Whether it ended before the boot was over, and by what.
    pub cut: Option<Cut>,
}

/// A limit that ended a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cut {
    /// The simulated time was over.
    Time,
    /// There were too many frames.
    Frames,
    /// Too many frames of a node waited for the bus.
    Overload,
}

/// Something that happened.
#[derive(Clone, Debug)]
pub struct Event {
    /// When: of a frame, when it was received.
    pub time: u64,
    /// What.
    pub kind: EventKind,
}

/// The kinds of events. Nodes are known by their positions in [`Run::nodes`].
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventKind {
    /// A frame.
    Frame {
        /// Who sent it.
        sender: usize,
        /// The frame.
        frame: BusFrame,
    },
    /// The manager found something out about a node.
    Milestone {
        /// The node.
        node: usize,
        /// What.
        milestone: Milestone,
    },
    /// The NMT state of a node changed.
    State {
        /// The node.
        node: usize,
        /// The new state.
        state: NmtState,
    },
    /// A second node sends data frames with a CAN-ID, which destroys frames of both on a real bus.
    TwoSenders {
        /// The CAN-ID.
        id: u16,
        /// Both nodes.
        senders: [usize; 2],
    },
}

/// What came of a node.
#[derive(Clone, Debug)]
pub struct NodeRun {
    /// The name.
    pub name: String,
    /// The node-ID.
    pub node_id: u8,
    /// Whether it is the manager.
    pub is_manager: bool,
    /// Whether the manager must configure and start it.
    pub must_boot: bool,
    /// Its value of 1F81h in the manager; `None` if the manager does not manage it.
    pub assignment: Option<u32>,
    /// Its device with the values at the end; `None` for a node that is not on the bus.
    pub device: Option<Device>,
    /// Its NMT state at the end.
    pub state: Option<NmtState>,
    /// What the manager found out about it last.
    pub milestone: Option<Milestone>,
    /// When it was configured and monitored.
    pub booted: Option<u64>,
    /// Since when it is operational.
    pub operational: Option<u64>,
    /// The downloads that it accepted in its last boot.
    pub downloads: usize,
    /// The emergency messages that it sent.
    pub emergencies: usize,
    /// Those of them that report an error while it was operational, but for errors that were over before the boot was, and for PDOs
    /// that are longer than their mapping.
    pub errors: usize,
}

impl NodeRun {
    /// Whether it is as it must be: booted, and operational unless the application starts it.
    pub(crate) fn has_arrived(&self, waits_for_application: bool) -> bool {
        let is_ready = self.is_manager || self.booted.is_some();
        let is_started = self.operational.is_some() || waits_for_application && !self.is_manager;
        !self.must_boot || is_ready && is_started
    }
}

impl Run {
    /// Whether each node became operational that had to, or is ready to be started by the application, no operational node
    /// reports an error, no two nodes share a CAN-ID, and the bus is not overloaded.
    pub fn is_booted(&self) -> bool {
        let has_conflict = self.events.iter().any(|event| matches!(event.kind, EventKind::TwoSenders { .. }));
        let is_right = |node: &NodeRun| node.errors == 0 && node.has_arrived(self.waits_for_application);
        !has_conflict && !self.is_overloaded() && self.nodes.iter().all(is_right)
    }

    /// Whether frames of low priority do not get through: one waited longer than any heartbeat, or too many wait.
    pub const fn is_overloaded(&self) -> bool {
        self.waiting >= 1000 * MILLISECOND || matches!(self.cut, Some(Cut::Overload))
    }

    /// The services that nodes are configured for but that are not simulated: sentences in lower case without a full stop, one for
    /// all services of a CAN-ID.
    pub fn not_simulated(&self) -> Vec<String> {
        let devices = self.nodes.iter().filter_map(|node| Some((&node.name, node.device.as_ref()?)));
        let mut services: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for (reason, service) in devices.flat_map(|(name, device)| unserved(name, device)) {
            services.entry(reason).or_default().push(service);
        }
        let sentence = |(reason, services): (String, Vec<String>)| {
            let have = if services.len() == 1 { "has" } else { "have" };
            say!("{} {} {}, which is not simulated", series(services), have, reason).to_string()
        };
        services.into_iter().map(sentence).collect()
    }

    /// The frames with their times and senders.
    pub fn frames(&self) -> impl Iterator<Item = (u64, usize, BusFrame)> + '_ {
        self.events.iter().filter_map(|event| match event.kind {
            EventKind::Frame { sender, frame } => Some((event.time, sender, frame)),
            _ => None,
        })
    }
}

/// What a node is configured for and does not do in the simulation: the reason, and the service.
fn unserved(name: &str, device: &Device) -> Vec<(String, String)> {
    let extended = |value: Option<CobId>| {
        let cob_id = value.filter(|cob_id| cob_id.is_valid() && cob_id.is_extended())?;
        Some(format!("the CAN-ID {:08X}h of 29 bits", cob_id.can_id(0)))
    };
    let services = [(0x1005, "SYNC"), (0x1014, "EMCY")].into_iter().filter_map(|(index, service)| {
        let cob_id = device.value(index, 0).and_then(|value| CobId::from_value(&value));
        Some((extended(cob_id)?, format!("{service} of `{name}`")))
    });
    let pdos = device.pdos().filter(|pdo| pdo.is_valid() == Some(true) && pdo.mapped().next().is_some());
    let pdos = pdos.filter_map(|pdo| {
        let is_requested = pdo.kind == PdoKind::Tpdo && matches!(pdo.transmission_type, Some(252 | 253));
        let reason = match extended(pdo.cob_id) {
            _ if pdo.is_multiplexed() => "multiplexed objects".to_owned(),
            Some(reason) => reason,
            None if is_requested => "a transmission on request".to_owned(),
            None => return None,
        };
        Some((reason, format!("{pdo} of `{name}`")))
    });
    services.chain(pdos).collect()
}
