//! Heartbeat consumers; CiA 301 allows one of a node.

use std::collections::HashMap;

use super::number;
use crate::Note;
use crate::dictionary::TableDictionary;
use crate::model::Place;

/// Which entries of 1016h a stack takes.
pub(super) struct Consumers {
    /// Whether it takes the entries from the last to the first, and ends there.
    pub(super) from_last: bool,
    /// Whether sub-index 0 says how many entries it takes.
    pub(super) is_counted: bool,
    /// What becomes of the second entry that monitors a node, if it is not served.
    pub(super) repeated: Option<&'static str>,
}

pub(super) fn notes(rules: &Consumers, dictionary: &TableDictionary<'_>) -> Vec<Note> {
    let Some(object) = dictionary.object(0x1016) else { return Vec::new() };
    let mut subs: Vec<u8> = object.entries.iter().map(|entry| entry.sub).filter(|&sub| sub > 0).collect();
    if rules.from_last {
        subs.reverse();
    }
    let count = number(Some(object), 0, 1).filter(|_| rules.is_counted);
    let is_used = |sub: &u8| number(Some(object), *sub, 4).is_some_and(|value| consumer(value).is_some());
    let (counted, others): (Vec<u8>, Vec<u8>) =
        subs.into_iter().partition(|&sub| count.is_none_or(|count| u64::from(sub) <= count));
    let mut notes = Vec::new();
    if let (Some(count), true) = (count, others.iter().any(is_used)) {
        let text =
            format!("the stack does not monitor the nodes of the entries above {count}, the value here");
        let note = Note::new(Place::entry(0x1016, 0), text).warning();
        notes.push(note.help("write the number of entries"));
    }
    let mut taken: HashMap<u64, u8> = HashMap::new();
    for sub in counted {
        let Some(node_id) = number(Some(object), sub, 4).and_then(consumer) else { continue };
        if let (Some(other), Some(effect)) = (taken.get(&node_id), rules.repeated) {
            let text = format!("{effect}: sub-index {other:02X}h also monitors node {node_id}");
            let note = Note::new(Place::entry(0x1016, sub), text).warning();
            notes.push(note.help("monitor each node in one entry"));
            if rules.from_last {
                break; // the entries before are not looked at
            }
        } else {
            taken.insert(node_id, sub);
        }
    }
    notes
}

/// The node of an entry that is in use.
fn consumer(value: u64) -> Option<u64> {
    let (time, node_id) = (value & 0xFFFF, value >> 16 & 0xFF);
    (time != 0 && node_id != 0).then_some(node_id)
}
