//! Every frame that a network sends, with its length and its rhythm.

use crate::compiled::PdoState;
use crate::messages::{Message, MessageId, Party, Service};
use crate::model::{PdoKind, predefined};
use crate::traffic::{Sync, Traffic, frame_bits};

pub(super) const MICROSECOND: u64 = 1000;
pub(super) const MILLISECOND: u64 = 1_000_000;

/// The minimum number of bits of a data frame with this many bytes: without stuff bits, with the interframe
/// space.
const fn least_bits(bytes: u64, is_extended: bool) -> u64 {
    if is_extended { 67 + 8 * bytes } else { 47 + 8 * bytes }
}

/// The purpose of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum TrafficKind {
    /// NMT commands.
    Nmt,
    /// SYNC.
    Sync,
    /// TIME.
    Time,
    /// EMCY.
    Emcy,
    /// A PDO that SYNC triggers.
    SynchronousPdo,
    /// A PDO that an event or a request triggers.
    EventPdo,
    /// SDO transfers.
    Sdo,
    /// Heartbeat and boot-up.
    Heartbeat,
    /// The request and the response of node guarding.
    Guarding,
}

/// How often a message is sent. Times are in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rhythm {
    /// Once in each period.
    Cyclic(u64),
    /// At any time, but with this minimum interval.
    AtLeast(u64),
    /// At any time.
    Unbounded,
    /// On errors, commands and requests.
    Rare,
}

impl Rhythm {
    /// The shortest time between two messages.
    pub(crate) const fn distance(self) -> Option<u64> {
        match self {
            Self::Cyclic(time) | Self::AtLeast(time) => Some(time),
            Self::Unbounded | Self::Rare => None,
        }
    }
}

/// The origin of a message's deadline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum DeadlineKind {
    /// The period of the message.
    Period,
    /// The event timer of the PDO.
    EventTimer,
    /// The synchronous window length (1007h).
    SyncWindow,
    /// The timeout of a receiver, from 1016h or the event timer of an RPDO, minus the time until the next
    /// message is sent.
    Receiver,
}

/// A message in time. Times are in nanoseconds.
#[derive(Clone, Debug)]
pub(crate) struct TimedFrame {
    pub(crate) id: MessageId,
    pub(crate) is_remote: bool,
    pub(crate) kind: TrafficKind,
    pub(crate) bytes: u64,
    pub(crate) rhythm: Rhythm,
    /// The interval between messages without events; `None` if there is none.
    pub(crate) usual: Option<u64>,
    pub(crate) deadline: Option<(u64, DeadlineKind)>,
    pub(crate) sender: Party,
    pub(crate) receivers: Vec<Party>,
}

impl TimedFrame {
    pub(super) fn new(id: MessageId, kind: TrafficKind, bytes: u64, rhythm: Rhythm, sender: Party) -> Self {
        Self {
            id,
            is_remote: false,
            kind,
            bytes,
            rhythm,
            usual: rhythm.distance(),
            deadline: rhythm.distance().map(|period| (period, DeadlineKind::Period)),
            sender,
            receivers: Vec::new(),
        }
    }

    /// The arbitration order: the lowest wins. With equal first 11 bits, a base frame wins, and a data frame
    /// before a remote frame.
    pub(crate) const fn priority(&self) -> (u32, bool, u32, bool) {
        match self.id.is_extended {
            false => (self.id.number, false, 0, self.is_remote),
            true => (self.id.number >> 18, true, self.id.number & 0x3_FFFF, self.is_remote),
        }
    }

    pub(crate) const fn most_bits(&self) -> u64 {
        frame_bits(self.bytes, self.id.is_extended)
    }

    pub(crate) const fn least_bits(&self) -> u64 {
        least_bits(self.bytes, self.id.is_extended)
    }

    fn limit(&mut self, time: u64, kind: DeadlineKind) {
        if self.deadline.is_none_or(|(deadline, _)| time < deadline) {
            self.deadline = Some((time, kind));
        }
    }

    /// Adds a receiver with a timeout of `time` after the last message.
    fn awaited(&mut self, time: u64) {
        // a timeout that does not exceed the period leaves no time: the message is late in any case
        self.limit(time.saturating_sub(self.usual.unwrap_or(0)), DeadlineKind::Receiver);
    }
}

impl Traffic<'_> {
    /// All messages that a node sends, by priority.
    pub(crate) fn frames(self) -> Vec<TimedFrame> {
        let sync = self.sync();
        let mut frames = Vec::new();
        for (id, message) in &self.messages.0 {
            // several senders are an error; the first one is used
            let Some(sender) = message.senders.first() else { continue };
            let sent = self.sent_as(*id, message, *sender, sync.as_ref());
            frames.extend(
                sent.into_iter().map(|frame| TimedFrame { receivers: message.receivers.clone(), ..frame }),
            );
        }
        frames.sort_by_key(TimedFrame::priority);
        frames
    }

    fn sent_as(
        self,
        id: MessageId,
        message: &Message,
        sender: Party,
        sync: Option<&Sync>,
    ) -> Vec<TimedFrame> {
        let rare = |kind, bytes| TimedFrame::new(id, kind, bytes, Rhythm::Rare, sender);
        match sender.service {
            Service::Nmt => vec![rare(TrafficKind::Nmt, 2)],
            Service::Time => vec![rare(TrafficKind::Time, 6)],
            Service::SdoRequest | Service::SdoResponse => vec![rare(TrafficKind::Sdo, 8)],
            Service::Emcy => {
                let distance = self.emcy_inhibit_time(sender);
                let rhythm = if distance == 0 { Rhythm::Rare } else { Rhythm::AtLeast(distance) };
                // no error, no message
                vec![TimedFrame {
                    usual: None,
                    deadline: None,
                    ..TimedFrame::new(id, TrafficKind::Emcy, 8, rhythm, sender)
                }]
            }
            Service::Sync => {
                let Some(sync) = sync else { return Vec::new() };
                let rhythm = Rhythm::Cyclic(sync.period.max(1) * MICROSECOND);
                vec![TimedFrame::new(id, TrafficKind::Sync, sync.bytes, rhythm, sender)]
            }
            Service::ErrorControl => self.error_control(id, sender),
            Service::Pdo(_) => self.pdo(id, message, sender, sync).into_iter().collect(),
        }
    }

    fn emcy_inhibit_time(self, sender: Party) -> u64 {
        let tenths = self.compiled.node(sender.node).and_then(|slave| slave.services().emcy_inhibit_time);
        u64::from(tenths.unwrap_or(0)) * 100 * MICROSECOND
    }

    /// Heartbeat, guarding, or only boot-up.
    fn error_control(self, id: MessageId, sender: Party) -> Vec<TimedFrame> {
        let times = self.compiled.node(sender.node).map(|slave| (slave.heartbeat, slave.guard_time));
        let every = |time: u16| Rhythm::Cyclic(u64::from(time) * MILLISECOND);
        let frame = |kind, bytes, rhythm| TimedFrame::new(id, kind, bytes, rhythm, sender);
        match times.unwrap_or_default() {
            (0, 0) => vec![frame(TrafficKind::Heartbeat, 1, Rhythm::Rare)],
            (0, time) => {
                let manager = self.network.manager.as_ref().and_then(|manager| manager.node);
                let asker = Party { node: manager.unwrap_or(sender.node), ..sender };
                let request = TimedFrame {
                    is_remote: true,
                    sender: asker,
                    ..frame(TrafficKind::Guarding, 0, every(time))
                };
                vec![frame(TrafficKind::Guarding, 1, every(time)), request]
            }
            (time, _) => {
                let mut frame = frame(TrafficKind::Heartbeat, 1, every(time));
                self.consumer_times(id).into_iter().for_each(|time| frame.awaited(time));
                vec![frame]
            }
        }
    }

    /// How long the consumers of a heartbeat wait for it.
    fn consumer_times(self, id: MessageId) -> Vec<u64> {
        let Some(node_id) = id.number.checked_sub(predefined::ERROR_CONTROL.into()) else {
            return Vec::new();
        };
        let consumers = self.compiled.nodes().flat_map(|slave| &slave.services().heartbeat_consumers);
        let of_node = consumers.filter(|consumer| u32::from(consumer.node_id) == node_id);
        let times = of_node.map(|consumer| u64::from(consumer.time) * MILLISECOND);
        times.filter(|time| *time != 0).collect()
    }

    /// A PDO with the parameters of its sender, otherwise of a receiver; `None` if it waits for a SYNC that
    /// no node sends.
    fn pdo(self, id: MessageId, message: &Message, sender: Party, sync: Option<&Sync>) -> Option<TimedFrame> {
        let mut parties = message.senders.iter().chain(&message.receivers);
        let state = parties.find_map(|party| self.compiled.pdo(party))?;
        let inhibit = Some(u64::from(state.inhibit_time) * 100 * MICROSECOND).filter(|time| *time != 0);
        let timer = Some(u64::from(state.event_timer) * MILLISECOND).filter(|time| *time != 0);
        let period = state.period(sync).map(|period| period.max(1) * MICROSECOND);
        let (kind, rhythm) = match (state.transmission, period) {
            (1..=240, period) => (TrafficKind::SynchronousPdo, Rhythm::Cyclic(period?)),
            (0, period) => (TrafficKind::SynchronousPdo, Rhythm::AtLeast(period?)),
            // as often as requested
            (252 | 253, _) => (TrafficKind::EventPdo, inhibit.map_or(Rhythm::Rare, Rhythm::AtLeast)),
            _ => (TrafficKind::EventPdo, inhibit.map_or(Rhythm::Unbounded, Rhythm::AtLeast)),
        };
        let mut frame = TimedFrame::new(id, kind, state.bytes(), rhythm, sender);
        match kind {
            TrafficKind::SynchronousPdo => {
                let window = sync.map_or(0, |sync| sync.window.value) * MICROSECOND;
                if window != 0 {
                    frame.limit(window, DeadlineKind::SyncWindow);
                }
            }
            _ => {
                frame.usual = timer.or(inhibit);
                // an inhibit time is not a deadline: the next message is newer
                frame.deadline = timer.map(|timer| (timer, DeadlineKind::EventTimer));
            }
        }
        for time in self.deadlines(message, state) {
            match kind {
                // without a timer, the interval is unknown
                TrafficKind::EventPdo if timer.is_none() => frame.limit(time, DeadlineKind::Receiver),
                _ => frame.awaited(time),
            }
        }
        Some(frame)
    }

    /// How long the receivers of a PDO wait for it.
    fn deadlines(self, message: &Message, sent: &PdoState) -> Vec<u64> {
        let received = message.receivers.iter().filter_map(|party| self.compiled.pdo(party));
        let own = Some(sent).filter(|state| state.pdo.kind == PdoKind::Tpdo).into_iter();
        let times = received.chain(own).map(|state| u64::from(state.deadline) * MILLISECOND);
        times.filter(|time| *time != 0).collect()
    }
}

impl PdoState {
    /// The minimum interval in microseconds; `None` for PDOs that an event may trigger at any time.
    pub(crate) fn period(&self, sync: Option<&Sync>) -> Option<u64> {
        match self.transmission {
            0..=240 => sync.map(|sync| sync.period * u64::from(self.transmission.max(1))),
            _ => [u64::from(self.inhibit_time) * 100, u64::from(self.event_timer) * 1000]
                .into_iter()
                .find(|time| *time != 0),
        }
    }

    /// The bytes that it has on the bus.
    pub(crate) fn bytes(&self) -> u64 {
        u64::from(self.bits().div_ceil(8)).min(8)
    }
}
