//! Timing diagrams of a network: the transmissions of each node when all messages arrive simultaneously, and
//! its share of the bus.

use askama::Template;

use super::simulation::{Queued, send};
use super::{TimedMessage, Timing, TrafficKind};
use crate::diagnostic::one_line;
use crate::graph::cut;
use crate::messages::MessageId;

/// The longest time that is drawn.
const LONGEST: u64 = 1_000_000_000;
/// The maximum number of drawn messages, except those of the first moment.
const MOST: usize = 90;

/// Left edge of the lanes; the names of the nodes are to the left.
const LEFT: usize = 150;
/// The length of the lanes.
const LENGTH: u64 = 1000;
const TOP: usize = 30;
const LANE: usize = 26;
const BAR: usize = 16;
/// The maximum number of characters of a name.
const NAME: usize = 18;

#[derive(Template)]
#[template(path = "timeline.svg")]
struct TimelineDiagram {
    label: String,
    height: usize,
    width: usize,
    end: usize,
    ticks: Vec<(u64, String)>,
    lanes: Vec<Lane>,
    load_title: &'static str,
    loads: Vec<LoadBar>,
}

struct Lane {
    y: usize,
    name: String,
    bars: Vec<Bar>,
}

/// A message on the bus, with its waiting time.
struct Bar {
    class: &'static str,
    title: String,
    wait: String,
    x: String,
    width: String,
}

struct LoadBar {
    y: usize,
    name: String,
    average: String,
    worst: String,
    words: String,
}

/// The network as SVG, without scripts and external references. `spelled` formats CAN-IDs as in the document
/// that contains the diagram.
pub fn svg(timing: &Timing, spelled: impl Fn(MessageId) -> String) -> String {
    let (sent, span) = sent(timing);
    let lane = |number: usize| TOP + LANE * number;
    let lanes: Vec<Lane> = timing
        .nodes
        .iter()
        .enumerate()
        .map(|(number, share)| {
            let own = sent.iter().filter(|sent| sent.message.sender.position == share.of.position);
            let bars = own.map(|sent| Bar::new(sent, span, lane(number), &spelled)).collect();
            Lane { y: lane(number), name: cut(&share.of.node, NAME), bars }
        })
        .collect();
    let end = lane(lanes.len());
    let bar = |(number, share): (usize, &super::LoadShare<crate::overview::End>)| {
        let percent =
            [share.load.average_percent(timing.bit_rate), share.load.worst_percent(timing.bit_rate)];
        LoadBar {
            y: end + 50 + LANE * number,
            name: cut(&share.of.node, NAME),
            average: pixels(percent[0].min(100_000), 100_000),
            worst: pixels(percent[1].min(100_000), 100_000),
            words: percent.map(of_percent).join(" – "),
        }
    };
    let loads: Vec<LoadBar> = timing.nodes.iter().enumerate().map(bar).collect();
    let picture = TimelineDiagram {
        label: format!(
            "{}: {} ms, {} kbit/s",
            one_line(timing.name.as_deref().unwrap_or("CANopen")),
            span / 1_000_000,
            timing.bit_rate
        ),
        height: end + 60 + LANE * loads.len(),
        width: LEFT + LENGTH as usize + 130,
        end,
        ticks: ticks(span),
        lanes,
        load_title: timing.language.pick("Load of the bus", "Buslast"),
        loads,
    };
    // writing to a string cannot fail
    picture.render().unwrap_or_default()
}

/// A message on the bus.
struct Shown<'t> {
    message: &'t TimedMessage,
    queued: u64,
    start: u64,
    end: u64,
}

/// The messages sent after all arrive simultaneously, each with maximum length, and the drawn time span.
fn sent(timing: &Timing) -> (Vec<Shown<'_>>, u64) {
    let is_drawn = |message: &&TimedMessage| message.period.is_some() || message.is_unbounded;
    let messages: Vec<&TimedMessage> =
        timing.messages.iter().filter(is_drawn).filter(|message| message.kind != TrafficKind::Emcy).collect();
    let duration = |message: &TimedMessage| message.bits[1] * 1_000_000 / u64::from(timing.bit_rate.max(1));
    let sync =
        messages.iter().find(|message| message.kind == TrafficKind::Sync).map_or(0, |sync| duration(sync));
    let next = |stream: usize, number: u64, _: u64| {
        let message = messages[stream];
        let after = if message.kind == TrafficKind::SynchronousPdo { sync } else { 0 };
        // aperiodic messages are drawn once
        let at = if number == 0 { Some(0) } else { message.period.map(|period| period * number) };
        Some(Queued { at: at? + after, duration: duration(message) })
    };
    let sent = send(messages.len(), LONGEST, MOST.max(messages.len() + 20), next);
    let span = sent.last().map_or(1_000_000, |sent| sent.end).min(LONGEST);
    let shown = sent.iter().filter(|sent| sent.end <= span);
    let shown = shown.map(|sent| Shown {
        message: messages[sent.stream],
        queued: sent.queued,
        start: sent.start,
        end: sent.end,
    });
    (shown.collect(), span)
}

impl Bar {
    fn new(sent: &Shown<'_>, span: u64, lane: usize, spelled: impl Fn(MessageId) -> String) -> Self {
        let Shown { message, queued, start, end } = sent;
        let (from, to, middle) = (pixels(*queued, span), pixels(*start, span), lane + BAR / 2);
        Self {
            class: match message.kind {
                TrafficKind::Sync => "sync",
                TrafficKind::SynchronousPdo | TrafficKind::EventPdo => "pdo",
                _ => "other",
            },
            title: format!(
                "{} {}: {} – {} ms",
                spelled(message.can_id),
                one_line(&message.name),
                of_time(*start),
                of_time(*end)
            ),
            wait: if queued < start { format!("M{from} {middle}H{to}") } else { String::new() },
            x: to,
            width: thousandths((end - start) * LENGTH * 1000 / span.max(1)),
        }
    }
}

/// The position of a part of a whole in the lanes.
fn pixels(part: u64, whole: u64) -> String {
    thousandths((LEFT as u64 * 1000) + part * LENGTH * 1000 / whole.max(1))
}

fn thousandths(number: u64) -> String {
    let (whole, rest) = (number / 1000, number % 1000 / 10);
    if rest == 0 { whole.to_string() } else { format!("{whole}.{rest:02}") }
}

/// Nanoseconds as milliseconds.
fn of_time(time: u64) -> String {
    format!("{}.{:02}", time / 1_000_000, time % 1_000_000 / 10_000)
}

/// Thousandths of a percent as percent.
fn of_percent(percent: u64) -> String {
    format!("{}.{} %", percent / 1000, percent % 1000 / 100)
}

/// Readable tick positions, with labels.
fn ticks(span: u64) -> Vec<(u64, String)> {
    let steps = [1, 2, 5, 10, 20, 50, 100, 200].map(|milliseconds| milliseconds * 1_000_000);
    let step = steps.into_iter().find(|step| span / step <= 12).unwrap_or(200_000_000);
    let times = (0..=span / step).map(|number| number * step);
    times
        .map(|time| (LEFT as u64 + time * LENGTH / span.max(1), format!("{} ms", time / 1_000_000)))
        .collect()
}
