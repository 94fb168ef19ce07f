//! Bus timing: the load, and the maximum time until all nodes have received each message.

mod advice;
mod analysis;
mod boot;
mod frames;
mod load;
mod shares;
mod simulation;
#[cfg(test)]
mod tests;
pub mod timeline;

pub use self::boot::{BootTimes, NodeBootTime};
pub use self::frames::{DeadlineKind, TrafficKind};
pub use self::load::Load;
pub use self::shares::LoadShare;

use self::analysis::{Arrival, Background, ResponseTime, Stream, Streams, WaitCause};
use self::frames::{Rhythm, TimedFrame};
use crate::Language;
use crate::compiled::Compiled;
use crate::messages::{MessageId, Messages};
use crate::network::Network;
use crate::overview::End;
use crate::traffic::{Traffic, frame_bits};

/// The bit rates of CiA 301 in kbit/s.
const BIT_RATES: [u16; 8] = [10, 20, 50, 125, 250, 500, 800, 1000];

/// Assumptions about a network and its nodes. Times are in nanoseconds.
#[derive(Clone, Copy, Debug)]
pub struct TimingOptions {
    /// The bit rate in kbit/s; `None`: from the network.
    pub bit_rate: Option<u16>,
    /// The minimum time from an SDO or guarding request to its response.
    pub response_time: u64,
    /// The maximum time from SYNC to the synchronous PDOs of a node.
    pub node_delay: u64,
    /// The assumed inhibit time of event-driven PDOs without one.
    pub event_distance: Option<u64>,
    /// Whether there are SDO transfers in the background, one at a time.
    pub sdo: bool,
    /// Whether nodes send emergencies all the time.
    pub emergencies: bool,
    /// Whether unbounded messages are considered to be in time.
    pub allow_unbounded: bool,
}

impl Default for TimingOptions {
    /// Responses after 1 ms, no delay after SYNC, SDO transfers in the background, and no errors.
    fn default() -> Self {
        Self {
            bit_rate: None,
            response_time: frames::MILLISECOND,
            node_delay: 0,
            event_distance: None,
            sdo: true,
            emergencies: false,
            allow_unbounded: false,
        }
    }
}

/// A network in time. Times are in nanoseconds.
#[derive(Clone, Debug)]
pub struct Timing {
    /// The name of the network.
    pub name: Option<String>,
    /// The language of the text.
    pub language: Language,
    /// The bit rate in kbit/s.
    pub bit_rate: u16,
    /// How much of the bus is used.
    pub load: Load,
    /// The load by sender, in the order of the network.
    pub nodes: Vec<LoadShare<End>>,
    /// The load by kind of message.
    pub kinds: Vec<LoadShare<TrafficKind>>,
    /// The load at the bit rates of CiA 301.
    pub rates: Vec<RateRow>,
    /// SYNC and the messages it triggers; `None` without SYNC.
    pub sync: Option<SyncTime>,
    /// All messages, by priority.
    pub messages: Vec<TimedMessage>,
    /// The minimum inhibit time, in multiples of 100 µs, for PDOs without one, with which all messages meet their
    /// deadlines; `None` if there are no such PDOs, or no time is sufficient.
    pub inhibit_time: Option<u16>,
    /// Remedies for messages that miss their deadlines, in the order of the messages.
    pub remedies: Vec<Remedy>,
    /// The duration of the nodes' configuration; `None` without a manager.
    pub boot: Option<BootTimes>,
}

/// A message in time. Times are in nanoseconds.
#[derive(Clone, Debug)]
pub struct TimedMessage {
    /// The CAN-ID.
    pub can_id: MessageId,
    /// Its purpose.
    pub kind: TrafficKind,
    /// `TPDO 1`, `SYNC`, `boot-up`.
    pub name: String,
    /// The number of bytes.
    pub bytes: u64,
    /// The minimum and maximum number of bits on the bus, without and with stuff bits.
    pub bits: [u64; 2],
    /// The minimum interval; `None` if there is none.
    pub period: Option<u64>,
    /// Whether it is sent once in each period.
    pub is_cyclic: bool,
    /// Whether it may be sent at any time, as a PDO without inhibit time.
    pub is_unbounded: bool,
    /// How late it may be queued.
    pub jitter: u64,
    /// The maximum time until it is received; `None` if unbounded.
    pub response: Option<u64>,
    /// The message that makes it unbounded.
    pub unbounded_by: Option<MessageId>,
    /// Whether it is unbounded because SDO transfers may use all remaining time.
    pub waits_for_sdo: bool,
    /// Its deadline, and the reason for it.
    pub deadline: Option<(u64, DeadlineKind)>,
    /// Who sends it.
    pub sender: End,
    /// Who receives it.
    pub receivers: Vec<End>,
}

impl TimedMessage {
    /// Whether it may be late. This is unknown for a message that waits for PDOs at any time, or for SDO
    /// transfers without an end.
    pub fn is_missed(&self) -> bool {
        let Some((deadline, _)) = self.deadline else { return false };
        match self.response {
            Some(response) => response > deadline,
            None => self.unbounded_by.is_none() && !self.waits_for_sdo,
        }
    }
}

/// Remedies for a message that misses its deadline.
#[derive(Clone, Debug)]
pub struct Remedy {
    /// Its position in the messages.
    pub message: usize,
    /// The minimum CiA 301 bit rate in kbit/s at which it meets its deadline.
    pub bit_rate: Option<u16>,
    /// The message that it must precede in priority, so that the others still meet their deadlines.
    pub before: Option<MessageId>,
}

/// A network at a bit rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RateRow {
    /// The bit rate in kbit/s.
    pub bit_rate: u16,
    /// How much of the bus is used.
    pub load: Load,
    /// The number of messages that miss their deadlines, without PDOs that may be sent at any time.
    pub missed: usize,
}

impl RateRow {
    /// Whether the network fits.
    pub fn fits(&self) -> bool {
        self.missed == 0 && self.load.worst_percent(self.bit_rate) <= 100_000
    }
}

/// SYNC and the messages it triggers. Times are in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SyncTime {
    /// The communication cycle period (1006h).
    pub period: u64,
    /// The synchronous window length (1007h); 0: none.
    pub window: u64,
    /// From the start of SYNC to the end of the last synchronous PDO, if all are sent after one SYNC and
    /// other messages delay them; `None` if unbounded.
    pub needed: Option<u64>,
}

impl SyncTime {
    /// The time that the PDOs have.
    pub fn limit(&self) -> u64 {
        if self.window == 0 { self.period } else { self.window }
    }

    /// Whether the PDOs fit into it; `None` if unbounded.
    pub fn fits(&self) -> Option<bool> {
        Some(self.needed? <= self.limit())
    }
}

impl Timing {
    /// The times of a network; `None` without a bit rate.
    pub fn new(network: &Network, compiled: &Compiled, options: &TimingOptions) -> Option<Self> {
        Self::in_language(network, compiled, options, Language::default())
    }

    /// Like `new`, with text in a language.
    pub fn in_language(
        network: &Network,
        compiled: &Compiled,
        options: &TimingOptions,
        language: Language,
    ) -> Option<Self> {
        let messages = Messages::new(network, compiled);
        let traffic = Traffic { network, compiled, messages: &messages };
        let bit_rate =
            options.bit_rate.or(network.bit_rate.map(|rate| rate.value)).filter(|rate| *rate > 0)?;
        let schedule = Schedule::new(traffic, *options);
        let streams = schedule.streams(bit_rate, AnyTime::Counts);
        let responses = streams.responses();
        let sync = schedule.sync_time(&streams, &responses);
        let messages = schedule.messages(network, language, &streams, &responses);
        Some(Self {
            name: network.name.clone(),
            language,
            bit_rate,
            load: Load::of(&schedule.frames),
            nodes: schedule.by_node(network),
            kinds: schedule.by_kind(),
            rates: BIT_RATES.map(|rate| schedule.at_rate(rate)).to_vec(),
            sync,
            inhibit_time: schedule.bounding_inhibit_time(bit_rate),
            remedies: schedule.remedies(bit_rate, &messages),
            messages,
            boot: BootTimes::new(network, compiled, bit_rate, options.response_time),
        })
    }

    /// The minimum CiA 301 bit rate from which the network fits.
    pub fn fits_from(&self) -> Option<u16> {
        let fitting = self.rates.iter().rev().take_while(|row| row.fits());
        fitting.last().map(|row| row.bit_rate)
    }

    /// The PDOs that may be sent at any time.
    pub fn unbounded(&self) -> impl Iterator<Item = &TimedMessage> {
        self.messages.iter().filter(|message| message.is_unbounded)
    }

    /// Whether all messages certainly meet their deadlines, and the synchronous PDOs their window. Unbounded messages
    /// are not certain, unless the options allow them.
    pub fn is_met(&self, options: &TimingOptions) -> bool {
        let is_late = self.sync.is_some_and(|sync| sync.fits() == Some(false));
        let is_open = |message: &TimedMessage| {
            message.is_unbounded || message.deadline.is_some() && message.response.is_none()
        };
        !is_late
            && self
                .messages
                .iter()
                .all(|message| !message.is_missed() && (options.allow_unbounded || !is_open(message)))
    }
}

/// The treatment of PDOs that are sent at any time.
#[derive(Clone, Copy)]
enum AnyTime {
    Counts,
    LeftOut,
    /// As PDOs with an inhibit time in nanoseconds.
    Inhibited(u64),
}

/// The messages of a network with the assumptions about it.
pub(crate) struct Schedule {
    pub(crate) frames: Vec<TimedFrame>,
    window: u64,
    options: TimingOptions,
}

impl Schedule {
    pub(crate) fn new(traffic: Traffic<'_>, options: TimingOptions) -> Self {
        let mut frames = traffic.frames();
        if let Some(distance) = options.event_distance {
            frames
                .iter_mut()
                .filter(|frame| frame.rhythm == Rhythm::Unbounded)
                .for_each(|frame| frame.inhibit(distance));
        }
        let window = traffic.sync().map_or(0, |sync| sync.window.value) * frames::MICROSECOND;
        Self { frames, window, options }
    }

    fn position(&self, kind: TrafficKind) -> Option<usize> {
        self.frames.iter().position(|frame| frame.kind == kind)
    }

    /// The messages on the bus.
    fn streams(&self, bit_rate: u16, any_time: AnyTime) -> Streams {
        let time = |bits: u64| (bits * 1_000_000).div_ceil(bit_rate.max(1).into());
        let sync = self.position(TrafficKind::Sync);
        let streams = self.frames.iter().enumerate().map(|(at, frame)| {
            let (after, jitter) = match frame.kind {
                TrafficKind::SynchronousPdo => (sync, self.options.node_delay),
                // the response to the following request
                TrafficKind::Guarding if !frame.is_remote => (Some(at + 1), self.options.response_time),
                _ => (None, 0),
            };
            Stream {
                is_background: frame.kind == TrafficKind::Sdo,
                cost: time(frame.most_bits()),
                arrival: self.arrival(frame, any_time),
                jitter,
                after,
            }
        });
        let is_sdo = |frame: &TimedFrame| frame.kind == TrafficKind::Sdo;
        let background =
            self.frames.iter().position(is_sdo).filter(|_| self.options.sdo).map(|first| Background {
                cost: self
                    .frames
                    .iter()
                    .filter(|frame| is_sdo(frame))
                    .map(|frame| time(frame.most_bits()))
                    .max()
                    .unwrap_or(0),
                response_time: self.options.response_time,
                first,
                end: self.frames.iter().rposition(is_sdo).map_or(0, |last| last + 1),
            });
        Streams { streams: streams.collect(), background, bit_time: time(1) }
    }

    fn arrival(&self, frame: &TimedFrame, any_time: AnyTime) -> Arrival {
        match (frame.rhythm, frame.kind) {
            (_, TrafficKind::Emcy) if !self.options.emergencies => Arrival::Rare,
            (Rhythm::Rare, TrafficKind::Emcy) => Arrival::Unbounded,
            (Rhythm::Cyclic(time) | Rhythm::AtLeast(time), _) => Arrival::Every(time),
            (Rhythm::Rare, _) => Arrival::Rare,
            (Rhythm::Unbounded, _) => match any_time {
                AnyTime::Counts => Arrival::Unbounded,
                AnyTime::LeftOut => Arrival::Rare,
                AnyTime::Inhibited(time) => Arrival::Every(time),
            },
        }
    }

    fn messages(
        &self,
        network: &Network,
        language: Language,
        streams: &Streams,
        responses: &[ResponseTime],
    ) -> Vec<TimedMessage> {
        let jitters = streams.jitters(responses);
        let message = |(at, frame): (usize, &TimedFrame)| TimedMessage {
            can_id: frame.id,
            kind: frame.kind,
            name: frame.name(language),
            bytes: frame.bytes,
            bits: [frame.least_bits(), frame.most_bits()],
            period: frame.rhythm.distance(),
            is_cyclic: matches!(frame.rhythm, Rhythm::Cyclic(_)),
            is_unbounded: frame.rhythm == Rhythm::Unbounded,
            jitter: jitters[at],
            response: match responses[at] {
                ResponseTime::Within(time) => Some(time),
                ResponseTime::Unbounded(_) => None,
            },
            unbounded_by: match responses[at] {
                ResponseTime::Unbounded(WaitCause::Message(cause)) => Some(self.frames[cause].id),
                _ => None,
            },
            waits_for_sdo: responses[at] == ResponseTime::Unbounded(WaitCause::Background),
            deadline: frame.deadline,
            sender: End::new(network, &frame.sender),
            receivers: frame.receivers.iter().map(|party| End::new(network, party)).collect(),
        };
        self.frames.iter().enumerate().map(message).collect()
    }

    /// SYNC with all that it triggers.
    fn sync_time(&self, streams: &Streams, responses: &[ResponseTime]) -> Option<SyncTime> {
        let at = self.position(TrafficKind::Sync)?;
        let triggered: Vec<usize> = (0..self.frames.len())
            .filter(|at| self.frames[*at].kind == TrafficKind::SynchronousPdo)
            .collect();
        let jitters = streams.jitters(responses);
        let burst = if triggered.is_empty() { Some(0) } else { streams.burst(at, &triggered, &jitters) };
        let needed = burst.map(|burst| streams.streams[at].cost + self.options.node_delay + burst);
        Some(SyncTime { period: self.frames[at].rhythm.distance().unwrap_or(0), window: self.window, needed })
    }

    /// The positions of messages that miss their deadlines.
    pub(crate) fn missed(&self, responses: &[ResponseTime], any_time: Option<u64>) -> Vec<usize> {
        let is_late = |at: &usize| {
            let frame = &self.frames[*at];
            let distance = any_time.filter(|_| frame.rhythm == Rhythm::Unbounded);
            let deadline =
                [frame.deadline.map(|(deadline, _)| deadline), distance].into_iter().flatten().min();
            match responses[*at] {
                ResponseTime::Within(response) => deadline.is_some_and(|deadline| response > deadline),
                ResponseTime::Unbounded(WaitCause::Background) => false,
                ResponseTime::Unbounded(_) => deadline.is_some(),
            }
        };
        (0..self.frames.len()).filter(is_late).collect()
    }

    /// The maximum number of bits of SYNC and all messages it triggers.
    pub(crate) fn bits_of_cycle(&self) -> u64 {
        let kinds = [TrafficKind::Sync, TrafficKind::SynchronousPdo];
        let frames = self.frames.iter().filter(|frame| kinds.contains(&frame.kind));
        frames.map(TimedFrame::most_bits).sum()
    }

    /// The messages that miss their deadlines even without PDOs that are sent at any time, with their responses.
    pub(crate) fn late(&self, bit_rate: u16) -> Vec<(&TimedFrame, u64)> {
        let responses = self.streams(bit_rate, AnyTime::LeftOut).responses();
        let late = self.missed(&responses, None).into_iter().filter_map(|at| match responses[at] {
            ResponseTime::Within(response) => Some((&self.frames[at], response)),
            ResponseTime::Unbounded(_) => None,
        });
        late.collect()
    }

    /// Whether SYNC and the messages it triggers may exceed the available time.
    fn is_over_window(&self, streams: &Streams, responses: &[ResponseTime]) -> bool {
        self.sync_time(streams, responses).is_some_and(|sync| sync.fits() != Some(true))
    }

    fn at_rate(&self, bit_rate: u16) -> RateRow {
        let streams = self.streams(bit_rate, AnyTime::LeftOut);
        let responses = streams.responses();
        let missed = self.missed(&responses, None).len();
        let missed = missed.max(usize::from(self.is_over_window(&streams, &responses)));
        RateRow { bit_rate, load: Load::of(&self.frames), missed }
    }
}

impl TimedFrame {
    /// Sets an inhibit time.
    fn inhibit(&mut self, distance: u64) {
        self.rhythm = Rhythm::AtLeast(distance);
        self.usual = self.usual.or(Some(distance));
    }

    /// `TPDO 1`, `SYNC`, `boot-up`.
    fn name(&self, language: Language) -> String {
        match (self.kind, self.rhythm, self.is_remote) {
            (TrafficKind::Heartbeat, Rhythm::Rare, _) => language.pick("boot-up", "Boot-up").to_owned(),
            (TrafficKind::Guarding, _, true) => {
                language.pick("guarding request", "Guarding-Anfrage").to_owned()
            }
            (TrafficKind::Guarding, ..) => language.pick("guarding", "Guarding").to_owned(),
            _ => self.sender.service.name(language).into_owned(),
        }
    }
}

/// The maximum number of bits of the download of a value: expedited up to 4 bytes, otherwise in segments of
/// 7.
pub(crate) const fn sdo_bits(size: usize) -> u64 {
    2 * sdo_requests(size) * frame_bits(8, false)
}

/// The number of requests for the download of a value.
const fn sdo_requests(size: usize) -> u64 {
    1 + if size <= 4 { 0 } else { size.div_ceil(7) as u64 }
}
