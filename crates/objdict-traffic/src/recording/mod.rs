//! What a page draws of the frames of logs, in memory that does not grow with their number.

mod choice;
mod page;

use std::collections::BTreeMap;

use self::choice::OfferedSignal;
pub use self::choice::{PlotChoice, address};
pub use self::page::PageTexts;
use super::{Bus, PRE_OPERATIONAL, raw};
use crate::log::LoggedFrame;
use objdict_document::describe::frames::{DecodedFrame, FrameKind, SignalReading, TransferStep, nmt_state};
use objdict_document::{Bands, Curve, Density};
use objdict_model::model::Value;

/// The most signals that are followed.
const MAX_SIGNALS: usize = 4096;

/// The most plots.
const MAX_PLOTS: usize = 64;

/// How many plots there are where none is chosen.
const FIRST_PLOTS: usize = 8;

/// The most names of signals that are not drawn.
const MAX_NAMES: usize = 20;

/// The most bins of a lane; more do not fit on a screen.
const MAX_BINS: usize = 1000;

/// What the NMT state of a node is called.
const NMT_STATE: &str = "NMT state";

/// A signal: the position of the bus, the node-ID, index and sub-index.
type SignalKey = (usize, u8, u16, u8);

/// What becomes of the values of a signal.
#[derive(Debug)]
enum Fate {
    /// They have been the same so far, so many from the first time to the last.
    Constant { value: Value, times: [i64; 2], count: u64 },
    /// They are drawn, in the plot of this position.
    Drawn(usize),
    /// They are not drawn.
    LeftOut,
}

/// The course of a signal.
#[derive(Debug)]
struct Plot {
    key: SignalKey,
    /// The entry with its name.
    name: String,
    unit: String,
    course: Course,
}

#[derive(Debug)]
enum Course {
    Numbers(Curve),
    States(Bands),
}

/// The history of frames and signals.
#[derive(Debug)]
pub struct Recording {
    choices: Vec<PlotChoice>,
    /// The choices that are for a signal of the logs.
    used: Vec<bool>,
    points: usize,
    density: Density,
    /// The lanes by bus and node-ID, 0 for frames of no node.
    lanes: BTreeMap<(usize, u8), usize>,
    states: BTreeMap<(usize, u8), Bands>,
    signals: BTreeMap<SignalKey, Fate>,
    plots: Vec<Plot>,
    /// Names of signals that are not drawn, and how many there are.
    left_out: (Vec<String>, usize),
}

impl Recording {
    /// A history without a frame, with `points` points of each signal. Without a choice, the first signals of PDOs that change are
    /// drawn.
    pub fn new(choices: &[PlotChoice], points: usize) -> Self {
        Self {
            choices: choices.to_vec(),
            used: vec![false; choices.len()],
            points,
            density: Density::new(points.min(MAX_BINS)),
            lanes: BTreeMap::new(),
            states: BTreeMap::new(),
            signals: BTreeMap::new(),
            plots: Vec::new(),
            left_out: (Vec::new(), 0),
        }
    }

    /// Adds a frame of the bus at a position.
    pub fn add(&mut self, decoded: &DecodedFrame, frame: &LoggedFrame, at: usize, bus: &Bus<'_>) {
        let time = frame.time.nanoseconds();
        let node_id = decoded.node_id.unwrap_or(0);
        let next = self.lanes.len();
        let lane = *self.lanes.entry((at, node_id)).or_insert(next);
        self.density.add(lane, Some(decoded.kind).filter(|_| !frame.is_error), time);
        if frame.is_error || frame.is_remote {
            return;
        }
        match decoded.kind {
            FrameKind::Heartbeat | FrameKind::Guarding | FrameKind::BootUp => {
                let is_boot_up = decoded.kind == FrameKind::BootUp;
                let state = if is_boot_up { Some(PRE_OPERATIONAL) } else { frame.data().first().copied() };
                state.into_iter().for_each(|state| self.state(state, time, (at, node_id), bus));
            }
            FrameKind::Pdo => self.pdo(decoded, frame, at, bus),
            FrameKind::Sdo => self.transfer(decoded, time, (at, node_id), bus),
            _ => {}
        }
    }

    fn state(&mut self, state: u8, time: i64, node: (usize, u8), bus: &Bus<'_>) {
        let points = self.points;
        let word = nmt_state(state & 0x7F);
        self.states.entry(node).or_insert_with(|| Bands::new(points)).add(time, &word);
        let key = (node.0, node.1, 0, 0);
        if !self.choices.is_empty() && !self.signals.contains_key(&key) {
            let fate = self.chosen(key, NMT_STATE, None, bus);
            self.signals.insert(key, fate);
        }
        if let Some(Fate::Drawn(plot)) = self.signals.get(&key) {
            let reading = SignalReading { word: Some(word), ..SignalReading::default() };
            self.plots[*plot].add(time, reading, self.points);
        }
    }

    fn pdo(&mut self, decoded: &DecodedFrame, frame: &LoggedFrame, at: usize, bus: &Bus<'_>) {
        let time = frame.time.nanoseconds();
        for (node_id, (index, sub), value) in bus.reader.values(decoded, &raw(frame)) {
            self.value((at, node_id, index, sub), &value, time, true, bus);
        }
    }

    /// A value that a node answers or has accepted.
    fn transfer(&mut self, decoded: &DecodedFrame, time: i64, (at, node_id): (usize, u8), bus: &Bus<'_>) {
        let Some(sdo) = decoded.sdo else { return };
        let is_taken = sdo.step == TransferStep::Written || !sdo.is_request && sdo.step.has_value();
        let Some((index, sub)) = sdo.entry.filter(|_| is_taken) else { return };
        if let Some((_, Some(value))) = bus.reader.transferred(decoded) {
            self.value((at, node_id, index, sub), &value, time, false, bus);
        }
    }

    fn value(&mut self, key: SignalKey, value: &Value, time: i64, is_pdo: bool, bus: &Bus<'_>) {
        let (_, node_id, index, sub) = key;
        if !self.signals.contains_key(&key) {
            let is_wanted = !self.choices.is_empty() || is_pdo;
            if self.signals.len() >= MAX_SIGNALS || !is_wanted {
                return;
            }
            let fate = if self.choices.is_empty() {
                Fate::Constant { value: value.clone(), times: [time; 2], count: 0 }
            } else {
                let name = bus.reader.entry_name(node_id, (index, sub));
                self.chosen(key, &name, Some((index, sub)), bus)
            };
            self.signals.insert(key, fate);
        }
        match self.signals.get_mut(&key) {
            Some(Fate::Constant { value: first, times, count }) if *first == *value => {
                (times[1], *count) = (time, *count + 1);
            }
            Some(Fate::Constant { value: first, times, count }) => {
                let (first, times, count) = (first.clone(), *times, *count);
                let name = bus.reader.entry_name(node_id, (index, sub));
                let fate = self.drawn(key, &name, FIRST_PLOTS, bus);
                if let Fate::Drawn(plot) = fate {
                    let reading = bus.reader.reading(node_id, (index, sub), &first);
                    self.plots[plot].begin(times, count, reading, self.points);
                }
                self.signals.insert(key, fate);
            }
            _ => {}
        }
        if let Some(Fate::Drawn(plot)) = self.signals.get(&key) {
            let reading = bus.reader.reading(node_id, (index, sub), value);
            self.plots[*plot].add(time, reading, self.points);
        }
    }

    /// What becomes of a signal where signals are chosen.
    fn chosen(&mut self, key: SignalKey, name: &str, entry: Option<(u16, u8)>, bus: &Bus<'_>) -> Fate {
        let node = bus.reader.name(key.1);
        // behind the address of the entry
        let own = if entry.is_some() { name.split_once(' ').map_or("", |(_, own)| own) } else { name };
        let signal = OfferedSignal { node_id: key.1, node: &node, entry, name: own };
        let mut is_chosen = false;
        for (choice, used) in self.choices.iter().zip(&mut self.used) {
            if choice.is_for(&signal) {
                (*used, is_chosen) = (true, true);
            }
        }
        if is_chosen { self.drawn(key, name, MAX_PLOTS, bus) } else { Fate::LeftOut }
    }

    fn drawn(&mut self, key: SignalKey, name: &str, most: usize, bus: &Bus<'_>) -> Fate {
        if self.plots.len() >= most {
            self.left_out.1 += 1;
            if self.left_out.0.len() < MAX_NAMES {
                self.left_out.0.push(format!("{}: {name}", bus.reader.name(key.1)));
            }
            return Fate::LeftOut;
        }
        let course = Course::Numbers(Curve::new(self.points));
        self.plots.push(Plot { key, name: name.to_owned(), unit: String::new(), course });
        Fate::Drawn(self.plots.len() - 1)
    }

    /// The choices that are for no signal of the logs.
    pub fn unused(&self) -> impl Iterator<Item = &str> {
        let choices = self.choices.iter().zip(&self.used);
        choices.filter(|(_, used)| !**used).map(|(choice, _)| choice.text.as_str())
    }
}

impl Plot {
    /// Begins with a value that came so many times between two times. What has a name at first is a state.
    fn begin(&mut self, times: [i64; 2], count: u64, reading: SignalReading, points: usize) {
        self.unit = reading.unit;
        match (reading.word, reading.number, &mut self.course) {
            (Some(word), ..) => {
                let mut bands = Bands::new(points);
                bands.begin(times, &word, count);
                self.course = Course::States(bands);
            }
            (None, Some(number), Course::Numbers(curve)) => curve.begin(times, number, count),
            _ => {}
        }
    }

    fn add(&mut self, time: i64, reading: SignalReading, points: usize) {
        if matches!(&self.course, Course::Numbers(curve) if curve.count() == 0) {
            return self.begin([time; 2], 1, reading, points);
        }
        let SignalReading { number, word, .. } = reading;
        match (&mut self.course, number, word) {
            (Course::Numbers(curve), Some(number), _) => curve.add(time, number),
            (Course::States(bands), _, Some(word)) => bands.add(time, &word),
            (Course::States(bands), Some(number), None) => bands.add(time, &number.to_string()),
            _ => {}
        }
    }
}
