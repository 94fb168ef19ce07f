//! Logs as a page: a time line, plots, and the sums.

use std::collections::BTreeMap;
use std::path::Path;

use super::super::args::DecodeArgs;
use super::super::input::name_of;
use super::super::outcome::{Failure, note};
use super::super::save::save;
use super::Logs;
use super::summary::reports;
use crate::document::{
    BusTraffic, PlotPoint, PlotValues, TrafficLane, TrafficPage, TrafficPlot, TrafficTable,
};
use crate::report::plural;
use crate::traffic::{Bucket, Bus, BusReport, Buses, Lanes, PlotChoice, Plots, Series, SignalPlot, rows};

/// The most plots of a bus where none is chosen.
const PLOTS: usize = 8;

/// The most events that are listed.
const EVENTS: usize = 1000;

pub(super) fn run(
    args: &DecodeArgs,
    buses: &mut Buses<'_>,
    logs: &mut Logs,
    path: &Path,
) -> Result<(), Failure> {
    let choices = args.plot.iter().map(|text| PlotChoice::new(text)).collect();
    let points = usize::try_from(args.points).unwrap_or(usize::MAX);
    let mut plots = Plots::new(choices, points);
    let mut lanes = Lanes::new(points);
    let reports = reports(args, buses, logs, |shown| {
        plots.add(&shown.decoded, shown.frame, shown.at, shown.bus);
        lanes.add(&shown.decoded, shown.frame, shown.at);
    })?;
    for choice in plots.unfound() {
        note(&format!("note: no frame has the signal `{}`\n", choice.text));
    }
    let (signals, further) = plots.shown(PLOTS);
    let mut signals_of: BTreeMap<usize, Vec<SignalPlot>> = BTreeMap::new();
    signals.into_iter().for_each(|signal| signals_of.entry(signal.bus).or_default().push(signal));
    let of_bus = |(at, (report, bus)): (usize, (&BusReport, &Bus<'_>))| BusTraffic {
        name: bus.channel.clone(),
        summary: report.sentence(),
        span: report.span,
        from: report.from.clone(),
        lanes: of_lanes(&lanes, at, report, bus),
        plots: signals_of.remove(&at).into_iter().flatten().map(|signal| of_signal(signal, bus)).collect(),
        further_plots: further.get(&at).copied().unwrap_or(0),
        tables: tables(report),
    };
    let names: Vec<String> = args.logs.iter().map(|path| name_of(path)).collect();
    let buses = reports.iter().zip(&buses.all).enumerate().map(of_bus).collect();
    save(path, TrafficPage { title: names.join(", "), buses }.html().as_bytes())?;
    Ok(())
}

/// What each node sent, and what happened to it.
fn of_lanes(lanes: &Lanes, at: usize, report: &BusReport, bus: &Bus<'_>) -> Vec<TrafficLane> {
    let own = lanes.all.range((at, 0)..=(at, u8::MAX));
    own.map(|(&(_, node_id), lane)| {
        let events = report.events().into_iter().flat_map(|(_, events)| events);
        let events = events.filter(|event| event.node == node_id && node_id != 0);
        TrafficLane {
            name: if node_id == 0 { "no node".to_owned() } else { bus.reader.name(node_id) },
            frames: lane.frames.iter().map(|(kind, series)| (*kind, times(series))).collect(),
            states: words(&lane.states.series, &lane.states.words)
                .map(|(time, word, _)| (time, word))
                .collect(),
            events: events
                .map(|event| {
                    (event.moment.time.nanoseconds(), format!("{}: {}", event.moment.time, event.text))
                })
                .collect(),
        }
    })
    .collect()
}

fn times(series: &Series) -> Vec<i64> {
    series.buckets().map(|bucket| bucket.first).collect()
}

/// What values meant, each from its time on.
fn words<'s>(series: &'s Series, words: &'s [String]) -> impl Iterator<Item = (i64, String, bool)> + 's {
    series.buckets().map(|bucket| {
        // the position of a word in the list is not negative
        let word = words.get(bucket.value as usize).cloned().unwrap_or_default();
        (bucket.first, word, bucket.min < bucket.max)
    })
}

fn of_signal(signal: SignalPlot, bus: &Bus<'_>) -> TrafficPlot {
    let SignalPlot { node_id, index, sub, name, unit, numbers, meanings, .. } = signal;
    let values = match meanings {
        Some(meanings) => PlotValues::Words(words(&meanings.series, &meanings.words).collect()),
        None => PlotValues::Numbers(numbers.buckets().map(point).collect()),
    };
    let node = bus.reader.name(node_id);
    TrafficPlot {
        name: format!("{node} {index:04X}:{sub:02X} {name}").trim_end().to_owned(),
        unit,
        count: numbers.count(),
        extremes: numbers.extremes().unwrap_or_default(),
        values,
    }
}

fn point(bucket: &Bucket) -> PlotPoint {
    let Bucket { first, last, min, max, value } = *bucket;
    PlotPoint { times: [first, last], numbers: [min, max, value] }
}

fn tables(report: &BusReport) -> Vec<TrafficTable> {
    let events = report.events().into_iter().map(|(title, events)| {
        let listed = events.iter().take(EVENTS).map(|event| {
            let rule = event.rule.map_or_else(String::new, |rule| rule.id.to_owned());
            vec![event.moment.time.to_string(), event.moment.line.to_string(), event.text.clone(), rule]
        });
        let more = events.len().saturating_sub(EVENTS);
        let more = (more > 0)
            .then(|| vec![String::new(), String::new(), plural(more, "further event"), String::new()]);
        TrafficTable::new(title, &["Time", "Line", "What", "Rule"], listed.chain(more).collect())
    });
    let nodes = TrafficTable::new("Nodes", &rows::NODES, report.node_rows().map(Vec::from).collect());
    let messages =
        TrafficTable::new("Messages", &rows::MESSAGES, report.message_rows().map(Vec::from).collect());
    events.chain([nodes, messages]).collect()
}
