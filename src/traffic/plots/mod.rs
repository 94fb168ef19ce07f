//! What signals and nodes did over time, in memory that does not grow with the frames of a log.

mod choice;
mod lane;
mod series;

use std::collections::BTreeMap;

pub(crate) use self::choice::PlotChoice;
pub(crate) use self::lane::Lanes;
pub(crate) use self::series::{Bucket, Series};
use super::{Bus, raw};
use crate::describe::frames::{DecodedFrame, FrameKind, PdoSignal, SdoStep};
use crate::format::log::LoggedFrame;

/// The most signals that are followed where none is chosen.
const MAX_SIGNALS: usize = 256;

/// The most meanings of a signal that are told apart; one with more is shown by its numbers.
const MAX_MEANINGS: usize = 32;

/// A signal over time.
#[derive(Debug)]
pub(crate) struct SignalPlot {
    /// The position of the bus.
    pub(crate) bus: usize,
    pub(crate) node_id: u8,
    pub(crate) index: u16,
    pub(crate) sub: u8,
    /// The name of the entry; empty if no description has it.
    pub(crate) name: String,
    /// The unit of the numbers; empty if there is none.
    pub(crate) unit: String,
    pub(crate) numbers: Series,
    /// What the values mean, where each value means something.
    pub(crate) meanings: Option<Meanings>,
}

/// The meanings of a signal over time, as positions in the list of their words.
#[derive(Debug)]
pub(crate) struct Meanings {
    pub(crate) words: Vec<String>,
    pub(crate) series: Series,
}

impl Meanings {
    fn new(limit: usize) -> Self {
        Self { words: Vec::new(), series: Series::new(limit) }
    }

    /// Adds a meaning; whether there is place for it.
    fn add(&mut self, time: i64, word: &str) -> bool {
        let known = self.words.iter().position(|known| known == word);
        if known.is_none() && self.words.len() >= MAX_MEANINGS {
            return false;
        }
        let at = known.unwrap_or_else(|| {
            self.words.push(word.to_owned());
            self.words.len() - 1
        });
        self.series.add(time, at as f64);
        true
    }
}

/// The signals of logs over time.
#[derive(Debug)]
pub(crate) struct Plots {
    choices: Vec<PlotChoice>,
    /// The most points of a signal.
    limit: usize,
    signals: Vec<SignalPlot>,
    positions: BTreeMap<(usize, u8, u16, u8), Option<usize>>,
}

impl Plots {
    /// The plots of chosen signals; without a choice of all signals in PDOs.
    pub(crate) fn new(choices: Vec<PlotChoice>, limit: usize) -> Self {
        let (signals, positions) = Default::default();
        Self { choices, limit, signals, positions }
    }

    /// Adds a frame of the bus at a position.
    pub(crate) fn add(&mut self, decoded: &DecodedFrame, frame: &LoggedFrame, at: usize, bus: &Bus<'_>) {
        let Some(node_id) = decoded.node_id else { return };
        let time = frame.time.nanoseconds();
        match decoded.kind {
            FrameKind::Pdo if !frame.is_remote => {
                for signal in bus.reader.signals(decoded, &raw(frame)) {
                    self.signal((at, node_id), time, &signal, bus);
                }
            }
            FrameKind::Sdo if !self.choices.is_empty() => {
                let step = decoded.sdo.map(|sdo| (sdo.step, sdo.is_request));
                let is_answer = matches!(step, Some((step, false)) if step.has_value());
                if is_answer || matches!(step, Some((SdoStep::Written, _))) {
                    let signal = bus.reader.transferred_signal(decoded);
                    signal.iter().for_each(|signal| self.signal((at, node_id), time, signal, bus));
                }
            }
            _ => {}
        }
    }

    fn signal(&mut self, (at, node_id): (usize, u8), time: i64, signal: &PdoSignal<'_>, bus: &Bus<'_>) {
        let PdoSignal { index, sub, .. } = *signal;
        let position = self.positions.get(&(at, node_id, index, sub)).copied();
        let position = position.unwrap_or_else(|| {
            let position = self.place((at, node_id), signal, bus);
            // with many buses, signals and node-IDs this list has an end too
            if self.positions.len() < 16 * MAX_SIGNALS {
                self.positions.insert((at, node_id, index, sub), position);
            }
            position
        });
        let Some(plot) = position.and_then(|position| self.signals.get_mut(position)) else { return };
        let Some(number) = number(signal) else { return };
        plot.numbers.add(time, number);
        let meaning = meaning(signal);
        let is_kept =
            plot.meanings.as_mut().zip(meaning).is_some_and(|(meanings, word)| meanings.add(time, word));
        if !is_kept {
            plot.meanings = None;
        }
    }

    /// The position of a signal that was not seen before; `None` if it is not followed.
    fn place(
        &mut self,
        (bus_at, node_id): (usize, u8),
        signal: &PdoSignal<'_>,
        bus: &Bus<'_>,
    ) -> Option<usize> {
        let node = bus.reader.name(node_id);
        let is_chosen =
            |choice: &PlotChoice| choice.is_for((node_id, &node), (signal.index, signal.sub), &signal.name);
        let chosen = self.choices.iter_mut().filter(|choice| is_chosen(choice));
        let count = chosen.map(|choice| choice.is_found = true).count();
        if count == 0 && !self.choices.is_empty() {
            return None;
        }
        if self.signals.len() >= MAX_SIGNALS {
            return None;
        }
        self.signals.push(SignalPlot {
            bus: bus_at,
            node_id,
            index: signal.index,
            sub: signal.sub,
            name: signal.name.clone().into_owned(),
            unit: signal.unit.clone().into_owned(),
            numbers: Series::new(self.limit),
            meanings: Some(Meanings::new(self.limit)),
        });
        Some(self.signals.len() - 1)
    }

    /// The choices that no signal is.
    pub(crate) fn unfound(&self) -> impl Iterator<Item = &PlotChoice> {
        self.choices.iter().filter(|choice| !choice.is_found)
    }

    /// The signals that are shown, by bus, node and entry, and how many others of a bus change. Of signals that were not chosen, the
    /// first ones of each bus that change are shown.
    pub(crate) fn shown(mut self, most: usize) -> (Vec<SignalPlot>, BTreeMap<usize, usize>) {
        let is_chosen = !self.choices.is_empty();
        self.signals.retain(|plot| {
            let changes = plot.numbers.extremes().is_some_and(|[min, _, max]| min < max);
            changes || is_chosen && plot.numbers.count() > 0
        });
        self.signals.sort_by_key(|plot| (plot.bus, plot.node_id, plot.index, plot.sub));
        if is_chosen {
            return (self.signals, BTreeMap::new());
        }
        let mut counts = BTreeMap::new();
        self.signals.retain(|plot| {
            let number = counts.entry(plot.bus).or_insert(0);
            *number += 1;
            *number <= most
        });
        counts.values_mut().for_each(|count: &mut usize| *count = count.saturating_sub(most));
        (self.signals, counts)
    }
}

/// The value as a number, in its unit if it has one.
fn number(signal: &PdoSignal<'_>) -> Option<f64> {
    let scaled = || signal.scaled.as_deref()?.parse().ok();
    let value = || {
        let value = signal.value.as_ref()?;
        value.as_real().or_else(|| Some(value.as_integer()? as f64))
    };
    scaled().or_else(value).or_else(|| Some(signal.raw? as f64)).filter(|number: &f64| number.is_finite())
}

/// What a value means: of a text such as `7 (state: on, bit 1)` the state, else all in brackets.
fn meaning<'s>(signal: &'s PdoSignal<'_>) -> Option<&'s str> {
    let words = signal.text.split_once(" (").filter(|_| signal.scaled.is_none() && signal.unit.is_empty());
    let (_, words) = words?;
    let words = words.strip_suffix(')')?;
    let (first, _) = words.split_once(", ").unwrap_or((words, ""));
    Some(first.split_once(": ").map_or(words, |(_, state)| state))
}
