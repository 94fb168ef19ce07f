//! Deviations of the stack from the description, and the objects for which it calls the application
//! (`--hook`).

use crate::canopennode::node_id::replaced;
use crate::dictionary::{ResolvedEntry, TableDictionary};
use crate::model::Place;
use crate::resolve::Encoded;
use crate::{Note, Options};

/// The maximum value size of the stack's SDO server, and its default.
const SDO_BUFFER: (usize, usize) = (889, 32);

/// Whether a number is the EMCY COB-ID of this node, which is stored without the node-ID.
pub(super) fn is_of_node(number: u64, node_id: Option<u8>) -> bool {
    node_id.is_some_and(|node_id| number & 0x7FF == 0x80 + u64::from(node_id))
}

/// Notes about an entry.
pub(super) fn of_entry(index: u16, entry: &ResolvedEntry<'_>, node_id: Option<u8>, notes: &mut Vec<Note>) {
    let resolved = &entry.resolved;
    let place = Place::entry(index, entry.sub);
    let mut say = |place: Place, text: &str| notes.push(Note::new(place, text));
    if let (Some(field), true) = (resolved.limit(), resolved.access.is_writable()) {
        say(place.clone().field(field), "the stack does not enforce limits");
    }
    resolved.padding().iter().for_each(|text| say(place.clone(), text));
    match (index, entry.sub, &resolved.default) {
        (0x1003, 0, _) => {
            say(place.clone(), "the stack responds with the number of errors and accepts 0 to erase them");
        }
        (0x1280..=0x12FF, 1, default) if !matches!(default, Encoded::Word(0 | 0x8000_0000)) => {
            say(place.clone(), "an SDO client of the stack begins without a server");
        }
        (0x1800..=0x19FF, 4, _) => say(place.clone(), "the stack answers that the entry does not exist"),
        (0x1014, 0, Encoded::Word(value)) if !is_of_node(*value, node_id) => {
            say(place.clone(), &format!("the stack adds the node-ID to `0x{value:X}`"));
        }
        _ => {}
    }
    if let Some(text) = replaced(index, entry, node_id).filter(|_| index != 0x1014) {
        say(place, &text);
    }
}

/// Notes values that are longer than the buffer of the SDO server.
pub(super) fn of_lengths(dictionary: &TableDictionary<'_>, notes: &mut Vec<Note>) {
    let (most, usual) = SDO_BUFFER;
    let mut longest = 0;
    for (object, entry) in dictionary.entries() {
        let size = entry.resolved.shape.size();
        longest = longest.max(size);
        if size > most {
            let text = format!("the stack's SDOs transfer at most {most} bytes");
            notes.push(Note::new(Place::entry(object.index, entry.sub), text));
        }
    }
    if longest > usual {
        let text = format!("the longest value has {longest} bytes, more than the stack transfers by default");
        let help = format!("define `CO_SDO_BUFFER_SIZE` as {} when you compile the stack", longest.min(most));
        notes.push(Note::new(Place::device(), text).help(help));
    }
}

/// Whether the stack registers its own function for an object.
fn is_of_stack(index: u16) -> bool {
    matches!(
        index,
        0x1003 | 0x1005 | 0x1006 | 0x1014 | 0x1016 | 0x1019 | 0x1200 | 0x1400..=0x17FF | 0x1800..=0x1BFF
    )
}

/// The indexes in the options, in order and in hex. Notes report objects for which the stack calls no
/// function, or calls it for more entries.
pub(super) fn hooked(
    dictionary: &TableDictionary<'_>,
    options: &Options,
    notes: &mut Vec<Note>,
) -> Vec<String> {
    let mut hooked: Vec<String> = Vec::new();
    for &at in &options.hooks {
        let object = dictionary.object(at.index);
        let has_sub = |sub| object.is_some_and(|object| object.entries.iter().any(|entry| entry.sub == sub));
        let text = match (object, at.sub) {
            (None, _) => "no entry to call a hook for",
            (_, Some(sub)) if !has_sub(sub) => "no entry to call a hook for",
            _ if is_of_stack(at.index) => {
                "the stack has its own function for the object, so there is no hook"
            }
            (Some(object), sub) => {
                let index = format!("{:04X}", at.index);
                if hooked.last() != Some(&index) {
                    hooked.push(index);
                }
                if sub.is_none() || object.is_single() {
                    continue;
                }
                "the stack calls the hook for all entries of the object"
            }
        };
        notes.push(Note::new(Place::at(at.index, at.sub), text));
    }
    hooked
}
