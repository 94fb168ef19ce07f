//! What the order of frames shows: NMT states, SDO transfers, and nodes that do not belong to the network.

use std::collections::BTreeMap;

use super::History;
use super::deviations::{Deviation, name};
use super::history::{NodeEvent, Seen};
use crate::log::{LogTime, LoggedFrame};
use crate::{Bus, Origin, PRE_OPERATIONAL};
use objdict_bus::crc;
use objdict_document::describe::frames::{DecodedFrame, FrameKind, SdoFrame, TransferStep, nmt_state};
use objdict_lint::recorded::traffic as rules;
use objdict_model::model::PdoKind;
use objdict_network::Service;

const OPERATIONAL: u8 = 5;

/// A client waits so many nanoseconds for an answer: the usual timeout of a second.
const PATIENCE: i64 = 1_000_000_000;

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
}

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
}

/// What was seen of the order of frames.
#[derive(Debug)]
pub(super) struct Conduct {
    nodes: Vec<NodeConduct>,
    channels: BTreeMap<(u8, u16), ChannelConduct>,
    has_commands: bool,
    has_answers: bool,
    /// Requests without an answer: they say something if the log has answers at all.
    unanswered: History,
}

impl Default for Conduct {
    fn default() -> Self {
        Self {
            nodes: vec![NodeConduct::default(); super::NODES],
            channels: BTreeMap::new(),
            has_commands: false,
            has_answers: false,
            unanswered: History::default(),
        }
    }
}

impl Conduct {
    /// When the state of a node changed, in nanoseconds.
    pub(super) fn changed(&self, node_id: u8) -> Option<i64> {
        self.nodes[usize::from(node_id) % super::NODES].changed
    }

    /// The rules that a frame is against in its order.
    pub(super) fn frame(
        &mut self,
        decoded: &DecodedFrame,
        frame: &LoggedFrame,
        origin: Origin<'_>,
        bus: &Bus<'_>,
    ) -> Vec<Deviation> {
        if frame.is_remote {
            return Vec::new();
        }
        let now = frame.time.nanoseconds();
        if decoded.kind == FrameKind::Nmt {
            self.command(frame.data(), now);
            return Vec::new();
        }
        let Some(node_id) = decoded.node_id else { return Vec::new() };
        let unknown = self.unknown(node_id, decoded, bus);
        let own = match decoded.kind {
            FrameKind::BootUp => self.boot_up(node_id, now, bus).into_iter().collect(),
            FrameKind::Heartbeat => {
                self.heartbeat(node_id, frame.data(), now);
                Vec::new()
            }
            FrameKind::Pdo => self.pdo(node_id, decoded, bus).into_iter().collect(),
            FrameKind::Sdo => self.sdo(node_id, decoded, frame, origin, bus),
            _ => Vec::new(),
        };
        unknown.into_iter().chain(own).collect()
    }

    fn command(&mut self, data: &[u8], now: i64) {
        let &[command, node_id, ..] = data else { return };
        self.has_commands = true;
        let nodes = self.nodes.iter_mut().enumerate();
        for (_, node) in nodes.filter(|(at, _)| node_id == 0 || *at == usize::from(node_id)) {
            // what a node has to send before it obeys is still sent
            node.state = (command == 1).then_some(OPERATIONAL);
            (node.is_said, node.changed) = (false, Some(now));
        }
    }

    fn boot_up(&mut self, node_id: u8, now: i64, bus: &Bus<'_>) -> Option<Deviation> {
        let node = &mut self.nodes[usize::from(node_id) % super::NODES];
        let is_unexpected = node.state.replace(PRE_OPERATIONAL) == Some(OPERATIONAL) && self.has_commands;
        // 1F80h bit 2: the node does not start by itself (CiA 302-2)
        let startup = bus.reader.device(node_id).map(|device| device.value(0x1F80, 0));
        let waits = startup.is_some_and(|startup| {
            let number = startup.and_then(|value| value.as_integer());
            number.is_none_or(|number| number & 1 << 2 != 0)
        });
        node.state = node.state.filter(|_| waits);
        (node.is_said, node.changed) = (false, Some(now));
        is_unexpected.then(|| {
            let text = format!("{} boots up in operation, without a command", bus.reader.name(node_id));
            (&rules::UNEXPECTED_BOOT_UP, text)
        })
    }

    fn heartbeat(&mut self, node_id: u8, data: &[u8], now: i64) {
        let node = &mut self.nodes[usize::from(node_id) % super::NODES];
        let state = data.first().map(|state| state & 0x7F);
        if node.state != state {
            (node.state, node.is_said, node.changed) = (state, false, Some(now));
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
        node.is_said = true;
        let text = format!("{} is sent, but the node is {}", name(decoded, bus), nmt_state(state));
        Some((&rules::NOT_OPERATIONAL, text))
    }

    /// The first frame of a node that the network does not have.
    fn unknown(&mut self, node_id: u8, decoded: &DecodedFrame, bus: &Bus<'_>) -> Option<Deviation> {
        let node = &mut self.nodes[usize::from(node_id) % super::NODES];
        let is_sent = decoded.sdo.is_none_or(|sdo| !sdo.is_request);
        if node.is_unknown || !bus.descriptions.is_network || !is_sent || bus.reader.is_described(node_id) {
            return None;
        }
        node.is_unknown = true;
        Some((&rules::UNKNOWN_NODE, format!("node {node_id} is not in the network, but sends frames")))
    }

    fn sdo(
        &mut self,
        node_id: u8,
        decoded: &DecodedFrame,
        frame: &LoggedFrame,
        origin: Origin<'_>,
        bus: &Bus<'_>,
    ) -> Vec<Deviation> {
        let Some(sdo) = decoded.sdo else { return Vec::new() };
        let mut found = Vec::new();
        let count = frame.data().len();
        if count != 8 {
            let side = if sdo.is_request { "request" } else { "response" };
            let text = format!("{}: the SDO {side} has {count} bytes, not 8", bus.reader.name(node_id));
            found.push((&rules::SDO_LENGTH, text));
        }
        let is_there = self.nodes[usize::from(node_id) % super::NODES].changed.is_some();
        let channel = self.channels.entry((node_id, sdo.channel)).or_default();
        if !sdo.is_request {
            self.has_answers = true;
            channel.asked = None;
        } else if is_begin(sdo.step) {
            // a scan asks for all nodes that there may be
            let is_expected = is_there || bus.reader.is_described(node_id);
            let asked = is_expected.then(|| (Seen::of(frame, origin), sdo.entry));
            if let Some((moment, entry)) = std::mem::replace(&mut channel.asked, asked) {
                let text = || unanswered(bus, node_id, entry);
                self.unanswered.add(moment, node_id, Some(&rules::UNANSWERED_REQUEST), text);
            }
        } else if matches!(sdo.step, TransferStep::Abort(_)) {
            channel.asked = None;
        }
        if let Some(fault) = channel.step(sdo, decoded, frame.data(), bus) {
            let entry = sdo.entry.map_or_else(String::new, |entry| bus.reader.entry_name(node_id, entry));
            let text = format!("{}: {entry}: {fault}", bus.reader.name(node_id));
            found.push((&rules::BROKEN_TRANSFER, text));
        }
        found
    }

    /// The requests without an answer; those at the end of the log had no time for it.
    pub(super) fn unanswered(&mut self, end: i64, bus: &Bus<'_>) -> Vec<NodeEvent> {
        for (&(node_id, _), channel) in &mut self.channels {
            let is_late = |time: LogTime| end.saturating_sub(time.nanoseconds()) > PATIENCE;
            if let Some((moment, entry)) = channel.asked.take_if(|(moment, _)| is_late(moment.time)) {
                let text = || unanswered(bus, node_id, entry);
                self.unanswered.add(moment, node_id, Some(&rules::UNANSWERED_REQUEST), text);
            }
        }
        if self.has_answers { self.unanswered.take() } else { Vec::new() }
    }
}

fn unanswered(bus: &Bus<'_>, node_id: u8, entry: Option<(u16, u8)>) -> String {
    let entry = entry.map_or_else(String::new, |entry| bus.reader.entry_name(node_id, entry));
    format!("{}: the request for {entry} has no answer", bus.reader.name(node_id))
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
        let size =
            size.map(|size| format!("{} of the {size} bytes were sent that were announced", value.len()));
        let sent = data.get(1..3).map(|bytes| u16::from_le_bytes([bytes[0], bytes[1]]));
        let is_checked = sdo.step == TransferStep::BlockEnd && self.has_crc == [true; 2];
        let wrong = sent.filter(|sent| is_checked && *sent != crc(0, value));
        let wrong = wrong.map(|sent| format!("the checksum is {sent:04X}h, not {:04X}h", crc(0, value)));
        let faults: Vec<String> = size.into_iter().chain(wrong).collect();
        (!faults.is_empty()).then(|| faults.join(", and "))
    }
}
