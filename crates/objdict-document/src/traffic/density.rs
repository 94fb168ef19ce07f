//! How many frames there were when, in bounded memory.

use crate::describe::frames::FrameKind;

/// The kinds of frames, and error frames behind them.
pub const DENSITY_KINDS: usize = FrameKind::ALL.len() + 1;

/// The most lanes.
const MAX_LANES: usize = 256;

/// The time of a bin at first, in nanoseconds.
const FIRST_WIDTH: i128 = 1000;

/// The number of frames of each kind in lanes, over a time that grows: when it is over, bins become twice as long.
#[derive(Clone, Debug)]
pub struct Density {
    capacity: usize,
    /// When the first bin begins, in nanoseconds.
    origin: i128,
    /// The time of a bin.
    width: i128,
    /// The first and the last time.
    span: Option<(i64, i64)>,
    lanes: Vec<Vec<[u32; DENSITY_KINDS]>>,
    left_out: u64,
}

impl Density {
    /// Lanes without a frame, of at most `capacity` bins each; there are at least two.
    pub fn new(capacity: usize) -> Self {
        let capacity = capacity.max(2).next_multiple_of(2);
        Self { capacity, origin: 0, width: FIRST_WIDTH, span: None, lanes: Vec::new(), left_out: 0 }
    }

    /// Adds a frame of a kind at a time in nanoseconds; an error frame has no kind. Frames of lanes for which there is no room are
    /// [counted](Self::left_out).
    pub fn add(&mut self, lane: usize, kind: Option<FrameKind>, time: i64) {
        let (first, last) = *self.span.get_or_insert_with(|| {
            self.origin = time.into();
            (time, time)
        });
        self.span = Some((first.min(time), last.max(time)));
        if lane >= MAX_LANES {
            self.left_out += 1;
            return;
        }
        let bin = self.bin(time);
        if self.lanes.len() <= lane {
            self.lanes.resize(lane + 1, Vec::new());
        }
        let bins = &mut self.lanes[lane];
        if bins.len() <= bin {
            bins.resize(bin + 1, [0; DENSITY_KINDS]);
        }
        let count = &mut bins[bin][kind.map_or(DENSITY_KINDS - 1, |kind| kind as usize)];
        *count = count.saturating_add(1);
    }

    /// The bin of a time, for which room is made.
    fn bin(&mut self, time: i64) -> usize {
        loop {
            let offset = i128::from(time) - self.origin;
            let length = self.width * self.capacity as i128;
            if (0..length).contains(&offset) {
                return (offset / self.width) as usize;
            }
            let shift = if offset < 0 { self.capacity } else { 0 };
            self.origin -= self.width * shift as i128;
            self.width *= 2;
            self.lanes.iter_mut().for_each(|bins| *bins = merged(bins, shift));
        }
    }

    /// The first and the last time in nanoseconds; `None` without a frame.
    pub const fn span(&self) -> Option<(i64, i64)> {
        self.span
    }

    /// The bins of a lane that have frames: when they begin and end in nanoseconds, and the number of each kind.
    pub fn bins(&self, lane: usize) -> impl Iterator<Item = ([i128; 2], &[u32; DENSITY_KINDS])> {
        let bins = self.lanes.get(lane).into_iter().flatten().enumerate();
        bins.filter(|(_, counts)| counts.iter().any(|count| *count > 0)).map(|(at, counts)| {
            let from = self.origin + self.width * at as i128;
            ([from, from + self.width], counts)
        })
    }

    /// The most frames of a bin.
    pub fn highest(&self) -> u64 {
        self.lanes.iter().flatten().map(total).max().unwrap_or_default()
    }

    /// How many frames are in no lane.
    pub const fn left_out(&self) -> u64 {
        self.left_out
    }
}

/// The number of frames of a bin.
pub(super) fn total(counts: &[u32; DENSITY_KINDS]) -> u64 {
    counts.iter().copied().map(u64::from).sum()
}

/// Two bins each as one, behind `shift` empty ones.
fn merged(bins: &[[u32; DENSITY_KINDS]], shift: usize) -> Vec<[u32; DENSITY_KINDS]> {
    let mut all = vec![[0_u32; DENSITY_KINDS]; (bins.len() + shift).div_ceil(2)];
    for (at, counts) in bins.iter().enumerate() {
        for (sum, count) in all[(at + shift) / 2].iter_mut().zip(counts) {
            *sum = sum.saturating_add(*count);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn lanes_are_bounded() {
        let mut density = Density::new(10);
        (0..MAX_LANES + 3).for_each(|lane| density.add(lane, None, 0));
        assert_eq!((density.lanes.len(), density.left_out()), (MAX_LANES, 3));
    }

    #[test]
    fn the_whole_of_time_has_room() {
        let mut density = Density::new(100);
        [0, i64::MAX, i64::MIN].into_iter().for_each(|time| density.add(0, Some(FrameKind::Pdo), time));
        assert_eq!((density.span(), density.bins(0).count()), (Some((i64::MIN, i64::MAX)), 3));
    }

    proptest! {
        /// No frame is lost, and each is in the bin of its time.
        #[test]
        fn bins_have_all_frames(times in prop::collection::vec(-1_000_000_000_i64..1_000_000_000, 0..300), capacity in 0..50_usize) {
            let mut density = Density::new(capacity);
            times.iter().for_each(|&time| density.add(0, Some(FrameKind::Sdo), time));
            prop_assert!(density.lanes.iter().all(|bins| bins.len() <= capacity.max(2) + 1));
            let mut found = 0;
            for ([from, to], counts) in density.bins(0) {
                let own = times.iter().filter(|&&time| (from..to).contains(&time.into())).count() as u64;
                prop_assert_eq!((total(counts), u64::from(counts[FrameKind::Sdo as usize])), (own, own));
                found += own;
            }
            prop_assert_eq!(found, times.len() as u64);
        }
    }
}
