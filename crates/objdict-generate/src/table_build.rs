//! Builds the flat table of a device, and its data in flash without duplicates.

use std::collections::{BTreeSet, HashMap};
use std::ops::Bound::{Included, Unbounded};

use super::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use super::head::Head;
use super::names::{NameScope, words};
use super::resolve::{Encoded, EntryPlan};
use super::stored::Members;
use super::table::{DeviceTable, Row, TableField, TableObject, ValuePlace};
use super::variables::elements;
use super::{GenerateError, Options, hooks};
use crate::model::{Address, Device, Object};

impl DeviceTable {
    /// The table of a device.
    pub(crate) fn new(device: &Device, options: &Options) -> Result<Self, GenerateError> {
        let mut builder = TableBuilder::new(device, options)?;
        builder.place_fields(device, options);
        builder.name_fields();
        builder.place_blocks();
        let TableBuilder { mut table, members, .. } = builder;
        members.finish(device, &mut table);
        hooks::mark(device, options, &mut table);
        Ok(table)
    }

    /// The objects, rows and groups of a table with their names, without memory for values.
    pub(crate) fn of_names(device: &Device, options: &Options) -> Result<Self, GenerateError> {
        Ok(TableBuilder::new(device, options)?.table)
    }

    fn empty(dictionary: &TableDictionary<'_>, options: &Options) -> Self {
        Self {
            head: Head::new(dictionary.device, options, "", ""),
            node_id: dictionary.node_id,
            objects: Vec::new(),
            rows: Vec::new(),
            fields: Vec::new(),
            groups: Vec::new(),
            rom: Vec::new(),
            notes: Vec::new(),
        }
    }
}

/// Items of the templates that do not belong to objects.
const ITEMS: &str = "
    od pdo defaults enums bits serde defmt groups table data_types communication manufacturer profile interface
    entries node_id max_size shared
";

struct TableBuilder {
    fields: NameScope,
    members: Members,
    table: DeviceTable,
}

impl TableBuilder {
    /// Everything with a name except the fields.
    fn new(device: &Device, options: &Options) -> Result<Self, GenerateError> {
        let mut dictionary = TableDictionary::new(device, options)?;
        let mut fields = NameScope::of_lower_case("node_id");
        let mut table = DeviceTable::empty(&dictionary, options);
        let members = Members::new(&dictionary, options, &mut fields, &mut table.groups);
        let objects = std::mem::take(&mut dictionary.objects);
        table.notes = dictionary.notes;
        let mut builder = Self { fields, members, table };
        let mut constants = NameScope::of_constants("");
        objects.into_iter().for_each(|object| builder.object(object, &mut constants));
        builder.name_objects();
        Ok(builder)
    }

    fn object(&mut self, resolved: ResolvedObject<'_>, constants: &mut NameScope) {
        let (index, single) = (resolved.index, resolved.is_single());
        let (name, module) = (resolved.object.name().to_owned(), module(index, &resolved.name));
        let first = self.table.rows.len();
        constants.reset("index");
        let names: Vec<String> = resolved.entries.iter().map(|entry| words(&entry.name)).collect();
        constants.foresee(names.iter().map(String::as_str));
        for (ResolvedEntry { sub, entry, resolved, .. }, words) in resolved.entries.into_iter().zip(&names) {
            let constant = constants.claim(words, format_args!("{sub:02x}"));
            let name = entry.name.to_string();
            let hooked = false;
            let row = Row { index, sub, name, constant, resolved, slot: None, rom: 0, rom_length: 0, hooked };
            self.table.rows.push(row);
        }
        let rows = first..self.table.rows.len();
        self.table.objects.push(TableObject { index, name, module, single, rows });
    }

    /// Makes the names of objects unique.
    fn name_objects(&mut self) {
        let objects = &mut self.table.objects;
        let mut modules = NameScope::of_lower_case(ITEMS);
        modules.foresee(objects.iter().map(|object| object.module.as_str()));
        for TableObject { index, module, .. } in objects {
            *module = modules.claim(module, format_args!("{index:04x}"));
        }
    }

    fn place_fields(&mut self, device: &Device, options: &Options) {
        for number in 0..self.table.objects.len() {
            let TableObject { index, ref rows, .. } = self.table.objects[number];
            let (rows, first) = (rows.clone(), self.table.fields.len());
            let object = &device.objects[&index];
            let name = module(index, &options.name_of(Address { index, sub: None }, object.name()));
            self.place_fields_of(object, &name, rows);
            let group = self.members.group(index);
            self.table.fields[first..].iter_mut().for_each(|field| field.group = group);
        }
    }

    /// Makes the names of fields unique.
    fn name_fields(&mut self) {
        let DeviceTable { fields, rows, .. } = &mut self.table;
        self.fields.foresee(fields.iter().map(|field| field.name.as_str()));
        for TableField { name, rows: of_field, is_object, .. } in fields {
            let Row { index, sub, .. } = rows[of_field.start];
            *name = match *is_object {
                true => self.fields.claim(name, format_args!("{index:04x}")),
                false => self.fields.claim(name, format_args!("{index:04x}_{sub:02x}")),
            };
        }
    }

    fn place_blocks(&mut self) {
        let blocks: Vec<Vec<u8>> = self.table.rows.iter().map(|row| block(&row.resolved)).collect();
        let (rom, offsets) = pack(blocks.iter().map(Vec::as_slice));
        for (row, block) in self.table.rows.iter_mut().zip(&blocks) {
            (row.rom, row.rom_length) = (offsets[block.as_slice()], block.len());
        }
        self.table.rom = rom;
    }

    /// Assigns fields to the writable entries of an object.
    fn place_fields_of(&mut self, object: &Object, name: &str, rows: std::ops::Range<usize>) {
        let elements = self.elements(object, rows.clone());
        for at in rows.start..elements.start {
            self.place_field(object, name, at..at + 1, false);
        }
        if !elements.is_empty() {
            self.place_field(object, name, elements.clone(), true);
        }
        for at in elements.end..rows.end {
            self.place_field(object, name, at..at + 1, false);
        }
    }

    /// The rows that form an array: not constant, and of equal shape.
    fn elements(&self, object: &Object, rows: std::ops::Range<usize>) -> std::ops::Range<usize> {
        let of_object = &self.table.rows[rows.clone()];
        let subs: Vec<u8> = of_object.iter().map(|row| row.sub).collect();
        let kind = |at: usize| {
            let resolved = &of_object[at].resolved;
            (!resolved.constant && resolved.shape.size() > 0).then_some(resolved.shape)
        };
        let elements = elements(object, &subs, kind);
        rows.start + elements.start..rows.start + elements.end
    }

    fn place_field(&mut self, object: &Object, name: &str, rows: std::ops::Range<usize>, array: bool) {
        let row = &self.table.rows[rows.start];
        let shape = row.resolved.shape;
        if row.resolved.constant || shape.size() == 0 {
            return; // in flash, or a DOMAIN without capacity
        }
        let is_object = array || !(object.object_type().has_subs() || object.compact.is_some());
        let name = if is_object { name.to_owned() } else { [name, "_", &row.constant].concat() };
        let field = self.table.fields.len();
        for (element, at) in rows.clone().enumerate() {
            self.table.rows[at].slot = Some(ValuePlace { field, element: array.then_some(element) });
        }
        self.table.fields.push(TableField { name, is_object, shape, rows, array, group: None });
    }
}

/// The words of the name of an object, or its index.
fn module(index: u16, name: &str) -> String {
    let words = words(name);
    if words.is_empty() { format!("x{index:04x}") } else { words }
}

/// The data of an entry in flash.
fn block(resolved: &EntryPlan) -> Vec<u8> {
    let size = resolved.shape.size();
    match &resolved.default {
        Encoded::Bytes(bytes) => {
            let numbers = [size, bytes.len()].map(|number| u16::try_from(number).unwrap_or(u16::MAX)); // checked before
            numbers.iter().flat_map(|number| number.to_le_bytes()).chain(bytes.iter().copied()).collect()
        }
        default => [Some(default), resolved.low.as_ref(), resolved.high.as_ref()]
            .into_iter()
            .flatten()
            .flat_map(|datum| match datum {
                Encoded::Word(word) | Encoded::Formula(word) => word.to_le_bytes().into_iter().take(size),
                Encoded::Bytes(_) => [0; 8].into_iter().take(0), // bytes have other shapes
            })
            .collect(),
    }
}

/// Length of the start that is searched for any position of a block; beyond it blocks overlap only with the
/// previous one. This keeps the run time linear.
const SEARCHED: usize = 2048;

/// The longest overlap of two blocks: a number of eight bytes with two limits.
const OVERLAP: usize = 24;

/// All bytes of these blocks, and the offset of each. Blocks share bytes where possible: each block is followed
/// by the one with the largest overlap, otherwise by the longest. At least one byte, because C has no empty
/// arrays.
pub(crate) fn pack<'a>(blocks: impl IntoIterator<Item = &'a [u8]>) -> (Vec<u8>, HashMap<&'a [u8], usize>) {
    let mut left: BTreeSet<&[u8]> = blocks.into_iter().collect();
    let mut longest_first: Vec<&[u8]> = left.iter().copied().collect();
    longest_first.sort_by_key(|block| block.len()); // popped from the end
    let mut offsets = HashMap::with_capacity(left.len());
    let mut bytes = Vec::new();
    while let Some((block, shared)) = continuing(&left, &bytes).or_else(|| Some((longest_first.pop()?, 0))) {
        if !left.remove(block) {
            continue;
        }
        let searched = &bytes[..bytes.len().min(SEARCHED)];
        let offset = memchr::memmem::find(searched, block).unwrap_or_else(|| {
            let offset = bytes.len() - shared;
            bytes.extend_from_slice(&block[shared..]);
            offset
        });
        offsets.insert(block, offset);
    }
    if bytes.is_empty() {
        bytes.push(0);
    }
    (bytes, offsets)
}

/// The block that starts with the most of the last bytes, and their number.
fn continuing<'a>(left: &BTreeSet<&'a [u8]>, bytes: &[u8]) -> Option<(&'a [u8], usize)> {
    (1..=bytes.len().min(OVERLAP)).rev().find_map(|shared| {
        let end = &bytes[bytes.len() - shared..];
        let next = left.range::<[u8], _>((Included(end), Unbounded)).next()?;
        next.starts_with(end).then_some((*next, shared))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packed<const N: usize>(blocks: [&[u8]; N]) -> (Vec<u8>, [usize; N]) {
        let (bytes, offsets) = pack(blocks);
        let offsets = blocks.map(|block| offsets[block]);
        for (block, offset) in blocks.iter().zip(offsets) {
            assert_eq!(bytes[offset..][..block.len()], **block);
        }
        (bytes, offsets)
    }

    #[test]
    fn equal_bytes_are_kept_once() {
        let (bytes, offsets) = packed([&[2, 3], &[1, 2, 3, 4], &[9, 9], &[4, 5, 6], &[1, 2, 3, 4]]);
        assert_eq!(bytes, [1, 2, 3, 4, 5, 6, 9, 9]);
        assert_eq!(offsets, [1, 0, 6, 3, 0]);
    }

    #[test]
    fn there_is_always_a_byte() {
        assert_eq!(packed([&[]]), (vec![0], [0]));
        assert_eq!(packed([]), (vec![0], []));
    }
}
