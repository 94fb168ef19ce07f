//! What a DCF says of the node (CiA 306-1 §5.4).

use serde::{Deserialize, Serialize};

use super::{Extra, Misfits};

/// The node that a device description was configured for: `DeviceComissioning`, as the standard spells it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Commissioning {
    /// `NodeID`, 1 to 127; 255 for a node that waits for LSS.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node_id: Option<u8>,
    /// `NodeName`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node_name: Option<String>,
    /// `NodeRefd`: the reference designator of the node.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node_reference_designator: Option<String>,
    /// `Baudrate` in kbit/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub baud_rate: Option<u16>,
    /// `NetNumber`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub net_number: Option<u32>,
    /// `NetworkName`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub network_name: Option<String>,
    /// `NetRefd`: the reference designator of the network.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub net_reference_designator: Option<String>,
    /// `CANopenManager`: whether the node is the manager of the network.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub manager: Option<bool>,
    /// `LSS_SerialNumber`, as in 1018h sub-index 4.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lss_serial_number: Option<u32>,
    /// Keys that the model does not know.
    #[serde(skip_serializing_if = "Extra::is_empty")]
    pub extra: Extra,
    /// Texts that are no values of their fields.
    #[serde(skip_serializing_if = "Misfits::is_empty")]
    pub misfits: Misfits,
}
