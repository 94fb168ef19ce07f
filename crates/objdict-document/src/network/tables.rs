//! Networks as tables for spreadsheets and scripts. As in the other tables, columns are never renamed, moved or removed.

use objdict_network::{CarriedEntry, DownloadRow, End, MappedEntry, MessageRow, NodeRow, Overview};

use super::{PdoLink, can_id, spoken};
use crate::csv::{CsvColumn, table};

/// The data between entries, all messages, and the configuration of the nodes, with file names.
pub(crate) fn tables<'a>(networks: impl Iterator<Item = &'a Overview>) -> [(&'static str, String); 3] {
    let named = networks.map(|network| (network.name.as_deref().unwrap_or_default(), network));
    let networks: Vec<(&str, &Overview)> = named.collect();
    [
        ("links.csv", links(&networks)),
        ("messages.csv", messages(&networks)),
        ("downloads.csv", downloads(&networks)),
    ]
}

/// A line for each entry of a link.
fn links(networks: &[(&str, &Overview)]) -> String {
    let links = networks
        .iter()
        .flat_map(|&(name, network)| network.links.iter().map(move |row| (name, PdoLink::new(row))));
    let links: Vec<(&str, PdoLink<'_>)> = links.collect();
    let columns: [CsvColumn<(&str, &PdoLink<'_>, &CarriedEntry)>; 13] = [
        ("network", |(network, ..)| (*network).to_owned()),
        ("can_id", |(_, link, _)| link.can_id.clone()),
        ("sender", |(_, link, _)| node(link.row.sender.as_ref())),
        ("sender_pdo", |(_, link, _)| pdo(link.row.sender.as_ref())),
        ("receiver", |(_, link, _)| node(link.row.receiver.as_ref())),
        ("receiver_pdo", |(_, link, _)| pdo(link.row.receiver.as_ref())),
        ("bit", |(.., entry)| entry.bit.to_string()),
        ("bits", |(.., entry)| entry.bits.to_string()),
        ("from", |(.., entry)| entry.from.as_ref().map(spoken).unwrap_or_default()),
        ("from_name", |(.., entry)| entry_name(entry.from.as_ref())),
        ("to", |(.., entry)| entry.to.as_ref().map(spoken).unwrap_or_default()),
        ("to_name", |(.., entry)| entry_name(entry.to.as_ref())),
        ("too_short", |(_, link, _)| if link.is_too_short { "yes" } else { "no" }.to_owned()),
    ];
    let rows =
        links.iter().flat_map(|(name, link)| link.row.entries.iter().map(move |entry| (*name, link, entry)));
    table(&columns, rows)
}

fn messages(networks: &[(&str, &Overview)]) -> String {
    let columns: [CsvColumn<(&str, &MessageRow)>; 7] = [
        ("network", |(network, _)| (*network).to_owned()),
        ("can_id", |(_, message)| can_id(message.can_id)),
        ("senders", |(_, message)| ends(&message.senders)),
        ("receivers", |(_, message)| ends(&message.receivers)),
        ("bytes", |(_, message)| number(message.bytes)),
        ("trigger", |(_, message)| message.trigger.clone()),
        ("period_us", |(_, message)| number(message.period)),
    ];
    let rows = networks
        .iter()
        .flat_map(|(name, network)| network.messages.iter().map(move |message| (*name, message)));
    table(&columns, rows)
}

/// A line for each download to a node, in order.
fn downloads(networks: &[(&str, &Overview)]) -> String {
    let columns: [CsvColumn<(&str, &NodeRow, usize, &DownloadRow)>; 7] = [
        ("network", |(network, ..)| (*network).to_owned()),
        ("node_id", |(_, node, ..)| number(node.node_id)),
        ("node", |(_, node, ..)| node.name.clone()),
        ("number", |(_, _, number, _)| number.to_string()),
        ("entry", |(.., download)| spoken(&download.entry)),
        ("name", |(.., download)| download.entry.name.clone()),
        ("value", |(.., download)| download.value.clone()),
    ];
    let nodes =
        networks.iter().flat_map(|(name, network)| network.nodes.iter().map(move |node| (*name, node)));
    let rows = nodes.flat_map(|(name, node)| {
        (1..).zip(&node.configuration).map(move |(number, download)| (name, node, number, download))
    });
    table(&columns, rows)
}

fn node(end: Option<&End>) -> String {
    end.map(|end| end.node.clone()).unwrap_or_default()
}

fn pdo(end: Option<&End>) -> String {
    end.map(|end| end.service.to_string()).unwrap_or_default()
}

fn ends(ends: &[End]) -> String {
    ends.iter().map(End::to_string).collect::<Vec<_>>().join("; ")
}

fn entry_name(entry: Option<&MappedEntry>) -> String {
    entry.map(|entry| entry.name.clone()).unwrap_or_default()
}

fn number(number: Option<impl ToString>) -> String {
    number.map(|number| number.to_string()).unwrap_or_default()
}
