//! Objects and their sub-indexes: added, removed, renamed and moved ones, and the matching of parts between
//! devices.

use std::collections::{BTreeMap, BTreeSet};

use super::audience::{Affected, group};
use super::{DeviceComparison, Side, Spot, rules};
use crate::diagnostic::{say, sub_index};
use crate::model::{Device, Field, Object, ObjectType, PdoKind, Place};

/// An object in both devices, at its old and at its new index.
#[derive(Clone, Copy)]
pub(super) struct ObjectPair<'a> {
    pub(super) index: (u16, u16),
    pub(super) old: &'a Object,
    pub(super) new: &'a Object,
}

/// The PDO that an index belongs to.
pub(super) fn pdo_of(index: u16) -> Option<(PdoKind, u16)> {
    PdoKind::of_communication(index).or_else(|| PdoKind::of_mapping(index))
}

/// The objects that may have moved: indexes below 2000h are fixed.
fn parts(device: &Device) -> Vec<MatchedPart<u16>> {
    let part = |(&index, object): (&u16, &Object)| {
        let types = object.entries().map(|(sub, entry)| format!("{sub}{:?}", entry.implied_type()));
        let shape = format!("{:?}{}", object.object_type(), types.collect::<String>());
        let words = if index < 0x2000 { String::new() } else { own_words(object.name()) };
        MatchedPart { key: index, words, shape }
    };
    device.objects.iter().map(part).collect()
}

/// The words of a specific name; names that end with a number may move to similar parts.
fn own_words(name: &str) -> String {
    let words = words(name);
    if words.ends_with(|c: char| c.is_ascii_digit()) { String::new() } else { words }
}

/// The sub-indexes of an object that may have moved; sub-index 0 of a structure and parameters of PDOs are
/// fixed.
fn subs(index: u16, object: &Object) -> Vec<MatchedPart<u8>> {
    let is_fixed = index < 0x2000 || object.object_type() == ObjectType::Array;
    let part = |(sub, entry): (u8, std::borrow::Cow<'_, crate::model::Entry>)| {
        let words = if sub == 0 || is_fixed { String::new() } else { own_words(&entry.name) };
        MatchedPart { key: sub, words, shape: format!("{:?}", entry.implied_type()) }
    };
    object.entries().map(part).collect()
}

impl<'a> DeviceComparison<'a> {
    pub(super) fn objects(&mut self) {
        let (old, new): (&'a Device, &'a Device) = (self.old.device, self.new.device);
        let Matched { pairs, removed, added } = matched(&parts(old), &parts(new));
        let pair = |&index: &(u16, u16)| {
            Some(ObjectPair { index, old: old.object(index.0)?, new: new.object(index.1)? })
        };
        for pair in pairs.iter().filter_map(pair) {
            self.object(pair);
        }
        let has_pdo = |device: &Device, index| {
            pdo_of(index).is_none_or(|(kind, number)| device.pdo(kind, number).is_some())
        };
        // a PDO that only one device has is a single change
        for index in removed.into_iter().filter(|&index| has_pdo(new, index)) {
            let Some(object) = old.object(index) else { continue };
            let affected = Affected::by_object(&self.old, index, object);
            let place = Some(Place::object(index));
            let spot = Spot { index: Some(index), sub: None, old: place, new: None, affected };
            let name = object.name();
            let message = say!("the object {:04X}h `{}` is removed", index, name);
            self.report(&rules::OBJECT_REMOVED, &spot, [Some(name.to_owned()), None], message);
        }
        for index in added.into_iter().filter(|&index| has_pdo(old, index)) {
            let Some(object) = new.object(index) else { continue };
            let affected = Affected::by_object(&self.new, index, object);
            let place = Some(Place::object(index));
            let spot = Spot { index: Some(index), sub: None, old: None, new: place, affected };
            let name = object.name();
            let message = say!("the object {:04X}h `{}` is added", index, name);
            self.report(&rules::OBJECT_ADDED, &spot, [None, Some(name.to_owned())], message);
        }
    }

    /// An object that both have.
    fn object(&mut self, pair: ObjectPair<'a>) {
        let ObjectPair { index: (old_index, new_index), old, new } = pair;
        if old_index == new_index && old == new && !self.has_meanings() {
            return;
        }
        let affected = Affected::by_object(&self.old, old_index, old);
        let places = [Some(Place::object(old_index)), Some(Place::object(new_index))];
        let [old_place, new_place] = places;
        let spot = Spot { index: Some(old_index), sub: None, old: old_place, new: new_place, affected };
        if old_index != new_index {
            let values = [old_index, new_index].map(|index| Some(format!("{index:04X}h")));
            let message =
                say!("the object `{}` moves from {:04X}h to {:04X}h", old.name(), old_index, new_index);
            self.report(&rules::OBJECT_MOVED, &spot, values, message);
        }
        if !(old.orphan || new.orphan) {
            self.name(&spot, [old.name(), new.name()], &rules::OBJECT_RENAMED);
        }
        self.storage(&spot, old, new);
        let is_orphan = old.orphan || new.orphan;
        if is_orphan || self.structure(&spot, old.object_type(), new.object_type()) {
            self.sub_indexes(pair);
        }
    }

    /// Whether a parameter of an application process may give equal objects a different meaning.
    fn has_meanings(&self) -> bool {
        !self.old.device.application.is_empty() || !self.new.device.application.is_empty()
    }

    /// Compares two names.
    pub(super) fn name(&mut self, spot: &Spot, [old, new]: [&str; 2], rule: &'static rules::ChangeRule) {
        let plain = |name: &str| name.split_whitespace().collect::<Vec<_>>().join(" ");
        if plain(old) == plain(new) {
            return;
        }
        let letters = |name: &str| words(name).replace(' ', "");
        let rule = if letters(old) == letters(new) { &rules::NAME_RESPELLED } else { rule };
        let spot = spot.field(&Field::ParameterName);
        let values = [Some(old.to_owned()), Some(new.to_owned())];
        self.report(rule, &spot, values, say!("the name changes from `{}` to `{}`", old, new));
    }

    /// Whether the objects are alike enough to compare their entries.
    fn structure(&mut self, spot: &Spot, old: ObjectType, new: ObjectType) -> bool {
        if old == new || (is_record(old) && is_record(new)) {
            return true;
        }
        let spot = spot.field(&Field::ObjectType);
        let is_alike = old.has_subs() && new.has_subs();
        let rule = if is_alike { &rules::ARRAY_OR_RECORD } else { &rules::OBJECT_TYPE_CHANGED };
        let values = [Some(old.name().to_owned()), Some(new.name().to_owned())];
        let message = say!("the object type changes from {} to {}", old.name(), new.name());
        self.report(rule, &spot, values, message);
        is_alike
    }

    fn storage(&mut self, spot: &Spot, old: &Object, new: &Object) {
        let (old_group, new_group) = (group(old), group(new));
        if old_group == new_group {
            return;
        }
        let affected = spot.affected.or(Affected::by_object(&self.new, spot.index.unwrap_or(0), new));
        let shown = |group: Option<&str>| group.unwrap_or("none").to_owned();
        let message = say!("the storage group changes from `{}` to `{}`", shown(old_group), shown(new_group));
        let values = [old_group, new_group].map(|group| group.map(str::to_owned));
        self.report(&rules::STORAGE_CHANGED, &Spot { affected, ..spot.clone() }, values, message);
    }

    /// The sub-indexes of an object.
    fn sub_indexes(&mut self, pair: ObjectPair<'a>) {
        let ObjectPair { index: (old_index, new_index), old, new } = pair;
        let Matched { pairs, removed, added } = matched(&subs(old_index, old), &subs(new_index, new));
        for sub in pairs {
            let is_moved = sub.0 != sub.1;
            if is_moved || old_index != new_index {
                self.moved.insert((old_index, sub.0), (new_index, sub.1));
            }
            self.entry(pair, sub);
        }
        let covered = self.slots_of_changed_mapping(old_index);
        for sub in removed.into_iter().filter(|sub| !covered.contains(sub)) {
            let Some(entry) = old.entry(sub) else { continue };
            let affected = Affected::by_entry(&self.old, (old_index, sub), old, &entry);
            let place = [place(&self.old, old_index, sub), Place::object(new_index)].map(Some);
            let [old, new] = place;
            let spot = Spot { index: Some(old_index), sub: Some(sub), old, new, affected };
            let message = say!("sub-index {} `{}` is removed", sub_index(sub), entry.name);
            self.report(&rules::ENTRY_REMOVED, &spot, [Some(entry.name.to_string()), None], message);
        }
        for sub in added.into_iter().filter(|sub| !covered.contains(sub)) {
            let Some(entry) = new.entry(sub) else { continue };
            let affected = Affected::by_entry(&self.new, (new_index, sub), new, &entry);
            let place = [Place::object(old_index), place(&self.new, new_index, sub)].map(Some);
            let [old, new] = place;
            let spot = Spot { index: Some(old_index), sub: Some(sub), old, new, affected };
            let message = say!("sub-index {} `{}` is added", sub_index(sub), entry.name);
            self.report(&rules::ENTRY_ADDED, &spot, [None, Some(entry.name.to_string())], message);
        }
    }
}

fn is_record(object_type: ObjectType) -> bool {
    matches!(object_type, ObjectType::Record | ObjectType::DefStruct)
}

/// The place of an entry in the description of a device.
pub(super) fn place(side: &Side<'_>, index: u16, sub: u8) -> Place {
    side.device.entry_place(index, sub)
}

/// A part that may have moved, identified by its name.
pub(super) struct MatchedPart<K> {
    pub(super) key: K,
    /// The words of its name; empty if it cannot move.
    pub(super) words: String,
    /// The properties that must match for parts of the same name.
    pub(super) shape: String,
}

/// The parts of two devices.
pub(super) struct Matched<K> {
    /// The keys of each part that both have, in the order of the old one.
    pub(super) pairs: Vec<(K, K)>,
    pub(super) removed: Vec<K>,
    pub(super) added: Vec<K>,
}

/// The words of a name: lower-case letters and digits, separated by spaces.
pub(super) fn words(name: &str) -> String {
    let lower = name.to_lowercase();
    let words = lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join(" ")
}

/// The parts by name, without names that occur twice.
fn unique<K: Copy + Ord>(parts: &[MatchedPart<K>]) -> BTreeMap<&str, &MatchedPart<K>> {
    let mut found = BTreeMap::new();
    let mut repeated = BTreeSet::new();
    for part in parts.iter().filter(|part| !part.words.is_empty()) {
        if found.insert(&*part.words, part).is_some() {
            repeated.insert(&*part.words);
        }
    }
    found.retain(|words, _| !repeated.contains(words));
    found
}

/// Finds the old parts in the new device: at the same key, or at a different key if the name is unique there, has the
/// same shape, and no longer exists at its old place.
pub(super) fn matched<K: Copy + Ord>(old: &[MatchedPart<K>], new: &[MatchedPart<K>]) -> Matched<K> {
    let (old_names, new_names) = (unique(old), unique(new));
    let by_key = |parts: &[MatchedPart<K>]| -> BTreeMap<K, String> {
        parts.iter().map(|part| (part.key, part.words.clone())).collect()
    };
    let (old_keys, new_keys) = (by_key(old), by_key(new));
    let moved = old_names.iter().filter_map(|(words, part)| {
        let target = new_names.get(words)?;
        let is_elsewhere = target.key != part.key && target.shape == part.shape;
        let has_left = new_keys.get(&part.key).is_none_or(|there| there != words);
        let is_new_there = old_keys.get(&target.key).is_none_or(|there| there != words);
        (is_elsewhere && has_left && is_new_there).then_some((part.key, target.key))
    });
    let moved: BTreeMap<K, K> = moved.collect();
    let taken: BTreeSet<K> = moved.values().copied().collect();
    let place = |key: K| match moved.get(&key) {
        Some(target) => Some(*target),
        None => Some(key).filter(|key| new_keys.contains_key(key) && !taken.contains(key)),
    };
    let pairs: Vec<(K, K)> = old_keys.keys().filter_map(|&key| Some((key, place(key)?))).collect();
    let found: BTreeSet<K> = pairs.iter().map(|(_, new)| *new).collect();
    Matched {
        removed: old_keys.keys().copied().filter(|&key| place(key).is_none()).collect(),
        added: new_keys.keys().copied().filter(|key| !found.contains(key)).collect(),
        pairs,
    }
}
