//! The services of a device, with clients and masters implemented here.

// the sessions use block transfers too
#![cfg(feature = "block-transfer")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod client;
mod dictionary;
mod errors;
mod lss;
mod nmt;
mod node;
mod pdo;
mod pieces;
mod rules;
mod sdo;
mod sdo_client;
mod watched;

use objdict_device::Frame;

/// A frame of eight bytes at most.
fn frame(id: u16, data: &[u8]) -> Frame {
    Frame::new(id, data).unwrap()
}

#[test]
fn frames_have_11_bits_and_eight_bytes() {
    assert_eq!(Frame::new(0x800, &[]), None);
    assert_eq!(Frame::new(0x7FF, &[0; 9]), None);
    assert_eq!(frame(0x7FF, &[1, 2]).data(), [1, 2]);
}
