//! What a CANopen device needs beside its object dictionary, for firmware: no standard library, no allocation,
//! no `unsafe`, no dependency.
//!
//! `objdict generate --target rust` writes the dictionary of a device as a table. [`table`] is the code that
//! serves such a table; it is the same for every device.

#![no_std]

pub mod table;

pub use table::Abort;
