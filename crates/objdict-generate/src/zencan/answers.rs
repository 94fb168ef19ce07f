//! The SDO answers of a zencan node per entry, and their deviations from the description.

use std::collections::BTreeMap;

use crate::Note;
use crate::dictionary::{ResolvedEntry, TableDictionary};
use crate::model::{Access, Place};
use crate::resolve::Encoded;

/// Whether zencan reserves the index: for the setting `autostart`, or the boot loader.
pub(super) fn is_reserved(index: u16) -> bool {
    matches!(index, 0x5000 | 0x5500 | 0x5510..=0x551F)
}

/// All entries of the node.
#[derive(Default)]
pub(super) struct Answers(BTreeMap<(u16, u8), EntryAnswer>);

/// An entry of the node.
pub(super) struct EntryAnswer {
    pub(super) access: Access,
    pub(super) tpdo: bool,
    pub(super) rpdo: bool,
    /// Maximum size in bytes.
    pub(super) size: usize,
    pub(super) held: Held,
}

/// The initial value.
#[derive(Clone, PartialEq, Eq)]
pub(super) enum Held {
    /// These bytes.
    Bytes(Vec<u8>),
    /// The node-ID plus a number.
    Formula(u64),
    /// A value provided by the application or by zencan.
    Served,
}

impl EntryAnswer {
    /// A number that cannot be mapped.
    pub(super) fn number(access: Access, size: usize, number: u64) -> Self {
        let held = Held::Bytes(number.to_le_bytes().into_iter().take(size).collect());
        Self { access, tpdo: false, rpdo: false, size, held }
    }
}

impl Answers {
    pub(super) fn put(&mut self, index: u16, sub: u8, answer: EntryAnswer) {
        self.0.insert((index, sub), answer);
    }

    /// Maximum size of an entry in bytes; `None` for a missing entry.
    pub(super) fn size(&self, index: u16, sub: u8) -> Option<usize> {
        self.0.get(&(index, sub)).map(|answer| answer.size)
    }

    /// Deviations of the node from the description.
    pub(super) fn differences(&self, dictionary: &TableDictionary<'_>) -> Vec<Note> {
        let mut notes = Vec::new();
        for (object, entry) in dictionary.entries() {
            let place = Place::entry(object.index, entry.sub);
            match self.0.get(&(object.index, entry.sub)) {
                Some(answer) => difference(&place, answer, entry, &mut notes),
                None if is_reserved(object.index) => {}
                None => notes.push(Note::new(place, "zencan has no such entry")),
            }
        }
        for &(index, sub) in self.0.keys().filter(|(index, sub)| dictionary.entry(*index, *sub).is_none()) {
            notes.push(Note::new(Place::entry(index, sub), "zencan adds the entry"));
        }
        notes
    }
}

fn difference(place: &Place, answer: &EntryAnswer, entry: &ResolvedEntry<'_>, notes: &mut Vec<Note>) {
    let resolved = &entry.resolved;
    let described = described(entry);
    if answer.held != Held::Served && answer.held != described {
        let (is, shall_be) = (shown(&answer.held), shown(&described));
        let note = Note::new(place.clone(), format!("the value is {is} in zencan, not {shall_be}"));
        notes.push(match described {
            Held::Formula(_) => note.help("generate with `--node-id`, or set the value in the application"),
            _ => note,
        });
    }
    for (verb, zencan, device) in [
        ("read", answer.access.is_readable(), resolved.access.is_readable()),
        ("write", answer.access.is_writable(), resolved.access.is_writable()),
    ] {
        match (zencan, device) {
            (true, false) => notes.push(Note::new(place.clone(), format!("in zencan an SDO can {verb} it"))),
            (false, true) => notes.push(Note::new(place.clone(), format!("in zencan no SDO can {verb} it"))),
            _ => {}
        }
    }
    if (answer.tpdo, answer.rpdo) != (resolved.tpdo, resolved.rpdo) {
        notes.push(Note::new(place.clone(), "zencan does not allow the entry in PDOs"));
    }
}

fn described(entry: &ResolvedEntry<'_>) -> Held {
    match &entry.resolved.default {
        Encoded::Formula(offset) => Held::Formula(*offset),
        value => Held::Bytes(value.bytes_on(None, entry.resolved.shape.size())),
    }
}

fn shown(held: &Held) -> String {
    match held {
        Held::Formula(offset) => format!("`$NODEID+{offset:#X}`"),
        Held::Served => "served".to_owned(),
        Held::Bytes(bytes) if bytes.is_empty() => "empty".to_owned(),
        Held::Bytes(bytes) if bytes.len() <= 8 => {
            let number = bytes.iter().rev().fold(0_u64, |number, &byte| (number << 8) | u64::from(byte));
            format!("`{number:#X}`")
        }
        Held::Bytes(bytes) if bytes.iter().all(|&byte| byte == 0) => format!("{} zero bytes", bytes.len()),
        Held::Bytes(bytes) => {
            let hex: String = bytes.iter().take(8).map(|byte| format!("{byte:02X}")).collect();
            format!("`{hex}…` ({} bytes)", bytes.len())
        }
    }
}
