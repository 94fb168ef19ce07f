//! Rows with a type of the application (`--hook`).

use super::cell::{RowType, hook_name};
use super::rows::StackRow;
use crate::model::Place;
use crate::notes::place_of;
use crate::{Note, Options};

/// The types of the stack that only read and write a value; with the others it serves the object.
const PLAIN: [&str; 8] = [
    "CO_TUNSIGNED8",
    "CO_TUNSIGNED16",
    "CO_TUNSIGNED32",
    "CO_TSIGNED8",
    "CO_TSIGNED16",
    "CO_TSIGNED32",
    "CO_TSTRING",
    "CO_TDOMAIN",
];

/// A type that the application defines for rows of an object.
pub(super) struct TypeHook {
    index: u16,
    /// The types that the rows would have without it.
    pub(super) replaced: Vec<String>,
}

impl TypeHook {
    pub(super) fn name(&self) -> String {
        hook_name(self.index)
    }
}

/// Marks the rows that the options name. Notes report entries that are missing or that the stack serves.
pub(super) fn mark(
    rows: &mut [StackRow],
    options: &Options,
    prefix: &str,
    notes: &mut Vec<Note>,
) -> Vec<TypeHook> {
    let mut hooks: Vec<TypeHook> = Vec::new();
    for &at in &options.hooks {
        let mut is_described = false;
        for row in
            rows.iter_mut().filter(|row| row.index == at.index && at.sub.is_none_or(|sub| row.sub == sub))
        {
            is_described = true;
            if matches!(row.type_, RowType::Stack(name) if !PLAIN.contains(&name)) {
                let text = "the stack has its own type for the entry, so there is no hook";
                notes.push(Note::new(Place::entry(row.index, row.sub), text));
                continue;
            }
            if hooks.last().is_none_or(|hook| hook.index != row.index) {
                hooks.push(TypeHook { index: row.index, replaced: Vec::new() });
            }
            let replaced = row.type_name(prefix);
            let hook = hooks.last_mut().filter(|hook| !row.hooked && !hook.replaced.contains(&replaced));
            hook.into_iter().for_each(|hook| hook.replaced.push(replaced.clone()));
            row.hooked = true;
        }
        if !is_described {
            notes.push(Note::new(place_of(at), "no entry to call a hook for"));
        }
    }
    hooks
}
