//! The services of a node together.

use crate::clock::earlier;
use crate::errors::{self, error_code};
use crate::guard::Guarded;
use crate::heartbeat::CONSUMER_TIME;
use crate::services::{ERROR_BEHAVIOUR, STARTUP, Services};
use crate::{
    Dictionary, Errors, Frame, Heartbeat, HeartbeatConsumer, Nmt, NmtCommand, NmtState, Pdos, Reception,
    Scope, SdoServer, SyncProducer, sync,
};

/// A node with `CHANNELS` SDO servers for values of at most `BUFFER` bytes, `R` RPDOs, `T` TPDOs and capacity to
/// monitor `N` other nodes. Each service works in the NMT states that CiA 301 specifies. The generated file contains a
/// type and a constructor with the numbers of its device.
///
/// The application passes all frames to [`Node::receive`] and calls [`Node::poll`] until there is no frame to send, in
/// one loop with its own work on the dictionary; [`Node::next`] returns how long it may sleep.
#[derive(Clone, Debug)]
pub struct Node<D, const BUFFER: usize, const CHANNELS: usize, const R: usize, const T: usize, const N: usize>
{
    /// The values.
    pub dictionary: D,
    /// The PDOs.
    pub pdos: Pdos<R, T>,
    nmt: Nmt,
    sync: SyncProducer,
    consumers: HeartbeatConsumer<N>,
    errors: Errors,
    servers: [SdoServer<BUFFER>; CHANNELS],
    /// Whether the node stops after its emergency message, which it cannot send once stopped.
    is_stopping: bool,
}

/// The effect of a frame that the node received.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Received {
    /// The frame is not for this node.
    Ignored,
    /// The response of an SDO server.
    Answer(Frame),
    /// A command of the NMT master. After a reset, the node has restored its values; the application then
    /// calls [`Node::boot`].
    Nmt(NmtCommand),
    /// An RPDO or SYNC.
    Pdo(Reception),
    /// A heartbeat with new information.
    Heartbeat(Heartbeat),
}

/// The services that apply SDO writes.
struct Followers<'a, const CHANNELS: usize, const R: usize, const T: usize, const N: usize> {
    pdos: &'a mut Pdos<R, T>,
    nmt: &'a mut Nmt,
    sync: &'a mut SyncProducer,
    consumers: &'a mut HeartbeatConsumer<N>,
    errors: &'a mut Errors,
}

impl<const CHANNELS: usize, const R: usize, const T: usize, const N: usize> Services
    for Followers<'_, CHANNELS, R, T, N>
{
    const PRODUCES_SYNC: bool = true;
    const CONSUMERS: Option<usize> = Some(N);
    const CHANNELS: Option<usize> = Some(CHANNELS);

    fn follow<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, index: u16, sub: u8) {
        let objects = dictionary.objects();
        match index {
            0x1017 => self.nmt.load(dictionary),
            CONSUMER_TIME => self.consumers.load_entry(dictionary, sub),
            errors::COB_ID | errors::INHIBIT_TIME if objects.has(errors::COB_ID) => {
                self.errors.load(dictionary);
            }
            sync::COB_ID | sync::PERIOD | sync::OVERFLOW if objects.has(sync::PERIOD) => {
                self.sync.load(dictionary);
                self.pdos.follow(dictionary, index);
            }
            _ => self.pdos.follow(dictionary, index),
        }
    }
}

impl<
    D: Dictionary,
    const BUFFER: usize,
    const CHANNELS: usize,
    const R: usize,
    const T: usize,
    const N: usize,
> Node<D, BUFFER, CHANNELS, R, T, N>
{
    /// A node before [`Node::boot`].
    #[must_use]
    pub const fn new(node_id: u8, dictionary: D, pdos: Pdos<R, T>) -> Self {
        Self {
            dictionary,
            pdos,
            nmt: Nmt::new(node_id),
            sync: SyncProducer::new(),
            consumers: HeartbeatConsumer::new(),
            errors: Errors::new(node_id),
            servers: servers(node_id),
            is_stopping: false,
        }
    }

    /// Changes the node-ID of a node that waits for [`Node::boot`], for example to the one that LSS configured. All
    /// values return to their power-on state: the stored values, otherwise the defaults. A default that was stored for
    /// a different node-ID becomes the default for this one.
    pub fn set_node_id(&mut self, node_id: u8) {
        self.nmt = Nmt::new(node_id);
        self.errors = Errors::new(node_id);
        self.servers = servers(node_id);
        self.dictionary.restart(Scope::All, node_id);
    }

    /// The node-ID.
    #[must_use]
    pub const fn node_id(&self) -> u8 {
        self.nmt.node_id()
    }

    /// The NMT state.
    #[must_use]
    pub const fn state(&self) -> NmtState {
        self.nmt.state()
    }

    /// The dictionary as SDO servers access it, for an application that writes in the same way: values that
    /// no service supports are rejected.
    pub fn guard(&mut self) -> Guarded<'_, D, impl Services> {
        self.split().0
    }

    const fn split(&mut self) -> (Guarded<'_, D, impl Services>, &mut [SdoServer<BUFFER>]) {
        let services = Followers::<CHANNELS, R, T, N> {
            pdos: &mut self.pdos,
            nmt: &mut self.nmt,
            sync: &mut self.sync,
            consumers: &mut self.consumers,
            errors: &mut self.errors,
        };
        (Guarded { dictionary: &mut self.dictionary, services }, &mut self.servers)
    }

    /// Starts the services with the values of the dictionary, and returns the boot-up message. Call it after power-on
    /// and after a reset. The node becomes operational if bit 2 of 1F80h is 0 (CiA 302-2).
    pub fn boot(&mut self, now: u64) -> Frame {
        self.pdos.load(&mut self.dictionary);
        self.pdos.stop();
        if self.dictionary.objects().has(sync::PERIOD) {
            self.sync.boot(&mut self.dictionary, now);
        }
        self.consumers.load(&mut self.dictionary);
        self.errors.boot(&mut self.dictionary);
        let frame = self.nmt.boot(&mut self.dictionary, now);
        let has_startup = self.dictionary.objects().has(STARTUP);
        if has_startup && self.dictionary.number(STARTUP, 0).is_ok_and(|startup| startup & 5 == 0) {
            self.enter(NmtState::Operational);
        }
        frame
    }

    /// Processes a frame received at `now`, in microseconds.
    pub fn receive(&mut self, frame: &Frame, now: u64) -> Received {
        if let Some(command) = self.nmt.receive(frame) {
            self.obey(command);
            return Received::Nmt(command);
        }
        if self.nmt.state() == NmtState::Initialising {
            return Received::Ignored;
        }
        if let Some(heartbeat) = self.consumers.receive(frame, now) {
            if let Heartbeat::Returned(node_id, _) = heartbeat {
                self.resolve(error_code::HEARTBEAT, [node_id, 0]);
            }
            return Received::Heartbeat(heartbeat);
        }
        match self.receive_pdo(frame, now) {
            Reception::Ignored => self.receive_sdo(frame, now),
            reception => Received::Pdo(reception),
        }
    }

    fn receive_pdo(&mut self, frame: &Frame, now: u64) -> Reception {
        let (errors, sync_length) = (&mut self.errors, self.pdos.sync_length());
        let mut last = Reception::Ignored;
        self.pdos.receive_each(&mut self.dictionary, frame, now, |dictionary, reception| {
            last = reception;
            if !errors::are_kept(dictionary) {
                return;
            }
            let mut state = |code, name: [u8; 2], is_active| match is_active {
                true => errors.report(dictionary, code, [name[0], name[1], 0, 0, 0]),
                false => errors.resolve(dictionary, code, name),
            };
            let (index, is_short, is_long) = match reception {
                Reception::Ignored => return,
                Reception::Sync => {
                    state(error_code::SYNC_LENGTH, [0; 2], frame.data().len() != sync_length);
                    return;
                }
                Reception::TooShort(index) => (index, true, false),
                Reception::TooLong(index) => (index, false, true),
                Reception::Written(index) | Reception::Held(index) | Reception::Refused(index, _) => {
                    (index, false, false)
                }
            };
            state(error_code::PDO_TOO_SHORT, number_of(index), is_short);
            state(error_code::PDO_TOO_LONG, number_of(index), is_long);
            if !is_short {
                state(error_code::RPDO_TIMEOUT, number_of(index), false);
            }
        });
        last
    }

    fn receive_sdo(&mut self, frame: &Frame, now: u64) -> Received {
        if !self.nmt.communicates() {
            return Received::Ignored;
        }
        let (mut dictionary, servers) = self.split();
        let answer = servers.iter_mut().find_map(|server| server.receive(&mut dictionary, frame, now));
        answer.map_or(Received::Ignored, Received::Answer)
    }

    /// Reports an error of the device: sets the error register, adds it to the history and sends an emergency message.
    /// `code` is defined by CiA 301 or a device profile, such as 8110h or 2310h; the first two bytes distinguish errors
    /// with the same code, and each is reported once until [`Node::resolve`]. After a communication error, bus-off or a
    /// lost heartbeat, the node behaves as 1029h specifies; if it stops, its emergency message is sent first, unless
    /// its inhibit time is not over.
    pub fn report(&mut self, code: u16, vendor: [u8; 5]) {
        let is_new = self.errors.report(&mut self.dictionary, code, vendor);
        if is_new && matches!(code, error_code::HEARTBEAT | error_code::BUS_OFF) {
            let behaviour = self.dictionary.number(ERROR_BEHAVIOUR, 1).unwrap_or(0);
            match (behaviour, self.state()) {
                (0, NmtState::Operational) => self.enter(NmtState::PreOperational),
                (2, NmtState::Operational | NmtState::PreOperational) => {
                    self.pdos.stop();
                    self.is_stopping = true;
                }
                _ => {}
            }
        }
    }

    /// Reports that an error no longer exists, by its code and its first two bytes.
    pub fn resolve(&mut self, code: u16, name: [u8; 2]) {
        self.errors.resolve(&mut self.dictionary, code, name);
    }

    fn obey(&mut self, command: NmtCommand) {
        let scope = match command {
            NmtCommand::ResetNode => Some(Scope::All),
            NmtCommand::ResetCommunication => Some(Scope::Communication),
            _ => None,
        };
        if let Some(scope) = scope {
            self.dictionary.restart(scope, self.node_id());
        }
        self.enter(self.state());
    }

    /// The services that the new state does not have end.
    fn enter(&mut self, state: NmtState) {
        self.is_stopping = false;
        self.nmt.enter(state);
        match state {
            NmtState::Operational => return self.pdos.start(),
            NmtState::PreOperational => {}
            _ => {
                self.servers.iter_mut().for_each(SdoServer::reset);
                self.sync.restart();
            }
        }
        self.pdos.stop();
    }

    /// The next frame to send at `now`, in microseconds: heartbeat, SYNC, emergency message, TPDO, or an SDO
    /// server frame.
    pub fn poll(&mut self, now: u64) -> Option<Frame> {
        self.look_for_losses(now);
        let objects = self.dictionary.objects();
        let emergency =
            |errors: &mut Errors| if objects.has(errors::COB_ID) { errors.poll(now) } else { None };
        if self.is_stopping {
            if let Some(emergency) = emergency(&mut self.errors) {
                return Some(emergency);
            }
            self.enter(NmtState::Stopped);
        }
        if let Some(frame) = self.nmt.poll(now) {
            return Some(frame);
        }
        if !self.nmt.communicates() {
            return None;
        }
        if objects.has(sync::PERIOD)
            && let Some(frame) = self.sync.poll(now)
        {
            self.receive_pdo(&frame, now);
            return Some(frame);
        }
        let frame = emergency(&mut self.errors).or_else(|| self.pdos.poll(&mut self.dictionary, now));
        frame.or_else(|| self.servers.iter_mut().find_map(|server| server.poll(&mut self.dictionary, now)))
    }

    /// Reports the heartbeats and RPDOs that are missing.
    fn look_for_losses(&mut self, now: u64) {
        while let Some(Heartbeat::Lost(node_id)) = self.consumers.poll(now) {
            self.report(error_code::HEARTBEAT, [node_id, 0, 0, 0, 0]);
        }
        while errors::are_kept(&self.dictionary)
            && let Some(index) = self.pdos.overdue(now)
        {
            let [low, high] = number_of(index);
            self.report(error_code::RPDO_TIMEOUT, [low, high, 0, 0, 0]);
        }
    }

    /// The time in microseconds at which [`Node::poll`] must be called again if no frame arrives: not later than `now`
    /// if there is a frame to send, `None` if nothing is scheduled. Requests of the application are due at once.
    #[must_use]
    pub fn next(&self, now: u64) -> Option<u64> {
        let always = earlier(self.nmt.next(now), self.consumers.next());
        if self.is_stopping {
            return Some(now);
        }
        if !self.nmt.communicates() {
            return always.filter(|_| self.state() != NmtState::Initialising);
        }
        let servers = self.servers.iter().fold(None, |next, server| earlier(next, server.next(now)));
        let objects = self.dictionary.objects();
        let sync = if objects.has(sync::PERIOD) { self.sync.next(now) } else { None };
        let emergency = if objects.has(errors::COB_ID) { self.errors.next(now) } else { None };
        earlier(earlier(always, earlier(sync, emergency)), earlier(self.pdos.next(now), servers))
    }
}

const fn servers<const BUFFER: usize, const CHANNELS: usize>(node_id: u8) -> [SdoServer<BUFFER>; CHANNELS] {
    let mut servers = [const { SdoServer::new(0, 0) }; CHANNELS];
    let mut number = 0;
    while number < CHANNELS {
        servers[number] = SdoServer::new(number as u8, node_id);
        number += 1;
    }
    servers
}

/// The number of a PDO, from 1, by the index of its communication parameters.
const fn number_of(index: u16) -> [u8; 2] {
    ((index & 0x1FF) + 1).to_le_bytes()
}
