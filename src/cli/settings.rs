//! What a check is told: by arguments, and by the configurations of the folders that files are in.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;

use clap::Args;

use super::Failure;
use super::args::{Deny, node_id};
use super::profiles::ProfileArgs;
use crate::config::Config;
pub(super) use crate::config::Project;
use crate::diagnostic::{Selection, Severity, Tool, series};
use crate::lint::{Level, Options, Severities};
use crate::production::{Configuration, Judging};
use crate::profile::Profile;
use crate::registry;

/// Which configuration holds, and what counts more.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Settings")]
pub(super) struct ConfigArgs {
    /// The configuration for all files; without it, the nearest `objdict.toml` in the folder of each file or above
    /// (docs/config.md)
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Look for no configuration
    #[arg(long, conflicts_with = "config")]
    no_config: bool,
    /// How grave the findings of a rule or group are: cia306/file-name=off, cia302=note; may be given several times
    #[arg(long = "severity", value_name = "RULE=SEVERITY")]
    severities: Vec<RuleLevel>,
}

/// What a check is told.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Settings")]
pub(super) struct SettingsArgs {
    #[command(flatten)]
    config: ConfigArgs,
    /// The mildest severity that makes the exit code 1: note, warning or error; without it, warning
    #[arg(long, value_enum, value_name = "SEVERITY", hide_possible_values = true)]
    deny: Option<Deny>,
    /// The node-ID that formulas are worked out for; a DCF names its own
    #[arg(long, value_name = "N", value_parser = node_id)]
    node_id: Option<u8>,
    /// Tools that the descriptions shall be fit for: dcf-tools, canopeneditor, python-canopen, codesys, canopennode
    #[arg(long, value_name = "TOOL", value_delimiter = ',', value_parser = tool)]
    compat: Vec<Tool>,
    #[command(flatten)]
    profiles: ProfileArgs,
}

/// A rule or group with how grave its findings are: `cia306/file-name=off`.
#[derive(Clone, Copy, Debug)]
struct RuleLevel {
    rules: Selection,
    level: Level,
}

impl FromStr for RuleLevel {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, level) = text.split_once('=').ok_or("expected a rule, `=` and a severity")?;
        let level = level.parse().map_err(|error: crate::lint::UnknownLevel| error.to_string())?;
        match registry::select(name) {
            Some(rules) => Ok(Self { rules, level }),
            None => Err(match registry::nearest_selection(name) {
                Some(meant) => format!("there is no rule or group `{name}`, did you mean `{meant}`?"),
                None => format!("there is no rule or group `{name}`, `objdict rules` lists all"),
            }),
        }
    }
}

fn tool(name: &str) -> Result<Tool, String> {
    Tool::named(name).ok_or_else(|| format!("the tools are {}", series(Tool::ALL)))
}

impl ConfigArgs {
    /// What a check is told, with further profiles.
    pub(super) fn judging(&self, profiles: &ProfileArgs) -> Judging {
        let config = match &self.config {
            Some(path) => Configuration::At(path.clone()),
            None if self.no_config => Configuration::Off,
            None => Configuration::Nearest,
        };
        Judging { config, severities: self.severities(), profiles: profiles.profiles.clone() }
    }

    fn severities(&self) -> Severities {
        let mut severities = Severities::default();
        for &RuleLevel { rules, level } in &self.severities {
            severities.set(rules, level);
        }
        severities
    }
}

impl SettingsArgs {
    /// The node-ID that formulas are worked out for.
    pub(super) fn node_id(&self) -> Option<u8> {
        self.node_id
    }

    /// The mildest severity that is too grave, where an argument says so.
    pub(super) fn stated_deny(&self) -> Option<Severity> {
        self.deny.map(Severity::from)
    }
}

/// What a check is told, with the configurations, each of which is read once.
pub(super) struct Settings<'a> {
    args: &'a SettingsArgs,
    severities: Severities,
    profiles: Vec<Arc<Profile>>,
    /// The configuration for all files, where one was named.
    named: Option<Arc<Project>>,
    /// The configuration that holds in a folder.
    by_folder: HashMap<PathBuf, Option<Arc<Project>>>,
    /// Those that were read, in the order in which they were met, by their path.
    projects: Vec<(PathBuf, Arc<Project>)>,
}

impl<'a> Settings<'a> {
    /// What the arguments say.
    ///
    /// # Errors
    /// When the configuration or a profile that they name cannot be read.
    pub(super) fn new(args: &'a SettingsArgs) -> Result<Self, Failure> {
        let mut settings = Self {
            args,
            severities: args.config.severities(),
            profiles: args.profiles.load()?,
            named: None,
            by_folder: HashMap::new(),
            projects: Vec::new(),
        };
        if let Some(path) = &args.config.config {
            settings.named = Some(settings.open(path)?);
        }
        Ok(settings)
    }

    /// The configuration that holds for a file; the standard input is taken for a file of the current folder.
    ///
    /// # Errors
    /// When it cannot be opened.
    pub(super) fn project_of(&mut self, path: &Path) -> Result<Option<Arc<Project>>, Failure> {
        if self.args.config.no_config || self.named.is_some() {
            return Ok(self.named.clone());
        }
        let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        if let Some(known) = self.by_folder.get(folder) {
            return Ok(known.clone());
        }
        let project = Config::find(folder).map(|path| self.open(&path)).transpose()?;
        self.by_folder.insert(folder.to_owned(), project.clone());
        Ok(project)
    }

    /// The configurations that were met, in that order.
    pub(super) fn projects(&self) -> impl Iterator<Item = &Project> {
        self.projects.iter().map(|(_, project)| &**project)
    }

    /// What the check of a file is told.
    pub(super) fn options(&self, path: &Path, project: Option<&Project>) -> Options {
        let mut options = match project {
            Some(project) => project.config.options(path, &self.severities),
            None => Options { severities: self.severities.clone(), ..Options::default() },
        };
        let of_project = project.map(|project| &project.profiles[..]).unwrap_or_default();
        options.profiles = of_project.iter().chain(&self.profiles).cloned().collect();
        options.node_id = self.args.node_id.or(options.node_id);
        if !self.args.compat.is_empty() {
            options.tools.clone_from(&self.args.compat);
        }
        options
    }

    /// The mildest severity that makes the exit code 1.
    pub(super) fn deny(&self, project: Option<&Project>) -> Severity {
        let said = self.args.deny.map(Severity::from);
        said.or_else(|| project.and_then(|project| project.config.deny())).unwrap_or(Severity::Warning)
    }

    fn open(&mut self, path: &Path) -> Result<Arc<Project>, Failure> {
        if let Some((_, project)) = self.projects.iter().find(|(known, _)| known == path) {
            return Ok(project.clone());
        }
        let project = Arc::new(Project::open(path).map_err(Failure::new)?);
        self.projects.push((path.to_owned(), project.clone()));
        Ok(project)
    }
}
