//! The JSON document of `objdict network timing`.

use serde::Serialize;

use objdict_model::json::Version;
use objdict_network::{
    BootTimes, DeadlineKind, Load, NodeBootTime, RateRow, Remedy, SyncTime, TimedMessage, Timing,
    TimingOptions, TrafficKind,
};

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct TimingJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The files as they were given, separated by spaces.
    file: &'a str,
    /// The name of the network.
    name: Option<&'a str>,
    /// The bit rate in kbit/s.
    bit_rate: u16,
    /// What was assumed.
    assumptions: Assumptions,
    /// Whether the exit code is 0: all messages are sure to meet their deadlines; with `--allow-unbounded`, all messages with a bound.
    is_met: bool,
    /// How much of the bus is used.
    load: LoadRow,
    /// The same for each sender.
    nodes: Vec<MessageLoad<&'a str>>,
    /// The same for each kind of message.
    kinds: Vec<MessageLoad<TrafficKind>>,
    /// The network at the bit rates of CiA 301, without PDOs that are sent at any time.
    bit_rates: Vec<BitRateTimes>,
    /// The least of these bit rates from which the network fits.
    fits_from: Option<u16>,
    /// SYNC and what it triggers; `null` without SYNC.
    sync: Option<SyncRow>,
    /// The least inhibit time in microseconds of PDOs without one with which all messages meet their deadlines.
    inhibit_time_us: Option<u64>,
    /// All messages, highest priority first.
    messages: Vec<MessageTimes<'a>>,
    /// What would help messages that are late.
    remedies: Vec<RemedyRow>,
    /// How long it takes to configure the nodes; `null` without a manager.
    boot: Option<BootRow<'a>>,
}

/// What was assumed. Times are in microseconds.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Assumptions {
    /// From a request of SDO or guarding to its answer.
    response_time_us: u64,
    /// From SYNC to the PDOs of a node.
    node_delay_us: u64,
    /// The inhibit time of event-driven PDOs that have none.
    inhibit_time_us: Option<u64>,
    /// Whether there are SDO transfers in the background, one at a time.
    sdo: bool,
    /// Whether nodes send emergencies all the time.
    emergencies: bool,
}

/// A load.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Load"))]
struct LoadRow {
    /// Bits each second, without stuff bits, with PDOs as often as their event timers say.
    average: f64,
    /// Bits each second, with the most stuff bits, and PDOs as often as they may be sent.
    worst: f64,
    /// The average in percent of the bit rate.
    average_percent: f64,
    /// The worst case in percent of the bit rate.
    worst_percent: f64,
}

/// The load of a part of the messages.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Share"))]
struct MessageLoad<T> {
    /// The name of the node, or the kind of the messages.
    of: T,
    /// Its load.
    #[serde(flatten)]
    load: LoadRow,
}

/// A bit rate.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Rate"))]
struct BitRateTimes {
    /// In kbit/s.
    bit_rate: u16,
    /// The average load in percent.
    average_percent: f64,
    /// The load in the worst case in percent.
    worst_percent: f64,
    /// Whether all messages meet their deadlines.
    fits: bool,
    /// The number of messages that miss their deadline.
    late: usize,
}

/// SYNC. Times are in microseconds.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Sync"))]
struct SyncRow {
    /// The communication cycle period (1006h).
    period_us: u64,
    /// The synchronous window length (1007h); 0: none.
    window_us: u64,
    /// From the start of SYNC to the end of the last synchronous PDO; `null` without a bound.
    needed_us: Option<u64>,
    /// Whether that is within the window, or else the period.
    fits: bool,
}

/// A message. Times are in microseconds.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Message"))]
struct MessageTimes<'a> {
    /// The CAN-ID.
    can_id: u32,
    /// Whether it has 29 bits.
    is_extended: bool,
    /// What it is for.
    kind: TrafficKind,
    /// The service: `TPDO 1`, `SYNC`.
    name: &'a str,
    /// The name of the node that sends it.
    sender: &'a str,
    /// The names of the nodes that receive it.
    receivers: Vec<&'a str>,
    /// The number of bytes.
    bytes: u64,
    /// The bits on the bus without stuff bits.
    min_bits: u64,
    /// The bits on the bus with the most stuff bits.
    max_bits: u64,
    /// The shortest time between two of them; `null` if there is none.
    period_us: Option<u64>,
    /// Whether it is sent once in each period.
    is_cyclic: bool,
    /// Whether it may be sent at any time: an event-driven PDO without inhibit time.
    is_unbounded: bool,
    /// How late it may be queued.
    jitter_us: u64,
    /// The longest time until it is received; `null` without a bound.
    response_us: Option<u64>,
    /// The CAN-ID of the message because of which there is no bound.
    unbounded_by: Option<u32>,
    /// Whether there is no bound because SDO transfers may leave no time to it.
    waits_for_sdo: bool,
    /// The longest time that it may take.
    deadline_us: Option<u64>,
    /// Why.
    deadline_kind: Option<DeadlineKind>,
    /// The deadline less the response; negative for a message that may be late.
    slack_us: Option<i64>,
}

/// What would help a message that is late.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Remedy"))]
struct RemedyRow {
    /// The CAN-ID of the message.
    can_id: u32,
    /// The least bit rate in kbit/s that is enough.
    bit_rate: Option<u16>,
    /// The CAN-ID below which its own would have to be.
    below: Option<u32>,
}

/// How long it takes to configure the nodes. Times are in microseconds.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Boot"))]
struct BootRow<'a> {
    /// How long the manager waits for mandatory nodes (1F89h); 0: for ever.
    limit_us: u64,
    /// The frames of all nodes, one after the other.
    frames_us: u64,
    /// The nodes that are booted.
    nodes: Vec<BootNode<'a>>,
}

/// A node that is booted. Times are in microseconds.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct BootNode<'a> {
    /// The node-ID.
    node_id: u8,
    /// The name.
    name: &'a str,
    /// Whether the network does not start without it.
    is_mandatory: bool,
    /// The number of downloads.
    downloads: usize,
    /// The time of their frames.
    frames_us: u64,
    /// The same with the time for the answers.
    total_us: u64,
    /// Whether that is longer than the manager waits.
    is_late: bool,
}

/// Nanoseconds as microseconds, up to the next one.
const fn up(time: u64) -> u64 {
    time.div_ceil(1000)
}

/// Thousandths.
fn decimal(thousandths: u64) -> f64 {
    thousandths as f64 / 1000.0
}

impl LoadRow {
    fn new(load: &Load, bit_rate: u16) -> Self {
        Self {
            average: decimal(load.average),
            worst: decimal(load.worst),
            average_percent: decimal(load.average_percent(bit_rate)),
            worst_percent: decimal(load.worst_percent(bit_rate)),
        }
    }
}

impl<'a> TimingJson<'a> {
    pub(crate) fn new(file: &'a str, timing: &'a Timing, options: &TimingOptions) -> Self {
        let rate = timing.bit_rate;
        let nodes = timing.nodes.iter();
        let kinds = timing.kinds.iter();
        Self {
            version: Version,
            file,
            name: timing.name.as_deref(),
            bit_rate: rate,
            assumptions: Assumptions {
                response_time_us: up(options.response_time),
                node_delay_us: up(options.node_delay),
                inhibit_time_us: options.event_distance.map(up),
                sdo: options.sdo,
                emergencies: options.emergencies,
            },
            is_met: timing.is_met(options),
            load: LoadRow::new(&timing.load, rate),
            nodes: nodes
                .map(|share| MessageLoad {
                    of: share.of.node.as_str(),
                    load: LoadRow::new(&share.load, rate),
                })
                .collect(),
            kinds: kinds
                .map(|share| MessageLoad { of: share.of, load: LoadRow::new(&share.load, rate) })
                .collect(),
            bit_rates: timing.rates.iter().map(BitRateTimes::new).collect(),
            fits_from: timing.fits_from(),
            sync: timing.sync.as_ref().map(SyncRow::new),
            inhibit_time_us: timing.inhibit_time.map(|tenths| u64::from(tenths) * 100),
            messages: timing.messages.iter().map(MessageTimes::new).collect(),
            remedies: timing.remedies.iter().map(|remedy| RemedyRow::new(timing, remedy)).collect(),
            boot: timing.boot.as_ref().map(BootRow::new),
        }
    }
}

impl BitRateTimes {
    fn new(row: &RateRow) -> Self {
        Self {
            bit_rate: row.bit_rate,
            average_percent: decimal(row.load.average_percent(row.bit_rate)),
            worst_percent: decimal(row.load.worst_percent(row.bit_rate)),
            fits: row.fits(),
            late: row.missed,
        }
    }
}

impl SyncRow {
    fn new(sync: &SyncTime) -> Self {
        Self {
            period_us: up(sync.period),
            window_us: up(sync.window),
            needed_us: sync.needed.map(up),
            fits: sync.fits() == Some(true),
        }
    }
}

impl<'a> MessageTimes<'a> {
    fn new(message: &'a TimedMessage) -> Self {
        let (response, deadline) = (message.response.map(up), message.deadline.map(|(time, _)| time / 1000));
        let mut receivers: Vec<&str> = message.receivers.iter().map(|end| end.node.as_str()).collect();
        receivers.dedup();
        Self {
            can_id: message.can_id.number,
            is_extended: message.can_id.is_extended,
            kind: message.kind,
            name: &message.name,
            sender: &message.sender.node,
            receivers,
            bytes: message.bytes,
            min_bits: message.bits[0],
            max_bits: message.bits[1],
            period_us: message.period.map(|period| period / 1000),
            is_cyclic: message.is_cyclic,
            is_unbounded: message.is_unbounded,
            jitter_us: up(message.jitter),
            response_us: response,
            unbounded_by: message.unbounded_by.map(|cause| cause.number),
            waits_for_sdo: message.waits_for_sdo,
            deadline_us: deadline,
            deadline_kind: message.deadline.map(|(_, kind)| kind),
            slack_us: deadline
                .zip(response)
                .map(|(deadline, response)| deadline.cast_signed() - response.cast_signed()),
        }
    }
}

impl RemedyRow {
    fn new(timing: &Timing, remedy: &Remedy) -> Self {
        Self {
            can_id: timing.messages[remedy.message].can_id.number,
            bit_rate: remedy.bit_rate,
            below: remedy.before.map(|before| before.number),
        }
    }
}

impl<'a> BootRow<'a> {
    fn new(boot: &'a BootTimes) -> Self {
        let node = |node: &'a NodeBootTime| BootNode {
            node_id: node.node_id,
            name: &node.name,
            is_mandatory: node.is_mandatory,
            downloads: node.downloads,
            frames_us: up(node.bus),
            total_us: up(node.total),
            is_late: boot.is_late(node),
        };
        Self {
            limit_us: up(boot.limit),
            frames_us: up(boot.bus()),
            nodes: boot.nodes.iter().map(node).collect(),
        }
    }
}
