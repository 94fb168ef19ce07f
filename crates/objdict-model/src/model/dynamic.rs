//! Dynamic channels and tools (CiA 302-4, CiA 306-3).

use super::part::part;
use super::{DataType, Extra, InvalidValues};

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
