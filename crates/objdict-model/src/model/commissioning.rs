//! The description of the node in a DCF (CiA 306-1 §5.4).

use super::part::part;
use super::{Extra, InvalidValues};

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
