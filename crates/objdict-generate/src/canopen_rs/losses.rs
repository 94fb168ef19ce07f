//! Notes about values and behaviour that an `ObjectDictionary` of canopen-rs does not support.

use super::ROOM;
use crate::Note;
use crate::diagnostic::counted;
use crate::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use crate::model::{DataType, PdoKind, Place, TypeKind};
use crate::resolve::{Encoded, ValueShape};

/// Number of PDOs per direction in the crate (`MAX_PDOS`).
const PDOS: u16 = 4;

/// Number of mapped objects per PDO (`MAX_PDO_MAPPING`).
const MAPPED: u64 = 8;

/// Removes unsupported values, and reports them and every other deviation from the description.
pub(super) fn of(dictionary: &mut TableDictionary<'_>) -> Vec<Note> {
    let mut notes = Vec::new();
    for object in &mut dictionary.objects {
        let index = object.index;
        object.entries.retain(|entry| fits(index, entry, &mut notes));
        for entry in &object.entries {
            of_entry(index, entry, &mut notes);
        }
    }
    dictionary.objects.retain(|object| !object.entries.is_empty());
    if dictionary.objects.iter().any(|object| PdoKind::of_mapping(object.index).is_some()) {
        let text = "PDOs may map every entry of the table: the crate ignores `PDOMapping`";
        notes.push(Note::new(Place::device(), text));
    }
    for object in &dictionary.objects {
        of_pdo(object, &mut notes);
    }
    notes
}

/// Whether the value fits into the crate's buffer.
fn fits(index: u16, entry: &ResolvedEntry<'_>, notes: &mut Vec<Note>) -> bool {
    let length = entry.resolved.default.bytes().len();
    if length <= usize::from(ROOM) {
        return true;
    }
    let text = format!("a value of {length} bytes is omitted: the crate supports at most {ROOM}");
    notes.push(Note::new(Place::entry(index, entry.sub), text));
    false
}

fn of_entry(index: u16, entry: &ResolvedEntry<'_>, notes: &mut Vec<Note>) {
    let place = || Place::entry(index, entry.sub);
    let resolved = &entry.resolved;
    if let Some(held) = held_as_octets(resolved.shape) {
        let freely =
            if resolved.access.is_writable() { ", of which an SDO may write more or fewer" } else { "" };
        notes.push(Note::new(place(), format!("{held}{freely}")));
    }
    if let ValueShape::Bytes(_, room) = resolved.shape
        && room > ROOM
    {
        notes.push(Note::new(
            place(),
            format!("the capacity is {ROOM} bytes, but the description requires {room}"),
        ));
    }
    if resolved.limit().is_some() {
        notes.push(Note::new(place(), "limits are not enforced: the crate does not support them"));
    }
}

/// The substitute for a data type that the crate lacks; `None` for supported types.
fn held_as_octets(shape: ValueShape) -> Option<String> {
    match shape {
        ValueShape::Word(data_type) if !is_modelled(data_type) => Some(format!(
            "{data_type} is stored as an octet string of {}",
            counted(shape.size(), "byte", "bytes")
        )),
        ValueShape::Bytes(data_type, _) if data_type == DataType::UNICODE_STRING => {
            Some("UNICODE_STRING is stored as an octet string".to_owned())
        }
        ValueShape::Block(length) => {
            let length = counted(length.into(), "byte", "bytes");
            Some(format!("a device-specific type is stored as an octet string of {length}"))
        }
        ValueShape::Word(_) | ValueShape::Bytes(..) => None,
    }
}

/// Whether the crate supports this data type of at most eight bytes.
pub(super) fn is_modelled(data_type: DataType) -> bool {
    match data_type.kind() {
        TypeKind::Boolean | TypeKind::Real32 | TypeKind::Real64 => true,
        TypeKind::Signed(bits) | TypeKind::Unsigned(bits) => matches!(bits, 8 | 16 | 32 | 64),
        _ => false,
    }
}

/// How the crate uses the PDO parameters.
fn of_pdo(object: &ResolvedObject<'_>, notes: &mut Vec<Note>) {
    let index = object.index;
    let mapping = PdoKind::of_mapping(index);
    let Some((_, number)) = mapping.or(PdoKind::of_communication(index)) else { return };
    if number > PDOS {
        let text = format!("the crate's node serves only PDO 1 to {PDOS}");
        notes.push(Note::new(Place::object(index), text));
        return;
    }
    let word = |entry: &ResolvedEntry<'_>| match entry.resolved.default {
        Encoded::Word(word) => Some(word),
        Encoded::Formula(_) | Encoded::Bytes(_) => None,
    };
    if mapping.is_some() {
        let count = object.entry(0).and_then(word).unwrap_or(0);
        if count > MAPPED {
            let text = format!("the crate's node maps at most {MAPPED} entries to a PDO, not {count}");
            notes.push(Note::new(Place::entry(index, 0), text));
        }
        let mapped = object.entries.iter().filter(|entry| entry.sub > 0 && u64::from(entry.sub) <= count);
        for entry in mapped {
            if let Some(bits) = word(entry).map(|word| word & 0xFF).filter(|bits| !bits.is_multiple_of(8)) {
                let text = format!("the crate's node packs only whole bytes, not {bits} bits");
                notes.push(Note::new(Place::entry(index, entry.sub), text));
            }
        }
        return;
    }
    for entry in &object.entries {
        let text = match (entry.sub, &entry.resolved.default) {
            (1, Encoded::Word(cob_id) | Encoded::Formula(cob_id)) if cob_id & 0x2000_0000 != 0 => {
                "the node of the crate supports only 11-bit CAN-IDs"
            }
            (3, Encoded::Word(time)) if *time != 0 => "the crate's node ignores the inhibit time",
            (5, Encoded::Word(time)) if *time != 0 => "the crate's node ignores the event timer",
            (6, Encoded::Word(start)) if *start != 0 => "the crate's node ignores the SYNC start value",
            _ => continue,
        };
        notes.push(Note::new(Place::entry(index, entry.sub), text));
    }
}
