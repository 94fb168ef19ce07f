//! Storage groups of the flat table: values stored together, in a separate struct and as an image.
//!
//! Only groups in the description or requested by the user are included; all other values remain in the
//! struct of values. An image consists of the layout (a hash, four bytes), the values and a CRC-16, all
//! little-endian; see docs/reference/generate.md.

use std::collections::BTreeMap;

use super::dictionary::{ResolvedObject, TableDictionary};
use super::names::{NameScope, clip, words};
use super::notes::in_order;
use super::resolve::ValueShape;
use super::table::{DeviceTable, Row, TableGroup};
use super::{Note, Options};
use crate::model::{Device, Place};

/// CANopenNode names of groups that are lost without power.
const VOLATILE: [&str; 2] = ["RAM", "ROM"];

/// Maximum length of a group name; leaves room for the longest prefix and suffix in an identifier.
const LONGEST: usize = 24;

/// Names whose `od_<name>_t`, `od_<name>_save` etc. have a different meaning.
const TAKEN: &str = "bool byte data double entry float image is kept offset time";

/// The object that stores groups on command.
const STORE: u16 = 0x1010;

/// The group of each object.
pub(super) struct Members {
    of_objects: BTreeMap<u16, usize>,
    notes: Vec<Note>,
}

impl Members {
    /// Groups claim names before fields do, so that new objects do not change group names.
    pub(super) fn new(
        dictionary: &TableDictionary<'_>,
        options: &Options,
        fields: &mut NameScope,
        groups: &mut Vec<TableGroup>,
    ) -> Self {
        let mut members = Self { of_objects: BTreeMap::new(), notes: Vec::new() };
        for object in &dictionary.objects {
            let Some(name) = group_of(object, options) else { continue };
            let changes = |entry: &super::dictionary::ResolvedEntry<'_>| {
                !entry.resolved.constant && entry.resolved.shape.size() > 0
            };
            if object.entries.iter().any(changes) {
                let group = group_named(name, object.index, fields, groups);
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

    /// The group of an object.
    pub(super) fn group(&self, index: u16) -> Option<usize> {
        self.of_objects.get(&index).copied()
    }

    /// Adds the groups to a table with complete rows.
    pub(super) fn finish(mut self, device: &Device, table: &mut DeviceTable) {
        let mut groups = std::mem::take(&mut table.groups);
        for (number, group) in groups.iter_mut().enumerate() {
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
        table.groups = groups;
        if !self.notes.is_empty() {
            table.notes.append(&mut self.notes);
            table.notes = in_order(std::mem::take(&mut table.notes));
        }
    }
}

/// The number of a group, which is added if it is new.
fn group_named(name: &str, first: u16, fields: &mut NameScope, groups: &mut Vec<TableGroup>) -> usize {
    if let Some(group) = groups.iter().position(|group| group.name == name) {
        return group;
    }
    let field = fields.claim(&identifier(name), format_args!("{first:04x}"));
    groups.push(TableGroup { name: name.to_owned(), field, sub_index: None, layout: 0, image_size: 0 });
    groups.len() - 1
}

/// The group stated for an object, otherwise the requested one; `None` if it is lost without power.
pub(crate) fn group_of<'a>(object: &'a ResolvedObject<'_>, options: &'a Options) -> Option<&'a str> {
    let stated = object.object.main.stack.as_ref().and_then(|stack| stack.storage_group.as_deref());
    let stated = stated.map(str::trim).filter(|name| !name.is_empty());
    let name = stated.or_else(|| options.group_of(object.index))?;
    (!VOLATILE.iter().any(|volatile| volatile.eq_ignore_ascii_case(name))).then_some(name)
}

/// The identifier of a group; must differ from functions of PDOs.
fn identifier(name: &str) -> String {
    let words = words(name);
    let words = clip(&words, LONGEST);
    let number = words.strip_prefix("rpdo").or_else(|| words.strip_prefix("tpdo"));
    let is_pdo = number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()));
    match words {
        "" => "group".to_owned(),
        words if is_pdo || TAKEN.split(' ').any(|taken| taken == words) => format!("{words}_group"),
        words => words.to_owned(),
    }
}

/// Size of a value in an image, in bytes: a string uses its full capacity, preceded by its length.
pub(crate) fn image_length(shape: ValueShape) -> usize {
    match shape {
        ValueShape::Word(_) | ValueShape::Block(_) => shape.size(),
        ValueShape::Bytes(..) => 2 + shape.size(),
    }
}

/// FNV-1a hash of the image contents; never 0 and never all ones, the values of erased memory.
fn layout(rows: &[&Row]) -> u32 {
    let bytes = rows.iter().flat_map(|row| {
        let data_type = match row.resolved.shape {
            ValueShape::Word(data_type) | ValueShape::Bytes(data_type, _) => data_type.0.to_le_bytes()[0], // standard types: one byte
            ValueShape::Block(_) => 0,
        };
        let [low, high] = row.index.to_le_bytes();
        let size = u16::try_from(row.resolved.shape.size()).unwrap_or(u16::MAX).to_le_bytes();
        [low, high, row.sub, data_type, size[0], size[1]]
    });
    let hash = bytes.fold(0x811C_9DC5_u32, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193));
    if hash == 0 || hash == u32::MAX { 1 } else { hash }
}

/// CiA 301 §7.5.2.13: sub-index 2 stores the communication parameters, 3 the application parameters; the
/// others are manufacturer-specific.
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

/// Whether a value identifies the firmware.
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
            ("a group whose name is very long", "a_group_whose_name_is"),
        ] {
            assert_eq!(identifier(name), expected);
        }
    }
}
