//! What canopen-stack does not keep, and what it needs and the description lacks.

use crate::Note;
use crate::dictionary::{Dictionary, ResolvedEntry};
use crate::model::{Access, Field, Part, Pdo, PdoKind, Place};
use crate::notes::once_per_device;
use crate::resolve::Datum;

/// The most rows that the stack can count.
const MOST_ROWS: usize = i16::MAX as usize;

/// Notes about entries and PDOs, and about objects that there are not.
pub(super) fn check(dictionary: &Dictionary<'_>, rows: usize, notes: &mut Vec<Note>) {
    let mut common = Vec::new();
    for object in &dictionary.objects {
        for entry in &object.entries {
            self::entry(object.index, entry, &mut common);
        }
    }
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
    let limit = match (&resolved.low, &resolved.high) {
        (Some(_), _) => Some(Field::LowLimit),
        (None, Some(_)) => Some(Field::HighLimit),
        _ => None,
    };
    if let (Some(field), true) = (limit, resolved.access.is_writable()) {
        notes.push(Note::new(place().field(field), "the stack does not keep limits"));
    }
    let both = resolved.access.is_readable() && resolved.access.is_writable();
    if both && resolved.tpdo != resolved.rpdo {
        let kind = if resolved.tpdo { PdoKind::Rpdo } else { PdoKind::Tpdo };
        let text =
            format!("the stack lets {kind}s carry the entry too: its row has one flag for both directions");
        notes.push(Note::new(place(), text));
    }
    if (resolved.tpdo || resolved.rpdo) && !matches!(resolved.shape.size(), 1 | 2 | 4) {
        let text = "PDOs of the stack carry values of 1, 2 and 4 bytes; of others only what the application does in `COTpdoReadData` and `CORpdoWriteData`";
        notes.push(Note::new(place(), text));
    }
    if index == 0x1003 && entry.sub > 0 && resolved.default != Datum::Word(0) {
        notes.push(Note::new(place(), "the error history is empty when the stack begins"));
    }
    if (0x1800..=0x19FF).contains(&index) && entry.sub == 6 {
        notes.push(Note::new(place(), "the stack does not act on the SYNC start value"));
    }
    if resolved.access == Access::Wo && index == 0x1003 {
        notes.push(Note::new(place(), "the stack reads the entry although it can only be written"));
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
                say(1, "the stack has no PDOs with 29 bits of CAN-ID", None);
            }
            if pdo.kind == PdoKind::Tpdo && !id.bit_30() {
                let text = "the stack does not transmit a TPDO whose COB-ID has bit 30 clear (RTR allowed)";
                let help = "write `$NODEID+0x40000180` and the like";
                say(1, text, Some(help));
            }
        }
        Some(_) => {}
        None => say(1, "without a COB-ID the stack does not run the PDO", None),
    }
    match pdo.transmission_type {
        None => say(2, "without a transmission type the stack does not run the PDO", None),
        Some(252 | 253) => say(2, "the stack does not answer RTR frames", None),
        Some(_) => {}
    }
}

fn mapping(dictionary: &Dictionary<'_>, pdo: &Pdo<'_>, notes: &mut Vec<Note>) {
    let index = pdo.mapping_index();
    if pdo.mapping.is_none() {
        let text = "without its mapping the stack does not run the PDO";
        notes.push(Note::new(Place::object(pdo.communication_index()), text));
        return;
    }
    if pdo.is_multiplexed() || pdo.mapped_count.is_some_and(|count| count > 8) {
        let text = "the stack maps 8 objects at most, and no multiplexed PDOs";
        notes.push(Note::new(Place::entry(index, 0), text));
    }
    for slot in pdo.used_slots() {
        let Some(mapped) = slot.object.filter(|object| !object.is_unused()) else { continue };
        let text = if mapped.bits % 8 != 0 || mapped.bits == 0 {
            "the stack maps whole bytes only"
        } else if mapped.is_dummy() && pdo.kind == PdoKind::Rpdo && (2..=7).contains(&mapped.index) {
            continue;
        } else if mapped.is_dummy() {
            "the stack has no such dummy"
        } else if !has(dictionary, mapped.index, mapped.sub) {
            "the stack does not run a PDO whose mapping names an entry that there is not"
        } else {
            continue;
        };
        notes.push(Note::new(Place::entry(index, slot.sub), format!("{text} (`{mapped}`)")));
    }
}

fn has(dictionary: &Dictionary<'_>, index: u16, sub: u8) -> bool {
    let at = dictionary.objects.binary_search_by_key(&index, |object| object.index);
    at.is_ok_and(|at| dictionary.objects[at].entries.iter().any(|entry| entry.sub == sub))
}

/// What the stack needs of the dictionary as a whole.
fn demands(dictionary: &Dictionary<'_>, rows: usize, notes: &mut Vec<Note>) {
    let device = |text: &str| Note::new(Part::Device, text.to_owned());
    if !has(dictionary, 0x1001, 0) {
        notes.push(device("without 1001h the stack reports an error when it begins, and sends no EMCY"));
    }
    if !has(dictionary, 0x1014, 0) {
        notes.push(device("without 1014h the stack sends no EMCY"));
    }
    if !has(dictionary, 0x1200, 1) {
        let note = device("without 1200h the stack has no SDO server; it is added with the default COB-IDs");
        notes.push(note.help("describe 1200h, `ro`, with `$NODEID+0x600` and `$NODEID+0x580`"));
    }
    if rows > MOST_ROWS {
        notes.push(device(&format!("{rows} rows; the stack counts {MOST_ROWS} at most")));
    }
    // the stack does not initialise the first row, which does not matter for plain values
    let first = dictionary.objects.first().map(|object| object.index);
    let special = |index: &u16| *index >= 0x1003 && super::special::special(*index, 0, false).is_some();
    if let Some(first) = first.filter(special) {
        let text =
            "the stack does not initialise the first object of a dictionary; 1000h must come before it";
        notes.push(Note::new(Place::object(first), text));
    }
    if has(dictionary, 0, 0) {
        notes.push(Note::new(Place::entry(0, 0), "the stack takes index 0 for the end of the dictionary"));
    }
}
