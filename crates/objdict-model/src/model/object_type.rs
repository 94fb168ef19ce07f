//! Object codes (CiA 301 §7.4.3, table 42).

use std::fmt;

/// The object type of an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "UPPERCASE"))]
#[repr(u8)]
pub enum ObjectType {
    /// No data fields.
    Null = 0,
    /// A block of data of any size, such as a program.
    Domain = 2,
    /// The definition of a data type.
    DefType = 5,
    /// The definition of a structure.
    DefStruct = 6,
    /// A single value.
    Var = 7,
    /// Values of one data type, with their number in sub-index 0.
    Array = 8,
    /// Values of any types, with the highest sub-index in sub-index 0.
    Record = 9,
}

impl ObjectType {
    /// The object type with this object code.
    pub const fn from_code(code: u8) -> Option<Self> {
        Some(match code {
            0 => Self::Null,
            2 => Self::Domain,
            5 => Self::DefType,
            6 => Self::DefStruct,
            7 => Self::Var,
            8 => Self::Array,
            9 => Self::Record,
            _ => return None,
        })
    }

    /// The object code.
    pub const fn code(self) -> u8 {
        self as u8
    }

    /// Whether the values are in sub-indexes (ARRAY, RECORD, DEFSTRUCT).
    pub const fn has_subs(self) -> bool {
        matches!(self, Self::Array | Self::Record | Self::DefStruct)
    }

    /// The name in CiA 301.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Null => "NULL",
            Self::Domain => "DOMAIN",
            Self::DefType => "DEFTYPE",
            Self::DefStruct => "DEFSTRUCT",
            Self::Var => "VAR",
            Self::Array => "ARRAY",
            Self::Record => "RECORD",
        }
    }
}

impl fmt::Display for ObjectType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
