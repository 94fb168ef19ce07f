//! Object codes (CiA 301 §7.4.3, table 42).

named! {
    /// The object type of an index.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[cfg_attr(feature = "serde", serde(rename_all = "UPPERCASE"))]
    #[repr(u8)]
    pub enum ObjectType {
        /// No data fields.
        Null (code 0) = "NULL",
        /// A block of data of any size, such as a program.
        Domain (code 2) = "DOMAIN",
        /// The definition of a data type.
        DefType (code 5) = "DEFTYPE",
        /// The definition of a structure.
        DefStruct (code 6) = "DEFSTRUCT",
        /// A single value.
        Var (code 7) = "VAR",
        /// Values of one data type, with their number in sub-index 0.
        Array (code 8) = "ARRAY",
        /// Values of any types, with the highest sub-index in sub-index 0.
        Record (code 9) = "RECORD",
    }
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
}
