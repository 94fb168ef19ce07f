//! The common parts of a target's files: the texts of their first lines and their names.

use super::Options;
use crate::model::Device;

/// The first lines of every file, and the prefix of its identifiers.
pub(crate) struct Head {
    /// Generator and source, for the first line.
    pub(crate) made_by: String,
    /// The product name; empty if not stated.
    pub(crate) product: String,
    /// The vendor name; empty if not stated.
    pub(crate) vendor: String,
    /// The prefix of identifiers, and of macros.
    pub(crate) lower: String,
    pub(crate) upper: String,
    /// The name of files, without its end.
    pub(crate) stem: String,
}

impl Head {
    pub(crate) fn new(device: &Device, options: &Options, prefix: &str, stem: &str) -> Self {
        let info = device.device_info.as_ref();
        Self {
            made_by: options.made_by() + if device.is_ethercat() { ", from EtherCAT" } else { "" },
            product: info.and_then(|info| info.product_name.clone()).unwrap_or_default(),
            vendor: info.and_then(|info| info.vendor_name.clone()).unwrap_or_default(),
            lower: prefix.to_owned(),
            upper: prefix.to_ascii_uppercase(),
            stem: stem.to_owned(),
        }
    }
}
