//! The calls that initialise PDOs, and the offsets of the mapped objects.

use super::image::Image;
use crate::Note;
use crate::dictionary::TableDictionary;
use crate::model::{MappedObject, Pdo, PdoKind, Place};

/// Number of PDOs per direction in the stack.
const MOST: u16 = 4;

/// A call of `MCO_InitTPDO` or `MCO_InitRPDO`.
pub(super) struct InitCall {
    pub(super) kind: PdoKind,
    pub(super) number: u16,
    /// A CAN-ID or an offset to the node-ID; `None` for the predefined CAN-ID.
    pub(super) can_id: Option<(u32, bool)>,
    /// In milliseconds.
    pub(super) event: u16,
    pub(super) inhibit: u16,
    pub(super) length: usize,
    pub(super) offset: usize,
}

/// The calls for all PDOs that the stack supports; places the mapped objects.
pub(super) fn calls(
    dictionary: &TableDictionary<'_>,
    image: &mut Image<'_>,
    notes: &mut Vec<Note>,
) -> Vec<InitCall> {
    let mut calls = Vec::new();
    for kind in [PdoKind::Tpdo, PdoKind::Rpdo] {
        for pdo in dictionary.device.pdos().filter(|pdo| pdo.kind == kind) {
            match call(&pdo, image, notes) {
                Ok(call) => calls.extend(call),
                Err((place, text)) => {
                    notes.push(Note::new(place, format!("{text}; {pdo} is not initialised")));
                }
            }
        }
    }
    calls
}

/// The call for a PDO; `Ok(None)` for an unused one.
fn call(
    pdo: &Pdo<'_>,
    image: &mut Image<'_>,
    notes: &mut Vec<Note>,
) -> Result<Option<InitCall>, (Place, String)> {
    let index = pdo.communication_index();
    let Some(id) = pdo.cob_id else {
        return Err((Place::entry(index, 1), "the COB-ID is missing".to_owned()));
    };
    if !id.is_valid() {
        return Ok(None);
    }
    if pdo.number > MOST {
        return Err((Place::object(index), format!("the stack supports {MOST} PDOs per direction")));
    }
    if id.is_extended() {
        return Err((Place::entry(index, 1), "the stack does not support 29-bit CAN-IDs".to_owned()));
    }
    let mut say = |sub: u8, text: &str| notes.push(Note::new(Place::entry(index, sub), text));
    if pdo.transmission_type.is_some_and(|number| number < 254) {
        say(2, "the stack supports neither SYNC nor RTR: it transmits periodically and on change");
    }
    let (event, tenths) = (pdo.event_timer.unwrap_or(0), pdo.inhibit_time.unwrap_or(0));
    if tenths % 10 != 0 {
        say(3, "the stack counts in milliseconds; the inhibit time is rounded up");
    }
    let inhibit = tenths.div_ceil(10);
    if pdo.kind == PdoKind::Tpdo && event == 0 && inhibit == 0 {
        say(5, "without an event timer and an inhibit time the stack never transmits the PDO");
    }
    if pdo.kind == PdoKind::Rpdo && (event != 0 || inhibit != 0) {
        say(5, "the stack does not support times for RPDOs");
    }
    let (offset, length) = place(pdo, image)?;
    let base = id.number() & 0x7FF;
    let default = pdo.kind.predefined_can_id(pdo.number).map(u32::from);
    let is_default = id.depends_on_node_id() && Some(base) == default;
    let can_id = (!is_default).then_some((base, id.depends_on_node_id()));
    Ok(Some(InitCall { kind: pdo.kind, number: pdo.number, can_id, event, inhibit, length, offset }))
}

/// Places the mapped objects of a PDO consecutively; returns their offset and length.
fn place(pdo: &Pdo<'_>, image: &mut Image<'_>) -> Result<(usize, usize), (Place, String)> {
    let index = pdo.mapping_index();
    let at = |sub: u8| Place::entry(index, sub);
    let mapped: Vec<(u8, MappedObject)> = pdo.mapped_slots().collect();
    if mapped.is_empty() {
        return Err((at(0), "nothing is mapped".to_owned()));
    }
    let mut parts = Vec::new();
    for &(sub, object) in &mapped {
        let bytes = usize::from(object.bits) / 8;
        if object.bits % 8 != 0 {
            return Err((at(sub), format!("`{object}`: the stack maps whole bytes")));
        }
        let entry = image.find(object.index, object.sub);
        match entry.map(|entry| &image.entries[entry]) {
            None if object.is_dummy() => {}
            None => return Err((at(sub), format!("`{object}` is not in the process image"))),
            Some(entry) if entry.size != bytes => {
                return Err((at(sub), format!("`{object}` has {} bytes", entry.size)));
            }
            Some(_) => {}
        }
        parts.push((sub, entry, bytes));
    }
    let length: usize = parts.iter().map(|(_, _, bytes)| bytes).sum();
    if length > 8 {
        return Err((at(0), format!("{length} bytes are mapped; a frame has 8")));
    }
    // either all objects are new, or they are already placed in the same order
    let places: Vec<Option<usize>> =
        parts.iter().map(|&(_, entry, _)| entry.and_then(|entry| image.entries[entry].offset)).collect();
    let Some(&(sub, ..)) = parts.iter().zip(&places).find(|(_, place)| place.is_some()).map(|(part, _)| part)
    else {
        return place_new(&parts, length, image, &at);
    };
    let mut next = places[0];
    let in_order = next.is_some()
        && parts.iter().zip(&places).all(|(&(_, _, bytes), &place)| {
            let fits = place == next;
            next = next.map(|next| next + bytes);
            fits
        });
    match places[0].filter(|_| in_order) {
        Some(offset) => Ok((offset, length)),
        None => {
            let text = "a different PDO also maps the entry, which has only one place in the process image"
                .to_owned();
            Err((at(sub), text))
        }
    }
}

fn place_new(
    parts: &[(u8, Option<usize>, usize)],
    length: usize,
    image: &mut Image<'_>,
    at: &dyn Fn(u8) -> Place,
) -> Result<(usize, usize), (Place, String)> {
    for (number, &(sub, entry, _)) in parts.iter().enumerate() {
        if entry.is_some() && parts[..number].iter().any(|&(_, other, _)| other == entry) {
            return Err((at(sub), "an entry is mapped twice".to_owned()));
        }
    }
    let offset = image.size;
    for &(_, entry, bytes) in parts {
        if let Some(entry) = entry {
            image.entries[entry].offset = Some(image.size);
        }
        image.size += bytes;
    }
    Ok((offset, length))
}
