//! objdict
mod check;
pub mod diagnostic;
pub mod format;
pub mod lint;
pub mod model;
pub mod registry;
pub mod source;

pub use check::check;
