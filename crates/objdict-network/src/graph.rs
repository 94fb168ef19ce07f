//! Diagrams of a network: its nodes, and the senders and receivers of each message.
//!
//! Nodes are columns and messages are rows, so that nothing overlaps, regardless of their number. SDO transfers between
//! the manager and every node are omitted.

use std::fmt::Write;

use askama::Template;

use crate::diagnostic::one_line;
use crate::messages::{MessageId, Service};
use crate::overview::{End, MessageRow, NodeRow, Overview};

/// Left edge of the first column; CAN-IDs and services are to the left.
const LEFT: usize = 130;
/// The vertical position of the bus line.
const BUS: usize = 24;
const ROW: usize = 20;
/// Half the length of an arrowhead.
const HEAD: usize = 5;

/// The columns of a diagram.
#[derive(Clone, Copy)]
struct Columns {
    /// The width of a column.
    width: usize,
    /// The height of a node's box.
    height: usize,
    /// Whether names are turned.
    is_turned: bool,
    /// The maximum number of characters of a name.
    limit: usize,
}

impl Columns {
    /// Wide ones for few nodes, narrow ones with turned names for many.
    const fn of(nodes: usize) -> Self {
        if nodes <= 10 {
            Self { width: 130, height: 40, is_turned: false, limit: 16 }
        } else {
            Self { width: 30, height: 170, is_turned: true, limit: 22 }
        }
    }

    const fn centre(self, column: usize) -> usize {
        LEFT + column * self.width + self.width / 2
    }

    const fn top(self) -> usize {
        BUS + 16
    }

    const fn bottom(self) -> usize {
        self.top() + self.height
    }
}

#[derive(Template)]
#[template(path = "topology.svg")]
struct NetworkDiagram {
    label: String,
    bus: String,
    width: usize,
    height: usize,
    columns: Columns,
    nodes: Vec<Column>,
    rows: Vec<DiagramRow>,
}

struct Column {
    x: usize,
    node_id: String,
    name: String,
    title: String,
    is_manager: bool,
}

struct DiagramRow {
    y: usize,
    can_id: String,
    service: String,
    title: String,
    class: &'static str,
    /// The line that connects all senders and receivers, and the arrowheads.
    path: String,
    senders: Vec<usize>,
}

/// The network as SVG, without scripts and external references. `spelled` formats CAN-IDs as in the document that
/// contains the diagram.
pub fn svg(overview: &Overview, spelled: impl Fn(MessageId) -> String) -> String {
    let columns = Columns::of(overview.nodes.len());
    let rows: Vec<DiagramRow> = drawn(overview)
        .enumerate()
        .map(|(number, message)| {
            let y = columns.bottom() + ROW * (number + 1);
            DiagramRow::new(overview, message, spelled(message.can_id), columns, y)
        })
        .collect();
    let name =
        overview.name.as_deref().unwrap_or(overview.language.pick("CANopen network", "CANopen-Netzwerk"));
    let rate = overview.bit_rate.map_or_else(String::new, |rate| format!("{rate} kbit/s"));
    let picture = NetworkDiagram {
        label: cut(name, 80),
        bus: rate,
        width: columns.centre(overview.nodes.len()) - columns.width / 2 + 20,
        height: columns.bottom() + ROW * (rows.len() + 1),
        columns,
        nodes: overview
            .nodes
            .iter()
            .enumerate()
            .map(|(at, node)| Column::new(overview, node, columns, at))
            .collect(),
        rows,
    };
    // writing to a string cannot fail
    picture.render().unwrap_or_default()
}

/// The network for Graphviz: an arrow from each sender to each receiver.
pub fn dot(overview: &Overview) -> String {
    let mut text = String::from("digraph network {\n  rankdir=LR;\n  node [shape=box];\n");
    for (number, node) in overview.nodes.iter().enumerate() {
        let label = format!("{} {}", id(node), node.name);
        let _ = writeln!(text, "  n{number} [label=\"{}\"];", quoted(&label));
    }
    for message in drawn(overview) {
        let positions =
            |ends: &[End]| ends.iter().filter_map(|end| position(overview, end)).collect::<Vec<_>>();
        let label = format!("{} {}", message.can_id, service(overview, message));
        for from in positions(&message.senders) {
            for to in positions(&message.receivers).into_iter().filter(|to| *to != from) {
                let _ = writeln!(text, "  n{from} -> n{to} [label=\"{}\"];", quoted(&label));
            }
        }
    }
    text + "}\n"
}

/// PDOs, and other messages except SDO that a node receives.
fn drawn(overview: &Overview) -> impl Iterator<Item = &MessageRow> {
    overview.messages.iter().filter(|message| match main_service(message) {
        Some(Service::SdoRequest | Service::SdoResponse) | None => false,
        Some(Service::Pdo(_)) => true,
        Some(_) => !message.senders.is_empty() && !message.receivers.is_empty(),
    })
}

/// The service with which a message is sent; if no node sends it, with which it is received.
fn main_service(message: &MessageRow) -> Option<Service> {
    message.senders.iter().chain(&message.receivers).next().map(|end| end.service)
}

/// `TPDO 1`: the service of the sender, otherwise of a receiver.
fn service(overview: &Overview, message: &MessageRow) -> String {
    main_service(message).map_or_else(String::new, |service| service.name(overview.language).into_owned())
}

fn position(overview: &Overview, end: &End) -> Option<usize> {
    overview.nodes.iter().position(|node| node.position == end.position)
}

fn id(node: &NodeRow) -> String {
    node.node_id.map_or_else(|| "?".to_owned(), |node_id| node_id.to_string())
}

/// Escapes a string for DOT.
fn quoted(text: &str) -> String {
    one_line(text).replace('\\', "\\\\").replace('"', "\\\"")
}

/// Truncates a text to this many characters.
pub(crate) fn cut(text: &str, limit: usize) -> String {
    match text.chars().nth(limit) {
        None => one_line(text),
        Some(_) => one_line(&text.chars().take(limit.saturating_sub(1)).collect::<String>()) + "…",
    }
}

impl Column {
    fn new(overview: &Overview, node: &NodeRow, columns: Columns, at: usize) -> Self {
        let word = overview.language.pick("node", "Knoten");
        Self {
            x: columns.centre(at),
            node_id: id(node),
            name: cut(&node.name, columns.limit),
            title: cut(&format!("{word} {} {}: {}", id(node), node.name, node.description), 120),
            is_manager: node.is_manager,
        }
    }
}

impl DiagramRow {
    fn new(overview: &Overview, message: &MessageRow, can_id: String, columns: Columns, y: usize) -> Self {
        let places = |ends: &[End]| -> Vec<usize> {
            let places = ends.iter().filter_map(|end| position(overview, end));
            places.map(|column| columns.centre(column)).collect()
        };
        let (senders, receivers) = (places(&message.senders), places(&message.receivers));
        let of = overview.language.pick("of", "von");
        let words = |ends: &[End]| {
            let end = |end: &End| format!("{} {of} {}", end.service.name(overview.language), end.node);
            ends.iter().map(end).collect::<Vec<_>>().join(", ")
        };
        Self {
            y,
            service: service(overview, message),
            title: cut(&format!("{can_id} {} → {}", words(&message.senders), words(&message.receivers)), 240),
            can_id,
            class: match main_service(message) {
                Some(Service::Pdo(_)) => "pdo",
                _ => "other",
            },
            path: line(&senders, &receivers, y),
            senders,
        }
    }
}

/// A line across all positions, and arrowheads at the receivers, which point away from the first sender.
fn line(senders: &[usize], receivers: &[usize], y: usize) -> String {
    let all = || senders.iter().chain(receivers).copied();
    let (Some(first), Some(last)) = (all().min(), all().max()) else { return String::new() };
    let mut path = format!("M{first} {y}H{last}");
    let from = senders.first().copied().unwrap_or(0);
    for &to in receivers {
        let tail = if to < from { to + 2 * HEAD } else { to - 2 * HEAD };
        let (above, below) = (y - HEAD, y + HEAD);
        // writing to a string cannot fail
        let _ = write!(path, "M{tail} {above}L{to} {y}L{tail} {below}");
    }
    path
}
