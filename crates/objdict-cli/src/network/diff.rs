//! `objdict network diff`.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::slice;

use super::super::annotation::DescribedStream;
use super::super::args::NetworkDiffArgs;
use super::super::dcf::differences;
use super::super::ending::{Failure, Outcome};
use super::super::stdout::Output;
use super::resolved;
use objdict_model::diagnostic::one_line;
use objdict_network::{End, Overview, Resolved, Service};

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

pub(super) fn run(args: &NetworkDiffArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let first = resolved(slice::from_ref(&args.first), &args.input)?;
    let second = resolved(slice::from_ref(&args.second), &args.input)?;
    let (before, after) = (sections(&first), sections(&second));
    let mut is_same = true;
    let none = Vec::new();
    let titles: std::collections::BTreeSet<_> = before.keys().chain(after.keys()).collect();
    for section in titles {
        let old = before.get(section).unwrap_or(&none);
        let new = after.get(section).unwrap_or(&none);
        is_same &= lines(&section.1, old, new, out)?;
    }
    for name in first.network().nodes.iter().map(|node| &node.name.value) {
        is_same &= configuration(name, &first, &second, out)?;
    }
    Ok(if is_same { Outcome::Clean } else { Outcome::Findings })
}

fn sections(resolved: &Resolved) -> DiffSections {
    let overview = Overview::new(resolved.network(), resolved.compiled());
    let mut sections = DiffSections::new();
    let bus = overview.name.iter().map(|name| format!("name {name}"));
    let bus = bus.chain(overview.bit_rate.map(|rate| format!("{rate} kbit/s")));
    sections.insert((SectionOrder::Bus, "bus".to_owned()), bus.collect());
    let nodes = overview.nodes.iter().map(|node| {
        let node_id = node.node_id.map_or_else(|| "?".to_owned(), |node_id| node_id.to_string());
        format!("{node_id} {}: {}", node.name, node.description)
    });
    sections.insert((SectionOrder::Nodes, "nodes".to_owned()), nodes.collect());
    let messages = overview.messages.iter().flat_map(|message| {
        let line =
            move |verb: &str, end: &End| format!("{} {verb} {end}: {}", message.can_id, message.trigger);
        // these follow from the node-IDs
        let follows =
            |end: &&End| matches!(end.service, Service::Nmt | Service::SdoRequest | Service::SdoResponse);
        let sent = message.senders.iter().filter(move |end| !follows(end)).map(move |end| line("from", end));
        let received = message.receivers.iter().filter(move |end| !follows(end));
        sent.chain(received.map(move |end| line("to", end)))
    });
    sections.insert((SectionOrder::Messages, "CAN-IDs".to_owned()), messages.collect());
    if let Some(plan) = &overview.boot {
        let title = format!("boot plan of {}", plan.manager);
        sections.insert((SectionOrder::Boot, title), plan.general.clone());
        for node in &plan.nodes {
            let mandatory = if node.is_mandatory { "mandatory" } else { "optional" };
            let steps = std::iter::once(mandatory.to_owned()).chain(node.steps.iter().cloned());
            sections.insert((SectionOrder::Boot, format!("boot of {}", node.name)), steps.collect());
        }
    }
    sections
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

/// Prints the downloads of a node that differ; whether there are none. A node that only one side has is reported as such.
fn configuration<'n>(
    name: &str,
    first: &'n Resolved,
    second: &'n Resolved,
    out: &mut Output,
) -> Result<bool, Failure> {
    let of_name = |resolved: &'n Resolved| {
        let nodes = &resolved.network().nodes;
        resolved.compiled().nodes().find(|slave| nodes[slave.node].name.value == name)
    };
    let (Some(old), Some(new)) = (of_name(first), of_name(second)) else { return Ok(true) };
    let found = old.arranged_or_stated().differences(new.arranged_or_stated());
    if found.is_empty() {
        return Ok(true);
    }
    let node = &second.network().nodes[new.node];
    let described =
        DescribedStream { device: Some(&node.device), node_id: node.node_id.map(|node_id| node_id.value) };
    writeln!(out, "downloads of {}:", one_line(name))?;
    differences(&found, described, out)?;
    Ok(false)
}
