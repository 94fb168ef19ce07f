//! A node: `objdict-device` over the dictionary of a description, with what its application adds: reset, EMCY, SYNC, guarding.

use objdict_device::{
    Frame, Heartbeat, HeartbeatConsumer, NmtCommand, NmtState, Node, Pdos, Received, Reception, emergency,
};

use crate::dictionary::LiveDictionary;
use crate::frame::BusFrame;

/// The longest value of an SDO, in bytes.
const LONGEST: usize = 1 << 16;

/// The bits of 1001h and of EMCY for communication errors: generic error, communication error.
const COMMUNICATION: u8 = 0x11;

/// EMCY error codes (CiA 301 §7.2.7.1).
const GUARDING_LOST: u16 = 0x8130;
const PDO_TOO_SHORT: u16 = 0x8210;
const RPDO_TIMED_OUT: u16 = 0x8250;

/// Nanoseconds of a millisecond.
pub(crate) const MILLISECOND: u64 = 1_000_000;

/// The services of a device, for any number of PDOs.
trait Services {
    fn boot(&mut self, now: u64) -> Frame;
    fn state(&self) -> NmtState;
    fn receive(&mut self, frame: &Frame, now: u64) -> Received;
    fn poll(&mut self, now: u64) -> Option<Frame>;
    fn overdue(&mut self, now: u64) -> Option<u16>;
    fn dictionary(&self) -> &LiveDictionary;
    fn dictionary_mut(&mut self) -> &mut LiveDictionary;
}

impl<const R: usize, const T: usize> Services for Node<LiveDictionary, LONGEST, 1, R, T> {
    fn boot(&mut self, now: u64) -> Frame {
        Self::boot(self, now)
    }

    fn state(&self) -> NmtState {
        Self::state(self)
    }

    fn receive(&mut self, frame: &Frame, now: u64) -> Received {
        Self::receive(self, frame, now)
    }

    fn poll(&mut self, now: u64) -> Option<Frame> {
        Self::poll(self, now)
    }

    fn overdue(&mut self, now: u64) -> Option<u16> {
        self.pdos.overdue(now)
    }

    fn dictionary(&self) -> &LiveDictionary {
        &self.dictionary
    }

    fn dictionary_mut(&mut self) -> &mut LiveDictionary {
        &mut self.dictionary
    }
}

fn services(node_id: u8, dictionary: LiveDictionary) -> Box<dyn Services> {
    fn with<const R: usize, const T: usize>(node_id: u8, dictionary: LiveDictionary) -> Box<dyn Services> {
        let pad = |indexes: &[u16], at: usize| indexes.get(at).copied().unwrap_or(0);
        let [rpdos, tpdos] = dictionary.pdos();
        let rpdos: [u16; R] = std::array::from_fn(|at| pad(&rpdos, at));
        let tpdos: [u16; T] = std::array::from_fn(|at| pad(&tpdos, at));
        Box::new(Node::<_, LONGEST, 1, R, T>::new(node_id, dictionary, Pdos::new(rpdos, tpdos)))
    }
    let most = dictionary.pdos().iter().map(Vec::len).max().unwrap_or(0);
    if most <= 16 { with::<16, 16>(node_id, dictionary) } else { with::<512, 512>(node_id, dictionary) }
}

/// A frame that waits for the bus.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pending {
    /// When the node has it ready, in nanoseconds.
    pub(crate) ready: u64,
    pub(crate) frame: BusFrame,
}

/// Guarding as the node takes part in it.
#[derive(Clone, Copy, Debug, Default)]
struct Guarding {
    toggle: u8,
    /// When the last request came.
    asked: Option<u64>,
}

/// SYNC as the node sends it.
#[derive(Clone, Copy, Debug)]
struct Producer {
    /// The period in nanoseconds.
    period: u64,
    next: u64,
    /// The highest counter; 0 without a counter.
    overflow: u8,
    counter: u8,
}

/// A node on the bus. Times are in nanoseconds.
pub(crate) struct SimulatedNode {
    pub(crate) node_id: u8,
    services: Box<dyn Services>,
    /// Monitors other nodes; `None` for the manager, which does so itself.
    consumers: Option<HeartbeatConsumer<127>>,
    guarding: Guarding,
    producer: Option<Producer>,
    /// When a reset ends.
    boots: Option<u64>,
    /// What it waits to send, in its order.
    pub(crate) queue: Vec<Pending>,
    /// The time that it takes for an answer, and for a reset.
    response: u64,
}

impl SimulatedNode {
    /// A node that is switched off.
    pub(crate) fn new(node_id: u8, dictionary: LiveDictionary, response: u64, is_manager: bool) -> Self {
        Self {
            node_id,
            services: services(node_id, dictionary),
            consumers: (!is_manager).then(HeartbeatConsumer::new),
            guarding: Guarding::default(),
            producer: None,
            boots: None,
            queue: Vec::new(),
            response,
        }
    }

    /// The NMT state.
    pub(crate) fn state(&self) -> NmtState {
        self.services.state()
    }

    pub(crate) fn dictionary(&self) -> &LiveDictionary {
        self.services.dictionary()
    }

    /// The CAN-ID of its emergency messages.
    pub(crate) fn emergency_id(&self) -> u16 {
        let dictionary = self.dictionary();
        let is_stated = dictionary.has(0x1014, 0);
        if is_stated { (dictionary.word(0x1014, 0) & 0x7FF) as u16 } else { 0x80 + u16::from(self.node_id) }
    }

    /// Whether it sends and receives more than NMT and error control.
    fn communicates(&self) -> bool {
        matches!(self.state(), NmtState::PreOperational | NmtState::Operational)
    }

    /// Sends a frame as soon as it is ready and the bus is free.
    pub(crate) fn send(&mut self, ready: u64, frame: impl Into<BusFrame>) {
        self.queue.push(Pending { ready, frame: frame.into() });
    }

    /// Asks for the frame with a CAN-ID.
    pub(crate) fn queue_remote(&mut self, id: u16, ready: u64) {
        if let Some(frame) = BusFrame::remote(id) {
            self.send(ready, frame);
        }
    }

    /// Starts the node with the values of its dictionary.
    pub(crate) fn boot(&mut self, now: u64) -> Frame {
        let frame = self.services.boot(micro(now));
        self.guarding = Guarding::default();
        self.load_consumers();
        self.services.dictionary_mut().take_written();
        self.load_producer(now);
        frame
    }

    /// Obeys a command of its own NMT master, which is the node itself.
    pub(crate) fn obey(&mut self, command: u8, now: u64) {
        if let Some(frame) = Frame::new(0, &[command, self.node_id]) {
            self.receive(&frame.into(), now);
        }
    }

    /// Takes a frame of another node.
    pub(crate) fn receive(&mut self, frame: &BusFrame, now: u64) {
        let Some(data) = frame.data_frame() else { return self.receive_remote(frame, now) };
        match self.services.receive(data, micro(now)) {
            Received::Answer(answer) => self.send(now + self.response, answer),
            Received::Nmt(command @ (NmtCommand::ResetNode | NmtCommand::ResetCommunication)) => {
                self.queue.clear();
                self.producer = None;
                self.services.dictionary_mut().reset(command == NmtCommand::ResetNode);
                self.boots = Some(now + self.response);
            }
            Received::Nmt(_) => self.load_producer(now),
            Received::Pdo(Reception::TooShort(index)) => self.report(PDO_TOO_SHORT, index, now),
            Received::Pdo(_) | Received::Ignored => {}
        }
        if let Some(consumers) =
            self.consumers.as_mut().filter(|_| self.services.state() != NmtState::Initialising)
        {
            consumers.receive(data, micro(now));
        }
        self.follow(now);
    }

    /// Answers a guarding request of the manager (CiA 301 §7.2.8.2.2.1). A node with a heartbeat is not guarded.
    fn receive_remote(&mut self, frame: &BusFrame, now: u64) {
        let is_guarded = self.dictionary().has(0x100C, 0) && self.dictionary().word(0x1017, 0) == 0;
        if frame.id() != error_control(self.node_id) || !is_guarded || self.state() == NmtState::Initialising
        {
            return;
        }
        let state = self.state().code() | self.guarding.toggle;
        self.guarding = Guarding { toggle: self.guarding.toggle ^ 0x80, asked: Some(now) };
        if let Some(answer) = Frame::new(frame.id(), &[state]) {
            self.send(now + self.response, answer);
        }
    }

    /// Does what is due by now.
    pub(crate) fn poll(&mut self, now: u64) {
        if self.boots.is_some_and(|at| at <= now) {
            self.boots = None;
            let frame = self.boot(now);
            self.send(now, frame);
        }
        while let Some(frame) = self.services.poll(micro(now)) {
            self.send(now, frame);
        }
        while let Some(index) = self.services.overdue(micro(now)) {
            self.report(RPDO_TIMED_OUT, index, now);
        }
        while let Some(Heartbeat::Lost(_)) =
            self.consumers.as_mut().and_then(|consumers| consumers.poll(micro(now)))
        {
            self.fail(now);
        }
        self.guard(now);
        self.produce(now);
    }

    /// The next time at which something is due to the nanosecond: what is due to the millisecond is found by polling.
    pub(crate) fn next(&self) -> Option<u64> {
        [self.boots, self.producer.map(|producer| producer.next)].into_iter().flatten().min()
    }

    /// Follows what SDOs wrote.
    fn follow(&mut self, now: u64) {
        for index in self.services.dictionary_mut().take_written() {
            match index {
                0x1016 => self.load_consumers(),
                0x1005 | 0x1006 | 0x1019 => self.load_producer(now),
                _ => {}
            }
        }
    }

    fn load_consumers(&mut self) {
        if let Some(consumers) = &mut self.consumers {
            consumers.load(self.services.dictionary_mut());
        }
    }

    /// Reads whether and how it sends SYNC (1005h, 1006h, 1019h).
    fn load_producer(&mut self, now: u64) {
        let dictionary = self.dictionary();
        let (cob_id, period) = (dictionary.word(0x1005, 0), u64::from(dictionary.word(0x1006, 0)) * 1000);
        let overflow = dictionary.word(0x1019, 0) as u8;
        if cob_id >> 30 & 1 == 0 || period == 0 || !self.communicates() {
            self.producer = None;
        } else if self
            .producer
            .is_none_or(|producer| producer.period != period || producer.overflow != overflow)
        {
            self.producer = Some(Producer { period, next: now + period, overflow, counter: 0 });
        }
    }

    fn produce(&mut self, now: u64) {
        let Some(producer) = self.producer.as_mut().filter(|producer| producer.next <= now) else { return };
        producer.next += producer.period;
        let counter = (producer.overflow > 1).then(|| {
            producer.counter = producer.counter % producer.overflow + 1;
            producer.counter
        });
        let id = (self.services.dictionary().word(0x1005, 0) & 0x7FF) as u16;
        if let Some(sync) = Frame::new(id, counter.as_slice()) {
            self.send(now, sync);
        }
    }

    /// Whether it sends this frame as SYNC, which is SYNC for its own PDOs too.
    pub(crate) fn is_own_sync(&self, frame: &BusFrame) -> bool {
        self.producer.is_some() && u32::from(frame.id()) == self.dictionary().word(0x1005, 0) & 0x7FF
    }

    /// Life guarding: requests that do not come any more.
    fn guard(&mut self, now: u64) {
        let dictionary = self.dictionary();
        let life =
            u64::from(dictionary.word(0x100C, 0)) * u64::from(dictionary.word(0x100D, 0)) * MILLISECOND;
        if life != 0 && self.guarding.asked.is_some_and(|asked| now.saturating_sub(asked) > life) {
            self.guarding.asked = None;
            self.fail(now);
        }
    }

    /// Reports that another node is lost, and does what 1029h says of communication errors (CiA 301 §7.5.2.32).
    fn fail(&mut self, now: u64) {
        self.report(GUARDING_LOST, 0, now);
        let reaction = self.dictionary().bytes(0x1029, 1).and_then(|bytes| bytes.first().copied());
        match reaction.unwrap_or(0) {
            0 if self.state() == NmtState::Operational => self.obey(0x80, now),
            2 => self.obey(2, now),
            _ => {}
        }
    }

    /// Sends EMCY with an error code; a PDO is named by its number in the bytes of the vendor.
    fn report(&mut self, code: u16, pdo: u16, now: u64) {
        if !self.communicates() {
            return;
        }
        let number = if pdo == 0 { 0 } else { (pdo & 0x1FF) + 1 };
        let [low, high] = number.to_le_bytes();
        let dictionary = self.services.dictionary_mut();
        dictionary.put(0x1001, 0, &[COMMUNICATION]);
        if let Some(frame) = emergency(dictionary, self.node_id, code, COMMUNICATION, [low, high, 0, 0, 0]) {
            self.send(now, frame);
        }
    }
}

/// The CAN-ID of boot-up, heartbeat and guarding.
pub(crate) const fn error_control(node_id: u8) -> u16 {
    0x700 + node_id as u16
}

/// Nanoseconds as the microseconds of `objdict-device`.
pub(crate) const fn micro(now: u64) -> u64 {
    now / 1000
}
