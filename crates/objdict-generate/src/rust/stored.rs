//! View of templates/rust/_stored.rs: structs of storage groups.

use std::collections::HashSet;

use super::view::{FieldView, fields_of, hex};
use crate::resolve::Datum;
use crate::stored::TableGroup;
use crate::table::Table;

/// Other types of the file and of the Rust prelude.
const TAKEN: &str = "
    Self Data Entry Abort Defaults Octets Time Value Field Offset OctetsVisitor Hooks ImageError Kept Option Some None Result Ok Err Box String
    Vec Clone Copy Debug Default PartialEq Eq PartialOrd Ord Hash Iterator IntoIterator Extend DoubleEndedIterator
    ExactSizeIterator From Into TryFrom TryInto FromIterator AsRef AsMut Drop Fn FnMut FnOnce Send Sync Sized Unpin
    ToOwned ToString
";

/// A storage group.
pub(super) struct GroupView<'a> {
    pub(super) group: &'a TableGroup,
    /// `PersistComm`.
    pub(super) type_name: String,
    pub(super) fields: Vec<FieldView<'a>>,
    /// Its first location in RAM.
    pub(super) first: usize,
    pub(super) last: usize,
    pub(super) layout: String,
    /// Whether a default is a formula.
    pub(super) depends_on_node_id: bool,
}

/// The groups of a table.
pub(super) fn group_views<'a>(table: &'a Table, places: &[usize]) -> Vec<GroupView<'a>> {
    let mut types: HashSet<String> = TAKEN.split_ascii_whitespace().map(str::to_owned).collect();
    let groups = table.groups.iter().enumerate().map(|(number, group)| {
        let fields = fields_of(table, Some(number), places);
        let rows = || table.members(Some(number)).flat_map(|field| &table.rows[field.rows.clone()]);
        let first = fields.first().map_or(0, |field| field.place);
        GroupView {
            type_name: claim(&mut types, &group.field, group.first),
            first,
            last: first + rows().count().saturating_sub(1),
            depends_on_node_id: rows().any(|row| matches!(row.resolved.default, Datum::Formula(_))),
            layout: hex(group.layout.into()),
            group,
            fields,
        }
    });
    groups.collect()
}

/// A type name; if it is taken, one with the group's index.
fn claim(types: &mut HashSet<String>, field: &str, index: u16) -> String {
    let camel: String = field.split('_').map(capital).collect();
    let others = (1_u32..).map(|number| match number {
        1 => format!("{camel}Group"),
        2 => format!("{camel}X{index:04X}"),
        _ => format!("{camel}X{index:04X}X{number}"),
    });
    let mut names = std::iter::once(camel.clone()).chain(others);
    names.find(|name| types.insert(name.clone())).unwrap_or(camel)
}

fn capital(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| first.to_ascii_uppercase().to_string() + letters.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_distinguished() {
        let mut types = HashSet::from(["Self".to_owned()]);
        let mut name = |field: &str, index| claim(&mut types, field, index);
        assert_eq!(name("persist_comm", 0x1000), "PersistComm");
        assert_eq!(name("self_", 0x1000), "SelfGroup");
        assert_eq!(name("a_1", 0x1000), "A1");
        assert_eq!(name("a1", 0x1001), "A1Group");
        assert_eq!(name("a1_", 0x1002), "A1X1002");
    }
}
