//! The rows of the table.

use super::cell::{Cell, PlannedRow, RowType, hook_name};
use super::layout::RowLayout;
use crate::dictionary::TableDictionary;

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

/// The macro of the stack for flags, which are letters of its name, or several if none covers all of them.
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
