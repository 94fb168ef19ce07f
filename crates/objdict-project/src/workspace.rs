//! The common path from a file to its findings. The command, the language server, build scripts, pages and Python use
//! it, so that they agree on the configuration, its overrides, and the additional files of a description.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use objdict_format::Description;
use objdict_lint::{KnownObjects, Options, Severities};
use objdict_model::diagnostic::{Findings, Severity, Tool};
use objdict_model::source::SourceError;
use objdict_profile::Profile;

use crate::check::{check_after, check_with};
pub use crate::check::{of_devices, with_origin_beside};
use crate::config::{Config, Project};

/// The source of the configuration.
#[derive(Clone, Debug, Default)]
pub enum ConfigSource {
    /// The nearest `objdict.toml`, in the folder of a file or above.
    #[default]
    Nearest,
    /// The file at this path, for all files.
    At(PathBuf),
    /// No configuration.
    Off,
}

/// Settings that override the configuration: arguments of a command, or of a build script.
#[derive(Clone, Debug, Default)]
pub struct Overrides {
    /// The severities that override those of rules and configuration.
    pub severities: Severities,
    /// Additional profiles to check against.
    pub profiles: Vec<Arc<Profile>>,
    /// The node-ID that formulas are evaluated for.
    pub node_id: Option<u8>,
    /// The target tools of descriptions; empty for those of the configuration.
    pub tools: Vec<Tool>,
    /// The lowest severity that fails a check.
    pub deny: Option<Severity>,
}

impl Overrides {
    /// The options for checking a file with its configuration.
    pub fn options(&self, path: &Path, project: Option<&Project>) -> Options {
        let mut options = match project {
            Some(project) => project.config.options(path, &self.severities),
            None => Options { severities: self.severities.clone(), ..Options::default() },
        };
        let of_project = project.map(|project| &project.profiles[..]).unwrap_or_default();
        options.profiles = of_project.iter().chain(&self.profiles).cloned().collect();
        options.node_id = self.node_id.or(options.node_id);
        if !self.tools.is_empty() {
            options.tools.clone_from(&self.tools);
        }
        options
    }

    /// The lowest severity that fails the check of a file with its configuration; the default is error.
    pub fn deny(&self, project: Option<&Project>) -> Severity {
        self.deny.or_else(|| project.and_then(|project| project.config.deny())).unwrap_or(Severity::Error)
    }
}

/// The configurations of files, each read once, with their overrides.
///
/// ```
/// use std::path::Path;
///
/// use objdict_format::{Format, read};
/// use objdict_model::source::SourceFile;
/// use objdict_project::workspace::{ConfigSource, Overrides, Workspace, findings};
///
/// let mut workspace = Workspace::new(ConfigSource::Off, Overrides::default())?;
/// let path = Path::new("lamp.eds");
/// let project = workspace.project_of(path)?;
/// let lamp = read(SourceFile::from_text("lamp.eds", "[2000]\nDataType=5\n"), Format::Eds);
/// let of_devices = findings(&lamp, &workspace.overrides().options(path, project.as_deref()));
/// assert!(of_devices[0].has_errors());
/// # Ok::<(), objdict_model::source::SourceError>(())
/// ```
#[derive(Debug, Default)]
pub struct Workspace {
    config: ConfigSource,
    overrides: Overrides,
    /// The configuration of each folder.
    by_folder: BTreeMap<PathBuf, Option<Arc<Project>>>,
    /// All configurations that were read, in the order of first use, by path.
    projects: Vec<(PathBuf, Arc<Project>)>,
}

impl Workspace {
    /// Files with their configurations.
    ///
    /// # Errors
    /// If the configuration for all files cannot be opened.
    pub fn new(config: ConfigSource, overrides: Overrides) -> Result<Self, SourceError> {
        let mut made = Self { config, overrides, by_folder: BTreeMap::new(), projects: Vec::new() };
        if let ConfigSource::At(path) = &made.config {
            let path = path.clone();
            made.open(path)?;
        }
        Ok(made)
    }

    /// The settings that override the configurations.
    pub fn overrides(&self) -> &Overrides {
        &self.overrides
    }

    /// The configuration for a file; the standard input is treated as a file in the current folder.
    ///
    /// # Errors
    /// If it cannot be opened.
    pub fn project_of(&mut self, path: &Path) -> Result<Option<Arc<Project>>, SourceError> {
        match &self.config {
            ConfigSource::Off => return Ok(None),
            ConfigSource::At(_) => return Ok(self.projects.first().map(|(_, project)| project.clone())),
            ConfigSource::Nearest => {}
        }
        let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        if let Some(known) = self.by_folder.get(folder) {
            return Ok(known.clone());
        }
        let project = Config::find(folder).map(|path| self.open(path)).transpose()?;
        self.by_folder.insert(folder.to_owned(), project.clone());
        Ok(project)
    }

    /// The configurations that were met, in that order, with their paths.
    pub fn projects(&self) -> impl Iterator<Item = (&Path, &Arc<Project>)> {
        self.projects.iter().map(|(path, project)| (&**path, project))
    }

    /// The files that were read for the configurations: these themselves, profiles and patches.
    pub fn inputs(&self) -> impl Iterator<Item = PathBuf> {
        self.projects.iter().flat_map(|(path, project)| std::iter::once(path.clone()).chain(project.files()))
    }

    fn open(&mut self, path: PathBuf) -> Result<Arc<Project>, SourceError> {
        if let Some((_, project)) = self.projects.iter().find(|(known, _)| *known == path) {
            return Ok(project.clone());
        }
        let project = Arc::new(Project::open(&path)?);
        self.projects.push((path, project.clone()));
        Ok(project)
    }
}

/// The findings of each device of a file; for a variant, those that the base device does not have.
pub fn findings(description: &Description, options: &Options) -> Vec<Findings> {
    of_devices(description, |device| check_with(device, options))
}

/// Like `findings`, reusing results for objects from before an edit, which are then updated.
#[doc(hidden)] // for the language server
pub fn findings_after(
    description: &Description,
    options: &Options,
    known: &mut KnownObjects,
) -> Vec<Findings> {
    match description.document() {
        Some(_) => vec![check_after(description, options, known)],
        None => findings(description, options),
    }
}

/// Like `findings`, with the configuration of its file; the caller that reads its patches reports an
/// unreadable one.
pub fn configured_findings(description: &Description, config: ConfigSource) -> Vec<Findings> {
    let path = Path::new(description.source().name());
    let mut workspace = Workspace::new(config, Overrides::default()).unwrap_or_default();
    let project = workspace.project_of(path).unwrap_or_default();
    findings(description, &workspace.overrides.options(path, project.as_deref()))
}

/// Like `findings`, with the nearest configuration.
pub fn judge(description: &Description) -> Vec<Findings> {
    configured_findings(description, ConfigSource::Nearest)
}
