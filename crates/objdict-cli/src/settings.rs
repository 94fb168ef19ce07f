//! Settings of a check: from arguments, and from the configurations of the folders that files are in.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::{Arc, Mutex, PoisonError};

use clap::Args;

use super::ending::{Failure, detail};
use super::patch_option::remember;
use super::profile_option::ProfileArgs;
use super::values::{node_id, one_of};
use super::written_files::keep;
pub(crate) use objdict_build::pipeline::CheckSettings;
use objdict_format::Description;
use objdict_format::input::Reading;
use objdict_format::patch::Patch;
use objdict_lint::{Level, Options, Severities};
use objdict_model::diagnostic::{Findings, Selection, Severity, Tool, series};
use objdict_model::source::shown;
pub(super) use objdict_project::config::Project;
use objdict_project::registry;
pub(crate) use objdict_project::workspace::ConfigSource;
use objdict_project::workspace::{self, Overrides, Workspace};

// Which configuration applies.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Settings")]
pub(super) struct ConfigFileArgs {
    /// Configuration for all files [default: the nearest `objdict.toml` in the folder of each file or above]
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Ignore all configuration files
    #[arg(long, conflicts_with = "config")]
    no_config: bool,
}

// Which configuration applies, and what overrides it.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Settings")]
pub(super) struct ConfigArgs {
    #[command(flatten)]
    file: ConfigFileArgs,
    /// New severity of a rule or group: cia306/file-name=off, cia302=note; repeatable
    #[arg(long = "severity", value_name = "RULE=SEVERITY")]
    severities: Vec<RuleLevel>,
    /// Rule or group to report exclusively; repeatable or comma-separated
    #[arg(long, value_name = "RULE", value_delimiter = ',', value_parser = rules)]
    select: Vec<Selection>,
    /// Rule or group to ignore; repeatable or comma-separated
    #[arg(long, value_name = "RULE", value_delimiter = ',', value_parser = rules)]
    ignore: Vec<Selection>,
}

// Settings of a check.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Settings")]
pub(super) struct SettingsArgs {
    #[command(flatten)]
    config: ConfigArgs,
    /// Lowest severity that fails the run: note, warning or error [default: error]
    #[arg(long, value_parser = one_of(&SEVERITIES), value_name = "SEVERITY", hide_possible_values = true)]
    deny: Option<Severity>,
    /// Node-ID (`$NODEID` in formulas) [default: from the DCF]
    #[arg(long, value_name = "N", value_parser = node_id)]
    node_id: Option<u8>,
    /// Tool to check compatibility with: dcf-tools, lely, canopeneditor, python-canopen, node-canopen, codesys, canopennode, canchkeds;
    /// repeatable or comma-separated
    #[arg(long, value_name = "TOOL", value_delimiter = ',', value_parser = tool)]
    compat: Vec<Tool>,
    #[command(flatten)]
    profiles: ProfileArgs,
}

/// A rule or group with its severity: `cia306/file-name=off`.
#[derive(Clone, Copy, Debug)]
struct RuleLevel {
    rules: Selection,
    level: Level,
}

impl FromStr for RuleLevel {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, level) = text.split_once('=').ok_or("expected a rule, `=` and a severity")?;
        let level = level.parse().map_err(|error: objdict_lint::UnknownLevel| error.to_string())?;
        Ok(Self { rules: rules(name)?, level })
    }
}

/// A rule or group by its name.
fn rules(name: &str) -> Result<Selection, String> {
    registry::select(name).ok_or_else(|| match registry::nearest_selection(name) {
        Some(meant) => format!("unknown rule or group `{name}`, did you mean `{meant}`?"),
        None => format!("unknown rule or group `{name}`, `objdict rules` lists all"),
    })
}

fn tool(name: &str) -> Result<Tool, String> {
    Tool::named(name).ok_or_else(|| format!("the tools are {}", series(Tool::ALL)))
}

impl SettingsArgs {
    /// The number of the first device profile that is asked for.
    ///
    /// # Errors
    /// When it has none, or is not known.
    pub(super) fn device_profile(&self) -> Result<Option<u16>, Failure> {
        let Some(profile) = self.profiles.load()?.into_iter().next() else { return Ok(None) };
        let unnumbered =
            || Failure::new(format_args!("`{}` is for devices of any profile", profile.document));
        profile.number.map(Some).ok_or_else(|| unnumbered().help("name a device profile, such as 402"))
    }
}

impl ConfigFileArgs {
    /// The patches that the configuration of a file names.
    ///
    /// # Errors
    /// When it cannot be used.
    pub(super) fn patches_of(&self, path: &Path) -> Result<Vec<Arc<Patch>>, Failure> {
        CommandSettings::new(&SettingsArgs::from(self))?.patches_of(path)
    }

    fn configuration(&self) -> ConfigSource {
        match &self.config {
            Some(path) => ConfigSource::At(path.clone()),
            None if self.no_config => ConfigSource::Off,
            None => ConfigSource::Nearest,
        }
    }
}

impl ConfigArgs {
    /// Settings of a check, with further profiles.
    pub(super) fn check(&self, profiles: &ProfileArgs) -> CheckSettings {
        let config = self.file.configuration();
        CheckSettings { config, severities: self.severities(), profiles: profiles.profiles.clone() }
    }

    fn severities(&self) -> Severities {
        let mut severities = Severities::default();
        for &RuleLevel { rules, level } in &self.severities {
            severities.set(rules, level);
        }
        for &rules in &self.ignore {
            severities.set(rules, Level::Off);
        }
        self.select.iter().for_each(|&rules| severities.select(rules));
        severities
    }
}

impl From<&ConfigFileArgs> for SettingsArgs {
    fn from(file: &ConfigFileArgs) -> Self {
        let config = ConfigArgs { file: file.clone(), ..ConfigArgs::default() };
        Self { config, ..Self::default() }
    }
}

impl SettingsArgs {
    /// Which configuration applies.
    pub(super) fn config_file(&self) -> &ConfigFileArgs {
        &self.config.file
    }

    /// The node-ID that formulas are evaluated for.
    pub(super) fn node_id(&self) -> Option<u8> {
        self.node_id
    }

    /// Whether arguments name the tools that descriptions are for.
    pub(super) fn names_tools(&self) -> bool {
        !self.compat.is_empty()
    }

    /// The lowest severity that fails the run, if an argument sets it.
    pub(super) fn stated_deny(&self) -> Option<Severity> {
        self.deny
    }
}

/// Settings of a check, with the configurations.
pub(super) struct CommandSettings(Workspace);

impl CommandSettings {
    /// What the arguments say.
    ///
    /// # Errors
    /// When the configuration or a profile that they name cannot be read.
    pub(super) fn new(args: &SettingsArgs) -> Result<Self, Failure> {
        *CONFIG.lock().unwrap_or_else(PoisonError::into_inner) = args.config.file.configuration();
        let overrides = Overrides {
            severities: args.config.severities(),
            profiles: args.profiles.load()?,
            node_id: args.node_id,
            tools: args.compat.clone(),
            deny: args.stated_deny(),
        };
        let workspace = Workspace::new(args.config.file.configuration(), overrides).map_err(Failure::new)?;
        workspace.projects().for_each(|(path, project)| take(path, project));
        Ok(Self(workspace))
    }

    /// The configuration that holds for a file; the standard input is taken for a file of the current folder.
    ///
    /// # Errors
    /// When it cannot be opened.
    pub(super) fn project_of(&mut self, path: &Path) -> Result<Option<Arc<Project>>, Failure> {
        let known = self.0.projects().count();
        let project = self.0.project_of(path).map_err(Failure::new)?;
        self.0.projects().skip(known).for_each(|(path, project)| take(path, project));
        Ok(project)
    }

    /// The patches that the configuration of a file names.
    ///
    /// # Errors
    /// When it cannot be used.
    pub(super) fn patches_of(&mut self, path: &Path) -> Result<Vec<Arc<Patch>>, Failure> {
        let project = self.project_of(path)?;
        match self.unusable().next() {
            Some(failure) => Err(failure),
            None => Ok(project.map(|project| project.patches.clone()).unwrap_or_default()),
        }
    }

    /// The configurations that were met, in that order.
    pub(super) fn projects(&self) -> impl Iterator<Item = &Project> {
        self.0.projects().map(|(_, project)| &**project)
    }

    /// What all files say that settings come from, for a hash.
    pub(super) fn contents(&self) -> String {
        let mut contents = format!("{:?}", self.0.overrides().profiles);
        for (path, project) in self.0.projects() {
            let text = project.config.source().text();
            let _ =
                write!(contents, "{} {text} {:?} {:?}", path.display(), project.profiles, project.patches);
        }
        contents
    }

    /// The configurations that were met and cannot be used, or have errors.
    pub(super) fn unusable(&self) -> impl Iterator<Item = Failure> {
        let is_unusable = |project: &&Project| !project.is_usable() || project.findings.has_errors();
        self.projects().filter(is_unusable).map(|project| {
            let name = project.config.source().name();
            let mut errors = project.findings.iter().filter(|finding| finding.severity == Severity::Error);
            let of_profiles = || Some(project.failures.first()?.to_string());
            let message = match errors.next().map(|cause| cause.message.to_string()).or_else(of_profiles) {
                Some(cause) => format!("`{name}` cannot be used: {cause}"),
                None => format!("`{name}` cannot be used"),
            };
            Failure::new(message).help("run `objdict check` to list all errors")
        })
    }

    /// The options of the check of a file.
    pub(super) fn options(&self, path: &Path, project: Option<&Project>) -> Options {
        self.0.overrides().options(path, project)
    }

    /// The lowest severity that makes the exit code 1.
    pub(super) fn deny(&self, project: Option<&Project>) -> Severity {
        self.0.overrides().deny(project)
    }
}

/// Which configuration this run uses.
static CONFIG: Mutex<ConfigSource> = Mutex::new(ConfigSource::Nearest);

/// All findings of a source: every command that makes something of it refuses its errors.
pub(super) fn judge(description: &Description) -> Vec<Findings> {
    let config = CONFIG.lock().unwrap_or_else(PoisonError::into_inner).clone();
    workspace::configured_findings(description, config)
}

/// How every command reads that makes something of a file.
pub(super) fn reading() -> Reading {
    Reading { judge: Some(judge), ..Reading::default() }
}

/// A configuration that was opened: no output goes over its files, and patches that are for no file are named at the end.
fn take(path: &Path, project: &Project) {
    detail(&shown(path));
    keep(path);
    project.files().for_each(|file| keep(&file));
    remember(&project.patches);
}

/// The severities, as arguments.
pub(super) const SEVERITIES: [(Severity, &str, &str); 3] =
    [(Severity::Note, "note", ""), (Severity::Warning, "warning", ""), (Severity::Error, "error", "")];
