//! Logs of buses, read with the open descriptions.

use std::borrow::Cow;
use std::path::Path;

use objdict::describe::frames::FrameKind;
use objdict::document::{TrafficCourse, TrafficPlot};
use objdict::format::log::{LogForm, LogOptions, LogReader, LoggedFrame};
use objdict::traffic::{
    BusReport, BusSums, Buses, Descriptions, Incident, MergedLogs, NamedLog, PlotChoice, Recording, findings,
    incidents, verdict,
};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::answer::{Answer, BadRequest, data};
use crate::document::text_report;

/// So many frames are kept as rows; sums and findings are over all.
const MAX_ROWS: usize = 500_000;

/// So many points are kept of each plot; of more, neighbours become one.
const MAX_POINTS: usize = 600;

/// A log, and what was read of it last.
#[derive(Debug)]
pub(crate) struct Log {
    name: String,
    bytes: Vec<u8>,
    form: LogForm,
    rows: Vec<LogRow>,
    /// The filter that was asked for last, and the positions of the rows that pass it.
    passing: Option<(Filter, Vec<usize>)>,
}

/// A frame in words.
#[derive(Debug)]
struct LogRow {
    /// Since the first frame.
    seconds: f64,
    line: u64,
    node: Option<u8>,
    kind: FrameKind,
    /// Time, channel, CAN-ID, data and words, with tabs between them: one text takes less memory than five.
    text: Box<str>,
}

/// Which frames are shown: all of an empty list.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Filter {
    #[serde(default)]
    nodes: Vec<u8>,
    #[serde(default)]
    kinds: Vec<String>,
    /// What the row has somewhere, in any case.
    #[serde(default)]
    text: String,
}

impl Filter {
    fn passes(&self, row: &LogRow, text: &str) -> bool {
        (self.nodes.is_empty() || row.node.is_some_and(|node| self.nodes.contains(&node)))
            && (self.kinds.is_empty() || self.kinds.iter().any(|kind| kind == row.kind.name()))
            && (text.is_empty() || row.text.to_lowercase().contains(text))
    }
}

/// What a page shows of a log beside its frames.
#[derive(Debug, Serialize)]
struct LogSummary {
    form: &'static str,
    /// The number of frames that are kept as rows.
    rows: usize,
    verdict: String,
    incidents: Vec<Incident>,
    plots: Vec<Value>,
    buses: Vec<BusReport>,
    /// How descriptions without a node-ID found their nodes.
    notes: Vec<String>,
    bad_lines: Vec<(u64, Cow<'static, str>)>,
    bad_count: u64,
}

impl Log {
    /// The log in a file; `None` if its start is in no form of logs.
    pub(crate) fn open(name: &str, bytes: &[u8]) -> Option<Self> {
        const FIRST_LINES: u64 = 100;
        let mut reader = LogReader::new(bytes, LogOptions::default());
        // a text of other lines is read to its end in vain, so not all of it
        let start = reader.next_frame().ok()??;
        let is_log = reader.line() <= FIRST_LINES && !(start.is_error && reader.bad_count() > 0);
        let form = reader.form().filter(|_| is_log)?;
        let (name, bytes) = (name.to_owned(), bytes.to_vec());
        Some(Self { name, bytes, form, rows: Vec::new(), passing: None })
    }

    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// What a page shows of it at first.
    pub(crate) fn state(&self) -> Value {
        json!({
            "name": self.name, "kind": "log", "format": self.form.name(), "encoding": "", "text": "", "is_read_only": true,
            "is_changed": false, "can_undo": false, "can_redo": false, "revision": 0, "devices": 0,
        })
    }

    fn reader(&self) -> MergedLogs<&[u8]> {
        MergedLogs(vec![NamedLog::new(self.name.clone(), self.bytes.as_slice(), LogOptions::default())])
    }

    /// Reads all frames with descriptions of nodes.
    pub(crate) fn decode(&mut self, descriptions: &Descriptions, plots: &[String]) -> Answer {
        let failed = |error| BadRequest::new(format_args!("cannot read the log: {error}"));
        let mut buses = Buses::new(&[], descriptions);
        let notes =
            if buses.is_open() { buses.find(&mut self.reader()).map_err(failed)? } else { Vec::new() };
        let (mut rows, mut sums): (Vec<LogRow>, Vec<BusSums>) = (Vec::new(), Vec::new());
        let choices: Vec<PlotChoice> = plots.iter().filter_map(|text| text.parse().ok()).collect();
        let mut recording = Recording::new(&choices, MAX_POINTS);
        let mut first = None;
        let mut logs = self.reader();
        while let Some((log, frame)) = logs.next_frame().map_err(failed)? {
            let at = buses.of(log, &frame, &logs);
            let bus = &mut buses.all[at];
            let decoded = bus.decode(&frame);
            while sums.len() <= at {
                sums.push(BusSums::new(descriptions.bit_rate));
            }
            let origin = logs.origin(log);
            sums[at].add(&decoded, &frame, origin, bus);
            recording.add(&decoded, &frame, at, bus);
            let seconds = seconds(frame.time.nanoseconds(), *first.get_or_insert(frame.time.nanoseconds()));
            if rows.len() < MAX_ROWS {
                let text = text(&frame, &bus.channel, &bus.words(&decoded, &frame));
                rows.push(LogRow {
                    seconds,
                    line: origin.line,
                    node: decoded.node_id,
                    kind: decoded.kind,
                    text,
                });
            }
        }
        let plots = recording.plots(&buses).iter().map(|plot| plotted(plot, first.unwrap_or(0))).collect();
        let mut buses: Vec<BusReport> =
            sums.iter_mut().zip(&buses.all).map(|(sums, bus)| sums.report(bus)).collect();
        let (lines, found) = findings(&buses, 0, self.name.clone());
        let report = text_report(&lines, found)?;
        let incidents = incidents(&mut buses);
        let reader = &logs.0[0].reader;
        let summary = LogSummary {
            form: self.form.name(),
            rows: rows.len(),
            verdict: verdict(&incidents),
            incidents,
            plots,
            buses,
            notes,
            bad_lines: reader.bad_lines().iter().map(|bad| (bad.line, bad.reason.clone())).collect(),
            bad_count: reader.bad_count(),
        };
        (self.rows, self.passing) = (rows, None);
        let summary = data(summary)?;
        let rest = summary.strip_prefix('{').unwrap_or_default();
        Ok(format!("{{\"report\":{report},{rest}"))
    }

    /// Some of the rows that pass a filter, from one on; `line` asks where the first one is that is not before this line.
    pub(crate) fn rows(&mut self, filter: &Filter, first: usize, count: usize, line: Option<u64>) -> Value {
        if self.passing.as_ref().is_none_or(|(known, _)| known != filter) {
            let text = filter.text.trim().to_lowercase();
            let passing = self.rows.iter().enumerate().filter(|(_, row)| filter.passes(row, &text));
            self.passing = Some((filter.clone(), passing.map(|(at, _)| at).collect()));
        }
        let passing = self.passing.as_ref().map_or(&[][..], |(_, passing)| passing.as_slice());
        let first = match line {
            Some(line) => passing.partition_point(|&at| self.rows[at].line < line),
            None => first,
        };
        let shown = passing.iter().skip(first).take(count).map(|&at| {
            let LogRow { seconds, line, node, kind, text } = &self.rows[at];
            json!({ "seconds": seconds, "line": line, "node": node, "kind": kind.name(), "cells": text.split('\t').collect::<Vec<_>>() })
        });
        json!({ "total": passing.len(), "first": first, "rows": shown.collect::<Vec<_>>() })
    }
}

/// The seconds from one time to another, both in nanoseconds.
fn seconds(time: i64, first: i64) -> f64 {
    time.saturating_sub(first) as f64 / 1e9
}

/// A plot with times in seconds since the first frame: numbers as `[from, to, least, greatest, last]`, words as `[from, to, word]`.
fn plotted(plot: &TrafficPlot<'_>, first: i64) -> Value {
    let (points, runs, words) = match plot.course {
        TrafficCourse::Numbers(curve) => {
            let point = |bucket: &objdict::document::CurveBucket| {
                json!([
                    seconds(bucket.from, first),
                    seconds(bucket.to, first),
                    bucket.min,
                    bucket.max,
                    bucket.last
                ])
            };
            (curve.buckets().iter().map(point).collect(), Vec::new(), &[][..])
        }
        TrafficCourse::States(bands) => {
            let run = |run: &objdict::document::BandRun| {
                json!([seconds(run.from, first), seconds(run.to, first), run.last])
            };
            (Vec::new(), bands.runs().iter().map(run).collect::<Vec<Value>>(), bands.words())
        }
    };
    let points: Vec<Value> = points;
    json!({ "name": plot.name, "unit": plot.unit, "points": points, "runs": runs, "words": words })
}

/// The cells of a frame, as `objdict decode` prints them.
fn text(frame: &LoggedFrame, channel: &str, words: &str) -> Box<str> {
    let data = match frame.is_remote {
        true => "remote".to_owned(),
        false => frame.data().iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" "),
    };
    let width = if frame.is_extended { 8 } else { 3 };
    let words = words.replace(['\t', '\n'], " ");
    format!("{}\t{channel}\t{:0width$X}\t{data}\t{words}", frame.time, frame.can_id).into()
}

/// Adds a device to what describes the nodes of a log.
pub(crate) fn describe(descriptions: &mut Descriptions, device: &objdict::model::Device, name: &str) {
    descriptions.add_device(device.clone(), None, Path::new(name), name.to_owned());
}
