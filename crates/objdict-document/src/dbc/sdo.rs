//! Messages of SDOs: a multiplexed signal for each entry of at most 4 bytes, which one frame transfers.

use super::Database;
use super::identifier::words;
use super::message::{CanId, Message};
use super::services::can_id;
use super::signal::{Mux, Signal};
use super::value::Carried;
use crate::model::{Access, CobId, DataType, Place, predefined};

/// The bits of a value in a frame.
const FIRST: u32 = 32;
const LONGEST: u32 = 32;

/// The commands of a client, and those of a server (CiA 301 §7.2.4.3).
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

/// Which way an SDO goes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    Request,
    Response,
}

impl Database<'_> {
    /// The SDO servers of all nodes.
    pub(super) fn add_sdos(&mut self) {
        for node in 0..self.stations.len() {
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
            return self.omit(node, place, true, "another service has the CAN-ID of the SDO");
        }
        let message = self.sdo(node, id, number, way);
        self.messages.push(message);
    }

    fn sdo(&mut self, node: usize, id: CanId, number: u16, way: Way) -> Message {
        let title = self.stations[node].title.clone();
        let (name, commands) = match way {
            Way::Request => ("SDO request", REQUESTS),
            Way::Response => ("SDO response", RESPONSES),
        };
        let number = if number == 1 { String::new() } else { format!(" {number}") };
        let name = self.names.claim(&words(&format!("{title} {name}{number}")), &format!("{:X}", id.number));
        let comment = format!("SDO{number} of {title}: values of at most 4 bytes");
        let mut message = Message::new(id, name, 8, comment);
        message.push(Signal::new("Command", 5, 3).with_values(commands));
        let mut selector = Signal::new("Entry", 8, 24);
        selector.mux = Mux::Selector;
        let signals = self.entries(node, way);
        let names = signals.iter().filter_map(|signal| match signal.mux {
            Mux::In(entry) => {
                Some((entry.into(), signal.comment.split(':').take(2).collect::<Vec<_>>().join(":")))
            }
            _ => None,
        });
        message.push(selector.with_values(names));
        signals.into_iter().for_each(|signal| message.push(signal));
        match way {
            Way::Request => message.received_by(node),
            Way::Response => message.senders.push(node),
        }
        message
    }

    /// The signals of the entries that go this way.
    fn entries(&mut self, node: usize, way: Way) -> Vec<Signal> {
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
                let carried = Carried { station, index, sub, entry: Some(&entry) };
                let Ok(own) = carried.signals(bits, false) else { continue };
                self.carried.insert((node, index, sub));
                signals.extend(own.into_iter().map(|signal| Signal {
                    mux: Mux::In(u32::from(index) | u32::from(sub) << 16),
                    first: signal.first + FIRST,
                    ..signal
                }));
            }
        }
        signals
    }
}
