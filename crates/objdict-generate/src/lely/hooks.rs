//! Entries for which the library calls the application (`--hook`).

use crate::dictionary::TableDictionary;
use crate::model::Place;
use crate::notes::place_of;
use crate::{Note, Options};

/// Maximum number of entries of an object: `nsub` is a byte.
pub(super) const MOST_ENTRIES: usize = 255;

/// An object for which the library calls functions of the application.
pub(super) struct Hook {
    pub(super) index: u16,
    /// The sub-indexes where it calls one for uploads.
    pub(super) read: Vec<u8>,
    /// The sub-indexes where it calls one for downloads.
    pub(super) written: Vec<u8>,
}

/// Whether the library has a function of its own for downloads to an object.
fn is_of_library(index: u16) -> bool {
    matches!(
        index,
        0x1003 | 0x1005 | 0x1006 | 0x100C | 0x100D | 0x1012 | 0x1014 | 0x1016 | 0x1017 | 0x1019 | 0x1028
        | 0x1200..=0x12FF | 0x1400..=0x1BFF | 0x1F25 | 0x1F80 | 0x1F82
    )
}

/// The objects with entries that the options name. Notes report what the library does not call for.
pub(super) fn hooked(
    dictionary: &TableDictionary<'_>,
    options: &Options,
    notes: &mut Vec<Note>,
) -> Vec<Hook> {
    let mut hooks: Vec<Hook> = Vec::new();
    for &at in &options.hooks {
        let entries = dictionary.object(at.index).map_or(&[][..], |object| &object.entries);
        let entries = entries.iter().take(MOST_ENTRIES);
        let mut asked = entries.filter(|entry| at.sub.is_none_or(|sub| sub == entry.sub)).peekable();
        if asked.peek().is_none() {
            notes.push(Note::new(place_of(at), "no entry to call a hook for"));
            continue;
        }
        if hooks.last().is_none_or(|hook| hook.index != at.index) {
            hooks.push(Hook { index: at.index, read: Vec::new(), written: Vec::new() });
        }
        let Some(hook) = hooks.last_mut() else { continue };
        for entry in asked {
            let access = entry.resolved.access;
            if access.is_writable() && is_of_library(at.index) {
                let text =
                    "the library has its own function for downloads, so the hook is called for uploads only";
                notes.push(Note::new(Place::entry(at.index, entry.sub), text));
            } else if access.is_writable() && !hook.written.contains(&entry.sub) {
                hook.written.push(entry.sub);
            }
            if access.is_readable() && !hook.read.contains(&entry.sub) {
                hook.read.push(entry.sub);
            }
        }
    }
    hooks
}
