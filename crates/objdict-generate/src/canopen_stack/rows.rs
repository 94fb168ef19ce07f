//! The rows of the table.

use super::cell::{Cell, Planned, Type};
use super::layout::Layout;
use crate::dictionary::Dictionary;

/// A row of the table.
pub(super) struct Row {
    pub(super) index: u16,
    pub(super) sub: u8,
    pub(super) flags: String,
    type_: Type,
    pub(super) data: String,
    pub(super) name: String,
}

impl Row {
    pub(super) fn type_name(&self, prefix: &str) -> String {
        match self.type_ {
            Type::Stack(name) => name.to_owned(),
            Type::Block => format!("&{prefix}_block"),
            Type::Bytes => format!("&{prefix}_bytes"),
        }
    }
}

/// The rows, by key.
pub(super) fn rows(dictionary: &Dictionary<'_>, planned: &[Vec<Planned>], layout: &Layout) -> Vec<Row> {
    let mut rows = Vec::new();
    for (number, object) in dictionary.objects.iter().enumerate() {
        for (at, entry) in object.entries.iter().enumerate() {
            let planned = &planned[number][at];
            let resolved = &entry.resolved;
            let stack = object.object.main.stack.as_ref().or(entry.entry.stack.as_ref());
            let detects_change = stack.is_some_and(|stack| stack.detects_change == Some(true));
            let (read, write) = resolved.sdo();
            let flags = Flags {
                direct: matches!(planned.cell, Cell::Direct(_)),
                node_id: planned.node_id,
                triggers: detects_change && resolved.tpdo,
                mappable: resolved.tpdo || resolved.rpdo,
                read,
                write,
            };
            rows.push(Row {
                index: object.index,
                sub: entry.sub,
                flags: flags.name(),
                type_: planned.type_,
                data: layout.data[number][at].clone(),
                name: entry.entry.name.to_string(),
            });
        }
    }
    if dictionary.object(0x1200).is_none() {
        rows.extend(default_sdo_server());
        rows.sort_by_key(|row| (row.index, row.sub));
    }
    rows
}

/// 1200h with the COB-IDs of CiA 301.
fn default_sdo_server() -> impl Iterator<Item = Row> {
    let row = |sub: u8, type_: &'static str, data: &str, name: &str| {
        let (flags, type_) = (if sub == 0 { "CO_OBJ_D___R_" } else { "CO_OBJ_DN__R_" }, Type::Stack(type_));
        let name = format!("{name} (not in the description)");
        Row { index: 0x1200, sub, flags: flags.to_owned(), type_, data: data.to_owned(), name }
    };
    [
        row(0, "CO_TUNSIGNED8", "2u", "Highest sub-index"),
        row(1, "CO_TUNSIGNED32", "1536u", "COB-ID client to server"),
        row(2, "CO_TUNSIGNED32", "1408u", "COB-ID server to client"),
    ]
    .into_iter()
}

/// The flags of a row.
#[derive(Clone, Copy)]
struct Flags {
    direct: bool,
    node_id: bool,
    triggers: bool,
    mappable: bool,
    read: bool,
    write: bool,
}

impl Flags {
    /// The macro of the stack, or several if none covers all of them.
    fn name(self) -> String {
        let lone = |letter: char, set: bool| if set { letter } else { '_' };
        let mut missing = Vec::new();
        let mut named = self;
        if named.triggers && (named.direct || named.node_id || !named.mappable) {
            missing.push("CO_OBJ___A___");
            named.triggers = false;
        }
        if named.mappable && named.direct {
            missing.push("CO_OBJ____P__");
            named.mappable = false;
        }
        let name: String = [
            lone('D', named.direct),
            lone('N', named.node_id),
            lone('A', named.triggers),
            lone('P', named.mappable),
            lone('R', named.read),
            lone('W', named.write),
        ]
        .into_iter()
        .collect();
        let mut names = vec![format!("CO_OBJ_{name}")];
        names.extend(missing.into_iter().map(str::to_owned));
        names.join(" | ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_have_the_names_of_the_stack() {
        let none = Flags {
            direct: false,
            node_id: false,
            triggers: false,
            mappable: false,
            read: true,
            write: false,
        };
        assert_eq!(none.name(), "CO_OBJ_____R_");
        assert_eq!(Flags { write: true, mappable: true, triggers: true, ..none }.name(), "CO_OBJ___APRW");
        assert_eq!(Flags { direct: true, node_id: true, ..none }.name(), "CO_OBJ_DN__R_");
        assert_eq!(Flags { direct: true, mappable: true, ..none }.name(), "CO_OBJ_D___R_ | CO_OBJ____P__");
        let all = Flags { node_id: true, mappable: true, triggers: true, ..none };
        assert_eq!(all.name(), "CO_OBJ__N_PR_ | CO_OBJ___A___");
    }
}
