//! Messages of the services of CiA 301: NMT, SYNC, TIME, EMCY, heartbeat.

use std::collections::BTreeMap;

use super::Database;
use super::identifier::words;
use super::signal::{DbcCanId, DbcMessage, DbcSignal};
use crate::model::{CobId, Place, predefined};
use crate::profile;

/// The commands of NMT (CiA 301 §7.2.8.3.1).
const COMMANDS: [(i128, &str); 5] = [
    (1, "start"),
    (2, "stop"),
    (128, "enter pre-operational"),
    (129, "reset node"),
    (130, "reset communication"),
];

/// The states of NMT in a heartbeat (CiA 301 §7.2.8.3.2).
const STATES: [(i128, &str); 4] =
    [(0, "boot-up"), (4, "stopped"), (5, "operational"), (127, "pre-operational")];

impl Database<'_> {
    /// The services of all nodes, those with fixed CAN-IDs first.
    pub(super) fn add_services(&mut self) {
        self.add_nmt();
        for node in 0..self.stations.len() {
            self.add_heartbeat(node);
        }
        self.add_sync();
        self.add_time();
        for node in 0..self.stations.len() {
            self.add_emcy(node);
        }
    }

    /// A message of a service with a unique name.
    fn service(&mut self, id: DbcCanId, name: &str, length: u32, comment: impl Into<String>) -> DbcMessage {
        let name = self.names.claim(&words(name), &format!("{:X}", id.number));
        DbcMessage::new(id, name, length, comment)
    }

    /// The position of the network manager, if a node states that it is.
    pub(super) fn manager(&self) -> Option<usize> {
        let is_manager = |of: &crate::model::Commissioning| of.manager == Some(true);
        self.stations.iter().position(|station| station.device.commissioning.as_ref().is_some_and(is_manager))
    }

    fn add_nmt(&mut self) {
        let mut message = self.service(DbcCanId::base(0), "NMT", 2, "NMT: commands of the manager");
        let nodes = self.stations.iter().map(|station| (station.node_id.into(), station.title.clone()));
        let nodes: Vec<(i128, String)> = [(0, "all nodes".to_owned())].into_iter().chain(nodes).collect();
        message.push(DbcSignal::new("Command", 0, 8).with_values(COMMANDS));
        message.push(DbcSignal::new("Node", 8, 8).with_values(nodes));
        let manager = self.manager();
        message.senders.extend(manager);
        for node in (0..self.stations.len()).filter(|&node| manager != Some(node)) {
            message.received_by(node);
        }
        self.messages.push(message);
    }

    /// The nodes with a COB-ID of a service for the whole network, by CAN-ID.
    fn users(&self, index: u16, usual: u16) -> BTreeMap<DbcCanId, Vec<(usize, CobId)>> {
        let mut users: BTreeMap<DbcCanId, Vec<(usize, CobId)>> = BTreeMap::new();
        for (node, station) in self.stations.iter().enumerate() {
            if let Some(object) = station.device.object(index) {
                let stated = object.value(0).map(|value| CobId::from_value(&value));
                let Some(cob_id) = stated.unwrap_or(Some(CobId::new(usual.into()))) else { continue };
                users.entry(can_id(cob_id, station.node_id)).or_default().push((node, cob_id));
            }
        }
        users
    }

    fn add_sync(&mut self) {
        for (id, users) in self.users(0x1005, predefined::SYNC) {
            if self.is_taken(id) {
                let reason = "a different service uses the CAN-ID of SYNC";
                users
                    .into_iter()
                    .for_each(|(node, _)| self.omit(node, Place::entry(0x1005, 0), true, reason));
                continue;
            }
            let facts: Vec<_> =
                users.iter().map(|(node, _)| self.stations[*node].device.services()).collect();
            let counts = facts.iter().any(|of| of.sync_counter_overflow.is_some_and(|highest| highest > 0));
            let mut message = self.service(id, "SYNC", u32::from(counts), "SYNC (1005h)");
            if counts {
                message.push(DbcSignal::new("Counter", 0, 8));
            }
            for ((node, cob_id), facts) in users.into_iter().zip(facts) {
                if cob_id.bit_30() {
                    message.senders.push(node);
                    let period = facts.communication_cycle_period.filter(|&period| period > 0);
                    if let Some(period) = period.filter(|_| message.cycle.is_none()) {
                        self.cycles.insert(id, period);
                        message.cycle = self.milliseconds(node, period.into(), Place::entry(0x1006, 0));
                    }
                } else {
                    message.received_by(node);
                }
            }
            self.messages.push(message);
        }
    }

    /// A time in microseconds in the unit of a DBC. Times that are not a whole number of milliseconds are
    /// omitted.
    pub(super) fn milliseconds(&mut self, node: usize, time: u64, place: Place) -> Option<u32> {
        if !time.is_multiple_of(1000) {
            let reason = format!("GenMsgCycleTime has whole milliseconds, and the time is {time} µs");
            self.omit(node, place, true, reason);
            return None;
        }
        u32::try_from(time / 1000).ok()
    }

    fn add_time(&mut self) {
        for (id, users) in self.users(0x1012, predefined::TIME) {
            let is_used = |(_, cob_id): &(usize, CobId)| cob_id.bit_30() || !cob_id.is_valid();
            if !users.iter().any(is_used) {
                continue;
            }
            if self.is_taken(id) {
                let reason = "a different service uses the CAN-ID of TIME";
                users
                    .into_iter()
                    .for_each(|(node, _)| self.omit(node, Place::entry(0x1012, 0), true, reason));
                continue;
            }
            let mut message = self.service(id, "TIME", 6, "TIME (1012h)");
            message.push(DbcSignal::new("Milliseconds", 0, 28).in_unit("ms"));
            message.push(DbcSignal::new("Days_since_1984", 32, 16).in_unit("d"));
            for (node, cob_id) in users {
                if cob_id.bit_30() {
                    message.senders.push(node);
                }
                if !cob_id.is_valid() {
                    message.received_by(node);
                }
            }
            self.messages.push(message);
        }
    }

    fn add_emcy(&mut self, node: usize) {
        let station = &self.stations[node];
        let Some(object) = station.device.object(0x1014) else { return };
        let usual = predefined::per_node(predefined::EMCY);
        let stated = object.value(0).map_or(Some(usual), |value| CobId::from_value(&value));
        let Some(cob_id) = stated else { return };
        if !cob_id.is_valid() {
            let reason = "EMCY is not valid (bit 31 of its COB-ID)";
            return self.omit(node, Place::entry(0x1014, 0), false, reason);
        }
        let (id, title) = (can_id(cob_id, station.node_id), station.title.clone());
        if self.is_taken(id) {
            let reason = "a different service uses the CAN-ID of EMCY";
            return self.omit(node, Place::entry(0x1014, 0), true, reason);
        }
        let mut message = self.service(id, &format!("{title} EMCY"), 8, format!("EMCY of {title} (1014h)"));
        message.push(DbcSignal::new("Error_code", 0, 16).with_values(crate::describe::error_codes()));
        message.push(self.error_register(node));
        message.push(DbcSignal::new("Error_field", 24, 40));
        message.senders.push(node);
        let watches = |other: &usize| {
            let numbers = self.stations[*other].device.object(0x1028);
            let value = numbers.and_then(|object| object.value(self.stations[node].node_id));
            value.and_then(|value| CobId::from_value(&value)).is_some_and(|consumed| {
                consumed.is_valid() && can_id(consumed, self.stations[*other].node_id) == id
            })
        };
        let receivers: Vec<usize> = (0..self.stations.len()).filter(watches).collect();
        receivers.into_iter().for_each(|node| message.received_by(node));
        self.messages.push(message);
    }

    /// 1001h in a frame of EMCY.
    fn error_register(&self, node: usize) -> DbcSignal {
        let documents = profile::of_object(self.stations[node].device, 0x1001).map(|(_, facts)| facts);
        let bits = profile::bits(documents, 0);
        let bits: Vec<String> = bits.iter().map(|bit| format!("{} {}", bit.first, bit.name)).collect();
        let comment = format!("1001h:00; bits: {}", bits.join(", "));
        DbcSignal { comment, ..DbcSignal::new("Error_register", 16, 8) }
    }

    fn add_heartbeat(&mut self, node: usize) {
        let station = &self.stations[node];
        let id = DbcCanId::base(u32::from(predefined::ERROR_CONTROL) + u32::from(station.node_id));
        let (title, facts) = (station.title.clone(), station.device.services());
        let is_guarded = station.device.object(0x100C).is_some();
        let comment = format!("heartbeat of {title} (1017h): boot-up, state of NMT");
        let mut message = self.service(id, &format!("{title} heartbeat"), 1, comment);
        message.push(DbcSignal::new("State", 0, 7).with_values(STATES));
        if is_guarded {
            message.push(DbcSignal {
                comment: "changes with each answer to node guarding, 0 in a heartbeat".to_owned(),
                ..DbcSignal::new("Toggle", 7, 1)
            });
        }
        message.senders.push(node);
        message.cycle = facts.heartbeat_time.filter(|&time| time > 0).map(u32::from);
        let node_id = self.stations[node].node_id;
        for (other, station) in self.stations.iter().enumerate() {
            let consumers = station.device.services().heartbeat_consumers;
            if consumers.iter().any(|consumer| consumer.node_id == node_id) {
                message.received_by(other);
            }
        }
        self.messages.push(message);
    }

    pub(super) fn is_taken(&self, id: DbcCanId) -> bool {
        self.messages.iter().any(|message| message.id == id)
    }
}

pub(super) fn can_id(cob_id: CobId, node_id: u8) -> DbcCanId {
    DbcCanId { is_extended: cob_id.is_extended(), number: cob_id.can_id(node_id) }
}
