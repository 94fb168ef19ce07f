//! Files that a run writes. None replaces a file that the run reads. A file given as an argument is replaced; in a
//! folder, only files of objdict are, unless `overwrite` is set.
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
