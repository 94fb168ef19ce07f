//! The profiles that are asked for beside those that devices state themselves: `--profile` and the setting of the same
//! name in `objdict.toml`.

use std::path::Path;
use std::sync::Arc;

use super::ending::Failure;
use super::written_files::keep;
use objdict_profile as profile;
use objdict_profile::{OpenError, Profile, ProfileError};
use objdict_project::report::problem;

// The argument `--profile`.
#[derive(Debug, Default, clap::Args)]
pub(super) struct ProfileArgs {
    /// Additional profile to check against: a CiA number such as 401, or a custom profile file (docs/guides/profiles.md); repeatable
    #[arg(long = "profile", value_name = "PROFILE")]
    pub profiles: Vec<String>,
}

impl ProfileArgs {
    /// The profiles that are meant, files in the current folder.
    pub(super) fn load(&self) -> Result<Vec<Arc<Profile>>, Failure> {
        self.profiles.iter().map(|name| load(name, Path::new(""))).collect()
    }
}

/// The profile of a number such as `401` or `CiA 401`, or that of a file with a path from `folder` on.
pub(super) fn load(name: &str, folder: &Path) -> Result<Arc<Profile>, Failure> {
    keep(&folder.join(name));
    Ok(profile::open(name, folder)?)
}

impl From<OpenError> for Failure {
    fn from(error: OpenError) -> Self {
        Self::from(&error)
    }
}

impl From<&OpenError> for Failure {
    fn from(error: &OpenError) -> Self {
        let failure = Self::new(error).maybe_help(error.help());
        match error {
            OpenError::Invalid { source_file, error: ProfileError { message, span: Some(span), help } } => {
                failure.excerpt(problem(source_file, *span, message, help.as_deref()))
            }
            _ => failure,
        }
    }
}
