//! Storage groups of the flat table: values that are kept together, in a struct of their own and with an image of it.
//!
//! Only groups that the description states or that the user requested count; what is in none stays in the struct of values.
//! An image is the layout (a hash, four bytes), the values and a CRC-16, all little-endian; docs/generate.md describes it.

use std::collections::BTreeMap;

use super::dictionary::{Dictionary, ResolvedObject};
use super::names::{Scope, words};
use super::notes::in_order;
use super::resolve::Shape;
use super::table::{Row, Table};
use super::{Note, Options};
use crate::model::{Device, Place};

/// Names of CANopenNode for groups that are not kept when the power is off.
const VOLATILE: [&str; 2] = ["RAM", "ROM"];

/// The longest name of a group: with the longest prefix and what stands behind it, it is still an identifier.
const LONGEST: usize = 24;

/// `od_<name>_t`, `od_<name>_save` and the like are something else.
const TAKEN: &str = "bool byte data double entry float image is kept offset time";

/// The object that saves groups on command.
const STORE: u16 = 0x1010;

/// A group of values that are kept together.
#[derive(Debug)]
pub(crate) struct TableGroup {
    /// As it is stated.
    pub(crate) name: String,
    /// Its member of the struct of values: unique there, and no keyword.
    pub(crate) field: String,
    /// The first object that has values in it.
    pub(crate) first: u16,
    /// The sub-index of 1010h and 1011h that is about it, where CiA 301 says which.
    pub(crate) sub_index: Option<u8>,
    /// A hash of index, sub-index, data type and length of its entries.
    pub(crate) layout: u32,
    /// Bytes of an image.
    pub(crate) image_size: usize,
}

/// Which objects are in which group.
pub(super) struct Members {
    groups: Vec<TableGroup>,
    of_objects: BTreeMap<u16, usize>,
    notes: Vec<Note>,
}

impl Members {
    /// Groups get their names before fields do, so that a new object changes none.
    pub(super) fn new(dictionary: &Dictionary<'_>, options: &Options, fields: &mut Scope) -> Self {
        let mut members = Self { groups: Vec::new(), of_objects: BTreeMap::new(), notes: Vec::new() };
        for object in &dictionary.objects {
            let Some(name) = group_of(object, options) else { continue };
            let changes = |entry: &super::dictionary::ResolvedEntry<'_>| {
                !entry.resolved.constant && entry.resolved.shape.size() > 0
            };
            if object.entries.iter().any(changes) {
                let group = members.group_named(name, object.index, fields);
                members.of_objects.insert(object.index, group);
            }
        }
        for group in &options.groups {
            if !dictionary.objects.iter().any(|object| group.objects.contains(&object.index)) {
                let text = format!("the group `{}` contains no object from here on", group.name);
                members.notes.push(Note::new(Place::object(*group.objects.start()), text));
            }
        }
        members
    }

    fn group_named(&mut self, name: &str, first: u16, fields: &mut Scope) -> usize {
        if let Some(group) = self.groups.iter().position(|group| group.name == name) {
            return group;
        }
        let field = fields.claim(&identifier(name), format_args!("{first:04x}"));
        let name = name.to_owned();
        self.groups.push(TableGroup { name, field, first, sub_index: None, layout: 0, image_size: 0 });
        self.groups.len() - 1
    }

    /// The group of an object that has values in one.
    pub(super) fn group(&self, index: u16) -> Option<usize> {
        self.of_objects.get(&index).copied()
    }

    /// Puts the groups into a table that has all its rows.
    pub(super) fn finish(mut self, device: &Device, table: &mut Table) {
        for (number, group) in self.groups.iter_mut().enumerate() {
            let of_group =
                |row: &&Row| row.slot.is_some_and(|slot| table.fields[slot.field].group == Some(number));
            let rows: Vec<&Row> = table.rows.iter().filter(of_group).collect();
            group.layout = layout(&rows);
            group.image_size = rows.iter().map(|row| image_length(row.resolved.shape)).sum::<usize>() + 6;
            group.sub_index = sub_index(device, &rows);
            let mut facts: Vec<u16> = rows.iter().filter(|row| is_fact(row)).map(|row| row.index).collect();
            facts.dedup();
            self.notes.extend(facts.into_iter().map(|index| of_the_firmware(index, &group.name)));
        }
        table.groups = self.groups;
        if !self.notes.is_empty() {
            table.notes.append(&mut self.notes);
            table.notes = in_order(std::mem::take(&mut table.notes));
        }
    }
}

/// The group that is stated for an object, else asked for.
fn group_of<'a>(object: &'a ResolvedObject<'_>, options: &'a Options) -> Option<&'a str> {
    let stated = object.object.main.stack.as_ref().and_then(|stack| stack.storage_group.as_deref());
    let stated = stated.map(str::trim).filter(|name| !name.is_empty());
    let name = stated.or_else(|| options.group_of(object.index))?;
    (!VOLATILE.iter().any(|volatile| volatile.eq_ignore_ascii_case(name))).then_some(name)
}

/// What a group is called in code; PDOs have functions of such names too.
fn identifier(name: &str) -> String {
    let words = words(name);
    let words = words[..words.len().min(LONGEST)].trim_end_matches('_');
    let number = words.strip_prefix("rpdo").or_else(|| words.strip_prefix("tpdo"));
    let is_pdo = number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()));
    match words {
        "" => "group".to_owned(),
        words if is_pdo || TAKEN.split(' ').any(|taken| taken == words) => format!("{words}_group"),
        words => words.to_owned(),
    }
}

/// Bytes of a value in an image: a text has all its room, behind its length.
pub(crate) fn image_length(shape: Shape) -> usize {
    match shape {
        Shape::Word(_) | Shape::Block(_) => shape.size(),
        Shape::Bytes(..) => 2 + shape.size(),
    }
}

/// FNV-1a of what an image holds; never 0 and never all ones, as blank memory is.
fn layout(rows: &[&Row]) -> u32 {
    let bytes = rows.iter().flat_map(|row| {
        let data_type = match row.resolved.shape {
            Shape::Word(data_type) | Shape::Bytes(data_type, _) => data_type.0.to_le_bytes()[0], // standard types: one byte
            Shape::Block(_) => 0,
        };
        let [low, high] = row.index.to_le_bytes();
        let size = u16::try_from(row.resolved.shape.size()).unwrap_or(u16::MAX).to_le_bytes();
        [low, high, row.sub, data_type, size[0], size[1]]
    });
    let hash = bytes.fold(0x811C_9DC5_u32, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193));
    if hash == 0 || hash == u32::MAX { 1 } else { hash }
}

/// CiA 301 §7.5.2.13: sub-index 2 is about the communication parameters, 3 about those of the application; which one
/// of the others is about what, the manufacturer says.
fn sub_index(device: &Device, rows: &[&Row]) -> Option<u8> {
    let within = |first: u16, last: u16| rows.iter().all(|row| (first..=last).contains(&row.index));
    let sub = if within(0x1000, 0x1FFF) {
        2
    } else if within(0x6000, 0x9FFF) {
        3
    } else {
        return None;
    };
    device.objects.get(&STORE).is_some_and(|object| object.has(sub)).then_some(sub)
}

/// Whether a value says what the firmware is.
fn is_fact(row: &Row) -> bool {
    matches!(row.index, 0x1000 | 0x1008..=0x100A | 0x1018) && !row.resolved.access.is_writable()
}

fn of_the_firmware(index: u16, group: &str) -> Note {
    let text = format!(
        "the firmware version is saved with `{group}`: loading an older image restores the older one"
    );
    Note::new(Place::object(index), text).help("make these entries `const` to keep them in flash")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_called_by_words() {
        for (name, expected) in [
            ("PERSIST_COMM", "persist_comm"),
            ("PersistApp", "persist_app"),
            ("tpdo1", "tpdo1_group"),
            ("Data", "data_group"),
            ("速度", "group"),
            ("a group whose name is very long", "a_group_whose_name_is_ve"),
        ] {
            assert_eq!(identifier(name), expected);
        }
    }
}
