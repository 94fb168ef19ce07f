//! The configuration `objdict.toml`: what a project says of all its descriptions (docs/config.md).
//!
//! Errors in it are findings with spans, as in a description; an invalid setting is ignored, and the others
//! hold.
//!
//! ```
//! use objdict::config::Config;
//! use objdict::lint::Severities;
//! use objdict::source::SourceFile;
//!
//! let text = "node-id = 5\n[rules]\n\"cia306/file-nam\" = \"off\"\ncia301 = \"note\"\n";
//! let config = Config::read(SourceFile::from_text("objdict.toml", text), "/project");
//! let finding = config.findings().iter().next().expect("there is no such rule");
//! assert_eq!(finding.help.as_ref().map(|help| help.to_string()).as_deref(), Some("did you mean `cia306/file-name`?"));
//!
//! let options = config.options("/project/devices/door.eds", &Severities::default());
//! assert_eq!(options.node_id, Some(5));
//! ```

mod path;
#[cfg(feature = "generate")]
mod project;
mod read;

use std::path::{Path, PathBuf};

use self::path::{PathPattern, relative};
#[cfg(feature = "generate")]
pub(crate) use self::project::Project;
use crate::diagnostic::{Findings, Selection, Severity, Tool};
use crate::lint::{Level, Options, Severities};
use crate::source::{CONFIG_FILE, MAX_TOML_SIZE, SourceError, SourceFile, SourceOptions, Span, absolute};

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

/// What a configuration says, as far as it is sound.
#[derive(Debug, Default)]
struct Settings {
    levels: Vec<(Selection, Level)>,
    ignored: Vec<(PathPattern, Vec<Selection>)>,
    excluded: Vec<PathPattern>,
    profiles: Vec<WantedProfile>,
    node_id: Option<u8>,
    tools: Vec<Tool>,
    deny: Option<Severity>,
}

/// A profile that a configuration asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WantedProfile {
    /// The number of the profile, or the path of a file.
    pub name: String,
    /// Its place.
    pub span: Span,
}

impl Config {
    /// Reads the file at `path`; paths in it are relative to its folder.
    ///
    /// # Errors
    /// When the file cannot be opened.
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

    /// The configuration that holds in a folder: the nearest file of the name [`CONFIG_FILE`], in it or above it.
    pub fn find(folder: &Path) -> Option<PathBuf> {
        absolute(folder).ancestors().map(|folder| folder.join(CONFIG_FILE)).find(|path| path.is_file())
    }

    /// The source.
    pub fn source(&self) -> &SourceFile {
        &self.source
    }

    /// Its errors.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// Whether it is TOML at all; else no setting holds.
    pub fn is_toml(&self) -> bool {
        self.is_toml
    }

    /// Options of a check of the file at `path`; severities of the command line come with `more`, and count more than
    /// those of the configuration, but not more than what it says of this file alone. Profiles are loaded by the caller.
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

    /// Profiles to check descriptions against, beside those that they state themselves; paths of files are relative to
    /// [`folder`](Self::folder).
    pub fn profiles(&self) -> &[WantedProfile] {
        &self.settings.profiles
    }

    /// The lowest severity that fails a check.
    pub fn deny(&self) -> Option<Severity> {
        self.settings.deny
    }

    /// Whether the file at `path` is passed over where it is found in a folder.
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
