//! The layout of each object (a variable, an array or a record of the stack), and the groups of values that the stack stores together.

use super::names::{MemberNames, behind_index, cname, word};
use super::storage::ValueStorage;
use crate::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use crate::model::{DataType, ObjectType, Place};
use crate::resolve::ValueShape;
use crate::{Note, Options, StackLayout};

/// Maximum number of entries of an object in the stack.
const MOST_ENTRIES: usize = u8::MAX as usize;

/// Objects with a number of elements that the stack requires.
const COUNTED: [u16; 4] = [0x1003, 0x1010, 0x1011, 0x1016];

/// An object of the stack.
pub(super) struct StackObject<'a> {
    pub(super) index: u16,
    /// The name of the object; empty if there is none.
    pub(super) cname: String,
    /// The storage group.
    pub(super) group: String,
    pub(super) layout: ObjectLayout<'a>,
    /// The number of elements, if the stack requires it.
    pub(super) count: Option<usize>,
}

/// How the stack accesses the entries of an object.
pub(super) enum ObjectLayout<'a> {
    /// A single value.
    Var(Member<'a>),
    /// Sub-index 0 and identical elements from sub-index 1 on, without gaps.
    Array(Member<'a>, Vec<Member<'a>>),
    /// Any sub-indexes.
    Record(Vec<Member<'a>>),
}

/// An entry in the stack.
pub(super) struct Member<'a> {
    /// The member name in a record.
    pub(super) name: String,
    pub(super) entry: &'a ResolvedEntry<'a>,
    pub(super) storage: ValueStorage,
}

impl StackObject<'_> {
    /// `2000_setpoint`: after `x` the member of the group's struct, after `o_` the descriptor of the object.
    pub(super) fn name(&self) -> String {
        behind_index(self.index, &self.cname)
    }

    /// All entries, by sub-index.
    pub(super) fn members(&self) -> impl Iterator<Item = &Member<'_>> {
        let (first, rest) = match &self.layout {
            ObjectLayout::Var(member) => (Some(member), [].as_slice()),
            ObjectLayout::Array(sub0, elements) => (Some(sub0), elements.as_slice()),
            ObjectLayout::Record(members) => (None, members.as_slice()),
        };
        first.into_iter().chain(rest)
    }

    /// The variable of an entry in C syntax.
    pub(super) fn variable(&self, prefix: &str, member: &Member<'_>) -> String {
        let name = format!("{prefix}_{}.x{}", self.group, self.name());
        match &self.layout {
            ObjectLayout::Var(_) => name,
            ObjectLayout::Array(..) if member.entry.sub == 0 => format!("{name}_sub0"),
            ObjectLayout::Array(..) => format!("{name}[{}]", member.entry.sub - 1),
            ObjectLayout::Record(_) => format!("{name}.{}", member.name),
        }
    }
}

/// Plans all objects of a dictionary; deviations from the description are noted.
pub(super) fn plan<'a>(
    dictionary: &'a TableDictionary<'a>,
    options: &Options,
    notes: &mut Vec<Note>,
) -> Vec<StackObject<'a>> {
    dictionary.objects.iter().map(|object| planned(object, options, notes)).collect()
}

fn planned<'a>(object: &'a ResolvedObject<'a>, options: &Options, notes: &mut Vec<Note>) -> StackObject<'a> {
    let place = Place::object(object.index);
    let mut entries: &[ResolvedEntry<'_>] = &object.entries;
    if let Some((last, others)) = entries.split_last().filter(|(_, others)| others.len() >= MOST_ENTRIES) {
        let text = format!("an object of the stack has at most {MOST_ENTRIES} entries; the entry is omitted");
        notes.push(Note::new(Place::entry(object.index, last.sub), text));
        entries = others;
    }
    let is_array = object.object.object_type() == ObjectType::Array;
    let is_stored = |entry: &ResolvedEntry<'_>| options.layout == StackLayout::Complete || has_value(entry);
    // the elements of an array are one variable
    let are_stored = is_array && entries.iter().any(|entry| entry.sub > 0 && is_stored(entry));
    let mut names = MemberNames::new(options.layout);
    let mut members = entries.iter().map(|entry| {
        let name = names.claim(&entry.name, entry.sub);
        let storage = ValueStorage::new(entry, is_stored(entry) || are_stored && entry.sub > 0);
        Member { name, entry, storage }
    });
    let layout = match members.next() {
        Some(only) if object.is_single() => ObjectLayout::Var(only),
        Some(first) if is_array => {
            let rest: Vec<Member<'_>> = members.collect();
            match invalid(&first, &rest) {
                None => ObjectLayout::Array(first, rest),
                Some(why) => {
                    let note =
                        Note::new(place, format!("the ARRAY becomes a record of the stack because {why}"));
                    notes.push(note.help("access its elements as members, not by a subscript"));
                    ObjectLayout::Record(std::iter::once(first).chain(rest).collect())
                }
            }
        }
        first => ObjectLayout::Record(first.into_iter().chain(members).collect()),
    };
    let elements = entries.iter().filter(|entry| entry.sub > 0).count();
    let count = (is_array || COUNTED.contains(&object.index)) && elements > 0;
    StackObject {
        index: object.index,
        cname: cname(&object.name, options.layout.into()),
        group: group(object, options),
        layout,
        count: count.then_some(elements),
    }
}

/// Whether CANopenEditor generates storage for an entry: it has a value, or is a string of stated length.
fn has_value(entry: &ResolvedEntry<'_>) -> bool {
    let length = entry.entry.stack.as_ref().and_then(|stack| stack.min_string_length);
    entry.entry.value().is_some() || length > Some(0)
}

/// The reason why entries do not form an array of the stack.
fn invalid(sub0: &Member<'_>, elements: &[Member<'_>]) -> Option<&'static str> {
    if sub0.entry.sub != 0 {
        return Some("it has no sub-index 0");
    }
    if sub0.entry.resolved.shape != ValueShape::Word(DataType::UNSIGNED8) {
        return Some("its sub-index 0 is not UNSIGNED8");
    }
    let Some(first) = elements.first() else {
        return Some("it has no elements");
    };
    if elements.iter().zip(1..).any(|(element, sub)| element.entry.sub != sub) {
        return Some("there are gaps between its sub-indexes");
    }
    let unlike = elements.iter().any(|element| !element.storage.is_like(&first.storage));
    unlike.then_some("its elements differ in type, length or access")
}

/// Names not available for groups, because `OD_<name>` or `OD_<name>_t` has a different meaning.
const TAKEN: &str = "t size attr entry stream io extension attributes applyNodeId initHooks initLimits writeLimited H DEFINITION";

/// Prefixes of other macros of the tables.
const BEGINS: [&str; 8] = ["read_", "write_", "CNT_", "ENTRY_", "ATTR_", "FLAGS_", "obj_", "INIT_"];

/// The group of an object: from the description, otherwise from the options, otherwise by index.
pub(super) fn group(object: &ResolvedObject<'_>, options: &Options) -> String {
    match (object.group(options), options.layout) {
        (Some(name), _) => identifier(name),
        (None, StackLayout::Complete) => by_index(object.index).to_owned(),
        (None, _) => "RAM".to_owned(),
    }
}

/// Communication parameters are stored by default; commands, states and application values are not.
fn by_index(index: u16) -> &'static str {
    match index {
        0x1001..=0x1003 | 0x1010 | 0x1011 | 0x1020..=0x1027 | 0x1200 | 0x1F50..=0x1F57 => "RAM",
        0x1000..=0x1FFF => "PERSIST_COMM",
        _ => "RAM",
    }
}

fn identifier(name: &str) -> String {
    let name = word(name);
    let taken = TAKEN.split_ascii_whitespace().any(|taken| taken.eq_ignore_ascii_case(&name));
    if taken || BEGINS.iter().any(|begin| name.starts_with(begin)) { format!("{name}_") } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_identifiers() {
        assert_eq!(identifier("PERSIST_APP"), "PERSIST_APP");
        assert_eq!(identifier(" my group\u{e9}"), "my_groupe");
        assert_eq!(identifier("size"), "size_");
        assert_eq!(identifier("ENTRY_H1000"), "ENTRY_H1000_");
        assert_eq!(by_index(0x1003), "RAM");
        assert_eq!(by_index(0x1400), "PERSIST_COMM");
        assert_eq!(by_index(0x2000), "RAM");
        assert_eq!([by_index(0x1F51), by_index(0x1F80)], ["RAM", "PERSIST_COMM"]);
    }
}
