//! The mapping of PDOs.

use super::ObjdictMacrosView;
use crate::Note;
use crate::model::{Pdo, PdoKind, Place};

/// Number of mapping entries per PDO.
pub(super) const SLOTS: usize = 8;

/// A PDO.
pub(super) struct MappingRow {
    pub(super) kind: PdoKind,
    pub(super) number: u16,
    /// The mapped entries.
    pub(super) entries: Vec<String>,
}

impl MappingRow {
    /// The number of unused mapping entries.
    pub(super) fn unused(&self) -> usize {
        SLOTS.saturating_sub(self.entries.len())
    }
}

/// All PDOs with a mapping, by number per direction; numbers without one are empty.
pub(super) fn pdos(tables: &ObjdictMacrosView<'_>, notes: &mut Vec<Note>) -> Vec<MappingRow> {
    let mut rows = Vec::new();
    for kind in PdoKind::ALL {
        let of_kind: Vec<Pdo<'_>> = tables.dictionary.device.pdos().filter(|pdo| pdo.kind == kind).collect();
        let last = of_kind.iter().map(|pdo| pdo.number).max().unwrap_or(0);
        for number in 1..=last {
            let pdo = of_kind.iter().find(|pdo| pdo.number == number);
            let entries = pdo.map(|pdo| entries(pdo, tables, notes)).unwrap_or_default();
            rows.push(MappingRow { kind, number, entries });
        }
    }
    rows
}

fn entries(pdo: &Pdo<'_>, tables: &ObjdictMacrosView<'_>, notes: &mut Vec<Note>) -> Vec<String> {
    let index = pdo.mapping_index();
    let mut entries = Vec::new();
    for (slot, mapped) in pdo.mapped_slots() {
        let place = Place::entry(index, slot);
        if entries.len() == SLOTS {
            notes.push(Note::new(place, format!("a PDO has {SLOTS} mapping entries at most")));
            break;
        }
        let (object, sub, bits) = (mapped.index, mapped.sub, mapped.bits);
        let address = match tables.address(object, sub) {
            Some(address) => address.to_owned(),
            None if mapped.is_dummy() => "NULL".to_owned(),
            None => {
                let text = format!("`{mapped}` is not in the dictionary; its address is NULL");
                notes.push(Note::new(place, text));
                "NULL".to_owned()
            }
        };
        entries.push(format!("MAP_ENTRY(0x{object:04X}, 0x{sub:02X}, {bits}, {address})"));
    }
    if pdo.is_multiplexed() {
        notes.push(Note::new(Place::entry(index, 0), "multiplexed PDOs are not supported"));
    }
    entries
}
