//! Time series in bounded memory: of a number, of a state, and of frame counts.

use crate::describe::frames::FrameKind;

/// The time series of a number: a fixed number of buckets, each with the extremes of consecutive values. When all are
/// full, adjacent ones are merged, so no extreme is lost regardless of the number of values.
#[derive(Clone, Debug)]
pub struct Curve {
    buckets: Vec<CurveBucket>,
    capacity: usize,
    /// The maximum number of values in a bucket.
    room: u64,
    count: u64,
    sum: f64,
    is_digital: bool,
}

/// Consecutive values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveBucket {
    /// The earliest time in nanoseconds.
    pub from: i64,
    /// The latest time in nanoseconds.
    pub to: i64,
    /// The lowest value.
    pub min: f64,
    /// The highest value.
    pub max: f64,
    /// The most recent value.
    pub last: f64,
    /// The number of values.
    pub count: u64,
}

impl Curve {
    /// An empty series of at most `capacity` buckets, but at least two.
    pub fn new(capacity: usize) -> Self {
        // neighbours become one, so their number is even
        let capacity = capacity.max(2).next_multiple_of(2);
        Self { buckets: Vec::new(), capacity, room: 1, count: 0, sum: 0.0, is_digital: true }
    }

    /// Adds a value at a time in nanoseconds. NaN is ignored.
    pub fn add(&mut self, time: i64, value: f64) {
        if !value.is_finite() {
            return;
        }
        self.count += 1;
        self.sum += value;
        self.is_digital &= is_byte(value);
        let own = CurveBucket { from: time, to: time, min: value, max: value, last: value, count: 1 };
        match self.buckets.last_mut() {
            Some(bucket) if bucket.count < self.room => *bucket = bucket.with(&own),
            _ => {
                if self.buckets.len() == self.capacity {
                    self.buckets = self.buckets.chunks(2).map(CurveBucket::of_neighbours).collect();
                    self.room *= 2;
                }
                self.buckets.push(own);
            }
        }
    }

    /// Begins with one value that occurred this many times between two times.
    pub fn begin(&mut self, [from, to]: [i64; 2], value: f64, count: u64) {
        if value.is_finite() && self.buckets.is_empty() && count > 0 {
            self.count = count;
            self.sum = value * count as f64;
            self.is_digital &= is_byte(value);
            self.buckets.push(CurveBucket { from, to, min: value, max: value, last: value, count });
        }
    }

    /// The buckets in the order of their values.
    pub fn buckets(&self) -> &[CurveBucket] {
        &self.buckets
    }

    /// The number of values.
    pub const fn count(&self) -> u64 {
        self.count
    }

    /// Whether all values are whole numbers of a byte, as those of digital inputs and outputs are.
    pub const fn is_digital(&self) -> bool {
        self.is_digital
    }

    /// The lowest and the highest value; `None` without one.
    pub fn range(&self) -> Option<(f64, f64)> {
        let ranges = self.buckets.iter().map(|bucket| (bucket.min, bucket.max));
        ranges.reduce(|(min, max), (low, high)| (min.min(low), max.max(high)))
    }

    /// The mean of the values, weighted by number; `None` without values.
    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }
}

/// Whether a value is one of an unsigned byte.
fn is_byte(value: f64) -> bool {
    (0.0..=255.0).contains(&value) && value.fract() == 0.0
}

impl CurveBucket {
    fn with(&self, later: &Self) -> Self {
        Self {
            from: self.from.min(later.from),
            to: self.to.max(later.to),
            min: self.min.min(later.min),
            max: self.max.max(later.max),
            last: later.last,
            count: self.count + later.count,
        }
    }

    fn of_neighbours(pair: &[Self]) -> Self {
        pair[1..].iter().fold(pair[0], |all, later| all.with(later))
    }
}

/// The maximum number of different words; later ones are combined.
const MAX_WORDS: usize = 48;

/// The time series of a state: how long each of its words applies. If there are too many changes, adjacent runs are
/// merged into one with the words of both, so no word is lost.
#[derive(Clone, Debug)]
pub struct Bands {
    words: Vec<String>,
    runs: Vec<BandRun>,
    capacity: usize,
    /// The maximum number of consecutive words in a run.
    room: u64,
    count: u64,
}

/// A time with one word, or with several if there were too many changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BandRun {
    /// Its start, in nanoseconds.
    pub from: i64,
    /// Its last occurrence, in nanoseconds.
    pub to: i64,
    /// The bit set of its words.
    pub words: u64,
    /// The position of the last word.
    pub last: usize,
    /// The number of consecutive words.
    pub changes: u64,
}

impl Bands {
    /// An empty series of at most `capacity` runs, but at least two.
    pub fn new(capacity: usize) -> Self {
        let capacity = capacity.max(2).next_multiple_of(2);
        Self { words: Vec::new(), runs: Vec::new(), capacity, room: 1, count: 0 }
    }

    /// Adds the word of a time in nanoseconds.
    pub fn add(&mut self, time: i64, word: &str) {
        self.count += 1;
        let last = self.position(word);
        match self.runs.last_mut() {
            Some(run) if run.last == last => run.to = run.to.max(time),
            Some(run) if run.changes < self.room => {
                run.words |= 1 << last;
                (run.last, run.to) = (last, run.to.max(time));
                run.changes += 1;
            }
            _ => {
                if self.runs.len() == self.capacity {
                    self.runs = self.runs.chunks(2).map(BandRun::of_neighbours).collect();
                    self.room *= 2;
                }
                self.runs.push(BandRun { from: time, to: time, words: 1 << last, last, changes: 1 });
            }
        }
    }

    /// Begins with one word that occurred this many times between two times.
    pub fn begin(&mut self, [from, to]: [i64; 2], word: &str, count: u64) {
        self.add(from, word);
        self.add(to, word);
        self.count = count;
    }

    fn position(&mut self, word: &str) -> usize {
        self.words.iter().position(|known| known == word).unwrap_or_else(|| {
            if self.words.len() < MAX_WORDS {
                self.words.push(word.to_owned());
            } else if self.words.len() == MAX_WORDS {
                self.words.push("others".to_owned());
            }
            self.words.len() - 1
        })
    }

    /// The words in order of appearance.
    pub fn words(&self) -> &[String] {
        &self.words
    }

    /// The runs in chronological order.
    pub fn runs(&self) -> &[BandRun] {
        &self.runs
    }

    /// The number of added words.
    pub const fn count(&self) -> u64 {
        self.count
    }

    /// The number of changes of the word.
    pub fn changes(&self) -> u64 {
        self.runs.iter().map(|run| run.changes).sum::<u64>().saturating_sub(1)
    }
}

impl BandRun {
    /// Whether it has one word.
    pub const fn is_single(&self) -> bool {
        self.words.is_power_of_two()
    }

    fn of_neighbours(pair: &[Self]) -> Self {
        pair[1..].iter().fold(pair[0], |all, later| Self {
            from: all.from.min(later.from),
            to: all.to.max(later.to),
            words: all.words | later.words,
            last: later.last,
            changes: all.changes + later.changes,
        })
    }
}

/// The kinds of frames, followed by error frames.
pub const DENSITY_KINDS: usize = FrameKind::ALL.len() + 1;

/// The maximum number of lanes.
const MAX_LANES: usize = 256;

/// The time of a bin at first, in nanoseconds.
const FIRST_WIDTH: i128 = 1000;

/// The number of frames of each kind in lanes, over a growing time: when it is exceeded, bins become twice as
/// long.
#[derive(Clone, Debug)]
pub struct Density {
    capacity: usize,
    /// The start of the first bin, in nanoseconds.
    origin: i128,
    /// The time of a bin.
    width: i128,
    /// The first and the last time.
    span: Option<(i64, i64)>,
    lanes: Vec<Vec<[u32; DENSITY_KINDS]>>,
    left_out: u64,
}

impl Density {
    /// Empty lanes of at most `capacity` bins each, but at least two.
    pub fn new(capacity: usize) -> Self {
        let capacity = capacity.max(2).next_multiple_of(2);
        Self { capacity, origin: 0, width: FIRST_WIDTH, span: None, lanes: Vec::new(), left_out: 0 }
    }

    /// Adds a frame of a kind at a time in nanoseconds; an error frame has no kind. Frames of lanes beyond the maximum
    /// are [counted](Self::left_out).
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

    /// The bin of a time, extending the range if needed.
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

    /// The bins of a lane that contain frames: their start and end in nanoseconds, and the number of each
    /// kind.
    pub fn bins(&self, lane: usize) -> impl Iterator<Item = ([i128; 2], &[u32; DENSITY_KINDS])> {
        let bins = self.lanes.get(lane).into_iter().flatten().enumerate();
        bins.filter(|(_, counts)| counts.iter().any(|count| *count > 0)).map(|(at, counts)| {
            let from = self.origin + self.width * at as i128;
            ([from, from + self.width], counts)
        })
    }

    /// The maximum number of frames in a bin.
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

/// Merges pairs of bins, after `shift` empty ones.
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
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_million_values_stay_in_the_buckets() {
        let mut curve = Curve::new(1000);
        for number in 0..1_000_000_i64 {
            // one value in a million differs
            curve.add(number * 1000, if number == 654_321 { 9.0 } else { (number % 7) as f64 });
        }
        assert!(curve.buckets().len() <= 1000 && curve.buckets.capacity() <= 2048);
        assert!(curve.buckets().len() >= 500);
        assert_eq!((curve.count(), curve.range()), (1_000_000, Some((0.0, 9.0))));
        let high: Vec<_> = curve.buckets().iter().filter(|bucket| bucket.max > 8.0).collect();
        assert!(high.len() == 1 && (high[0].from..=high[0].to).contains(&654_321_000), "{high:?}");
    }

    #[test]
    fn what_is_not_a_number_is_left_out() {
        let mut curve = Curve::new(0);
        assert_eq!((curve.range(), curve.mean()), (None, None));
        [f64::NAN, f64::INFINITY, 3.0].into_iter().for_each(|value| curve.add(5, value));
        assert_eq!((curve.count(), curve.range(), curve.mean()), (1, Some((3.0, 3.0)), Some(3.0)));
    }

    #[test]
    fn values_before_the_first_change_count() {
        let mut curve = Curve::new(4);
        curve.begin([10, 40], 2.0, 3);
        curve.add(50, 6.0);
        assert_eq!((curve.count(), curve.mean(), curve.range()), (4, Some(3.0), Some((2.0, 6.0))));
        assert_eq!((curve.buckets()[0].from, curve.buckets()[0].to, curve.buckets().len()), (10, 40, 2));
    }

    proptest! {
        /// Each bucket reports the extremes of its own values, regardless of the order of their times.
        #[test]
        fn buckets_are_as_their_values(values in prop::collection::vec((-50..50_i64, -9..9_i32), 0..300), capacity in 0..40_usize) {
            let mut curve = Curve::new(capacity);
            values.iter().for_each(|&(time, value)| curve.add(time, value.into()));
            prop_assert!(curve.buckets().len() <= capacity.max(2) + 1);
            let mut rest = &values[..];
            for bucket in curve.buckets() {
                let (own, later) = rest.split_at(bucket.count as usize);
                rest = later;
                let numbers = || own.iter().map(|&(_, value)| f64::from(value));
                let found = CurveBucket {
                    from: own.iter().map(|&(time, _)| time).min().unwrap(),
                    to: own.iter().map(|&(time, _)| time).max().unwrap(),
                    min: numbers().fold(f64::INFINITY, f64::min),
                    max: numbers().fold(f64::NEG_INFINITY, f64::max),
                    last: numbers().next_back().unwrap(),
                    count: own.len() as u64,
                };
                prop_assert_eq!(*bucket, found);
            }
            prop_assert!(rest.is_empty());
        }
    }

    #[test]
    fn words_last_until_the_next_one() {
        let mut bands = Bands::new(10);
        for (time, word) in [(0, "stopped"), (5, "stopped"), (9, "operational"), (12, "stopped")] {
            bands.add(time, word);
        }
        assert_eq!(bands.words(), ["stopped", "operational"]);
        let runs: Vec<_> = bands.runs().iter().map(|run| (run.from, run.to, run.last)).collect();
        assert_eq!((runs, bands.changes(), bands.count()), (vec![(0, 5, 0), (9, 9, 1), (12, 12, 0)], 2, 4));
    }

    #[test]
    fn no_word_is_lost() {
        let mut bands = Bands::new(100);
        for number in 0..1_000_000_i64 {
            bands.add(number, if number == 777_777 { "fault" } else { ["on", "off"][(number % 2) as usize] });
        }
        assert!((50..=100).contains(&bands.runs().len()));
        assert_eq!((bands.changes(), bands.words().len()), (999_999, 3));
        let fault = 1 << bands.words().iter().position(|word| word == "fault").unwrap();
        let with: Vec<_> = bands.runs().iter().filter(|run| run.words & fault != 0).collect();
        assert!(with.len() == 1 && with[0].from <= 777_777 && with[0].to >= 777_777 && !with[0].is_single());
    }

    #[test]
    fn words_are_bounded() {
        let mut bands = Bands::new(4);
        (0..1000).for_each(|number| bands.add(number, &number.to_string()));
        assert_eq!((bands.words().len(), bands.words()[MAX_WORDS].as_str()), (MAX_WORDS + 1, "others"));
        assert!(bands.runs().len() <= 4);
    }

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
        /// No frame is lost, and each is in the correct bin.
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
