//! Common properties of a device's entries, which are written once.

use std::collections::BTreeMap;

use super::defaults::{Defaults, Omissions, OmittedFact};
use super::objects::{TomlPair, common, inline};
use super::words::{map_word, push, quoted, type_word, words};
use objdict_model::model::{Device, Entry, Object};

/// The most frequent item.
fn most<T: Ord + Clone>(items: impl Iterator<Item = T>) -> Option<T> {
    let mut counts: BTreeMap<T, usize> = BTreeMap::new();
    items.for_each(|item| *counts.entry(item).or_default() += 1);
    counts.into_iter().max_by_key(|(_, count)| *count).map(|(item, _)| item)
}

/// The common properties of most entries of a device.
pub(super) fn usual(device: &Device) -> Defaults {
    let entries = || {
        let of_object = |object: &'_ Object| -> Vec<Entry> {
            let subs = object.subs.iter().filter(|(sub, _)| *sub != 0).map(|(_, entry)| entry);
            let main =
                Some(&object.main).filter(|_| object.subs.is_empty() && !object.object_type().has_subs());
            main.into_iter()
                .chain(subs)
                .map(|entry| Entry {
                    object_type: entry.object_type,
                    access: entry.access,
                    pdo_mapping: entry.pdo_mapping,
                    ..Entry::default()
                })
                .collect()
        };
        device.objects.values().flat_map(of_object)
    };
    let built_in = Defaults::default();
    let mut defaults = Defaults::default();
    match most(entries().map(|entry| entry.access)) {
        Some(Some(access)) => defaults.access = access,
        Some(None) => defaults.unstated.add(OmittedFact::Access),
        None => {}
    }
    match most(entries().map(|entry| entry.pdo_mapping.map(|map| map as u8))) {
        Some(None) => defaults.unstated.add(OmittedFact::Map),
        Some(Some(code)) => {
            let found = entries().filter_map(|entry| entry.pdo_mapping).find(|map| *map as u8 == code);
            defaults.map = found.unwrap_or_default();
        }
        None => {}
    }
    let subs = device.objects.values().flat_map(|object| object.subs.iter()).filter(|(sub, _)| *sub != 0);
    if most(subs.map(|(_, entry)| entry.object_type.is_some())) == Some(false) {
        defaults.unstated.add(OmittedFact::ObjectType);
    }
    let described =
        || device.objects.values().filter(|object| !object.subs.is_empty() && object.compact.is_none());
    if most(described().map(|object| object.sub_number.is_some())) == Some(false) {
        defaults.unstated.add(OmittedFact::SubNumber);
    }
    match usual_first(device) {
        Some(Some(first)) => defaults.sub0 = first,
        Some(None) => defaults.unstated.add(OmittedFact::Sub0),
        None => defaults.sub0 = built_in.sub0,
    }
    defaults
}

/// The common sub-index 0 of most objects; the inner `None` if there is none.
fn usual_first(device: &Device) -> Option<Option<Entry>> {
    let mut counts: BTreeMap<String, (usize, Option<Entry>)> = BTreeMap::new();
    let described =
        device.objects.values().filter(|object| !object.subs.is_empty() && object.compact.is_none());
    for object in described {
        let first = object.subs.get(0).map(|entry| Entry {
            name: entry.name.clone(),
            object_type: entry.object_type,
            data_type: entry.data_type,
            access: entry.access,
            pdo_mapping: entry.pdo_mapping,
            ..Entry::default()
        });
        let word = serde_json::to_string(&first).unwrap_or_default();
        counts.entry(word).or_insert((0, first)).0 += 1;
    }
    counts.into_values().max_by_key(|(count, _)| *count).map(|(_, first)| first)
}

pub(super) fn write_defaults(defaults: &Defaults, text: &mut String) {
    let built_in = Defaults::default();
    let mut lines = Vec::new();
    if defaults.access != built_in.access {
        lines.push(format!("access = {}", quoted(defaults.access.name())));
    }
    if defaults.map != built_in.map {
        lines.push(format!("map = {}", quoted(&map_word(defaults.map))));
    }
    if defaults.unstated != built_in.unstated {
        lines.push(format!("unstated = [{}]", words(&defaults.unstated.words())));
    }
    if defaults.sub0 != built_in.sub0 {
        let mut keys: Vec<TomlPair> = Vec::new();
        let mut given = Omissions::default();
        let (found, usual) = (&defaults.sub0, &built_in.sub0);
        if found.name != usual.name {
            keys.push(("name".to_owned(), quoted(&found.name)));
        }
        if found.data_type != usual.data_type {
            keys.extend(found.data_type.map(|data_type| ("type".to_owned(), quoted(&type_word(data_type)))));
        }
        common(found, usual, &mut keys, &mut given);
        if given != Omissions::default() {
            keys.push(("unstated".to_owned(), format!("[{}]", words(&given.words()))));
        }
        lines.push(format!("sub0 = {}", inline(&keys)));
    }
    if !lines.is_empty() {
        text.push_str("\n[defaults]\n");
        lines.iter().for_each(|line| push(text, line));
    }
}
