//! Files that a run writes. None takes the place of one that the run reads; a file that an argument names is replaced; in a
//! folder only what objdict wrote is, unless `overwrite` is set.

mod folder;
mod manifest;
mod names;
#[cfg(feature = "cli")]
mod replace;
mod save;

use std::collections::HashSet;
use std::io;
use std::path::{Path, PathBuf};

pub(crate) use self::folder::OutputFolder;
#[cfg(feature = "cli")]
pub(crate) use self::manifest::{Manifest, State};
#[cfg(feature = "cli")]
pub(crate) use self::save::abandon;
pub(crate) use self::save::{Saved, save};

/// Why a file is not written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The system does not write it.
    #[error("cannot write `{}`: {error}", path.display())]
    Unwritable {
        /// The file.
        path: PathBuf,
        /// What the system said.
        error: io::Error,
    },
    /// The run reads it, or has written it.
    #[error("`{}` is another input or output of this run", path.display())]
    InUse {
        /// The file.
        path: PathBuf,
    },
    /// It is in the folder, and objdict did not write it.
    #[error("`{}` was not written by objdict", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
    },
    /// It is in the folder, and is not as objdict wrote it.
    #[error("`{}` was changed after objdict wrote it", path.display())]
    Changed {
        /// The file.
        path: PathBuf,
    },
    /// Not every system can have a file of this name.
    #[error("`{name}` is not a valid name of a file: {reason}")]
    Name {
        /// The name.
        name: String,
        /// Why.
        reason: &'static str,
    },
}

impl OutputError {
    fn unwritable(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        |error| Self::Unwritable { path: path.into(), error }
    }

    /// What to do about it; `overwrite` is how the caller says that files of others may be replaced.
    pub(crate) fn help(&self, overwrite: &str) -> Option<String> {
        Some(match self {
            Self::Unwritable { .. } => return None,
            Self::InUse { .. } => "name another file for the output".to_owned(),
            Self::Foreign { .. } | Self::Changed { .. } => {
                format!("name another folder, or replace the file with `{overwrite}`")
            }
            Self::Name { .. } => "choose another name".to_owned(),
        })
    }
}

/// What a file is, whatever it is called: its device and its number there, or its full path where files have no numbers.
#[cfg(unix)]
type Identity = (u64, u64);
#[cfg(not(unix))]
type Identity = PathBuf;

/// `None` for what does not exist, and for pipes and devices: writing to these takes nothing away.
#[cfg(unix)]
fn identity(path: &Path) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    path.metadata().ok().filter(std::fs::Metadata::is_file).map(|file| (file.dev(), file.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<Identity> {
    path.canonicalize().ok().filter(|path| path.is_file())
}

/// The files that a run reads or has written.
#[derive(Debug, Default)]
pub(crate) struct Used(HashSet<Identity>);

impl Used {
    /// Notes that the run uses a file.
    pub(crate) fn add(&mut self, path: &Path) {
        self.0.extend(identity(path));
    }

    /// Refuses a file that the run uses already.
    pub(crate) fn require_other(&self, path: &Path) -> Result<(), OutputError> {
        match identity(path) {
            Some(identity) if self.0.contains(&identity) => Err(OutputError::InUse { path: path.to_owned() }),
            _ => Ok(()),
        }
    }

    /// Writes a file that an argument names: it replaces what is there, but nothing that the run uses.
    #[cfg(feature = "cli")]
    pub(crate) fn save(&mut self, path: &Path, contents: &[u8]) -> Result<Saved, OutputError> {
        names::require_file(path)?;
        self.require_other(path)?;
        let saved = save(path, contents).map_err(OutputError::unwritable(path))?;
        self.add(path);
        Ok(saved)
    }
}
