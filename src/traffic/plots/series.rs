//! A value over time in bounded memory.

/// The first width of a bucket in nanoseconds.
const NARROWEST: i64 = 1000;

/// The least number of buckets that is kept: all times are in four of the widest ones.
const FEWEST: usize = 4;

/// What is known of a value in a span of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bucket {
    /// The time of the first value in nanoseconds.
    pub(crate) first: i64,
    /// The time of the last value in nanoseconds.
    pub(crate) last: i64,
    pub(crate) min: f64,
    pub(crate) max: f64,
    /// The last value.
    pub(crate) value: f64,
}

impl Bucket {
    fn of(time: i64, value: f64) -> Self {
        Self { first: time, last: time, min: value, max: value, value }
    }

    /// Takes in another one; of two last values the one that came later counts.
    fn merge(&mut self, other: Self) {
        if other.last >= self.last {
            (self.last, self.value) = (other.last, other.value);
        }
        self.first = self.first.min(other.first);
        self.min = self.min.min(other.min);
        self.max = self.max.max(other.max);
    }
}

/// The values of a signal. When there are more than are kept, neighbours are merged: no extreme is lost.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    /// The most buckets.
    limit: usize,
    /// The width of a bucket in nanoseconds.
    width: i64,
    /// The buckets by their numbers, in ascending order.
    buckets: Vec<(i64, Bucket)>,
    count: u64,
    sum: f64,
}

impl Series {
    pub(crate) fn new(limit: usize) -> Self {
        Self { limit: limit.max(FEWEST), width: NARROWEST, buckets: Vec::new(), count: 0, sum: 0.0 }
    }

    /// Adds a value. Times may go back, as those of a log do after the clock was set.
    pub(crate) fn add(&mut self, time: i64, value: f64) {
        self.count += 1;
        self.sum += value;
        let (number, bucket) = (time.div_euclid(self.width), Bucket::of(time, value));
        // values come in the order of their times, but for a few
        let at = match self.buckets.last() {
            Some((last, _)) if *last >= number => self.buckets.partition_point(|(other, _)| *other < number),
            _ => self.buckets.len(),
        };
        match self.buckets.get_mut(at) {
            Some((other, known)) if *other == number => known.merge(bucket),
            _ => self.buckets.insert(at, (number, bucket)),
        }
        while self.buckets.len() > self.limit && self.width < i64::MAX / 2 {
            self.widen();
        }
    }

    fn widen(&mut self) {
        self.width *= 2;
        self.buckets.iter_mut().for_each(|(number, _)| *number = number.div_euclid(2));
        self.buckets.dedup_by(|(number, bucket), (kept, into)| {
            let is_same = number == kept;
            if is_same {
                into.merge(*bucket);
            }
            is_same
        });
    }

    pub(crate) fn buckets(&self) -> impl Iterator<Item = &Bucket> {
        self.buckets.iter().map(|(_, bucket)| bucket)
    }

    /// How many values there were.
    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    /// The lowest value, the mean and the highest; `None` without a value.
    pub(crate) fn extremes(&self) -> Option<[f64; 3]> {
        let min = self.buckets().map(|bucket| bucket.min).reduce(f64::min)?;
        let max = self.buckets().map(|bucket| bucket.max).reduce(f64::max)?;
        Some([min, self.sum / self.count as f64, max])
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn no_extreme_is_lost(
            values in prop::collection::vec((-1_000_000_000_000_i64..1_000_000_000_000, -100.0..100.0_f64), 1..400),
            limit in FEWEST..50,
        ) {
            let mut series = Series::new(limit);
            values.iter().for_each(|(time, value)| series.add(*time, *value));
            prop_assert!(series.buckets.len() <= limit);
            prop_assert_eq!(series.count(), values.len() as u64);
            let all = || values.iter().map(|(_, value)| *value);
            let [min, mean, max] = series.extremes().unwrap();
            prop_assert_eq!([min, max], [all().fold(f64::MAX, f64::min), all().fold(f64::MIN, f64::max)]);
            prop_assert!((mean - all().sum::<f64>() / values.len() as f64).abs() < 1e-9);
            // each bucket has what the values between its times have
            for bucket in series.buckets() {
                let own = || values.iter().filter(|(time, _)| (bucket.first..=bucket.last).contains(time));
                prop_assert_eq!(bucket.min, own().map(|(_, value)| *value).fold(f64::MAX, f64::min));
                prop_assert_eq!(bucket.max, own().map(|(_, value)| *value).fold(f64::MIN, f64::max));
                let last = own().filter(|(time, _)| *time == bucket.last).next_back().unwrap();
                prop_assert_eq!(bucket.value, last.1);
            }
            prop_assert!(series.buckets().map(|bucket| bucket.first).is_sorted());
        }
    }

    #[test]
    fn the_ends_of_time_are_few_buckets() {
        let mut series = Series::new(1);
        let times = [i64::MIN, i64::MIN / 2 - 1, -1, 0, i64::MAX / 2, i64::MAX];
        times.into_iter().for_each(|time| series.add(time, 1.0));
        assert!(series.buckets.len() <= FEWEST);
    }
}
