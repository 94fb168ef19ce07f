//! What changes in the names of generated C and Rust.

use std::collections::{BTreeMap, BTreeSet};

use objdict_generate as generate;
use objdict_generate::Identifier;
use objdict_lint::changes::{DeviceChange, identifier_changed};
use objdict_model::diagnostic::Text;
use objdict_model::model::Device;

type EntryIdentifiers = BTreeMap<(u16, Option<u8>), Identifier>;

/// The identifiers of a device; none if no table can be generated of it.
fn names(device: &Device) -> EntryIdentifiers {
    let names = generate::identifiers(device).unwrap_or_default();
    names.into_iter().map(|name| ((name.index, name.sub), name)).collect()
}

/// Adds the identifiers to changes of names, and the changes of identifiers whose names stay: a new entry of the same name gives both
/// a number.
pub(super) fn add(changes: &mut Vec<DeviceChange>, old: &Device, new: &Device) {
    let (old, new) = (names(old), names(new));
    let mut explained: BTreeSet<(u16, Option<u8>)> = BTreeSet::new();
    for change in changes.iter_mut().filter(|change| is_of_name(change)) {
        let Some(index) = change.index else { continue };
        let key = (index, change.sub);
        explained.insert(key);
        let says_name = change.rule.info.name().contains("name");
        let (Some(before), Some(after)) = (old.get(&key), new.get(&key)) else { continue };
        if says_name && before.c != after.c {
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
        let after = new.get(key).filter(|after| after.c != before.c && !is_explained);
        if let Some(after) = after {
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

/// Whether a change explains that identifiers change.
fn is_of_name(change: &DeviceChange) -> bool {
    let name = change.rule.info.name();
    name.contains("name")
        || name.ends_with("moved")
        || name == "object-type-changed"
        || name == "array-or-record"
}
