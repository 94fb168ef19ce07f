//! The description of the node in a DCF (CiA 306-1 §5.4).

use super::{Extra, InvalidValues};

/// The configured node: `DeviceComissioning`, in the spelling of the standard.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Commissioning {
    /// `NodeID`, 1 to 127; 255 for an unconfigured node that uses LSS.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub node_id: Option<u8>,
    /// `NodeName`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub node_name: Option<String>,
    /// `NodeRefd`: the reference designator of the node.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub node_reference_designator: Option<String>,
    /// `Baudrate` in kbit/s.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub baud_rate: Option<u16>,
    /// `NetNumber`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub net_number: Option<u32>,
    /// `NetworkName`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub network_name: Option<String>,
    /// `NetRefd`: the reference designator of the network.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub net_reference_designator: Option<String>,
    /// `CANopenManager`: whether the node is the manager of the network.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub manager: Option<bool>,
    /// `LSS_SerialNumber`, as in 1018h sub-index 4.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub lss_serial_number: Option<u32>,
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
