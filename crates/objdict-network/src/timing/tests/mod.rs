//! The published example, the network of the book, and the arbitration order.

mod observed;

use super::analysis::{Arrival, ResponseTime, Stream, Streams, WaitCause};
use super::frames::{MICROSECOND, MILLISECOND, Rhythm, TimedFrame};
use super::{AnyTime, Load, Schedule, TimingOptions, TrafficKind};
use crate::messages::{MessageId, Party, Service};
use crate::source::Span;

/// Streams without jitter, by cost and period in microseconds.
fn streams(bit_time: u64, messages: &[(u64, u64)]) -> Streams {
    let stream = |(cost, period): &(u64, u64)| Stream {
        cost: cost * MICROSECOND,
        arrival: Arrival::Every(period * MICROSECOND),
        jitter: 0,
        after: None,
        is_background: false,
    };
    Streams { streams: messages.iter().map(stream).collect(), background: None, bit_time }
}

fn within(microseconds: u64) -> ResponseTime {
    ResponseTime::Within(microseconds * MICROSECOND)
}

#[test]
fn the_second_instance_may_be_the_slowest() {
    // the example of the paper, for which single-instance analyses find 3 ms
    let example = streams(8000, &[(1000, 2500), (1000, 3500), (1000, 3500)]);
    assert_eq!(example.responses(), [within(2000), within(3000), within(3500)]);
}

#[test]
fn a_full_bus_has_no_bound() {
    let full = streams(1000, &[(100, 1000), (500, 1000), (400, 1000), (1, 1_000_000)]);
    let responses = full.responses();
    assert_eq!(responses[0], within(600), "the longest frame below, and its own");
    assert_eq!(responses[3], ResponseTime::Unbounded(WaitCause::Load));
    let mut any = streams(1000, &[(100, 1000), (100, 1000), (100, 1000)]);
    any.streams[1].arrival = Arrival::Unbounded;
    assert_eq!(
        any.responses(),
        [
            within(200),
            ResponseTime::Unbounded(WaitCause::Message(1)),
            ResponseTime::Unbounded(WaitCause::Message(1))
        ]
    );
    any.streams[1].arrival = Arrival::Rare;
    assert_eq!(any.responses(), [within(200), within(300), within(200)]);
}

fn frame(id: u32, kind: TrafficKind, bytes: u64, period: u64) -> TimedFrame {
    let service = match kind {
        TrafficKind::Sync => Service::Sync,
        TrafficKind::Sdo => Service::SdoRequest,
        TrafficKind::Heartbeat => Service::ErrorControl,
        _ => Service::pdo(crate::model::PdoKind::Tpdo, 1),
    };
    let sender = Party { node: 0, service, at: Span::empty(0) };
    let rhythm = if period == 0 { Rhythm::Rare } else { Rhythm::Cyclic(period * MILLISECOND) };
    TimedFrame::new(MessageId { is_extended: id > 0x7FF, number: id }, kind, bytes, rhythm, sender)
}

/// The network of chapter 4 with the outputs of the controller once in 66 ms.
fn book(jitter_of_outputs: bool) -> Vec<TimedFrame> {
    use TrafficKind::{EventPdo, Heartbeat, Sync, SynchronousPdo};
    let outputs = if jitter_of_outputs { SynchronousPdo } else { EventPdo };
    vec![
        frame(0x080, Sync, 0, 33),
        frame(0x18B, SynchronousPdo, 5, 33),
        frame(0x20B, outputs, 1, 66),
        frame(0x28B, SynchronousPdo, 4, 165),
        frame(0x30B, outputs, 4, 66),
        frame(0x381, outputs, 1, 66),
        frame(0x401, SynchronousPdo, 5, 33),
        frame(0x481, outputs, 4, 66),
        frame(0x501, SynchronousPdo, 4, 132),
        frame(0x70B, Heartbeat, 1, 300),
        frame(0x70C, Heartbeat, 1, 300),
    ]
}

fn schedule(frames: Vec<TimedFrame>, sdo: bool) -> Schedule {
    Schedule {
        frames,
        window: 0,
        options: TimingOptions { sdo, response_time: 0, ..TimingOptions::default() },
    }
}

/// Responses in units of 10 µs, at 125 kbit/s.
fn responses(schedule: &Schedule) -> Vec<u64> {
    let found = schedule.streams(125, AnyTime::Counts).responses();
    let number = |response: &ResponseTime| match response {
        ResponseTime::Within(time) => time / 10_000,
        ResponseTime::Unbounded(_) => 0,
    };
    found.iter().map(number).collect()
}

#[test]
fn the_network_of_the_book_has_these_responses() {
    let mut without_jitter = schedule(book(false), false).streams(125, AnyTime::Counts);
    without_jitter.streams.iter_mut().for_each(|stream| stream.after = None);
    let expected = [128, 212, 264, 340, 416, 468, 544, 620, 672, 724, 724];
    assert_eq!(without_jitter.responses(), expected.map(|time| within(time * 10)));
    let expected = [128, 340, 392, 468, 544, 596, 672, 748, 800, 724, 724];
    assert_eq!(responses(&schedule(book(true), false)), expected);

    let mut frames = book(false);
    frames.insert(9, frame(0x60B, TrafficKind::Sdo, 8, 0));
    let mut with_sdo = schedule(frames, true).streams(125, AnyTime::Counts);
    with_sdo.streams.iter_mut().for_each(|stream| stream.after = None);
    let expected = [152, 236, 288, 364, 440, 492, 576, 652, 728];
    assert_eq!(with_sdo.responses()[..9], expected.map(|time| within(time * 10)));
    // nodes that respond immediately leave no time between two SDO frames
    assert_eq!(with_sdo.responses()[10..], [ResponseTime::Unbounded(WaitCause::Background); 2]);
    with_sdo.background.as_mut().unwrap().response_time = MILLISECOND;
    assert!(matches!(with_sdo.responses()[11], ResponseTime::Within(time) if time > 724 * 10_000));
}

#[test]
fn the_synchronous_window_begins_with_sync() {
    let needed = |schedule: &Schedule| {
        let streams = schedule.streams(125, AnyTime::Counts);
        schedule.sync_time(&streams, &streams.responses()).unwrap().needed
    };
    assert_eq!(needed(&schedule(book(false), false)), Some(6720 * MICROSECOND));
    let mut frames = book(false);
    frames.insert(9, frame(0x60B, TrafficKind::Sdo, 8, 0));
    assert_eq!(needed(&schedule(frames, true)), Some(7280 * MICROSECOND));
}

#[test]
fn loads_are_those_of_the_sheet() {
    let is_output = |frame: &TimedFrame| frame.kind == TrafficKind::EventPdo;
    let figure: Vec<TimedFrame> = book(false).into_iter().filter(|frame| !is_output(frame)).collect();
    let load = Load::of(&figure);
    assert_eq!([load.average, load.worst].map(|load| (load + 50) / 100), [81_409, 97_591]);
    assert_eq!([load.average_percent(125), load.worst_percent(125)], [6513, 7807]);
    let all = Load::of(&book(false));
    assert_eq!([all.average_percent(125), all.worst_percent(125)], [9761, 11_686]);
}

/// The bits before the data: 11 bits, then remote or not and one bit that states whether 18 bits follow.
fn arbitration(frame: &TimedFrame) -> Vec<bool> {
    let bits = |number: u32, count: u32| (0..count).rev().map(move |bit| number >> bit & 1 == 1);
    let id = frame.id.number;
    match frame.id.is_extended {
        false => bits(id, 11).chain([frame.is_remote, false]).collect(),
        true => bits(id >> 18, 11)
            .chain([true, true])
            .chain(bits(id & 0x3_FFFF, 18))
            .chain([frame.is_remote])
            .collect(),
    }
}

#[test]
fn the_priority_is_the_order_of_arbitration() {
    let mut frames = Vec::new();
    for id in [
        0x000,
        0x080,
        0x18B,
        0x18C,
        0x7FF,
        0x800,
        0x18B << 18,
        (0x18B << 18) + 5,
        (0x18A << 18) + 7,
        0x1FFF_FFFF,
    ] {
        for is_remote in [false, true] {
            frames.push(TimedFrame { is_remote, ..frame(id, TrafficKind::EventPdo, 1, 10) });
        }
    }
    for one in &frames {
        for other in &frames {
            // bit by bit, a 0 wins
            assert_eq!(one.priority().cmp(&other.priority()), arbitration(one).cmp(&arbitration(other)));
        }
    }
}

#[test]
fn two_thousand_messages_meet_their_deadlines() {
    let mut frames = vec![frame(0x080, TrafficKind::Sync, 0, 500)];
    let kinds = [TrafficKind::SynchronousPdo, TrafficKind::EventPdo, TrafficKind::Heartbeat];
    for (number, kind) in (0..2000).zip(kinds.into_iter().cycle()) {
        let period = 1000 + number % 40 * 100;
        frames.push(frame(0x0800_0000 + number as u32, kind, number % 9, period));
    }
    let schedule = schedule(frames, false);
    let fitting =
        super::BIT_RATES.map(|rate| schedule.at_rate(rate)).into_iter().filter(super::RateRow::fits);
    assert_eq!(fitting.map(|row| row.bit_rate).collect::<Vec<_>>(), [500, 800, 1000]);
}

#[test]
fn a_higher_priority_or_a_faster_bus_helps() {
    let mut frames = book(false);
    frames[8].deadline = Some((5 * MILLISECOND, super::DeadlineKind::Receiver));
    let schedule = schedule(frames, false);
    let responses = schedule.streams(125, AnyTime::Counts).responses();
    assert_eq!(schedule.missed(&responses, None), [8]);
}
