//! The parameter groups of 1010h and 1011h.

use super::cell::{Cell, PlannedRow};
use super::layout::{ParaGroup, RowLayout};
use super::special::{RESTORE, STORE};
use crate::Note;
use crate::dictionary::TableDictionary;
use crate::model::Place;

/// The arrays of `CO_PARA`.
#[derive(Default)]
pub(super) struct ParameterArrays {
    /// A line for each sub-index of 1010h.
    pub(super) store: Vec<String>,
    /// A line for each sub-index of 1011h.
    pub(super) restore: Vec<String>,
    /// Whether a row states that there are defaults, but no group owns them.
    pub(super) nothing: bool,
}

impl ParameterArrays {
    /// Assigns the groups of a layout to sub-indexes and enters them in the rows.
    pub(super) fn new(
        dictionary: &TableDictionary<'_>,
        planned: &[Vec<PlannedRow>],
        layout: &mut RowLayout,
        prefix: &str,
        notes: &mut Vec<Note>,
    ) -> Self {
        let subs = |index: u16| group_rows(dictionary, planned, index);
        let (store, restore) = (subs(STORE), subs(RESTORE));
        let rows = if store.is_empty() { &restore } else { &store };
        let count = rows.iter().map(|row| row.sub).max().unwrap_or(0);
        let subs = assign(&layout.groups, count, notes);
        if store.is_empty() {
            missing(&layout.groups, notes);
        } else if layout.groups.is_empty() {
            let note = Note::new(Place::object(STORE), "without a storage group nothing is stored");
            notes.push(note.help("define one with `--group 2000-2FFF=NAME`"));
        }
        let mut parameters = Self::default();
        for (rows, index) in [(&store, STORE), (&restore, RESTORE)] {
            for row in rows {
                let group = subs.iter().position(|&sub| sub == Some(row.sub));
                let line = parameters.line(&layout.groups, group, row, index, prefix);
                note_value(&layout.groups, group, row, index, notes);
                let (name, lines) = match index {
                    STORE => ("store", &mut parameters.store),
                    _ => ("restore", &mut parameters.restore),
                };
                layout.data[row.object][row.entry] = format!("&{prefix}_{name}[{}]", lines.len());
                lines.push(line);
            }
        }
        parameters
    }

    /// The initializer of a `CO_PARA`.
    fn line(
        &mut self,
        groups: &[ParaGroup],
        group: Option<usize>,
        row: &GroupRow,
        index: u16,
        prefix: &str,
    ) -> String {
        let value = row.value;
        let (offset, size, start, defaults, reset) = match group {
            Some(at) => {
                let before: Vec<String> =
                    groups[..at].iter().map(|group| format!("sizeof({}_t)", group.variable)).collect();
                let offset = if before.is_empty() { "0u".to_owned() } else { before.join(" + ") };
                let ParaGroup { variable, communication, .. } = &groups[at];
                let reset = if *communication { "CO_RESET_COM" } else { "CO_RESET_NODE" };
                let defaults = format!("(uint8_t *)&{variable}_defaults");
                (offset, format!("sizeof({variable}_t)"), format!("(uint8_t *)&{variable}"), defaults, reset)
            }
            None => {
                let defaults = match groups.first() {
                    Some(group) => format!("(uint8_t *)&{}_defaults", group.variable),
                    None => format!("(uint8_t *)&{prefix}_nothing"),
                };
                ("0u".to_owned(), "0u".to_owned(), "NULL".to_owned(), defaults, "CO_RESET_INVALID")
            }
        };
        // 1011h reads as 1 if there are defaults
        let defaults = if index == RESTORE && value == 0 { "NULL".to_owned() } else { defaults };
        let defaults = if index == STORE && group.is_none() { "NULL".to_owned() } else { defaults };
        self.nothing |= defaults.ends_with("_nothing");
        let what = group.map_or("no values of its own", |at| &groups[at].name);
        let what = crate::escape::c_comment(what);
        format!(
            "{{.Offset = {offset}, .Size = {size}, .Start = {start}, .Default = {defaults}, .Type = {reset}, .Ident = NULL, .Value = 0x{value:08X}u}}, /* sub-index {:02X}h: {what} */",
            row.sub
        )
    }
}

/// A row of a parameter group.
struct GroupRow {
    object: usize,
    entry: usize,
    sub: u8,
    value: u32,
}

fn group_rows(dictionary: &TableDictionary<'_>, planned: &[Vec<PlannedRow>], index: u16) -> Vec<GroupRow> {
    let Some(object) = dictionary.objects.iter().position(|object| object.index == index) else {
        return Vec::new();
    };
    let rows = planned[object].iter().enumerate().filter_map(|(entry, planned)| match planned.cell {
        Cell::Group(value) => {
            Some(GroupRow { object, entry, sub: dictionary.objects[object].entries[entry].sub, value })
        }
        _ => None,
    });
    rows.collect()
}

/// Assigns a sub-index to each group: 2 for communication, 3 for the application, then the others.
fn assign(groups: &[ParaGroup], count: u8, notes: &mut Vec<Note>) -> Vec<Option<u8>> {
    if count <= 1 {
        return groups.iter().map(|_| (count == 1).then_some(1)).collect();
    }
    let is_first = |at: usize, communication: bool| {
        groups[at].communication == communication
            && groups[..at].iter().all(|group| group.communication != communication)
    };
    let mut behind = 3;
    let mut subs = Vec::new();
    for (at, group) in groups.iter().enumerate() {
        let sub = match (is_first(at, true), is_first(at, false)) {
            (true, _) => 2,
            (_, true) => 3,
            _ => {
                behind += 1;
                behind
            }
        };
        if sub > count {
            let text =
                format!("no sub-index is free for the group `{}`, so SDOs cannot store it", group.name);
            notes.push(Note::new(Place::object(STORE), text));
        }
        subs.push((sub <= count).then_some(sub));
    }
    subs
}

fn missing(groups: &[ParaGroup], notes: &mut Vec<Note>) {
    for group in groups {
        let text = format!("without 1010h SDOs cannot store the group `{}`", group.name);
        notes.push(Note::new(Place::object(group.first), text));
    }
}

/// Notes if reading 1010h and 1011h returns a value other than described, or one that does not match the
/// behaviour.
fn note_value(groups: &[ParaGroup], group: Option<usize>, row: &GroupRow, index: u16, notes: &mut Vec<Note>) {
    let place = Place::entry(index, row.sub);
    match group {
        Some(at) if row.value & 1 == 0 => {
            let what = if index == STORE { "stores" } else { "restores" };
            let text =
                format!("bit 0 of its value is clear, so no SDO {what} the group `{}`", groups[at].name);
            notes.push(Note::new(place, text));
        }
        _ if index == RESTORE && row.value > 1 => {
            notes.push(Note::new(place, "the stack answers only 1 or 0"));
        }
        _ => {}
    }
}
