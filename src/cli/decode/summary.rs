//! Sums over the frames of logs.

use std::io::{self, Write};

use serde::Serialize;

use super::super::args::{DecodeArgs, DecodeFormat};
use super::super::input::source_name;
use super::super::outcome::Failure;
use super::super::output::Output;
use super::super::table::{Table, fit};
use super::{Logs, each_frame};
use crate::json::{self, Version};
use crate::report::plural;
use crate::traffic::{BusReport, BusSums, Buses, NodeEvent};

/// The version of the JSON document, see docs/json.md.
const VERSION: u32 = 1;

/// The most characters of a cell.
const CELL: usize = 60;

/// The most characters of a line.
const LINE: usize = 200;

/// The most events of a kind that the text shows.
const EVENTS: usize = 20;

/// The sums over logs.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(in crate::cli) struct Document {
    /// The version of the document.
    version: Version<VERSION>,
    /// The logs as they were given.
    logs: Vec<String>,
    /// The number of lines that are not understood.
    bad_lines: u64,
    /// The buses, by the channels of the logs.
    buses: Vec<BusReport>,
}

pub(super) fn run(
    args: &DecodeArgs,
    buses: &mut Buses<'_>,
    logs: &mut Logs,
    out: &mut Output,
) -> Result<(), Failure> {
    let reports = reports(args, buses, logs)?;
    let document = Document {
        version: Version,
        logs: args.logs.iter().map(|path| source_name(path)).collect(),
        bad_lines: logs.0.iter().map(|log| log.reader.bad_count()).sum(),
        buses: reports,
    };
    if args.format == DecodeFormat::Json {
        json::write_pretty(&mut out.raw()?, &document)?;
        writeln!(out)?;
        return Ok(());
    }
    for (at, bus) in document.buses.iter().enumerate() {
        if at > 0 {
            writeln!(out)?;
        }
        bus.write(out)?;
    }
    Ok(())
}

/// The sums of each bus.
pub(super) fn reports(
    args: &DecodeArgs,
    buses: &mut Buses<'_>,
    logs: &mut Logs,
) -> Result<Vec<BusReport>, Failure> {
    let mut sums: Vec<BusSums> = Vec::new();
    each_frame(args, buses, logs, |shown| {
        while sums.len() <= shown.at {
            sums.push(BusSums::new(args.bit_rate.or(shown.bus.descriptions.bit_rate)));
        }
        sums[shown.at].add(&shown.decoded, shown.frame, shown.origin, shown.bus);
        Ok(())
    })?;
    Ok(sums.iter_mut().zip(&buses.all).map(|(sums, bus)| sums.report(bus)).collect())
}

impl BusReport {
    fn write(&self, out: &mut Output) -> io::Result<()> {
        let channel = if self.channel.is_empty() { String::new() } else { format!("{}: ", self.channel) };
        let load = self.load.map_or_else(String::new, |load| format!(", {load:.2} % load"));
        let (from, to, rate) = (&self.from, &self.to, self.frames_per_second);
        writeln!(
            out,
            "{channel}{} from {from} to {to}, {rate:.1} frames/s{load}",
            plural(count(self.frames), "frame")
        )?;
        let kinds = self.kinds.iter().map(|kind| format!("{} {}", kind.kind, kind.frames));
        let errors = (self.error_frames > 0).then(|| plural(count(self.error_frames), "error frame"));
        let kinds: Vec<String> = kinds.chain(errors).collect();
        writeln!(out, "{}\n", kinds.join(", "))?;
        self.nodes(out)?;
        self.messages(out)?;
        events("Lost heartbeats", &self.lost_heartbeats, out)?;
        events("Aborted transfers", &self.aborted_transfers, out)?;
        events("Emergencies", &self.emergencies, out)?;
        events("Not as described", &self.deviations, out)?;
        if self.further_events > 0 {
            writeln!(out, "\nand {}", plural(count(self.further_events), "further event"))?;
        }
        self.configurations(out)?;
        if !self.undescribed.is_empty() {
            let nodes: Vec<String> = self.undescribed.iter().map(ToString::to_string).collect();
            writeln!(out, "\nNodes without a description: {}", nodes.join(", "))?;
        }
        Ok(())
    }

    fn nodes(&self, out: &mut Output) -> io::Result<()> {
        let headings =
            ["Node", "Name", "Frames", "Frames/s", "Load", "State", "Boot-ups", "Lost", "EMCY", "Aborts"];
        let mut table = Table::new(headings, CELL);
        let some = |count: u64| if count == 0 { String::new() } else { count.to_string() };
        for node in &self.nodes {
            table.row([
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
            ]);
        }
        table.write(out)
    }

    fn messages(&self, out: &mut Output) -> io::Result<()> {
        writeln!(out)?;
        let headings =
            ["CAN-ID", "Message", "Frames", "Min ms", "Mean ms", "Max ms", "Jitter ms", "Described"];
        let mut table = Table::new(headings, CELL);
        for message in &self.messages {
            let width = if message.extended { 8 } else { 3 };
            let name = if message.name.is_empty() { message.kind } else { &message.name };
            let [min, mean, max, jitter] = match &message.cycle {
                Some(cycle) => [&cycle.min, &cycle.mean, &cycle.max, &cycle.jitter].map(Clone::clone),
                None => Default::default(),
            };
            table.row([
                format!("{:0width$X}", message.can_id),
                name.to_owned(),
                message.frames.to_string(),
                min,
                mean,
                max,
                jitter,
                message.described.clone().unwrap_or_default(),
            ]);
        }
        table.write(out)
    }

    fn configurations(&self, out: &mut Output) -> io::Result<()> {
        for node in &self.configurations {
            let entries = if node.written == 1 { "entry" } else { "entries" };
            writeln!(
                out,
                "\n{}: {} {entries} written, {} as described",
                node.name, node.written, node.as_described
            )?;
            for other in &node.others {
                writeln!(out, "  {}", fit(other, LINE))?;
            }
            for entry in &node.not_written {
                writeln!(out, "  {} is configured in the description and was not written", fit(entry, LINE))?;
            }
        }
        Ok(())
    }
}

fn events(title: &str, events: &[NodeEvent], out: &mut Output) -> io::Result<()> {
    if events.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{title}:")?;
    for NodeEvent { moment, text, rule, .. } in events.iter().take(EVENTS) {
        let rule = rule.map_or_else(String::new, |rule| format!(" [{}]", rule.id));
        writeln!(out, "  {}  {}{rule}", moment.time, fit(text, LINE))?;
    }
    if events.len() > EVENTS {
        writeln!(out, "  and {} more", events.len() - EVENTS)?;
    }
    Ok(())
}

fn count(number: u64) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
