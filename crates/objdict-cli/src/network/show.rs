//! `objdict network show`.

use std::io::{self, Write};

use serde::Serialize;

use super::super::args::{NetworkShowArgs, ShowFormat};
use super::super::ending::{Failure, Outcome};
use super::super::stdout::Output;
use super::super::table::{TextTable, fit};
use super::{overview, source_names_of, timing};
use objdict_model::diagnostic::plural;
use objdict_model::json::Version;
use objdict_model::model::PdoKind;
use objdict_network::{
    BootPlan, DownloadRow, End, LinkRow, MappedEntry, MessageRow, NodeRow, Overview, Service, UnlinkedEnd,
};

/// The most characters of a cell.
const CELL: usize = 72;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct NetworkJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The file as it was given; several are separated by spaces.
    file: &'a str,
    #[serde(flatten)]
    overview: &'a Overview,
}

pub(super) fn run(args: &NetworkShowArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let overview = overview(&args.files, &args.input)?;
    match args.format {
        ShowFormat::Json => {
            let document =
                NetworkJson { version: Version, file: &source_names_of(&args.files), overview: &overview };
            out.json(&document)?;
        }
        ShowFormat::Table => tables(&overview, out)?,
    }
    Ok(Outcome::Clean)
}

fn tables(overview: &Overview, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{}", fit(&summary(overview), CELL * 3))?;
    let uncounted = overview.uncounted.words(overview.language, |can_id| can_id.to_string());
    if overview.load.is_some() && !uncounted.is_empty() {
        writeln!(out, "Not counted: {uncounted}")?;
    }
    writeln!(out)?;
    nodes(overview, out)?;
    let (links, unlinked): (Vec<_>, Vec<_>) =
        overview.links.iter().partition(|link| !is_unlinked(overview, link));
    if !links.is_empty() {
        writeln!(out, "\nLinks\n")?;
        self::links(&links, out)?;
    }
    if !unlinked.is_empty() {
        writeln!(out, "\nValid by default, without a link\n")?;
        self::unlinked(overview, out)?;
    }
    writeln!(out, "\nCAN-IDs, highest priority first\n")?;
    can_ids(overview, out)?;
    if let Some(plan) = &overview.boot {
        boot(plan, out)?;
    }
    overview.nodes.iter().filter(|node| node.downloads > 0).try_for_each(|node| downloads(node, out))
}

fn summary(overview: &Overview) -> String {
    let mut words = vec![plural(overview.nodes.len(), "node")];
    words.extend(overview.bit_rate.map(|rate| format!("{rate} kbit/s")));
    let load = |load: u64| format!("cyclic messages take up to {}.{} %", load / 10, load % 10);
    words.extend(overview.load.map(load));
    let name = overview.name.as_deref().unwrap_or("network without a name");
    format!("{name}: {}", words.join(", "))
}

/// A time in milliseconds; empty for 0.
fn milliseconds(time: u16) -> String {
    if time == 0 { String::new() } else { format!("{time} ms") }
}

fn nodes(overview: &Overview, out: &mut dyn Write) -> io::Result<()> {
    let headings = ["Node", "Name", "", "Description", "Heartbeat", "Guarding", "Downloads", "Bytes"];
    let mut table = TextTable::new(headings, CELL);
    for node in &overview.nodes {
        table.row([
            node.node_id.map_or_else(|| "?".to_owned(), |node_id| node_id.to_string()),
            node.name.clone(),
            if node.is_manager { "manager" } else { "" }.to_owned(),
            node.description.clone(),
            milliseconds(node.heartbeat),
            milliseconds(node.guard_time),
            node.downloads.to_string(),
            node.bytes.to_string(),
        ]);
    }
    table.write(out)
}

/// Whether a PDO is as its description has it by default, and no node has the other side.
fn is_unlinked(overview: &Overview, link: &LinkRow) -> bool {
    match (&link.sender, &link.receiver) {
        (Some(end), None) | (None, Some(end)) => overview.is_unlinked(link.can_id, end),
        _ => false,
    }
}

/// A line for each node.
fn unlinked(overview: &Overview, out: &mut dyn Write) -> io::Result<()> {
    let mut table = TextTable::new(["Node", "No node receives", "No node sends"], CELL * 2);
    for row in &overview.unlinked {
        let pdos = |kind: PdoKind| {
            let of_kind = |end: &&UnlinkedEnd| matches!(end.service, Service::Pdo(pdo) if pdo.kind == kind);
            let shown =
                row.pdos.iter().filter(of_kind).map(|end| format!("{} ({})", end.service, end.can_id));
            shown.collect::<Vec<_>>().join(", ")
        };
        table.row([row.node.clone(), pdos(PdoKind::Tpdo), pdos(PdoKind::Rpdo)]);
    }
    table.write(out)
}

fn links(links: &[&LinkRow], out: &mut dyn Write) -> io::Result<()> {
    let mut table = TextTable::new(["CAN-ID", "From", "Entry", "To", "Entry"], CELL);
    for link in links {
        let end = |end: &Option<End>| end.as_ref().map_or_else(|| "no node".to_owned(), End::to_string);
        let ends = [link.can_id.to_string(), end(&link.sender), end(&link.receiver)];
        if link.entries.is_empty() {
            let [can_id, from, to] = ends.clone();
            table.row([can_id, from, String::new(), to, String::new()]);
        }
        for entry in &link.entries {
            let [can_id, from, to] = ends.clone();
            let text =
                |entry: &Option<MappedEntry>| entry.as_ref().map(ToString::to_string).unwrap_or_default();
            table.row([can_id, from, text(&entry.from), to, text(&entry.to)]);
        }
    }
    table.write(out)
}

fn can_ids(overview: &Overview, out: &mut dyn Write) -> io::Result<()> {
    let mut table = TextTable::new(["CAN-ID", "From", "To", "Bytes", "Trigger", "Period"], CELL);
    // what only waits by default is not on the bus
    let waits = |message: &&MessageRow| {
        let is_unlinked = |end: &End| overview.is_unlinked(message.can_id, end);
        message.senders.is_empty() && message.receivers.iter().all(is_unlinked)
    };
    for message in overview.messages.iter().filter(|message| !waits(message)) {
        let ends = |ends: &[End]| ends.iter().map(End::to_string).collect::<Vec<_>>().join(", ");
        // the same service of many nodes is one word
        let receivers = match message.receivers.as_slice() {
            [first, .., last] if message.receivers.len() > 4 && first.service == last.service => {
                format!("{} of {}", first.service, plural(message.receivers.len(), "node"))
            }
            receivers => ends(receivers),
        };
        table.row([
            message.can_id.to_string(),
            ends(&message.senders),
            receivers,
            message.length(),
            message.trigger.clone(),
            message.period.map(|period| timing::milliseconds(period * 1000)).unwrap_or_default(),
        ]);
    }
    table.write(out)
}

/// What configures a node, in order.
fn downloads(node: &NodeRow, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\nDownloads to {}\n", fit(&node.name, CELL))?;
    let mut table = TextTable::new(["Entry", "Value"], CELL);
    for DownloadRow { entry, value } in &node.configuration {
        table.row([entry.to_string(), value.clone()]);
    }
    table.write(out)
}

fn boot(plan: &BootPlan, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\nBoot plan of {} (1F80h = {:08X}h)\n", fit(&plan.manager, CELL), plan.startup)?;
    for words in &plan.general {
        writeln!(out, "  {words}")?;
    }
    for node in &plan.nodes {
        let mandatory = if node.is_mandatory { "mandatory" } else { "optional" };
        let name = fit(&node.name, CELL);
        writeln!(out, "\nNode {} {name}: {mandatory} (1F81h = {:08X}h)\n", node.node_id, node.assignment)?;
        for step in &node.steps {
            writeln!(out, "  {}", fit(step, CELL * 3))?;
        }
    }
    Ok(())
}
