//! The classes of devices (CiA 311).

use super::part::words;

words! {
    /// The class of a device.
    pub enum DeviceClass {
        /// A fixed device.
        Compact = "compact",
        /// A device with modules.
        Modular = "modular",
        /// A configurable device.
        Configurable = "configurable",
    }
}
