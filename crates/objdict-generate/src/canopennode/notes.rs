//! Features that the stack does not support, and unmet requirements of the stack.

use super::plan::{Member, StackObject};
use super::storage::{is_odd_nan, is_text};
use crate::Note;
use crate::model::{DataType, Device, Place};
use crate::resolve::ValueShape;
use objdict_model::canopennode::{Cause, is_read_at_start, unmet};

/// Requirements of the stack on the device, as found by `--compat canopennode`; mapped bits are among the causes in `startup`.
pub(super) fn of_stack(device: &Device, notes: &mut Vec<Note>) {
    let unmet = unmet(device).into_iter().filter(|unmet| unmet.cause != Cause::Bits);
    notes.extend(unmet.map(|unmet| {
        let text = format!("{}; {}", unmet.message, unmet.cause.effect());
        let note = Note::new(unmet.place, text).help(unmet.help);
        if unmet.cause == Cause::Start { note.error() } else { note.warning() }
    }));
}

/// Deviations for the values of an object.
pub(super) fn of_object(object: &StackObject<'_>, notes: &mut Vec<Note>) {
    for member in object.members() {
        let place = Place::entry(object.index, member.entry.sub);
        notes.extend(text(member).map(|text| Note::new(place.clone(), text)));
        notes.extend(octets(&place, member));
        // a DOMAIN has a different type from the one that the stack reads
        let is_word = matches!(member.entry.resolved.shape, ValueShape::Word(_));
        if member.storage.type_.is_none() && is_word && is_read_at_start(object.index, member.entry.sub) {
            let text = "the stack reads the value when it starts, but this layout has none without a default";
            let note = Note::new(place.clone(), format!("{text}; {}", Cause::Start.effect()));
            notes.push(note.help("write a default").error());
        }
        if is_odd_nan(&member.entry.resolved) {
            notes.push(Note::new(place.clone(), "a NaN becomes the compiler's `NAN`"));
        }
        if object.index == 0x1003 && !member.entry.resolved.default.is_zero() {
            notes.push(Note::new(place.clone(), "the error history is empty when the stack starts"));
        }
        let stack = member.entry.entry.stack.as_deref();
        if stack.is_some_and(|stack| stack.detects_change == Some(true)) {
            let note = Note::new(place.clone(), "the tables have no room for `CO_flagsPDO`");
            notes.push(note.help("attach an extension in the application and call `OD_requestTPDO`"));
        }
    }
}

/// Deviations for a string: the stack determines its length by the first zero.
fn text(member: &Member<'_>) -> Option<&'static str> {
    let resolved = &member.entry.resolved;
    let ValueShape::Bytes(data_type, _) = resolved.shape else { return None };
    if !is_text(data_type) || member.storage.type_.is_none() {
        return None;
    }
    match data_type {
        DataType::UNICODE_STRING => Some(
            "the SDO server of the stack truncates a UNICODE_STRING at its first zero byte, which each character below U+0100 has",
        ),
        _ => resolved
            .default
            .bytes()
            .contains(&0)
            .then_some("the stack's SDO server truncates a string at its first zero"),
    }
}

/// Notes for bytes, and for values without memory: the stack does not support values of variable length.
fn octets(place: &Place, member: &Member<'_>) -> Option<Note> {
    let shape = member.entry.resolved.shape;
    let data_type = shape.data_type()?;
    let is_fixed = matches!(shape, ValueShape::Bytes(..)) && !is_text(data_type);
    if member.storage.type_.is_some() {
        let length = member.storage.length;
        let text = format!("a {data_type} of the stack has a fixed length, here {length} bytes");
        let differs = is_fixed && member.entry.resolved.access.is_writable();
        return differs.then(|| Note::new(place.clone(), text));
    }
    let text = format!("a value of type {data_type} without a default has no memory in the tables");
    let help = "attach an extension to the entry in the application";
    (data_type != DataType::DOMAIN).then(|| Note::new(place.clone(), text).help(help))
}
