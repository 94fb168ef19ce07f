//! Packing of tables: concatenated lists without duplicates.

use std::collections::HashMap;
use std::hash::Hash;
use std::ops::RangeInclusive;

use super::fields::NeedText;
use crate::Condition;
use crate::model::{Access, DataType, ObjectType, Value};
use crate::tables::{BitRow, EntryRow, MeaningRow, NeedRow, SubList, Tables};

/// Concatenated lists of one type.
pub(super) struct Lists<T> {
    items: Vec<T>,
    known: HashMap<Box<[T]>, SubList>,
}

impl<T> Default for Lists<T> {
    fn default() -> Self {
        Self { items: Vec::new(), known: HashMap::new() }
    }
}

impl<T: Clone + Eq + Hash> Lists<T> {
    /// The position of a list; appends it if necessary.
    pub(super) fn part(&mut self, list: &[T]) -> SubList {
        if list.is_empty() {
            return SubList::default();
        }
        if let Some(part) = self.known.get(list) {
            return *part;
        }
        let part = SubList(number(self.items.len()), number(list.len()));
        self.items.extend_from_slice(list);
        self.known.insert(list.into(), part);
        part
    }
}

/// A table position or count; a text cannot contain more.
fn number(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}

/// The position of an item, which is appended if new.
fn position<T>(items: &mut Vec<T>, known: &mut HashMap<String, u32>, key: String, item: T) -> u32 {
    *known.entry(key).or_insert_with(|| {
        items.push(item);
        number(items.len() - 1)
    })
}

/// Tables under construction.
#[derive(Default)]
pub(super) struct Packer {
    pub(super) entries: Lists<EntryRow>,
    pub(super) bits: Lists<BitRow>,
    meanings: Lists<MeaningRow>,
    pub(super) object_types: Lists<ObjectType>,
    pub(super) data_types: Lists<DataType>,
    pub(super) access: Lists<Access>,
    pub(super) values: Lists<RangeInclusive<i128>>,
    pub(super) indexes: Lists<u16>,
    texts: String,
    known_texts: HashMap<String, SubList>,
    conditions: Vec<Condition>,
    known_conditions: HashMap<String, u32>,
    defaults: Vec<Value>,
    known_defaults: HashMap<String, u32>,
}

impl Packer {
    /// The packed tables.
    pub(super) fn tables(self) -> Tables {
        Tables {
            entries: self.entries.items.into(),
            bits: self.bits.items.into(),
            meanings: self.meanings.items.into(),
            conditions: self.conditions.into(),
            object_types: self.object_types.items.into(),
            data_types: self.data_types.items.into(),
            access: self.access.items.into(),
            values: self.values.items.into(),
            defaults: self.defaults.into(),
            indexes: self.indexes.items.into(),
            texts: self.texts.into(),
            ..Tables::default()
        }
    }

    pub(super) fn text(&mut self, text: &str) -> SubList {
        if text.is_empty() {
            return SubList::default();
        }
        if let Some(part) = self.known_texts.get(text) {
            return *part;
        }
        let part = SubList(number(self.texts.len()), number(text.len()));
        self.texts.push_str(text);
        self.known_texts.insert(text.to_owned(), part);
        part
    }

    pub(super) fn condition(&mut self, condition: Condition) -> u32 {
        let key = condition.to_string();
        position(&mut self.conditions, &mut self.known_conditions, key, condition)
    }

    pub(super) fn need(&mut self, need: Option<NeedText>) -> NeedRow {
        match need {
            None | Some(NeedText::Optional) => NeedRow::Optional,
            Some(NeedText::Mandatory) => NeedRow::Mandatory,
            Some(NeedText::When(condition)) => NeedRow::When(self.condition(condition)),
        }
    }

    pub(super) fn default_value(&mut self, value: Value) -> u32 {
        let key = format!("{value:?}");
        position(&mut self.defaults, &mut self.known_defaults, key, value)
    }

    pub(super) fn meanings(&mut self, meanings: &[(RangeInclusive<u64>, String)]) -> SubList {
        let row = |(range, text): &(RangeInclusive<u64>, String)| MeaningRow {
            first: *range.start(),
            last: *range.end(),
            text: self.text(text),
        };
        let rows: Vec<MeaningRow> = meanings.iter().map(row).collect();
        self.meanings.part(&rows)
    }
}
