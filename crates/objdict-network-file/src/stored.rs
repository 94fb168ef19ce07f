//! The configurations of nodes in the manager's description: their DCFs (1F20h) and concise DCFs (1F22h) (CiA
//! 302-3).

use std::borrow::Cow;

use super::rules::INVALID_CONFIGURATION;
use objdict_format as format;
use objdict_format::Format;
use objdict_model::diagnostic::{At, Diagnostic, Findings, say};
use objdict_model::model::{Device, Entry, Value};
use objdict_model::source::{SourceFile, SourceOptions};
use objdict_network::{Network, Node, Stored};
use objdict_node::download::{ConciseDcf, Plan, PlanOptions};

const REMEDY: &str = "rebuild the manager's DCF: `objdict network build --target manager`";

const DCF: u16 = 0x1F20;
const CONCISE_DCF: u16 = 0x1F22;

/// A configuration that a device stores for the node with this node-ID.
type HeldConfiguration = (u16, u8, Result<ConciseDcf, String>);

/// The configurations that a device stores for other nodes, except empty ones.
fn held(device: &Device) -> Vec<HeldConfiguration> {
    let objects = [DCF, CONCISE_DCF].into_iter().filter_map(|index| Some((index, device.object(index)?)));
    let entries =
        objects.flat_map(|(index, object)| object.entries().map(move |(sub, entry)| (index, sub, entry)));
    let configuration = |(index, node_id, entry): (u16, u8, Cow<'_, Entry>)| {
        let Some(Value::Bytes(bytes)) = entry.value() else { return None };
        // an empty one reads as a stream without downloads
        let is_empty = bytes.is_empty() || bytes[..] == [0; 4];
        let downloads = match index {
            _ if is_empty || !(1..=127).contains(&node_id) => return None,
            CONCISE_DCF => ConciseDcf::parse(bytes).map_err(|error| error.to_string()),
            _ => of_dcf(bytes, node_id),
        };
        Some((index, node_id, downloads))
    };
    entries.filter_map(configuration).collect()
}

/// The unreadable configurations that a device stores for other nodes.
pub fn unreadable_configurations(device: &Device) -> Findings {
    let mut findings = Findings::new();
    for (index, node_id, downloads) in held(device) {
        if let Err(reason) = downloads {
            let message =
                say!("the configuration in {:04X}h:{:02X} is not valid: {}", index, node_id, reason);
            let finding =
                Diagnostic::new(&INVALID_CONFIGURATION, device.value_place(index, node_id), message);
            findings.push(finding.help(REMEDY).understood());
        }
    }
    findings
}

/// Reads the configurations in the manager's description, each for its node. An unreadable one is a finding.
pub(super) fn read(network: &mut Network, findings: &mut Findings) {
    let Some(own) = network.manager.as_ref().and_then(|manager| manager.node) else { return };
    let manager = &network.nodes[own];
    let mut configurations = Vec::new();
    for (index, node_id, downloads) in held(&manager.device) {
        // assigned but missing nodes are reported for 1F81h
        let has_id = |node: &Node| node.node_id.map(|id| id.value) == Some(node_id);
        let Some(node) = network.nodes.iter().position(has_id) else { continue };
        match downloads {
            Ok(downloads) => configurations.push((node, Stored { index, downloads })),
            Err(reason) => {
                let name = &manager.name.value;
                let message = say!(
                    "the configuration in {:04X}h:{:02X} of `{}` is not valid: {}",
                    index,
                    node_id,
                    name,
                    reason
                );
                let place = At::Node(own, manager.device.value_place(index, node_id));
                let finding = Diagnostic::new(&INVALID_CONFIGURATION, manager.file.at, message)
                    .label(place, "the configuration")
                    .label(network.nodes[node].name.at, "the node");
                findings.push(finding.help(REMEDY).understood());
            }
        }
    }
    for (node, stored) in configurations {
        network.nodes[node].stored.push(stored);
    }
}

/// The downloads that a node's DCF specifies.
fn of_dcf(bytes: &[u8], node_id: u8) -> Result<ConciseDcf, String> {
    let source = SourceFile::from_bytes("1F20h", bytes.to_vec(), &SourceOptions::default())
        .map_err(|error| error.to_string())?;
    let description = format::read(source, Format::Dcf);
    let device: &Device = description.device();
    if device.objects.is_empty() {
        return Err("it is not a DCF".to_owned());
    }
    if let Some(other) = device.node_id().filter(|other| *other != node_id) {
        return Err(format!("it is the DCF of node {other}"));
    }
    let options = PlanOptions { node_id: Some(node_id), ..PlanOptions::default() };
    ConciseDcf::plan(device, &options).map(Plan::without_files).map_err(|error| error.to_string())
}
