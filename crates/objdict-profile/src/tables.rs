//! How a profile is stored: rows that name what belongs to them by its position. So the tables of the documents that come
//! with the program are plain data without pointers, of which a check touches what it looks at; custom ones are made
//! when its TOML is read.

use std::borrow::Cow;
use std::ops::RangeInclusive;

pub use super::condition::Term;
use super::{Condition, Mapping};
use crate::model::{Access, DataType, ObjectType, Value};

/// So many items of a list, from a position on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Part(pub u32, pub u32);

/// What a profile says of objects.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tables {
    /// The objects, in ascending order of their indexes.
    pub objects: Cow<'static, [ObjectRow]>,
    /// The entries of objects. Objects with the same entries share them, and so do all lists here.
    pub entries: Cow<'static, [EntryRow]>,
    /// The bits of entries.
    pub bits: Cow<'static, [BitRow]>,
    /// The meanings of bits.
    pub meanings: Cow<'static, [MeaningRow]>,
    /// Conditions of needs.
    pub conditions: Cow<'static, [Condition]>,
    /// Object types of objects.
    pub object_types: Cow<'static, [ObjectType]>,
    /// Data types of entries.
    pub data_types: Cow<'static, [DataType]>,
    /// Access types of entries.
    pub access: Cow<'static, [Access]>,
    /// Values of entries.
    pub values: Cow<'static, [RangeInclusive<i128>]>,
    /// Defaults of entries.
    pub defaults: Cow<'static, [Value]>,
    /// Indexes of objects.
    pub indexes: Cow<'static, [u16]>,
    /// All names, one behind the other.
    pub texts: Cow<'static, str>,
}

/// An object, or a range of alike ones; see [`ObjectFacts`](super::ObjectFacts).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectRow {
    /// First index.
    pub first: u16,
    /// Last index.
    pub last: u16,
    /// In the texts.
    pub name: Part,
    /// In the object types.
    pub object_types: Part,
    /// Whether it has to be there.
    pub need: NeedRow,
    /// The position of a condition.
    pub only: Option<u32>,
    /// In the indexes.
    pub as_many_as: Part,
    /// In the entries.
    pub entries: Part,
    /// In the texts; empty where nothing is said.
    pub source: Part,
    /// In the texts; empty where nothing is said.
    pub about: Part,
}

/// An entry, or a range of alike ones; see [`EntryFacts`](super::EntryFacts).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EntryRow {
    /// First sub-index.
    pub first: u8,
    /// Last sub-index.
    pub last: u8,
    /// Which PDOs may carry it.
    pub mapping: Option<Mapping>,
    /// Whether it has to be there.
    pub need: NeedRow,
    /// In the texts.
    pub name: Part,
    /// In the data types.
    pub data_types: Part,
    /// In the access types.
    pub access: Part,
    /// In the values.
    pub values: Part,
    /// The position of a default.
    pub default: Option<u32>,
    /// In the texts; empty where the value has none.
    pub unit: Part,
    /// In the bits.
    pub bits: Part,
}

/// Whether something has to be there; see [`Need`](super::Need).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NeedRow {
    /// It may be there.
    Optional,
    /// It has to be.
    Mandatory,
    /// It has to be when the condition at this position holds.
    When(u32),
}

/// A group of bits; see [`BitField`](super::BitField).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BitRow {
    /// Lowest bit.
    pub first: u8,
    /// Highest bit.
    pub last: u8,
    /// In the texts.
    pub name: Part,
    /// In the meanings.
    pub values: Part,
}

/// What some values of bits mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MeaningRow {
    /// First value.
    pub first: u64,
    /// Last value.
    pub last: u64,
    /// In the texts.
    pub text: Part,
}

impl Tables {
    /// A text that may be missing.
    pub(super) fn stated(&self, text: Part) -> Option<&str> {
        Some(text.of_text(&self.texts)).filter(|text| !text.is_empty())
    }
}

impl Part {
    /// The items of a list; none where it is shorter.
    pub fn of<T>(self, list: &[T]) -> &[T] {
        let from = list.get(self.0 as usize..);
        from.and_then(|items| items.get(..self.1 as usize)).unwrap_or_default()
    }

    /// The part of a text; empty where that is shorter.
    pub fn of_text(self, text: &str) -> &str {
        let from = text.get(self.0 as usize..);
        from.and_then(|text| text.get(..self.1 as usize)).unwrap_or_default()
    }
}
