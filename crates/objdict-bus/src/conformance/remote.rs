//! The checks of a device on a real bus: those that need no simulated time, and change nothing unless that is wanted.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

use objdict_device::{Abort, Frame, NmtCommand, NmtState, Received};

use super::bench::{Bench, RESET_NODE};
use super::described::{DescribedEntries, DescribedEntry, abort_code, answer, hex, place};
use super::objects::service_of;
use super::{
    CheckEffect, CheckStep, Conformance, ConformanceCheck, RemoteGroups, SERVICES, Verdict, ensure, failed,
    impossible, verdict,
};
use crate::dictionary::{LiveDictionary, PowerOn};
use crate::model::{Access, Device, TypeKind};
use crate::node::NodeServices;

/// How long the device may take for an answer, for what follows it, and for a reset, in microseconds.
const ANSWER: u64 = 500_000;
const NEXT: u64 = 5_000;
const RESET: u64 = 5_000_000;

/// A device on a bus.
pub trait RemoteDevice {
    /// Sends a frame; whether the bus is still there.
    fn send(&mut self, frame: &Frame) -> bool;

    /// The time in microseconds.
    fn now(&self) -> u64;

    /// The next frame on the bus; `None` if none came until a time.
    fn receive(&mut self, until: u64) -> Option<Frame>;
}

/// Checks a device on a bus against its description. Checks that need simulated time, another group, or a broadcast are impossible.
pub fn conformance_on(
    device: &Device,
    node_id: u8,
    remote: Rc<RefCell<dyn RemoteDevice>>,
    groups: RemoteGroups,
) -> Conformance {
    let mut described = described(device, node_id);
    let mut checks = planned(&described, groups);
    let Some(mut node) = RemoteNode::new(remote, node_id, groups.writes) else {
        return Conformance { checks };
    };
    let boot_up = node.boot(0);
    let values = present(&mut Bench::new(&described, node.again(), boot_up));
    described.assume(values);
    let of_services = SERVICES.into_iter().flatten().zip(&mut checks);
    for (check, planned) in of_services.filter(|(_, planned)| matches!(planned.verdict, Verdict::Planned(_)))
    {
        let boot_up = node.boot(0);
        planned.verdict = verdict(check.run(&mut Bench::new(&described, node.again(), boot_up)));
    }
    let boot_up = node.boot(0);
    let mut bench = Bench::new(&described, node.again(), boot_up);
    for (index, planned) in described.indexes().into_iter().zip(checks.iter_mut().skip(service_count())) {
        let mut entries = described.object(index);
        planned.verdict = verdict(entries.try_for_each(|entry| check_reading(&mut bench, entry)));
    }
    Conformance { checks }
}

/// The device's values, entry by entry; `None` for an entry without a value, or with the described one.
fn present(bench: &mut Bench<'_>) -> Vec<Option<Vec<u8>>> {
    let described = bench.described;
    let is_read = |entry: &DescribedEntry| {
        let is_plain = entry.data_type.kind() != TypeKind::Domain && entry.access != Access::Const;
        is_plain && entry.is_readable()
    };
    let mut read = |entry: &DescribedEntry| {
        if is_read(entry) { bench.upload(entry.index, entry.sub).ok() } else { None }
    };
    described.entries.iter().map(&mut read).collect()
}

/// The checks that [`conformance_on`] would make or leave out. Nothing is sent.
pub fn conformance_plan(device: &Device, node_id: u8, groups: RemoteGroups) -> Conformance {
    Conformance { checks: planned(&described(device, node_id), groups) }
}

fn described(device: &Device, node_id: u8) -> DescribedEntries {
    let device = PowerOn::Defaults.values_of(device);
    let live = LiveDictionary::of_table(&device, node_id, &[]);
    let mut described = DescribedEntries::new(&device, node_id, &live);
    described.spare(&device);
    described
}

fn service_count() -> usize {
    SERVICES.into_iter().flatten().count()
}

/// The checks of services, then of objects.
fn planned(described: &DescribedEntries, groups: RemoteGroups) -> Vec<ConformanceCheck> {
    let of_services = SERVICES.into_iter().flatten().map(|check| ConformanceCheck {
        service: check.service,
        name: check.name.to_owned(),
        section: check.section,
        verdict: groups.verdict(check.remote.first().copied()),
    });
    let of_objects = described.indexes().into_iter().map(|index| ConformanceCheck {
        service: service_of(index),
        name: format!("{index:04X}h"),
        section: "7.4",
        verdict: Verdict::Planned(CheckEffect::Reads),
    });
    of_services.chain(of_objects).collect()
}

/// The value of an entry on a device: it has another one than the default, but the length, the access and both protocols are as described.
fn check_reading(bench: &mut Bench<'_>, entry: &DescribedEntry) -> CheckStep {
    let (index, sub) = (entry.index, entry.sub);
    let place = place(index, sub);
    let value = bench.upload(index, sub);
    let bytes = match (value, entry.is_readable()) {
        (Err(Abort::WriteOnly), false) => return Ok(()),
        (value, false) => {
            return failed(format!("{place}, which is write-only, is {}", answer(&value.map(drop))));
        }
        // an entry without a value now, such as an empty error history
        (Err(Abort::NoData | Abort::DeviceState | Abort::LocalControl), true) => {
            return impossible(format!("{place} has no value now"));
        }
        (Err(abort), true) => return failed(format!("{place} cannot be read: {}", abort_code(abort))),
        (Ok(bytes), true) => bytes,
    };
    if let Some(size) = entry.size() {
        ensure(bytes.len() == size, || format!("{place} has {} bytes instead of {size}", bytes.len()))?;
    }
    ensure(entry.access != Access::Const || bytes == entry.default, || {
        format!("{place} is constant, but is {} instead of {}", hex(&bytes), hex(&entry.default))
    })
}

/// The device as checks see a node. Times are of the checks: they stand still while the device takes its time.
struct RemoteNode {
    remote: Rc<RefCell<dyn RemoteDevice>>,
    node_id: u8,
    /// Whether the node is reset before each check, and by which command.
    reset: Option<u8>,
    /// What the node sends after a reset, and what is returned without it.
    boot_up: Frame,
    silence: Frame,
    now: u64,
    heard: VecDeque<Frame>,
}

impl RemoteNode {
    /// `None` for an invalid node-ID.
    fn new(remote: Rc<RefCell<dyn RemoteDevice>>, node_id: u8, resets: bool) -> Option<Self> {
        let frame = |data: &[u8]| Frame::new(0x700 + u16::from(node_id), data);
        let reset = resets.then_some(RESET_NODE);
        let (boot_up, silence, heard) = (frame(&[0])?, frame(&[])?, VecDeque::new());
        Some(Self { remote, node_id, reset, boot_up, silence, now: 0, heard })
    }

    fn is_own(&self, frame: &Frame) -> bool {
        frame.id() & 0x7F == u16::from(self.node_id) && frame.id() < 0x780
    }

    /// The time after so many microseconds.
    fn after(&self, wait: u64) -> u64 {
        self.remote.borrow().now().saturating_add(wait)
    }

    /// The next frame of the device until a time.
    fn next_frame(&mut self, until: u64) -> Option<Frame> {
        loop {
            let frame = self.remote.borrow_mut().receive(until)?;
            if self.is_own(&frame) {
                return Some(frame);
            }
        }
    }
}

impl NodeServices for RemoteNode {
    fn boot(&mut self, now: u64) -> Frame {
        (self.now, self.heard) = (now, VecDeque::new());
        let request = match self.reset {
            Some(command) => Frame::new(0, &[command, self.node_id]),
            // a transfer of the check before is over
            None => Frame::new(0x600 + u16::from(self.node_id), &[0x80, 0, 0, 0, 0, 0, 4, 5]),
        };
        request.map(|frame| self.remote.borrow_mut().send(&frame));
        if self.reset.is_none() {
            let until = self.after(NEXT);
            while self.next_frame(until).is_some() {}
            return self.boot_up;
        }
        // a node that is being reset may still send
        let (until, boot_up) = (self.after(RESET), self.boot_up);
        let has_booted = std::iter::from_fn(|| self.next_frame(until)).any(|frame| frame == boot_up);
        if has_booted { boot_up } else { self.silence }
    }

    fn state(&self) -> NmtState {
        NmtState::PreOperational
    }

    fn receive(&mut self, frame: &Frame, now: u64) -> Received {
        self.now = self.now.max(now);
        if let (0, &[command @ (0x81 | 0x82), id]) = (frame.id(), frame.data())
            && id == self.node_id
        {
            // the bench boots the node then
            self.reset = self.reset.map(|_| command);
            return Received::Nmt(NmtCommand::ResetNode);
        }
        self.remote.borrow_mut().send(frame);
        let is_answered = frame.id() == 0x600 + u16::from(self.node_id);
        let answer = 0x580 + u16::from(self.node_id);
        let until = self.after(if is_answered { ANSWER } else { NEXT });
        while let Some(frame) = self.next_frame(until) {
            if frame.id() == answer {
                return Received::Answer(frame);
            }
            self.heard.push_back(frame);
        }
        Received::Ignored
    }

    fn poll(&mut self, now: u64) -> Option<Frame> {
        let passed = now.saturating_sub(self.now);
        self.now = self.now.max(now);
        let until = self.after(passed.max(NEXT));
        self.heard.pop_front().or_else(|| self.next_frame(until))
    }

    fn next(&self, now: u64) -> Option<u64> {
        Some(if self.heard.is_empty() { now + 1000 } else { now })
    }

    fn report(&mut self, _: u16) {}

    fn again(&self) -> Box<dyn NodeServices> {
        let (remote, reset, heard) =
            (Rc::clone(&self.remote), self.reset.map(|_| RESET_NODE), VecDeque::new());
        Box::new(Self { remote, reset, heard, now: 0, ..*self })
    }
}
