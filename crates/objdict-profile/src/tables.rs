//! Storage of profiles: rows refer to their lists by position. So the tables of built-in documents are plain
//! data without pointers, and a check touches only the parts that it uses; tables of custom profiles are
//! built when their TOML is read.

use std::borrow::Cow;
use std::ops::RangeInclusive;

use super::condition::Condition;
pub use super::condition::Term;
use super::need::{Confidence, Mapping};
use crate::model::{Access, DataType, ObjectType, Value};

/// A sub-list: position and number of items.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct SubList(pub u32, pub u32);

/// The object definitions of a profile.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tables {
    /// The objects, in ascending order of their indexes.
    pub objects: Cow<'static, [ObjectRow]>,
    /// The entries of objects. Objects with the same entries share them; so do all lists below.
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
    /// In the meanings: the EMCY error codes.
    pub errors: SubList,
    /// The objects of the state machine.
    pub machine: Option<MachineRow>,
    /// The commands of the state machine.
    pub commands: Cow<'static, [CommandRow]>,
    /// The transitions of the state machine.
    pub transitions: Cow<'static, [TransitionRow]>,
    /// All texts, concatenated.
    pub texts: Cow<'static, str>,
}

/// A table of rows: the field names precede all rows, and each row lists its values in this order.
macro_rules! table {
    ($row:ident $fields:tt: $($values:tt)*) => { &[$($crate::tables::table!(@row $row $fields $values)),*] };
    (@row $row:ident { $($field:ident),* } ($($value:expr),*)) => { $row { $($field: $value),* } };
}
pub(crate) use table;

/// An object, or a range of similar ones; see [`ObjectFacts`](super::ObjectFacts).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectRow {
    /// First index.
    pub first: u16,
    /// Last index.
    pub last: u16,
    /// In the texts.
    pub name: SubList,
    /// In the object types.
    pub object_types: SubList,
    /// Whether it is mandatory.
    pub need: NeedRow,
    /// The position of a condition.
    pub only: Option<u32>,
    /// In the indexes.
    pub as_many_as: SubList,
    /// In the entries.
    pub entries: SubList,
    /// In the texts; empty if not stated.
    pub source: SubList,
    /// In the texts; empty if not stated.
    pub about: SubList,
    /// The reliability of the source.
    pub confidence: Confidence,
}

/// An entry, or a range of similar ones; see [`EntryFacts`](super::EntryFacts).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EntryRow {
    /// First sub-index.
    pub first: u8,
    /// Last sub-index.
    pub last: u8,
    /// The PDOs that may map it.
    pub mapping: Option<Mapping>,
    /// Whether it is mandatory.
    pub need: NeedRow,
    /// In the texts.
    pub name: SubList,
    /// In the data types.
    pub data_types: SubList,
    /// In the access types.
    pub access: SubList,
    /// In the values.
    pub values: SubList,
    /// The position of a default.
    pub default: Option<u32>,
    /// In the texts; empty if there is none.
    pub unit: SubList,
    /// In the bits.
    pub bits: SubList,
}

/// Whether an object or entry is mandatory; see [`Need`](super::Need).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NeedRow {
    /// Optional.
    Optional,
    /// Mandatory.
    Mandatory,
    /// Mandatory under the condition at this position.
    When(u32),
}

/// A bit field; see [`BitFieldFacts`](super::BitFieldFacts).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BitRow {
    /// Lowest bit.
    pub first: u8,
    /// Highest bit.
    pub last: u8,
    /// In the texts.
    pub name: SubList,
    /// In the meanings.
    pub values: SubList,
}

/// The meaning of some values of a bit field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MeaningRow {
    /// First value.
    pub first: u64,
    /// Last value.
    pub last: u64,
    /// In the texts.
    pub text: SubList,
}

/// The objects of a state machine; see [`StateMachine`](super::StateMachine).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MachineRow {
    /// The index of the object whose lowest bit field is the state.
    pub status: u16,
    /// The index of the object that receives commands.
    pub command: u16,
}

/// A command of a state machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CommandRow {
    /// In the texts.
    pub name: SubList,
    /// In the texts: the bits of the command.
    pub mask: SubList,
}

/// A transition of a state machine; the texts are [`Transition`](super::Transition)'s.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TransitionRow {
    /// The number in the document.
    pub number: u8,
    /// In the texts.
    pub from: SubList,
    /// In the texts.
    pub to: SubList,
    /// In the texts.
    pub by: SubList,
}

impl Tables {
    /// An optional text.
    pub(super) fn stated(&self, text: SubList) -> Option<&str> {
        Some(text.of_text(&self.texts)).filter(|text| !text.is_empty())
    }
}

impl SubList {
    /// The items of a list; empty if they are out of bounds.
    pub fn of<T>(self, list: &[T]) -> &[T] {
        let from = list.get(self.0 as usize..);
        from.and_then(|items| items.get(..self.1 as usize)).unwrap_or_default()
    }

    /// The section of a text; empty if it is out of bounds.
    pub fn of_text(self, text: &str) -> &str {
        let from = text.get(self.0 as usize..);
        from.and_then(|text| text.get(..self.1 as usize)).unwrap_or_default()
    }
}
