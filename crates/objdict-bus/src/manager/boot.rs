//! The process "boot NMT slave" (CiA 302-2): step by step, each with what ends it.

use objdict_device::{Abort, NmtState};

use super::{
    BootFailure, ClientProgress, GUARDING, Monitor, PATIENCE, RESET_COMMUNICATION, RESET_NODE,
    RunningManager, SlaveStep,
};
use crate::dictionary::number;
use crate::node::{MILLISECOND, SimulatedNode, error_control};

/// What 1011h takes.
const LOAD: &[u8] = b"load";

impl RunningManager {
    /// Begins to boot a node.
    pub(super) fn begin(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        let slave = &mut self.slaves[at];
        (slave.monitor, slave.is_running, slave.accepted) = (Monitor::None, false, 0);
        if slave.assignment.boots() {
            self.read(at, SlaveStep::DeviceType, (0x1000, 0), own, now);
        } else {
            self.control(at, own, now);
        }
    }

    /// A node is there.
    pub(super) fn take_boot_up(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        match self.slaves[at].step {
            SlaveStep::Idle | SlaveStep::BootUp(_) | SlaveStep::Retry(_) | SlaveStep::Finished => {
                self.begin(at, own, now);
            }
            SlaveStep::State(_) => self.reset(at, own, now),
            SlaveStep::Reset(_) => self.check_software(at, own, now),
            SlaveStep::Restored(_) => self.configure(at, 0, own, now),
            _ => {}
        }
    }

    /// A node says in which state it is: by a heartbeat, or as it was asked.
    pub(super) fn take_state(&mut self, at: usize, state: u8, own: &mut SimulatedNode, now: u64) {
        let slave = &mut self.slaves[at];
        slave.monitor = match slave.monitor {
            Monitor::None => Monitor::None,
            Monitor::Heartbeat(_) => Monitor::Heartbeat(now),
            Monitor::Guarding(next, _) => Monitor::Guarding(next, 0),
        };
        match slave.step {
            SlaveStep::State(_) if state & 0x7F == NmtState::Operational.code() => {
                slave.is_running = true;
                self.control(at, own, now);
            }
            SlaveStep::State(_) => self.reset(at, own, now),
            SlaveStep::Monitor(_) => self.finish(at, None, own, now),
            _ => {}
        }
    }

    /// What a step waits for did not come.
    pub(super) fn give_up_waiting(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        let slave = &self.slaves[at];
        let failure = match slave.step {
            SlaveStep::BootUp(_) | SlaveStep::Retry(_) => return self.begin(at, own, now),
            SlaveStep::State(_) if slave.consumer_time != 0 => BootFailure::NoState(slave.consumer_time),
            SlaveStep::State(_) => BootFailure::NoGuarding,
            SlaveStep::Monitor(_) => BootFailure::NoHeartbeat(slave.consumer_time),
            _ => BootFailure::NoRestart,
        };
        self.finish(at, Some(failure), own, now);
    }

    /// Goes on with a transfer.
    pub(super) fn advance(&mut self, at: usize, progress: ClientProgress, own: &mut SimulatedNode, now: u64) {
        if let Some(frame) = progress.frame {
            own.send(now, frame);
        }
        if let Some(result) = progress.end {
            self.conclude(at, result, own, now);
        }
    }

    /// Goes on after a transfer.
    fn conclude(&mut self, at: usize, result: Result<Vec<u8>, Abort>, own: &mut SimulatedNode, now: u64) {
        let number = |result: Result<Vec<u8>, Abort>| result.map(|bytes| number(&bytes) as u32);
        match (self.slaves[at].step.clone(), result) {
            (SlaveStep::DeviceType, Err(abort @ Abort::Timeout)) => self.miss(at, abort, own, now),
            // it answers, and will not answer otherwise when it is asked again
            (SlaveStep::DeviceType, Err(abort)) => {
                self.finish(at, Some(BootFailure::NoAnswer(abort)), own, now);
            }
            (SlaveStep::DeviceType, result) => self.compare(at, (0x1000, 0), number(result), own, now),
            (SlaveStep::Identity(sub), result) => self.compare(at, (0x1018, sub), number(result), own, now),
            (SlaveStep::Software, result) => {
                let (expected, found) = (self.slaves[at].software, number(result));
                if found == Ok(expected) {
                    self.check_configuration(at, own, now);
                } else {
                    self.finish(at, Some(BootFailure::Software { expected, found }), own, now);
                }
            }
            (SlaveStep::Verification(sub), result) => {
                let is_kept = number(result) == Ok(self.slaves[at].configured_at[usize::from(sub == 2)]);
                match (is_kept, sub) {
                    (true, 1) => self.read(at, SlaveStep::Verification(2), (0x1020, 2), own, now),
                    (true, _) => self.control(at, own, now),
                    (false, _) => self.restore(at, own, now),
                }
            }
            (SlaveStep::Restore, Ok(_)) => {
                let (node_id, sub) = (self.slaves[at].node_id, self.slaves[at].restore);
                let command = if sub == 2 { RESET_COMMUNICATION } else { RESET_NODE };
                self.slaves[at].step = SlaveStep::Restored(now + PATIENCE);
                self.command(command, node_id, own, now);
            }
            (SlaveStep::Restore, Err(abort)) => {
                let failure = BootFailure::Restore(self.slaves[at].restore, abort);
                self.finish(at, Some(failure), own, now);
            }
            (SlaveStep::Download(number), Ok(_)) => {
                self.slaves[at].accepted = number + 1;
                self.configure(at, number + 1, own, now);
            }
            (SlaveStep::Download(number), Err(abort)) => {
                let download = self.slaves[at].downloads.iter().flatten().nth(number);
                let (index, sub) = download.map_or((0, 0), crate::download::Download::entry);
                let failure = BootFailure::Download { number: number + 1, index, sub, abort };
                self.finish(at, Some(failure), own, now);
            }
            _ => {}
        }
    }

    fn read(
        &mut self,
        at: usize,
        step: SlaveStep,
        (index, sub): (u16, u8),
        own: &mut SimulatedNode,
        now: u64,
    ) {
        let slave = &mut self.slaves[at];
        slave.step = step;
        let progress = slave.client.upload(index, sub, now);
        self.advance(at, progress, own, now);
    }

    /// A node does not answer: it is asked again later, a mandatory one as long as 1F89h says.
    fn miss(&mut self, at: usize, abort: Abort, own: &mut SimulatedNode, now: u64) {
        let is_over = self.boot_time != 0 && now.saturating_sub(self.began) >= self.boot_time;
        let slave = &mut self.slaves[at];
        if slave.assignment.is_mandatory() && is_over {
            return self.finish(at, Some(BootFailure::NoAnswer(abort)), own, now);
        }
        slave.failure = Some(BootFailure::NoAnswer(abort));
        slave.step = SlaveStep::Retry(now + PATIENCE);
    }

    /// Compares an entry with what is expected; 0 is not compared.
    fn compare(
        &mut self,
        at: usize,
        (index, sub): (u16, u8),
        found: Result<u32, Abort>,
        own: &mut SimulatedNode,
        now: u64,
    ) {
        let slave = &self.slaves[at];
        let position = if index == 0x1000 { 0 } else { sub };
        let expected = slave.expected[usize::from(position)];
        if expected != 0 && found != Ok(expected) {
            return self.finish(at, Some(BootFailure::Identity { index, sub, expected, found }), own, now);
        }
        match (position + 1..=4).find(|sub| slave.expected[usize::from(*sub)] != 0) {
            Some(sub) => self.read(at, SlaveStep::Identity(sub), (0x1018, sub), own, now),
            None if slave.assignment.is_kept_alive() => self.look(at, own, now),
            None => self.check_software(at, own, now),
        }
    }

    /// Looks whether a node that must not be reset is operational.
    fn look(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        let slave = &mut self.slaves[at];
        slave.step = match slave.consumer_time {
            0 => {
                own.queue_remote(error_control(slave.node_id), now);
                SlaveStep::State(now + GUARDING)
            }
            time => SlaveStep::State(now + u64::from(time) * MILLISECOND),
        };
    }

    fn reset(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        self.slaves[at].step = SlaveStep::Reset(now + PATIENCE);
        self.command(RESET_COMMUNICATION, self.slaves[at].node_id, own, now);
    }

    fn check_software(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        let slave = &self.slaves[at];
        match (slave.assignment.checks_software(), slave.software) {
            (false, _) => self.check_configuration(at, own, now),
            (true, 0) => self.finish(at, Some(BootFailure::NoSoftwareExpected), own, now),
            (true, _) => self.read(at, SlaveStep::Software, (0x1F56, 1), own, now),
        }
    }

    /// A node that has the configuration already is not configured again.
    fn check_configuration(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        if self.slaves[at].configured_at.contains(&0) {
            self.restore(at, own, now);
        } else {
            self.read(at, SlaveStep::Verification(1), (0x1020, 1), own, now);
        }
    }

    fn restore(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        let slave = &mut self.slaves[at];
        if !slave.assignment.restores() || slave.restore == 0 {
            return self.configure(at, 0, own, now);
        }
        slave.step = SlaveStep::Restore;
        let progress = slave.client.download(0x1011, slave.restore, LOAD.to_vec(), now);
        self.advance(at, progress, own, now);
    }

    /// Makes a download, counted from 0.
    fn configure(&mut self, at: usize, number: usize, own: &mut SimulatedNode, now: u64) {
        let slave = &mut self.slaves[at];
        let download = match &slave.downloads {
            Ok(downloads) => downloads.get(number).cloned(),
            Err(reason) => {
                let failure = BootFailure::Configuration(reason.clone());
                return self.finish(at, Some(failure), own, now);
            }
        };
        let Some(download) = download else { return self.control(at, own, now) };
        slave.step = SlaveStep::Download(number);
        let progress = slave.client.download(download.index, download.sub, download.data, now);
        self.advance(at, progress, own, now);
    }

    /// Starts the error control: waits for the first heartbeat, or begins to ask.
    fn control(&mut self, at: usize, own: &mut SimulatedNode, now: u64) {
        let slave = &mut self.slaves[at];
        if slave.consumer_time == 0 {
            return self.finish(at, None, own, now);
        }
        slave.step = SlaveStep::Monitor(now + u64::from(slave.consumer_time) * MILLISECOND);
    }
}
