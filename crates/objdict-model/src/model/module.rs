//! Modules of a modular device (CiA 306-1 chapter 6), dynamic channels and tools (CiA 302-4, CiA 306-3).

use std::collections::BTreeMap;

use super::part::part;
use super::{DataType, Entry, Extra, InvalidValues, Object};

part! {
    /// The supported and the connected modules of a bus coupler.
    pub struct Modules {
        /// `NrOfEntries` of `SupportedModules`, as stated.
        pub declared: Option<u16>,
        /// The modules by number, counted from 1.
        #[cfg_attr(feature = "serde", serde(with = "super::unique_keys"))]
        #[cfg_attr(feature = "schema", schemars(with = "BTreeMap<u16, Module>"))]
        pub supported: BTreeMap<u16, Module>,
        /// `ConnectedModules` of a DCF: the numbers of the modules in their physical order.
        pub connected: Option<Vec<u16>>,
        /// Texts of `SupportedModules` and `ConnectedModules` that are not valid in their fields.
        #[cfg_attr(feature = "serde", serde(rename = "misfits"))]
        pub invalid_values: InvalidValues,
        /// Keys of `SupportedModules` and `ConnectedModules` without a field in the model.
        pub extra: Extra,
    }

    // a map has room for eleven, but most modules add one object: a box saves memory
    /// A module and the objects and sub-indexes it adds to the dictionary of the coupler.
    pub struct Module {
        /// `ProductName`.
        pub product_name: Option<String>,
        /// `ProductVersion`.
        pub product_version: Option<u8>,
        /// `ProductRevision`.
        pub product_revision: Option<u8>,
        /// `OrderCode`.
        pub order_code: Option<String>,
        /// The lines of `MxComments`.
        pub comments: Vec<String>,
        /// `MxFixedObjects`: the list of objects that exist once if such a module is plugged in.
        #[cfg_attr(feature = "serde", serde(with = "super::index_list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Vec<super::HexText<u16>>"))]
        pub fixed_list: Vec<u16>,
        /// `MxFixedxxxx`: the description of those objects.
        #[cfg_attr(feature = "serde", serde(with = "super::index_keys"))]
        #[cfg_attr(feature = "schema", schemars(with = "BTreeMap<super::HexText<u16>, Box<Object>>"))]
        pub fixed: BTreeMap<u16, Box<Object>>,
        /// `MxSubExtends`: the list of objects to which each such module adds sub-indexes.
        #[cfg_attr(feature = "serde", serde(with = "super::index_list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Vec<super::HexText<u16>>"))]
        pub extension_list: Vec<u16>,
        /// `MxSubExtxxxx`: the description of the new sub-indexes.
        #[cfg_attr(feature = "serde", serde(with = "super::index_keys"))]
        #[cfg_attr(feature = "schema", schemars(with = "BTreeMap<super::HexText<u16>, Box<Extension>>"))]
        pub extensions: BTreeMap<u16, Box<Extension>>,
        /// Keys without a field in the model.
        pub extra: Extra,
        /// Texts that are not valid in their fields.
        #[cfg_attr(feature = "serde", serde(rename = "misfits"))]
        pub invalid_values: InvalidValues,
    }
}

part! {
    /// The sub-indexes that a module adds to an object.
    pub struct Extension from "super::flat::ExtensionForm" {
        /// The content of each new sub-index.
        #[cfg_attr(feature = "serde", serde(flatten))]
        always() pub entry: Entry,
        /// `Count`.
        pub count: Option<ExtensionCount>,
        /// `ObjExtend`: the maximum sub-index, after which the next index is used; none if 0 or missing.
        pub obj_extend: Option<u8>,
    }
}

/// The number of sub-indexes that a module adds (`Count`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum ExtensionCount {
    /// `n`: this number of new sub-indexes.
    Subs(u8),
    /// `0;b`: modules share a sub-index, each using `b` bits; when it is full, a new sub-index starts.
    SharedBits(u8),
}

part! {
    /// The segments of the process image for network variables (CiA 302-4).
    pub struct DynamicChannels {
        /// The segments, in the order of the file.
        always() pub segments: Vec<Segment>,
        /// Keys without a field in the model.
        pub extra: Extra,
        /// Texts that are not valid in their fields.
        #[cfg_attr(feature = "serde", serde(rename = "misfits"))]
        pub invalid_values: InvalidValues,
    }

    /// A range of indexes for network variables of one data type and direction.
    pub struct Segment {
        /// `TypeN`.
        pub data_type: Option<DataType>,
        /// `DirN`: `ro` for data to the network, `rww` or `wo` for data from it.
        pub direction: Option<Box<str>>,
        /// `RangeN`: first and last index.
        #[cfg_attr(feature = "serde", serde(with = "super::index_list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Option<[super::HexText<u16>; 2]>"))]
        pub range: Option<(u16, u16)>,
        /// `PPOffsetN`: the offset in the process picture, for BOOLEAN optionally followed by a comma and an
        /// address difference.
        pub offset: Option<Box<str>>,
        /// `maxNumber` (CiA 311): the maximum number of objects.
        pub max_number: Option<u32>,
        /// `bitAlignment` (CiA 311), in bits.
        pub bit_alignment: Option<u8>,
    }
}

impl Segment {
    /// Whether it states neither a type nor a direction nor a range.
    pub fn is_empty(&self) -> bool {
        let has_direction = self.direction.as_deref().is_some_and(|direction| !direction.is_empty());
        self.data_type.is_none() && !has_direction && self.range.is_none()
    }
}

part! {
    /// A program that a configuration tool can start.
    pub struct ToolCommand {
        /// `Name`.
        always() pub name: String,
        /// `Command`, with the placeholders `$DCF`, `$EDS` and `$NODEID`.
        always() pub command: String,
    }
}
