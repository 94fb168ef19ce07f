//! `objdict network diff`: what both networks show, what their nodes are sent and have, and where none of that differs,
//! what is built of them. So nothing is printed only if every output is the same.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::path::Path;
use std::slice;

use super::super::annotation::DescribedStream;
use super::super::args::NetworkDiffArgs;
use super::super::changes::address;
use super::super::dcf::differences;
use super::super::ending::{Failure, Outcome};
use super::super::stdout::Output;
use super::{open_to_use, timing};
use objdict_lint::changes::{DeviceChange, compare};
use objdict_model::diagnostic::{one_line, plural};
use objdict_model::model::{Device, DeviceKind, PdoKind};
use objdict_network::{
    BootPlan, Compiled, DcfgenMode, End, LelyOptions, Network, NodeRow, Overview, Service, Slave, Timing,
    TimingOptions,
};
use objdict_network_file::{Build, BuildError, BuiltFile, ConfiguredNode, NetworkFile};
use objdict_node::download::{ConciseDcf, Differences};
use objdict_project::line_diff::changes;

/// A network in lines, by what they are about.
type DiffSections = BTreeMap<(SectionOrder, String), Vec<String>>;

/// The order of the sections.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum SectionOrder {
    Bus,
    Nodes,
    Messages,
    Boot,
}

/// One of the networks.
struct ComparedNetwork<'f> {
    network: &'f Network,
    compiled: &'f Compiled,
    overview: Overview,
    build: Build<'f>,
    /// The nodes as their DCFs describe them, without what the sections have.
    nodes: Vec<ConfiguredNode>,
}

pub(super) fn run(args: &NetworkDiffArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let open = |path| open_to_use(slice::from_ref(path), &args.input);
    let files = [open(&args.first)?, open(&args.second)?];
    let [first, second] = [ComparedNetwork::new(&files[0])?, ComparedNetwork::new(&files[1])?];
    let (before, after) = (first.sections(), second.sections());
    let mut changed = BTreeSet::new();
    let none = Vec::new();
    let titles: BTreeSet<_> = before.keys().chain(after.keys()).collect();
    for section in titles {
        let old = before.get(section).unwrap_or(&none);
        let new = after.get(section).unwrap_or(&none);
        if !lines(&section.1, old, new, out)? {
            changed.insert(section.0);
        }
    }
    let mut is_same = changed.is_empty();
    for node in &first.nodes {
        if let Some(other) = second.nodes.iter().find(|other| other.name == node.name) {
            let sent = first.sends(node, &second, other, out)?;
            is_same &= sent.is_empty();
            is_same &= has(node, other, &sent, changed.contains(&SectionOrder::Boot), out)?;
            let title = format!("description of {}", one_line(&node.name));
            is_same &= lines(&title, &information(&node.device), &information(&other.device), out)?;
        }
    }
    // what no section is about
    let is_same = is_same && outputs(&first.outputs()?, &second.outputs()?, out)?;
    Ok(if is_same { Outcome::Clean } else { Outcome::Findings })
}

impl<'f> ComparedNetwork<'f> {
    fn new(file: &'f NetworkFile) -> Result<Self, Failure> {
        let build = file.build(DcfgenMode::Corrected).map_err(Failure::new)?;
        let (Some(network), Some(compiled)) = (file.network(), file.compiled()) else {
            return Err(Failure::new("the file does not describe a network"));
        };
        // what cannot be built is compared with the outputs
        let mut nodes = build.configured_nodes().unwrap_or_default();
        for ConfiguredNode { device, .. } in &mut nodes {
            device.kind = DeviceKind::Node;
            if let Some(node) = &mut device.commissioning {
                (node.node_id, node.node_name, node.baud_rate, node.network_name, node.manager) =
                    Default::default();
            }
        }
        Ok(Self { network, compiled, overview: Overview::new(network, compiled), build, nodes })
    }

    fn sections(&self) -> DiffSections {
        let Self { network, overview, .. } = self;
        let mut sections = DiffSections::new();
        let bus = overview.name.iter().map(|name| format!("name {name}"));
        let bus = bus.chain(overview.bit_rate.map(|rate| format!("{rate} kbit/s")));
        let folder = Some(&network.run_time_folder).filter(|folder| !folder.is_empty());
        let bus = bus.chain(folder.map(|folder| format!("run-time folder {folder}")));
        sections.insert((SectionOrder::Bus, "bus".to_owned()), bus.collect());
        let nodes = overview.nodes.iter().map(|row| self.node(row));
        sections.insert((SectionOrder::Nodes, "nodes".to_owned()), nodes.collect());
        sections.insert((SectionOrder::Messages, "CAN-IDs".to_owned()), self.messages().collect());
        if let Some(plan) = &overview.boot {
            boot(plan, &mut sections);
        }
        sections
    }

    fn node(&self, row: &NodeRow) -> String {
        let node_id = row.node_id.map_or_else(|| "?".to_owned(), |node_id| node_id.to_string());
        let manager = if row.is_manager { ", manager" } else { "" };
        // the name of the file may differ
        let file = &self.network.nodes[row.position].file.value;
        let description = if *file == row.description { "" } else { &row.description };
        format!("{node_id} {}: {description}{manager}", row.name)
    }

    fn messages(&self) -> impl Iterator<Item = String> {
        self.overview.messages.iter().flat_map(|message| {
            // what other services send is of a fixed length
            let has_length = |end: &End| matches!(end.service, Service::Pdo(_) | Service::Sync);
            let ends = || message.senders.iter().chain(&message.receivers);
            let length = match (message.bytes.filter(|_| ends().any(has_length)), message.lengths.as_slice())
            {
                (None, _) => String::new(),
                (Some(bytes), []) => format!(", {}", plural(bytes.into(), "byte")),
                (Some(_), _) => format!(", {} bytes", message.length()),
            };
            // the period of a PDO follows from its trigger
            let is_cyclic = |end: &End| !matches!(end.service, Service::Pdo(_));
            let period = message.period.filter(|_| message.senders.iter().all(is_cyclic));
            let period = period
                .map(|period| format!(", every {}", timing::milliseconds(period * 1000)))
                .unwrap_or_default();
            let line = move |verb: &str, end: &End| {
                format!("{} {verb} {end}: {}{period}{length}", message.can_id, message.trigger)
            };
            // these follow from the node-IDs
            let follows =
                |end: &&End| matches!(end.service, Service::Nmt | Service::SdoRequest | Service::SdoResponse);
            let sent = message.senders.iter().filter(move |end| !follows(end));
            let sent: Vec<_> = sent.map(|end| line("from", end)).collect();
            let received = message.receivers.iter().filter(move |end| !follows(end));
            sent.into_iter().chain(received.map(move |end| line("to", end)))
        })
    }

    /// A node with its downloads; a manager that is made is not configured.
    fn slave(&self, node: &ConfiguredNode) -> Option<&Slave> {
        self.compiled.nodes().find(|slave| slave.node == node.node && !node.is_made)
    }

    /// Prints the downloads of a node that differ.
    fn sends(
        &self,
        node: &ConfiguredNode,
        second: &Self,
        other: &ConfiguredNode,
        out: &mut Output,
    ) -> Result<Differences, Failure> {
        let none = ConciseDcf::default();
        let sent = |slave: Option<&'_ Slave>| slave.map_or(&none, Slave::arranged_or_stated).clone();
        let found = sent(self.slave(node)).differences(&sent(second.slave(other)));
        if !found.is_empty() {
            let device = Some(&other.device);
            writeln!(out, "downloads of {}:", one_line(&node.name))?;
            differences(&found, DescribedStream { device, node_id: Some(other.node_id) }, out)?;
        }
        Ok(found)
    }

    /// Everything that is shown and built, by name; the descriptions that `bus.yml` comes with are compared as devices.
    fn outputs(&self) -> Result<Vec<BuiltFile>, Failure> {
        let json = |name: &str, value: serde_json::Result<serde_json::Value>| {
            let text = value.and_then(|value| serde_json::to_string_pretty(&value)).map_err(Failure::new)?;
            Ok::<_, Failure>(BuiltFile { name: name.to_owned(), bytes: text.into_bytes() })
        };
        let mut files = vec![json("show", serde_json::to_value(&self.overview))?];
        let options = TimingOptions {
            bit_rate: Some(self.overview.bit_rate.unwrap_or(1000)),
            ..TimingOptions::default()
        };
        if let Some(times) = Timing::new(self.network, self.compiled, &options) {
            files.push(json("timing", serde_json::to_value(timing::TimingJson::new("", &times, &options)))?);
        }
        let failed = |name: &str, error: BuildError| {
            vec![BuiltFile { name: name.to_owned(), bytes: error.to_string().into_bytes() }]
        };
        if self.network.manager.is_some() {
            let lely = self.build.lely(&LelyOptions::default());
            files.extend(lely.unwrap_or_else(|error| failed("lely", error)));
        }
        files.extend(self.build.concise().unwrap_or_else(|error| failed("concise", error)));
        if let Err(error) = self.build.configured_nodes() {
            files.extend(failed("dcf", error));
        }
        let bus = self.build.bus_yml().unwrap_or_else(|error| failed("bus.yml", error));
        files.extend(bus.into_iter().take(1));
        Ok(files)
    }
}

fn boot(plan: &BootPlan, sections: &mut DiffSections) {
    let startup = [format!("1F80h = {:08X}h", plan.startup)];
    let title = format!("boot plan of {}", plan.manager);
    sections.insert(
        (SectionOrder::Boot, title),
        startup.into_iter().chain(plan.general.iter().cloned()).collect(),
    );
    for node in &plan.nodes {
        let mandatory = if node.is_mandatory { "mandatory" } else { "optional" };
        let steps = [format!("{mandatory} (1F81h = {:08X}h)", node.assignment)].into_iter();
        let steps = steps.chain(node.steps.iter().cloned()).collect();
        sections.insert((SectionOrder::Boot, format!("boot of {}", node.name)), steps);
    }
}

/// Prints the lines that only one side has; whether there are none.
fn lines(title: &str, old: &[String], new: &[String], out: &mut dyn Write) -> io::Result<bool> {
    let removed = old.iter().filter(|line| !new.contains(line)).map(|line| ('-', line));
    let added = new.iter().filter(|line| !old.contains(line)).map(|line| ('+', line));
    let changed: Vec<_> = removed.chain(added).collect();
    if !changed.is_empty() {
        writeln!(out, "{title}:")?;
    }
    for (sign, line) in &changed {
        writeln!(out, "{sign} {line}")?;
    }
    Ok(changed.is_empty())
}

/// Prints what else differs in the dictionaries of a node after its configuration; whether there is nothing.
fn has(
    node: &ConfiguredNode,
    other: &ConfiguredNode,
    sent: &Differences,
    is_booted: bool,
    out: &mut dyn Write,
) -> io::Result<bool> {
    let is_sent = |index, sub: Option<u8>| {
        sent.entries.iter().any(|entry| entry.index == index && sub.is_none_or(|sub| entry.sub == sub))
    };
    let is_explained = |change: &DeviceChange| {
        // the configurations of the nodes, and what the boot plan shows
        let is_of_manager =
            |index| index == 0x1F22 || is_booted && matches!(index, 0x1016 | 0x1F55 | 0x1F80..=0x1F8A);
        let of_pdo = |index| [Some(index), PdoKind::of_communication(index).map(|_| index + 0x200)];
        match (change.index, change.sub) {
            (Some(index), Some(sub)) => is_of_manager(index) || is_sent(index, Some(sub)),
            (Some(index), None) => of_pdo(index).into_iter().flatten().any(|index| is_sent(index, None)),
            _ => false,
        }
    };
    let found = compare(&node.device, &other.device);
    let found: Vec<_> = found.iter().filter(|change| !is_explained(change)).collect();
    if !found.is_empty() {
        writeln!(out, "dictionary of {}:", one_line(&node.name))?;
    }
    for change in &found {
        writeln!(out, "~ {}: {}", address(change), one_line(&change.message.shown()))?;
    }
    Ok(found.is_empty())
}

/// What a DCF takes over of its description but for names and dates, which `compare` leaves out.
fn information(device: &Device) -> Vec<String> {
    let info = device.file_info.clone().unwrap_or_default();
    let numbers = [("FileVersion", info.file_version), ("FileRevision", info.file_revision)];
    let numbers = numbers.map(|(key, number)| (key, number.map(|number| number.to_string())));
    let texts = [
        ("EDSVersion", info.eds_version),
        ("Description", info.description),
        ("CreatedBy", info.created_by),
        ("ModifiedBy", info.modified_by),
    ];
    let lines = numbers.into_iter().chain(texts);
    lines.filter_map(|(key, text)| Some(format!("{key}={}", one_line(&text?)))).collect()
}

/// Prints the lines of outputs that differ; whether there are none.
fn outputs(old: &[BuiltFile], new: &[BuiltFile], out: &mut dyn Write) -> io::Result<bool> {
    let mut is_same = true;
    let empty = BuiltFile { name: String::new(), bytes: Vec::new() };
    let names: BTreeSet<_> = old.iter().chain(new).map(|file| &file.name).collect();
    for name in names {
        let [old, new] =
            [old, new].map(|files| files.iter().find(|file| file.name == *name).unwrap_or(&empty));
        let [old_text, new_text] = [old, new].map(|file| String::from_utf8_lossy(&file.bytes));
        // the names of the descriptions may differ
        let [before, after] = [&old_text, &new_text]
            .map(|text| text.lines().filter(|line| !line.starts_with("  dcf: ")).collect::<Vec<_>>());
        if before == after {
            continue;
        }
        is_same = false;
        writeln!(out, "{}:", one_line(name))?;
        if Path::new(name).extension().is_some_and(|ending| ending == "bin" || ending == "cdcf") {
            writeln!(out, "~ {} bytes, {} bytes", old.bytes.len(), new.bytes.len())?;
            continue;
        }
        for change in changes(&before, &after) {
            for (sign, lines) in [('-', &before[change.old.clone()]), ('+', &after[change.new.clone()])] {
                lines.iter().try_for_each(|line| writeln!(out, "{sign} {}", one_line(line.trim())))?;
            }
        }
    }
    Ok(is_same)
}
