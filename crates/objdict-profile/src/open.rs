//! Opens profiles by number or by file path.

use std::path::Path;
use std::sync::Arc;

use super::{Profile, ProfileError, named, standard};
use crate::source::{MAX_TOML_SIZE, SourceError, SourceFile, SourceOptions};

/// Why a profile cannot be opened.
#[derive(Debug)]
#[non_exhaustive]
pub enum OpenError {
    /// Neither a built-in profile nor a file.
    Unknown {
        /// The name.
        name: String,
    },
    /// The file cannot be opened.
    Source(SourceError),
    /// The file is not a valid profile.
    Invalid {
        /// The invalid profile.
        source_file: Box<SourceFile>,
        /// The error.
        error: ProfileError,
    },
}

objdict_model::error_messages! { OpenError: from SourceError as Source {
    Self::Unknown { name } => "unknown profile `{name}`";
    Self::Source(error) => "{error}";
    Self::Invalid { source_file, error } => "`{}` is not a valid profile: {error}", source_file.name();
} }

impl OpenError {
    /// How to fix it.
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Unknown { .. } => Some(format!(
                "write one of {}, or the path of a profile such as `our-drives.toml`",
                numbers()
            )),
            Self::Source(_) => None,
            Self::Invalid { error, .. } => error.help.clone(),
        }
    }
}

fn numbers() -> String {
    let numbers: Vec<&str> = standard().map(Profile::document_number).collect();
    numbers.join(", ")
}

impl Profile {
    /// The number in the common name of a document: `401`.
    pub fn document_number(&self) -> &str {
        self.group.trim_start_matches("cia")
    }
}

/// Opens the profile with a number such as `401` or `CiA 401`, or a file with a path relative to `folder`.
///
/// # Errors
/// If there is no such profile, or the file cannot be read or is not a valid profile.
pub fn open(name: &str, folder: &Path) -> Result<Arc<Profile>, OpenError> {
    if let Some(profile) = named(name) {
        return Ok(Arc::new(profile.clone()));
    }
    let path = folder.join(name);
    if !path.exists() && path.extension().is_none() {
        return Err(OpenError::Unknown { name: name.to_owned() });
    }
    let source = SourceFile::open(&path, &SourceOptions { encoding: None, max_size: MAX_TOML_SIZE })?;
    let profile = Profile::from_toml(source.text());
    profile.map(Arc::new).map_err(|error| OpenError::Invalid { source_file: Box::new(source), error })
}
