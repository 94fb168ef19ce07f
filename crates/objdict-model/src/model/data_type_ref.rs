//! The data types of parameters and members (CiA 311 §6.4.2).

use super::part::{part, words};

/// The data type of a parameter, a member or an element.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum DataTypeRef {
    /// A type of IEC 61131-3.
    Simple(SimpleType),
    /// `dataTypeIDRef`: a type of the description.
    Defined(Box<str>),
    /// `variableRef`: the types of variables of functions.
    Variables(Vec<VariableRef>),
}

part! {
    /// A variable of a function instance (`variableRef`).
    pub struct VariableRef {
        /// `position`; 1 if missing.
        pub position: Option<u8>,
        /// `instanceIDRef`: the function instances, from the outermost to the innermost.
        pub instances: Vec<Box<str>>,
        /// `variableIDRef`: the variable.
        pub variable: Box<str>,
        /// `memberRef`: the members of the variable, from the outermost to the innermost.
        pub members: Vec<MemberRef>,
    }

    /// A member of a variable: by id, or by index of an array.
    pub struct MemberRef {
        /// `uniqueIDRef`.
        pub unique_id: Option<Box<str>>,
        /// `index`.
        pub index: Option<Box<str>>,
    }
}

words! {
    /// The data types of IEC 61131-3 in CiA 311. Some data types of CiA 301 have no counterpart.
    pub enum SimpleType {
        /// One bit.
        Bool = "BOOL",
        /// Bits.
        Bitstring = "BITSTRING",
        /// 8 bits.
        Byte = "BYTE",
        /// A character.
        Char = "CHAR",
        /// 16 bits.
        Word = "WORD",
        /// 32 bits.
        Dword = "DWORD",
        /// 64 bits.
        Lword = "LWORD",
        /// 8 bits, signed.
        Sint = "SINT",
        /// 16 bits, signed.
        Int = "INT",
        /// 32 bits, signed.
        Dint = "DINT",
        /// 64 bits, signed.
        Lint = "LINT",
        /// 8 bits, unsigned.
        Usint = "USINT",
        /// 16 bits, unsigned.
        Uint = "UINT",
        /// 32 bits, unsigned.
        Udint = "UDINT",
        /// 64 bits, unsigned.
        Ulint = "ULINT",
        /// 32 bits, floating point.
        Real = "REAL",
        /// 64 bits, floating point.
        Lreal = "LREAL",
        /// Characters of 8 bits.
        String = "STRING",
        /// Characters of 16 bits.
        Wstring = "WSTRING",
    }
}
