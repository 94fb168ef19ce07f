//! Networks as tables for spreadsheets and scripts. As in the other tables, columns are never renamed, moved or removed.

use std::borrow::Cow;

use objdict_network::{End, LinkRow, MappedEntry, NodeRow, Overview};

use super::link::{Link, can_id, spoken};
use crate::csv;

/// What goes from entry to entry, all messages, and what configures the nodes, with the names of the files.
pub(crate) fn tables<'a>(networks: impl Iterator<Item = &'a Overview>) -> [(&'static str, String); 3] {
    const LINKS: [&str; 13] = [
        "network",
        "can_id",
        "sender",
        "sender_pdo",
        "receiver",
        "receiver_pdo",
        "bit",
        "bits",
        "from",
        "from_name",
        "to",
        "to_name",
        "too_short",
    ];
    const MESSAGES: [&str; 7] =
        ["network", "can_id", "senders", "receivers", "bytes", "trigger", "period_us"];
    const DOWNLOADS: [&str; 7] = ["network", "node_id", "node", "number", "entry", "name", "value"];
    let [mut links, mut messages, mut downloads] = [(); 3].map(|()| "\u{FEFF}".to_owned());
    csv::line(&mut links, LINKS.map(Cow::Borrowed));
    csv::line(&mut messages, MESSAGES.map(Cow::Borrowed));
    csv::line(&mut downloads, DOWNLOADS.map(Cow::Borrowed));
    for overview in networks {
        let name = overview.name.as_deref().unwrap_or_default();
        for link in overview.links.iter().map(Link::new) {
            link_lines(&mut links, name, &link);
        }
        let ends = |ends: &[End]| ends.iter().map(End::to_string).collect::<Vec<_>>().join("; ");
        for message in &overview.messages {
            let fields = [
                name.to_owned(),
                can_id(message.can_id),
                ends(&message.senders),
                ends(&message.receivers),
                message.bytes.map(|bytes| bytes.to_string()).unwrap_or_default(),
                message.trigger.clone(),
                message.period.map(|period| period.to_string()).unwrap_or_default(),
            ];
            csv::line(&mut messages, fields.map(Cow::Owned));
        }
        overview.nodes.iter().for_each(|node| download_lines(&mut downloads, name, node));
    }
    [("links.csv", links), ("messages.csv", messages), ("downloads.csv", downloads)]
}

/// A line for each download to a node, in order.
fn download_lines(text: &mut String, network: &str, node: &NodeRow) {
    for (number, download) in (1_u32..).zip(&node.configuration) {
        let fields = [
            network.to_owned(),
            node.node_id.map(|node_id| node_id.to_string()).unwrap_or_default(),
            node.name.clone(),
            number.to_string(),
            spoken(&download.entry),
            download.entry.name.clone(),
            download.value.clone(),
        ];
        csv::line(text, fields.map(Cow::Owned));
    }
}

/// A line for each entry of a link.
fn link_lines(text: &mut String, network: &str, link: &Link<'_>) {
    let node = |end: &Option<End>| end.as_ref().map(|end| end.node.clone()).unwrap_or_default();
    let pdo = |end: &Option<End>| end.as_ref().map(|end| end.service.to_string()).unwrap_or_default();
    let LinkRow { sender, receiver, entries, .. } = link.row;
    for entry in entries {
        let address = |entry: &Option<MappedEntry>| entry.as_ref().map(spoken).unwrap_or_default();
        let name =
            |entry: &Option<MappedEntry>| entry.as_ref().map(|entry| entry.name.clone()).unwrap_or_default();
        let fields = [
            network.to_owned(),
            link.can_id.clone(),
            node(sender),
            pdo(sender),
            node(receiver),
            pdo(receiver),
            entry.bit.to_string(),
            entry.bits.to_string(),
            address(&entry.from),
            name(&entry.from),
            address(&entry.to),
            name(&entry.to),
            if link.is_too_short { "yes" } else { "no" }.to_owned(),
        ];
        csv::line(text, fields.map(Cow::Owned));
    }
}
