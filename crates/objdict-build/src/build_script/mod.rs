//! Generating in `build.rs`: the description is checked and turned into files for the firmware whenever it changes.
//!
//! The simple case is one line. It writes `od.rs` to `OUT_DIR`:
//!
//! ```no_run
//! # extern crate objdict_build as objdict;
//! // build.rs
//! fn main() -> Result<(), objdict::build_script::Error> {
//!     objdict::build_script::generate("motor.eds")?;
//!     Ok(())
//! }
//! ```
//!
//! Every option of the command `objdict generate` is a method of [`Builder`]:
//!
//! ```no_run
//! # mod objdict { pub use objdict_build::build_script; pub use objdict_generate as generate; }
//! use objdict::build_script::Builder;
//! use objdict::generate::Target;
//!
//! fn main() -> Result<(), objdict::build_script::Error> {
//!     Builder::new("motor.eds").node_id(5).target(Target::C).prefix("motor").generate()?;
//!     Ok(())
//! }
//! ```
//!
//! The firmware includes the file with `include!(concat!(env!("OUT_DIR"), "/od.rs"))`. `docs/guides/cargo.md` shows
//! a complete project, and `examples/firmware-rust` is one.
//!
//! A script can also write the EDS or XDD that ships with the firmware ([`Builder::convert_to`], with the feature
//! `toml`, which also reads `device.toml`).
//!
//! # Lines for Cargo
//!
//! * An error in the description fails the build: [`Error`] shows it with its place if `main` returns it.
//! * Warnings, and content that a target cannot express, become `cargo:warning` lines, up to a
//!   [limit](Builder::max_warnings).
//! * `cargo:rerun-if-changed` lists each file that was read: the description, the configuration `objdict.toml` with its
//!   profiles, and the files in options. Adding a first configuration does not make Cargo run the script.
//! * Files are written only when they change, and then as a whole.
//!
//! The check is the same as in `objdict generate`: the nearest `objdict.toml` applies; see
//! [`Builder::config`].

mod builder;
mod cargo;

use std::path::{Path, PathBuf};

pub use self::builder::Builder;
pub use crate::pipeline::{Error, OutputError};
use objdict_generate::Sizes;
pub use objdict_lint::Level;
pub use objdict_model::diagnostic::Severity;

/// The result of a build script.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Built {
    /// How many objects the device has.
    pub objects: usize,
    /// How many entries they have.
    pub entries: usize,
    /// The files, in the order of the targets, then the descriptions, including files that already had these contents.
    pub files: Vec<PathBuf>,
    /// The flash and RAM sizes of the tables, by the names of the targets; empty unless
    /// [requested](Builder::sizes).
    pub sizes: Vec<(&'static str, Sizes)>,
}

/// Writes `od.rs`, the dictionary of a description in Rust, to `OUT_DIR`: [`Builder::new`] without any option.
///
/// # Errors
/// If there is an error in the description, or a file cannot be read or written; see [`Error`].
pub fn generate(description: impl AsRef<Path>) -> Result<Built, Error> {
    Builder::new(description).generate()
}
