//! What the manager knows of a node that it manages.

use std::collections::BTreeMap;

use super::failure::BootFailure;
use crate::client::Client;
use crate::dictionary::LiveDictionary;
use crate::download::Download;
use crate::node::MILLISECOND;

/// The configurations of nodes (1F22h) by node-ID: their downloads, or why they cannot be read.
pub type Configurations = BTreeMap<u8, Result<Vec<Download>, String>>;

/// The bits of 1F81h (CiA 302-2).
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlaveAssignment(pub(crate) u32);

impl SlaveAssignment {
    /// Whether the node is in the network list.
    pub(crate) const fn is_slave(self) -> bool {
        self.0 & 1 != 0
    }

    /// Whether the manager configures and starts it.
    pub(crate) const fn boots(self) -> bool {
        self.0 & 5 == 5
    }

    pub(crate) const fn is_mandatory(self) -> bool {
        self.0 & 9 == 9
    }

    /// Whether it is not reset while it is operational.
    pub(crate) const fn is_kept_alive(self) -> bool {
        self.0 & 0x11 == 0x11
    }

    pub(crate) const fn checks_software(self) -> bool {
        self.0 & 0x20 != 0
    }

    pub(crate) const fn restores(self) -> bool {
        self.0 & 0x80 != 0
    }

    /// Guard time in nanoseconds and retry factor; `None` without guarding.
    pub(super) const fn guarding(self) -> Option<(u64, u32)> {
        let (time, factor) = (self.0 >> 16, self.0 >> 8 & 0xFF);
        if time == 0 || factor == 0 { None } else { Some((time as u64 * MILLISECOND, factor)) }
    }
}

/// The state of the process "boot NMT slave". Times are in nanoseconds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum SlaveStep {
    /// Waits for the boot-up message.
    Idle,
    /// The same, but at that time it asks in any case.
    BootUp(u64),
    /// Begins again at that time.
    Retry(u64),
    /// Reads 1000h.
    DeviceType,
    /// Reads this sub-index of 1018h.
    Identity(u8),
    /// Waits until then for the state of a node that may be operational.
    State(u64),
    /// Waits until then for the boot-up message after a reset of the node alone.
    Reset(u64),
    /// Reads 1F56h.
    Software,
    /// Reads 1020h: this sub-index.
    Verification(u8),
    /// Writes 1011h.
    Restore,
    /// Waits until then for the boot-up message after the defaults were restored.
    Restored(u64),
    /// Writes this download, counted from 0.
    Download(usize),
    /// Waits until then for the first heartbeat.
    Monitor(u64),
    /// The end, with or without success.
    Finished,
}

impl SlaveStep {
    /// When it has to be looked at.
    pub(super) const fn until(&self) -> Option<u64> {
        match self {
            Self::BootUp(at)
            | Self::Retry(at)
            | Self::State(at)
            | Self::Reset(at)
            | Self::Restored(at)
            | Self::Monitor(at) => Some(*at),
            _ => None,
        }
    }
}

/// How a node is monitored after its boot. Times are in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Monitor {
    None,
    /// By its heartbeat, the last of which came then.
    Heartbeat(u64),
    /// By guarding: when the next request is due, and how many had no answer.
    Guarding(u64, u32),
}

/// A node that the manager manages, with what the objects of the manager say of it.
pub(super) struct ManagedSlave {
    pub(super) node_id: u8,
    pub(super) assignment: SlaveAssignment,
    /// Device type and identity (1F84h to 1F88h).
    pub(super) expected: [u32; 5],
    /// Software (1F55h).
    pub(super) software: u32,
    /// Date and time of the configuration (1F26h, 1F27h).
    pub(super) configured_at: [u32; 2],
    /// The sub-index of 1011h that restores (1F8Ah).
    pub(super) restore: u8,
    /// Consumer heartbeat time in milliseconds (1016h); 0 for none.
    pub(super) consumer_time: u16,
    pub(super) downloads: Result<Vec<Download>, String>,
    pub(super) client: Client,
    pub(super) step: SlaveStep,
    pub(super) monitor: Monitor,
    /// Whether it was operational already when the manager looked.
    pub(super) is_running: bool,
    /// Whether the last boot succeeded.
    pub(super) has_booted: bool,
    pub(super) failure: Option<BootFailure>,
    /// The downloads that the node has accepted.
    pub(super) accepted: usize,
}

impl ManagedSlave {
    pub(super) fn new(node_id: u8, dictionary: &LiveDictionary, configurations: &Configurations) -> Self {
        let word = |index: u16| dictionary.word(index, node_id);
        let consumers = (1..=127).map(|sub| dictionary.word(0x1016, sub));
        let mut watching = consumers.filter(|consumer| consumer >> 16 & 0x7F == u32::from(node_id));
        Self {
            node_id,
            assignment: SlaveAssignment(word(0x1F81)),
            expected: [0x1F84, 0x1F85, 0x1F86, 0x1F87, 0x1F88].map(word),
            software: word(0x1F55),
            configured_at: [0x1F26, 0x1F27].map(word),
            restore: word(0x1F8A) as u8,
            consumer_time: watching.next_back().unwrap_or(0) as u16,
            downloads: configurations.get(&node_id).cloned().unwrap_or(Ok(Vec::new())),
            client: Client::new(node_id),
            step: SlaveStep::Idle,
            monitor: Monitor::None,
            is_running: false,
            has_booted: false,
            failure: None,
            accepted: 0,
        }
    }
}
