//! Notes about what a target cannot express, in order, and each once.

use super::Note;
use crate::model::{Part, Place};

/// Notes in the order of their places; those of one place stay as they are.
pub(crate) fn in_order(mut notes: Vec<Note>) -> Vec<Note> {
    notes.sort_by(|a, b| a.place.cmp(&b.place));
    notes
}

/// Ordered notes without those that say the same of further entries of an object: the first one counts them.
pub(crate) fn once_per_object(notes: Vec<Note>) -> Vec<Note> {
    let mut kept: Vec<(Note, u32)> = Vec::new();
    for note in notes {
        let same = |(first, _): &&mut (Note, u32)| {
            index_of(&first.place).is_some_and(|index| index_of(&note.place) == Some(index))
                && first.place.field == note.place.field
                && first.message == note.message
        };
        let recent = kept.iter_mut().rev().take(8); // the kinds of notes that entries of one object have
        match recent.into_iter().find(same) {
            Some((_, more)) => *more += 1,
            None => kept.push((note, 0)),
        }
    }
    let counted = kept.into_iter().map(|(mut note, more)| {
        if more > 0 {
            let entries = if more == 1 { "entry" } else { "entries" };
            note.message = format!("{}; so for {more} more {entries} of the object", note.message);
        }
        note
    });
    counted.collect()
}

/// The index of the object whose entry a place is.
fn index_of(place: &Place) -> Option<u16> {
    match place.part {
        Part::Entry(index, _) => Some(index),
        _ => None,
    }
}
