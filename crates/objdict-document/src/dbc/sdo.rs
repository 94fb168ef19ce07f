//! Messages of SDOs: a multiplexed signal for each entry of at most 4 bytes, which fits in one frame, and the
//! abort code.

use objdict_device::Abort;

use super::Database;
use super::identifier::words;
use super::services::can_id;
use super::signal::{DbcCanId, DbcMessage, DbcSignal, Mux};
use super::value::DbcEntry;
use crate::model::{Access, CobId, DataType, Place, predefined};

/// The bits of a value in a frame.
const FIRST: u32 = 32;
const LONGEST: u32 = 32;

/// The positions of the signals in their messages that select others.
const COMMAND: usize = 0;
const ENTRY: usize = 1;

/// The commands of a client and of a server (CiA 301 §7.2.4.3).
const REQUESTS: [(i128, &str); 7] = [
    (0, "download segment"),
    (1, "initiate download"),
    (2, "initiate upload"),
    (3, "upload segment"),
    (4, "abort"),
    (5, "block upload"),
    (6, "block download"),
];
const RESPONSES: [(i128, &str); 7] = [
    (0, "upload segment"),
    (1, "download segment"),
    (2, "initiate upload"),
    (3, "initiate download"),
    (4, "abort"),
    (5, "block download"),
    (6, "block upload"),
];

const ABORT: u32 = 4;

/// The direction of an SDO.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    Request,
    Response,
}

impl Way {
    /// The command with a value, and the command with only the entry.
    const fn commands(self) -> [u32; 2] {
        match self {
            Self::Request => [1, 2],
            Self::Response => [2, 3],
        }
    }

    /// The commands without an entry: of segments and blocks.
    const fn others(self) -> [[u32; 2]; 3] {
        match self {
            Self::Request => [[0, 0], [3, 3], [5, 6]],
            Self::Response => [[0, 0], [1, 1], [5, 6]],
        }
    }
}

/// The abort codes of CiA 301 with their meanings.
fn aborts() -> impl Iterator<Item = (i128, String)> {
    let codes = (0x0500..=0x0800_u32).flat_map(|class| (0..=0xFF).map(move |code| class << 16 | code));
    let known = codes.map(Abort::from).filter(|abort| !matches!(abort, Abort::Other(_)));
    known.map(|abort| {
        let text = abort.to_string();
        let meaning = text.split_once(": ").map_or(text.as_str(), |(_, meaning)| meaning);
        (abort.code().into(), meaning.to_owned())
    })
}

impl Database<'_> {
    /// The SDO servers of all nodes.
    pub(super) fn add_sdos(&mut self) {
        // a manager without a description is a client
        let servers = (0..self.stations.len()).filter(|&node| !self.stations[node].is_counterpart);
        for node in servers.collect::<Vec<_>>() {
            let device = self.stations[node].device;
            let channels = device.services().sdo_servers;
            if device.object(0x1200).is_none() {
                let cob_id = |base| Some(predefined::per_node(base));
                let (request, response) = (predefined::SDO_REQUEST, predefined::SDO_RESPONSE);
                self.add_sdo(node, 1, Way::Request, cob_id(request));
                self.add_sdo(node, 1, Way::Response, cob_id(response));
            }
            for channel in channels {
                self.add_sdo(node, channel.number, Way::Request, channel.request);
                self.add_sdo(node, channel.number, Way::Response, channel.response);
            }
        }
    }

    fn add_sdo(&mut self, node: usize, number: u16, way: Way, cob_id: Option<CobId>) {
        let Some(cob_id) = cob_id.filter(|cob_id| cob_id.is_valid()) else { return };
        let id = can_id(cob_id, self.stations[node].node_id);
        if self.is_taken(id) {
            let place = Place::entry(0x1200 + number - 1, if way == Way::Request { 1 } else { 2 });
            return self.omit(node, place, true, "a different service uses the SDO's CAN-ID");
        }
        let message = self.sdo(node, id, number, way);
        self.messages.push(message);
    }

    fn sdo(&mut self, node: usize, id: DbcCanId, number: u16, way: Way) -> DbcMessage {
        let title = self.stations[node].title.clone();
        let (name, commands) = match way {
            Way::Request => ("SDO request", REQUESTS),
            Way::Response => ("SDO response", RESPONSES),
        };
        let number = if number == 1 { String::new() } else { format!(" {number}") };
        let name = self.names.claim(&words(&format!("{title} {name}{number}")), &format!("{:X}", id.number));
        let comment = format!("SDO{number} of {title}: values of at most 4 bytes");
        let mut message = DbcMessage::new(id, name, 8, comment);
        let [with_value, without_value] = way.commands();
        let within = |signal: DbcSignal, ranges: &[[u32; 2]]| DbcSignal {
            mux: Mux::within(COMMAND, ranges),
            ..signal
        };
        let mut command = DbcSignal::new("Command", 5, 3).with_values(commands);
        command.mux.selects = true;
        message.push(command);
        let signals = self.entries(node, way);
        let names = signals.iter().filter_map(|signal| {
            let (_, ranges) = signal.mux.within.as_ref()?;
            let name = signal.comment.split(':').take(2).collect::<Vec<_>>().join(":");
            Some((ranges.first()?[0].into(), name))
        });
        let names: Vec<(i128, String)> = names.collect();
        let entry = DbcSignal::new("Entry", 8, 24).with_values(names.iter().cloned());
        let mut entry = within(entry, &[[with_value; 2]]);
        entry.mux.selects = true;
        message.push(entry);
        // in other frames, its bits belong to a value
        let alone = DbcSignal::new("Entry_without_value", 8, 24).with_values(names);
        message.push(within(alone, &[[without_value; 2], [ABORT; 2]]));
        message.push(within(DbcSignal::new("Abort_code", 32, 32).with_values(aborts()), &[[ABORT; 2]]));
        message.push(within(DbcSignal::new("Data", 8, 56), &way.others()));
        signals.into_iter().for_each(|signal| message.push(signal));
        // the manager is the client of the default SDO
        let client = self.manager().filter(|&manager| number.is_empty() && manager != node);
        match way {
            Way::Request => {
                message.senders.extend(client);
                message.received_by(node);
            }
            Way::Response => {
                message.senders.push(node);
                client.into_iter().for_each(|client| message.received_by(client));
            }
        }
        message
    }

    /// The signals of the entries for this direction.
    fn entries(&mut self, node: usize, way: Way) -> Vec<DbcSignal> {
        let station = &self.stations[node];
        let mut signals = Vec::new();
        for (&index, object) in station.device.objects.range(0x1000..) {
            for (sub, entry) in object.entries() {
                let goes = entry.access.is_none_or(match way {
                    Way::Request => Access::is_writable,
                    Way::Response => Access::is_readable,
                });
                let bits = entry.data_type.and_then(DataType::bit_length).map(u32::from);
                let Some(bits) = bits.filter(|&bits| goes && bits <= LONGEST) else { continue };
                let carried = DbcEntry { station, index, sub, entry: Some(&entry) };
                let Ok(own) = carried.signals(bits, false) else { continue };
                self.carried.insert((node, index, sub));
                signals.extend(own.into_iter().map(|signal| DbcSignal {
                    mux: Mux::within(ENTRY, &[[u32::from(index) | u32::from(sub) << 16; 2]]),
                    first: signal.first + FIRST,
                    ..signal
                }));
            }
        }
        signals
    }
}
