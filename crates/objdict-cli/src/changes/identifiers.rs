//! What changes in the names of generated C and Rust.

use std::collections::{BTreeMap, BTreeSet};

use objdict_generate as generate;
use objdict_generate::Identifier;
use objdict_lint::changes::{DeviceChange, identifier_changed};
use objdict_model::diagnostic::Text;
use objdict_model::model::{Device, Part};

/// An object, or an entry by its sub-index.
type IdentifierKey = (u16, Option<u8>);

type EntryIdentifiers = BTreeMap<IdentifierKey, Identifier>;

/// The identifiers of a device; none if no table can be generated of it.
fn names(device: &Device) -> EntryIdentifiers {
    let names = generate::identifiers(device).unwrap_or_default();
    names.into_iter().map(|name| ((name.index, name.sub), name)).collect()
}

/// Adds the identifiers to changes of names, and the changes of identifiers whose names stay: a new entry of the same name gives both
/// a number.
pub(super) fn add(changes: &mut Vec<DeviceChange>, old: &Device, new: &Device) {
    let (old, new) = (names(old), names(new));
    let mut explained: BTreeSet<IdentifierKey> = BTreeSet::new();
    let mut moved = BTreeMap::new();
    for change in changes.iter_mut() {
        let (Some((key, new_key)), Some(reach)) = (keys(change), IdentifierReach::of(change)) else {
            continue;
        };
        moved.insert(key, new_key);
        if reach != IdentifierReach::Respelled {
            explained.insert(key);
        }
        let (Some(before), Some(after)) = (old.get(&key), new.get(&new_key)) else { continue };
        if reach == IdentifierReach::Renamed && before.c != after.c {
            let names = format!(
                "in C `{}` becomes `{}`, in Rust `{}` becomes `{}`",
                before.c, after.c, before.rust, after.rust
            );
            change.message = Text::from(format!("{}: {names}", change.message));
        }
    }
    let mut added = Vec::new();
    for (key, before) in &old {
        let is_explained = explained.contains(key) || explained.contains(&(key.0, None));
        let after = new.get(moved.get(key).unwrap_or(key));
        if let Some(after) = after.filter(|after| after.c != before.c && !is_explained) {
            added.push(identifier_changed(*key, [&before.c, &after.c], [&before.rust, &after.rust]));
        }
    }
    // behind the changes of its object
    for change in added {
        let is_behind = |other: &DeviceChange| other.index.is_none_or(|index| Some(index) > change.index);
        let at = changes.iter().position(is_behind).unwrap_or(changes.len());
        changes.insert(at, change);
    }
}

/// The entry that a change is about, in the old and in the new device.
fn keys(change: &DeviceChange) -> Option<(IdentifierKey, IdentifierKey)> {
    let key = (change.index?, change.sub);
    let new = match change.new_place.as_ref().map(|place| &place.part) {
        Some(Part::Object(index)) => (*index, change.sub),
        Some(Part::Entry(index, sub)) => (*index, Some(*sub)),
        _ => key,
    };
    Some((key, new))
}

/// What a change has to do with identifiers.
#[derive(Clone, Copy, PartialEq, Eq)]
enum IdentifierReach {
    /// A different name: its message lists the identifiers.
    Renamed,
    /// A name with the same words: its message does not list them.
    Respelled,
    /// A different structure or place, which explains them.
    Explained,
}

impl IdentifierReach {
    fn of(change: &DeviceChange) -> Option<Self> {
        let name = change.rule.info.name();
        match name {
            "name-respelled" => Some(Self::Respelled),
            "object-type-changed" | "array-or-record" => Some(Self::Explained),
            _ if name.contains("name") => Some(Self::Renamed),
            _ => name.ends_with("moved").then_some(Self::Explained),
        }
    }
}
