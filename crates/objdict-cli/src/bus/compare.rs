//! `objdict bus compare`.

use std::io::Write;

use objdict_can::{ExpectedNode, NodeDifference, OtherIdentity};
use objdict_document::describe::frames::nmt_state;
use objdict_model::diagnostic::plural;
use objdict_model::json::Version;
use objdict_network::Slave;
use objdict_node::download::remaining;
use objdict_node::parameter::no_parameter;
use serde::Serialize;

use super::session::BusSession;
use super::values::ValueWords;
use crate::args::{BusCompareArgs, ShowFormat};
use crate::ending::{Failure, Outcome};
use crate::network::open_to_use;
use crate::stdout::Output;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct ComparisonJson {
    /// The version of the document.
    version: Version<1>,
    /// The address of the bus.
    bus: String,
    /// The number of nodes in the network file, without the manager.
    nodes: usize,
    /// The number of values that were compared.
    values: usize,
    /// The differences, by node-ID.
    differences: Vec<DifferenceRow>,
}

/// A difference.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Difference"))]
struct DifferenceRow {
    /// The node-ID.
    node_id: u8,
    /// The name in the network; absent for a node that is not in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    node: Option<String>,
    /// What differs.
    kind: DifferenceKind,
    /// The index in hex, of an entry.
    #[serde(skip_serializing_if = "Option::is_none")]
    index: Option<String>,
    /// The sub-index in hex.
    #[serde(skip_serializing_if = "Option::is_none")]
    sub: Option<String>,
    /// What the network file describes.
    #[serde(skip_serializing_if = "Option::is_none")]
    expected: Option<String>,
    /// What was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    found: Option<String>,
    /// The same as a sentence.
    text: String,
}

/// A kind of difference.
#[derive(Clone, Copy, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
enum DifferenceKind {
    /// The node does not answer.
    Missing,
    /// The node is not in the network file.
    Extra,
    /// The node is another device.
    Identity,
    /// An entry has another value.
    Value,
    /// An entry cannot be read.
    Unreadable,
    /// The node is in another state.
    State,
    /// The node sends no heartbeat.
    Heartbeat,
}

pub(super) fn run(args: &BusCompareArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let file = open_to_use(std::slice::from_ref(&args.network), &args.connect.input)?;
    let slaves: Vec<&Slave> = file.compiled().into_iter().flat_map(|compiled| &compiled.slaves).collect();
    let manager =
        file.compiled().and_then(|compiled| compiled.manager.as_ref()).map(|manager| manager.node_id);
    let state = args.state.map(|state| state as u8);
    let wanted: Vec<ExpectedNode> = slaves.iter().map(|slave| wanted(slave, state)).collect();
    session.listen(None, "asks all node-IDs for 1000h and 1018h, and reads the described values")?;
    let mut found = session.client.scan(1..=127, args.connect.link.timeout.into())?;
    found.retain(|node| Some(node.node_id) != manager);
    let differences = session.client.compare(&wanted, &found)?;
    let name = |node_id: u8| {
        let slave = slaves.iter().find(|slave| slave.node_id == node_id)?;
        Some((*slave, file.network()?.nodes[slave.node].name.value.clone()))
    };
    let rows: Vec<DifferenceRow> = differences
        .into_iter()
        .map(|(node_id, difference)| row(node_id, name(node_id).as_ref(), difference))
        .collect();
    let outcome = if rows.is_empty() { Outcome::Clean } else { Outcome::Findings };
    let has_answered =
        |node: &&ExpectedNode| found.iter().any(|found| found.node_id == node.node_id && found.answers);
    let compared =
        |node: &ExpectedNode| remaining(&node.values).into_iter().filter(|remains| *remains).count();
    let (nodes, values) = (wanted.len(), wanted.iter().filter(has_answered).map(compared).sum());
    match args.connect.format {
        ShowFormat::Json => {
            out.json(&ComparisonJson {
                version: Version,
                bus: session.name,
                nodes,
                values,
                differences: rows,
            })?;
        }
        ShowFormat::Table => {
            for row in &rows {
                writeln!(out, "{}", row.text)?;
            }
            let (count, nodes) = (plural(rows.len(), "difference"), plural(nodes, "node"));
            writeln!(out, "{count} in {nodes} and {}", plural(values, "value"))?;
        }
    }
    Ok(outcome)
}

/// A node as the network configures it.
fn wanted(slave: &Slave, state: Option<u8>) -> ExpectedNode {
    let is_parameter = |index, sub| no_parameter(&slave.device, index, sub).is_none();
    let downloads = slave.downloads.0.iter();
    let values = downloads.filter(|download| is_parameter(download.index, download.sub)).cloned().collect();
    ExpectedNode { node_id: slave.node_id, identity: slave.identity, values, state }
}

fn row(node_id: u8, node: Option<&(&Slave, String)>, difference: NodeDifference) -> DifferenceRow {
    let hex = |number: u32| format!("{number:X}h");
    let of_entry = |entry, bytes: &[u8]| match node {
        Some((slave, _)) => ValueWords::new(&slave.device, node_id).text(entry, bytes),
        None => String::new(),
    };
    let (kind, entry, expected, found) = match difference {
        NodeDifference::Missing => (DifferenceKind::Missing, None, None, None),
        NodeDifference::Extra => (DifferenceKind::Extra, None, None, None),
        NodeDifference::Identity(OtherIdentity { index, sub, expected, found }) => {
            let found = found.map_or_else(|| "missing".to_owned(), hex);
            (DifferenceKind::Identity, Some((index, sub)), Some(hex(expected)), Some(found))
        }
        NodeDifference::Value(index, sub, wanted, found) => {
            let [wanted, found] = [wanted, found].map(|bytes| of_entry((index, sub), &bytes));
            (DifferenceKind::Value, Some((index, sub)), Some(wanted), Some(found))
        }
        NodeDifference::Unreadable(index, sub, abort) => {
            (DifferenceKind::Unreadable, Some((index, sub)), None, Some(abort.to_string()))
        }
        NodeDifference::State(wanted, found) => {
            let found = found.map_or_else(|| "unknown, because it sends no heartbeat".to_owned(), nmt_state);
            (DifferenceKind::State, None, Some(nmt_state(wanted)), Some(found))
        }
        NodeDifference::NoHeartbeat(period) => {
            (DifferenceKind::Heartbeat, None, Some(format!("{period} ms")), None)
        }
        _ => (DifferenceKind::State, None, None, None),
    };
    let name = node.map(|(_, name)| name.clone());
    let title = name.as_ref().map_or_else(|| format!("node {node_id}"), |name| format!("{name} ({node_id})"));
    let place = entry.map(|entry| {
        let name = node.map(|(slave, _)| ValueWords::new(&slave.device, node_id).name(entry));
        format!("{:04X}:{:02X} {}", entry.0, entry.1, name.unwrap_or_default())
    });
    let text = match (kind, &place, &expected, &found) {
        (DifferenceKind::Missing, ..) => format!("{title} is missing"),
        (DifferenceKind::Extra, ..) => format!("{title} is not in the network"),
        (_, Some(place), Some(expected), Some(found)) => {
            format!("{title}: {place} is {found}, expected {expected}")
        }
        (_, Some(place), _, Some(found)) => format!("{title}: {place} cannot be read: {found}"),
        (DifferenceKind::Heartbeat, _, Some(period), _) => {
            format!("{title} sends no heartbeat, expected every {period}")
        }
        (_, _, Some(expected), Some(found)) => format!("{title}: the state is {found}, expected {expected}"),
        _ => title,
    };
    let (index, sub) =
        (entry.map(|(index, _)| format!("{index:04X}")), entry.map(|(_, sub)| format!("{sub:02X}")));
    DifferenceRow { node_id, node: name, kind, index, sub, expected, found, text }
}
