//! Default values of identity and services, decoded: constants shared by the targets `rust` and `c`.

use super::Note;
use super::table::DeviceTable;
use crate::model::{CobId, Device, Identity, Place, SdoChannel, Services, predefined};

/// A constant.
pub(crate) struct Constant {
    /// In lower case: `emcy_cob_id`.
    pub(crate) name: String,
    /// Its source: `1014h`.
    pub(crate) source: String,
    /// Its meaning: a sentence without full stop and without texts of the description.
    pub(crate) meaning: String,
    pub(crate) value: ConstantValue,
}

/// The value of a constant.
pub(crate) enum ConstantValue {
    /// A function of the node-ID that returns the COB-ID.
    CobId(CobId),
    /// A function of the node-ID that returns the CAN-ID.
    CanId(CobId),
    Flag(bool),
    /// A 32-bit number usually written in hexadecimal.
    Code(u32),
    /// A number and its width: 8, 16 or 32 bits.
    Number(u32, u8),
    /// Node-IDs and times in milliseconds.
    Consumers(Vec<(u8, u16)>),
}

/// A flag of a COB-ID: its name, its meaning if set, and how to read it.
type Flag = (&'static str, &'static str, fn(CobId) -> bool);

/// The constants of a device, only for entries in the table. Values that cannot be decoded are noted.
pub(crate) fn constants(device: &Device, table: &DeviceTable, notes: &mut Vec<Note>) -> Vec<Constant> {
    let services = device.services();
    let mut found = FoundDefault { device, table, notes, constants: Vec::new() };
    found.identity(device.identity());
    found.sync(&services);
    found.others(&services);
    found.heartbeat(&services);
    for channel in &services.sdo_servers {
        found.channel("server", "client", channel);
    }
    for channel in &services.sdo_clients {
        found.channel("client", "server", channel);
    }
    found.constants
}

struct FoundDefault<'a> {
    device: &'a Device,
    table: &'a DeviceTable,
    notes: &'a mut Vec<Note>,
    constants: Vec<Constant>,
}

impl FoundDefault<'_> {
    fn put(&mut self, (index, sub): (u16, u8), name: &str, meaning: &str, value: ConstantValue) {
        let source = if sub == 0 { format!("{index:04X}h") } else { format!("{index:04X}h:{sub:02X}") };
        let (name, meaning) = (name.to_owned(), meaning.to_owned());
        self.constants.push(Constant { name, source, meaning, value });
    }

    /// Whether the table has an entry with a decoded value; notes a value that could not be decoded.
    fn has(&mut self, (index, sub): (u16, u8), is_decoded: bool) -> bool {
        let is_there = |row: &super::table::Row| (row.index, row.sub).cmp(&(index, sub));
        if self.table.rows.binary_search_by(is_there).is_err() {
            return false;
        }
        if let (false, Some(value)) = (is_decoded, self.device.value(index, sub)) {
            let text = format!("no constant for `{value}`, which is not valid for this object on every node");
            self.notes.push(Note::new(Place::entry(index, sub), text));
        }
        is_decoded
    }

    fn number<T: Into<u32>>(&mut self, at: (u16, u8), number: Option<T>, name: &str, meaning: &str) {
        let bits = u8::try_from(size_of::<T>() * 8).unwrap_or(32);
        if let (true, Some(number)) = (self.has(at, number.is_some()), number) {
            self.put(at, name, meaning, ConstantValue::Number(number.into(), bits));
        }
    }

    /// A COB-ID, its CAN-ID and its flags, each with its name and its meaning if set.
    fn cob_id(
        &mut self,
        at: (u16, u8),
        cob_id: Option<CobId>,
        (name, service): (&str, &str),
        flags: &[Flag],
    ) {
        let (true, Some(cob_id)) = (self.has(at, cob_id.is_some()), cob_id) else { return };
        let put = |found: &mut Self, what: &str, meaning: &str, value| {
            found.put(at, &format!("{name}_{what}"), meaning, value);
        };
        let meaning = format!("COB-ID of {service} with the flags of its upper bits");
        put(self, "cob_id", &meaning, ConstantValue::CobId(cob_id));
        put(self, "can_id", &format!("CAN-ID of {service}"), ConstantValue::CanId(cob_id));
        for (what, meaning, flag) in flags {
            put(self, what, &format!("Whether {meaning}"), ConstantValue::Flag(flag(cob_id)));
        }
        let meaning = "Whether the CAN-ID has 29 bits";
        put(self, "is_extended", meaning, ConstantValue::Flag(cob_id.is_extended()));
    }

    fn identity(&mut self, identity: Identity) {
        let Identity { vendor_id, product_code, revision_number, serial_number } = identity;
        for (sub, number, name, meaning) in [
            (1, vendor_id, "vendor_id", "Vendor-ID"),
            (2, product_code, "product_code", "Product code"),
            (3, revision_number, "revision_number", "Revision number"),
            (4, serial_number, "serial_number", "Serial number"),
        ] {
            let at = (Identity::INDEX, sub);
            if let (true, Some(number)) = (self.has(at, number.is_some()), number) {
                self.put(at, name, meaning, ConstantValue::Code(number));
            }
        }
    }

    fn sync(&mut self, services: &Services) {
        let flags: &[Flag] = &[("is_produced", "the device produces SYNC", CobId::bit_30)];
        self.cob_id((0x1005, 0), services.sync, ("sync", "SYNC"), flags);
        let period = services.communication_cycle_period;
        let meaning = "Communication cycle period in microseconds";
        self.number((0x1006, 0), period, "communication_cycle_period", meaning);
        let meaning = "Synchronous window length in microseconds";
        self.number((0x1007, 0), services.synchronous_window, "synchronous_window", meaning);
        let meaning = "Highest counter of SYNC, 0 without counter";
        self.number((0x1019, 0), services.sync_counter_overflow, "sync_counter_overflow", meaning);
    }

    /// TIME and EMCY.
    fn others(&mut self, services: &Services) {
        let flags: &[Flag] = &[
            ("is_consumed", "the device consumes TIME", |cob_id| !cob_id.is_valid()),
            ("is_produced", "the device produces TIME", CobId::bit_30),
        ];
        self.cob_id((0x1012, 0), services.time, ("time", "TIME"), flags);
        let flags: &[Flag] = &[("is_valid", "the device sends EMCY", CobId::is_valid)];
        self.cob_id((0x1014, 0), services.emcy, ("emcy", "EMCY"), flags);
        let meaning = "Inhibit time of EMCY in multiples of 100 microseconds";
        self.number((0x1015, 0), services.emcy_inhibit_time, "emcy_inhibit_time", meaning);
    }

    fn heartbeat(&mut self, services: &Services) {
        let cob_id = predefined::per_node(predefined::ERROR_CONTROL);
        self.constants.push(Constant {
            name: "heartbeat_cob_id".to_owned(),
            source: "CiA 301".to_owned(),
            meaning: "COB-ID of boot-up and heartbeat".to_owned(),
            value: ConstantValue::CobId(cob_id),
        });
        let meaning = "Time between two heartbeats in milliseconds, 0 without heartbeat";
        self.number((0x1017, 0), services.heartbeat_time, "heartbeat_time", meaning);
        for sub in 1..=127 {
            let is_number = |value: &crate::model::Value| value.as_integer().is_some();
            let is_decoded = self.device.value(0x1016, sub).as_deref().is_none_or(is_number);
            self.has((0x1016, sub), is_decoded);
        }
        let consumers = services.heartbeat_consumers.iter();
        let consumers: Vec<(u8, u16)> = consumers
            .filter(|consumer| {
                self.table.rows.iter().any(|row| (row.index, row.sub) == (0x1016, consumer.sub))
            })
            .map(|consumer| (consumer.node_id, consumer.time))
            .collect();
        if !consumers.is_empty() {
            let meaning = "The monitored nodes and their heartbeat times in milliseconds";
            self.put((0x1016, 0), "heartbeat_consumers", meaning, ConstantValue::Consumers(consumers));
        }
    }

    fn channel(&mut self, own: &str, other: &str, channel: &SdoChannel) {
        let SdoChannel { number, index, .. } = *channel;
        let service = format!("SDO {own} {number}");
        let flags: &[Flag] = &[("is_valid", "the COB-ID is in use", CobId::is_valid)];
        let name = format!("sdo_{own}{number}_request");
        let of = format!("{service} from client to server");
        self.cob_id((index, 1), channel.request, (&name, &of), flags);
        let name = format!("sdo_{own}{number}_response");
        let of = format!("{service} from server to client");
        self.cob_id((index, 2), channel.response, (&name, &of), flags);
        let name = format!("sdo_{own}{number}_{other}_node_id");
        let meaning = format!("Node-ID of the {other} of {service}");
        self.number((index, 3), channel.node_id, &name, &meaning);
    }
}
