//! Bus traffic as a page: a timeline, plots of signals, and tables of statistics.

mod course;
mod drawing;
mod scale;

use askama::Template;

pub use self::course::{BandRun, Bands, Curve, CurveBucket, DENSITY_KINDS, Density};
use self::drawing::{BAND, BandWord, Filled, LANE, PLOT};
use self::scale::{Tick, TimeScale, ValueScale, rounded};
use super::escape::filters;
use super::html::{rendered, with_policy};

/// The page of the traffic in logs.
#[derive(Debug)]
pub struct TrafficPage<'a> {
    /// The names of the logs.
    pub title: String,
    /// The number of frames, and their time span.
    pub summary: String,
    /// The number of frames over time, by lane.
    pub density: &'a Density,
    /// The buses.
    pub buses: Vec<TrafficBus<'a>>,
    /// The signals that are drawn.
    pub plots: Vec<TrafficPlot<'a>>,
    /// The signals that are not drawn, in sentences; empty if all are.
    pub left_out: String,
}

/// A bus.
#[derive(Debug)]
pub struct TrafficBus<'a> {
    /// The name of its channel, with the number of frames and the load.
    pub title: String,
    /// Its nodes.
    pub lanes: Vec<TrafficLane<'a>>,
    /// The events, by kind.
    pub events: Vec<TrafficEvents>,
    /// Its statistics.
    pub tables: Vec<TrafficTable>,
    /// Additional remarks.
    pub remarks: Vec<String>,
}

/// A node in the time line.
#[derive(Debug)]
pub struct TrafficLane<'a> {
    /// Its name.
    pub name: String,
    /// Its lane in the density.
    pub lane: usize,
    /// Its NMT states; `None` if it did not send one.
    pub states: Option<&'a Bands>,
}

/// The events of one kind.
#[derive(Debug)]
pub struct TrafficEvents {
    /// The kind.
    pub title: &'static str,
    /// The class of the marks in the time line: `emcy`, `boot-up`, `abort`, `error` or `deviation`.
    pub class: &'static str,
    /// In chronological order.
    pub events: Vec<TrafficEvent>,
    /// The number of further events.
    pub further: u64,
}

/// An event.
#[derive(Debug)]
pub struct TrafficEvent {
    /// When, in nanoseconds.
    pub time: i64,
    /// The time as the log has it.
    pub shown_time: String,
    /// The position of the node among the lanes of its bus.
    pub lane: Option<usize>,
    /// The event as text.
    pub text: String,
    /// The id of the violated rule; empty if there is none.
    pub rule: &'static str,
}

/// A table.
#[derive(Debug)]
pub struct TrafficTable {
    /// Its title.
    pub title: &'static str,
    /// The headings of its columns.
    pub headings: Vec<&'static str>,
    /// Its cells.
    pub rows: Vec<Vec<String>>,
}

/// The course of a signal.
#[derive(Debug)]
pub struct TrafficPlot<'a> {
    /// The node and the entry.
    pub name: String,
    /// The unit; empty if there is none.
    pub unit: String,
    /// The values.
    pub course: TrafficCourse<'a>,
}

/// The course of a signal over time.
#[derive(Clone, Copy, Debug)]
pub enum TrafficCourse<'a> {
    /// Numbers.
    Numbers(&'a Curve),
    /// States, by their words.
    States(&'a Bands),
}

#[derive(Template)]
#[template(path = "html/traffic.html")]
struct TrafficTemplate<'a> {
    page: &'a TrafficPage<'a>,
    scale: TimeScale,
    ticks: Vec<Tick>,
    buses: Vec<DrawnBus<'a>>,
    plots: Vec<DrawnPlot<'a>>,
    kinds: Vec<&'static str>,
    states: Vec<(String, &'a str)>,
}

struct DrawnBus<'a> {
    bus: &'a TrafficBus<'a>,
    lanes: Vec<DrawnLane<'a>>,
    lists: Vec<DrawnEvents<'a>>,
}

struct DrawnLane<'a> {
    name: &'a str,
    label: String,
    paths: Vec<Filled>,
    states: Vec<Filled>,
    /// The positions in the lists of events.
    marks: Vec<TimelineMark<'a>>,
}

struct TimelineMark<'a> {
    id: usize,
    class: &'static str,
    percent: String,
    /// The time for the script.
    seconds: String,
    event: &'a TrafficEvent,
}

struct DrawnEvents<'a> {
    list: &'a TrafficEvents,
    /// The number of the first event on the page.
    first: usize,
}

struct DrawnPlot<'a> {
    plot: &'a TrafficPlot<'a>,
    /// The number of values and their extremes, as text.
    label: String,
    /// The cells of the table: number, minimum, mean, maximum.
    cells: [String; 4],
    drawing: Drawing,
}

enum Drawing {
    Numbers { line: String, extremes: String, ticks: Vec<Tick>, points: String },
    States { paths: Vec<Filled>, words: Vec<BandWord>, legend: Vec<(String, String)>, points: String },
}

impl TrafficPage<'_> {
    /// Writes the page as HTML without external files.
    pub fn html(&self) -> String {
        let end = self.density.span().map(|(_, end)| end);
        let scale = TimeScale::new(self.density.span().unwrap_or_default());
        let mut next = 0;
        let buses: Vec<_> = self.buses.iter().map(|bus| self.bus(bus, &scale, &mut next)).collect();
        let has_kind = |kind: &str| {
            let mut paths = buses.iter().flat_map(|bus| &bus.lanes).flat_map(|lane| &lane.paths);
            paths.any(|path| path.class.strip_prefix("k-") == Some(kind))
        };
        let kinds = (0..DENSITY_KINDS).map(drawing::class).filter(|kind| has_kind(kind)).collect();
        let template = TrafficTemplate {
            page: self,
            ticks: scale.ticks(),
            plots: self.plots.iter().map(|plot| plot.drawn(&scale, end)).collect(),
            kinds,
            states: self.states(),
            buses,
            scale,
        };
        with_policy(rendered(&template, 100_000))
    }

    fn bus<'b>(&'b self, bus: &'b TrafficBus<'_>, scale: &TimeScale, next: &mut usize) -> DrawnBus<'b> {
        let drawn = |list: &'b TrafficEvents| {
            let first = *next;
            *next += list.events.len();
            DrawnEvents { list, first }
        };
        let lists: Vec<DrawnEvents<'_>> = bus.events.iter().map(drawn).collect();
        let highest = self.density.highest();
        let lanes = bus.lanes.iter().enumerate().map(|(position, lane)| {
            let marks = lists.iter().flat_map(|drawn| {
                let own = drawn
                    .list
                    .events
                    .iter()
                    .enumerate()
                    .filter(move |(_, event)| event.lane == Some(position));
                own.map(|(at, event)| TimelineMark {
                    id: drawn.first + at,
                    class: drawn.list.class,
                    percent: scale.percent(event.time),
                    seconds: scale.seconds(event.time),
                    event,
                })
            });
            DrawnLane {
                name: &lane.name,
                label: self.label(lane),
                paths: drawing::lane(self.density, lane.lane, highest, scale),
                states: lane
                    .states
                    .map(|states| drawing::band(states, LANE + 2.0, 6.0, scale, None))
                    .unwrap_or_default(),
                marks: marks.collect(),
            }
        });
        DrawnBus { bus, lanes: lanes.collect(), lists }
    }

    /// The frames of a lane as text: `plc: sync 40, nmt 4`.
    fn label(&self, lane: &TrafficLane<'_>) -> String {
        let mut sums = [0_u64; DENSITY_KINDS];
        for (_, counts) in self.density.bins(lane.lane) {
            sums.iter_mut().zip(counts).for_each(|(sum, count)| *sum += u64::from(*count));
        }
        let counted = sums.iter().enumerate().filter(|(_, sum)| **sum > 0);
        let words: Vec<String> =
            counted.map(|(kind, sum)| format!("{} {sum}", drawing::class(kind))).collect();
        format!("{}: {}", lane.name, if words.is_empty() { "no frame".to_owned() } else { words.join(", ") })
    }

    /// The NMT states of all nodes, with their classes.
    fn states(&self) -> Vec<(String, &str)> {
        let bands = self.buses.iter().flat_map(|bus| &bus.lanes).filter_map(|lane| lane.states);
        let words = bands.flat_map(|bands| bands.words().iter().enumerate());
        let mut all: Vec<_> =
            words.map(|(position, word)| (drawing::state_class(word, position), &**word)).collect();
        all.sort_unstable();
        all.dedup();
        all
    }
}

impl TrafficPlot<'_> {
    fn drawn(&self, scale: &TimeScale, end: Option<i64>) -> DrawnPlot<'_> {
        match self.course {
            TrafficCourse::Numbers(curve) => self.numbers(curve, scale, end),
            TrafficCourse::States(bands) => self.bands(bands, scale, end),
        }
    }

    fn numbers(&self, curve: &Curve, scale: &TimeScale, end: Option<i64>) -> DrawnPlot<'_> {
        let range = curve.range().unwrap_or_default();
        let (min, max, mean) =
            (rounded(range.0), rounded(range.1), rounded(curve.mean().unwrap_or_default()));
        let value = ValueScale::new(range, PLOT);
        DrawnPlot {
            plot: self,
            label: format!("{}: {} values from {min} to {max}, {mean} on average", self.name, curve.count()),
            cells: [curve.count().to_string(), min, mean, max],
            drawing: Drawing::Numbers {
                line: drawing::line(curve, scale, &value, end),
                extremes: drawing::extremes(curve, scale, &value),
                ticks: value.ticks(),
                points: drawing::points(curve, scale),
            },
        }
    }

    fn bands(&self, bands: &Bands, scale: &TimeScale, end: Option<i64>) -> DrawnPlot<'_> {
        let legend = bands.words().iter().enumerate();
        let legend: Vec<_> =
            legend.map(|(position, word)| (drawing::state_class(word, position), word.clone())).collect();
        DrawnPlot {
            plot: self,
            label: format!("{}: {} changes between {}", self.name, bands.changes(), bands.words().join(", ")),
            cells: [bands.count().to_string(), String::new(), String::new(), String::new()],
            drawing: Drawing::States {
                paths: drawing::band(bands, 0.0, BAND, scale, end),
                words: drawing::words(bands, scale, end),
                legend,
                points: drawing::states(bands, scale),
            },
        }
    }
}
