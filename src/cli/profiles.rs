//! The profiles that are asked for beside those that devices state themselves: `--profile` and the setting of the same
//! name in `objdict.toml`.

use std::path::Path;
use std::sync::Arc;

use super::Failure;
use crate::profile::{self, Profile};
use crate::report::problem;
use crate::source::{SourceFile, SourceOptions};

/// The argument `--profile`.
#[derive(Debug, Default, clap::Args)]
pub(super) struct ProfileArgs {
    /// A document that devices shall follow though they do not say so, such as 401, or a file with a profile of your own
    /// (docs/profiles.md); may be given several times
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
    if let Some(profile) = profile::named(name) {
        return Ok(Arc::clone(profile));
    }
    let path = folder.join(name);
    if !path.exists() && path.extension().is_none() {
        let numbers: Vec<String> = profile::standard().map(|profile| number(profile).to_owned()).collect();
        return Err(Failure::new(format_args!("there is no profile `{name}`")).help(format!(
            "it is one of {}, or the file of a profile such as `our-drives.toml`",
            numbers.join(", ")
        )));
    }
    read(&path)
}

/// The profile of a file.
fn read(path: &Path) -> Result<Arc<Profile>, Failure> {
    let source = SourceFile::open(path, &SourceOptions::default()).map_err(Failure::new)?;
    Profile::from_toml(source.text()).map(Arc::new).map_err(|error| {
        let failure = Failure::new(format_args!("`{}` is no profile: {}", path.display(), error.message));
        match error.span {
            Some(span) => failure.excerpt(problem(&source, span, &error.message, error.help.as_deref())),
            None => failure,
        }
    })
}

/// What people call a document that comes with the program: `401`.
pub(super) fn number(profile: &Profile) -> &str {
    profile.group.trim_start_matches("cia")
}
