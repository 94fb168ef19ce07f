//! The drawings of a page: paths and rectangles for SVG.

use std::fmt::Write;

use super::course::{Bands, Curve, CurveBucket, DENSITY_KINDS, Density, total};
use super::scale::{TimeScale, ValueScale, rounded, short};
use crate::describe::frames::FrameKind;

/// The height of a plot of numbers.
pub(super) const PLOT: f64 = 120.0;

/// The height of a band of states in a plot.
pub(super) const BAND: f64 = 34.0;

/// The height of the frames in a lane.
pub(super) const LANE: f64 = 28.0;

/// The maximum number of words in a band; a reader cannot see more.
const MAX_WORDS: usize = 200;

/// The width of a plot for which words are selected without a script, and the width of a letter.
const WIDTH: f64 = 700.0;
const LETTER: f64 = 7.0;

/// A colour and its range.
pub(super) struct Filled {
    pub(super) class: String,
    pub(super) path: String,
}

/// A word in a band.
pub(super) struct BandWord {
    pub(super) text: String,
    /// The range along the axis.
    pub(super) from: String,
    pub(super) to: String,
    pub(super) percent: String,
    pub(super) is_hidden: bool,
}

/// The CSS class of a kind of frames; error frames have none.
pub(super) fn class(kind: usize) -> &'static str {
    FrameKind::ALL.get(kind).map_or("error", |kind| kind.name())
}

/// The frames of a lane, one path per kind. The height of a bin shows their number, on a logarithmic scale.
pub(super) fn lane(density: &Density, lane: usize, highest: u64, scale: &TimeScale) -> Vec<Filled> {
    let mut paths = vec![String::new(); DENSITY_KINDS];
    for ([from, to], counts) in density.bins(lane) {
        let all = total(counts) as f64;
        let share = (1.0 + all).ln() / (2.0_f64.max(1.0 + highest as f64)).ln();
        let height = LANE * (0.35 + 0.65 * share.min(1.0));
        let (left, width) = (scale.x(from), scale.x(to) - scale.x(from));
        let mut bottom = LANE;
        for (path, count) in paths.iter_mut().zip(counts).filter(|(_, count)| **count > 0) {
            let top = bottom - height * f64::from(*count) / all;
            rectangle(path, left, top, width, bottom - top);
            bottom = top;
        }
    }
    let filled = paths.into_iter().enumerate().filter(|(_, path)| !path.is_empty());
    filled.map(|(kind, path)| Filled { class: format!("k-{}", class(kind)), path }).collect()
}

fn rectangle(path: &mut String, left: f64, top: f64, width: f64, height: f64) {
    let [left, top, width, height] = [left, top, width, height].map(short);
    // writing to a string cannot fail
    let _ = write!(path, "M{left} {top}h{width}v{height}h-{width}z");
}

/// The words of a band as colours. A run with several words has a stripe for each.
pub(super) fn band(bands: &Bands, top: f64, height: f64, scale: &TimeScale, end: Option<i64>) -> Vec<Filled> {
    let mut paths = vec![String::new(); bands.words().len()];
    for (run, end) in runs(bands, end) {
        let (left, stripe) = (scale.x(run.from), height / f64::from(run.words.count_ones().max(1)));
        let width = (scale.x(end) - left).max(0.0);
        let positions = (0..paths.len()).filter(|position| run.words >> position & 1 == 1);
        for (number, position) in positions.enumerate() {
            rectangle(&mut paths[position], left, top + stripe * number as f64, width, stripe);
        }
    }
    let filled = paths.into_iter().enumerate();
    filled
        .map(|(position, path)| Filled { class: state_class(&bands.words()[position], position), path })
        .collect()
}

/// The CSS class of a state: NMT states always have the same colours.
pub(super) fn state_class(word: &str, position: usize) -> String {
    match word {
        "initialising" | "stopped" | "operational" | "pre-operational" => format!("s-{word}"),
        _ => format!("s{}", position % 8),
    }
}

/// Each run and when it ends: with the next one, as a state lasts until then, the last one at `end` if that is stated.
fn runs(bands: &Bands, last: Option<i64>) -> impl Iterator<Item = (&super::BandRun, i64)> {
    let ends = bands.runs().iter().skip(1).map(|next| Some(next.from)).chain([None]);
    bands.runs().iter().zip(ends).map(move |(run, end)| (run, end.or(last).unwrap_or(run.to)))
}

/// The words that have a place of their own.
pub(super) fn words(bands: &Bands, scale: &TimeScale, end: Option<i64>) -> Vec<BandWord> {
    let single = runs(bands, end).filter(|(run, _)| run.is_single()).take(MAX_WORDS);
    single
        .map(|(run, end)| {
            let text = bands.words()[run.last].clone();
            let (from, to) = (scale.x(run.from), scale.x(end));
            let room = (to - from) / super::scale::LENGTH * WIDTH;
            BandWord {
                is_hidden: room < text.chars().count() as f64 * LETTER + 8.0,
                text,
                from: short(from),
                to: short(to),
                percent: format!("{}%", short((from + to) / 20.0)),
            }
        })
        .collect()
}

/// The values as a line from one to the next; a digital signal has its value until the next one, and the last one until `end`.
pub(super) fn line(curve: &Curve, time: &TimeScale, value: &ValueScale, end: Option<i64>) -> String {
    let mut path = String::new();
    for bucket in curve.buckets() {
        if curve.is_digital() && !path.is_empty() {
            let _ = write!(path, "H{}", short(time.x(bucket.from)));
        }
        let (from, to, y) = (time.x(bucket.from), short(time.x(bucket.to)), short(value.y(bucket.last)));
        // a constant value is a horizontal line
        if bucket.min == bucket.max && bucket.from < bucket.to {
            let _ = write!(path, "{}{} {y}", if path.is_empty() { "M" } else { "L" }, short(from));
        }
        let _ = write!(path, "{}{to} {y}", if path.is_empty() { "M" } else { "L" });
    }
    if let Some(end) = end.filter(|_| curve.is_digital() && !path.is_empty()) {
        let _ = write!(path, "H{}", short(time.x(end)));
    }
    // a value alone is a point, which a line has to show
    if curve.buckets().len() == 1 { path + "h1" } else { path }
}

/// The extremes of the buckets that have several values.
pub(super) fn extremes(curve: &Curve, time: &TimeScale, value: &ValueScale) -> String {
    let mut path = String::new();
    for CurveBucket { from, to, min, max, .. } in
        curve.buckets().iter().filter(|bucket| bucket.min < bucket.max)
    {
        let (left, top) = (time.x(*from), value.y(*max));
        rectangle(&mut path, left, top, time.x(*to) - left, value.y(*min) - top);
    }
    path
}

/// The values for the script: `seconds last min max`, without the extremes if there is only one value.
pub(super) fn points(curve: &Curve, time: &TimeScale) -> String {
    let point = |CurveBucket { from, min, max, last, .. }: &CurveBucket| {
        let seconds = time.seconds(*from);
        let [last, low, high] = [*last, *min, *max].map(rounded);
        if min < max { format!("{seconds} {last} {low} {high}") } else { format!("{seconds} {last}") }
    };
    curve.buckets().iter().map(point).collect::<Vec<_>>().join(";")
}

/// The runs for the script: `seconds word word`, by positions of the words.
pub(super) fn states(bands: &Bands, time: &TimeScale) -> String {
    let positions = |words: u64| (0..64).filter(move |position| words >> position & 1 == 1);
    let run = |run: &super::BandRun| {
        positions(run.words).fold(time.seconds(run.from), |text, position| format!("{text} {position}"))
    };
    bands.runs().iter().map(run).collect::<Vec<_>>().join(";")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Digital signals have edges, other numbers a line from value to value.
    #[test]
    fn digital_signals_are_steps() {
        let scale = TimeScale::new((0, 1000));
        let drawn = |values: [f64; 3]| {
            let mut curve = Curve::new(10);
            (0..).zip(values).for_each(|(at, value)| curve.add(at * 250, value));
            let value = ValueScale::new(curve.range().unwrap(), PLOT);
            line(&curve, &scale, &value, Some(1000)).replace(|letter: char| !letter.is_ascii_uppercase(), "")
        };
        assert_eq!(drawn([0.0, 1.0, 0.0]), "MHLHLH");
        assert_eq!(drawn([0.0, 1.5, 0.0]), "MLL");
    }

    /// A state of a signal lasts to the end of the log.
    #[test]
    fn a_state_lasts_to_the_end() {
        let scale = TimeScale::new((0, 1_000_000));
        let mut bands = Bands::new(10);
        bands.add(0, "on");
        bands.add(500_000, "off");
        let ends = |end| words(&bands, &scale, end).into_iter().map(|word| word.to).collect::<Vec<_>>();
        assert_eq!(
            (ends(Some(1_000_000)), ends(None)),
            (vec!["500".to_owned(), "990.196".to_owned()], vec!["500".to_owned(); 2])
        );
    }
}
