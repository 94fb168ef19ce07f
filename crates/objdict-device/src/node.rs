//! The services of a node together.

use crate::{Dictionary, Frame, Nmt, NmtCommand, NmtState, Pdos, Reception, SdoServer};

/// A node with `CHANNELS` SDO servers for values of at most `BUFFER` bytes, `R` RPDOs and `T` TPDOs, where each service works in the
/// NMT states that CiA 301 gives it.
///
/// The application gives [`Node::receive`] all frames and calls [`Node::poll`] until there is no frame to send, in one loop with its
/// own work on the dictionary.
#[derive(Clone, Debug)]
pub struct Node<D, const BUFFER: usize, const CHANNELS: usize, const R: usize, const T: usize> {
    /// The values.
    pub dictionary: D,
    /// The PDOs.
    pub pdos: Pdos<R, T>,
    nmt: Nmt,
    servers: [SdoServer<BUFFER>; CHANNELS],
}

/// What became of a frame that the node received.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Received {
    /// It is not for this node.
    Ignored,
    /// The answer of an SDO server.
    Answer(Frame),
    /// A command of the NMT master. After a reset the application restores the values and calls [`Node::boot`].
    Nmt(NmtCommand),
    /// An RPDO or SYNC.
    Pdo(Reception),
}

impl<D: Dictionary, const BUFFER: usize, const CHANNELS: usize, const R: usize, const T: usize>
    Node<D, BUFFER, CHANNELS, R, T>
{
    /// A node before [`Node::boot`].
    #[must_use]
    pub const fn new(node_id: u8, dictionary: D, pdos: Pdos<R, T>) -> Self {
        let mut servers = [const { SdoServer::new(0, 0) }; CHANNELS];
        let mut number = 0;
        while number < CHANNELS {
            servers[number] = SdoServer::new(number as u8, node_id);
            number += 1;
        }
        Self { dictionary, pdos, nmt: Nmt::new(node_id), servers }
    }

    /// The NMT state.
    #[must_use]
    pub const fn state(&self) -> NmtState {
        self.nmt.state()
    }

    /// Starts the services with the values of the dictionary, and returns the boot-up message: after power-on, and after a reset.
    pub fn boot(&mut self, now: u64) -> Frame {
        self.pdos.load(&mut self.dictionary);
        self.nmt.boot(now)
    }

    /// Takes a frame at a time in microseconds.
    pub fn receive(&mut self, frame: &Frame, now: u64) -> Received {
        if let Some(command) = self.nmt.receive(frame) {
            self.follow_state();
            return Received::Nmt(command);
        }
        match self.pdos.receive(&mut self.dictionary, frame, now) {
            Reception::Ignored => self.receive_sdo(frame, now),
            reception => Received::Pdo(reception),
        }
    }

    fn receive_sdo(&mut self, frame: &Frame, now: u64) -> Received {
        if !matches!(self.state(), NmtState::PreOperational | NmtState::Operational) {
            return Received::Ignored;
        }
        let mut dictionary = self.pdos.guard(&mut self.dictionary);
        let answer = self.servers.iter_mut().find_map(|server| server.receive(&mut dictionary, frame, now));
        answer.map_or(Received::Ignored, Received::Answer)
    }

    /// The services that the new state does not have end.
    fn follow_state(&mut self) {
        match self.state() {
            NmtState::Operational => return self.pdos.start(),
            NmtState::PreOperational => {}
            _ => self.servers.iter_mut().for_each(SdoServer::reset),
        }
        self.pdos.stop();
    }

    /// The next frame to send at a time in microseconds: heartbeat, TPDO, or what an SDO server has to say.
    pub fn poll(&mut self, now: u64) -> Option<Frame> {
        let period = self.dictionary.number(0x1017, 0).map_or(0, |period| period as u16);
        let heartbeat = self.nmt.poll(period, now);
        let frame = heartbeat.or_else(|| self.pdos.poll(&mut self.dictionary, now));
        frame.or_else(|| self.servers.iter_mut().find_map(|server| server.poll(&mut self.dictionary, now)))
    }
}
