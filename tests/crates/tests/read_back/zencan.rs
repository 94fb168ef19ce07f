//! zencan: zencan-build accepts the configuration, and the objects of its node answer as described.

use std::collections::BTreeMap;

use objdict::generate::Note;
use objdict::model::TypeKind;
use zencan_node::common::NodeId;
use zencan_node::common::objects::{DataType, PdoMappable};
use zencan_node::common::sdo::AbortCode;
use zencan_node::object_dict::{ODEntry, ScalarField, SubObjectAccess};
use zencan_node::{Callbacks, Node, NodeMbox, NodeState};

use crate::truth::{Row, truth};
use crate::{counted, devices, generated, noted};

#[allow(clippy::all, missing_docs, unreachable_pub, unsafe_code, reason = "made by zencan-build")]
mod nodes {
    use super::{Start, start};

    include!(concat!(env!("OUT_DIR"), "/zencan.rs"));
}

type Table = &'static [ODEntry<'static>];

/// Starts the node of a device with a node-ID.
type Start = fn(u8) -> Table;

/// Starts a node, so that its PDOs get their defaults.
fn start(node_id: u8, mbox: &'static NodeMbox, state: &'static NodeState<'static>, table: Table) -> Table {
    let _ = Node::new(NodeId::new(node_id).unwrap(), Callbacks::new(), mbox, state, table);
    table
}

/// The data of an SDO upload.
fn read(entry: &ODEntry<'_>, sub: u8) -> Result<Vec<u8>, AbortCode> {
    let mut buffer = [0; 882];
    let length = entry.data.read(sub, 0, &mut buffer)?;
    Ok(buffer[..length].to_vec())
}

/// Entries that differ from the description, by kind of difference.
#[derive(Default)]
struct Differences(BTreeMap<&'static str, Vec<(u16, u8)>>);

/// The note texts for each kind.
const KINDS: [&str; 9] = [
    "zencan has no such entry",
    "zencan adds the entry",
    "the value is ",
    "in zencan an SDO can read",
    "in zencan no SDO can read",
    "in zencan an SDO can write",
    "in zencan no SDO can write",
    "zencan does not allow the entry in PDOs",
    " becomes `",
];

impl Differences {
    fn put(&mut self, kind: &'static str, row: &Row) {
        assert!(KINDS.contains(&kind));
        self.0.entry(kind).or_default().push((row.index, row.sub));
    }

    fn of_entry(&mut self, name: &str, row: &Row, table: Table) {
        let entry = table.iter().find(|entry| entry.index == row.index);
        let Some((entry, info)) = entry.and_then(|entry| Some((entry, entry.data.sub_info(row.sub).ok()?)))
        else {
            self.put("zencan has no such entry", row);
            return;
        };
        match (info.access_type.is_readable(), row.read) {
            (true, false) => self.put("in zencan an SDO can read", row),
            (false, true) => self.put("in zencan no SDO can read", row),
            _ => {}
        }
        match (info.access_type.is_writable(), row.write) {
            (true, false) => self.put("in zencan an SDO can write", row),
            (false, true) => self.put("in zencan no SDO can write", row),
            _ => {}
        }
        let mapping = match (row.tpdo, row.rpdo) {
            (false, false) => PdoMappable::None,
            (true, false) => PdoMappable::Tpdo,
            (false, true) => PdoMappable::Rpdo,
            (true, true) => PdoMappable::Both,
        };
        if info.pdo_mapping != mapping {
            assert_eq!(info.pdo_mapping, PdoMappable::None, "{name}: {row}");
            self.put("zencan does not allow the entry in PDOs", row);
        }
        let data_type = match row.kind {
            Some(TypeKind::TimeOfDay) => DataType::TimeOfDay,
            Some(TypeKind::TimeDifference) => DataType::TimeDifference,
            _ => DataType::from(row.data_type.unwrap()),
        };
        let has_note = if row.sub == 0 {
            row.kind != Some(TypeKind::Unsigned(8))
        } else {
            !is_made_by_zencan(row.index)
        };
        if info.data_type != data_type && has_note {
            self.put(" becomes `", row);
        }
        match read(entry, row.sub) {
            Ok(bytes) if Some(&bytes) != row.default.as_ref() && (row.index, row.sub) != (0x1010, 1) => {
                self.put("the value is ", row);
            }
            Ok(_) => {}
            Err(AbortCode::WriteOnly) => assert!(!row.read, "{name}: {row}"),
            Err(AbortCode::ResourceNotAvailable) => {
                assert_eq!(row.kind, Some(TypeKind::Domain), "{name}: {row}");
            }
            Err(abort) => {
                assert_eq!((row.index, row.sub), (0x1010, 0), "{name}: {row}: {abort:?}");
                if row.default != Some(vec![1]) {
                    self.put("the value is ", row);
                }
            }
        }
    }

    fn added(&mut self, rows: &[Row], table: Table) {
        for entry in table {
            for sub in 0..=u8::MAX {
                let is_described = rows.iter().any(|row| (row.index, row.sub) == (entry.index, sub));
                if !is_described && entry.data.sub_info(sub).is_ok() {
                    self.0.entry("zencan adds the entry").or_default().push((entry.index, sub));
                }
            }
        }
    }

    fn compare(&self, name: &str, notes: &[Note], rows: &[Row]) {
        for kind in KINDS {
            let mut observed = counted(self.0.get(kind).map_or(&[], Vec::as_slice));
            let mut noted = noted(notes, kind);
            if kind == "the value is " {
                // write-only entries cannot be read
                for row in rows.iter().filter(|row| !row.read) {
                    observed.remove(&row.index);
                    noted.remove(&row.index);
                }
            }
            assert_eq!(observed, noted, "{name}: {kind}");
        }
    }
}

fn is_made_by_zencan(index: u16) -> bool {
    matches!(index, 0x1000 | 0x1001 | 0x1008..=0x100A | 0x1010 | 0x1017 | 0x1018 | 0x1400..=0x1BFF)
}

#[test]
fn every_entry_is_read_back_or_has_its_note() {
    let mut compared = 0;
    for ((name, device), &(known, start)) in devices::devices().iter().zip(nodes::DEVICES) {
        assert_eq!(name, known);
        let node_id = device.node_id().unwrap_or(5);
        let table = start(node_id);
        let rows = truth(device, node_id);
        let mut differences = Differences::default();
        rows.iter().for_each(|row| differences.of_entry(name, row, table));
        differences.added(&rows, table);
        differences.compare(name, &generated(device, "zencan").notes, &rows);
        compared += rows.len();
    }
    assert!(compared > 1000, "only {compared} entries were compared");
}

/// Why a BOOLEAN cannot be a `boolean` in zencan: its SDO server uses a read buffer longer than one byte.
#[test]
fn zencan_reads_no_boolean_of_its_own() {
    let own = ScalarField::<bool>::new(true);
    assert!(own.read(0, &mut [0; 882]).is_err());
    assert!(ScalarField::<u8>::new(1).read(0, &mut [0; 882]).is_ok());
}

/// The PDOs of a valid device are those of its description.
#[test]
fn pdos_have_their_defaults() {
    let table = nodes::DEVICES.iter().find(|(name, _)| *name == "io_401").map(|(_, start)| start(9)).unwrap();
    let read = |index, sub| read(table.iter().find(|entry| entry.index == index).unwrap(), sub).unwrap();
    assert_eq!(read(0x1400, 1), 0x209_u32.to_le_bytes());
    assert_eq!(read(0x1800, 1), 0x189_u32.to_le_bytes());
    assert_eq!(read(0x1A00, 0), [2]);
    assert_eq!(read(0x1A00, 1), 0x6000_0108_u32.to_le_bytes());
}
