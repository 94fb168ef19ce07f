//! A configuration, and its settings for a file.

use std::path::{Path, PathBuf};

use super::path::relative;
use super::read;
use super::settings::{Settings, WantedFiles, WantedProfile};
use objdict_lint::{Level, Options, Severities};
use objdict_model::diagnostic::{Findings, Severity};
use objdict_model::source::{
    CONFIG_FILE, MAX_TOML_SIZE, SourceError, SourceFile, SourceOptions, absolute, is_file,
};

/// A configuration that was read.
#[derive(Debug)]
pub struct Config {
    source: SourceFile,
    findings: Findings,
    is_toml: bool,
    /// The folder that paths are relative to.
    folder: PathBuf,
    settings: Settings,
}

impl Config {
    /// Reads the file at `path`; paths in it are relative to its folder.
    ///
    /// # Errors
    /// If the file cannot be opened.
    pub fn open(path: &Path) -> Result<Self, SourceError> {
        let source = SourceFile::open(path, &SourceOptions { encoding: None, max_size: MAX_TOML_SIZE })?;
        let path = absolute(path);
        Ok(Self::read(source, path.parent().unwrap_or(&path)))
    }

    /// Reads a source; paths in it are relative to `folder`.
    pub fn read(source: SourceFile, folder: impl AsRef<Path>) -> Self {
        let folder = absolute(folder.as_ref());
        let mut findings = Findings::new();
        let settings = read::read(source.text(), &mut findings);
        findings.sort_by_key(read::start_of);
        let is_toml = settings.is_some();
        Self { source, findings, is_toml, folder, settings: settings.unwrap_or_default() }
    }

    /// The configuration of a folder: the nearest file named [`CONFIG_FILE`], in it or in a parent folder.
    pub fn find(folder: &Path) -> Option<PathBuf> {
        absolute(folder).ancestors().map(|folder| folder.join(CONFIG_FILE)).find(|path| is_file(path))
    }

    /// The source.
    pub fn source(&self) -> &SourceFile {
        &self.source
    }

    /// Its errors.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// Whether it is valid TOML; otherwise no setting applies.
    pub fn is_toml(&self) -> bool {
        self.is_toml
    }

    /// Options for checking the file at `path`; `more` contains severities from the command line, which override those
    /// of the configuration except the ones for this file only. The caller loads profiles.
    pub fn options(&self, path: impl AsRef<Path>, more: &Severities) -> Options {
        let mut severities = Severities::default();
        for &(rules, level) in &self.settings.levels {
            severities.set(rules, level);
        }
        severities.extend(more);
        let path = self.relative(path.as_ref());
        let ignored = self.settings.ignored.iter().filter(|(pattern, _)| pattern.matches(&path));
        for &rules in ignored.flat_map(|(_, rules)| rules) {
            severities.set(rules, Level::Off);
        }
        let (node_id, tools) = (self.settings.node_id, self.settings.tools.clone());
        Options { node_id, tools, severities, ..Options::default() }
    }

    /// Additional profiles to check descriptions against; paths of files are relative to [`folder`](Self::folder).
    pub fn profiles(&self) -> &[WantedProfile] {
        &self.settings.profiles
    }

    /// Patterns of the patches of descriptions (docs/guides/patches.md), relative to [`folder`](Self::folder).
    pub fn patches(&self) -> &[WantedFiles] {
        &self.settings.patches
    }

    /// The lowest severity that fails a check.
    pub fn deny(&self) -> Option<Severity> {
        self.settings.deny
    }

    /// Whether the file at `path` is skipped when a folder is searched.
    pub fn excludes(&self, path: &Path) -> bool {
        let path = self.relative(path);
        self.settings.excluded.iter().any(|pattern| pattern.matches(&path))
    }

    /// The folder that paths are relative to.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    fn relative(&self, path: &Path) -> String {
        relative(&absolute(path), &self.folder)
    }
}
