//! Sums over the frames of a bus, in memory that does not grow with their number.

mod conduct;
mod cycle;
mod deviations;
mod message;
mod report;

use std::collections::BTreeMap;

use self::conduct::Conduct;
use self::conduct::about;
use self::cycle::Cycle;
use self::deviations::{Preceding, malformed, of_abort, of_transfer, refused};
use self::message::{MessageSums, first_bytes};
use self::report::sync_period;
pub use self::report::{BusReport, incidents};
use super::{Bus, Origin, PRE_OPERATIONAL};
use crate::history::{History, Seen};
use crate::incident::{Drives, IncidentBook, Subject};
use crate::log::{LogTime, LoggedFrame};
use crate::sight::Sight;
use objdict_bus::classical_bits;
use objdict_document::describe::frames::{DecodedFrame, FrameKind, TransferStep};
use objdict_lint::recorded::traffic as rules;
use objdict_network::Service;

/// The most CAN-IDs of 29 bits.
const MAX_EXTENDED: usize = 4096;

/// The bit of an error frame of SocketCAN that says bus-off.
const BUS_OFF: u32 = 0x40;

/// So many distances between SYNC, and between PDOs, show that they are regular.
const SYNCS: u64 = 20;

/// So many distances between heartbeats do so.
const HEARTBEATS: u64 = 3;

/// The most error codes of a node that are followed.
const MAX_ERRORS: usize = 8;

/// So many requests of guarding without an answer are too many: the usual life time factor.
const GUARDINGS: u32 = 3;

/// The time over which the load is a peak, in nanoseconds, and the percent from which on it is one.
const LOAD_TIME: i64 = 100_000_000;
const PEAK: u64 = 90;

/// The time over which the present load is averaged, in nanoseconds.
const PRESENT: i64 = 500_000_000;

const SECOND: i64 = 1_000_000_000;

/// So many heartbeats that come twice in their period show two producers.
const DOUBLES: u32 = 4;

/// The most entries whose last written values are kept.
const MAX_WRITTEN: usize = 10_000;

/// The most bytes of a written value that are compared.
const MAX_VALUE: usize = 256;

/// The node-IDs, and 0 for frames of no node.
const NODES: usize = 128;

/// A frame that may turn out to be the last one.
#[derive(Clone, Debug)]
struct LastFrame {
    frame: LoggedFrame,
    log: usize,
    line: u64,
}

impl LastFrame {
    fn of(frame: &LoggedFrame, Origin { log, line, .. }: Origin<'_>) -> Self {
        Self { frame: frame.clone(), log, line }
    }

    fn seen(&self) -> Seen {
        Seen::of(&self.frame, Origin { log: self.log, line: self.line, text: &[] })
    }

    fn nanoseconds(&self) -> i64 {
        self.frame.time.nanoseconds()
    }
}

/// What was seen of a node.
#[derive(Clone, Debug, Default)]
struct NodeSums {
    frames: u64,
    bits: u64,
    boot_ups: u64,
    emergencies: u64,
    aborts: u64,
    lost: u64,
    state: Option<u8>,
    last_heartbeat: Option<Seen>,
    /// The longest time between heartbeats in nanoseconds; `None` if no description says it.
    limit: Option<i64>,
    /// The time of its heartbeat in nanoseconds, how long the last one was after the previous one, and how many came twice in it.
    period: Option<i64>,
    distance: i64,
    doubles: u32,
    /// Whether the node has said that it sends no heartbeats.
    is_off: bool,
    heartbeats: Cycle,
    /// Its last frame, while it has no heartbeat.
    last: Option<LastFrame>,
    /// When a command stopped or reset it, in nanoseconds.
    stopped: Option<i64>,
    /// The requests of guarding since its last answer, and whether it has answered one.
    guarding: (u32, bool),
    /// The error codes that it has sent and not taken back.
    errors: Vec<u16>,
}

/// The sums of a bus.
#[derive(Clone, Debug)]
pub struct BusSums {
    /// The bit rate in kbit/s.
    bit_rate: Option<u16>,
    frames: u64,
    error_frames: u64,
    bits: u64,
    /// When the present part of time began, in which peaks of the load are found, and its bits.
    part: (i64, u64),
    /// The load of the last parts in percent, of which the latest weigh most.
    present_load: f64,
    span: Option<(LogTime, LogTime)>,
    kinds: [u64; FrameKind::ALL.len()],
    /// Positions of CAN-IDs of 11 bits, from 1 on.
    base: Vec<u16>,
    extended: BTreeMap<u32, usize>,
    messages: Vec<MessageSums>,
    nodes: Vec<NodeSums>,
    /// How often nodes had changed when the limits of heartbeats and the period of SYNC were found.
    changes: Option<u64>,
    emergencies: History,
    aborts: History,
    book: IncidentBook,
    drives: Drives,
    starts: History,
    bus_errors: History,
    conduct: Conduct,
    last_sync: Option<LastFrame>,
    /// When SYNC came again after a second, in nanoseconds.
    sync_pause: Option<i64>,
    syncs: Cycle,
    is_bus_off: bool,
    /// The period of SYNC in nanoseconds, where a description states it.
    sync_period: Option<i64>,
    /// The last value that a node has accepted.
    written: BTreeMap<(u8, u16, u8), Vec<u8>>,
    is_written_cut: bool,
}

impl BusSums {
    /// Sums without a frame; the load is found if the bit rate in kbit/s is known.
    pub fn new(bit_rate: Option<u16>) -> Self {
        Self {
            bit_rate,
            frames: 0,
            error_frames: 0,
            bits: 0,
            part: (0, 0),
            present_load: 0.0,
            span: None,
            kinds: Default::default(),
            base: vec![0; 0x800],
            extended: BTreeMap::new(),
            messages: Vec::new(),
            nodes: vec![NodeSums::default(); NODES],
            changes: None,
            emergencies: History::default(),
            aborts: History::default(),
            book: IncidentBook::default(),
            drives: Drives::default(),
            starts: History::default(),
            bus_errors: History::default(),
            conduct: Conduct::default(),
            last_sync: None,
            sync_pause: None,
            syncs: Cycle::default(),
            is_bus_off: false,
            sync_period: None,
            written: BTreeMap::new(),
            is_written_cut: false,
        }
    }

    /// Adds a frame.
    pub fn add(&mut self, decoded: &DecodedFrame, frame: &LoggedFrame, origin: Origin<'_>, bus: &Bus<'_>) {
        let sight = Sight { decoded, frame, origin, bus };
        self.frames += 1;
        let (first, last) = self.span.unwrap_or((frame.time, frame.time));
        self.span = Some((first.min(frame.time), last.max(frame.time)));
        if frame.is_error {
            self.error_frame(sight);
            return;
        }
        if std::mem::take(&mut self.is_bus_off) {
            self.book.end(Subject::new(&rules::BUS_OFF, 0, 0), || sight.seen(), "frames again");
        }
        let bits = match self.bit_rate {
            Some(_) if !frame.is_fd => {
                classical_bits(frame.can_id, frame.is_extended, frame.is_remote, frame.data()).into()
            }
            _ => 0,
        };
        self.bits += bits;
        self.load_part(bits, sight);
        self.kinds[decoded.kind as usize] += 1;
        let changes = Some(bus.reader.changes().cycles);
        if self.changes != changes {
            self.changes = changes;
            self.find_limits(bus);
            self.sync_period = sync_period(bus).map(|period| i64::from(period) * 1000);
        }
        // a request is sent by another node, which no frame names
        let is_sent = match decoded.sdo {
            Some(sdo) => !sdo.is_request,
            None => !frame.is_remote && decoded.kind != FrameKind::Nmt && !is_rpdo(decoded.service),
        };
        let node_id = usize::from(decoded.node_id.unwrap_or(0)) % NODES;
        let sender = if is_sent { node_id } else { 0 };
        self.nodes[sender].frames += 1;
        self.nodes[sender].bits += bits;
        if sender != 0 && self.nodes[sender].last_heartbeat.is_none() {
            self.nodes[sender].last = Some(LastFrame::of(frame, origin));
        }
        if let Some(text) = malformed(decoded, frame) {
            let subject = Subject::new(&rules::MALFORMED_FRAME, node_id as u8, frame.can_id);
            self.book.against(subject, sight.seen(), || text);
        }
        if decoded.kind == FrameKind::Sync && !frame.is_remote {
            self.sync(node_id as u8, sight);
        }
        self.message(sight);
        self.conduct.frame(sight, &mut self.book);
        self.event(sight);
    }

    /// Finds peaks of the load in parts of time. More than all of it shows times that are not those of the bus.
    fn load_part(&mut self, bits: u64, sight: Sight<'_>) {
        let (start, sum) = self.part;
        let passed = sight.now().saturating_sub(start);
        if (0..LOAD_TIME).contains(&passed) {
            self.part.1 += bits;
            return;
        }
        self.part = (sight.now(), bits);
        let Some(rate) = self.bit_rate.filter(|_| sum > 0) else { return };
        // kbit/s are bits in a millisecond
        let passed = passed.max(LOAD_TIME) as f64;
        let part = sum as f64 * 1e8 / (f64::from(rate) * passed);
        self.present_load += (part - self.present_load) * (passed / PRESENT as f64).min(1.0);
        let percent = sum * 100 / (u64::from(rate) * (LOAD_TIME / 1_000_000) as u64);
        let subject = Subject::new(&rules::LOAD_PEAK, 0, 0);
        if (PEAK..=100).contains(&percent) {
            let text = || format!("the load was {percent} % for 100 ms");
            self.book.against(subject, sight.seen(), text);
        } else {
            self.book.end(subject, || sight.seen(), "the load is lower");
        }
    }

    fn message(&mut self, sight: Sight<'_>) {
        let Sight { decoded, frame, .. } = sight;
        let LoggedFrame { can_id, is_extended, .. } = *frame;
        let known = match is_extended {
            false => usize::from(self.base[can_id as usize & 0x7FF]).checked_sub(1),
            true => self.extended.get(&can_id).copied(),
        };
        let at = known.unwrap_or_else(|| {
            let at = self.messages.len();
            if is_extended {
                if self.extended.len() >= MAX_EXTENDED {
                    return usize::MAX;
                }
                self.extended.insert(can_id, at);
            } else {
                self.base[can_id as usize & 0x7FF] = at as u16 + 1;
            }
            self.messages.push(MessageSums::new(decoded, frame));
            at
        });
        let Some(message) = self.messages.get_mut(at) else { return };
        if message.kind != decoded.kind && message.kind == FrameKind::BootUp {
            message.kind = decoded.kind;
        }
        if decoded.kind == FrameKind::Pdo && !frame.is_remote {
            self.pdo(at, sight);
        }
        // a boot-up is not a part of the cycle of heartbeats
        let is_cyclic = decoded.kind != FrameKind::BootUp && !frame.is_remote;
        self.messages[at].cycle.add(frame.time, is_cyclic);
    }

    /// What the descriptions, and the PDOs before, say against a PDO.
    fn pdo(&mut self, at: usize, sight: Sight<'_>) {
        let Sight { decoded, frame, bus, origin } = sight;
        let Some(message) = self.messages.get_mut(at) else { return };
        let node_id = decoded.node_id.unwrap_or(0);
        let before = Preceding {
            frame: message.cycle.last,
            sync: self.last_sync.as_ref().map(LastFrame::nanoseconds),
            state: self.conduct.changed(node_id),
        };
        let about = frame.can_id;
        for (rule, text) in message.expected.deviations(decoded, frame, bus, before) {
            self.book.against(Subject::new(rule, node_id, about), sight.seen(), || text);
        }
        if message.expected.is_right_again(frame) {
            let subject = Subject::new(&rules::PDO_LENGTH, node_id, about);
            self.book.end(subject, || sight.seen(), "the length is right again");
        }
        // most frames repeat the words of the frame before
        let data = first_bytes(frame);
        let is_news = std::mem::replace(&mut message.data, data) != data;
        message.repeats += u64::from(!is_news);
        if message.expected.has_words && (is_news || self.drives.is_waiting) {
            self.drives.frame(sight, &mut self.book);
        }
        let last = message.steady.last.unwrap_or(0);
        let has_reason = [self.sync_pause, self.nodes[usize::from(node_id) % NODES].stopped, before.state]
            .iter()
            .any(|reason| reason.is_some_and(|reason| reason >= last.saturating_sub(SECOND)));
        if let Some(text) = message.silence(sight.now(), bus) {
            message.steady = Cycle::default();
            if !has_reason {
                let subject = Subject::new(&rules::SILENT_NODE, node_id, about);
                self.book.against(subject, sight.seen(), || text);
                self.book.end(subject, || sight.seen(), "it comes again");
            }
        }
        message.steady.add(frame.time, true);
        message.last = message.is_cyclic().then(|| LastFrame::of(frame, origin));
    }

    /// SYNC out of its cycle: half a period more or less is more than a busy bus explains. Without a described period a
    /// SYNC that was regular has its own.
    fn sync(&mut self, node_id: u8, sight: Sight<'_>) {
        let Sight { frame, origin, .. } = sight;
        let now = sight.now();
        let last = self.last_sync.replace(LastFrame::of(frame, origin)).map(|last| last.nanoseconds());
        let period = self.sync_period.or_else(|| self.syncs.regular(SYNCS));
        let Some((last, period)) = last.zip(period) else { return self.syncs.add(frame.time, true) };
        let gap = now.saturating_sub(last);
        if (period / 2..=period / 2 * 3).contains(&gap) {
            return self.syncs.add(frame.time, true);
        }
        // the period may be another one from now on
        self.syncs = Cycle::default();
        self.syncs.add(frame.time, true);
        if gap > SECOND {
            self.sync_pause = Some(now);
        }
        let is_early = gap < period / 2;
        let [gap, period] = [gap, period].map(milliseconds);
        let subject = Subject::new(&rules::SYNC_CYCLE, node_id, is_early.into());
        let many = if is_early { ", probably of a second producer: a frame has no sender" } else { "" };
        let text = || format!("SYNC was sent after {gap} ms; its period is {period} ms{many}");
        self.book.against(subject, sight.seen(), text);
    }

    fn error_frame(&mut self, sight: Sight<'_>) {
        self.error_frames += 1;
        let (seen, words) = (sight.seen(), sight.words());
        self.bus_errors.add(seen.clone(), 0, None, || words.clone());
        let is_bus_off = sight.frame.can_id & BUS_OFF != 0;
        self.is_bus_off |= is_bus_off;
        let rule = if is_bus_off { &rules::BUS_OFF } else { &rules::ERROR_FRAMES };
        self.book.against(Subject::new(rule, 0, 0), seen, || words);
    }

    /// What is more than a frame.
    fn event(&mut self, sight: Sight<'_>) {
        let Sight { decoded, frame, .. } = sight;
        if decoded.kind == FrameKind::Nmt {
            return self.command(frame);
        }
        let Some(node_id) = decoded.node_id else { return };
        let node = &mut self.nodes[usize::from(node_id) % NODES];
        match decoded.kind {
            FrameKind::BootUp => {
                node.boot_ups += 1;
                // a node sends it when it has become pre-operational (CiA 301 §7.3.2.2)
                (node.last_heartbeat, node.state, node.stopped) = (None, Some(PRE_OPERATIONAL), None);
                node.heartbeats = Cycle::default();
                self.errors_end(node_id, sight);
                self.starts.add(sight.seen(), node_id, None, || sight.words());
            }
            FrameKind::Heartbeat | FrameKind::Guarding if !frame.is_remote => {
                node.state = frame.data().first().map(|state| state & 0x7F);
                if decoded.kind == FrameKind::Heartbeat {
                    self.heartbeat(node_id, sight);
                } else {
                    node.guarding = (0, true);
                    let subject = Subject::new(&rules::SILENT_NODE, node_id, 0);
                    self.book.end(subject, || sight.seen(), "the node answers again");
                }
            }
            FrameKind::Guarding => {
                node.guarding.0 += 1;
                if node.guarding == (GUARDINGS, true) {
                    let subject = Subject::new(&rules::SILENT_NODE, node_id, 0);
                    let text = || format!("{} does not respond to guarding", sight.name(node_id));
                    self.book.against(subject, sight.seen(), text);
                }
            }
            FrameKind::Emcy if !frame.is_remote => {
                node.emergencies += 1;
                self.emergencies.add(sight.seen(), node_id, None, || sight.words());
                self.emergency(node_id, sight);
            }
            FrameKind::Sdo => self.transfer(node_id, sight),
            _ => {}
        }
    }

    /// Silence after a command that stops or resets a node is right.
    fn command(&mut self, frame: &LoggedFrame) {
        let &[command @ (2 | 0x80..=0x82), whom, ..] = frame.data() else { return };
        let nodes = self.nodes.iter_mut().enumerate();
        for (_, node) in nodes.filter(|(at, _)| whom == 0 || *at == usize::from(whom)) {
            node.stopped = Some(frame.time.nanoseconds());
            if matches!(command, 0x81 | 0x82) {
                node.last_heartbeat = None;
            }
        }
    }

    fn emergency(&mut self, node_id: u8, sight: Sight<'_>) {
        let &[low, high, ..] = sight.frame.data() else { return };
        let code = u16::from_le_bytes([low, high]);
        if code >> 8 == 0 {
            return self.errors_end(node_id, sight);
        }
        let errors = &mut self.nodes[usize::from(node_id) % NODES].errors;
        if !errors.contains(&code) && errors.len() < MAX_ERRORS {
            errors.push(code);
        }
        let words = sight.bus.reader.error_code(node_id, code);
        let text = || format!("{} reports EMCY {code:04X}h ({words})", sight.name(node_id));
        self.book.against(Subject::new(&rules::EMERGENCY, node_id, code.into()), sight.seen(), text);
    }

    /// A node takes back its errors, or boots up.
    fn errors_end(&mut self, node_id: u8, sight: Sight<'_>) {
        for code in std::mem::take(&mut self.nodes[usize::from(node_id) % NODES].errors) {
            let subject = Subject::new(&rules::EMERGENCY, node_id, code.into());
            self.book.end(subject, || sight.seen(), &sight.words());
        }
    }

    fn heartbeat(&mut self, node_id: u8, sight: Sight<'_>) {
        let node = &mut self.nodes[usize::from(node_id) % NODES];
        let (now, limit) = (sight.now(), node.heartbeat_limit());
        let last = node.last_heartbeat.replace(sight.seen());
        let gap = last.as_ref().map_or(0, |last| now.saturating_sub(last.time.nanoseconds()));
        let late = last.zip(limit).filter(|(_, limit)| gap > *limit);
        if late.is_some() {
            // the period may be another one from now on
            node.heartbeats = Cycle::default();
        }
        node.heartbeats.add(sight.frame.time, true);
        if node.is_doubled(gap) {
            let subject = Subject::new(&rules::SHARED_CAN_ID, node_id, 0);
            let text = || {
                format!(
                    "{}: heartbeats come twice in their time, probably of two nodes: a frame has no sender",
                    sight.name(node_id)
                )
            };
            self.book.against(subject, sight.seen(), text);
        }
        let node = &mut self.nodes[usize::from(node_id) % NODES];
        if let Some((last, limit)) = late {
            node.lost += 1;
            let subject = Subject::new(&rules::LATE_HEARTBEAT, node_id, 0);
            self.book.against(subject, last, || lost(&sight.name(node_id), gap, limit));
            self.book.end(subject, || sight.seen(), "heartbeat again");
        }
    }

    fn transfer(&mut self, node_id: u8, sight: Sight<'_>) {
        let Sight { decoded, bus, .. } = sight;
        let Some(sdo) = decoded.sdo else { return };
        let subject = |rule| Subject::new(rule, node_id, about(sdo));
        let seen = || sight.seen();
        if let Some((rule, text)) = of_transfer(node_id, decoded, bus) {
            self.book.against(subject(rule), seen(), || text);
        }
        self.drives.frame(sight, &mut self.book);
        let is_written = sdo.step == TransferStep::Written;
        if (is_written || !sdo.is_request && sdo.step.has_value()) && self.conduct.is_sound(node_id, sdo) {
            self.book.end(subject(&rules::BROKEN_TRANSFER), seen, "the transfer succeeds");
        }
        match (sdo.step, sdo.entry) {
            (TransferStep::Abort(code), _) => {
                self.nodes[usize::from(node_id) % NODES].aborts += 1;
                self.aborts.add(seen(), node_id, None, || sight.words());
                if let Some(rule) = of_abort(code, decoded, bus) {
                    let is_of_node = rule.id == rules::UNANSWERED_REQUEST.id;
                    let about = if is_of_node { 0 } else { about(sdo) };
                    self.book.against(Subject::new(rule, node_id, about), seen(), || refused(sight));
                }
            }
            (TransferStep::Written, Some((index, sub))) => {
                self.book.end(subject(&rules::REFUSED_WRITE), seen, "the node accepts the value");
                let key = (node_id, index, sub);
                if self.written.len() >= MAX_WRITTEN && !self.written.contains_key(&key) {
                    self.is_written_cut = true;
                    return;
                }
                if let Some(bytes) = bus.reader.transferred_bytes(decoded) {
                    let value = self.written.entry(key).or_default();
                    value.clear();
                    value.extend_from_slice(kept(bytes));
                }
            }
            _ => {}
        }
    }

    /// How long each node may be without a heartbeat: 1.5 times its own time, or less if a consumer waits less. A consumer that waits
    /// longer is no reason for a heartbeat to be late.
    fn find_limits(&mut self, bus: &Bus<'_>) {
        const MILLISECOND: i64 = 1_000_000;
        let services: Vec<_> = bus
            .reader
            .node_ids()
            .filter_map(|node_id| Some((node_id, bus.reader.device(node_id)?.services())))
            .collect();
        for node in &mut self.nodes {
            (node.limit, node.is_off, node.period) = (None, false, None);
        }
        for (node_id, own) in &services {
            let node = &mut self.nodes[usize::from(*node_id) % NODES];
            node.is_off = own.heartbeat_time == Some(0);
            let produced = own.heartbeat_time.filter(|time| *time != 0);
            node.period = produced.map(|time| i64::from(time) * MILLISECOND);
            node.limit = node.period.map(|period| period * 3 / 2);
        }
        let consumed = services.iter().flat_map(|(_, services)| &services.heartbeat_consumers);
        for consumer in consumed.filter(|consumer| consumer.time != 0) {
            if let Some(node) = self.nodes.get_mut(usize::from(consumer.node_id)) {
                let time = i64::from(consumer.time) * MILLISECOND;
                node.limit = Some(node.limit.map_or(time, |limit| limit.min(time)));
            }
        }
    }
}

impl NodeSums {
    /// Whether heartbeats have come twice in their period, so many times in a row.
    fn is_doubled(&mut self, gap: i64) -> bool {
        let former = std::mem::replace(&mut self.distance, gap);
        let is_double = self.period.is_some_and(|period| {
            let sum = gap.saturating_add(former);
            former.max(gap) < period / 100 * 85 && (period / 10 * 8..=period / 10 * 12).contains(&sum)
        });
        self.doubles = if is_double { self.doubles + 1 } else { 0 };
        self.doubles == DOUBLES
    }

    /// How long the node may be without a heartbeat, in nanoseconds. One that was regular has its own limit, with much room.
    fn heartbeat_limit(&self) -> Option<i64> {
        let own = || self.heartbeats.regular(HEARTBEATS).filter(|_| !self.is_off);
        self.limit.or_else(|| Some(own()?.saturating_mul(3)))
    }
}

/// What is kept of a value to compare it.
fn kept(bytes: &[u8]) -> &[u8] {
    &bytes[..bytes.len().min(MAX_VALUE)]
}

fn lost(name: &str, gap: i64, limit: i64) -> String {
    format!("{name}: no heartbeat for {} ms, limit {} ms", milliseconds(gap), milliseconds(limit))
}

fn is_rpdo(service: Option<Service>) -> bool {
    matches!(service, Some(Service::Pdo(pdo)) if pdo.kind == objdict_model::model::PdoKind::Rpdo)
}

/// Nanoseconds as milliseconds with three digits: `33.012`.
pub(super) fn milliseconds(nanoseconds: i64) -> String {
    let sign = if nanoseconds < 0 { "-" } else { "" };
    let micro = (nanoseconds.unsigned_abs() + 500) / 1000;
    format!("{sign}{}.{:03}", micro / 1000, micro % 1000)
}
