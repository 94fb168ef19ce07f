//! NMT: the state of the node, boot-up and heartbeat.

use crate::clock::{Periodic, milliseconds};
use crate::dictionary::word;
use crate::{Dictionary, Frame};

/// The base CAN-ID of boot-up and heartbeat, to which the node-ID is added.
pub(crate) const ERROR_CONTROL: u32 = 0x700;

/// The NMT state of a node (CiA 301 §7.3.2.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

    /// The state in a heartbeat; bit 7 is reserved. `None` for other values.
    #[must_use]
    pub fn from_code(code: u8) -> Option<Self> {
        let states = [Self::Initialising, Self::Stopped, Self::Operational, Self::PreOperational];
        states.into_iter().find(|state| state.code() == code & 0x7F)
    }
}

/// A command of the NMT master.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum NmtCommand {
    /// Become operational.
    Start,
    /// Become stopped.
    Stop,
    /// Become pre-operational.
    EnterPreOperational,
    /// Restart the application: restore all power-on values.
    ResetNode,
    /// Restart the communication: restore the power-on values of 1000h to 1FFFh.
    ResetCommunication,
}

/// The NMT slave: state, boot-up and heartbeat of a node.
#[derive(Clone, Debug)]
pub struct Nmt {
    node_id: u8,
    state: NmtState,
    /// The state that was sent last.
    announced: NmtState,
    heartbeat: Periodic,
}

impl Nmt {
    /// A node before boot-up.
    #[must_use]
    pub const fn new(node_id: u8) -> Self {
        let state = NmtState::Initialising;
        Self { node_id: node_id & 0x7F, state, announced: state, heartbeat: Periodic::never() }
    }

    /// The node-ID.
    #[must_use]
    pub const fn node_id(&self) -> u8 {
        self.node_id
    }

    /// The state.
    #[must_use]
    pub const fn state(&self) -> NmtState {
        self.state
    }

    /// Changes the state without a command, such as after an error.
    pub(crate) const fn enter(&mut self, state: NmtState) {
        self.state = state;
    }

    /// Whether SDOs, SYNC and emergency messages work.
    pub(crate) const fn communicates(&self) -> bool {
        matches!(self.state, NmtState::PreOperational | NmtState::Operational)
    }

    /// Processes a frame, and returns its command for this node. A reset leads to [`NmtState::Initialising`]; call
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

    /// Reads 1017h after a write to it: the heartbeat begins at once.
    pub fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        let period = word(dictionary, 0x1017, 0, 0) as u16;
        self.heartbeat.restart(milliseconds(period));
    }

    /// Ends the initialisation and returns the boot-up message, which also acts as a heartbeat. The node is
    /// then pre-operational.
    pub fn boot<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, now: u64) -> Frame {
        self.load(dictionary);
        self.heartbeat.wait(now);
        self.state = NmtState::PreOperational;
        self.announced = self.state;
        self.error_control(NmtState::Initialising)
    }

    /// The heartbeat if it is due at `now`, in microseconds. A new state is sent at once, without restarting
    /// the period.
    pub fn poll(&mut self, now: u64) -> Option<Frame> {
        if self.next(now)? > now {
            return None;
        }
        let _ = self.heartbeat.take(now);
        self.announced = self.state;
        Some(self.error_control(self.state))
    }

    /// The time at which the next heartbeat is due.
    #[must_use]
    pub fn next(&self, now: u64) -> Option<u64> {
        let due = self.heartbeat.next(now).filter(|_| self.state != NmtState::Initialising);
        if self.announced == self.state { due } else { due.map(|_| now) }
    }

    fn error_control(&self, state: NmtState) -> Frame {
        let bytes = [state.code(), 0, 0, 0, 0, 0, 0, 0];
        Frame::full(ERROR_CONTROL + u32::from(self.node_id), bytes).shortened(1)
    }
}
