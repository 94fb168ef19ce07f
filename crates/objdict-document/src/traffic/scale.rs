//! Positions of times and values in a plot.

/// The length of the time axis in a plot. Browsers stretch it to the available width.
pub(super) const LENGTH: f64 = 1000.0;

/// The minimum time span of an axis, in nanoseconds.
const LEAST: i128 = 1_000_000;

/// A labelled tick of a plot.
pub(super) struct Tick {
    /// The position along the axis.
    pub(super) at: String,
    pub(super) label: String,
}

/// The axis of times.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimeScale {
    /// The time at its start in nanoseconds.
    pub(super) start: i128,
    /// The time that it shows in nanoseconds.
    pub(super) length: i128,
    /// The zero time of its labels.
    pub(super) zero: i64,
}

impl TimeScale {
    /// An axis for all times from the first to the last, with some space at its ends.
    pub(super) fn new((first, last): (i64, i64)) -> Self {
        let length = i128::from(last) - i128::from(first);
        let room = (length / 100).max((LEAST - length) / 2).max(1);
        Self { start: i128::from(first) - room, length: length + 2 * room, zero: first }
    }

    fn part(&self, time: i128) -> f64 {
        ((time - self.start) as f64 / self.length as f64).clamp(0.0, 1.0)
    }

    /// The position of a time.
    pub(super) fn x(&self, time: impl Into<i128>) -> f64 {
        self.part(time.into()) * LENGTH
    }

    /// The position in percent: `12.5%`.
    pub(super) fn percent(&self, time: impl Into<i128>) -> String {
        format!("{}%", short(self.part(time.into()) * 100.0))
    }

    /// A time in seconds since the first one.
    pub(super) fn seconds(&self, time: i64) -> String {
        let nanoseconds = i128::from(time) - i128::from(self.zero);
        let sign = if nanoseconds < 0 { "-" } else { "" };
        let (whole, rest) = (nanoseconds.abs() / 1_000_000_000, nanoseconds.abs() % 1_000_000_000);
        let text = format!("{sign}{whole}.{rest:09}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    }

    /// Times that are easy to read.
    pub(super) fn ticks(&self) -> Vec<Tick> {
        let start = (self.start - i128::from(self.zero)) as f64;
        let length = self.length as f64;
        let (unit, factor) = match length {
            _ if length >= 2e9 => ("s", 1e9),
            _ if length >= 2e6 => ("ms", 1e6),
            _ => ("µs", 1e3),
        };
        let labels = ticks(start / factor, (start + length) / factor);
        let tick = |(number, label): (f64, String)| Tick {
            at: format!("{}%", short((number * factor - start) / length * 100.0)),
            label: format!("{label} {unit}"),
        };
        labels.into_iter().map(tick).collect()
    }
}

/// The axis of values.
#[derive(Clone, Copy, Debug)]
pub(super) struct ValueScale {
    low: f64,
    high: f64,
    height: f64,
}

impl ValueScale {
    /// An axis for values between two, as high as a drawing.
    pub(super) fn new((low, high): (f64, f64), height: f64) -> Self {
        let room = if low < high { (high - low) * 0.04 } else { (low.abs() * 0.1).max(1.0) };
        Self { low: low - room, high: high + room, height }
    }

    /// The position of a value.
    pub(super) fn y(&self, value: f64) -> f64 {
        // halves, because the whole may be more than a number can be
        let part = (value / 2.0 - self.low / 2.0) / (self.high / 2.0 - self.low / 2.0);
        self.height * (1.0 - if part.is_finite() { part } else { 0.5 })
    }

    pub(super) fn ticks(&self) -> Vec<Tick> {
        let tick = |(value, label): (f64, String)| Tick { at: short(self.y(value)), label };
        ticks(self.low, self.high).into_iter().map(tick).collect()
    }
}

/// Numbers between two that are easy to read, at most seven.
fn ticks(low: f64, high: f64) -> Vec<(f64, String)> {
    let least = (high - low) / 6.0;
    if !least.is_finite() || least <= 0.0 {
        return Vec::new();
    }
    let power = 10_f64.powf(least.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power).into_iter().find(|step| *step >= least);
    let step = step.unwrap_or(10.0 * power);
    let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
    let first = (low / step).ceil();
    let numbers =
        (0..7).map(|number| (first + f64::from(number)) * step).take_while(|number| *number <= high);
    numbers.map(|number| (number, label(number, decimals))).collect()
}

fn label(number: f64, decimals: usize) -> String {
    if number.abs() >= 1e12 { format!("{number:.2e}") } else { format!("{:.decimals$}", number + 0.0) }
}

/// A coordinate with at most three decimal places.
pub(super) fn short(number: f64) -> String {
    let text = format!("{number:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A value rounded for display: six significant digits.
pub(super) fn rounded(number: f64) -> String {
    if number == 0.0 || (1e-4..1e15).contains(&number.abs()) {
        let whole = number.abs().max(1.0).log10().floor() as i32;
        let decimals = usize::try_from(5 - whole).unwrap_or_default();
        let text = format!("{number:.decimals$}");
        let text = if decimals > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        return text.to_owned();
    }
    format!("{number:.5e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: Vec<Tick>) -> Vec<String> {
        ticks.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn ticks_are_easy_to_read() {
        let time = TimeScale::new((1_436_509_052_250_185_000, 1_436_509_053_571_649_000));
        assert_eq!(labels(time.ticks()), ["0 ms", "500 ms", "1000 ms"].map(str::to_owned));
        assert_eq!(
            labels(ValueScale::new((0.0, 100.0), 120.0).ticks()),
            ["0", "20", "40", "60", "80", "100"]
        );
        assert_eq!(labels(ValueScale::new((0.01, 0.012), 120.0).ticks())[0], "0.0100");
    }

    #[test]
    fn scales_have_room_for_anything() {
        for (first, last) in [(0, 0), (i64::MIN, i64::MAX), (5, 6)] {
            let time = TimeScale::new((first, last));
            assert!((0.0..=LENGTH).contains(&time.x(first)) && time.x(first) <= time.x(last));
            assert!(time.ticks().len() <= 7);
        }
        for range in [(f64::MIN, f64::MAX), (0.0, 0.0), (-3.0, -3.0), (f64::MAX, f64::MAX)] {
            let scale = ValueScale::new(range, 120.0);
            assert!(scale.y(range.0).is_finite() && scale.ticks().len() <= 7, "{range:?}");
        }
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [0.0, 1234.5678, 1_000_000.0, 0.1 + 0.2, -7.0].map(rounded),
            ["0", "1234.57", "1000000", "0.3", "-7"]
        );
        assert_eq!([1e300, 12.5, 1e-9].map(rounded)[0], "1.00000e300");
        assert_eq!([0.1234, 5.0, -0.0001].map(short), ["0.123", "5", "0"]);
        let scale = TimeScale::new((1_500_000_000, 9_000_000_000));
        assert_eq!(
            [1_500_000_000, 1_500_000_001, 0].map(|time| scale.seconds(time)),
            ["0", "0.000000001", "-1.5"]
        );
    }
}
