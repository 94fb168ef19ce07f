//! The description of the node in a DCF (CiA 306-1 §5.4), and the explicit downloads that configure it in
//! addition to its entries' values.

use super::part::part;
use super::{Extra, InvalidValues, Value};

part! {
    /// The configured node: `DeviceComissioning`, in the spelling of the standard.
    pub struct Commissioning {
        /// `NodeID`, 1 to 127; 255 for an unconfigured node that uses LSS.
        pub node_id: Option<u8>,
        /// `NodeName`.
        pub node_name: Option<String>,
        /// `NodeRefd`: the reference designator of the node.
        pub node_reference_designator: Option<String>,
        /// `Baudrate` in kbit/s.
        pub baud_rate: Option<u16>,
        /// `NetNumber`.
        pub net_number: Option<u32>,
        /// `NetworkName`.
        pub network_name: Option<String>,
        /// `NetRefd`: the reference designator of the network.
        pub net_reference_designator: Option<String>,
        /// `CANopenManager`: whether the node is the manager of the network.
        pub manager: Option<bool>,
        /// `LSS_SerialNumber`, as in 1018h sub-index 4.
        pub lss_serial_number: Option<u32>,
        /// Keys without a field in the model.
        pub extra: Extra,
        /// Texts that are not valid in their fields.
        #[cfg_attr(feature = "serde", serde(rename = "misfits"))]
        pub invalid_values: InvalidValues,
    }
}

/// An SDO download that is performed as stated: in this order, repeatedly if listed repeatedly, and even if
/// the node already has the value. No CiA format supports it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ExplicitDownload {
    /// Whether it is performed before or after the values of entries.
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

/// When a download is performed.
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
