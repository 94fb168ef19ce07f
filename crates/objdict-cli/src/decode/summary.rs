//! Sums over the frames of logs.

use std::io::{self, Write};

use serde::Serialize;

use super::super::args::{DecodeFormat, FrameFilterArgs};
use super::super::ending::{Failure, Outcome};
use super::super::stdout::Output;
use super::super::table::{TextTable, fit};
use super::incidents::{self, LINE};
use super::{KnownFindings, Logs, each_frame};
use objdict_model::diagnostic::plural;
use objdict_model::json::Version;
use objdict_traffic as traffic;
use objdict_traffic::{Bus, BusReport, BusSums, Buses, Incident, IncidentState, NodeEvent, Recording};

/// The most characters of a cell.
const CELL: usize = 60;

/// The most events of a kind that the text shows.
const EVENTS: usize = 20;

/// The sums over logs.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct TrafficSummaryJson {
    /// The version of the document.
    version: Version<1>,
    /// The logs as they were given.
    logs: Vec<String>,
    /// The number of lines that are not understood.
    bad_lines: u64,
    /// What went wrong in one line.
    verdict: String,
    /// What went wrong: first what is unresolved, then what is over, then warnings.
    incidents: Vec<Incident>,
    /// How many incidents a baseline has, which are not listed; absent for none.
    #[serde(skip_serializing_if = "is_none")]
    known: usize,
    /// The buses, by the channels of the logs.
    buses: Vec<BusReport>,
}

const fn is_none(count: &usize) -> bool {
    *count == 0
}

/// The sums over all frames that pass the filters, which are also recorded if a page is wanted. `watch` sees those of a bus, at its position,
/// after each frame.
pub(super) fn gather(
    args: &FrameFilterArgs,
    bit_rate: Option<u16>,
    buses: &mut Buses<'_>,
    logs: &mut Logs,
    mut recording: Option<&mut Recording>,
    mut watch: impl FnMut(usize, &BusSums, &Bus<'_>),
) -> Result<TrafficSummaryJson, Failure> {
    let mut sums: Vec<BusSums> = Vec::new();
    each_frame(args, buses, logs, |shown| {
        while sums.len() <= shown.at {
            sums.push(BusSums::new(bit_rate.or(shown.bus.descriptions.bit_rate)));
        }
        sums[shown.at].add(&shown.decoded, shown.frame, shown.origin, shown.bus);
        if let Some(recording) = &mut recording {
            recording.add(&shown.decoded, shown.frame, shown.at, shown.bus);
        }
        watch(shown.at, &sums[shown.at], shown.bus);
        Ok(())
    })?;
    let mut reports: Vec<BusReport> =
        sums.iter_mut().zip(&buses.all).map(|(sums, bus)| sums.report(bus)).collect();
    let incidents = traffic::incidents(&mut reports);
    Ok(TrafficSummaryJson {
        version: Version,
        logs: logs.0.iter().map(|log| log.name.clone()).collect(),
        bad_lines: logs.0.iter().map(|log| log.reader.bad_count()).sum(),
        verdict: traffic::verdict(&incidents),
        incidents,
        known: 0,
        buses: reports,
    })
}

impl TrafficSummaryJson {
    /// Leaves out the incidents that are known.
    pub(super) fn sift(&mut self, known: &mut KnownFindings) {
        let log = self.logs.first().map_or("", String::as_str);
        self.known = known.sift_incidents(log, &mut self.incidents);
        self.verdict = traffic::verdict(&self.incidents);
    }

    /// The logs as they were given.
    pub(super) fn logs(&self) -> &[String] {
        &self.logs
    }

    /// The sums of each bus.
    pub(super) fn buses(&self) -> &[BusReport] {
        &self.buses
    }

    /// Whether an incident is unresolved.
    pub(super) fn outcome(&self) -> Outcome {
        let is_unresolved = self.incidents.iter().any(|incident| incident.state == IncidentState::Unresolved);
        if is_unresolved { Outcome::Findings } else { Outcome::Clean }
    }

    /// What went wrong.
    pub(super) fn incidents(&self) -> &[Incident] {
        &self.incidents
    }

    /// The same with one incident.
    pub(super) fn only(&mut self, number: usize) -> Result<&Self, Failure> {
        incidents::one(number, &self.incidents)?;
        self.incidents.retain(|incident| incident.number == number);
        Ok(self)
    }

    /// What went wrong in one line.
    pub(super) fn verdict(&self) -> &str {
        &self.verdict
    }

    pub(super) fn write(&self, format: DecodeFormat, out: &mut Output) -> Result<(), Failure> {
        if format == DecodeFormat::Json {
            out.pretty_json(self)?;
            return Ok(());
        }
        incidents::write(&self.verdict, &self.incidents, out)?;
        if self.known > 0 {
            writeln!(out, "\n{} of the baseline", plural(self.known, "known incident"))?;
        }
        for bus in &self.buses {
            writeln!(out)?;
            write_bus(bus, out)?;
        }
        Ok(())
    }
}

/// The headings of the nodes.
pub(super) const NODES: [&str; 10] =
    ["Node", "Name", "Frames", "Frames/s", "Load", "State", "Boot-ups", "Lost", "EMCY", "Aborts"];

/// The headings of the messages.
pub(super) const MESSAGES: [&str; 8] =
    ["CAN-ID", "Message", "Frames", "Min ms", "Mean ms", "Max ms", "Jitter ms", "Described"];

fn write_bus(bus: &BusReport, out: &mut Output) -> io::Result<()> {
    writeln!(out, "{}\n{}\n", title(bus), kinds(bus))?;
    let mut nodes = TextTable::new(NODES, CELL);
    node_rows(bus).for_each(|row| nodes.row(row));
    nodes.write(out)?;
    writeln!(out)?;
    let mut messages = TextTable::new(MESSAGES, CELL);
    message_rows(bus).for_each(|row| messages.row(row));
    messages.write(out)?;
    events("Aborted transfers", &bus.aborted_transfers, out)?;
    events("Emergencies", &bus.emergencies, out)?;
    if bus.further_events > 0 {
        writeln!(out, "\nand {}", plural(count(bus.further_events), "further event"))?;
    }
    for (title, lines) in remarks(bus) {
        writeln!(out, "\n{title}")?;
        for line in lines {
            writeln!(out, "  {}", fit(&line, LINE))?;
        }
    }
    Ok(())
}

/// The channel with its frames and their time.
pub(super) fn title(bus: &BusReport) -> String {
    let channel = if bus.channel.is_empty() { String::new() } else { format!("{}: ", bus.channel) };
    let load = bus.load.map_or_else(String::new, |load| format!(", {load:.2} % load"));
    let (from, to, rate) = (&bus.from, &bus.to, bus.frames_per_second);
    let frames = plural(count(bus.frames), "frame");
    format!("{channel}{frames} from {from} to {to}, {rate:.1} frames/s{load}")
}

/// The number of frames of each kind.
pub(super) fn kinds(bus: &BusReport) -> String {
    let kinds = bus.kinds.iter().map(|kind| format!("{} {}", kind.kind, kind.frames));
    let errors = (bus.error_frames > 0).then(|| plural(count(bus.error_frames), "error frame"));
    kinds.chain(errors).collect::<Vec<_>>().join(", ")
}

/// The cells of the nodes, below [`NODES`].
pub(super) fn node_rows(bus: &BusReport) -> impl Iterator<Item = [String; 10]> {
    let some = |count: u64| if count == 0 { String::new() } else { count.to_string() };
    bus.nodes.iter().map(move |node| {
        [
            if node.node == 0 { "-".to_owned() } else { node.node.to_string() },
            node.name.clone().unwrap_or_default(),
            node.frames.to_string(),
            format!("{:.1}", node.frames_per_second),
            node.load.map_or_else(String::new, |load| format!("{load:.2} %")),
            node.state.clone().unwrap_or_default(),
            some(node.boot_ups),
            some(node.lost_heartbeats),
            some(node.emergencies),
            some(node.aborted_transfers),
        ]
    })
}

/// The cells of the messages, below [`MESSAGES`].
pub(super) fn message_rows(bus: &BusReport) -> impl Iterator<Item = [String; 8]> {
    bus.messages.iter().map(|message| {
        let width = if message.extended { 8 } else { 3 };
        let name = if message.name.is_empty() { message.kind } else { &message.name };
        let [min, mean, max, jitter] = match &message.cycle {
            Some(cycle) => [&cycle.min, &cycle.mean, &cycle.max, &cycle.jitter].map(Clone::clone),
            None => Default::default(),
        };
        [
            format!("{:0width$X}", message.can_id),
            name.to_owned(),
            message.frames.to_string(),
            min,
            mean,
            max,
            jitter,
            message.described.clone().unwrap_or_default(),
        ]
    })
}

/// What was configured, and the nodes without a description: titles with what is below them.
pub(super) fn remarks(bus: &BusReport) -> impl Iterator<Item = (String, Vec<String>)> {
    let configurations = bus.configurations.iter().map(|node| {
        let entries = if node.written == 1 { "entry" } else { "entries" };
        let title =
            format!("{}: {} {entries} written, {} as described", node.name, node.written, node.as_described);
        let missing = node.not_written.iter();
        let missing =
            missing.map(|entry| format!("{entry} is configured in the description and was not written"));
        (title, node.others.iter().cloned().chain(missing).collect())
    });
    let nodes: Vec<String> = bus.undescribed.iter().map(ToString::to_string).collect();
    let undescribed = (!nodes.is_empty())
        .then(|| (format!("Nodes without a description: {}", nodes.join(", ")), Vec::new()));
    configurations.chain(undescribed)
}

fn events(title: &str, events: &[NodeEvent], out: &mut Output) -> io::Result<()> {
    if events.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{title}:")?;
    for NodeEvent { moment, text, .. } in events.iter().take(EVENTS) {
        writeln!(out, "  {}  {}", moment.time, fit(text, LINE))?;
    }
    if events.len() > EVENTS {
        writeln!(out, "  and {} more", events.len() - EVENTS)?;
    }
    Ok(())
}

fn count(number: u64) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
