//! NMT: the state of the node, boot-up and heartbeat.

use crate::{Dictionary, Frame};

/// The first CAN-ID of boot-up and heartbeat, to which the node-ID is added.
const ERROR_CONTROL: u32 = 0x700;

/// The NMT state of a node (CiA 301 §7.3.2.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NmtState {
    /// Before boot-up: no service works.
    Initialising,
    /// Only NMT and heartbeat work.
    Stopped,
    /// All services work.
    Operational,
    /// All services but PDOs work.
    PreOperational,
}

impl NmtState {
    /// The state in a heartbeat.
    #[must_use]
    pub const fn code(self) -> u8 {
        match self {
            Self::Initialising => 0x00,
            Self::Stopped => 0x04,
            Self::Operational => 0x05,
            Self::PreOperational => 0x7F,
        }
    }

    /// The state of a heartbeat; bit 7 is reserved. `None` for other values.
    #[must_use]
    pub fn from_code(code: u8) -> Option<Self> {
        let states = [Self::Initialising, Self::Stopped, Self::Operational, Self::PreOperational];
        states.into_iter().find(|state| state.code() == code & 0x7F)
    }
}

/// What the NMT master orders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NmtCommand {
    /// Become operational.
    Start,
    /// Become stopped.
    Stop,
    /// Become pre-operational.
    EnterPreOperational,
    /// Restart the application: all values are those of power-on.
    ResetNode,
    /// Restart the communication: the values of 1000h to 1FFFh are those of power-on.
    ResetCommunication,
}

/// The NMT slave: state, boot-up and heartbeat of a node.
#[derive(Clone, Debug)]
pub struct Nmt {
    node_id: u8,
    state: NmtState,
    /// When the last heartbeat was sent, and which state it had.
    sent: Option<(u64, NmtState)>,
}

impl Nmt {
    /// A node before boot-up.
    #[must_use]
    pub const fn new(node_id: u8) -> Self {
        Self { node_id: node_id & 0x7F, state: NmtState::Initialising, sent: None }
    }

    /// The state.
    #[must_use]
    pub const fn state(&self) -> NmtState {
        self.state
    }

    /// Takes a frame, and returns the command that it has for this node. A reset leads to [`NmtState::Initialising`]; call
    /// [`Nmt::boot`] when the values are restored.
    pub fn receive(&mut self, frame: &Frame) -> Option<NmtCommand> {
        let (0, &[command, node_id]) = (frame.id(), frame.data()) else { return None };
        if self.state == NmtState::Initialising || (node_id != 0 && node_id != self.node_id) {
            return None;
        }
        let (command, state) = match command {
            1 => (NmtCommand::Start, NmtState::Operational),
            2 => (NmtCommand::Stop, NmtState::Stopped),
            128 => (NmtCommand::EnterPreOperational, NmtState::PreOperational),
            129 => (NmtCommand::ResetNode, NmtState::Initialising),
            130 => (NmtCommand::ResetCommunication, NmtState::Initialising),
            _ => return None,
        };
        self.state = state;
        Some(command)
    }

    /// Ends the initialisation: the boot-up message, which counts as a heartbeat. The node is pre-operational then.
    pub fn boot(&mut self, now: u64) -> Frame {
        self.state = NmtState::PreOperational;
        self.sent = Some((now, self.state));
        self.error_control(NmtState::Initialising)
    }

    /// The heartbeat when it is due: `period` is 1017h in milliseconds, 0 for none, `now` is in microseconds. A new state is sent at
    /// once.
    pub fn poll(&mut self, period: u16, now: u64) -> Option<Frame> {
        let (at, state) = self.sent?;
        let waited = now.saturating_sub(at);
        let is_due = waited >= u64::from(period) * 1000 || state != self.state;
        if period == 0 || self.state == NmtState::Initialising || !is_due {
            return None;
        }
        self.sent = Some((now, self.state));
        Some(self.error_control(self.state))
    }

    fn error_control(&self, state: NmtState) -> Frame {
        let bytes = [state.code(), 0, 0, 0, 0, 0, 0, 0];
        Frame::full(ERROR_CONTROL + u32::from(self.node_id), bytes).shortened(1)
    }
}

/// Monitors the heartbeats of at most `N` other nodes: those of 1016h.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct HeartbeatConsumer<const N: usize> {
    nodes: [Monitored; N],
}

#[derive(Clone, Copy, Debug)]
struct Monitored {
    node_id: u8,
    /// In milliseconds.
    time: u16,
    /// The last heartbeat; `None` before the first one and after it was lost.
    last: Option<(u64, NmtState)>,
}

/// What became known of another node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heartbeat {
    /// The node has this state now; its heartbeat started or its state changed.
    State(u8, NmtState),
    /// The heartbeat of the node is missing (emergency 8130h).
    Lost(u8),
}

impl<const N: usize> HeartbeatConsumer<N> {
    /// No node is monitored before [`HeartbeatConsumer::load`].
    #[must_use]
    pub const fn new() -> Self {
        Self { nodes: [Monitored { node_id: 0, time: 0, last: None }; N] }
    }

    /// Reads 1016h, after a reset or a write to it.
    pub fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        for (node, sub) in self.nodes.iter_mut().zip(1..) {
            let value = dictionary.number(0x1016, sub).unwrap_or(0);
            let is_used = value >> 23 == 0 && value & 0xFFFF != 0;
            let node_id = if is_used { (value >> 16) as u8 } else { 0 };
            *node = Monitored { node_id, time: value as u16, last: None };
        }
    }

    /// Takes a frame at a time in microseconds. A node is monitored from its first heartbeat on.
    pub fn receive(&mut self, frame: &Frame, now: u64) -> Option<Heartbeat> {
        let &[code] = frame.data() else { return None };
        let state = NmtState::from_code(code)?;
        let is_sender = |node: &&mut Monitored| {
            node.node_id != 0 && u32::from(frame.id()) == ERROR_CONTROL + u32::from(node.node_id)
        };
        let node = self.nodes.iter_mut().find(is_sender)?;
        let before = node.last.replace((now, state));
        (before.map(|(_, state)| state) != Some(state)).then_some(Heartbeat::State(node.node_id, state))
    }

    /// The next node whose heartbeat is missing. Call it until it returns `None`.
    pub fn poll(&mut self, now: u64) -> Option<Heartbeat> {
        let is_lost = |node: &&mut Monitored| {
            node.last.is_some_and(|(at, _)| now.saturating_sub(at) > u64::from(node.time) * 1000)
        };
        let node = self.nodes.iter_mut().find(is_lost)?;
        node.last = None;
        Some(Heartbeat::Lost(node.node_id))
    }
}

impl<const N: usize> Default for HeartbeatConsumer<N> {
    fn default() -> Self {
        Self::new()
    }
}
