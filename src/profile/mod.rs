//! What the standards demand of objects, as data: rules and generators ask here and know no table themselves.

pub mod cia301;

use crate::model::{Access, DataType, ObjectType};

/// What a standard says of an object, or of a range of alike ones.
#[derive(Debug)]
pub struct ObjectFacts {
    /// First index.
    pub first: u16,
    /// Last index; the first one for a single object.
    pub last: u16,
    /// Name in the standard.
    pub name: &'static str,
    /// The object type, then others that real devices have and that do no harm.
    pub object_types: &'static [ObjectType],
    /// Whether every device has the object.
    pub mandatory: bool,
    /// The sub-indexes that it may have, in ascending order.
    pub entries: &'static [EntryFacts],
}

/// What a standard says of a sub-index, or of a range of alike ones.
#[derive(Clone, Copy, Debug)]
pub struct EntryFacts {
    /// First sub-index.
    pub first: u8,
    /// Last sub-index; the first one for a single entry.
    pub last: u8,
    /// Name in the standard.
    pub name: &'static str,
    /// The data types that the standard's editions know; empty where any may be.
    pub data_types: &'static [DataType],
    /// The access types that the standard's editions allow; empty where any may be. See
    /// [`EntryFacts::accepts_access`].
    pub access: &'static [Access],
    /// Whether the entry is there whenever the object is.
    pub mandatory: bool,
    /// Whether a PDO may carry it.
    pub mappable: bool,
    /// Smallest and largest value that the standard allows; `None` for all of the data type.
    pub range: Option<(u64, u64)>,
}

impl ObjectFacts {
    /// The object type that the standard gives it.
    pub fn object_type(&self) -> ObjectType {
        self.object_types.first().copied().unwrap_or(ObjectType::Var)
    }

    /// What it says of a sub-index; `None` for one that the object does not have.
    pub fn entry(&self, sub: u8) -> Option<&'static EntryFacts> {
        self.entries.iter().find(|entry| (entry.first..=entry.last).contains(&sub))
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
}
