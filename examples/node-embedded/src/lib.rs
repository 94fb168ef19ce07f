//! What both examples share: the table of the device.

#![no_std]

/// The object dictionary.
pub mod od {
    include!(concat!(env!("OUT_DIR"), "/od.rs"));
}
