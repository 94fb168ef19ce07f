//! Compact storage of an EDS: sub-indexes written out, and stored compactly again.

use std::collections::BTreeMap;

use crate::diagnostic::{Change, Fix};
use crate::format::{self, Description, eds};
use crate::model::{Compact, Configured, Device, Entry, Field, Object, Part, Place};
use crate::source::{Edits, SourceFile};

/// The change of an object between both, where the text gives back the same entries.
pub(super) fn stored_otherwise(description: &Description, index: u16) -> Option<Fix> {
    description.document()?;
    let device = description.device();
    let object = device.object(index)?;
    let (other, title) = match object.compact {
        Some(_) => (object.expanded().into_owned(), format!("write the sub-indexes of {index:04X}h out")),
        None => (compacted(object)?, format!("store the sub-indexes of {index:04X}h compactly")),
    };
    let mut fix = change(device, index, object, &other, title)?;
    // names that follow from the name of the object have no section
    fix.changes.retain(|change| match change {
        Change::Remove(place @ Place { field: None, .. }) => description.locate(place).is_some(),
        _ => true,
    });
    says_the_same(description, &fix, index).then_some(fix)
}

/// The object with its sub-indexes stored compactly; `None` where they are too different.
fn compacted(object: &Object) -> Option<Object> {
    let count =
        object.subs.iter().map(|(sub, _)| sub).filter(|sub| *sub != 0xFF).max().filter(|count| *count > 1)?;
    let first = object.subs.get(1)?;
    let mut compact = Compact { count, ..Compact::default() };
    for sub in 1..=count {
        let entry = object.subs.get(sub)?;
        let configured = entry.configured.clone();
        if shared(entry) != shared(first) {
            return None;
        }
        if *entry.name != *format!("{}{sub}", object.main.name) {
            compact.names.push((sub, entry.name.clone()));
        }
        if let Some(Configured { value, denotation, .. }) = configured.map(|configured| *configured) {
            compact.values.extend(value.map(|value| (sub, value)));
            compact.denotations.extend(denotation.map(|denotation| (sub, denotation)));
        }
    }
    let number = object.value(0).and_then(|value| value.as_integer());
    if number.is_some_and(|number| number != count.into()) || object.subs.get(0xFF).is_some() {
        return None;
    }
    let main = Entry {
        data_type: first.data_type,
        access: first.access,
        pdo_mapping: first.pdo_mapping,
        default: first.default.clone(),
        low_limit: first.low_limit.clone(),
        high_limit: first.high_limit.clone(),
        flags: first.flags,
        ..object.main.clone()
    };
    let subs = Default::default();
    Some(Object { main, compact: Some(Box::new(compact)), sub_number: None, subs, ..object.clone() })
}

/// What compactly stored entries have in common.
fn shared(entry: &Entry) -> Entry {
    Entry { name: Default::default(), object_type: None, configured: None, ..entry.clone() }
}

/// The changes of sections and keys that make one of the other.
fn change(device: &Device, index: u16, before: &Object, after: &Object, title: String) -> Option<Fix> {
    let of = |object: &Object| {
        let objects = std::iter::once((index, object.clone())).collect();
        let device = Device { kind: device.kind, objects, ..Device::default() };
        let changes = eds::additions(&Device { kind: device.kind, ..Device::default() }, &device)?;
        let parts = changes.into_iter().filter_map(|change| match change {
            Change::Add(part, fields) => Some((part, fields)),
            _ => None,
        });
        Some(parts.collect::<BTreeMap<Part, Vec<(Field, String)>>>())
    };
    let (old, new) = (of(before)?, of(after)?);
    let mut fix = Fix::risky(title);
    for (part, fields) in &new {
        if !old.contains_key(part) {
            fix = fix.with(Change::Add(part.clone(), fields.clone()));
        }
    }
    let object = Part::Object(index);
    let (had, has) = (old.get(&object)?, new.get(&object)?);
    for (field, value) in has.iter().filter(|pair| !had.contains(pair)) {
        fix = fix.with(Change::Set(Place::of(object.clone()).field(field.clone()), value.clone()));
    }
    for (field, _) in had.iter().filter(|(field, _)| has.iter().all(|(other, _)| other != field)) {
        fix = fix.with(Change::Remove(Place::of(object.clone()).field(field.clone())));
    }
    for part in old.keys().filter(|part| !new.contains_key(part)) {
        fix = fix.with(Change::Remove(Place::of(part.clone())));
    }
    Some(fix)
}

/// Whether the entries of the object are the same in the changed text, but for the name of sub-index 0, and nothing else changes.
fn says_the_same(description: &Description, fix: &Fix, index: u16) -> bool {
    let edited = description.edits(fix).and_then(|edits| {
        let mut edited = Edits::new(description.source());
        edits.into_iter().for_each(|(span, text)| edited.replace(span, text));
        edited.text().ok()
    });
    let Some(text) = edited else { return false };
    let after = format::read(SourceFile::from_text(description.source().name(), text), description.format());
    let entries = |device: &Device| {
        let object = device.object(index).into_iter();
        let entries = object.flat_map(|object| object.entries().collect::<Vec<_>>());
        let mut entries: Vec<(u8, Entry)> = entries.map(|(sub, entry)| (sub, entry.into_owned())).collect();
        if let Some((0, count)) = entries.first_mut() {
            (count.name, count.pdo_mapping) = Default::default();
        }
        entries
    };
    let others = |device: &Device| {
        let others = device.objects.iter().filter(|(other, _)| **other != index);
        others.map(|(index, object)| (*index, object.clone())).collect::<Vec<_>>()
    };
    entries(description.device()) == entries(after.device())
        && others(description.device()) == others(after.device())
}
