//! Dynamic channels and tools (CiA 302-4, CiA 306-3).

use super::{DataType, Extra, InvalidValues};

/// The segments of the process image for network variables (CiA 302-4).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct DynamicChannels {
    /// The segments, in the order of the file.
    pub segments: Vec<Segment>,
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

/// A range of indexes for network variables of one data type and direction.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Segment {
    /// `TypeN`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub data_type: Option<DataType>,
    /// `DirN`: `ro` for data to the network, `rww` or `wo` for data from it.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub direction: Option<Box<str>>,
    /// `RangeN`: first and last index.
    #[cfg_attr(
        feature = "serde",
        serde(with = "super::index_list", skip_serializing_if = "Option::is_none")
    )]
    #[cfg_attr(feature = "schema", schemars(with = "Option<[super::HexText<u16>; 2]>"))]
    pub range: Option<(u16, u16)>,
    /// `PPOffsetN`: the offset in the process picture, for BOOLEAN optionally followed by a comma and an
    /// address difference.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub offset: Option<Box<str>>,
    /// `maxNumber` (CiA 311): the maximum number of objects.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub max_number: Option<u32>,
    /// `bitAlignment` (CiA 311), in bits.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub bit_alignment: Option<u8>,
}

impl Segment {
    /// Whether it states neither a type nor a direction nor a range.
    pub fn is_empty(&self) -> bool {
        let has_direction = self.direction.as_deref().is_some_and(|direction| !direction.is_empty());
        self.data_type.is_none() && !has_direction && self.range.is_none()
    }
}

/// A program that a configuration tool can start.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct ToolCommand {
    /// `Name`.
    pub name: String,
    /// `Command`, with the placeholders `$DCF`, `$EDS` and `$NODEID`.
    pub command: String,
}
