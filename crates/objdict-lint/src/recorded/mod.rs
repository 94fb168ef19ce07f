//! The rules about recordings: the responses of a device, and bus traffic. The readers of recordings apply
//! them.

pub mod probe;
pub mod traffic;
