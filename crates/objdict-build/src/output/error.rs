//! The reasons why a file is not written.

use std::io;
use std::path::PathBuf;

use objdict_model::source::shown;

/// The reason why a file is not written.
#[derive(Debug)]
#[non_exhaustive]
pub enum OutputError {
    /// The system does not write it.
    Unwritable {
        /// The file.
        path: PathBuf,
        /// The system's error.
        error: io::Error,
    },
    /// The run reads it, or has already written it.
    InUse {
        /// The file.
        path: PathBuf,
    },
    /// It is in the folder, but objdict did not write it.
    Foreign {
        /// The file.
        path: PathBuf,
    },
    /// It is in the folder, but differs from what objdict wrote.
    Changed {
        /// The file.
        path: PathBuf,
    },
    /// Not every system can have a file of this name.
    Name {
        /// The name.
        name: String,
        /// Why.
        reason: &'static str,
    },
}

objdict_model::error_messages! { OutputError: {
    Self::Unwritable { path, error } => "cannot write `{}`: {error}", shown(path);
    Self::InUse { path } => "`{}` is already an input or output of this run", shown(path);
    Self::Foreign { path } => "`{}` was not written by objdict", shown(path);
    Self::Changed { path } => "`{}` was changed after objdict wrote it", shown(path);
    Self::Name { name, reason } => "`{name}` is not a valid file name: {reason}";
} }

impl OutputError {
    pub(super) fn unwritable(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        |error| Self::Unwritable { path: path.into(), error }
    }

    /// How to fix the error; `overwrite` is the caller's option for replacing foreign files.
    pub fn help(&self, overwrite: &str) -> Option<String> {
        Some(match self {
            Self::Unwritable { .. } => return None,
            Self::InUse { .. } => "choose a different output file".to_owned(),
            Self::Foreign { .. } | Self::Changed { .. } => {
                format!("choose a different folder, or replace the file with `{overwrite}`")
            }
            Self::Name { .. } => "choose a different name".to_owned(),
        })
    }
}
