//! Changes of a description that fix nothing: order and spelling, and new parts.

use super::file::CheckedFile;
use super::protocol::{CodeAction, REFACTOR, TextEdit};
use objdict_eds::eds;
use objdict_format as format;
use objdict_format::Description;
use objdict_format::scaffold;
use objdict_model::diagnostic::{Change, Fix};
use objdict_model::model::{
    Access, DataType, Device, Entry, Field, MappedObject, Object, ObjectList, ObjectType, Part, PdoKind,
    PdoMapping, Place, Value,
};
use objdict_model::source::{Edits, SourceFile};

/// The bits of a frame.
const FRAME: u32 = 64;

/// The edits that put a file into the order and spelling of `objdict fmt`; `None` where that is not possible.
pub(super) fn formatted(file: &CheckedFile) -> Option<Vec<TextEdit>> {
    let description = file.description()?;
    let bytes = description.arranged().ok()?;
    let source = file.source().with_bytes(bytes).ok()?;
    Some(file.edits_to(source.text()))
}

/// The changes that can be made at an offset.
pub(super) fn refactorings(file: &CheckedFile, description: &Description, offset: u32) -> Vec<CodeAction> {
    let Some(place) = file.place(offset) else { return Vec::new() };
    let device = description.device();
    let mut fixes = Vec::new();
    if let Some(index) = place.part.object() {
        fixes.extend(new_sub_index(device, index));
        let has_subs = device.object(index).is_some_and(|object| object.object_type().has_subs());
        match place.part {
            Part::Entry(_, sub) => fixes.extend(mapped(device, index, sub)),
            _ if has_subs => {}
            _ => fixes.extend(mapped(device, index, 0)),
        }
    }
    if let Part::List(list) = place.part {
        fixes.extend(listed(device, list));
    }
    let action = |fix: Fix| {
        let edits = file.edits(description.edits(&fix)?);
        Some(CodeAction {
            title: fix.title.shown().into_owned(),
            kind: REFACTOR,
            edit: Some(file.workspace_edit(edits)),
            ..CodeAction::default()
        })
    };
    fixes.into_iter().filter_map(action).collect()
}

/// Adds the next sub-index that the documents allow to an object, as they demand it, else as the one before it is.
pub(super) fn new_sub_index(device: &Device, index: u16) -> Option<Fix> {
    let object = device.object(index)?;
    let sub = scaffold::next_sub_index(device, index)?;
    let entry = scaffold::entry(device, index, sub).unwrap_or_else(|| like_before(object, sub));
    let mut after = Device { kind: device.kind, ..Device::default() };
    let mut before = after.clone();
    before.objects.insert(index, object.clone());
    let mut grown = object.clone();
    grown.subs.insert(sub, entry);
    grown.sub_number = grown.sub_number.and_then(|number| number.checked_add(1));
    after.objects.insert(index, grown);
    let title = format!("add sub-index {sub:02X} to {index:04X}h");
    let changes = eds::additions(&before, &after)?;
    let mut fix = changes.into_iter().fold(Fix::risky(title), Fix::with);
    let highest = object.subs.get(0).and_then(|entry| entry.default.as_ref()?.as_integer());
    // there it counts errors, or the objects that are mapped
    let counts_others = index == 0x1003 || PdoKind::of_mapping(index).is_some();
    if !counts_others && highest.is_some_and(|highest| highest < sub.into()) {
        fix = fix.set(Place::entry(index, 0).field(Field::DefaultValue), format!("0x{sub:X}"));
    }
    Some(fix)
}

/// A sub-index that no document describes: sub-index 0, or one with the type of the one before it.
fn like_before(object: &Object, sub: u8) -> Entry {
    let count = || Entry {
        data_type: Some(DataType::UNSIGNED8),
        access: Some(Access::Const),
        pdo_mapping: Some(PdoMapping::No),
        default: object
            .highest_sub()
            .and_then(|highest| Value::from_integer(highest.into(), DataType::UNSIGNED8)),
        ..Entry::default()
    };
    let before = object.subs.iter().rfind(|(other, _)| (1..sub).contains(other)).map(|(_, entry)| entry);
    let data_type = before.and_then(|before| before.data_type).unwrap_or(DataType::UNSIGNED8);
    let (name, entry) = match sub {
        0 => ("Highest sub-index supported".to_owned(), count()),
        _ => {
            let access = before.and_then(|before| before.access).or(Some(Access::Ro));
            let pdo_mapping = before.and_then(|before| before.pdo_mapping);
            let default = before.and_then(|before| before.default.clone());
            let default = default.or_else(|| Value::from_integer(0, data_type));
            let entry =
                Entry { data_type: Some(data_type), access, pdo_mapping, default, ..Entry::default() };
            (format!("{} {sub}", object.name()), entry)
        }
    };
    Entry { name: name.into(), object_type: Some(ObjectType::Var), ..entry }
}

/// The other way to store an object at an offset, and what it is called: entries written out, or compact storage.
pub(super) fn storage(file: &CheckedFile, description: &Description, offset: u32) -> Option<(u16, String)> {
    let index = file.place(offset)?.part.object()?;
    let object = description.device().object(index)?;
    stored_otherwise(description, object)?;
    let title = match &object.compact {
        Some(compact) => format!("describe the {} sub-indexes of {index:04X}h individually", compact.count),
        None => {
            let name = object.subs.get(0).map(|entry| &*entry.name).filter(|name| *name != "NrOfObjects");
            let lost = name.map(|name| format!(", without the name `{name}` of sub-index 0"));
            format!("store {index:04X}h compactly{}", lost.unwrap_or_default())
        }
    };
    Some((index, title))
}

/// An object stored the other way; only EDS and DCF have compact storage.
fn stored_otherwise(description: &Description, object: &Object) -> Option<Object> {
    description.document()?;
    if object.compact.is_some() { Some(object.expanded().into_owned()) } else { object.compacted() }
}

/// The edits that store an object the other way.
pub(super) fn restored(file: &CheckedFile, index: u16) -> Option<Vec<TextEdit>> {
    let description = file.description()?;
    let object = description.device().object(index)?;
    let after = stored_otherwise(description, object)?;
    let changed = |description: &Description, changes: Vec<Change>| {
        let fix = changes.into_iter().fold(Fix::risky(""), Fix::with);
        let mut edits = Edits::new(description.source());
        description.edits(&fix)?.into_iter().for_each(|(span, new)| edits.replace(span, new));
        edits.text().ok()
    };
    let [changes, added] = eds::stored(index, object, &after);
    let left = SourceFile::from_text(file.source().name(), changed(description, changes)?);
    let text = match &added[..] {
        [] => left.text().to_owned(),
        _ => changed(&format::read(left, description.format()), added)?,
    };
    Some(file.edits_to(&text))
}

/// Maps an entry into the first PDO of each direction that has room for it and a sub-index left.
fn mapped(device: &Device, index: u16, sub: u8) -> Vec<Fix> {
    let entry = device.object(index).and_then(|object| object.entry(sub));
    let Some(entry) = entry.filter(|_| PdoKind::of_mapping(index).is_none()) else { return Vec::new() };
    let Some(bits) = entry.implied_type().and_then(DataType::bit_length) else { return Vec::new() };
    let kinds = PdoKind::ALL.into_iter().filter(|kind| entry.is_mappable() && entry.fits_pdo(*kind));
    let fix = |kind: PdoKind| {
        let mut pdos =
            device.pdos().filter(|pdo| pdo.kind == kind && pdo.bit_length() + u32::from(bits) <= FRAME);
        pdos.find_map(|pdo| {
            let count = pdo.mapped_count.filter(|count| *count < 64)?;
            let slot = pdo.slots.iter().find(|slot| slot.sub == count + 1)?;
            let number = MappedObject { index, sub, bits }.to_number();
            let mapping = pdo.mapping_index();
            let title = format!("map into {pdo} (now {} of {FRAME} bits)", pdo.bit_length());
            let value = device.value_place(mapping, slot.sub);
            let counted = device.value_place(mapping, 0);
            Some(
                Fix::risky(title).set(value, format!("0x{number:08X}")).set(counted, (count + 1).to_string()),
            )
        })
    };
    kinds.filter_map(fix).collect()
}

/// Numbers a list again, in the order of its indexes.
fn listed(device: &Device, list: ObjectList) -> Option<Fix> {
    let mut members = device.lists.get(list).to_vec();
    members.sort_unstable();
    members.dedup();
    let title = format!("renumber {list} in the order of indexes");
    (!members.is_empty()).then(|| Fix::risky(title).with(Change::List(list, members)))
}
