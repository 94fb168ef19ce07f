//! Nodes to the DBC of their bus.

use std::io::Write;

use super::super::Failure;
use super::super::args::ConvertArgs;
use super::super::input::{FileKind, Input, name_of};
use super::super::output::Output;
use super::super::save::{Saved, is_stdout, save};
use super::Job;
use super::losses::{self, LossReport};
use crate::document::dbc::{self, BusNode, DbcOptions, Omission};
use crate::format::{Description, Loss, LossKind};
use crate::model::{Device, Part};

/// A node of the bus.
struct Node<'a> {
    job: &'a Job,
    from: FileKind,
    device: Device,
    node_id: u8,
}

/// Writes the DBC of the nodes in all files.
pub(super) fn convert(
    args: &ConvertArgs,
    jobs: &[Job],
    report: &mut LossReport,
    out: &mut Output,
) -> Result<(), Failure> {
    let nodes = nodes(args, jobs)?;
    let name = args.name.as_deref().filter(|_| nodes.len() == 1);
    let bus = nodes.iter().map(|node| BusNode { device: &node.device, node_id: node.node_id, name });
    let options = DbcOptions { sdo: args.dbc.sdo, bits: args.dbc.bits };
    let written = dbc::write(&bus.collect::<Vec<_>>(), options);
    let [job, ..] = jobs else { return Ok(()) };
    let mut lines = String::new();
    if is_stdout(&job.output) {
        out.write_all(&written.bytes)?;
    } else {
        let unchanged = match save(&job.output, &written.bytes)? {
            Saved::Written => "",
            Saved::Unchanged => ", unchanged",
        };
        let what = match nodes.as_slice() {
            [node] => format!("{} ({})", name_of(&job.input), node.from.name()),
            nodes => format!("{} nodes", nodes.len()),
        };
        let (output, size) = (job.output.display(), written.bytes.len());
        lines.push_str(&format!("{what} to {output} (DBC), {size} bytes{unchanged}\n"));
    }
    for (position, node) in nodes.iter().enumerate() {
        let omissions = written.omissions.iter().filter(|omission| omission.node == position);
        let losses: Vec<Loss> = omissions.map(|omission| loss(&node.device, omission)).collect();
        if nodes.len() > 1 {
            let (file, from) = (name_of(&node.job.input), node.from.name());
            lines.push_str(&format!("{file} ({from}), node {}\n", node.node_id));
        }
        lines.push_str(&losses::text(&losses));
        report.add(node.job, node.from, losses);
    }
    if is_stdout(&job.output) {
        super::super::tell(&lines);
    } else {
        out.write_all(super::super::shown(&lines).as_bytes())?;
    }
    Ok(())
}

/// The nodes in all files, each with its own node-ID.
fn nodes<'a>(args: &ConvertArgs, jobs: &'a [Job]) -> Result<Vec<Node<'a>>, Failure> {
    let mut devices = Vec::new();
    for job in jobs {
        let (from, input) = args.input.read(&job.input)?;
        let found = devices_in(args, job, input)?;
        devices.extend(found.into_iter().map(|device| (job, from, args.expand.device(&device).into_owned())));
    }
    let is_one = devices.len() == 1;
    let mut nodes: Vec<Node<'a>> = Vec::new();
    for (job, from, device) in devices {
        let file = name_of(&job.input);
        // for several nodes the argument is for those that state none
        let node_id = match is_one {
            true => args.node_id.or(device.node_id()),
            false => device.node_id().or(args.node_id),
        };
        let Some(node_id) = node_id else {
            let failure = Failure::new(format_args!(
                "missing node-ID: a DBC has the messages of nodes, and `{file}` states none"
            ));
            return Err(failure.help("set it with `--node-id`"));
        };
        if let Some(other) = nodes.iter().find(|other| other.node_id == node_id) {
            let other = name_of(&other.job.input);
            let failure =
                Failure::new(format_args!("`{other}` and `{file}` both have the node-ID {node_id}"));
            return Err(failure.help("make a DCF of one of them with another `--node-id`"));
        }
        nodes.push(Node { job, from, device, node_id });
    }
    Ok(nodes)
}

/// The devices of a file: the one that was asked for, or all.
fn devices_in(args: &ConvertArgs, job: &Job, input: Input) -> Result<Vec<Device>, Failure> {
    match input {
        Input::Description(description) if args.input.device.is_some() => {
            Ok(vec![args.input.selected(&job.input, *description)?.device().clone()])
        }
        Input::Description(description) => {
            let mut devices = Vec::new();
            let mut next = Some(*description);
            for number in 0..next.as_ref().map_or(0, Description::device_count) {
                next = next.and_then(|description| description.select(number));
                devices.extend(next.as_ref().map(|description| description.device().clone()));
            }
            Ok(devices)
        }
        Input::Device(device) => Ok(vec![*device]),
        Input::Concise(_) | Input::NodeList(_) => {
            let failure = Failure::new(format_args!("`{}` describes no node", name_of(&job.input)));
            Err(failure.help("name an EDS, DCF, XDD, XDC or JSON"))
        }
    }
}

/// What a DBC does not say of a node, in the words of the loss report.
fn loss(device: &Device, omission: &Omission) -> Loss {
    let (path, value) = match omission.place.part {
        Part::Entry(index, sub) => {
            let object = device.object(index);
            let sub_path = match object.and_then(|object| object.subs.get(sub)) {
                Some(_) => format!("/subs/0x{sub:02X}"),
                None => String::new(),
            };
            let entry = object.and_then(|object| object.entry(sub));
            let is_configured = entry.as_ref().is_some_and(|entry| entry.configured_value().is_some());
            let field = if is_configured { "configured/value" } else { "default" };
            let value = entry.as_ref().and_then(|entry| entry.value());
            (
                format!("/objects/0x{index:04X}{sub_path}/{field}"),
                serde_json::to_value(value).unwrap_or_default(),
            )
        }
        _ => (String::new(), serde_json::Value::Null),
    };
    let kind = if omission.is_lost { LossKind::Lost } else { LossKind::LeftOut };
    let (place, reason) = (omission.place.clone(), Some(omission.reason.clone()));
    Loss { place, path, kind, value, becomes: None, reason }
}
