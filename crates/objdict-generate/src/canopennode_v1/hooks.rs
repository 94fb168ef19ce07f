//! Objects for which the stack calls the application (`--hook`).

use crate::dictionary::TableDictionary;
use crate::notes::place_of;
use crate::{Note, Options};

/// Whether the stack registers a function of its own for an object.
fn is_of_stack(index: u16) -> bool {
    matches!(
        index,
        0x1003 | 0x1005 | 0x1006 | 0x1014 | 0x1016 | 0x1019 | 0x1200 | 0x1400..=0x17FF | 0x1800..=0x1BFF
    )
}

/// The indexes that the options name, in order and in hex. Notes report where the stack calls no function, and where for more.
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
        notes.push(Note::new(place_of(at), text));
    }
    hooked
}
