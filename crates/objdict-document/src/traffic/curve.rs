//! The course of a number in bounded memory.

/// The course of a number: so many buckets, each with the extremes of the values that came one after another. When all are full,
/// neighbours become one, so no extreme is lost however many values come.
#[derive(Clone, Debug)]
pub struct Curve {
    buckets: Vec<CurveBucket>,
    capacity: usize,
    /// The most values of a bucket.
    room: u64,
    count: u64,
    sum: f64,
}

/// Values that came one after another.
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
    /// The value that came last.
    pub last: f64,
    /// The number of values.
    pub count: u64,
}

impl Curve {
    /// A course without a value, of at most `capacity` buckets; there are at least two.
    pub fn new(capacity: usize) -> Self {
        // neighbours become one, so their number is even
        let capacity = capacity.max(2).next_multiple_of(2);
        Self { buckets: Vec::new(), capacity, room: 1, count: 0, sum: 0.0 }
    }

    /// Adds a value at a time in nanoseconds. What is not a number is left out.
    pub fn add(&mut self, time: i64, value: f64) {
        if !value.is_finite() {
            return;
        }
        self.count += 1;
        self.sum += value;
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

    /// Begins with one value that came so many times between two times.
    pub fn begin(&mut self, [from, to]: [i64; 2], value: f64, count: u64) {
        if value.is_finite() && self.buckets.is_empty() && count > 0 {
            self.count = count;
            self.sum = value * count as f64;
            self.buckets.push(CurveBucket { from, to, min: value, max: value, last: value, count });
        }
    }

    /// The buckets in the order in which their values came.
    pub fn buckets(&self) -> &[CurveBucket] {
        &self.buckets
    }

    /// The number of values.
    pub const fn count(&self) -> u64 {
        self.count
    }

    /// The lowest and the highest value; `None` without one.
    pub fn range(&self) -> Option<(f64, f64)> {
        let ranges = self.buckets.iter().map(|bucket| (bucket.min, bucket.max));
        ranges.reduce(|(min, max), (low, high)| (min.min(low), max.max(high)))
    }

    /// The mean of the values, each as often as it came; `None` without one.
    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_million_values_stay_in_the_buckets() {
        let mut curve = Curve::new(1000);
        for number in 0..1_000_000_i64 {
            // one value of a million is another
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
        /// Each bucket says of its values what they say themselves, whatever order their times have.
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
}
