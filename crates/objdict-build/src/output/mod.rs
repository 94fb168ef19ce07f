//! Files that a run writes. None takes the place of one that the run reads; a file that an argument names is replaced; in a
//! folder only what objdict wrote is, unless `overwrite` is set.
//!
//! No other module writes files of a product, for the command and for build scripts. Inputs and outputs of a run
//! are recorded by device and inode (`Used`), so links and different spellings are recognised.

mod error;
mod folder;
mod manifest;
mod names;
#[cfg(feature = "command")]
mod replace;
mod save;
mod used;

pub use self::error::OutputError;
pub use self::folder::OutputFolder;
pub use self::manifest::{FileState, Hash, Manifest};
#[cfg(feature = "command")]
pub use self::save::PrivateFile;
pub use self::save::{Saved, abandon, save};
pub use self::used::Used;
