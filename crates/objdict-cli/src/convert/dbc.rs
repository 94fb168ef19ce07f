//! Nodes to the DBC of their bus.

use std::io::Write;
use std::path::Path;
use std::slice;

use super::super::args::ConvertArgs;
use super::super::ending::{Failure, note};
use super::super::input::{FileKind, Input, name_of, source_name};
use super::super::network;
use super::super::stdout::Output;
use super::super::written_files::{Saved, is_stdout, keep, save};
use super::Job;
use super::device::left_out;
use super::losses::{self, LossReport};
use objdict_document::dbc;
use objdict_document::dbc::{BusNode, DbcOptions};
use objdict_format::identify::{ContentKind, identify};
use objdict_format::input::Reading;
use objdict_format::{Loss, LossKind};
use objdict_model::diagnostic::counted;
use objdict_model::model::{Device, NodeList};
use objdict_network::DcfgenMode;
use objdict_network_file::{ConfiguredNode, location};

/// A node of the bus.
struct DbcNode {
    /// Of the file that describes it.
    job: Job,
    from: FileKind,
    device: Device,
    /// That of the node list or the device; `None` if neither states one.
    node_id: Option<u8>,
    /// That of the node list or network.
    name: Option<String>,
    /// Whether it is the manager of a network without a description, whose PDOs are the other sides of those of the nodes.
    is_counterpart: bool,
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
    let bus = nodes.iter().map(|(node, node_id)| BusNode {
        device: &node.device,
        node_id: *node_id,
        name: name.or(node.name.as_deref()),
        is_counterpart: node.is_counterpart,
    });
    let options = DbcOptions { sdo: args.dbc.sdo, bits: args.dbc.bits };
    let written = dbc::write(&bus.collect::<Vec<_>>(), options);
    let [job, ..] = jobs else { return Ok(()) };
    let mut lines = String::new();
    if is_stdout(&job.output) {
        out.raw()?.write_all(&written.bytes)?;
    } else {
        let unchanged = match save(&job.output, &written.bytes)? {
            Saved::Written => "",
            Saved::Unchanged => ", unchanged",
        };
        let what = match nodes.as_slice() {
            [(node, _)] => format!("{} ({})", name_of(&node.job.input), node.from.name()),
            nodes => format!("{} nodes", nodes.len()),
        };
        let (output, size) = (name_of(&job.output), written.bytes.len());
        lines.push_str(&format!("{what} to {output} (DBC), {size} bytes{unchanged}\n"));
    }
    let described = nodes.iter().enumerate().filter(|(_, (node, _))| !node.is_counterpart);
    for (position, (node, node_id)) in described {
        let omissions = written.omissions.iter().filter(|omission| omission.node == position);
        let losses: Vec<Loss> = omissions
            .map(|omission| {
                let kind = if omission.is_lost { LossKind::Lost } else { LossKind::LeftOut };
                left_out(&node.device, &omission.place, kind, omission.reason.clone())
            })
            .collect();
        if nodes.len() > 1 {
            let (file, from) = (name_of(&node.job.input), node.from.name());
            lines.push_str(&format!("{file} ({from}), node {node_id}\n"));
        }
        lines.push_str(&losses::text(&losses));
        report.add(&node.job, node.from, losses);
    }
    if is_stdout(&job.output) {
        note(&lines);
    } else {
        out.summary(lines.trim_end_matches('\n'))?;
    }
    Ok(())
}

/// The nodes in all files, each with its own node-ID.
fn nodes(args: &ConvertArgs, jobs: &[Job]) -> Result<Vec<(DbcNode, u8)>, Failure> {
    let mut found = Vec::new();
    for job in jobs {
        let bytes = args.input.size.read(&job.input)?;
        let name = name_of(&job.input);
        let kind = identify(&name, &bytes).kind;
        if args.input.from.is_none() && matches!(kind, ContentKind::Network | ContentKind::BusConfiguration) {
            found.append(&mut nodes_of_network(args, job)?);
            continue;
        }
        let reading = Reading { is_node: true, ..args.input.reading_with(&job.patches) };
        match reading.read(&name, bytes)? {
            (_, Input::NodeList(list)) => found.append(&mut nodes_of_list(args, job, &list)?),
            (from, input) => {
                let devices = devices_in(&reading, job, input)?;
                found.append(&mut nodes_in(args, job, from, devices));
            }
        }
    }
    let is_one = found.len() == 1;
    let mut nodes: Vec<(DbcNode, u8)> = Vec::new();
    for node in found {
        let file = name_of(&node.job.input);
        // for several nodes the argument is for those that state none
        let node_id = match is_one {
            true => args.node_id.or(node.node_id),
            false => node.node_id.or(args.node_id),
        };
        let Some(node_id) = node_id else {
            let failure = Failure::new(format_args!(
                "missing node-ID: a DBC contains messages of nodes, but `{file}` has no node-ID"
            ));
            return Err(failure.help("set it with `--node-id`"));
        };
        if let Some((other, _)) = nodes.iter().find(|(_, other)| *other == node_id) {
            let other = name_of(&other.job.input);
            let failure =
                Failure::new(format_args!("`{other}` and `{file}` both have the node-ID {node_id}"));
            return Err(failure.help("create a DCF of one of them with a different `--node-id`"));
        }
        nodes.push((node, node_id));
    }
    Ok(nodes)
}

/// The nodes of a network after their configuration, and its manager.
fn nodes_of_network(args: &ConvertArgs, job: &Job) -> Result<Vec<DbcNode>, Failure> {
    let name = name_of(&job.input);
    if job.input == Path::new("-") {
        let failure = Failure::new("a network cannot be read from the standard input");
        return Err(failure.help("name its file: the paths of descriptions are relative to it"));
    }
    if args.node_id.is_some() {
        let failure = Failure::new(format_args!("`{name}` is a network, whose nodes have node-IDs"));
        return Err(failure.help("omit `--node-id`"));
    }
    let input = args.network.with(&args.input.patch, &args.config);
    let file = network::open_to_use(slice::from_ref(&job.input), &input)?;
    let nodes = file.build(DcfgenMode::Corrected).and_then(|build| build.configured_nodes());
    let nodes = nodes.map_err(|error| {
        let help = format!("run `objdict network check {name}` for the reason");
        Failure::new(format_args!("`{name}`: {error}")).help(help)
    })?;
    let node = |node: ConfiguredNode| {
        let description = file.description(node.node);
        let input = description.map_or_else(|| job.input.clone(), |of| of.source().name().into());
        DbcNode {
            job: Job { input, ..job.clone() },
            from: description.map_or(FileKind::Json, |of| of.format().into()),
            device: node.device,
            node_id: Some(node.node_id),
            name: Some(node.name),
            is_counterpart: node.is_made,
        }
    };
    Ok(nodes.into_iter().map(node).collect())
}

/// The nodes of a network that are present, from the files that the list names. The list says which nodes they are.
fn nodes_of_list(args: &ConvertArgs, job: &Job, list: &NodeList) -> Result<Vec<DbcNode>, Failure> {
    let file = name_of(&job.input);
    let networks = list.networks.as_slice();
    let network = match (args.input.device, networks) {
        (None, [network]) => Some(network),
        (None, _) => None,
        (Some(number), _) => networks.get(number.get() - 1),
    };
    let Some(network) = network else {
        let count = counted(networks.len(), "network", "networks");
        let failure = Failure::new(format_args!("`{file}` has {count}, but a DBC is for one"));
        return Err(failure.help("choose one by its number with `--device`, counted from 1"));
    };
    let folder = args.network.paths.folder_of(&job.input);
    let mut nodes = Vec::new();
    for node in network.nodes.iter().filter(|node| node.present) {
        if node.dcf.is_none() {
            let failure = Failure::new(format_args!("`{file}` has no file for node {}", node.id));
            return Err(failure.help(format!("add `Node{}DCFName`", node.id)));
        }
        let input = folder.resolve(&location(Some(&folder), network, node)).map_err(|error| {
            let failure = Failure::new(format_args!("the file of node {}: {error}", node.id));
            error.help().into_iter().fold(failure, Failure::help)
        })?;
        keep(&input);
        let bytes = args.input.size.read(&input)?;
        let own = Job { input, ..job.clone() };
        let reading =
            Reading { from: None, device: None, is_node: true, ..args.input.reading_with(&job.patches) };
        let (from, input) = reading.read(&source_name(&own.input), bytes)?;
        for found in nodes_in(args, &own, from, devices_in(&reading, &own, input)?) {
            nodes.push(DbcNode { node_id: Some(node.id), name: node.name.clone(), ..found });
        }
    }
    Ok(nodes)
}

/// The nodes that devices of a file are.
fn nodes_in(args: &ConvertArgs, job: &Job, from: FileKind, devices: Vec<Device>) -> Vec<DbcNode> {
    let node = |device: Device| {
        let device = args.expand.device(&device).into_owned();
        let node_id = device.node_id();
        DbcNode { job: job.clone(), from, node_id, device, name: None, is_counterpart: false }
    };
    devices.into_iter().map(node).collect()
}

/// The devices of a file: the one that was asked for, or all.
fn devices_in(reading: &Reading, job: &Job, input: Input) -> Result<Vec<Device>, Failure> {
    match input {
        Input::Description(description) if reading.device.is_some() => {
            Ok(vec![reading.select(&source_name(&job.input), *description)?.into_device()])
        }
        // variants are no nodes beside the device
        Input::Description(description) if description.device_count() == 1 => {
            Ok(vec![description.into_device()])
        }
        Input::Description(description) => {
            Ok(description.map_devices(|description| description.device().clone()))
        }
        Input::Device(device) => Ok(vec![*device]),
        Input::Concise(_) | Input::NodeList(_) => {
            let failure = Failure::new(format_args!("`{}` does not describe a node", name_of(&job.input)));
            Err(failure.help("name an EDS, DCF, XDD, XDC, JSON, node list or network"))
        }
    }
}
