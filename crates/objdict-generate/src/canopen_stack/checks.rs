//! Features that canopen-stack does not support, and its requirements that the description does not meet.

use crate::Note;
use crate::dictionary::{Dictionary, ResolvedEntry};
use crate::model::{Access, Part, Pdo, PdoKind, Place};
use crate::notes::once_per_device;
use crate::resolve::Datum;

/// Maximum number of rows in the stack.
const MOST_ROWS: usize = i16::MAX as usize;

/// The bit of a COB-ID that says that it is not valid.
const NOT_VALID: u64 = 1 << 31;

/// Adds notes about entries and PDOs, and about missing objects.
pub(super) fn check(dictionary: &Dictionary<'_>, rows: usize, notes: &mut Vec<Note>) {
    let mut common = Vec::new();
    dictionary.entries().for_each(|(object, entry)| self::entry(object.index, entry, &mut common));
    notes.extend(once_per_device(common));
    for pdo in dictionary.device.pdos() {
        communication(&pdo, notes);
        mapping(dictionary, &pdo, notes);
    }
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
    if index == 0x1003 && entry.sub > 0 && resolved.default != Datum::Word(0) {
        notes.push(Note::new(place(), "the error history is empty when the stack starts"));
    }
    if (0x1800..=0x19FF).contains(&index) && entry.sub == 6 {
        notes.push(Note::new(place(), "the stack ignores the SYNC start value"));
    }
    let is_off = |value: &Datum| matches!(value, Datum::Word(cob_id) if cob_id & NOT_VALID != 0);
    if index == 0x1200 && matches!(entry.sub, 1 | 2) && is_off(&resolved.default) {
        let note =
            Note::new(place(), "the COB-ID is not valid (bit 31), so the stack has no SDO server").warning();
        notes.push(note.help("write `$NODEID+0x600` in sub-index 1 and `$NODEID+0x580` in sub-index 2"));
    }
    if resolved.access == Access::Wo && index == 0x1003 {
        notes.push(Note::new(place(), "an SDO can read the entry although it is write-only"));
    }
}

fn communication(pdo: &Pdo<'_>, notes: &mut Vec<Note>) {
    let index = pdo.communication_index();
    if pdo.communication.is_none() {
        return;
    }
    let mut say = |sub: u8, text: &str, help: Option<&'static str>| {
        let note = Note::new(Place::entry(index, sub), text);
        notes.push(Note { help: help.map(Into::into), ..note });
    };
    match pdo.cob_id {
        Some(id) if id.is_valid() => {
            if id.is_extended() {
                say(1, "the stack does not support 29-bit CAN-IDs for PDOs", None);
            }
            if pdo.kind == PdoKind::Tpdo && !id.bit_30() {
                let text = "the stack does not transmit a TPDO whose COB-ID has bit 30 clear (RTR allowed)";
                let help = "set bit 30, as in `$NODEID+0x40000180`";
                say(1, text, Some(help));
            }
        }
        Some(_) => {}
        None => say(1, "the stack ignores a PDO without a COB-ID", None),
    }
    match pdo.transmission_type {
        None => say(2, "the stack ignores a PDO without a transmission type", None),
        Some(252 | 253) => say(2, "the stack does not answer RTR frames", None),
        Some(_) => {}
    }
}

fn mapping(dictionary: &Dictionary<'_>, pdo: &Pdo<'_>, notes: &mut Vec<Note>) {
    let index = pdo.mapping_index();
    if pdo.mapping.is_none() {
        let text = "the stack ignores a PDO without a mapping";
        notes.push(Note::new(Place::object(pdo.communication_index()), text));
        return;
    }
    if pdo.is_multiplexed() || pdo.mapped_count.is_some_and(|count| count > 8) {
        let text = "the stack maps at most 8 objects and does not support multiplexed PDOs";
        notes.push(Note::new(Place::entry(index, 0), text));
    }
    let has = |index, sub| dictionary.entry(index, sub).is_some();
    for slot in pdo.used_slots() {
        let Some(mapped) = slot.object.filter(|object| !object.is_unused()) else { continue };
        let is_misread = mapped.bits % 8 != 0 || mapped.bits == 0;
        let text = if is_misread {
            "the stack maps whole bytes only, and misreads the entries behind"
        } else if mapped.is_dummy() && pdo.kind == PdoKind::Rpdo && (2..=7).contains(&mapped.index) {
            continue;
        } else if mapped.is_dummy() {
            "the stack does not support this dummy entry"
        } else if !has(mapped.index, mapped.sub) {
            "the stack ignores a PDO that maps a missing entry"
        } else {
            continue;
        };
        let note = Note::new(Place::entry(index, slot.sub), format!("{text} (`{mapped}`)"));
        notes.push(if is_misread { note.warning() } else { note });
    }
}

/// Requirements of the stack on the whole dictionary.
fn demands(dictionary: &Dictionary<'_>, rows: usize, notes: &mut Vec<Note>) {
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
