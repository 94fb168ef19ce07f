//! Downloads that configure a node beside the values of its entries.

use super::Value;

/// An SDO download that is made as stated: in this order, more than once, and even if the node has the value
/// already. No format of CiA has a place for it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ExplicitDownload {
    /// Whether it comes before or after the values of the entries.
    pub when: Moment,
    /// The index of the object.
    #[cfg_attr(feature = "serde", serde(with = "super::hex_number"))]
    #[cfg_attr(feature = "schema", schemars(with = "super::HexText<u16>"))]
    pub index: u16,
    /// The sub-index of the entry.
    #[cfg_attr(feature = "serde", serde(with = "super::hex_number"))]
    #[cfg_attr(feature = "schema", schemars(with = "super::HexText<u8>"))]
    pub sub: u8,
    /// The value, as in `ParameterValue`.
    pub value: Value,
}

/// When a download is made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Moment {
    /// Before the values of entries.
    Before,
    /// After the values of entries.
    #[default]
    After,
}
