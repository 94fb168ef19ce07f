//! The frames of configured nodes as a DBC: the messages and signals that tools of the CAN bus decode.
//!
//! A DBC describes the bus: the PDOs of each node, its EMCY and heartbeat, SYNC, TIME and NMT, and SDO on request. It
//! cannot contain any other part of a dictionary.

mod decimal;
mod identifier;
mod pdo;
mod sdo;
mod services;
mod signal;
#[cfg(test)]
mod tests;
mod text;
mod value;

use std::collections::{BTreeMap, BTreeSet};

use self::identifier::{DbcName, DbcNames, words};
use self::signal::DbcMessage;
pub(crate) use self::value::{Scaled, scaling_of};
use crate::describe::Decoder;
use crate::model::{Device, Entry, Meanings, Part, Place};

/// A node whose frames are described.
#[derive(Clone, Copy, Debug)]
pub struct BusNode<'a> {
    /// The device after configuration.
    pub device: &'a Device,
    /// The node-ID, 1 to 127. Each node has its own.
    pub node_id: u8,
    /// The name; `None` uses the one in the description.
    pub name: Option<&'a str>,
    /// Whether its PDOs are only the counterparts of the other nodes' PDOs, as for a manager without a description: it
    /// sends and receives their messages.
    pub is_counterpart: bool,
}

/// Additional content of a DBC besides PDOs and the services of CiA 301.
#[derive(Clone, Copy, Debug, Default)]
pub struct DbcOptions {
    /// The SDOs of each node, a multiplexed signal for each entry of at most 4 bytes.
    pub sdo: bool,
    /// A signal for each named bit field of a word instead of one for the word.
    pub bits: bool,
}

/// A written DBC.
#[derive(Clone, Debug)]
pub struct Dbc {
    /// The file, in ISO 8859-1.
    pub bytes: Vec<u8>,
    /// Bus content that is missing in the file, node by node.
    pub omissions: Vec<Omission>,
}

/// Content of a node that a DBC cannot describe.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// The position of the node in the list of nodes.
    pub node: usize,
    /// Its place in the device.
    pub place: Place,
    /// Whether the bus carries it.
    pub is_lost: bool,
    /// The reason why it is missing in the file: lower case, no full stop.
    pub reason: String,
}

/// Writes the DBC of a network.
pub fn write(nodes: &[BusNode<'_>], options: DbcOptions) -> Dbc {
    let mut database = Database::new(nodes, options);
    database.add_services();
    if options.sdo {
        database.add_sdos();
    }
    database.add_pdos();
    database.count_rest();
    database.messages.sort_by_key(|message| message.id);
    database.omissions.sort_by_key(|omission| omission.node);
    Dbc { bytes: text::write(&database), omissions: database.omissions }
}

/// The content of a DBC.
struct Database<'a> {
    options: DbcOptions,
    stations: Vec<Station<'a>>,
    messages: Vec<DbcMessage>,
    omissions: Vec<Omission>,
    /// The entries with a signal: node, index, sub-index.
    carried: BTreeSet<(usize, u16, u8)>,
    /// The communication cycle periods in microseconds, by the CAN-ID of SYNC.
    cycles: BTreeMap<signal::DbcCanId, u32>,
    names: identifier::DbcNames,
}

impl<'a> Database<'a> {
    fn new(nodes: &[BusNode<'a>], options: DbcOptions) -> Self {
        let mut names = identifier::DbcNames::default();
        let stations = nodes.iter().map(|node| Station::new(node, &mut names)).collect();
        Self {
            options,
            stations,
            messages: Vec::new(),
            omissions: Vec::new(),
            carried: BTreeSet::new(),
            cycles: BTreeMap::new(),
            names: identifier::DbcNames::default(),
        }
    }

    fn omit(&mut self, node: usize, place: Place, is_lost: bool, reason: impl Into<String>) {
        self.omissions.push(Omission { node, place, is_lost, reason: reason.into() });
    }

    /// Adds one line about the entries of each node that are not on the bus.
    fn count_rest(&mut self) {
        for node in 0..self.stations.len() {
            let entries = self.stations[node].device.objects.iter().flat_map(|(&index, object)| {
                (0..=u8::MAX).filter(move |&sub| object.has(sub)).map(move |sub| (node, index, sub))
            });
            let rest = entries.filter(|entry| !self.carried.contains(entry)).count();
            if rest > 0 {
                let entries = if rest == 1 { "entry has" } else { "entries have" };
                let reason = format!("{rest} {entries} no signal: a DBC contains only bus traffic");
                self.omit(node, Place { part: Part::Device, field: None }, false, reason);
            }
        }
    }
}

/// A node.
struct Station<'a> {
    device: &'a Device,
    node_id: u8,
    decoder: Decoder<'a>,
    meanings: Meanings<'a>,
    /// The name on the bus.
    name: DbcName,
    /// The name in the description, otherwise the node-ID.
    title: String,
    /// Whether its PDOs are the counterparts of the other nodes' PDOs.
    is_counterpart: bool,
}

/// The language of names.
const LANGUAGE: &str = "en";

impl<'a> Station<'a> {
    fn new(node: &BusNode<'a>, names: &mut DbcNames) -> Self {
        let BusNode { device, node_id, name, is_counterpart } = *node;
        let stated = device.commissioning.as_ref().and_then(|of| of.node_name.as_deref());
        let product = device.device_info.as_ref().and_then(|info| info.product_name.as_deref());
        let mut titles = [name, stated, product].into_iter().flatten().map(str::trim);
        let title = titles.find(|title| !words(title).is_empty());
        let mut title = title.map_or_else(|| format!("Node {node_id}"), str::to_owned);
        let name = names.claim(&words(&title), &node_id.to_string());
        if *name.full.as_ref().unwrap_or(&name.short) != words(&title) {
            title.push_str(&format!(" {node_id}")); // a different node has the same name
        }
        Self {
            device,
            node_id,
            decoder: Decoder::english(device, Some(node_id)),
            meanings: device.meanings_in(LANGUAGE),
            name,
            title,
            is_counterpart,
        }
    }

    /// The name of an entry in English, otherwise the name in the file.
    fn name_of<'e>(&self, entry: &'e Entry) -> &'e str {
        let label = entry.parameter.as_ref().and_then(|parameter| parameter.labels.name_in(LANGUAGE));
        label.map(str::trim).filter(|label| !label.is_empty()).unwrap_or(&entry.name)
    }

    /// The words of a signal: the name in the application, otherwise of the entry. The name of an entry such as `Sub 1`
    /// is meaningless without the object's.
    fn signal_words(&self, index: u16, sub: u8, entry: &Entry) -> String {
        let configured = entry.configured.as_ref().and_then(|configured| configured.denotation.as_deref());
        let parameter = entry.parameter.as_ref().and_then(|of| of.denotation.name_in(LANGUAGE));
        let denotation = configured.or(parameter).map(words).filter(|words| !words.is_empty());
        if let Some(denotation) = denotation {
            return denotation;
        }
        let own = words(self.name_of(entry));
        let object = self.device.object(index).filter(|object| object.object_type().has_subs() || sub > 0);
        let object = object.map(|object| words(self.name_of(&object.main))).unwrap_or_default();
        let is_in = |word: &str| word.len() > 2 && own.split('_').any(|own| own.eq_ignore_ascii_case(word));
        match (object.is_empty(), own.is_empty()) {
            (false, true) => format!("{object}_{sub:02X}"),
            (false, false) if !object.split('_').any(is_in) => format!("{object}_{own}"),
            _ => own,
        }
    }
}
