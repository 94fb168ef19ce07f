//! The drawings of the page: what is stretched as paths of a picture 1000 wide, and texts at parts of the width.

use std::fmt::Write;

use super::{PlotPoint, PlotValues, TrafficLane, TrafficPlot};

/// The width that the whole time has in a path.
const WIDTH: f64 = 1000.0;

/// The width of a character of a label, and a little more.
const CHARACTER: f64 = 8.0;

/// The height of a plot of numbers, without the lines for its extremes.
const PLOT: f64 = 100.0;

/// A text of a drawing.
#[derive(Debug)]
pub(super) struct Label {
    /// Where it begins, in parts of the width.
    pub(super) x: String,
    /// Where what it is for ends, so that it is hidden where it has no place; empty if it has no end.
    pub(super) end: String,
    pub(super) text: String,
    /// Whether it has no place where the drawing is as wide as a path.
    pub(super) is_hidden: bool,
}

impl Label {
    fn at(part: f64, text: String) -> Self {
        Self { x: share(part), end: String::new(), text, is_hidden: false }
    }
}

/// A span of time with a word for it.
#[derive(Debug)]
pub(super) struct Band {
    pub(super) x: String,
    pub(super) width: String,
    /// The number of its word, for its colour.
    pub(super) class: usize,
    pub(super) text: String,
}

/// A drawing.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    /// Paths with their classes.
    pub(super) paths: Vec<(&'static str, String)>,
    pub(super) bands: Vec<Band>,
    pub(super) labels: Vec<Label>,
    /// Events: where, and what.
    pub(super) marks: Vec<Label>,
    /// The values for the script: positions and numbers.
    pub(super) points: String,
}

/// From times to positions.
#[derive(Debug)]
pub(super) struct Scale {
    from: i64,
    length: f64,
}

impl Scale {
    pub(super) fn new([from, to]: [i64; 2]) -> Self {
        Self { from, length: to.saturating_sub(from).max(1) as f64 }
    }

    /// The time at the left, and the length in seconds. Dates have too many digits for an axis: with them times count from the first frame.
    pub(super) fn seconds(&self) -> [f64; 2] {
        let from = if self.from.unsigned_abs() >= 1_000_000_000_000_000 { 0 } else { self.from };
        [from as f64 / 1e9, self.length / 1e9]
    }

    fn part(&self, time: i64) -> f64 {
        (time.saturating_sub(self.from) as f64 / self.length).clamp(0.0, 1.0)
    }

    fn x(&self, time: i64) -> String {
        short(self.part(time) * WIDTH)
    }

    /// The times at the top.
    pub(super) fn axis(&self) -> Drawing {
        let [from, length] = self.seconds();
        let step = step(length / 5.0);
        // the last digit that distinguishes two ticks
        let digits = (-step.log10().floor()).max(0.0) as usize;
        let first = (from / step).ceil() as i64;
        let ticks = (first..first + 12).map(|tick| tick as f64 * step).take_while(|at| *at <= from + length);
        let labels = ticks.map(|at| Label::at((at - from) / length, format!("{at:.digits$} s")));
        Drawing { labels: labels.collect(), ..Drawing::default() }
    }

    /// Frames above, states below.
    pub(super) fn lane(&self, lane: &TrafficLane) -> Drawing {
        let mut drawing = Drawing::default();
        for (kind, times) in &lane.frames {
            let mut path = String::new();
            let mut last = String::new();
            for time in times {
                let x = self.x(*time);
                if x != last {
                    // writing to a text cannot fail
                    let _ = write!(path, "M{x} 2v18");
                    last = x;
                }
            }
            drawing.paths.push((kind, path));
        }
        let states = lane.states.iter().map(|(time, state)| (*time, state.as_str(), false));
        self.bands(&states.collect::<Vec<_>>(), &mut drawing);
        let mark = |(time, text): &(i64, String)| Label::at(self.part(*time), text.clone());
        drawing.marks = lane.events.iter().map(mark).collect();
        drawing
    }

    pub(super) fn plot(&self, plot: &TrafficPlot) -> Drawing {
        let mut drawing = Drawing::default();
        match &plot.values {
            PlotValues::Numbers(points) => self.line(points, plot.extremes, &mut drawing),
            PlotValues::Words(words) => {
                let words: Vec<_> =
                    words.iter().map(|(time, word, is_mixed)| (*time, &**word, *is_mixed)).collect();
                self.bands(&words, &mut drawing);
            }
        }
        drawing
    }

    /// A value counts until the next one.
    fn line(&self, points: &[PlotPoint], [lowest, _, highest]: [f64; 3], drawing: &mut Drawing) {
        let height = (highest - lowest).max(f64::MIN_POSITIVE);
        let y = |number: f64| {
            let part = if highest > lowest { (highest - number) / height } else { 0.5 };
            short(4.0 + part.clamp(0.0, 1.0) * (PLOT - 8.0))
        };
        let (mut path, mut values) = (String::new(), String::new());
        for point in points {
            let [min, max, last] = point.numbers;
            let [x, end] = point.times.map(|time| self.x(time));
            let start = if path.is_empty() { format!("M{x} {}", y(last)) } else { format!("H{x}") };
            path += &start;
            if min < max {
                let _ = write!(path, "V{}V{}", y(min), y(max));
            }
            let _ = write!(path, "V{}H{end}", y(last));
            let _ = write!(values, "{x} {} ", number(last));
        }
        if !path.is_empty() {
            let _ = write!(path, "H{}", short(WIDTH));
        }
        drawing.paths.push(("line", path));
        drawing.points = values;
    }

    /// Bands of neighbours with one word are one.
    fn bands(&self, words: &[(i64, &str, bool)], drawing: &mut Drawing) {
        let mut known: Vec<&str> = Vec::new();
        let of_one_word = || words.chunk_by(|a, b| a.1 == b.1 && !a.2 && !b.2);
        let ends = of_one_word().skip(1).filter_map(|chunk| Some(chunk.first()?.0)).map(Some);
        for (chunk, end) in of_one_word().zip(ends.chain([None])) {
            let Some(&(time, word, is_mixed)) = chunk.first() else { continue };
            let class = known.iter().position(|known| *known == word).unwrap_or_else(|| {
                known.push(word);
                known.len() - 1
            });
            let (start, end) = (self.part(time), end.map_or(1.0, |end| self.part(end)));
            let text = if is_mixed { format!("several, at last {word}") } else { word.to_owned() };
            drawing.bands.push(Band {
                x: short(start * WIDTH),
                width: short((end - start).max(0.0) * WIDTH),
                class: class % 8,
                text,
            });
            let is_hidden = (end - start) * WIDTH < CHARACTER * word.chars().count() as f64;
            let (x, end) = (share(start), share(end));
            drawing.labels.push(Label { x, end, text: word.to_owned(), is_hidden });
        }
    }
}

/// A step of 1, 2 or 5 for ticks, not smaller than this.
fn step(least: f64) -> f64 {
    let magnitude = 10_f64.powf(least.max(1e-9).log10().floor());
    let steps = [1.0, 2.0, 5.0].map(|step| step * magnitude);
    steps.into_iter().find(|step| *step >= least).unwrap_or(10.0 * magnitude)
}

/// A part of the width as CSS has it.
fn share(part: f64) -> String {
    short(part * 100.0) + "%"
}

/// With two digits behind the point at most.
fn short(number: f64) -> String {
    let text = format!("{number:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A number as it is read, with six digits.
pub(super) fn number(number: f64) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    let digits = 5 - (number.abs().log10().floor().clamp(-300.0, 300.0) as i32);
    match usize::try_from(digits) {
        Ok(digits @ 0..=12) => {
            let text = format!("{number:.digits$}");
            let is_fraction = text.contains('.');
            if is_fraction { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
        }
        Ok(_) => format!("{number:.5e}"),
        Err(_) if number.abs() < 1e15 => format!("{number:.0}"),
        Err(_) => format!("{number:.5e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_six_digits() {
        let shown = [0.0, 1450.0, 0.1, -2.5, 1.0 / 3.0, 1234567.0, 1e20, 1e-20, 99999.96].map(number);
        let expected =
            ["0", "1450", "0.1", "-2.5", "0.333333", "1234567", "1.00000e20", "1.00000e-20", "100000"];
        assert_eq!(shown, expected);
    }

    #[test]
    fn ticks_are_round() {
        let axis = |from, to| {
            let labels = Scale::new([from, to]).axis().labels;
            labels.into_iter().map(|label| (label.x, label.text)).collect::<Vec<_>>()
        };
        let tick = |x: &str, text: &str| (x.to_owned(), text.to_owned());
        let second = 1_000_000_000;
        let expected = [
            tick("0%", "1.0 s"),
            tick("25%", "1.5 s"),
            tick("50%", "2.0 s"),
            tick("75%", "2.5 s"),
            tick("100%", "3.0 s"),
        ];
        assert_eq!(axis(second, 3 * second), expected);
        // a date: times count from the first frame
        assert_eq!(axis(1_700_000_000 * second, 1_700_000_001 * second)[0], tick("0%", "0.0 s"));
        assert_eq!(axis(5, 5).len(), 6);
    }

    #[test]
    fn a_number_counts_until_the_next_one() {
        let point = |time, numbers| PlotPoint { times: [time, time], numbers };
        let mut drawing = Drawing::default();
        let points = [point(0, [0.0, 0.0, 0.0]), point(50, [1.0, 10.0, 10.0])];
        Scale::new([0, 100]).line(&points, [0.0, 5.0, 10.0], &mut drawing);
        assert_eq!(drawing.paths[0].1, "M0 96V96H0H500V86.8V4V4H500H1000");
        assert_eq!(drawing.points, "0 0 500 10 ");
    }
}
