//! The NMT master that boots a network and monitors it (CiA 302-2), with the configuration manager (CiA 302-3).

mod boot;
mod failure;
mod slave;

use objdict_device::{Frame, NmtState};

pub use self::failure::BootFailure;
pub use self::slave::Configurations;
pub(crate) use self::slave::SlaveAssignment;
use self::slave::{ManagedSlave, Monitor, SlaveStep};
use crate::client::ClientProgress;
use crate::dictionary::LiveDictionary;
use crate::frame::BusFrame;
use crate::node::{MILLISECOND, SimulatedNode, error_control};

const START: u8 = 1;
const STOP: u8 = 2;
const RESET_NODE: u8 = 0x81;
const RESET_COMMUNICATION: u8 = 0x82;

/// Nanoseconds after which the manager gives a restarting node up, and begins again with one that does not answer.
const PATIENCE: u64 = 1000 * MILLISECOND;

/// Nanoseconds that the manager waits for a boot-up message before it asks a mandatory node without one.
const BOOT_UP: u64 = 500 * MILLISECOND;

/// Nanoseconds that the manager waits for the answer to a guarding request when it looks for the state of a node.
const GUARDING: u64 = 100 * MILLISECOND;

/// Something that the manager found out.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Milestone {
    /// The node is configured and monitored, so it can be started.
    Booted,
    /// The node was operational already and is left alone.
    Running,
    /// The node is not booted.
    Failed(BootFailure),
    /// The heartbeat of the node is missing, or it does not answer to guarding any more.
    Lost,
}

/// The bits of 1F80h.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StartupBits(u32);

impl StartupBits {
    const fn has(self, bit: u32) -> bool {
        self.0 >> bit & 1 == 1
    }

    pub(crate) const fn is_master(self) -> bool {
        self.has(0)
    }

    /// Whether all nodes are started by one command.
    const fn starts_together(self) -> bool {
        self.has(1)
    }

    /// Whether the manager becomes operational by itself.
    pub(crate) const fn operates(self) -> bool {
        !self.has(2)
    }

    const fn starts_nodes(self) -> bool {
        !self.has(3)
    }

    /// Whether nodes become operational without a word of the application.
    pub(crate) const fn leads_to_operational(self) -> bool {
        self.starts_nodes() && (self.operates() || !self.starts_together())
    }
}

/// The manager. Its own services are those of a node.
pub(crate) struct RunningManager {
    startup: StartupBits,
    /// Within this time mandatory nodes must answer (1F89h), in nanoseconds; 0: for ever.
    boot_time: u64,
    /// The time between two commands (102Ah), in nanoseconds.
    inhibit_time: u64,
    began: u64,
    /// When the next command may be sent.
    next_command: u64,
    slaves: Vec<ManagedSlave>,
    /// Whether a mandatory node failed.
    is_halted: bool,
    /// Whether the start-up is over.
    is_started: bool,
    /// What was found out since the last look, each with the node-ID.
    milestones: Vec<(u8, Milestone)>,
}

impl RunningManager {
    /// The manager whose objects are in a dictionary.
    pub(crate) fn new(node_id: u8, dictionary: &LiveDictionary, configurations: &Configurations) -> Self {
        let is_slave = |id: &u8| *id != node_id && SlaveAssignment(dictionary.word(0x1F81, *id)).is_slave();
        Self {
            startup: StartupBits(dictionary.word(0x1F80, 0)),
            boot_time: u64::from(dictionary.word(0x1F89, 0)) * MILLISECOND,
            inhibit_time: u64::from(dictionary.word(0x102A, 0)) * MILLISECOND / 10,
            began: 0,
            next_command: 0,
            slaves: (1..=127)
                .filter(is_slave)
                .map(|id| ManagedSlave::new(id, dictionary, configurations))
                .collect(),
            is_halted: false,
            is_started: false,
            milestones: Vec::new(),
        }
    }

    pub(crate) const fn startup(&self) -> StartupBits {
        self.startup
    }

    /// The nodes that it manages.
    pub(crate) fn assignments(&self) -> impl Iterator<Item = (u8, SlaveAssignment)> {
        self.slaves.iter().map(|slave| (slave.node_id, slave.assignment))
    }

    /// The downloads that a node accepted in its last boot.
    pub(crate) fn accepted(&self, node_id: u8) -> usize {
        self.slaves.iter().find(|slave| slave.node_id == node_id).map_or(0, |slave| slave.accepted)
    }

    pub(crate) fn take_milestones(&mut self) -> Vec<(u8, Milestone)> {
        std::mem::take(&mut self.milestones)
    }

    /// Starts the network: resets the communication of all nodes but those that may be operational, and boots those that do not
    /// send a boot-up message for it.
    pub(crate) fn start(&mut self, own: &mut SimulatedNode, now: u64) {
        self.began = now;
        if self.slaves.iter().any(|slave| slave.assignment.is_kept_alive()) {
            let others = self.slaves.iter().filter(|slave| !slave.assignment.is_kept_alive());
            let others: Vec<u8> = others.map(|slave| slave.node_id).collect();
            others.into_iter().for_each(|id| self.command(RESET_COMMUNICATION, id, own, now));
        } else {
            self.command(RESET_COMMUNICATION, 0, own, now);
        }
        for at in 0..self.slaves.len() {
            let slave = &mut self.slaves[at];
            if slave.assignment.is_kept_alive() {
                self.begin(at, own, now);
            } else if slave.assignment.is_mandatory() {
                slave.step = SlaveStep::BootUp(now + BOOT_UP);
            }
        }
        self.go_on(own, now);
    }

    /// Takes a frame of a node.
    pub(crate) fn receive(&mut self, frame: &BusFrame, own: &mut SimulatedNode, now: u64) {
        let Some(data) = frame.data_frame() else { return };
        let at =
            |base: u16| self.slaves.iter().position(|slave| frame.id() == base + u16::from(slave.node_id));
        if let Some(at) = at(0x580) {
            let progress = self.slaves[at].client.receive(data, now);
            self.advance(at, progress, own, now);
        } else if let (Some(at), Some(&state)) = (at(0x700), data.data().first()) {
            match state {
                0 => self.take_boot_up(at, own, now),
                state => self.take_state(at, state, own, now),
            }
        }
    }

    /// Does what is due by now.
    pub(crate) fn poll(&mut self, own: &mut SimulatedNode, now: u64) {
        for at in 0..self.slaves.len() {
            let progress = self.slaves[at].client.poll(now);
            self.advance(at, progress, own, now);
            if self.slaves[at].step.until().is_some_and(|until| until <= now) {
                self.give_up_waiting(at, own, now);
            }
            self.monitor(at, own, now);
        }
    }

    /// When [`RunningManager::poll`] has to be called.
    pub(crate) fn next(&self) -> Option<u64> {
        let of = |slave: &ManagedSlave| {
            let monitor = match slave.monitor {
                Monitor::None => None,
                Monitor::Heartbeat(last) => Some(last + u64::from(slave.consumer_time) * MILLISECOND + 1),
                Monitor::Guarding(next, _) => Some(next),
            };
            [slave.client.next(), slave.step.until(), monitor].into_iter().flatten().min()
        };
        self.slaves.iter().filter_map(of).min()
    }

    /// Whether it waits for nothing but boot-up messages, and its inhibit time holds no command back.
    pub(crate) fn is_idle(&self, now: u64) -> bool {
        let is_idle = |slave: &ManagedSlave| matches!(slave.step, SlaveStep::Idle | SlaveStep::Finished);
        self.next_command <= now.saturating_add(self.inhibit_time) && self.slaves.iter().all(is_idle)
    }

    /// Sends an NMT command, to all nodes if the node-ID is 0.
    fn command(&mut self, command: u8, node_id: u8, own: &mut SimulatedNode, now: u64) {
        let ready = self.next_command.max(now);
        self.next_command = ready + self.inhibit_time;
        if let Some(frame) = Frame::new(0, &[command, node_id]) {
            own.send(ready, frame);
        }
    }

    /// Becomes operational when all mandatory nodes are booted.
    fn go_on(&mut self, own: &mut SimulatedNode, now: u64) {
        let is_waiting =
            |slave: &ManagedSlave| slave.assignment.is_mandatory() && slave.step != SlaveStep::Finished;
        if self.is_started || self.is_halted || self.slaves.iter().any(is_waiting) {
            return;
        }
        self.is_started = true;
        if !self.startup.operates() {
            return;
        }
        own.obey(START, now);
        if !self.startup.starts_nodes() || !self.startup.starts_together() {
            return;
        }
        if self.slaves.iter().all(|slave| slave.assignment.boots() && slave.has_booted) {
            return self.command(START, 0, own, now);
        }
        let booted = self
            .slaves
            .iter()
            .filter(|slave| slave.assignment.boots() && slave.has_booted && !slave.is_running);
        let booted: Vec<u8> = booted.map(|slave| slave.node_id).collect();
        booted.into_iter().for_each(|id| self.command(START, id, own, now));
    }

    /// Ends the boot of a node, and starts it if that is wanted.
    fn finish(&mut self, at: usize, failure: Option<BootFailure>, own: &mut SimulatedNode, now: u64) {
        let slave = &mut self.slaves[at];
        (slave.step, slave.has_booted) = (SlaveStep::Finished, failure.is_none());
        let milestone = match &failure {
            Some(failure) => Milestone::Failed(failure.clone()),
            None if slave.is_running => Milestone::Running,
            None => Milestone::Booted,
        };
        let (node_id, assignment, is_running) = (slave.node_id, slave.assignment, slave.is_running);
        slave.monitor = match assignment.guarding() {
            _ if failure.is_some() => Monitor::None,
            _ if slave.consumer_time != 0 => Monitor::Heartbeat(now),
            Some((time, _)) => Monitor::Guarding(now + time, 0),
            None => Monitor::None,
        };
        self.is_halted |= failure.is_some() && assignment.is_mandatory();
        slave.failure = failure;
        self.milestones.push((node_id, milestone));
        let is_due = !self.startup.starts_together() || own.state() == NmtState::Operational;
        let is_ready = self.slaves[at].has_booted && assignment.boots() && !is_running;
        if is_ready && self.startup.starts_nodes() && is_due {
            self.command(START, node_id, own, now);
        }
        self.go_on(own, now);
    }

    /// Monitors a node: asks it, or finds that its heartbeat is missing.
    fn monitor(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        let slave = &mut self.slaves[at];
        let is_lost = match slave.monitor {
            Monitor::None => false,
            Monitor::Heartbeat(last) => {
                now.saturating_sub(last) > u64::from(slave.consumer_time) * MILLISECOND
            }
            Monitor::Guarding(next, unanswered) => {
                let (time, factor) = slave.assignment.guarding().unwrap_or((u64::MAX, 1));
                if next > now {
                    false
                } else if unanswered >= factor {
                    true
                } else {
                    slave.monitor = Monitor::Guarding(next + time, unanswered + 1);
                    own.queue_remote(error_control(slave.node_id), now);
                    false
                }
            }
        };
        if is_lost {
            slave.monitor = Monitor::None;
            let (node_id, is_mandatory) = (slave.node_id, slave.assignment.is_mandatory());
            self.milestones.push((node_id, Milestone::Lost));
            self.react(node_id, is_mandatory, own, now);
        }
    }

    /// What it does about a lost node (1F80h bits 4 and 6). A reset of all nodes ends at the nodes: a manager that restarted, too,
    /// would begin this run anew.
    fn react(&mut self, node_id: u8, is_mandatory: bool, own: &mut SimulatedNode, now: u64) {
        if is_mandatory && self.startup.has(6) {
            self.command(STOP, 0, own, now);
            own.obey(STOP, now);
        } else if is_mandatory && self.startup.has(4) {
            self.command(RESET_NODE, 0, own, now);
        } else {
            self.command(RESET_NODE, node_id, own, now);
        }
    }
}
