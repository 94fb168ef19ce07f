//! A configuration with the other files that it needs.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::configuration::Config;
use crate::registry::own::invalid_setting;
use objdict_model::diagnostic::Findings;
use objdict_model::source::SourceError;
use objdict_profile as profile;
use objdict_profile::{OpenError, Profile};

/// A configuration with the profiles and patches that it names.
#[derive(Debug)]
pub struct Project {
    /// Its settings.
    pub config: Config,
    /// The profiles that it names.
    pub profiles: Vec<Arc<Profile>>,
    /// The patches that it names by patterns.
    #[cfg(feature = "full")]
    pub patches: Vec<Arc<objdict_format::patch::Patch>>,
    /// Its errors.
    pub findings: Findings,
    /// Errors in its profiles: files cannot be checked as configured if there are any.
    pub failures: Vec<OpenError>,
}

impl Project {
    /// Reads the file at `path`, and the profiles and patches that it refers to.
    ///
    /// # Errors
    ///
    /// If the file cannot be read. Errors in it are in `findings`.
    pub fn open(path: &Path) -> Result<Self, SourceError> {
        Ok(Self::of(Config::open(&called(path))?))
    }

    /// A configuration with the profiles that it names.
    pub fn of(config: Config) -> Self {
        let mut findings = config.findings().clone();
        let (mut profiles, mut failures) = (Vec::new(), Vec::new());
        // paths of files are relative, like the configuration's own
        let path = PathBuf::from(config.source().name());
        let folder = path.parent().unwrap_or(Path::new(""));
        for wanted in config.profiles() {
            match profile::open(&wanted.name, folder) {
                Ok(profile) => profiles.push(profile),
                Err(error @ OpenError::Invalid { .. }) => failures.push(error),
                Err(error) => {
                    let finding = invalid_setting(wanted.span, error.to_string());
                    let path = || "write a path relative to the folder of this configuration".to_owned();
                    findings.push(finding.help(error.help().unwrap_or_else(path)));
                }
            }
        }
        #[cfg(feature = "full")]
        let patches = super::patches::named(&config, folder, &mut findings);
        Self {
            config,
            profiles,
            #[cfg(feature = "full")]
            patches,
            findings,
            failures,
        }
    }

    /// Whether files can be checked as configured.
    pub fn is_usable(&self) -> bool {
        self.config.is_toml() && self.failures.is_empty()
    }

    /// The files with profiles that it names.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        let wanted = self.config.profiles().iter().filter(|wanted| profile::named(&wanted.name).is_none());
        let folder = Path::new(self.config.source().name()).parent().unwrap_or(Path::new(""));
        let files = wanted.map(|wanted| folder.join(&wanted.name)).filter(|path| path.is_file());
        #[cfg(feature = "full")]
        let files = files.chain(self.patches.iter().map(|patch| PathBuf::from(patch.source().name())));
        files
    }
}

/// A path relative to the current folder, if it is inside.
fn called(path: &Path) -> PathBuf {
    let current = std::env::current_dir().ok();
    current.and_then(|folder| path.strip_prefix(folder).ok()).unwrap_or(path).to_owned()
}
