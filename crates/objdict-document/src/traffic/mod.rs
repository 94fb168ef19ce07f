//! What was seen on buses, as a page: a time line, plots of signals, and tables.
//!
//! Drawings have their texts outside of what is stretched to the width of the page, so that both are sharp; a script changes the part that
//! is shown. Without it the page is whole.

mod drawing;

use askama::Template;

use self::drawing::{Drawing, Scale};
use super::escape::filters;
use super::policy::with_policy;

/// The page of logs.
#[derive(Debug)]
pub struct TrafficPage {
    /// What the logs are called.
    pub title: String,
    /// The buses in them.
    pub buses: Vec<BusTraffic>,
}

/// What was seen of a bus. Times are in nanoseconds.
#[derive(Debug)]
pub struct BusTraffic {
    /// The name of its channel; empty if it has none.
    pub name: String,
    /// The sum of its frames in a sentence.
    pub summary: String,
    /// The first and the last time.
    pub span: [i64; 2],
    /// The first time as the log has it.
    pub from: String,
    /// What each node sent.
    pub lanes: Vec<TrafficLane>,
    /// The signals that are plotted.
    pub plots: Vec<TrafficPlot>,
    /// How many other signals change.
    pub further_plots: usize,
    /// What is listed below.
    pub tables: Vec<TrafficTable>,
}

/// What a node sent, and what happened to it.
#[derive(Debug)]
pub struct TrafficLane {
    /// The name of the node.
    pub name: String,
    /// When it sent frames of a kind, by the words of [`FrameKind`](crate::describe::frames::FrameKind); `error` has error frames.
    pub frames: Vec<(&'static str, Vec<i64>)>,
    /// Its NMT states, each from its time on.
    pub states: Vec<(i64, String)>,
    /// Events in words.
    pub events: Vec<(i64, String)>,
}

/// A signal over time.
#[derive(Debug)]
pub struct TrafficPlot {
    /// What it is: `drive 6064:00 Position actual value`.
    pub name: String,
    /// Its unit; empty if it has none.
    pub unit: String,
    /// The number of values.
    pub count: u64,
    /// The lowest value, the mean and the highest.
    pub extremes: [f64; 3],
    /// Its values.
    pub values: PlotValues,
}

/// The values of a signal.
#[derive(Debug)]
pub enum PlotValues {
    /// Numbers.
    Numbers(Vec<PlotPoint>),
    /// What the values mean, each from its time on; a span in which there were several has the last one, and is marked.
    Words(Vec<(i64, String, bool)>),
}

/// Numbers between two times.
#[derive(Clone, Copy, Debug)]
pub struct PlotPoint {
    /// The first and the last time.
    pub times: [i64; 2],
    /// The lowest, the highest and the last number.
    pub numbers: [f64; 3],
}

/// A table.
#[derive(Debug)]
pub struct TrafficTable {
    title: &'static str,
    headings: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

/// The kinds of frames with words for the legend.
const KINDS: [(&str, &str); 12] = [
    ("nmt", "NMT"),
    ("sync", "SYNC"),
    ("time", "TIME"),
    ("emcy", "EMCY"),
    ("pdo", "PDO"),
    ("sdo", "SDO"),
    ("heartbeat", "heartbeat"),
    ("boot-up", "boot-up"),
    ("guarding", "guarding"),
    ("lss", "LSS"),
    ("unknown", "unknown"),
    ("error", "error frame"),
];

#[derive(Template)]
#[template(path = "html/traffic.html")]
struct TrafficTemplate<'a> {
    page: &'a TrafficPage,
    buses: Vec<BusView<'a>>,
    version: &'static str,
}

struct BusView<'a> {
    bus: &'a BusTraffic,
    /// The first time and the length of the drawings in seconds; times count from the first if it is a date.
    seconds: [f64; 2],
    axis: Drawing,
    lanes: Vec<(&'a TrafficLane, Drawing)>,
    plots: Vec<(&'a TrafficPlot, Drawing)>,
    legend: Vec<(&'static str, &'static str)>,
}

impl TrafficPage {
    /// Writes the page as HTML, which needs no other file.
    pub fn html(&self) -> String {
        let buses = self.buses.iter().map(BusView::new).collect();
        let template = TrafficTemplate { page: self, buses, version: env!("CARGO_PKG_VERSION") };
        // writing to a String cannot fail, nor do the template filters
        with_policy(template.render().unwrap_or_default())
    }
}

impl TrafficTable {
    /// A table without the columns that are empty in every row.
    pub fn new(title: &'static str, headings: &[&'static str], mut rows: Vec<Vec<String>>) -> Self {
        let is_used =
            |column: usize| rows.iter().any(|row| row.get(column).is_some_and(|cell| !cell.is_empty()));
        let used: Vec<usize> = (0..headings.len()).filter(|column| is_used(*column)).collect();
        for row in &mut rows {
            let cells =
                used.iter().map(|column| row.get_mut(*column).map(std::mem::take).unwrap_or_default());
            *row = cells.collect();
        }
        let headings = used.iter().filter_map(|column| headings.get(*column).copied()).collect();
        Self { title, headings, rows }
    }
}

impl<'a> BusView<'a> {
    fn new(bus: &'a BusTraffic) -> Self {
        let scale = Scale::new(bus.span);
        let is_used =
            |kind: &str| bus.lanes.iter().any(|lane| lane.frames.iter().any(|(used, _)| *used == kind));
        Self {
            bus,
            seconds: scale.seconds(),
            axis: scale.axis(),
            lanes: bus.lanes.iter().map(|lane| (lane, scale.lane(lane))).collect(),
            plots: bus.plots.iter().map(|plot| (plot, scale.plot(plot))).collect(),
            legend: KINDS.into_iter().filter(|(kind, _)| is_used(kind)).collect(),
        }
    }
}

impl TrafficPlot {
    fn highest(&self) -> String {
        format!("{} {}", drawing::number(self.extremes[2]), self.unit)
    }

    fn lowest(&self) -> String {
        drawing::number(self.extremes[0])
    }

    /// Such as `5 values, lowest 1450, mean 1950, highest 2200 mm`.
    fn facts(&self) -> String {
        let count = if self.count == 1 { "1 value".to_owned() } else { format!("{} values", self.count) };
        if let PlotValues::Words(_) = self.values {
            return count;
        }
        let [min, mean, max] = self.extremes.map(drawing::number);
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        format!("{count}, lowest {min}, mean {mean}, highest {max}{unit}")
    }
}
