//! The vendor and the names of the device: `DeviceIdentity` of the device profile, `identity` of the network
//! profile.

use crate::model::DeviceIdentity;

/// The complete content of the element.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct IdentityContent {
    pub(crate) vendor_name: Option<Box<str>>,
    /// As written.
    pub(crate) vendor_id: Option<Box<str>>,
    pub(crate) product_name: Option<Box<str>>,
    /// As written.
    pub(crate) product_id: Option<Box<str>>,
    pub(crate) order_numbers: Vec<Box<str>>,
    /// What an EDS does not have, without further order numbers.
    pub(crate) rest: DeviceIdentity,
}
