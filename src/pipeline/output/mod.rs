//! Files that a run writes. None takes the place of one that the run reads; a file that an argument names is replaced; in a
//! folder only what objdict wrote is, unless `overwrite` is set.

mod error;
mod folder;
mod manifest;
mod names;
#[cfg(feature = "cli")]
mod replace;
mod save;
mod used;

pub use self::error::OutputError;
pub(crate) use self::folder::OutputFolder;
#[cfg(feature = "cli")]
pub(crate) use self::manifest::Hash;
#[cfg(feature = "cli")]
pub(crate) use self::manifest::{Manifest, State};
#[cfg(feature = "cli")]
pub(crate) use self::save::{Saved, abandon, save};
pub(crate) use self::used::Used;
