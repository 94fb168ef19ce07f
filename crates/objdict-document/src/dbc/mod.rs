//! The frames of configured nodes as a DBC: the messages and signals that tools of the CAN bus decode.
//!
//! A DBC holds what is on the bus: the PDOs of each node, its EMCY and heartbeat, SYNC, TIME and NMT, and SDO if that is
//! asked for. Everything else of a dictionary has no place in it.

mod decimal;
mod identifier;
mod message;
mod pdo;
mod sdo;
mod services;
mod signal;
mod station;
#[cfg(test)]
mod tests;
mod text;
mod value;

use std::collections::{BTreeMap, BTreeSet};

use self::message::DbcMessage;
use self::station::Station;
pub(crate) use self::value::{Scaled, scaling_of};
use crate::model::{Device, Part, Place};

/// A node whose frames are described.
#[derive(Clone, Copy, Debug)]
pub struct BusNode<'a> {
    /// The device after configuration.
    pub device: &'a Device,
    /// The node-ID, 1 to 127. Each node has its own.
    pub node_id: u8,
    /// The name; `None` for the one that the device states.
    pub name: Option<&'a str>,
    /// Whether its PDOs are only the other sides of those of the other nodes, as for a manager without a description: it
    /// sends and receives their messages.
    pub is_counterpart: bool,
}

/// What a DBC describes beyond PDOs and the services of CiA 301.
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
    /// What is on the bus and not in the file, node by node.
    pub omissions: Vec<Omission>,
}

/// What a DBC does not say of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// The position of the node in the list of nodes.
    pub node: usize,
    /// Where the device says it.
    pub place: Place,
    /// Whether the bus carries it.
    pub is_lost: bool,
    /// Why it is not in the file: lower case, no full stop.
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
    cycles: BTreeMap<message::DbcCanId, u32>,
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

    /// One line for the entries of each node that are not on the bus.
    fn count_rest(&mut self) {
        for node in 0..self.stations.len() {
            let entries = self.stations[node].device.objects.iter().flat_map(|(&index, object)| {
                (0..=u8::MAX).filter(move |&sub| object.has(sub)).map(move |sub| (node, index, sub))
            });
            let rest = entries.filter(|entry| !self.carried.contains(entry)).count();
            if rest > 0 {
                let entries = if rest == 1 { "entry has" } else { "entries have" };
                let reason = format!("{rest} {entries} no signal: a DBC has only what is on the bus");
                self.omit(node, Place { part: Part::Device, field: None }, false, reason);
            }
        }
    }
}
