//! Which part of one device is which part of the other.

use std::collections::{BTreeMap, BTreeSet};

/// A part that may have moved, known by its name.
pub(super) struct MatchedPart<K> {
    pub(super) key: K,
    /// The words of its name; empty for one that does not move.
    pub(super) words: String,
    /// What a part of the same name must have alike to be the same one.
    pub(super) shape: String,
}

/// The parts of two devices.
pub(super) struct Matched<K> {
    /// The keys of each part that both have, in the order of the old one.
    pub(super) pairs: Vec<(K, K)>,
    pub(super) removed: Vec<K>,
    pub(super) added: Vec<K>,
}

/// The words of a name: lower-case letters and digits, joined by blanks.
pub(super) fn words(name: &str) -> String {
    let lower = name.to_lowercase();
    let words = lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join(" ")
}

/// The parts by their names, without names that occur twice.
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

/// Finds the old parts in the new device: at their key, or at another key if what they are called is there alone, has the
/// same shape, and has left its old place.
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
