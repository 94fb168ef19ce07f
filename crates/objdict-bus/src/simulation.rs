//! The bus: who may send next, and when what happens.
//!
//! Time is simulated: frames in nanoseconds, timers of nodes every millisecond. A run therefore gives the same
//! result on every machine.

use std::collections::BTreeMap;

use objdict_device::{NmtState, error_code};

use crate::dictionary::{LiveDictionary, PowerOn};
use crate::frame::BusFrame;
use crate::manager::{Configurations, Milestone, RunningManager};
use crate::model::Device;
use crate::node::{MILLISECOND, SimulatedNode};
use crate::run::{Cut, Event, EventKind, NodeRun, Run};

/// A network before the manager is switched on.
#[derive(Clone, Debug)]
pub struct Plant {
    /// The bit rate in kbit/s.
    pub bit_rate: u16,
    /// The manager.
    pub manager: PlantNode,
    /// What the manager has in 1F22h.
    pub configurations: Configurations,
    /// The other nodes on the bus. They are switched on and pre-operational.
    pub nodes: Vec<PlantNode>,
}

/// A node of a plant.
#[derive(Clone, Debug)]
pub struct PlantNode {
    /// The name.
    pub name: String,
    /// The node-ID, 1 to 127.
    pub node_id: u8,
    /// The description.
    pub device: Device,
    /// The values that it has.
    pub power_on: PowerOn,
    /// Whether the manager must boot it; `None` if that is what 1F81h says. A node without 1F81h must be booted.
    pub must_boot: Option<bool>,
}

impl PlantNode {
    /// The description with the values that the node is switched on with, where they are not its defaults.
    pub fn switched_on(&self) -> Device {
        self.power_on.values_of(&self.device)
    }
}

/// The conditions of a simulation. Times are in nanoseconds.
#[derive(Clone, Copy, Debug)]
pub struct Conditions {
    /// The time that a node takes for the answer to an SDO or a guarding request, and for a reset.
    pub response: u64,
    /// How long the network runs after its boot.
    pub after: u64,
    /// The longest simulated time.
    pub limit: u64,
    /// The most frames.
    pub frames: usize,
}

impl Default for Conditions {
    /// Answers after 1 ms; 100 ms after the boot; at most 60 s and 500,000 frames.
    fn default() -> Self {
        Self { response: MILLISECOND, after: 100 * MILLISECOND, limit: 60_000 * MILLISECOND, frames: 500_000 }
    }
}

/// The most frames of a node that wait for the bus. A node with all its PDOs has fewer at once.
pub(crate) const QUEUE: usize = 10_000;

/// How long the manager must have waited for boot-up messages alone until no node is expected any more.
const PATIENCE: u64 = 1500 * MILLISECOND;

/// Boots a network in simulated time: the manager is switched on at time 0.
pub fn boot(plant: &Plant, conditions: &Conditions) -> Run {
    let mut simulation = Simulation::new(plant, *conditions);
    let cut = simulation.run();
    simulation.finish(plant, cut)
}

/// A frame on the wire.
#[derive(Clone, Copy)]
struct Transmission {
    end: u64,
    sender: usize,
    frame: BusFrame,
}

struct Simulation {
    bit_rate: u16,
    conditions: Conditions,
    now: u64,
    manager: RunningManager,
    /// The manager, then the others; `None` for a node that is not on the bus.
    nodes: Vec<Option<SimulatedNode>>,
    runs: Vec<NodeRun>,
    wire: Option<Transmission>,
    events: Vec<Event>,
    frames: usize,
    busy: u64,
    /// Who sent a CAN-ID first, and whether a second sender is reported.
    senders: BTreeMap<u16, (usize, bool)>,
    /// Since when the manager waits for boot-up messages alone.
    idle: Option<u64>,
    /// Since when all nodes are as they must be.
    arrived: Option<u64>,
}

impl Simulation {
    fn new(plant: &Plant, conditions: Conditions) -> Self {
        let of_manager = dictionary(&plant.manager);
        let manager = RunningManager::new(plant.manager.node_id, &of_manager, &plant.configurations);
        let own = SimulatedNode::new(plant.manager.node_id, of_manager, conditions.response, true);
        let mut simulation = Self {
            bit_rate: plant.bit_rate,
            conditions,
            now: 0,
            runs: vec![node_run(&plant.manager, true, None)],
            nodes: vec![Some(own)],
            manager,
            wire: None,
            events: Vec::new(),
            frames: 0,
            busy: 0,
            senders: BTreeMap::new(),
            idle: None,
            arrived: None,
        };
        simulation.runs[0].must_boot = simulation.manager.startup().operates();
        simulation.add_nodes(plant);
        simulation
    }

    /// The nodes on the bus, and those that the manager alone knows.
    fn add_nodes(&mut self, plant: &Plant) {
        let assignments: BTreeMap<u8, u32> =
            self.manager.assignments().map(|(node_id, assignment)| (node_id, assignment.0)).collect();
        let mut nodes: Vec<(NodeRun, Option<SimulatedNode>)> = Vec::new();
        for node in &plant.nodes {
            let mut on_bus =
                SimulatedNode::new(node.node_id, dictionary(node), self.conditions.response, false);
            // it was switched on before the manager
            let _ = on_bus.boot(0);
            nodes.push((node_run(node, false, assignments.get(&node.node_id).copied()), Some(on_bus)));
        }
        for (&node_id, &assignment) in &assignments {
            if plant.nodes.iter().all(|node| node.node_id != node_id) {
                let missing = PlantNode {
                    name: format!("node {node_id}"),
                    node_id,
                    device: Device::default(),
                    power_on: PowerOn::Defaults,
                    must_boot: None,
                };
                nodes.push((node_run(&missing, false, Some(assignment)), None));
            }
        }
        nodes.sort_by_key(|(run, _)| run.node_id);
        for (run, node) in nodes {
            self.runs.push(run);
            self.nodes.push(node);
        }
    }

    fn run(&mut self) -> Option<Cut> {
        if let Some(own) = &mut self.nodes[0] {
            let frame = own.boot(0);
            own.send(0, frame);
            if self.manager.startup().is_master() {
                self.manager.start(own, 0);
            }
        }
        loop {
            self.deliver();
            self.poll();
            if self.is_over() {
                return None;
            }
            if self.frames >= self.conditions.frames {
                return Some(Cut::Frames);
            }
            if self.nodes.iter().flatten().any(|node| node.queue.len() > QUEUE) {
                return Some(Cut::Overload);
            }
            self.arbitrate();
            let next = self.next();
            if next > self.conditions.limit {
                return Some(Cut::Time);
            }
            self.now = next;
        }
    }

    /// Gives a frame that has ended to all nodes.
    fn deliver(&mut self) {
        let Some(Transmission { sender, frame, .. }) = self.wire.filter(|wire| wire.end <= self.now) else {
            return;
        };
        self.wire = None;
        self.frames += 1;
        self.record(EventKind::Frame { sender, frame });
        self.look_for_conflict(sender, &frame);
        if self.nodes[sender].as_ref().is_some_and(|node| node.emergency_id() == frame.id()) {
            self.take_emergency(sender, frame.data());
        }
        for (at, node) in self.nodes.iter_mut().enumerate() {
            let Some(node) = node else { continue };
            if at != sender {
                node.receive(&frame, self.now);
            }
        }
        if let Some(own) = self.nodes[0].as_mut().filter(|_| sender != 0) {
            self.manager.receive(&frame, own, self.now);
        }
    }

    /// Counts an emergency. A node that starts by itself may disturb others until the manager has configured it, so an error that
    /// is over before all nodes are as they must be is none. Neither is a PDO that is longer than its mapping, whose first bytes
    /// the node takes.
    fn take_emergency(&mut self, sender: usize, data: &[u8]) {
        let run = &mut self.runs[sender];
        run.emergencies += 1;
        const TOO_LONG: [u8; 2] = error_code::PDO_TOO_LONG.to_le_bytes();
        match data {
            _ if data.starts_with(&TOO_LONG) => {}
            [_, _, 0, ..] if self.arrived.is_none() => run.errors = 0,
            [0, 0, ..] => {}
            _ => run.errors += usize::from(run.state == Some(NmtState::Operational)),
        }
    }

    fn look_for_conflict(&mut self, sender: usize, frame: &BusFrame) {
        if frame.is_remote() {
            return;
        }
        let (first, is_reported) = self.senders.entry(frame.id()).or_insert((sender, false));
        if *first != sender && !*is_reported {
            *is_reported = true;
            let senders = [*first, sender];
            self.record(EventKind::TwoSenders { id: frame.id(), senders });
        }
    }

    /// Lets all nodes do what is due.
    fn poll(&mut self) {
        for node in self.nodes.iter_mut().flatten() {
            node.poll(self.now);
        }
        if let Some(own) = &mut self.nodes[0] {
            self.manager.poll(own, self.now);
        }
        for (node_id, milestone) in self.manager.take_milestones() {
            self.reach(node_id, milestone);
        }
        for at in 0..self.nodes.len() {
            let Some(state) = self.nodes[at].as_ref().map(SimulatedNode::state) else { continue };
            if self.runs[at].state != Some(state) {
                self.runs[at].state = Some(state);
                self.runs[at].operational = (state == NmtState::Operational).then_some(self.now);
                self.record(EventKind::State { node: at, state });
            }
        }
    }

    fn reach(&mut self, node_id: u8, milestone: Milestone) {
        let Some(at) = self.runs.iter().position(|run| run.node_id == node_id) else { return };
        let has_booted = matches!(milestone, Milestone::Booted | Milestone::Running);
        self.runs[at].booted = has_booted.then_some(self.now);
        self.runs[at].milestone = Some(milestone.clone());
        self.record(EventKind::Milestone { node: at, milestone });
    }

    fn record(&mut self, kind: EventKind) {
        self.events.push(Event { time: self.now, kind });
    }

    /// Whether the boot has succeeded some time ago, or nothing more will happen.
    fn is_over(&mut self) -> bool {
        let waits = !self.manager.startup().leads_to_operational();
        let has_arrived = self.runs.iter().all(|run| run.has_arrived(waits));
        // a manager without nodes to boot is not done before it knows those that are there
        self.arrived = if has_arrived { self.arrived.or(Some(self.now)) } else { None };
        self.idle = if self.manager.is_idle(self.now) { self.idle.or(Some(self.now)) } else { None };
        let since = |time: Option<u64>, duration| time.is_some_and(|time| self.now - time >= duration);
        since(self.arrived, self.conditions.after) || since(self.idle, PATIENCE)
    }

    /// Puts the frame with the highest priority on a free wire. Each node sends its frames in their order.
    fn arbitrate(&mut self) {
        if self.wire.is_some() {
            return;
        }
        let first = |node: &SimulatedNode| {
            let ready = node.queue.iter().enumerate().filter(|(_, pending)| pending.ready <= self.now);
            ready.min_by_key(|(_, pending)| pending.ready).map(|(at, pending)| (at, pending.frame))
        };
        let offers = self.nodes.iter().enumerate().filter_map(|(sender, node)| {
            let (at, frame) = first(node.as_ref()?)?;
            Some((frame, sender, at))
        });
        let Some((frame, sender, at)) = offers.min_by_key(|(frame, ..)| frame.priority()) else { return };
        if let Some(node) = &mut self.nodes[sender] {
            node.queue.remove(at);
        }
        let duration = frame.duration(self.bit_rate);
        self.busy += duration;
        self.wire = Some(Transmission { end: self.now + duration, sender, frame });
    }

    /// The next time at which something happens. Timers of milliseconds are looked at each millisecond.
    fn next(&self) -> u64 {
        let tick = (self.now / MILLISECOND + 1) * MILLISECOND;
        let nodes = self.nodes.iter().flatten();
        let pending = nodes.clone().flat_map(|node| &node.queue).map(|pending| pending.ready);
        let due = nodes.filter_map(|node| node.next(self.now)).chain(self.manager.next());
        let times = pending.chain(due).chain(self.wire.map(|wire| wire.end));
        times.filter(|time| *time > self.now).min().map_or(tick, |time| time.min(tick))
    }

    fn finish(mut self, plant: &Plant, cut: Option<Cut>) -> Run {
        let waits_for_application = !self.manager.startup().leads_to_operational();
        for (at, node) in self.nodes.iter().enumerate() {
            let Some(node) = node else { continue };
            let run = &mut self.runs[at];
            run.downloads = self.manager.accepted(run.node_id);
            let of = plant.nodes.iter().chain([&plant.manager]).find(|of| of.node_id == run.node_id);
            run.device = of.map(|of| node.dictionary().present(&of.device));
        }
        let pending = self.nodes.iter().flatten().flat_map(|node| &node.queue);
        let waiting = pending.map(|pending| self.now.saturating_sub(pending.ready)).max().unwrap_or(0);
        let is_operational = self.runs.iter().all(|run| run.has_arrived(false));
        let times = self.runs.iter().filter(|run| run.must_boot).filter_map(|run| run.operational);
        Run {
            operational: times.max().filter(|_| is_operational),
            events: self.events,
            nodes: self.runs,
            waits_for_application,
            end: self.now,
            busy: self.busy,
            waiting,
            cut,
        }
    }
}

fn dictionary(node: &PlantNode) -> LiveDictionary {
    LiveDictionary::new(&node.device, node.node_id, node.power_on)
}

fn node_run(node: &PlantNode, is_manager: bool, assignment: Option<u32>) -> NodeRun {
    let boots = assignment.is_none_or(|assignment| assignment & 5 == 5);
    NodeRun {
        name: node.name.clone(),
        node_id: node.node_id,
        is_manager,
        must_boot: node.must_boot.unwrap_or(boots),
        assignment,
        device: None,
        state: None,
        milestone: None,
        booted: None,
        operational: None,
        downloads: 0,
        emergencies: 0,
        errors: 0,
    }
}
