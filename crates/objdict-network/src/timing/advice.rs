//! Remedies for messages that are late.

use super::{AnyTime, BIT_RATES, Remedy, Schedule, TimedMessage};
use crate::timing::analysis::ResponseTime;
use crate::timing::frames::{Rhythm, TimedFrame};

/// The maximum number of messages with a remedy.
const MOST: usize = 3;

impl Schedule {
    /// The minimum inhibit time, in multiples of 100 µs, for PDOs without one, with which all messages meet
    /// their deadlines.
    pub(super) fn bounding_inhibit_time(&self, bit_rate: u16) -> Option<u16> {
        if self.frames.iter().all(|frame| frame.rhythm != Rhythm::Unbounded) {
            return None;
        }
        let is_enough = |tenths: u16| {
            let distance = u64::from(tenths) * 100_000;
            let streams = self.streams(bit_rate, AnyTime::Inhibited(distance));
            let responses = streams.responses();
            let is_open = |(frame, response): (&TimedFrame, &ResponseTime)| {
                frame.deadline.is_some() && matches!(response, ResponseTime::Unbounded(_))
            };
            !self.frames.iter().zip(&responses).any(is_open)
                && self.missed(&responses, Some(distance)).is_empty()
                && !self.is_over_window(&streams, &responses)
        };
        // a longer time never delays a message more
        let (mut least, mut most) = (1, u16::MAX);
        if !is_enough(most) {
            return None;
        }
        while least < most {
            let middle = least + (most - least) / 2;
            if is_enough(middle) { most = middle } else { least = middle + 1 }
        }
        Some(most)
    }

    /// Remedies for the first messages that miss their deadlines.
    pub(super) fn remedies(&self, bit_rate: u16, messages: &[TimedMessage]) -> Vec<Remedy> {
        let missed: Vec<usize> =
            (0..messages.len()).filter(|at| messages[*at].is_missed()).take(MOST).collect();
        let faster = BIT_RATES.into_iter().filter(|rate| *rate > bit_rate && !missed.is_empty());
        let faster: Vec<(u16, Vec<usize>)> = faster
            .map(|rate| (rate, self.missed(&self.streams(rate, AnyTime::Counts).responses(), None)))
            .collect();
        let remedy = |message: usize| Remedy {
            message,
            bit_rate: faster.iter().find(|(_, missed)| !missed.contains(&message)).map(|(rate, _)| *rate),
            before: self.sufficient_priority(bit_rate, message).map(|at| messages[at].can_id),
        };
        missed.iter().map(|message| remedy(*message)).collect()
    }

    /// The position of the last message before which the given one would meet its deadline, without causing
    /// additional misses.
    fn sufficient_priority(&self, bit_rate: u16, message: usize) -> Option<usize> {
        let missed = |place: usize| {
            let mut frames = self.frames.clone();
            frames[place..=message].rotate_right(1);
            let moved = Self { frames, ..*self };
            let responses = moved.streams(bit_rate, AnyTime::Counts).responses();
            let missed = moved.missed(&responses, None);
            (missed.contains(&place), missed.len())
        };
        let is_movable = |place: &usize| self.frames[*place].kind == self.frames[message].kind;
        let places: Vec<usize> = (0..message).filter(is_movable).collect();
        // the higher the priority, the shorter the response
        let enough = places.partition_point(|place| !missed(*place).0);
        let place = *places.get(enough.checked_sub(1)?)?;
        (missed(place).1 < missed(message).1).then_some(place)
    }
}
