//! Adds objects to the text of a device description, as changes, so that the rest of the text is kept.

use super::section::SectionName;
use super::write;
use crate::diagnostic::Change;
use crate::eds::Style;
use crate::ini::{Document, Section};
use crate::model::{Device, Field, Object, Part, Place, Value};
use crate::source::{Encoding, SourceFile, Span};

/// The changes that turn the text of `before` into the text of `after`, which has additional objects and sub-indexes,
/// and different lists, counts and connected modules. Additional objects are not stored compactly, as in the canonical
/// text. `None` if an object with new entries is stored compactly, because its text cannot contain single entries.
pub fn additions(before: &Device, after: &Device) -> Option<Vec<Change>> {
    let mut changes = Vec::new();
    let mut new = Device { kind: after.kind, ..Device::default() };
    for (&index, object) in &after.objects {
        match before.object(index) {
            None => {
                new.objects.insert(index, object.clone());
            }
            Some(old) if old.compact.is_some() && has_grown(old, object) => return None,
            Some(old) => {
                changes.extend(grown(index, old, object));
                let added = object.subs.iter().filter(|(sub, _)| old.subs.get(*sub).is_none());
                let subs: Vec<_> = added.map(|(sub, entry)| (sub, entry.clone())).collect();
                if !subs.is_empty() {
                    let main = object.main.clone();
                    new.objects.insert(
                        index,
                        Object { main, subs: subs.into_iter().collect(), ..Object::default() },
                    );
                }
            }
        }
    }
    changes.extend(sections(&new, &Style::default()).into_iter().filter_map(|(part, fields)| match part {
        Part::Object(index) if before.objects.contains_key(&index) => None,
        // everything that describes an object, including its links and the unknown keys of its compact
        // storage
        _ => part.object().is_some().then_some(Change::Add(part, fields)),
    }));
    for list in crate::model::ObjectList::ALL {
        if before.lists.get(list) != after.lists.get(list) {
            changes.push(Change::List(list, after.lists.get(list).to_vec()));
        }
    }
    changes.extend(connected(before, after));
    Some(changes)
}

/// The changes that convert an object's text to a different storage: first those of existing sections, then the new
/// sections, relative to the remaining text.
pub fn stored(index: u16, before: &Object, after: &Object) -> [Vec<Change>; 2] {
    let of = |object: &Object| {
        let objects = std::iter::once((index, object.clone())).collect();
        let mut sections = stated(&Device { objects, ..Device::default() });
        // the canonical text adds names where the object has none
        let has_names = object.compact.as_ref().is_some_and(|compact| !compact.names.is_empty());
        let is_name = |part: &Part| matches!(part, Part::CompactNames(_));
        sections.retain(|(part, _)| part.object() == Some(index) && (has_names || !is_name(part)));
        sections
    };
    let (old, new) = (of(before), of(after));
    let mut changes = Vec::new();
    for (part, fields) in &old {
        let Some((_, kept)) = new.iter().find(|(other, _)| other == part) else {
            changes.push(Change::Remove(Place::of(part.clone())));
            continue;
        };
        let place = |field: &Field| Place::of(part.clone()).field(field.clone());
        let gone = fields.iter().filter(|(field, _)| kept.iter().all(|(other, _)| other != field));
        changes.extend(gone.map(|(field, _)| Change::Remove(place(field))));
        let set = kept.iter().filter(|new| !fields.contains(new));
        changes.extend(set.map(|(field, value)| Change::Set(place(field), value.clone())));
    }
    let added = new.into_iter().filter(|(part, _)| old.iter().all(|(other, _)| other != part));
    [changes, added.map(|(part, fields)| Change::Add(part, fields)).collect()]
}

/// Whether a compactly stored object has new entries.
fn has_grown(old: &Object, new: &Object) -> bool {
    let count = |object: &Object| object.compact.as_ref().map(|compact| compact.count);
    count(old) != count(new) || old.subs.len() != new.subs.len()
}

/// The key of an object that changes with new entries: their number.
fn grown(index: u16, old: &Object, new: &Object) -> Vec<Change> {
    let mut changes = Vec::new();
    if let Some(count) =
        new.sub_number.filter(|_| old.sub_number.is_some() && old.sub_number != new.sub_number)
    {
        changes.push(Change::Set(Place::object(index).field(Field::SubNumber), count.to_string()));
    }
    for (sub, entry) in new.subs.iter() {
        let Some(before) = old.subs.get(sub) else { continue };
        let default = entry.default.as_ref().filter(|_| entry.default != before.default);
        if let Some(number) = default.and_then(Value::as_integer) {
            changes
                .push(Change::Set(Place::entry(index, sub).field(Field::DefaultValue), number.to_string()));
        }
    }
    changes
}

/// The section of the connected modules: new, or with different numbers.
fn connected(before: &Device, after: &Device) -> Vec<Change> {
    let of = |device: &Device| device.modules.as_ref().and_then(|modules| modules.connected.clone());
    let (old, new) = (of(before), of(after));
    let Some(numbers) = new.filter(|new| old.as_ref() != Some(new)) else { return Vec::new() };
    let items = (1_u32..).zip(&numbers).map(|(item, number)| (Field::Item(item), number.to_string()));
    let fields = std::iter::once((Field::NrOfEntries, numbers.len().to_string())).chain(items);
    let Some(old) = old else { return vec![Change::Add(Part::ConnectedModules, fields.collect())] };
    let place = |field| Place::of(Part::ConnectedModules).field(field);
    let set = fields.map(|(field, value)| Change::Set(place(field), value));
    let gone = (numbers.len() + 1..=old.len()).filter_map(|item| u32::try_from(item).ok());
    set.chain(gone.map(|item| Change::Remove(place(Field::Item(item))))).collect()
}

/// The sections and keys of the canonical text of a device. Compact storage is kept.
pub fn stated(device: &Device) -> Vec<(Part, Vec<(Field, String)>)> {
    sections(device, &Style { compact: true, encoding: Some(Encoding::Utf8), ..Style::default() })
}

/// The sections of the text of a device, with their keys.
fn sections(device: &Device, style: &Style) -> Vec<(Part, Vec<(Field, String)>)> {
    let text = String::from_utf8(write::write(device, style));
    let document = Document::new(SourceFile::from_text("additions", text.unwrap_or_default()));
    let text = document.text();
    let mut sections = Vec::new();
    document.visit(
        |section: &Section| {
            let Some(header) = section.header else { return };
            let field = |key: Span| Field::from_name(key.of(text));
            let fields =
                section.entries.iter().map(|entry| (field(entry.key), entry.value.of(text).to_owned()));
            sections.push((SectionName::parse(header.name.of(text)).part, fields.collect()));
        },
        |_| {},
    );
    sections
}
