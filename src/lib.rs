//! objdict
mod check;
#[cfg(feature = "cli")]
pub mod cli;
pub mod diagnostic;
pub mod download;
pub mod format;
pub mod generate;
pub mod lint;
pub mod model;
pub mod profile;
pub mod registry;
pub mod report;
pub mod source;

pub use check::check;
