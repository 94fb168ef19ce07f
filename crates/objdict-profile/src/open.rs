//! Opens a profile by its number or by the path of its file.

use std::path::Path;
use std::sync::Arc;

use super::{Profile, ProfileError, named, standard};
use crate::source::{SourceError, SourceFile, SourceOptions};

/// Why a profile cannot be opened.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OpenError {
    /// Neither a built-in profile nor a file.
    #[error("unknown profile `{name}`")]
    Unknown {
        /// The name.
        name: String,
    },
    /// The file cannot be opened.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// The file is not a valid profile.
    #[error("`{}` is not a valid profile: {error}", source_file.name())]
    Invalid {
        /// The file.
        source_file: Box<SourceFile>,
        /// What is wrong.
        error: ProfileError,
    },
}

impl OpenError {
    /// What to do about it.
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
    /// The number of a document as people call it: `401`.
    pub fn document_number(&self) -> &str {
        self.group.trim_start_matches("cia")
    }
}

/// The profile of a number such as `401` or `CiA 401`, or that of a file with a path from `folder` on.
///
/// # Errors
/// If there is no profile of this name, or the file cannot be read or is not a valid profile.
pub fn open(name: &str, folder: &Path) -> Result<Arc<Profile>, OpenError> {
    if let Some(profile) = named(name) {
        return Ok(Arc::new(profile.clone()));
    }
    let path = folder.join(name);
    if !path.exists() && path.extension().is_none() {
        return Err(OpenError::Unknown { name: name.to_owned() });
    }
    let source = SourceFile::open(&path, &SourceOptions::default())?;
    let profile = Profile::from_toml(source.text());
    profile.map(Arc::new).map_err(|error| OpenError::Invalid { source_file: Box::new(source), error })
}
