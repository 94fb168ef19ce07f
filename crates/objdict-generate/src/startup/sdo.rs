//! What stacks demand of the parameters of SDO channels.

use super::{datum, number};
use crate::Note;
use crate::dictionary::TableDictionary;
use crate::model::Place;

/// The bit of a COB-ID that says that it is not valid.
const NOT_VALID: u64 = 1 << 31;

/// A demand, and what happens otherwise.
pub(super) enum DemandRow {
    /// The highest sub-index of the objects in a range is one of these, or the stack does not start.
    Highest { first: u16, last: u16, allowed: &'static [u64] },
    /// The default server (1200h) has the COB-IDs of its entries: these must be valid, and those of CiA 301.
    DefaultServer,
}

pub(super) fn notes(row: &DemandRow, dictionary: &TableDictionary<'_>) -> Vec<Note> {
    match row {
        DemandRow::Highest { first, last, allowed } => highest(dictionary, (*first, *last), allowed),
        DemandRow::DefaultServer => default_server(dictionary),
    }
}

fn highest(dictionary: &TableDictionary<'_>, (first, last): (u16, u16), allowed: &[u64]) -> Vec<Note> {
    let objects = dictionary.objects.iter().filter(|object| (first..=last).contains(&object.index));
    let wrong = objects.filter_map(|object| {
        let highest = number(Some(object), 0, 1).filter(|highest| !allowed.contains(highest))?;
        let words: Vec<String> = allowed.iter().map(u64::to_string).collect();
        let text = format!("the stack does not start with {highest} here, but with {}", words.join(" or "));
        Some(Note::new(Place::entry(object.index, 0), text).warning().help("correct the number of entries"))
    });
    wrong.collect()
}

fn default_server(dictionary: &TableDictionary<'_>) -> Vec<Note> {
    let object = dictionary.object(0x1200);
    let wrong = [(1, 0x600_u64), (2, 0x580)].into_iter().filter_map(|(sub, base)| {
        let value = datum(object, sub, 4)?;
        let of_node = |node_id: u8| value.on_node(Some(node_id)) == base + u64::from(node_id);
        let fits = match dictionary.node_id {
            Some(node_id) => of_node(node_id),
            None => (1..=127).any(of_node),
        };
        let text = match value.word() {
            _ if fits => return None,
            word if word & NOT_VALID != 0 => {
                "the COB-ID is not valid (bit 31), so the stack has no SDO server".to_owned()
            }
            word => format!("with the COB-ID {word:X}h the stack does not answer the SDOs of its node-ID"),
        };
        let note = Note::new(Place::entry(0x1200, sub), text).warning();
        Some(note.help("write `$NODEID+0x600` in sub-index 1 and `$NODEID+0x580` in sub-index 2"))
    });
    wrong.collect()
}
