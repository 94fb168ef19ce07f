//! Features that canopen-stack does not support, and its requirements that the description does not meet.

use crate::Note;
use crate::dictionary::{ResolvedEntry, TableDictionary};
use crate::model::{Access, Part, Pdo, PdoKind, Place};
use crate::notes::once_per_device;
use crate::resolve::Encoded;
use crate::startup;

/// Maximum number of rows in the stack.
const MOST_ROWS: usize = i16::MAX as usize;

/// Adds notes about entries and PDOs, and about missing objects.
pub(super) fn check(dictionary: &TableDictionary<'_>, rows: usize, notes: &mut Vec<Note>) {
    let mut common = Vec::new();
    dictionary.entries().for_each(|(object, entry)| self::entry(object.index, entry, &mut common));
    notes.extend(once_per_device(common));
    notes.extend(dictionary.device.pdos().filter_map(|pdo| transmission(&pdo)));
    notes.append(&mut startup::notes(&startup::CANOPEN_STACK, dictionary));
    demands(dictionary, rows, notes);
}

fn entry(index: u16, entry: &ResolvedEntry<'_>, notes: &mut Vec<Note>) {
    let resolved = &entry.resolved;
    let place = || Place::entry(index, entry.sub);
    if let (Some(field), true) = (resolved.limit(), resolved.access.is_writable()) {
        notes.push(Note::new(place().field(field), "the stack does not enforce limits"));
    }
    if resolved.sdo() == (true, true) && resolved.tpdo != resolved.rpdo {
        let kind = if resolved.tpdo { PdoKind::Rpdo } else { PdoKind::Tpdo };
        let text =
            format!("the stack also allows the entry in {kind}s: its row has one flag for both directions");
        notes.push(Note::new(place(), text));
    }
    if (resolved.tpdo || resolved.rpdo) && !matches!(resolved.shape.size(), 1 | 2 | 4) {
        let text = "PDOs of the stack carry values of 1, 2 and 4 bytes; the application transfers others in `COTpdoReadData` and `CORpdoWriteData`";
        notes.push(Note::new(place(), text));
    }
    if index == 0x1003 && entry.sub > 0 && resolved.default != Encoded::Word(0) {
        notes.push(Note::new(place(), "the error history is empty when the stack starts"));
    }
    if (0x1800..=0x19FF).contains(&index) && entry.sub == 6 {
        notes.push(Note::new(place(), "the stack ignores the SYNC start value"));
    }
    if resolved.access == Access::Wo && index == 0x1003 {
        notes.push(Note::new(place(), "an SDO can read the entry although it is write-only"));
    }
}

/// What the transmission types of a PDO mean to the stack.
fn transmission(pdo: &Pdo<'_>) -> Option<Note> {
    let place = Place::entry(pdo.communication_index(), 2);
    let is_polled = matches!(pdo.transmission_type, Some(252 | 253));
    is_polled.then(|| Note::new(place, "the stack does not answer RTR frames"))
}

/// Requirements of the stack on the whole dictionary.
fn demands(dictionary: &TableDictionary<'_>, rows: usize, notes: &mut Vec<Note>) {
    let has = |index, sub| dictionary.entry(index, sub).is_some();
    let device = |text: &str| Note::new(Part::Device, text.to_owned());
    if !has(0x1001, 0) {
        notes.push(device("without 1001h the stack reports an error when it starts, and sends no EMCY"));
    }
    if !has(0x1014, 0) {
        notes.push(device("without 1014h the stack sends no EMCY"));
    }
    if !has(0x1200, 1) {
        let note = device("without 1200h the stack has no SDO server; it is added with the default COB-IDs");
        notes.push(note.help("describe 1200h, `ro`, with `$NODEID+0x600` and `$NODEID+0x580`"));
    }
    if rows > MOST_ROWS {
        notes.push(device(&format!("{rows} rows, but the stack supports at most {MOST_ROWS}")));
    }
    // the stack does not initialise the first row, which is harmless for plain values
    let first = dictionary.objects.first().map(|object| object.index);
    let special = |index: &u16| *index >= 0x1003 && super::special::special(*index, 0, false).is_some();
    if let Some(first) = first.filter(special) {
        let text = "the stack does not initialise the first object of a dictionary; 1000h must precede it";
        notes.push(Note::new(Place::object(first), text));
    }
    if has(0, 0) {
        notes
            .push(Note::new(Place::entry(0, 0), "the stack interprets index 0 as the end of the dictionary"));
    }
}
