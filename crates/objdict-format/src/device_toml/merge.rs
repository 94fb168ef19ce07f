//! Merges a file or variant over another file: tables are merged key by key, the nearer value wins, and
//! `remove` removes.

use std::collections::BTreeSet;

use super::keys::PDO;
use super::words::{index, sub};
use objdict_keyed::section::present_name;
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_model::source::Span;

/// Trees that were merged.
#[derive(Clone, Debug)]
pub(super) struct Merged {
    pub(super) tree: KeyedTree,
    /// Addresses that nearer trees removed from those below, in capital letters; no profile needs to provide
    /// them.
    pub(super) taken: BTreeSet<String>,
}

impl Merged {
    pub(super) fn new(tree: KeyedTree) -> Self {
        Self { tree, taken: BTreeSet::new() }
    }

    /// Merges a nearer tree over this one.
    pub(super) fn with(self, near: &KeyedTree) -> Self {
        let Self { mut tree, mut taken } = self;
        let removed = removals(near);
        for Pair { key, .. } in &removed {
            let address = key.spelled().to_ascii_uppercase();
            for path in paths_of(&address) {
                if let Some(rest) = without(&tree, &path) {
                    tree = rest;
                    taken.insert(address.clone());
                    // the table of a PDO has two objects
                    taken.extend(
                        index(&address)
                            .filter(|_| path[0] != "object")
                            .map(|index| format!("{:04X}", index ^ 0x200)),
                    );
                }
            }
        }
        let mut removals = removals(&tree);
        // objects that the nearer one describes exist again
        removals.retain(|removal| !paths_of(&removal.key.spelled()).iter().any(|path| has(near, path)));
        removals.extend(removed);
        let mut tree = near.on(&tree, &|key| spelling(present_name(PDO, key)));
        if let Kind::Map(entries) = &*tree.kind {
            let mut entries: Vec<Pair> =
                entries.iter().filter(|entry| entry.key.text() != Some("remove")).cloned().collect();
            let key = KeyedTree::new(Span::empty(0), Kind::Text("remove".to_owned()));
            entries.push(Pair { key, value: KeyedTree::new(Span::empty(0), Kind::Map(removals)) });
            tree = KeyedTree::new(tree.span, Kind::Map(entries));
        }
        Self { tree, taken }
    }
}

/// The entries of `remove`, each as a key.
fn removals(tree: &KeyedTree) -> Vec<Pair> {
    let entry = |key: &KeyedTree| Pair { key: key.clone(), value: KeyedTree::new(key.span, Kind::Null) };
    match tree.get("remove").map(|tree| (tree, &*tree.kind)) {
        None => Vec::new(),
        Some((_, Kind::List(items))) => items.iter().map(entry).collect(),
        Some((_, Kind::Map(entries))) => entries.clone(),
        Some((tree, _)) => vec![entry(tree)],
    }
}

/// The paths at which a file may describe an address: objects, PDOs, and entries.
fn paths_of(address: &str) -> Vec<Vec<String>> {
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
    match address.split_once(':') {
        Some((object, entry)) if index(object).is_some() && sub(entry).is_some() => {
            vec![words(&["object", object, "sub", entry])]
        }
        Some(_) => Vec::new(),
        None => {
            let Some(number) = index(address) else { return Vec::new() };
            let pdo = match number {
                0x1400..=0x17FF => Some("rpdo"),
                0x1800..=0x1BFF => Some("tpdo"),
                _ => None,
            };
            // keys are compared as hex digits
            let pdo = pdo.map(|pdo| words(&[pdo, &((number & 0x1FF) + 1).to_string()]));
            std::iter::once(words(&["object", address])).chain(pdo).collect()
        }
    }
}

/// The normalised spelling of a key: `200a` and `200A`, `1` and `01` are equal.
fn spelling(key: &str) -> String {
    let is_hex = !key.is_empty() && key.len() <= 4 && key.bytes().all(|byte| byte.is_ascii_hexdigit());
    match u16::from_str_radix(key, 16) {
        Ok(number) if is_hex => format!("{number:X}"),
        _ => key.to_owned(),
    }
}

fn entry_of<'t>(tree: &'t KeyedTree, key: &str) -> Option<&'t Pair> {
    tree.entries()?.iter().find(|entry| spelling(&entry.key.spelled()) == spelling(key))
}

fn has(tree: &KeyedTree, path: &[String]) -> bool {
    match path {
        [] => true,
        [key, rest @ ..] => entry_of(tree, key).is_some_and(|entry| has(&entry.value, rest)),
    }
}

/// The tree without the value at a path; `None` if there is none.
fn without(tree: &KeyedTree, path: &[String]) -> Option<KeyedTree> {
    let (key, rest) = path.split_first()?;
    let found = entry_of(tree, key)?;
    let replaced = if rest.is_empty() { None } else { Some(without(&found.value, rest)?) };
    let entries = tree.entries()?.iter().filter_map(|entry| match &replaced {
        _ if !std::ptr::eq(entry, found) => Some(entry.clone()),
        None => None,
        Some(value) => Some(Pair { key: entry.key.clone(), value: value.clone() }),
    });
    Some(KeyedTree::new(tree.span, Kind::Map(entries.collect())))
}
