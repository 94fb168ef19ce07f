//! What the order of frames shows: NMT states, SDO transfers, and nodes that do not belong to the network.

use std::collections::BTreeMap;

use super::deviations::{Deviation, name};
use super::is_rpdo;
use crate::history::Seen;
use crate::incident::{IncidentBook, Subject};
use crate::log::LogTime;
use crate::sight::Sight;
use crate::{Bus, PRE_OPERATIONAL};
use objdict_bus::crc;
use objdict_document::describe::frames::{DecodedFrame, FrameKind, SdoFrame, TransferStep, nmt_state};
use objdict_lint::recorded::traffic as rules;
use objdict_model::diagnostic::RuleInfo;
use objdict_model::model::PdoKind;
use objdict_network::Service;

const OPERATIONAL: u8 = 5;

/// A client waits so many nanoseconds for an answer: the usual timeout of a second.
const PATIENCE: i64 = 1_000_000_000;

/// A node is started so many nanoseconds after its boot-up message.
const START_TIME: i64 = 2_000_000_000;

/// So many nanoseconds are between the boot-up messages of a node that boots repeatedly.
const BOOT_TIME: i64 = 10_000_000_000;

/// So many boot-up messages are too many.
const BOOT_UPS: usize = 3;

/// The most nodes that are addressed and missing: a scan addresses more.
const MAX_MISSING: usize = 3;

/// What a node did last.
#[derive(Clone, Debug, Default)]
struct NodeConduct {
    /// Its NMT state; `None` where the log does not show it.
    state: Option<u8>,
    /// Whether PDOs in this state were reported.
    is_said: bool,
    /// Whether it was reported that the network does not have it.
    is_unknown: bool,
    /// When its state changed, in nanoseconds.
    changed: Option<i64>,
    /// Whether it sent a frame.
    is_seen: bool,
    /// The first SDO request or NMT command to it alone, before it sent a frame.
    addressed: Option<Seen>,
    /// The boot-up message after which it was not started.
    boot_up: Option<Seen>,
    /// When it sent the last boot-up message, in nanoseconds.
    boot_up_time: Option<i64>,
    /// The boot-up messages, at most ten seconds apart, that are not reported: how many there are with those that are.
    boot_ups: (Vec<Seen>, usize),
    /// Whether all nodes were reset, so that one boot-up message more is right.
    is_reset: bool,
    /// Whether an incident is over when it is operational.
    is_down: bool,
}

/// Incidents that are over when a node is operational.
const DOWN: [&RuleInfo; 3] = [&rules::NOT_OPERATIONAL, &rules::UNEXPECTED_BOOT_UP, &rules::REPEATED_BOOT];

/// A transfer of an SDO channel.
#[derive(Clone, Debug, Default)]
struct ChannelConduct {
    /// The request that has no answer yet, and its entry.
    asked: Option<(Seen, Option<(u16, u8)>)>,
    /// The toggle bit of the next segment.
    toggle: bool,
    /// The bytes that were announced.
    size: Option<u32>,
    /// Whether client and server check blocks.
    has_crc: [bool; 2],
    /// Whether the last transfer has a fault.
    is_broken: bool,
}

/// What was seen of the order of frames.
#[derive(Clone, Debug)]
pub(super) struct Conduct {
    nodes: Vec<NodeConduct>,
    channels: BTreeMap<(u8, u16), ChannelConduct>,
    has_commands: bool,
    /// Whether a command started a node.
    has_starts: bool,
    has_answers: bool,
}

impl Default for Conduct {
    fn default() -> Self {
        Self {
            nodes: vec![NodeConduct::default(); super::NODES],
            channels: BTreeMap::new(),
            has_commands: false,
            has_starts: false,
            has_answers: false,
        }
    }
}

impl Conduct {
    /// When the state of a node changed, in nanoseconds.
    pub(super) fn changed(&self, node_id: u8) -> Option<i64> {
        self.nodes[usize::from(node_id) % super::NODES].changed
    }

    /// Reports what a frame is against in its order.
    pub(super) fn frame(&mut self, sight: Sight<'_>, book: &mut IncidentBook) {
        let decoded = sight.decoded;
        if sight.frame.is_remote {
            return;
        }
        if decoded.kind == FrameKind::Nmt {
            return self.command(sight, book);
        }
        let Some(node_id) = decoded.node_id else { return };
        let was_seen = self.nodes[usize::from(node_id) % super::NODES].is_seen;
        self.unknown(node_id, sight, book);
        match decoded.kind {
            FrameKind::BootUp => self.boot_up(node_id, was_seen, sight, book),
            FrameKind::Heartbeat => self.heartbeat(node_id, sight, book),
            FrameKind::Pdo => {
                if let Some((rule, text)) = self.pdo(node_id, decoded, sight.bus) {
                    book.against(Subject::new(rule, node_id, 0), sight.seen(), || text);
                }
            }
            FrameKind::Sdo => self.sdo(node_id, sight, book),
            _ => {}
        }
    }

    fn command(&mut self, sight: Sight<'_>, book: &mut IncidentBook) {
        let &[command, node_id, ..] = sight.frame.data() else { return };
        self.has_commands = true;
        self.has_starts |= command == 1;
        let nodes = self.nodes.iter_mut().zip(0..);
        for (node, at) in nodes.filter(|(_, at)| node_id == 0 || *at == node_id) {
            // what a node has to send before it obeys is still sent
            node.state = (command == 1).then_some(OPERATIONAL);
            (node.is_said, node.changed, node.boot_up) = (false, Some(sight.now()), None);
            node.is_reset |= node_id == 0 && matches!(command, 0x81 | 0x82);
            if node_id != 0 && !node.is_seen {
                node.addressed.get_or_insert_with(|| sight.seen());
            }
            if command == 1 {
                node.is_up(at, sight, book);
            }
        }
    }

    fn boot_up(&mut self, node_id: u8, was_seen: bool, sight: Sight<'_>, book: &mut IncidentBook) {
        let node = &mut self.nodes[usize::from(node_id) % super::NODES];
        let was_operational = node.state.replace(PRE_OPERATIONAL) == Some(OPERATIONAL);
        // one that was started and never seen may be switched on now
        let is_unexpected = was_operational && was_seen && self.has_commands;
        // 1F80h bit 2: the node does not start by itself (CiA 302-2)
        let startup = sight.bus.reader.device(node_id).map(|device| device.value(0x1F80, 0));
        let waits = startup.is_some_and(|startup| {
            let number = startup.and_then(|value| value.as_integer());
            number.is_none_or(|number| number & 1 << 2 != 0)
        });
        node.state = node.state.filter(|_| waits);
        let (moment, now) = (sight.seen(), sight.now());
        let last = node.boot_up_time.replace(now);
        (node.is_said, node.changed, node.boot_up) = (false, Some(now), Some(moment.clone()));
        let name = || sight.name(node_id);
        if is_unexpected {
            node.is_down = true;
            let text = || format!("{} boots up during operation, without a command", name());
            book.against(Subject::new(&rules::UNEXPECTED_BOOT_UP, node_id, 0), moment.clone(), text);
        }
        let (waiting, count) = &mut node.boot_ups;
        if last.is_none_or(|last| now.saturating_sub(last) > BOOT_TIME) {
            (*waiting, *count) = (Vec::new(), 0);
        }
        if !std::mem::take(&mut node.is_reset) {
            waiting.push(moment);
            *count += 1;
        }
        if *count >= BOOT_UPS {
            node.is_down = true;
            for moment in waiting.drain(..) {
                let text = || format!("{} boots repeatedly", name());
                book.against(Subject::new(&rules::REPEATED_BOOT, node_id, 0), moment, text);
            }
        }
    }

    fn heartbeat(&mut self, node_id: u8, sight: Sight<'_>, book: &mut IncidentBook) {
        let node = &mut self.nodes[usize::from(node_id) % super::NODES];
        let state = sight.frame.data().first().map(|state| state & 0x7F);
        if node.state != state {
            (node.state, node.is_said, node.changed) = (state, false, Some(sight.now()));
        }
        if state == Some(OPERATIONAL) {
            node.is_up(node_id, sight, book);
        }
    }

    /// PDOs of a node that is not operational, the first in each state.
    fn pdo(&mut self, node_id: u8, decoded: &DecodedFrame, bus: &Bus<'_>) -> Option<Deviation> {
        let Some(Service::Pdo(pdo)) = decoded.service else { return None };
        let node = &mut self.nodes[usize::from(node_id) % super::NODES];
        let state = node.state.filter(|state| *state != OPERATIONAL && !node.is_said)?;
        // without commands the log lacks those that started the nodes
        if !self.has_commands || pdo.kind != PdoKind::Tpdo {
            return None;
        }
        (node.is_said, node.is_down) = (true, true);
        let text = format!("{} is sent, but the node is {}", name(decoded, bus), nmt_state(state));
        Some((&rules::NOT_OPERATIONAL, text))
    }

    /// The first frame of a node that the network does not have.
    fn unknown(&mut self, node_id: u8, sight: Sight<'_>, book: &mut IncidentBook) {
        let Sight { decoded, bus, .. } = sight;
        let node = &mut self.nodes[usize::from(node_id) % super::NODES];
        if decoded.sdo.is_some_and(|sdo| sdo.is_request) || is_rpdo(decoded.service) {
            return;
        }
        node.is_seen = true;
        if node.is_unknown || !bus.descriptions.is_network || bus.reader.is_described(node_id) {
            return;
        }
        node.is_unknown = true;
        let text = || format!("node {node_id} is not in the network, but sends frames");
        book.against(Subject::new(&rules::UNKNOWN_NODE, node_id, 0), sight.seen(), text);
    }

    /// Whether no fault was found in the last transfer of a channel.
    pub(super) fn is_sound(&self, node_id: u8, sdo: SdoFrame) -> bool {
        self.channels.get(&(node_id, sdo.channel)).is_none_or(|channel| !channel.is_broken)
    }

    fn sdo(&mut self, node_id: u8, sight: Sight<'_>, book: &mut IncidentBook) {
        let Sight { decoded, frame, bus, .. } = sight;
        let Some(sdo) = decoded.sdo else { return };
        let seen = || sight.seen();
        let count = frame.data().len();
        if count != 8 {
            let side = if sdo.is_request { "request" } else { "response" };
            let text = || format!("{}: the SDO {side} has {count} bytes, not 8", bus.reader.name(node_id));
            book.against(Subject::new(&rules::SDO_LENGTH, node_id, 0), seen(), text);
        }
        let unanswered = Subject::new(&rules::UNANSWERED_REQUEST, node_id, 0);
        let node = &mut self.nodes[usize::from(node_id) % super::NODES];
        let channel = self.channels.entry((node_id, sdo.channel)).or_default();
        if !sdo.is_request {
            self.has_answers = true;
            channel.asked = None;
            book.end(unanswered, seen, "the node answers again");
        } else if is_begin(sdo.step) {
            if !node.is_seen {
                node.addressed.get_or_insert_with(seen);
            }
            // a scan asks for all nodes that there may be
            let is_expected = node.changed.is_some() || bus.reader.is_described(node_id);
            let asked = is_expected.then(|| (seen(), sdo.entry));
            if let Some((moment, entry)) = std::mem::replace(&mut channel.asked, asked) {
                book.against(unanswered, moment, || without_answer(bus, node_id, entry));
            }
        } else if matches!(sdo.step, TransferStep::Abort(_)) {
            channel.asked = None;
        }
        if let Some(fault) = channel.step(sdo, decoded, frame.data(), bus) {
            channel.is_broken = true;
            let entry = sdo.entry.map_or_else(String::new, |entry| bus.reader.entry_name(node_id, entry));
            let text = || format!("{}: {entry}: {fault}", bus.reader.name(node_id));
            book.against(Subject::new(&rules::BROKEN_TRANSFER, node_id, about(sdo)), seen(), text);
        }
    }

    /// What is missing at the end of the log; the last requests had no time for an answer.
    pub(super) fn close(&mut self, end: i64, bus: &Bus<'_>, book: &mut IncidentBook) {
        let is_past = |time: LogTime, limit: i64| end.saturating_sub(time.nanoseconds()) > limit;
        for (&(node_id, _), channel) in &mut self.channels {
            if let Some((moment, entry)) = channel.asked.take_if(|(moment, _)| is_past(moment.time, PATIENCE))
            {
                let subject = Subject::new(&rules::UNANSWERED_REQUEST, node_id, 0);
                book.against(subject, moment, || without_answer(bus, node_id, entry));
            }
        }
        let is_missing = |node: &NodeConduct| {
            !node.is_seen && node.addressed.as_ref().is_some_and(|seen| is_past(seen.time, PATIENCE))
        };
        // more are those that a scan looks for
        if self.has_answers && self.nodes.iter().filter(|node| is_missing(node)).count() <= MAX_MISSING {
            for (node, node_id) in self.nodes.iter_mut().zip(0..).filter(|(node, _)| is_missing(node)) {
                let Some(moment) = node.addressed.take() else { continue };
                let text =
                    || format!("{} does not respond: the log has no frame from it", bus.reader.name(node_id));
                book.against(Subject::new(&rules::MISSING_NODE, node_id, 0), moment, text);
            }
        }
        for (node, node_id) in self.nodes.iter_mut().zip(0..) {
            let waits = self.has_starts && node.state == Some(PRE_OPERATIONAL);
            let boot_up = node.boot_up.take().filter(|seen| waits && is_past(seen.time, START_TIME));
            if let Some(moment) = boot_up {
                let text = || format!("{} boots up and is not started", bus.reader.name(node_id));
                book.against(Subject::new(&rules::NOT_STARTED, node_id, 0), moment, text);
            }
        }
        if !self.has_answers {
            book.forget(&rules::UNANSWERED_REQUEST);
        }
    }
}

impl NodeConduct {
    /// It is operational, which ends what kept it from that.
    fn is_up(&mut self, node_id: u8, sight: Sight<'_>, book: &mut IncidentBook) {
        self.boot_up = None;
        if std::mem::take(&mut self.is_down) {
            for rule in DOWN {
                book.end(Subject::new(rule, node_id, 0), || sight.seen(), "the node is operational");
            }
        }
    }
}

/// The number of an entry, as what an incident is about.
pub(super) fn about(sdo: SdoFrame) -> u32 {
    sdo.entry.map_or(0, |(index, sub)| u32::from(index) << 8 | u32::from(sub))
}

fn without_answer(bus: &Bus<'_>, node_id: u8, entry: Option<(u16, u8)>) -> String {
    let entry = entry.map_or_else(String::new, |entry| bus.reader.entry_name(node_id, entry));
    format!("{}: no response to the request for {entry}", bus.reader.name(node_id))
}

/// Whether a client begins a transfer.
const fn is_begin(step: TransferStep) -> bool {
    matches!(
        step,
        TransferStep::Read | TransferStep::Write | TransferStep::WriteStart(_) | TransferStep::BlockRead
    )
}

impl ChannelConduct {
    /// How a step of a transfer is not sound.
    fn step(&mut self, sdo: SdoFrame, decoded: &DecodedFrame, data: &[u8], bus: &Bus<'_>) -> Option<String> {
        let command = *data.first()?;
        if is_begin(sdo.step) {
            let asked = self.asked.take();
            *self = Self { asked, ..Self::default() };
        }
        // of blocks, bit 2 of the first request and of its answer
        let is_start = matches!(sdo.step, TransferStep::ValueStart(_) | TransferStep::Expected);
        if is_begin(sdo.step) || is_start {
            self.has_crc[usize::from(sdo.is_request)] = command >> 5 >= 5 && command & 1 << 2 != 0;
        }
        match sdo.step {
            TransferStep::WriteStart(size) | TransferStep::ValueStart(size) => self.size = size,
            TransferStep::NextSegment | TransferStep::Segment(_) | TransferStep::LastSegment
                if sdo.is_request && sdo.entry.is_some() =>
            {
                let toggle = command & 0x10 != 0;
                if std::mem::replace(&mut self.toggle, !toggle) != toggle {
                    return Some("the toggle bit does not alternate".to_owned());
                }
            }
            _ => {}
        }
        if !matches!(sdo.step, TransferStep::LastSegment | TransferStep::BlockEnd) {
            return None;
        }
        let value = bus.reader.transfer(decoded)?.data();
        let is_other = |size: &u32| usize::try_from(*size).is_ok_and(|size| size != value.len());
        let size = self.size.take().filter(is_other);
        let size = size.map(|size| format!("{} of the {size} announced bytes were sent", value.len()));
        let sent = data.get(1..3).map(|bytes| u16::from_le_bytes([bytes[0], bytes[1]]));
        let is_checked = sdo.step == TransferStep::BlockEnd && self.has_crc == [true; 2];
        let wrong = sent.filter(|sent| is_checked && *sent != crc(0, value));
        let wrong = wrong.map(|sent| format!("the checksum is {sent:04X}h, not {:04X}h", crc(0, value)));
        let faults: Vec<String> = size.into_iter().chain(wrong).collect();
        (!faults.is_empty()).then(|| faults.join(", and "))
    }
}
