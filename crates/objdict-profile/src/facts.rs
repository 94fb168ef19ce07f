//! Definitions of objects and entries in a document.
//!
//! They are views of rows in `tables`, so a check touches only the rows that it uses.

use std::ops::RangeInclusive;

use super::condition::Condition;
use super::need::{Confidence, Mapping, Need};
use super::tables::{BitRow, EntryRow, MeaningRow, NeedRow, ObjectRow, Tables};
use crate::model::{Access, DataType, Device, ObjectType, Value};

/// The definition of an object, or of a range of similar ones.
#[derive(Clone, Copy, Debug)]
pub struct ObjectFacts<'a> {
    /// First index.
    pub first: u16,
    /// Last index; equal to `first` for a single object.
    pub last: u16,
    /// Name in the document.
    pub name: &'a str,
    /// The object type, followed by alternatives that real devices use and that do no harm; empty if any is
    /// allowed.
    pub object_types: &'a [ObjectType],
    /// Whether the object is mandatory.
    pub need: Need<'a>,
    /// The condition under which the object is meaningful; `None`: always.
    pub only: Option<&'a Condition>,
    /// Objects with the same number of elements; the first existing one applies. Empty if the
    /// document does not state any.
    pub as_many_as: &'a [u16],
    /// The section of the document, or another source.
    pub source: Option<&'a str>,
    /// Its purpose in one original English sentence.
    pub about: Option<&'a str>,
    /// The reliability of the source: a requirement of medium confidence never leads to an error.
    pub confidence: Confidence,
    entries: &'a [EntryRow],
    tables: &'a Tables,
}

/// The definition of a sub-index, or of a range of similar ones.
#[derive(Clone, Copy, Debug)]
pub struct EntryFacts<'a> {
    /// First sub-index.
    pub first: u8,
    /// Last sub-index; equal to `first` for a single entry.
    pub last: u8,
    /// Name in the document; empty for the value of a VAR.
    pub name: &'a str,
    /// The data type, followed by alternatives from other editions; empty if any is allowed.
    pub data_types: &'a [DataType],
    /// The access type, followed by alternatives from other editions; empty if any is allowed. See
    /// [`EntryFacts::accepts_access`].
    pub access: &'a [Access],
    /// Whether the entry is mandatory if the object exists.
    pub need: Need<'a>,
    /// The PDOs that may map it; `None` if not stated.
    pub mapping: Option<Mapping>,
    /// The allowed values; empty for all values of the data type.
    pub values: &'a [RangeInclusive<i128>],
    /// The default value as delivered by the vendor.
    pub default: Option<&'a Value>,
    /// The unit of its value, such as `ms`; `None` if there is none or the device chooses it.
    pub unit: Option<&'a str>,
    bits: &'a [BitRow],
    tables: &'a Tables,
}

/// A bit field of a value.
#[derive(Clone, Copy, Debug)]
pub struct BitFieldFacts<'a> {
    /// Lowest bit, counted from 0.
    pub first: u8,
    /// Highest bit.
    pub last: u8,
    /// Its name.
    pub name: &'a str,
    meanings: &'a [MeaningRow],
    texts: &'a str,
}

impl<'a> Need<'a> {
    fn of(row: NeedRow, tables: &'a Tables) -> Self {
        match row {
            NeedRow::Optional => Self::Optional,
            NeedRow::Mandatory => Self::Mandatory,
            NeedRow::When(at) => tables.conditions.get(at as usize).map_or(Self::Optional, Self::When),
        }
    }

    /// Whether the object or entry is certainly mandatory for a logical device; see [`Condition::holds`].
    pub fn is_there(&self, device: &Device, block: u8) -> bool {
        match self {
            Self::Optional => false,
            Self::Mandatory => true,
            Self::When(condition) => condition.holds(device, block) == Some(true),
        }
    }
}

impl<'a> ObjectFacts<'a> {
    pub(super) fn of(row: &ObjectRow, tables: &'a Tables) -> Self {
        Self {
            first: row.first,
            last: row.last,
            name: row.name.of_text(&tables.texts),
            object_types: row.object_types.of(&tables.object_types),
            need: Need::of(row.need, tables),
            only: row.only.and_then(|at| tables.conditions.get(at as usize)),
            as_many_as: row.as_many_as.of(&tables.indexes),
            source: tables.stated(row.source),
            about: tables.stated(row.about),
            confidence: row.confidence,
            entries: row.entries.of(&tables.entries),
            tables,
        }
    }

    /// Whether the object certainly applies to a logical device, and not only to others; see
    /// [`Condition::holds`].
    pub fn is_for(&self, device: &Device, block: u8) -> bool {
        self.only.is_none_or(|only| only.holds(device, block) == Some(true))
    }

    /// Whether the object is mandatory for a logical device.
    pub fn is_demanded(&self, device: &Device, block: u8) -> bool {
        self.need.is_there(device, block) && self.is_for(device, block)
    }

    /// The object type in the document; VAR if it is not stated.
    pub fn object_type(&self) -> ObjectType {
        self.object_types.first().copied().unwrap_or(ObjectType::Var)
    }

    /// Whether the document states the object type.
    pub fn states_type(&self) -> bool {
        !self.object_types.is_empty()
    }

    /// The allowed sub-indexes in ascending order; 0 for the value of a VAR. Empty if the document does not
    /// define any.
    pub fn entries(&self) -> impl ExactSizeIterator<Item = EntryFacts<'a>> + use<'a> {
        let tables = self.tables;
        self.entries.iter().map(move |row| EntryFacts::of(row, tables))
    }

    /// The definition of a sub-index; `None` if the object does not have it.
    pub fn entry(&self, sub: u8) -> Option<EntryFacts<'a>> {
        let at = self.entries.partition_point(|entry| entry.last < sub);
        let row = self.entries.get(at).filter(|entry| entry.first <= sub);
        row.map(|row| EntryFacts::of(row, self.tables))
    }

    /// The highest allowed sub-index.
    pub fn highest_sub(&self) -> u8 {
        self.entries.last().map_or(0, |entry| entry.last)
    }
}

impl<'a> EntryFacts<'a> {
    fn of(row: &EntryRow, tables: &'a Tables) -> Self {
        Self {
            first: row.first,
            last: row.last,
            name: row.name.of_text(&tables.texts),
            data_types: row.data_types.of(&tables.data_types),
            access: row.access.of(&tables.access),
            need: Need::of(row.need, tables),
            mapping: row.mapping,
            values: row.values.of(&tables.values),
            default: row.default.and_then(|at| tables.defaults.get(at as usize)),
            unit: tables.stated(row.unit),
            bits: row.bits.of(&tables.bits),
            tables,
        }
    }

    /// The bit fields.
    pub fn bits(&self) -> impl ExactSizeIterator<Item = BitFieldFacts<'a>> + use<'a> {
        let tables = self.tables;
        self.bits.iter().map(move |row| BitFieldFacts {
            first: row.first,
            last: row.last,
            name: row.name.of_text(&tables.texts),
            meanings: row.values.of(&tables.meanings),
            texts: &tables.texts,
        })
    }

    /// Whether an entry may have this data type.
    pub fn accepts_type(&self, data_type: DataType) -> bool {
        self.data_types.is_empty() || self.data_types.contains(&data_type)
    }

    /// Whether an entry may have this access type. `ro` and `const` are interchangeable, because editions
    /// of CiA 301 swap them; `rwr` and `rww` are more specific than `rw`.
    pub fn accepts_access(&self, access: Access) -> bool {
        let stands_for = |allowed: Access| match allowed {
            Access::Ro | Access::Const => matches!(access, Access::Ro | Access::Const),
            Access::Rw => matches!(access, Access::Rw | Access::Rwr | Access::Rww),
            _ => access == allowed,
        };
        self.access.is_empty() || self.access.iter().any(|&allowed| stands_for(allowed))
    }

    /// Whether an entry may have this value.
    pub fn accepts_value(&self, value: i128) -> bool {
        self.values.is_empty() || self.values.iter().any(|range| range.contains(&value))
    }

    /// Whether PDOs may map it, as far as the document states it.
    pub fn is_mappable(&self) -> bool {
        self.mapping.is_some_and(|mapping| mapping != Mapping::No)
    }

    /// Whether the entry is mandatory if the object exists.
    pub fn is_mandatory(&self) -> bool {
        self.need == Need::Mandatory
    }
}

impl<'a> BitFieldFacts<'a> {
    /// The value of its bits in `value`.
    pub fn of(&self, value: u64) -> u64 {
        let width = u32::from(self.last.saturating_sub(self.first)) + 1;
        let mask = u64::MAX.checked_shr(64u32.saturating_sub(width)).unwrap_or(0);
        value.checked_shr(self.first.into()).unwrap_or(0) & mask
    }

    /// The meanings of its values.
    pub fn meanings(&self) -> impl ExactSizeIterator<Item = (RangeInclusive<u64>, &'a str)> + use<'a> {
        let texts = self.texts;
        self.meanings.iter().map(move |row| (row.first..=row.last, row.text.of_text(texts)))
    }

    /// The meaning of its bits in a value, if the document defines it.
    pub fn meaning(&self, value: u64) -> Option<&'a str> {
        let part = self.of(value);
        self.meanings().find(|(range, _)| range.contains(&part)).map(|(_, meaning)| meaning)
    }
}
