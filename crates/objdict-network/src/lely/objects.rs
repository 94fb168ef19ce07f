//! The objects of the master.

use std::collections::BTreeMap;

use super::text::{Type, hex};
use super::{LelyWriter, Mirrored};
use crate::compiled::{PdoState, received_type};
use crate::model::{DataType, MappedObject, PdoKind};

const ARRAY: u8 = 8;
const RECORD: u8 = 9;

/// As many nodes as a network has.
const NODES: usize = 127;

/// The locations of the nodes' PDO entries in the master: an entry that an earlier PDO of the node carries
/// keeps its location.
struct MasterPlaces<'a> {
    /// The first index.
    first: u16,
    /// The location of an entry, by node, index and sub-index.
    places: BTreeMap<(usize, u16, u8), (u16, u8)>,
    /// The entries that each PDO adds, with the number of its counterpart.
    added: Vec<(u16, Vec<(MappedObject, Mirrored<'a>)>)>,
}

impl<'a> MasterPlaces<'a> {
    fn new(first: u16, pdos: &[Mirrored<'a>]) -> Self {
        let mut places = Self { first, places: BTreeMap::new(), added: Vec::new() };
        for pdo in pdos {
            let mut added = Vec::new();
            for object in pdo.state.mapping.values() {
                let key = (pdo.slave.node, object.index, object.sub);
                places.places.entry(key).or_insert_with(|| {
                    added.push((*object, *pdo));
                    // a PDO maps 64 objects at most
                    (pdo.index(first), added.len() as u8)
                });
            }
            places.added.push((pdo.number, added));
        }
        places
    }

    fn of(&self, pdo: &Mirrored<'_>, object: &MappedObject) -> MappedObject {
        let (index, sub) =
            self.places.get(&(pdo.slave.node, object.index, object.sub)).copied().unwrap_or_default();
        MappedObject { index, sub, bits: object.bits }
    }
}

/// The indexes of the objects for the entries of PDOs.
pub(super) fn indexes<'a>(first: u16, pdos: &[Mirrored<'a>]) -> impl Iterator<Item = u16> + use<'a> {
    let added = MasterPlaces::new(first, pdos).added.into_iter();
    added.filter(|(_, added)| !added.is_empty()).map(move |(number, _)| first + (number - 1))
}

impl<'a> LelyWriter<'a> {
    /// 1000h to 102Ah.
    pub(super) fn communication(&mut self) {
        let manager = self.manager;
        let [vendor, product, revision] = manager.identity;
        let produces_sync = self.is_strict() || manager.sync_period.value != 0;
        let knowledge = self.knowledge();
        let consumers: Option<Vec<_>> =
            manager.monitors_nodes().then(|| (1..).zip(knowledge.heartbeats()).collect());
        let mut errors: BTreeMap<u8, u8> = [(1, 0)].into();
        errors.extend(&manager.error_behavior);
        let out = &mut self.out;
        out.value("1000", "Device type", Type::U32, "ro", hex(0));
        out.var("1001", "Error register", Type::U8, "ro");
        out.compact("1003", "Pre-defined error field", (ARRAY, Type::U32), "ro", None, 254);
        out.value("1005", "COB-ID SYNC message", Type::U32, "rw", hex(u32::from(produces_sync) << 30 | 0x80));
        out.value("1006", "Communication cycle period", Type::U32, "rw", manager.sync_period.value);
        out.value("1007", "Synchronous window length", Type::U32, "rw", manager.sync_window.value);
        let time = manager.time_cob_id.map_or(0x100, |cob_id| cob_id.value);
        out.value("1012", "COB-ID time stamp object", Type::U32, "rw", hex(time));
        out.var("1013", "High resolution time stamp", Type::U32, "rw");
        out.key("PDOMapping", 1);
        out.value("1014", "COB-ID EMCY", Type::U32, "rw", "$NODEID+0x80");
        out.value("1015", "Inhibit time EMCY", Type::U16, "rw", manager.emcy_inhibit_time);
        if let Some(consumers) = consumers {
            out.compact("1016", "Consumer heartbeat time", (ARRAY, Type::U32), "rw", None, NODES);
            out.numbers("1016", consumers);
        }
        let heartbeat = manager.heartbeat.producer.map_or(0, |time| time.value);
        out.value("1017", "Producer heartbeat time", Type::U16, "rw", heartbeat);
        out.record("1018", "Identity Object", RECORD, 4, "Highest sub-index supported");
        out.value("1018sub1", "Vendor-ID", Type::U32, "ro", hex(vendor));
        out.value("1018sub2", "Product code", Type::U32, "ro", hex(product));
        out.value("1018sub3", "Revision number", Type::U32, "ro", hex(revision));
        out.var("1018sub4", "Serial number", Type::U32, "ro");
        out.value("1019", "Synchronous counter overflow value", Type::U8, "rw", manager.sync_overflow.value);
        out.compact("1028", "Emergency consumer object", (ARRAY, Type::U32), "rw", Some(1 << 31), NODES);
        out.numbers("1028", knowledge.emergencies());
        out.compact("1029", "Error behavior object", (ARRAY, Type::U8), "rw", None, 254);
        out.values(
            "1029",
            errors.into_iter().map(|(sub, value)| (sub, format!("0x{value:02X}"))).collect::<Vec<_>>(),
        );
        out.value("102A", "NMT inhibit time", Type::U16, "rw", manager.nmt_inhibit_time);
    }

    /// 1400h to 1BFFh.
    pub(super) fn pdos(&mut self, received: &[Mirrored<'_>], sent: &[Mirrored<'_>]) {
        // Lely's RPDOs ignore frames with a type from 241 to 253
        let is_strict = self.is_strict();
        let transmission = |state: &PdoState| match state.pdo.kind {
            PdoKind::Tpdo if !is_strict => format!("0x{:02X}", received_type(state.transmission)),
            _ => format!("0x{:02X}", state.transmission),
        };
        let out = &mut self.out;
        for pdo in received {
            let section = format!("{:04X}", pdo.index(0x1400));
            let sub = |number: u8| format!("{section}sub{number}");
            let state = pdo.state;
            out.record(&section, "RPDO communication parameter", RECORD, 5, "highest sub-index supported");
            out.value(&sub(1), "COB-ID used by RPDO", Type::U32, "rw", hex(state.cob_id));
            out.value(&sub(2), "transmission type", Type::U8, "rw", transmission(state));
            out.var(&sub(3), "inhibit time", Type::U16, "rw");
            out.var(&sub(4), "compatibility entry", Type::U8, "rw");
            out.value(&sub(5), "event-timer", Type::U16, "rw", state.deadline);
        }
        self.mappings(0x1600, "RPDO mapping parameter", &MasterPlaces::new(0x2000, received), received);
        let out = &mut self.out;
        for pdo in sent {
            let section = format!("{:04X}", pdo.index(0x1800));
            let sub = |number: u8| format!("{section}sub{number}");
            let state = pdo.state;
            out.record(&section, "TPDO communication parameter", RECORD, 6, "highest sub-index supported");
            out.value(&sub(1), "COB-ID used by TPDO", Type::U32, "rw", hex(state.cob_id));
            out.value(&sub(2), "transmission type", Type::U8, "rw", transmission(state));
            out.value(&sub(3), "inhibit time", Type::U16, "rw", state.inhibit_time);
            out.var(&sub(4), "reserved", Type::U8, "rw");
            out.value(&sub(5), "event timer", Type::U16, "rw", state.event_timer);
            out.value(&sub(6), "SYNC start value", Type::U8, "rw", state.sync_start);
        }
        self.mappings(0x1A00, "TPDO mapping parameter", &MasterPlaces::new(0x2200, sent), sent);
    }

    fn mappings(&mut self, first: u16, name: &str, places: &MasterPlaces<'_>, pdos: &[Mirrored<'_>]) {
        for pdo in pdos {
            let mapped: Vec<MappedObject> =
                pdo.state.mapping.values().map(|object| places.of(pdo, object)).collect();
            self.mapping(pdo.index(first), name, RECORD, &mapped);
        }
    }

    fn mapping(&mut self, index: u16, name: &str, kind: u8, mapped: &[MappedObject]) {
        let section = format!("{index:04X}");
        self.out.compact(&section, name, (kind, Type::U32), "rw", None, mapped.len());
        let values: Vec<(u8, String)> =
            (1..).zip(mapped.iter().map(|object| hex(object.to_number()))).collect();
        self.out.values(&section, values);
    }

    /// 1F22h to 1F8Ah.
    pub(super) fn boot(&mut self) {
        let uploads: Vec<(u8, String)> =
            self.slaves.iter().filter_map(|slave| Some((slave.node_id, self.upload(slave)?))).collect();
        self.files("1F22", "Concise DCF", "Node-ID", &uploads);
        // CiA 302-3: 666E6F63h ("conf"), for one node or by sub-index 80h for all; dcfgen has a byte and no such sub-index
        let (request, all) = if self.is_strict() { (Type::U8, 0) } else { (Type::U32, 1) };
        self.out.compact("1F25", "Configuration request", (ARRAY, request), "wo", None, NODES + all);
        self.of_nodes("1F55", "Expected software identification", Type::U32);
        let programs: Vec<(u8, String)> = self
            .slaves
            .iter()
            .filter_map(|slave| Some((slave.node_id, self.node(slave).boot.software_file.clone()?)))
            .collect();
        self.files("1F58", "Program data", "Program data of node-ID", &programs);
        self.out.value("1F80", "NMT startup", Type::U32, "rw", hex(self.manager.startup.to_number()));
        self.of_nodes("1F81", "NMT slave assignment", Type::U32);
        self.out.numbers("1F81", self.knowledge().assignments());
        self.out.compact("1F82", "Request NMT", (ARRAY, Type::U8), "rw", None, NODES + all);
        let identity = ["Device type identification", "Vendor identification", "Product code"];
        for ((position, index), name) in (0..).zip(0x1F84_u16..).zip(identity) {
            self.identity(position, &format!("{index:04X}"), name);
        }
        self.of_nodes("1F87", "Revision_number", Type::U32);
        self.of_nodes("1F88", "Serial number", Type::U32);
        self.out.value("1F89", "Boot time", Type::U32, "rw", self.manager.boot_time.value);
        self.of_nodes("1F8A", "Restore configuration", Type::U8);
        let restored = self.knowledge().restored().into_iter();
        let restored: Vec<_> = restored.map(|(node_id, sub)| (node_id, format!("0x{sub:02X}"))).collect();
        self.out.values("1F8A", restored);
    }

    /// An array with a number for each node.
    fn of_nodes(&mut self, section: &str, name: &str, data_type: Type) {
        self.out.compact(section, name, (ARRAY, data_type), "rw", None, NODES);
    }

    /// An array of files by node-ID; nothing if there are no files.
    fn files(&mut self, section: &str, name: &str, of_node: &str, files: &[(u8, String)]) {
        if files.is_empty() {
            return;
        }
        self.out.record(section, name, ARRAY, NODES, "Highest sub-index supported");
        for node_id in 1..=NODES as u8 {
            self.out.section(&format!("{section}sub{node_id:X}"));
            self.out.key("ParameterName", format_args!("{of_node} {node_id}"));
            self.out.data(0x000F, "ro");
            for (_, file) in files.iter().filter(|(other, _)| *other == node_id) {
                self.out.key("UploadFile", file);
            }
        }
    }

    /// 1F84h to 1F86h.
    fn identity(&mut self, position: usize, section: &str, name: &str) {
        self.of_nodes(section, name, Type::U32);
        let stated = self.knowledge().identities(position);
        let count = stated.len();
        let has_it = |node_id: u8| {
            let slave = self.slaves.iter().find(|slave| slave.node_id == node_id);
            slave.is_some_and(|slave| self.node(slave).device.entry(0x1018, 2).is_some())
        };
        let listed = stated.into_iter().filter(|(node_id, _)| position != 2 || has_it(*node_id));
        let listed: Vec<(u8, u32)> = listed.collect();
        let count = if self.is_strict() { count } else { listed.len() };
        self.out.section(&format!("{section}Value"));
        self.out.key("NrOfEntries", count);
        for (node_id, number) in listed {
            self.out.key(&node_id.to_string(), hex(number));
        }
    }

    /// The objects for the entries of the nodes' PDOs, and the mappings of the nodes.
    pub(super) fn application(&mut self, received: &[Mirrored<'_>], sent: &[Mirrored<'_>]) {
        self.entries("RPDO", "rww", &MasterPlaces::new(0x2000, received));
        self.entries("TPDO", "rwr", &MasterPlaces::new(0x2200, sent));
        if self.options.remote_pdos {
            self.remote(0x5800, "TPDO", received);
            self.remote(0x5C00, "RPDO", sent);
        }
    }

    fn entries(&mut self, kind: &str, access: &str, places: &MasterPlaces<'_>) {
        let is_strict = self.is_strict();
        for (number, added) in &places.added {
            if added.is_empty() {
                continue;
            }
            let section = format!("{:04X}", places.first + (number - 1));
            let name = format!("Mapped application objects for {kind} {number}");
            self.out.record(&section, &name, RECORD, added.len(), "Highest sub-index supported");
            for (sub, (object, pdo)) in (1_u8..).zip(added) {
                let (name, data_type) = described(pdo, object);
                let data_type = if is_strict { data_type } else { carried_type(data_type, object.bits) };
                self.out.section(&format!("{section}sub{sub:X}"));
                self.out.key("ParameterName", format_args!("{}: {name}", pdo.node.name.value));
                self.out.data(data_type, access);
                self.out.key("PDOMapping", 1);
            }
        }
    }

    fn remote(&mut self, first: u16, kind: &str, pdos: &[Mirrored<'_>]) {
        for pdo in pdos {
            let number = u32::from(pdo.state.pdo.number) << 8 | u32::from(pdo.slave.node_id);
            let name = format!("Remote {kind} number and node-ID");
            self.out.value(&format!("{:04X}", pdo.index(first)), &name, Type::U32, "rw", hex(number));
        }
        for pdo in pdos {
            let mapped: Vec<MappedObject> = pdo.state.mapping.values().copied().collect();
            let name = format!("Remote {kind} mapping parameter");
            self.mapping(pdo.index(first + 0x200), &name, ARRAY, &mapped);
        }
    }
}

/// The data type of an entry that carries this many bits: an unsigned one if the node's mapping has a different length
/// from the entry, or the entry has no type. dcfgen uses the node's type unchanged.
fn carried_type(data_type: u16, bits: u8) -> u16 {
    let known = DataType(data_type);
    let is_right = match known.bit_length() {
        Some(length) => length == bits,
        None => data_type != 0,
    };
    let unsigned = || match bits {
        1 => Some(DataType::BOOLEAN),
        _ if bits.is_multiple_of(8) => DataType::unsigned((bits / 8).into()),
        _ => None,
    };
    // there is no integer type of any other length
    if is_right { data_type } else { unsigned().unwrap_or(DataType::OCTET_STRING).0 }
}

/// The name and the data type of a mapped entry; for a dummy, those of the data type.
fn described(pdo: &Mirrored<'_>, object: &MappedObject) -> (String, u16) {
    if object.is_dummy() {
        return (DataType(object.index).to_string(), object.index);
    }
    let device = &pdo.node.device;
    let entry = device.entry(object.index, object.sub);
    let data_type = crate::download::transferred_type(device, object.index, object.sub);
    let denotation = entry.as_ref().and_then(|entry| entry.configured.as_ref()?.denotation.clone());
    let name = denotation.or_else(|| entry.map(|entry| entry.name.clone())).unwrap_or_default();
    (name.into(), data_type.map_or(0, |data_type| data_type.0))
}
