//! A node alone with a master: frames in, frames out, and the time.

use std::collections::VecDeque;

use objdict_device::{Abort, Frame, NmtCommand, Received};

use super::described::{DescribedEntries, abort_code, answer, hex, place};
use super::{CheckStep, Verdict, ensure, failed, impossible};
use crate::client::{Client, ClientProgress};
use crate::dictionary::number;
use crate::node::NodeServices;

/// Microseconds of a millisecond.
pub(super) const MS: u64 = 1000;

/// What passes between two frames of the master.
const GAP: u64 = 100;

/// More frames at one time than this are endless.
const ENDLESS: usize = 100_000;

pub(super) const START: u8 = 1;
pub(super) const STOP: u8 = 2;
pub(super) const ENTER_PRE_OPERATIONAL: u8 = 128;
pub(super) const RESET_NODE: u8 = 129;
pub(super) const RESET_COMMUNICATION: u8 = 130;

pub(super) const STOPPED: u8 = 0x04;
pub(super) const OPERATIONAL: u8 = 0x05;
pub(super) const PRE_OPERATIONAL: u8 = 0x7F;

/// A frame of the node and when it came.
pub(super) type SentFrame = (u64, Frame);

/// A node that was switched on, at a time in microseconds.
pub(super) struct Bench<'d> {
    pub(super) described: &'d DescribedEntries,
    node: Box<dyn NodeServices>,
    client: Client,
    pub(super) now: u64,
    /// What the node sent when it was switched on.
    pub(super) boot_up: Frame,
}

impl<'d> Bench<'d> {
    /// With a node that was switched on at the time 0, and what it sent then.
    pub(super) fn new(described: &'d DescribedEntries, node: Box<dyn NodeServices>, boot_up: Frame) -> Self {
        let client = Client::new(described.node_id);
        let mut bench = Self { described, node, client, now: 0, boot_up };
        bench.run(GAP);
        bench
    }

    pub(super) fn node_id(&self) -> u16 {
        self.described.node_id.into()
    }

    /// Another node-ID.
    pub(super) const fn neighbour(&self) -> u8 {
        self.described.node_id % 127 + 1
    }

    /// Sends a frame, and returns what the node sends at once.
    pub(super) fn send(&mut self, id: u16, data: &[u8]) -> Vec<Frame> {
        let mut sent: Vec<Frame> = self.run(GAP).into_iter().map(|(_, frame)| frame).collect();
        let Some(frame) = Frame::new(id, data) else { return sent };
        match self.node.receive(&frame, self.now) {
            Received::Answer(answer) => sent.push(answer),
            Received::Nmt(NmtCommand::ResetNode | NmtCommand::ResetCommunication) => {
                sent.push(self.node.boot(self.now));
            }
            _ => {}
        }
        sent.extend(self.poll());
        sent
    }

    fn poll(&mut self) -> Vec<Frame> {
        let (node, now) = (&mut self.node, self.now);
        std::iter::from_fn(|| node.poll(now)).take(ENDLESS).collect()
    }

    /// Lets time pass, and returns what the node sends. It is polled when it says that it must be.
    pub(super) fn run(&mut self, time: u64) -> Vec<SentFrame> {
        let (end, mut sent) = (self.now + time, Vec::new());
        while let Some(due) = self.node.next(self.now).filter(|due| *due <= end) {
            self.now = due.max(self.now);
            let frames = self.poll();
            let is_idle = frames.is_empty();
            sent.extend(frames.into_iter().map(|frame| (self.now, frame)));
            if self.now == end || sent.len() > ENDLESS {
                break;
            }
            // what is due without an effect is not asked for endlessly
            self.now += u64::from(is_idle);
        }
        self.now = end;
        sent
    }

    /// Lets time pass without a look at the node, as when its processor is busy.
    pub(super) fn sleep(&mut self, time: u64) {
        self.now += time;
    }

    /// The times at which frames with a CAN-ID come, and their data.
    pub(super) fn listen(&mut self, id: u16, time: u64) -> Vec<SentFrame> {
        self.run(time).into_iter().filter(|(_, frame)| frame.id() == id).collect()
    }

    /// Sends an NMT command to the node.
    pub(super) fn command(&mut self, command: u8) -> Vec<Frame> {
        let node_id = self.described.node_id;
        self.send(0, &[command, node_id])
    }

    /// The answer to an SDO request.
    pub(super) fn request(&mut self, request: [u8; 8]) -> Option<[u8; 8]> {
        self.answer_of(&request)
    }

    /// The answer to the data of an SDO request, which may be too short.
    pub(super) fn answer_of(&mut self, request: &[u8]) -> Option<[u8; 8]> {
        let node_id = self.node_id();
        let sent = self.send(0x600 + node_id, request);
        let mut answers = sent.into_iter().filter(|frame| frame.id() == 0x580 + node_id);
        answers.next_back().and_then(|frame| frame.data().try_into().ok())
    }

    /// Whether the SDO server answers.
    pub(super) fn answers(&mut self) -> bool {
        self.request([0x40, 0x00, 0x10, 0, 0, 0, 0, 0]).is_some()
    }

    fn transfer(&mut self, id: [u16; 2], first: ClientProgress) -> Result<Vec<u8>, Abort> {
        let (mut progress, mut answers) = (first, VecDeque::new());
        loop {
            if let Some(frame) = progress.frame {
                let sent = self.send(id[0], frame.data());
                answers.extend(sent.into_iter().filter(|frame| frame.id() == id[1]));
            }
            if let Some(end) = progress.end {
                return end;
            }
            let now = self.now * 1000;
            progress = match answers.pop_front() {
                Some(answer) => self.client.receive(&answer, now),
                None => self.client.poll(now),
            };
            if progress == ClientProgress::default() && answers.is_empty() {
                let late = self.listen(id[1], MS);
                answers.extend(late.into_iter().map(|(_, frame)| frame));
            }
        }
    }

    fn channel(&self) -> [u16; 2] {
        [0x600 + self.node_id(), 0x580 + self.node_id()]
    }

    pub(super) fn upload(&mut self, index: u16, sub: u8) -> Result<Vec<u8>, Abort> {
        let first = self.client.upload(index, sub, self.now * 1000);
        self.transfer(self.channel(), first)
    }

    pub(super) fn upload_block(&mut self, index: u16, sub: u8) -> Result<Vec<u8>, Abort> {
        let first = self.client.upload_block(index, sub, self.now * 1000);
        self.transfer(self.channel(), first)
    }

    pub(super) fn download(&mut self, index: u16, sub: u8, data: &[u8]) -> Result<(), Abort> {
        let first = self.client.download(index, sub, data.to_vec(), self.now * 1000);
        self.transfer(self.channel(), first).map(drop)
    }

    pub(super) fn download_block(&mut self, index: u16, sub: u8, data: &[u8]) -> Result<(), Abort> {
        let first = self.client.download_block(index, sub, data.to_vec(), self.now * 1000);
        self.transfer(self.channel(), first).map(drop)
    }

    /// The value of an entry that the description says is readable.
    pub(super) fn read(&mut self, index: u16, sub: u8) -> CheckStep<Vec<u8>> {
        let entry = self.described.needs(index, sub)?;
        if !entry.is_readable() {
            return impossible(format!("{} is {}", place(index, sub), entry.access.name()));
        }
        self.upload(index, sub)
            .or_else(|abort| failed(format!("reading {}: {}", place(index, sub), abort_code(abort))))
    }

    /// The value of a number.
    pub(super) fn number(&mut self, index: u16, sub: u8) -> CheckStep<u64> {
        self.read(index, sub).map(|bytes| number(&bytes))
    }

    /// Checks the value of an entry.
    pub(super) fn expect(&mut self, index: u16, sub: u8, expected: &[u8]) -> CheckStep {
        let value = self.read(index, sub)?;
        ensure(value == expected, || {
            format!("{} is {}, not {}", place(index, sub), hex(&value), hex(expected))
        })
    }

    /// The bytes of a number that the description says can be written.
    fn writable(&self, index: u16, sub: u8, number: u64) -> CheckStep<Vec<u8>> {
        let entry = self.described.needs_writable(index, sub)?;
        let bytes = number.to_le_bytes();
        let fits = |size: &usize| *size <= 8 && bytes[*size..].iter().all(|byte| *byte == 0);
        let bytes = entry.size().filter(fits).map(|size| bytes[..size].to_vec());
        let value = bytes.as_deref().and_then(|bytes| entry.number_of(bytes));
        match (bytes, value) {
            (Some(bytes), Some(value)) if entry.allows(value) => Ok(bytes),
            _ => impossible(format!("{number:X}h is beyond the type or the limits of {}", place(index, sub))),
        }
    }

    /// Writes a number that the description and CiA 301 allow.
    pub(super) fn write(&mut self, index: u16, sub: u8, number: u64) -> CheckStep {
        let bytes = self.writable(index, sub, number)?;
        self.download(index, sub, &bytes).or_else(|abort| {
            failed(format!("writing {} to {}: {}", hex(&bytes), place(index, sub), abort_code(abort)))
        })
    }

    /// Writes a number that the node must refuse.
    pub(super) fn refuse(&mut self, index: u16, sub: u8, number: u64, abort: Abort) -> CheckStep {
        let bytes = self.writable(index, sub, number)?;
        self.refuse_bytes(index, sub, &bytes, abort)
    }

    /// Writes a value that the node must refuse.
    pub(super) fn refuse_bytes(&mut self, index: u16, sub: u8, bytes: &[u8], abort: Abort) -> CheckStep {
        let result = self.download(index, sub, bytes);
        ensure(result == Err(abort), || {
            let place = place(index, sub);
            format!("writing {} to {place}: {}, not {}", hex(bytes), answer(&result), abort_code(abort))
        })
    }

    /// Reads an entry by another SDO channel.
    pub(super) fn upload_by(&mut self, channel: [u16; 2], index: u16, sub: u8) -> Result<Vec<u8>, Abort> {
        let own = std::mem::replace(&mut self.client, Client::with_can_ids(channel));
        let first = self.client.upload(index, sub, self.now * 1000);
        let result = self.transfer(channel, first);
        self.client = own;
        result
    }

    /// The period of the heartbeat in microseconds, after it was switched on if it can be.
    pub(super) fn start_heartbeat(&mut self) -> CheckStep<u64> {
        let entry = self.described.needs(0x1017, 0)?;
        if entry.size() != Some(2) {
            return impossible("1017h does not have two bytes");
        }
        if !entry.is_writable() {
            return match self.described.number(0x1017, 0) {
                0 => impossible(format!("1017h is {} and 0", entry.access.name())),
                period => Ok(period * MS),
            };
        }
        let period = entry.low.unwrap_or(0).max(100).min(entry.high.unwrap_or(100)).max(1);
        self.write(0x1017, 0, period as u64)?;
        Ok(period as u64 * MS)
    }

    /// The period of the heartbeat, if the description lets the node have one.
    pub(super) fn watch(&mut self) -> CheckStep<Option<u64>> {
        match self.start_heartbeat() {
            Ok(period) => Ok(Some(period)),
            Err(Verdict::Failed(text)) => failed(text),
            Err(_) => Ok(None),
        }
    }

    /// Checks the NMT state: as a heartbeat with this period says, else as far as SDO servers show it.
    pub(super) fn expect_state(&mut self, heartbeat: Option<u64>, expected: u8) -> CheckStep {
        if let Some(period) = heartbeat {
            let heartbeats = self.listen(0x700 + self.node_id(), 2 * period);
            let state = heartbeats.last().map(|(_, frame)| frame.data().to_vec()).unwrap_or_default();
            return ensure(state == [expected], || {
                format!("the state is {}, not {expected:02X}", hex(&state))
            });
        }
        let answers = self.answers();
        ensure(answers == (expected != STOPPED), || {
            format!("in state {expected:02X}h, SDOs are answered: {answers}")
        })
    }

    /// Makes the node operational.
    pub(super) fn start(&mut self) -> Vec<Frame> {
        self.command(START)
    }
}
