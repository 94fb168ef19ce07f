//! `objdict bus scan`.

use std::io::Write;
use std::path::PathBuf;

use objdict_can::ScannedNode;
use objdict_document::describe::frames::nmt_state;
use objdict_model::diagnostic::plural;
use objdict_model::json::Version;
use objdict_model::model::Device;
use objdict_traffic::DescribedNode;
use serde::Serialize;

use super::session::BusSession;
use crate::args::{BusScanArgs, ShowFormat, WithFile};
use crate::decode::descriptions;
use crate::ending::{Failure, Outcome};
use crate::stdout::Output;
use crate::table::TextTable;

/// The most characters of a cell.
const CELL: usize = 60;

/// The endings of the descriptions that are looked at in the current folder, and the most files.
const ENDINGS: [&str; 4] = ["eds", "dcf", "xdd", "xdc"];
const FILES: usize = 200;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct ScanJson {
    /// The version of the document.
    version: Version<1>,
    /// The address of the bus.
    bus: String,
    /// The bit rate in kbit/s; absent if the adapter does not know it, or if no frame shows it.
    #[serde(skip_serializing_if = "Option::is_none")]
    bit_rate: Option<u16>,
    /// Whether another NMT or LSS master was heard.
    has_master: bool,
    /// The nodes, by node-ID.
    nodes: Vec<ScanRow>,
}

/// A node.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Node"))]
struct ScanRow {
    /// The node-ID.
    node_id: u8,
    /// The NMT state; absent if the node sends no heartbeat.
    #[serde(skip_serializing_if = "Option::is_none")]
    state: Option<String>,
    /// Whether its SDO server answers.
    answers: bool,
    /// The device type (1000h).
    #[serde(skip_serializing_if = "Option::is_none")]
    device_type: Option<u32>,
    /// The number of the device profile in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    profile: Option<u16>,
    /// The vendor-ID.
    #[serde(skip_serializing_if = "Option::is_none")]
    vendor_id: Option<u32>,
    /// The product code.
    #[serde(skip_serializing_if = "Option::is_none")]
    product_code: Option<u32>,
    /// The revision number.
    #[serde(skip_serializing_if = "Option::is_none")]
    revision_number: Option<u32>,
    /// The serial number.
    #[serde(skip_serializing_if = "Option::is_none")]
    serial_number: Option<u32>,
    /// The file that describes it.
    #[serde(skip_serializing_if = "Option::is_none")]
    description: Option<String>,
    /// Whether the description is of another revision.
    is_other_revision: bool,
}

pub(super) fn run(args: &BusScanArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    if args.connect.with.is_empty() {
        session.descriptions = descriptions(in_folder().iter(), &args.connect.input)?;
    }
    let (first, last) = (args.nodes.start(), args.nodes.end());
    session.listen(None, &format!("asks node-IDs {first} to {last} for 1000h and 1018h"))?;
    let found = session.client.scan(args.nodes.clone(), args.connect.link.timeout.into())?;
    let nodes: Vec<ScanRow> = found.iter().map(|node| row(node, &session)).collect();
    let (bit_rate, has_master) = (session.client.heard_bit_rate(), session.client.has_master());
    match args.connect.format {
        ShowFormat::Json => {
            out.json(&ScanJson { version: Version, bus: session.name, bit_rate, has_master, nodes })?;
        }
        ShowFormat::Table => {
            let (count, is_empty) = (plural(nodes.len(), "node"), nodes.is_empty());
            write_table(nodes, out)?;
            let rate = match bit_rate {
                Some(rate) => format!(" at {rate} kbit/s"),
                None if is_empty => "; the bus is silent, so its bit rate is unknown".to_owned(),
                None => String::new(),
            };
            let master = if has_master { "; a different NMT or LSS master is active" } else { "" };
            writeln!(out, "{count} on {}{rate}{master}", session.name)?;
        }
    }
    Ok(Outcome::Clean)
}

/// The descriptions in the current folder.
fn in_folder() -> Vec<WithFile> {
    let is_description = |path: &PathBuf| {
        path.extension().is_some_and(|ending| ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known)))
    };
    let files = std::fs::read_dir(".").into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> =
        files.map(|file| PathBuf::from(file.file_name())).filter(is_description).take(FILES).collect();
    paths.sort();
    paths.into_iter().map(|path| WithFile { node_id: None, path }).collect()
}

fn row(node: &ScannedNode, session: &BusSession) -> ScanRow {
    let [vendor_id, product_code, revision_number, serial_number] = node.identity;
    let description = fitting(node, &session.descriptions.nodes);
    ScanRow {
        node_id: node.node_id,
        state: node.state.map(nmt_state),
        answers: node.answers,
        device_type: node.device_type,
        profile: node.device_type.map(|device_type| device_type as u16).filter(|profile| *profile != 0),
        vendor_id,
        product_code,
        revision_number,
        serial_number,
        description: description.map(|(description, _)| description.file.clone()),
        is_other_revision: description.is_some_and(|(_, is_exact)| !is_exact),
    }
}

/// The description with the identity of a node, and whether its revision is the same.
fn fitting<'d>(node: &ScannedNode, nodes: &'d [DescribedNode]) -> Option<(&'d DescribedNode, bool)> {
    let number = |device: &Device, sub: u8| objdict_network::answered(device, sub, node.node_id);
    let is_product = |described: &&DescribedNode| {
        let is_same = |sub: u8| {
            let own = node.identity[usize::from(sub) - 1];
            own.is_some_and(|own| own != 0) && own == number(&described.device, sub)
        };
        is_same(1) && is_same(2)
    };
    let fits: Vec<&DescribedNode> = nodes.iter().filter(is_product).collect();
    let is_exact = |described: &&&DescribedNode| number(&described.device, 3) == node.identity[2];
    let is_for_node = |described: &&&DescribedNode| described.node_id == Some(node.node_id);
    let exact = fits.iter().filter(is_exact).find(is_for_node).or_else(|| fits.iter().find(is_exact));
    exact.map(|described| (*described, true)).or_else(|| fits.first().map(|described| (*described, false)))
}

fn write_table(nodes: Vec<ScanRow>, out: &mut Output) -> std::io::Result<()> {
    let headings = ["Node", "State", "Profile", "Vendor", "Product", "Revision", "Serial", "Description"];
    let mut table = TextTable::new(headings, CELL);
    let hex = |number: Option<u32>| number.map_or_else(String::new, |number| format!("{number:X}h"));
    for node in nodes {
        let state = match (node.state, node.answers) {
            (Some(state), true) => state,
            (Some(state), false) => format!("{state}, no SDO"),
            (None, true) => "no heartbeat".to_owned(),
            (None, false) => "heard".to_owned(),
        };
        let other = if node.is_other_revision { " (other revision)" } else { "" };
        table.row([
            node.node_id.to_string(),
            state,
            node.profile.map_or_else(String::new, |profile| profile.to_string()),
            hex(node.vendor_id),
            hex(node.product_code),
            hex(node.revision_number),
            hex(node.serial_number),
            node.description.map_or_else(String::new, |file| format!("{file}{other}")),
        ]);
    }
    if table.is_empty() { Ok(()) } else { table.write(out) }
}
