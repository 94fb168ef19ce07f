//! The heartbeats of other nodes.

use crate::clock::milliseconds;
use crate::nmt::ERROR_CONTROL;
use crate::{Dictionary, Frame, NmtState};

/// The object with the monitored nodes.
pub(crate) const CONSUMER_TIME: u16 = 0x1016;

/// Monitors the heartbeats of at most `N` other nodes, which are listed in 1016h.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct HeartbeatConsumer<const N: usize> {
    nodes: [Monitored; N],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Monitored {
    node_id: u8,
    /// In milliseconds.
    time: u16,
    last: Last,
}

/// The last heartbeat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Last {
    /// No heartbeat yet.
    Never,
    At(u64, NmtState),
    /// The node is lost.
    Lost,
}

/// A change in the state of a monitored node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Heartbeat {
    /// The node has this state now; its heartbeat started or its state changed.
    State(u8, NmtState),
    /// The heartbeat of a lost node is back, with this state.
    Returned(u8, NmtState),
    /// The heartbeat of the node is missing (emergency 8130h).
    Lost(u8),
}

/// The node and the time in milliseconds of an entry of 1016h, if it is in use.
pub(crate) fn monitored(value: u64) -> Option<(u8, u16)> {
    let (node_id, time) = ((value >> 16) as u8, value as u16);
    (value >> 23 == 0 && node_id != 0 && time != 0).then_some((node_id, time))
}

impl Monitored {
    const NONE: Self = Self { node_id: 0, time: 0, last: Last::Never };

    fn of<D: Dictionary + ?Sized>(dictionary: &mut D, sub: u8) -> Self {
        let value = dictionary.number(CONSUMER_TIME, sub).ok().and_then(monitored);
        value.map_or(Self::NONE, |(node_id, time)| Self { node_id, time, last: Last::Never })
    }

    /// The time at which the node is lost unless a heartbeat arrives.
    fn deadline(&self) -> Option<u64> {
        match self.last {
            Last::At(at, _) => Some(at.saturating_add(milliseconds(self.time))),
            Last::Never | Last::Lost => None,
        }
    }
}

impl<const N: usize> HeartbeatConsumer<N> {
    /// No node is monitored before [`HeartbeatConsumer::load`].
    #[must_use]
    pub const fn new() -> Self {
        Self { nodes: [Monitored::NONE; N] }
    }

    /// Reads 1016h, after a reset.
    pub fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        (1..=N.min(0x7F) as u8).for_each(|sub| self.load_entry(dictionary, sub));
    }

    /// Reads an entry of 1016h, after a write to it. Monitoring of other nodes continues.
    pub fn load_entry<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, sub: u8) {
        let node = usize::from(sub).checked_sub(1).and_then(|at| self.nodes.get_mut(at));
        if let Some(node) = node {
            *node = Monitored::of(dictionary, sub);
        }
    }

    /// Processes a frame received at `now`, in microseconds. A node is monitored from its first heartbeat on.
    pub fn receive(&mut self, frame: &Frame, now: u64) -> Option<Heartbeat> {
        let is_sender = |node: &&mut Monitored| {
            node.node_id != 0 && u32::from(frame.id()) == ERROR_CONTROL + u32::from(node.node_id)
        };
        let node = self.nodes.iter_mut().find(is_sender)?;
        let &[code] = frame.data() else { return None };
        let state = NmtState::from_code(code)?;
        match core::mem::replace(&mut node.last, Last::At(now, state)) {
            Last::At(_, before) if before == state => None,
            Last::At(..) | Last::Never => Some(Heartbeat::State(node.node_id, state)),
            Last::Lost => Some(Heartbeat::Returned(node.node_id, state)),
        }
    }

    /// The next node whose heartbeat is missing. Call it until it returns `None`.
    pub fn poll(&mut self, now: u64) -> Option<Heartbeat> {
        let is_lost = |node: &&mut Monitored| node.deadline().is_some_and(|deadline| deadline < now);
        let node = self.nodes.iter_mut().find(is_lost)?;
        node.last = Last::Lost;
        Some(Heartbeat::Lost(node.node_id))
    }

    /// The time at which the next node is lost unless its heartbeat arrives.
    #[must_use]
    pub fn next(&self) -> Option<u64> {
        // it is lost when the time has passed
        self.nodes.iter().filter_map(Monitored::deadline).min().map(|deadline| deadline.saturating_add(1))
    }
}

impl<const N: usize> Default for HeartbeatConsumer<N> {
    fn default() -> Self {
        Self::new()
    }
}
