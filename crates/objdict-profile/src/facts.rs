//! What a document says of an object and of its entries.

use std::ops::RangeInclusive;

use super::Condition;
use crate::model::{Access, DataType, Device, ObjectType, Value};

/// What a document says of an object, or of a range of alike ones.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectFacts {
    /// First index.
    pub first: u16,
    /// Last index; the first one for a single object.
    pub last: u16,
    /// Name in the document.
    pub name: String,
    /// The object type, then others that real devices have and that do no harm; empty where any may be.
    pub object_types: Vec<ObjectType>,
    /// Whether a device has to have it.
    pub need: Need,
    /// When it makes sense at all; always, without.
    pub only: Option<Condition>,
    /// Objects that it has as many elements as: the first ones of those that are there. Empty where the document does not
    /// say.
    pub as_many_as: Vec<u16>,
    /// The sub-indexes that it may have, in ascending order; 0 for the value of a VAR. Empty where the document says
    /// nothing of them.
    pub entries: Vec<EntryFacts>,
    /// Where the document says so, or who else does.
    pub source: Option<String>,
}

/// What a document says of a sub-index, or of a range of alike ones.
#[derive(Clone, Debug, PartialEq)]
pub struct EntryFacts {
    /// First sub-index.
    pub first: u8,
    /// Last sub-index; the first one for a single entry.
    pub last: u8,
    /// Name in the document; empty for the value of a VAR.
    pub name: String,
    /// The data type, then others that editions know; empty where any may be.
    pub data_types: Vec<DataType>,
    /// The access type, then others that editions allow; empty where any may be. See [`EntryFacts::accepts_access`].
    pub access: Vec<Access>,
    /// Whether the entry is there whenever the object is.
    pub need: Need,
    /// Whether a PDO may carry it; `None` where the document does not say.
    pub mapping: Option<Mapping>,
    /// The values that it may have; empty for all of the data type.
    pub values: Vec<RangeInclusive<i128>>,
    /// The value that it has when the device comes from its maker.
    pub default: Option<Value>,
    /// What its bits mean.
    pub bits: Vec<BitField>,
}

/// Whether something has to be there.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Need {
    /// It may be there.
    #[default]
    Optional,
    /// It has to be.
    Mandatory,
    /// It has to be when something holds.
    When(Condition),
}

/// Which PDOs may carry an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mapping {
    /// None.
    No,
    /// TPDOs.
    Tpdo,
    /// RPDOs.
    Rpdo,
    /// Both.
    Any,
}

/// A group of bits of a value.
#[derive(Clone, Debug, PartialEq)]
pub struct BitField {
    /// Lowest bit, counted from 0.
    pub first: u8,
    /// Highest bit.
    pub last: u8,
    /// What it is.
    pub name: String,
    /// What its values mean.
    pub values: Vec<(RangeInclusive<u64>, String)>,
}

impl Need {
    /// Whether a logical device, see [`Condition::holds`], surely needs what has this need.
    pub fn is_there(&self, device: &Device, block: u8) -> bool {
        match self {
            Self::Optional => false,
            Self::Mandatory => true,
            Self::When(condition) => condition.holds(device, block) == Some(true),
        }
    }
}

impl ObjectFacts {
    /// Whether the object is surely one for a logical device, see [`Condition::holds`], and not only for others.
    pub fn is_for(&self, device: &Device, block: u8) -> bool {
        self.only.as_ref().is_none_or(|only| only.holds(device, block) == Some(true))
    }

    /// Whether a logical device has to have the object.
    pub fn is_demanded(&self, device: &Device, block: u8) -> bool {
        self.need.is_there(device, block) && self.is_for(device, block)
    }

    /// The object type that the document gives it; VAR where it does not say.
    pub fn object_type(&self) -> ObjectType {
        self.object_types.first().copied().unwrap_or(ObjectType::Var)
    }

    /// Whether the document says of what object type it is.
    pub fn states_type(&self) -> bool {
        !self.object_types.is_empty()
    }

    /// What it says of a sub-index; `None` for one that the object does not have.
    pub fn entry(&self, sub: u8) -> Option<&EntryFacts> {
        let at = self.entries.partition_point(|entry| entry.last < sub);
        self.entries.get(at).filter(|entry| entry.first <= sub)
    }

    /// The highest sub-index that it may have.
    pub fn highest_sub(&self) -> u8 {
        self.entries.last().map_or(0, |entry| entry.last)
    }
}

impl EntryFacts {
    /// Whether an entry may have this data type.
    pub fn accepts_type(&self, data_type: DataType) -> bool {
        self.data_types.is_empty() || self.data_types.contains(&data_type)
    }

    /// Whether an entry may have this access type. `ro` and `const` stand for each other, for the editions of CiA 301
    /// exchanged them; `rwr` and `rww` say more than `rw` and are no other access.
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

    /// Whether a PDO may carry it, as far as the document says.
    pub fn is_mappable(&self) -> bool {
        self.mapping.is_some_and(|mapping| mapping != Mapping::No)
    }

    /// Whether the entry is there whenever the object is.
    pub fn is_mandatory(&self) -> bool {
        self.need == Need::Mandatory
    }
}

impl Mapping {
    /// The name in a profile.
    pub const fn name(self) -> &'static str {
        match self {
            Self::No => "no",
            Self::Tpdo => "tpdo",
            Self::Rpdo => "rpdo",
            Self::Any => "any",
        }
    }
}

impl BitField {
    /// Its part of a value.
    pub fn of(&self, value: u64) -> u64 {
        let width = u32::from(self.last.saturating_sub(self.first)) + 1;
        let mask = u64::MAX.checked_shr(64u32.saturating_sub(width)).unwrap_or(0);
        value.checked_shr(self.first.into()).unwrap_or(0) & mask
    }

    /// What its part of a value means, where the document says so.
    pub fn meaning(&self, value: u64) -> Option<&str> {
        let part = self.of(value);
        self.values.iter().find(|(range, _)| range.contains(&part)).map(|(_, meaning)| meaning.as_str())
    }
}
