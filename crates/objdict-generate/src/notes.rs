//! Notes about content that a target cannot express, ordered and without repetition.

use std::collections::{BTreeSet, HashMap};

use super::Note;
use crate::diagnostic::counted;
use crate::model::{Part, Place};

/// Maximum number of objects or ranges named in a message.
const MOST_RANGES: usize = 8;

/// The treatment of the node-ID if a stack does not add it.
pub(crate) fn added(node_id: Option<u8>) -> String {
    match node_id {
        Some(node_id) => format!("the constant node-ID {node_id} is added"),
        None => "nothing is added".to_owned(),
    }
}

/// Orders notes by place; notes at the same place keep their order.
pub(crate) fn in_order(mut notes: Vec<Note>) -> Vec<Note> {
    notes.sort_by(|a, b| a.place.cmp(&b.place));
    notes
}

/// Merges equal notes about several entries or objects of the device into the first one, which states their number
/// and names the objects.
pub(crate) fn once_per_device(notes: Vec<Note>) -> Vec<Note> {
    let mut kept: Vec<Note> = Vec::new();
    let mut known: HashMap<(bool, String), usize> = HashMap::new();
    let mut merged = BTreeSet::new();
    for note in notes {
        let key = index_of(&note.place).map(|(is_entry, _)| (is_entry, note.message.clone()));
        let first = key.as_ref().and_then(|key| known.get(key).copied());
        match first.and_then(|first| Some((first, kept.get_mut(first)?))) {
            Some((number, first)) => {
                merged.insert(number);
                first.also.push(note.place);
            }
            None => {
                known.extend(key.map(|key| (key, kept.len())));
                kept.push(note);
            }
        }
    }
    // notes merged earlier already state their count
    for (_, note) in kept.iter_mut().enumerate().filter(|(number, _)| merged.contains(number)) {
        let Some((is_entry, index)) = index_of(&note.place) else { continue };
        let more = match is_entry {
            true => counted(note.also.len(), "more entry", "more entries"),
            false => counted(note.also.len(), "more object", "more objects"),
        };
        let indexes: Vec<u16> = note.also.iter().filter_map(index_of).map(|(_, index)| index).collect();
        let same = indexes.iter().all(|&other| other == index);
        let of = if same { "of the object".to_owned() } else { format!("({})", ranges(&indexes)) };
        note.message = format!("{}; also for {more} {of}", note.message);
    }
    kept
}

/// Indexes in ascending order as text: `1010h, 1400h to 1403h`; only the first ones if there are many.
fn ranges(indexes: &[u16]) -> String {
    let mut ranges: Vec<(u16, u16)> = Vec::new();
    for &index in indexes {
        match ranges.last_mut() {
            Some((_, last)) if index.saturating_sub(*last) <= 1 => *last = index,
            _ => ranges.push((index, index)),
        }
    }
    let range = |&(first, last): &(u16, u16)| match last - first {
        0 => format!("{first:04X}h"),
        _ => format!("{first:04X}h to {last:04X}h"),
    };
    let more = if ranges.len() > MOST_RANGES { ", …" } else { "" };
    let named: Vec<String> = ranges.iter().take(MOST_RANGES).map(range).collect();
    named.join(", ") + more
}

/// Whether a place is an entry, and its index; `None` if it is not an object either.
fn index_of(place: &Place) -> Option<(bool, u16)> {
    match place.part {
        Part::Entry(index, _) => Some((true, index)),
        Part::Object(index) => Some((false, index)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_holds_for_many_entries_is_reported_once() {
        let at = |index, sub| Note::new(Place::entry(index, sub), "the stack has no room");
        let notes = vec![at(0x1400, 1), at(0x1400, 2), at(0x1401, 1), at(0x1A00, 1)];
        let per_object = once_per_device(notes[..2].to_vec());
        assert_eq!(
            per_object[0].to_string(),
            "0x1400sub1: the stack has no room; also for 1 more entry of the object"
        );
        assert_eq!(per_object[0].also, [Place::entry(0x1400, 2)]);
        let objects = (0x1404..0x1408).map(|index| Note::new(Place::object(index), "only 4 PDOs")).collect();
        assert_eq!(
            once_per_device(objects)[0].to_string(),
            "0x1404: only 4 PDOs; also for 3 more objects (1405h to 1407h)"
        );
        let per_device = once_per_device(notes);
        assert_eq!(per_device.len(), 1);
        assert_eq!(
            per_device[0].message,
            "the stack has no room; also for 3 more entries (1400h to 1401h, 1A00h)"
        );
        assert_eq!(per_device[0].places().count(), 4);
        let many: Vec<Note> = (0..20).map(|number| at(0x2000 + 2 * number, 0)).collect();
        let told = once_per_device(many);
        assert!(told[0].message.ends_with("2010h, …)"), "{}", told[0].message);
        assert_eq!(told[0].also.len(), 19);
    }
}
