//! A node: `objdict-device` over the dictionary of a description, with what its application adds: resets and guarding.

use objdict_device::{Dictionary, Frame, NmtCommand, NmtState, Node, Pdos, Received, error_code};

use crate::dictionary::LiveDictionary;
use crate::frame::BusFrame;

/// The longest value of an SDO, in bytes.
const LONGEST: usize = 1 << 16;
/// What most devices need: each check copies a node with its buffers.
const SHORT: usize = 1 << 9;

/// Nanoseconds of a millisecond.
pub(crate) const MILLISECOND: u64 = 1_000_000;

/// The services of a device, for any dictionary and any number of PDOs.
pub(crate) trait NodeServices {
    fn boot(&mut self, now: u64) -> Frame;
    fn state(&self) -> NmtState;
    fn receive(&mut self, frame: &Frame, now: u64) -> Received;
    fn poll(&mut self, now: u64) -> Option<Frame>;
    fn next(&self, now: u64) -> Option<u64>;
    fn report(&mut self, code: u16);
    /// The same node as it is now.
    fn again(&self) -> Box<dyn NodeServices>;
}

/// The services of a simulated node, and its values.
trait LiveServices: NodeServices {
    fn dictionary(&self) -> &LiveDictionary;
}

impl<
    D: Dictionary + Clone + 'static,
    const B: usize,
    const C: usize,
    const R: usize,
    const T: usize,
    const N: usize,
> NodeServices for Node<D, B, C, R, T, N>
{
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

    fn next(&self, now: u64) -> Option<u64> {
        Self::next(self, now)
    }

    fn report(&mut self, code: u16) {
        Self::report(self, code, [0; 5]);
    }

    fn again(&self) -> Box<dyn NodeServices> {
        Box::new(self.clone())
    }
}

impl<const C: usize, const R: usize, const T: usize, const N: usize> LiveServices
    for Node<LiveDictionary, LONGEST, C, R, T, N>
{
    fn dictionary(&self) -> &LiveDictionary {
        &self.dictionary
    }
}

/// The most PDOs of a kind in a small node.
const FEW: usize = 16;
/// The most PDOs of a kind that there are.
const ALL: usize = 512;

/// A node with these PDOs, in so much room.
fn node<D: Dictionary, const B: usize, const C: usize, const P: usize, const N: usize>(
    node_id: u8,
    dictionary: D,
    [rpdos, tpdos]: &[Vec<u16>; 2],
) -> Box<Node<D, B, C, P, P, N>> {
    let padded = |indexes: &[u16]| std::array::from_fn(|at| indexes.get(at).copied().unwrap_or(0));
    Box::new(Node::new(node_id, dictionary, Pdos::new(padded(rpdos), padded(tpdos))))
}

fn has_few(pdos: &[Vec<u16>; 2]) -> bool {
    pdos.iter().all(|pdos| pdos.len() <= FEW)
}

fn services(node_id: u8, dictionary: LiveDictionary, is_manager: bool) -> Box<dyn LiveServices> {
    let pdos = dictionary.pdos();
    match (has_few(&pdos), is_manager) {
        (true, false) => node::<_, LONGEST, 1, FEW, 127>(node_id, dictionary, &pdos),
        (false, false) => node::<_, LONGEST, 1, ALL, 127>(node_id, dictionary, &pdos),
        // a manager monitors its nodes itself
        (true, true) => node::<_, LONGEST, 1, FEW, 0>(node_id, dictionary, &pdos),
        (false, true) => node::<_, LONGEST, 1, ALL, 0>(node_id, dictionary, &pdos),
    }
}

/// A node alone, with a second SDO server, over any dictionary with these PDOs and values of at most `longest` bytes.
pub(crate) fn lone<D: Dictionary + Clone + 'static>(
    node_id: u8,
    dictionary: D,
    pdos: &[Vec<u16>; 2],
    longest: usize,
) -> Box<dyn NodeServices> {
    match (has_few(pdos), longest <= SHORT) {
        (true, true) => node::<_, SHORT, 2, FEW, 127>(node_id, dictionary, pdos),
        (true, false) => node::<_, LONGEST, 2, FEW, 127>(node_id, dictionary, pdos),
        (false, _) => node::<_, LONGEST, 2, ALL, 127>(node_id, dictionary, pdos),
    }
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

/// A node on the bus. Times are in nanoseconds.
pub(crate) struct SimulatedNode {
    pub(crate) node_id: u8,
    services: Box<dyn LiveServices>,
    guarding: Guarding,
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
            services: services(node_id, dictionary, is_manager),
            guarding: Guarding::default(),
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
            Received::Nmt(NmtCommand::ResetNode | NmtCommand::ResetCommunication) => {
                self.queue.clear();
                self.boots = Some(now + self.response);
            }
            Received::Nmt(_) | Received::Pdo(_) | Received::Heartbeat(_) | Received::Ignored => {}
        }
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
        self.guard(now);
    }

    /// The next time at which something is due.
    pub(crate) fn next(&self, now: u64) -> Option<u64> {
        // what is due within a microsecond is due at its end
        let due = self.services.next(micro(now)).map(|due| due * 1000);
        self.boots.into_iter().chain(due).chain(self.guard_ends()).min()
    }

    /// When the requests of life guarding are missing.
    fn guard_ends(&self) -> Option<u64> {
        let dictionary = self.dictionary();
        let life =
            u64::from(dictionary.word(0x100C, 0)) * u64::from(dictionary.word(0x100D, 0)) * MILLISECOND;
        self.guarding.asked.filter(|_| life != 0).map(|asked| asked + life + 1)
    }

    /// Life guarding: requests that do not come any more.
    fn guard(&mut self, now: u64) {
        if self.guard_ends().is_some_and(|end| end <= now) {
            self.guarding.asked = None;
            self.services.report(error_code::HEARTBEAT);
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
