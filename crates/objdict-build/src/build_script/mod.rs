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
//! The firmware takes the file in with `include!(concat!(env!("OUT_DIR"), "/od.rs"))`. `docs/guides/cargo.md` shows a whole
//! project, `examples/firmware-rust` is one.
//!
//! A script also writes the EDS or XDD that goes with the firmware ([`Builder::convert_to`], with the feature `toml`,
//! which reads `device.toml` too).
//!
//! # Lines for Cargo
//!
//! * An error in the description fails the build: [`Error`] shows it with its place when `main` returns it.
//! * Warnings, and what a target cannot express, become `cargo:warning` lines, [so many](Builder::max_warnings) of them.
//! * Each file that was read is named by `cargo:rerun-if-changed`: the description, the configuration `objdict.toml` with
//!   its profiles, the files that options name. A configuration that is new, where there was none, does not make Cargo run
//!   the script.
//! * Files are only written when they change, and then as a whole.
//!
//! The check is that of `objdict generate`: the nearest `objdict.toml` holds, see [`Builder::config`].

mod builder;
mod cargo;

use std::path::{Path, PathBuf};

pub use self::builder::Builder;
pub use crate::pipeline::{Error, OutputError};
use objdict_generate::Sizes;
pub use objdict_lint::Level;
pub use objdict_model::diagnostic::Severity;

/// What a build script made.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Built {
    /// How many objects the device has.
    pub objects: usize,
    /// How many entries they have.
    pub entries: usize,
    /// The files, in the order of the targets, and then the descriptions; those that were there already with these contents
    /// too.
    pub files: Vec<PathBuf>,
    /// What the tables take in flash and RAM, by the names of the targets; empty unless
    /// [that is asked for](Builder::sizes).
    pub sizes: Vec<(&'static str, Sizes)>,
}

/// Writes `od.rs`, the dictionary of a description in Rust, to `OUT_DIR`: [`Builder::new`] without any option.
///
/// # Errors
/// When there is an error in the description, or a file cannot be read or written, see [`Error`].
pub fn generate(description: impl AsRef<Path>) -> Result<Built, Error> {
    Builder::new(description).generate()
}
