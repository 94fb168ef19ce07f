//! Distances between the frames of a CAN-ID.

use crate::log::LogTime;

/// The distances between frames in nanoseconds.
#[derive(Clone, Debug, Default)]
pub(super) struct Cycle {
    pub(super) frames: u64,
    /// The time of the last frame of the cycle.
    pub(super) last: Option<i64>,
    distances: u64,
    sum: i64,
    pub(super) shortest: i64,
    pub(super) longest: i64,
}

impl Cycle {
    /// Adds a frame; one that is not a part of the cycle is only counted.
    pub(super) fn add(&mut self, time: LogTime, is_cyclic: bool) {
        self.frames += 1;
        if !is_cyclic {
            self.last = None;
            return;
        }
        let now = time.nanoseconds();
        let Some(last) = self.last.replace(now) else { return };
        let distance = now.saturating_sub(last);
        if self.distances == 0 {
            (self.shortest, self.longest) = (distance, distance);
        } else {
            (self.shortest, self.longest) = (self.shortest.min(distance), self.longest.max(distance));
        }
        self.distances += 1;
        self.sum = self.sum.saturating_add(distance);
    }

    /// The mean distance, if there are so many that hardly differ.
    pub(super) fn regular(&self, count: u64) -> Option<i64> {
        let is_regular = self.distances >= count && self.longest / 2 <= self.shortest / 4 * 3;
        self.mean().filter(|_| is_regular)
    }

    /// The mean distance; `None` without two frames.
    pub(super) fn mean(&self) -> Option<i64> {
        self.sum.checked_div(i64::try_from(self.distances).ok()?)
    }
}
