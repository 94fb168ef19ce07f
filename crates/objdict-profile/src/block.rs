//! The logical devices of a module, which repeat the objects of a profile (CiA 301 §7.4.1).

use crate::model::Device;

/// The first index of profile objects; further logical devices of a module follow at fixed offsets.
pub(super) const FIRST_INDEX: u16 = 0x6000;
/// Number of indexes of a logical device (CiA 301 §7.4.1).
pub(super) const BLOCK: u16 = 0x800;
/// Maximum number of logical devices in a module.
pub const MAX_BLOCKS: u8 = 8;

/// Converts an index of the first logical device to the corresponding one of `block`, numbered from 0.
pub const fn index_in(block: u8, index: u16) -> u16 {
    if index < FIRST_INDEX { index } else { index.saturating_add(BLOCK.saturating_mul(block as u16)) }
}

/// The index of a logical device's device type: 1000h or, if it indicates several logical devices (FFFFh in
/// its low word), 67FFh plus multiples of 800h (CiA 301 §7.5.2.1).
pub fn device_type_index(device: &Device, block: u8) -> u16 {
    match device.profile() {
        Some(0xFFFF) => index_in(block, 0x67FF),
        _ => 0x1000,
    }
}

/// The device profile number of a logical device.
pub fn number_of(device: &Device, block: u8) -> Option<u16> {
    let value = device.object(device_type_index(device, block))?.value(0)?.as_integer()?;
    u16::try_from(value & 0xFFFF).ok()
}
