//! The identity object (CiA 301 §7.5.2.21).

use super::{Device, Value};

/// The content of 1018h; `None` for a missing or non-numeric value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// Sub-index 1: the vendor-ID assigned by CiA.
    pub vendor_id: Option<u32>,
    /// Sub-index 2.
    pub product_code: Option<u32>,
    /// Sub-index 3.
    pub revision_number: Option<u32>,
    /// Sub-index 4.
    pub serial_number: Option<u32>,
}

impl Identity {
    /// The index of the identity object.
    pub const INDEX: u16 = 0x1018;

    /// Major and minor revision: a new major revision changes the behaviour on the network.
    pub fn revision(&self) -> Option<(u16, u16)> {
        self.revision_number.map(|number| ((number >> 16) as u16, number as u16))
    }
}

impl Device {
    /// The identity of the device: 1018h after configuration.
    pub fn identity(&self) -> Identity {
        let object = self.object(Identity::INDEX);
        let number = |sub| {
            let value = object?.value(sub)?;
            value.as_ref().as_integer().and_then(|number| u32::try_from(number).ok())
        };
        Identity {
            vendor_id: number(1),
            product_code: number(2),
            revision_number: number(3),
            serial_number: number(4),
        }
    }

    /// The value of a sub-index after configuration.
    pub fn value(&self, index: u16, sub: u8) -> Option<std::borrow::Cow<'_, Value>> {
        self.object(index)?.value(sub)
    }
}
