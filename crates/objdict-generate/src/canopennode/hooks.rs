//! Extensions through which the stack calls the application (`--hook`).

use super::limits::is_of_stack;
use super::plan::StackObject;
use crate::model::{Access, Address};
use crate::notes::place_of;
use crate::{Note, Options};

/// An object with an extension of the application.
pub(super) struct HookedObject {
    pub(super) index: u16,
    /// Position of the object in the list.
    pub(super) position: usize,
    /// Whether SDOs or PDOs read an entry of it.
    pub(super) is_read: bool,
    /// Whether SDOs or PDOs write an entry of it.
    pub(super) is_written: bool,
}

/// The objects that the options name. Notes report what an extension of the stack cannot do.
pub(super) fn hooked(
    objects: &[StackObject<'_>],
    options: &Options,
    notes: &mut Vec<Note>,
) -> Vec<HookedObject> {
    let mut hooked: Vec<HookedObject> = Vec::new();
    for &at in &options.hooks {
        let (place, Address { index, sub }) = (place_of(at), at);
        let has_entry = |object: &StackObject<'_>| {
            sub.is_none_or(|sub| object.members().any(|member| member.entry.sub == sub))
        };
        let mut found = objects.iter().enumerate();
        let Some((position, object)) =
            found.find(|(_, object)| object.index == index).filter(|(_, object)| has_entry(object))
        else {
            notes.push(Note::new(place, "no entry to call a hook for"));
            continue;
        };
        if is_of_stack(index) {
            let text = "the stack has its own extension of the object, so there is no hook";
            notes.push(Note::new(place, text));
            continue;
        }
        if sub.is_some() && object.members().nth(1).is_some() {
            notes.push(Note::new(place, "the stack calls the hook for all entries of the object"));
        }
        if hooked.last().is_some_and(|last| last.index == index) {
            continue;
        }
        let accesses = || object.members().map(|member| member.entry.resolved.access);
        let (is_read, is_written) =
            (accesses().any(Access::is_readable), accesses().any(Access::is_writable));
        hooked.push(HookedObject { index, position, is_read, is_written });
    }
    hooked
}
