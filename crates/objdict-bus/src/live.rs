//! A simulated bus without a manager: a program takes its place.

use std::collections::VecDeque;

use objdict_device::{Frame, LssReceived, LssSlave};

use crate::dictionary::{LiveDictionary, PowerOn};
use crate::frame::BusFrame;
use crate::node::{MILLISECOND, Pending, SimulatedNode, micro};
use crate::simulation::{PlantNode, QUEUE};

/// The CAN-ID of LSS requests.
const LSS_REQUEST: u16 = 0x7E5;

/// The bit rates in kbit/s that simulated nodes accept by LSS. Their frames take the time of the bus whichever they store.
const BIT_RATES: &[u16] = &[10, 20, 50, 125, 250, 500, 800, 1000];

/// A node with its LSS slave.
struct LiveNode {
    plant: PlantNode,
    lss: LssSlave,
    /// `None` without a node-ID.
    node: Option<SimulatedNode>,
}

/// Who sends a frame.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sender {
    Client,
    /// The services of a node, by its position, and the frame's position in its queue.
    Node(usize, usize),
    /// LSS slaves, by the position in their queue.
    Lss(usize),
}

/// Simulated nodes that answer a client in simulated time. They are switched on and pre-operational; no node is the manager. The same
/// frames at the same times have the same answers.
pub struct LiveBus {
    bit_rate: u16,
    now: u64,
    nodes: Vec<LiveNode>,
    /// Frames of the client.
    requests: VecDeque<BusFrame>,
    /// Answers to LSS. Equal answers of several nodes are one frame, as on a wire.
    answers: Vec<Pending>,
}

impl LiveBus {
    /// A bus with these nodes and a bit rate in kbit/s. Nodes among `new` come from the factory: defaults, and no node-ID.
    pub fn new(nodes: Vec<PlantNode>, bit_rate: u16, new: &[u8]) -> Self {
        let nodes = nodes.into_iter().map(|plant| LiveNode::new(plant, new)).collect();
        Self { bit_rate, now: 0, nodes, requests: VecDeque::new(), answers: Vec::new() }
    }

    /// The simulated time in nanoseconds.
    pub const fn now(&self) -> u64 {
        self.now
    }

    /// The bit rate in kbit/s.
    pub const fn bit_rate(&self) -> u16 {
        self.bit_rate
    }

    /// Changes the bit rate in kbit/s, of the nodes too.
    pub const fn set_bit_rate(&mut self, bit_rate: u16) {
        self.bit_rate = bit_rate;
    }

    /// Sends a frame of the client as soon as the bus is free.
    pub fn send(&mut self, frame: BusFrame) {
        self.requests.push_back(frame);
    }

    /// Lets time pass until a node sends a frame; `None` if none does until `until`, in nanoseconds.
    pub fn run(&mut self, until: u64) -> Option<(u64, BusFrame)> {
        loop {
            for node in self.nodes.iter_mut().filter_map(|node| node.node.as_mut()) {
                node.poll(self.now);
                node.queue.truncate(QUEUE);
            }
            if let Some((sender, frame)) = self.arbitrate() {
                self.now += frame.duration(self.bit_rate);
                self.deliver(sender, &frame);
                if sender != Sender::Client {
                    return Some((self.now, frame));
                }
            } else if self.now >= until {
                return None;
            } else {
                self.now = self.next().min(until);
            }
        }
    }

    /// Takes the frame that wins the bus.
    fn arbitrate(&mut self) -> Option<(Sender, BusFrame)> {
        let now = self.now;
        let first = |queue: &[Pending]| {
            let ready = queue.iter().enumerate().filter(|(_, pending)| pending.ready <= now);
            ready.min_by_key(|(_, pending)| pending.ready).map(|(at, pending)| (at, pending.frame))
        };
        let of_nodes = self.nodes.iter().enumerate().filter_map(|(node, live)| {
            let (at, frame) = first(&live.node.as_ref()?.queue)?;
            Some((Sender::Node(node, at), frame))
        });
        let of_lss = first(&self.answers).map(|(at, frame)| (Sender::Lss(at), frame));
        let own = self.requests.front().map(|frame| (Sender::Client, *frame));
        let winner = of_nodes.chain(of_lss).chain(own).min_by_key(|(_, frame)| frame.priority())?;
        match winner.0 {
            Sender::Client => drop(self.requests.pop_front()),
            Sender::Lss(at) => _ = self.answers.remove(at),
            Sender::Node(node, at) => {
                self.nodes[node].node.iter_mut().for_each(|node| _ = node.queue.remove(at));
            }
        }
        Some(winner)
    }

    fn deliver(&mut self, sender: Sender, frame: &BusFrame) {
        for (at, node) in self.nodes.iter_mut().enumerate() {
            if matches!(sender, Sender::Node(own, _) if own == at) {
                continue;
            }
            if let Some(answer) = node.receive(frame, self.now) {
                let pending = Pending { ready: self.now + MILLISECOND, frame: answer.into() };
                let is_new = |other: &Pending| (other.ready, other.frame) != (pending.ready, pending.frame);
                if self.answers.iter().all(is_new) {
                    self.answers.push(pending);
                }
            }
        }
    }

    /// When something may happen: timers of milliseconds are looked at each millisecond.
    fn next(&self) -> u64 {
        let nodes = || self.nodes.iter().filter_map(|node| node.node.as_ref());
        let pending = nodes().flat_map(|node| &node.queue).chain(&self.answers).map(|pending| pending.ready);
        let times = pending.chain(nodes().filter_map(|node| node.next(self.now)));
        let tick = (self.now / MILLISECOND + 1) * MILLISECOND;
        times.filter(|time| *time > self.now).min().map_or(tick, |time| time.min(tick))
    }
}

impl LiveNode {
    fn new(mut plant: PlantNode, new: &[u8]) -> Self {
        let is_new = new.contains(&plant.node_id);
        if is_new {
            plant.power_on = PowerOn::Defaults;
        }
        let of_node = LiveDictionary::new(&plant.device, plant.node_id, plant.power_on);
        let identity = [1, 2, 3, 4].map(|sub| of_node.word(0x1018, sub));
        let node_id = Some(plant.node_id).filter(|_| !is_new);
        let lss = LssSlave::new(identity, node_id).with_bit_rates(BIT_RATES).with_storage();
        let mut node = Self { plant, lss, node: None };
        if let Some(node_id) = node_id {
            // it was switched on before the client
            let _ = node.switch_on(node_id, 0);
        }
        node
    }

    /// Starts the node; returns its boot-up message.
    fn switch_on(&mut self, node_id: u8, now: u64) -> Frame {
        let dictionary = LiveDictionary::new(&self.plant.device, node_id, self.plant.power_on);
        let mut node = SimulatedNode::new(node_id, dictionary, MILLISECOND, false);
        let frame = node.boot(now);
        self.node = Some(node);
        frame
    }

    /// Takes a frame; returns the answer of its LSS slave, or the boot-up message with the node-ID that LSS has assigned.
    fn receive(&mut self, frame: &BusFrame, now: u64) -> Option<Frame> {
        if let Some(request) = frame.data_frame().filter(|frame| frame.id() == LSS_REQUEST) {
            return match self.lss.receive(request, micro(now)) {
                LssReceived::Answer(answer) => Some(answer),
                LssReceived::Store { .. } => Some(LssSlave::answer_store(Ok(()))),
                LssReceived::NodeId(node_id) => Some(self.switch_on(node_id, now)),
                LssReceived::Ignored => {
                    // the delays of a change of the bit rate are over at once
                    while self.lss.poll(u64::MAX).is_some() {}
                    None
                }
            };
        }
        let before = self.lss.node_id();
        if is_reset_of(frame, before) && self.lss.reset() != before {
            self.node = None;
            return self.lss.node_id().map(|node_id| self.switch_on(node_id, now));
        }
        self.node.iter_mut().for_each(|node| node.receive(frame, now));
        None
    }
}

/// Whether a frame is the NMT command that resets this node or its communication.
fn is_reset_of(frame: &BusFrame, node_id: Option<u8>) -> bool {
    let of_node = |id: u8| id == 0 || Some(id) == node_id;
    matches!((frame.id(), frame.data()), (0, &[0x81 | 0x82, id]) if of_node(id))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Access, DataType, Device, Entry, Object, ObjectType, Value};

    fn plant(node_id: u8) -> PlantNode {
        let mut device = Device::default();
        let entry = |number| Entry {
            data_type: Some(DataType::UNSIGNED32),
            access: Some(Access::Ro),
            default: Some(Value::Unsigned(number)),
            ..Entry::default()
        };
        let mut identity = Object::default();
        identity.main.object_type = Some(ObjectType::Record);
        identity.subs.insert(1, entry(7));
        identity.subs.insert(2, entry(8));
        device.objects.insert(0x1000, Object { main: entry(0x191), ..Object::default() });
        device.objects.insert(0x1018, identity);
        let (power_on, must_boot) = (PowerOn::Defaults, None);
        PlantNode { name: String::new(), node_id, device, power_on, must_boot }
    }

    fn sent(bus: &mut LiveBus, id: u16, data: &[u8]) -> Vec<(u16, Vec<u8>)> {
        bus.send(Frame::new(id, data).unwrap().into());
        let until = bus.now() + 50 * MILLISECOND;
        std::iter::from_fn(|| bus.run(until)).map(|(_, frame)| (frame.id(), frame.data().to_vec())).collect()
    }

    #[test]
    fn nodes_answer_and_lss_gives_a_new_one_its_node_id() {
        let mut bus = LiveBus::new(vec![plant(5), plant(6)], 500, &[6]);
        let read = [0x40, 0, 0x10, 0, 0, 0, 0, 0];
        let answer = vec![(0x585, vec![0x43, 0, 0x10, 0, 0x91, 1, 0, 0])];
        assert_eq!(sent(&mut bus, 0x605, &read), answer);
        assert_eq!(sent(&mut bus, 0x606, &read), [], "it has no node-ID");
        assert_eq!(sent(&mut bus, 0x7E5, &[4, 1, 0, 0, 0, 0, 0, 0]), []);
        let inquired = sent(&mut bus, 0x7E5, &[0x5A, 0, 0, 0, 0, 0, 0, 0]);
        assert_eq!(inquired, [(0x7E4, vec![0x5A, 7, 0, 0, 0, 0, 0, 0])], "one frame, though both answer");
        let chosen: [[u8; 8]; 5] = [
            [4, 0, 0, 0, 0, 0, 0, 0],
            [0x40, 7, 0, 0, 0, 0, 0, 0],
            [0x41, 8, 0, 0, 0, 0, 0, 0],
            [0x42, 0, 0, 0, 0, 0, 0, 0],
            [0x43, 0, 0, 0, 0, 0, 0, 0],
        ];
        let answers = chosen.map(|data| sent(&mut bus, 0x7E5, &data));
        assert_eq!(answers[4], [(0x7E4, vec![0x44, 0, 0, 0, 0, 0, 0, 0])]);
        assert_eq!(sent(&mut bus, 0, &[0x82, 5]), [(0x705, vec![0])]);
    }
}
