//! The rows of the table, and those with an application-defined type (`--hook`).

use super::cell::{Cell, PlannedRow, RowType, hook_name};
use super::layout::RowLayout;
use crate::dictionary::TableDictionary;
use crate::model::Place;
use crate::{Note, Options};

/// A row of the table.
pub(super) struct StackRow {
    pub(super) index: u16,
    pub(super) sub: u8,
    pub(super) flags: String,
    pub(super) type_: RowType,
    /// Whether the application defines the type.
    pub(super) hooked: bool,
    pub(super) data: String,
    pub(super) name: String,
}

impl StackRow {
    pub(super) fn type_name(&self, prefix: &str) -> String {
        match self.type_ {
            _ if self.hooked => format!("&{prefix}_{}", hook_name(self.index)),
            RowType::Stack(name) => name.to_owned(),
            RowType::Block => format!("&{prefix}_block"),
            RowType::Bytes => format!("&{prefix}_bytes"),
        }
    }
}

/// The rows, by key.
pub(super) fn rows(
    dictionary: &TableDictionary<'_>,
    planned: &[Vec<PlannedRow>],
    layout: &RowLayout,
) -> Vec<StackRow> {
    let cells = planned.iter().flatten().zip(layout.data.iter().flatten());
    let rows = dictionary.entries().zip(cells).map(|((object, entry), (planned, data))| {
        let resolved = &entry.resolved;
        let stack = object.object.main.stack.as_ref().or(entry.entry.stack.as_ref());
        let detects_change = stack.is_some_and(|stack| stack.detects_change == Some(true));
        let set = [
            ('D', matches!(planned.cell, Cell::Direct(_))),
            ('N', planned.node_id),
            ('A', detects_change && resolved.tpdo),
            ('P', resolved.tpdo || resolved.rpdo),
            ('R', resolved.access.is_readable()),
            ('W', resolved.access.is_writable()),
        ];
        let set: String = set.into_iter().filter_map(|(letter, is_set)| is_set.then_some(letter)).collect();
        StackRow {
            index: object.index,
            sub: entry.sub,
            flags: flags(&set),
            type_: planned.type_,
            hooked: false,
            data: data.clone(),
            name: entry.entry.name.to_string(),
        }
    });
    let mut rows: Vec<StackRow> = rows.collect();
    if dictionary.object(0x1200).is_none() {
        rows.extend(default_sdo_server());
        rows.sort_by_key(|row| (row.index, row.sub));
    }
    rows
}

/// 1200h with the COB-IDs of CiA 301.
fn default_sdo_server() -> impl Iterator<Item = StackRow> {
    let row = |sub: u8, type_: &'static str, data: &str, name: &str| {
        let (flags, type_) =
            (if sub == 0 { "CO_OBJ_D___R_" } else { "CO_OBJ_DN__R_" }, RowType::Stack(type_));
        let name = format!("{name} (not in the description)");
        let (flags, data) = (flags.to_owned(), data.to_owned());
        StackRow { index: 0x1200, sub, flags, type_, hooked: false, data, name }
    };
    [
        row(0, "CO_TUNSIGNED8", "2u", "Highest sub-index"),
        row(1, "CO_TUNSIGNED32", "1536u", "COB-ID client to server"),
        row(2, "CO_TUNSIGNED32", "1408u", "COB-ID server to client"),
    ]
    .into_iter()
}

/// The flags macro of the stack, whose name contains the flag letters, or several macros if none covers all
/// flags.
fn flags(set: &str) -> String {
    let has = |letter| set.contains(letter);
    let triggers = has('A') && (has('D') || has('N') || !has('P'));
    let maps = has('P') && has('D');
    let is_named = |letter| has(letter) && !(letter == 'A' && triggers || letter == 'P' && maps);
    let name: String = "DNAPRW".chars().map(|letter| if is_named(letter) { letter } else { '_' }).collect();
    let triggers = if triggers { " | CO_OBJ___A___" } else { "" };
    let maps = if maps { " | CO_OBJ____P__" } else { "" };
    format!("CO_OBJ_{name}{triggers}{maps}")
}

/// The types of the stack that only read and write a value; the other types implement the object's function.
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
            notes.push(Note::new(Place::at(at.index, at.sub), "no entry to call a hook for"));
        }
    }
    hooks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_have_the_names_of_the_stack() {
        assert_eq!(flags("R"), "CO_OBJ_____R_");
        assert_eq!(flags("RWPA"), "CO_OBJ___APRW");
        assert_eq!(flags("DNR"), "CO_OBJ_DN__R_");
        assert_eq!(flags("DPR"), "CO_OBJ_D___R_ | CO_OBJ____P__");
        assert_eq!(flags("NPAR"), "CO_OBJ__N_PR_ | CO_OBJ___A___");
    }
}
