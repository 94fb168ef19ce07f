//! Modules of a modular device (CiA 306-1 chapter 6).

use std::collections::BTreeMap;

use super::{Entry, Extra, InvalidValues, Object};

/// The supported and the connected modules of a bus coupler.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Modules {
    /// `NrOfEntries` of `SupportedModules`, as stated.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub declared: Option<u16>,
    /// The modules by number, counted from 1.
    #[cfg_attr(
        feature = "serde",
        serde(with = "super::unique_keys", skip_serializing_if = "BTreeMap::is_empty")
    )]
    #[cfg_attr(feature = "schema", schemars(with = "BTreeMap<u16, Module>"))]
    pub supported: BTreeMap<u16, Module>,
    /// `ConnectedModules` of a DCF: the numbers of the modules in their physical order.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub connected: Option<Vec<u16>>,
    /// Texts of `SupportedModules` and `ConnectedModules` that are not valid in their fields.
    #[cfg_attr(
        feature = "serde",
        serde(rename = "misfits", skip_serializing_if = "InvalidValues::is_empty")
    )]
    pub invalid_values: InvalidValues,
    /// Keys of `SupportedModules` and `ConnectedModules` without a field in the model.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Extra::is_empty"))]
    pub extra: Extra,
}

/// A module and the objects and sub-indexes it adds to the dictionary of the coupler.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
// a map has room for eleven, and most modules bring one object: a box keeps that small
pub struct Module {
    /// `ProductName`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub product_name: Option<String>,
    /// `ProductVersion`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub product_version: Option<u8>,
    /// `ProductRevision`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub product_revision: Option<u8>,
    /// `OrderCode`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub order_code: Option<String>,
    /// The lines of `MxComments`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub comments: Vec<String>,
    /// `MxFixedObjects`: the list of objects that exist once if such a module is plugged in.
    #[cfg_attr(feature = "serde", serde(with = "super::index_list", skip_serializing_if = "Vec::is_empty"))]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<super::HexText<u16>>"))]
    pub fixed_list: Vec<u16>,
    /// `MxFixedxxxx`: the description of those objects.
    #[cfg_attr(
        feature = "serde",
        serde(with = "super::index_keys", skip_serializing_if = "BTreeMap::is_empty")
    )]
    #[cfg_attr(feature = "schema", schemars(with = "BTreeMap<super::HexText<u16>, Box<Object>>"))]
    pub fixed: BTreeMap<u16, Box<Object>>,
    /// `MxSubExtends`: the list of objects to which each such module adds sub-indexes.
    #[cfg_attr(feature = "serde", serde(with = "super::index_list", skip_serializing_if = "Vec::is_empty"))]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<super::HexText<u16>>"))]
    pub extension_list: Vec<u16>,
    /// `MxSubExtxxxx`: the description of the new sub-indexes.
    #[cfg_attr(
        feature = "serde",
        serde(with = "super::index_keys", skip_serializing_if = "BTreeMap::is_empty")
    )]
    #[cfg_attr(feature = "schema", schemars(with = "BTreeMap<super::HexText<u16>, Box<Extension>>"))]
    pub extensions: BTreeMap<u16, Box<Extension>>,
    /// Keys without a field in the model.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Extra::is_empty"))]
    pub extra: Extra,
    /// Texts that are not valid in their fields.
    #[cfg_attr(
        feature = "serde",
        serde(rename = "misfits", skip_serializing_if = "InvalidValues::is_empty")
    )]
    pub invalid_values: InvalidValues,
}

/// The sub-indexes that a module adds to an object.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(try_from = "super::flat::ExtensionForm"))]
#[cfg_attr(feature = "schema", schemars(!try_from))]
pub struct Extension {
    /// The content of each new sub-index.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub entry: Entry,
    /// `Count`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub count: Option<ExtensionCount>,
    /// `ObjExtend`: the maximum sub-index, after which the next index is used; none if 0 or missing.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub obj_extend: Option<u8>,
}

/// The number of sub-indexes that a module adds (`Count`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ExtensionCount {
    /// `n`: this number of new sub-indexes.
    Subs(u8),
    /// `0;b`: modules share a sub-index, each using `b` bits; a new sub-index starts if the last one is
    /// full.
    SharedBits(u8),
}
