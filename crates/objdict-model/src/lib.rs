//! The foundation of objdict: texts with positions, findings as data, and the typed dictionary of a device.
//! Part of `objdict`, which is the crate to depend on.

#[macro_use]
mod named;

pub mod canopennode;
pub mod diagnostic;
mod format;
mod language;
pub mod literal;
pub mod model;
pub mod source;

pub use format::{Format, Syntax};
pub use language::Language;
