//! No response on a simulated bus takes longer than the analysis predicts, and the worst case reaches it.

use super::super::analysis::{Arrival, Background, ResponseTime, Stream, Streams};
use super::super::simulation::{Queued, Sent, send};
use crate::traffic::frame_bits;

/// Random numbers that are the same in every run (xorshift64*).
struct Random(u64);

impl Random {
    fn seeded(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 16
    }

    /// A number from `least` up to `most`.
    fn between(&mut self, least: u64, most: u64) -> u64 {
        least + self.next() % (most - least + 1)
    }

    fn one_in(&mut self, count: u64) -> bool {
        self.next().is_multiple_of(count)
    }
}

/// A bus with the longest and the shortest frame of each stream.
struct Bus {
    streams: Streams,
    shortest: Vec<u64>,
}

const BIT: u64 = 8000;

impl Bus {
    /// Messages of any length, with a load from a few percent to nearly full.
    fn random(random: &mut Random) -> Self {
        let count = random.between(3, 12);
        let load = random.between(50, 980);
        let mut shortest = Vec::new();
        let mut stream = || {
            let is_extended = random.one_in(6);
            let bytes = random.between(0, 8);
            let cost = frame_bits(bytes, is_extended) * BIT;
            shortest.push(cost - random.between(0, cost / 5));
            let share = random.between(500, 1500) * load / 1000;
            // all shares together are near the load
            let period = cost * count * 1000 / share.max(1);
            let jitter = if random.one_in(3) { random.between(0, period) } else { 0 };
            Stream {
                cost,
                arrival: Arrival::Every(period.max(cost)),
                jitter,
                after: None,
                is_background: false,
            }
        };
        let streams = (0..count).map(|_| stream()).collect();
        Self { streams: Streams { streams, background: None, bit_time: BIT }, shortest }
    }

    /// SDO transfers that lie between the messages.
    fn with_background(mut self, random: &mut Random) -> Self {
        let cost = frame_bits(8, false) * BIT;
        let first = random.between(0, self.streams.streams.len() as u64) as usize;
        self.streams.background =
            Some(Background { cost, response_time: random.between(1, 40) * 100_000, first, end: first });
        self
    }

    fn period(&self, stream: usize) -> u64 {
        match self.streams.streams[stream].arrival {
            Arrival::Every(period) => period,
            Arrival::Unbounded | Arrival::Rare => u64::MAX,
        }
    }
}

/// Each message at its time, if requested in this order: first the higher priorities, with the SDO frames
/// where the bus sends them.
fn simulate(bus: &Bus, random: &mut Random, until: u64) -> Vec<Sent> {
    let streams = &bus.streams.streams;
    let is_at_once = random.one_in(4);
    let mut phase = |stream| if is_at_once { BIT } else { random.between(0, bus.period(stream)) };
    let phases: Vec<u64> = (0..streams.len()).map(&mut phase).collect();
    let sdo = bus.streams.background.map(|background| background.first);
    let next = |place: usize, number: u64, sent: u64| {
        if Some(place) == sdo {
            let background = bus.streams.background?;
            // requests follow responses immediately, and responses are delayed
            let at = if number.is_multiple_of(2) { sent + background.response_time } else { sent };
            return Some(Queued { at, duration: background.cost });
        }
        let stream = if sdo.is_some_and(|sdo| place > sdo) { place - 1 } else { place };
        let Stream { cost, jitter, .. } = streams[stream];
        let late = if random.one_in(2) { 0 } else { random.between(0, jitter) };
        let release = phases[stream] + number * bus.period(stream);
        let duration = if random.one_in(2) { cost } else { random.between(bus.shortest[stream], cost) };
        Some(Queued { at: release + late, duration })
    };
    let mut sent = send(streams.len() + usize::from(sdo.is_some()), until, 100, next);
    sent.retain(|sent| Some(sent.stream) != sdo);
    for sent in &mut sent {
        sent.stream -= usize::from(sdo.is_some_and(|sdo| sent.stream > sdo));
        // responses are measured from the time without jitter
        sent.queued = phases[sent.stream] + sent.number * bus.period(sent.stream);
    }
    sent
}

/// Checks the responses of some runs; returns the number of compared ones.
fn compare(bus: &Bus, random: &mut Random, seed: u64) -> usize {
    let bounds = bus.streams.responses();
    let mut compared = 0;
    for _ in 0..2 {
        for sent in simulate(bus, random, 3_000_000_000) {
            let ResponseTime::Within(bound) = bounds[sent.stream] else { continue };
            compared += 1;
            let response = sent.end - sent.queued;
            assert!(
                response <= bound,
                "network {seed}: {response} ns of {sent:?}, but {bound} ns: {:?}",
                bus.streams
            );
        }
    }
    compared
}

#[test]
fn no_response_on_a_bus_is_longer_than_the_analysis_says() {
    let mut compared = 0;
    for seed in 1..=10_000 {
        let mut random = Random::seeded(seed);
        compared += compare(&Bus::random(&mut random), &mut random, seed);
    }
    assert!(compared > 1_000_000, "{compared}");
}

#[test]
fn sdo_transfers_delay_no_message_longer_than_the_analysis_says() {
    let mut compared = 0;
    for seed in 1..=2000 {
        let mut random = Random::seeded(seed);
        let bus = Bus::random(&mut random).with_background(&mut random);
        compared += compare(&bus, &mut random, seed);
    }
    assert!(compared > 150_000, "{compared}");
}

/// The longest response of a stream if all messages of higher priority arrive simultaneously, with maximum jitter, and
/// the longest one of lower priority has just started.
fn critical(streams: &Streams, stream: usize) -> u64 {
    let all = &streams.streams;
    let blocker = all[stream + 1..].iter().map(|below| below.cost).max();
    // the lower frame starts one bit before the others arrive
    let start = streams.bit_time;
    let next = |place: usize, number: u64, _: u64| {
        if place > stream {
            return blocker.filter(|_| number == 0).map(|duration| Queued { at: 0, duration });
        }
        let Stream { cost, arrival, jitter, .. } = all[place];
        let Arrival::Every(period) = arrival else { return None };
        Some(Queued { at: start + (number * period).saturating_sub(jitter), duration: cost })
    };
    let sent = send(stream + 2, 20_000_000_000, 4000, next);
    let period = match all[stream].arrival {
        Arrival::Every(period) => period,
        Arrival::Unbounded | Arrival::Rare => u64::MAX,
    };
    let jitter = all[stream].jitter;
    let mut free = start;
    let mut longest = 0;
    for sent in &sent {
        // only until the bus is free for the first time
        if sent.start > free {
            break;
        }
        free = sent.end;
        if sent.stream == stream {
            longest = longest.max(sent.end + jitter - start - sent.number * period);
        }
    }
    longest
}

#[test]
fn the_critical_instant_shows_the_response_within_a_few_bits() {
    let mut exact = 0;
    let mut looked = 0;
    for seed in 1..=1000 {
        let mut random = Random::seeded(seed);
        let bus = Bus::random(&mut random);
        for (stream, bound) in bus.streams.responses().into_iter().enumerate() {
            let ResponseTime::Within(bound) = bound else { continue };
            let seen = critical(&bus.streams, stream);
            assert!(seen <= bound, "network {seed}, stream {stream}: {seen} ns, but {bound} ns");
            looked += 1;
            exact += usize::from(bound - seen <= 2 * BIT);
        }
    }
    // a higher-priority message within the last bit is included in the analysis
    assert!(exact * 100 >= looked * 98, "{exact} of {looked}");
}
