//! Settings of the check from the configuration, and the files of names and profiles.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Error, Request, refusal, text_of};
use objdict_generate as generate;
use objdict_lint::Options;
use objdict_model::diagnostic::{Diagnostic, Severity};
use objdict_model::source::{MAX_TOML_SIZE, read_text, shown};
use objdict_profile as profile;
use objdict_profile::Profile;
use objdict_project::config::Project;
use objdict_project::report::Subject;
use objdict_project::workspace::{Overrides, Workspace};

impl Request {
    /// The options of the check, and the problems of the configuration files.
    pub(super) fn configured(
        &self,
        project: Option<&Project>,
        node_id: Option<u8>,
        files: &mut Vec<PathBuf>,
    ) -> Result<(Options, Vec<String>), Error> {
        let profiles = self.check.profiles.iter().map(|name| self.profile(name, files));
        let overrides = Overrides {
            severities: self.check.severities.clone(),
            profiles: profiles.collect::<Result<_, _>>()?,
            node_id,
            ..Overrides::default()
        };
        let options = overrides.options(&self.file, project);
        let findings = project.map(|project| config_findings(project, &options)).transpose()?;
        Ok((options, findings.unwrap_or_default()))
    }

    /// The configuration of the description; its files are added to `files`.
    pub(super) fn project(&self, files: &mut Vec<PathBuf>) -> Result<Option<Project>, Error> {
        let mut workspace = Workspace::new(self.check.config.clone(), Overrides::default())?;
        let project = workspace.project_of(&self.file)?;
        files.extend(workspace.inputs());
        drop(workspace);
        let Some(mut project) = project.and_then(Arc::into_inner) else { return Ok(None) };
        if !project.failures.is_empty() {
            return Err(project.failures.swap_remove(0).into());
        }
        Ok(Some(project))
    }

    fn profile(&self, name: &str, files: &mut Vec<PathBuf>) -> Result<Arc<Profile>, Error> {
        if profile::named(name).is_none() && Path::new(name).is_file() {
            files.push(name.into());
        }
        Ok(profile::open(name, Path::new(""))?)
    }
}

/// Warnings about a configuration, a line each. Its errors stop the run even with `--force`, because the intended check is
/// unknown.
fn config_findings(project: &Project, options: &Options) -> Result<Vec<String>, Error> {
    let findings = options.severities.apply(project.findings.clone());
    let subject = Subject::Text(project.config.source());
    let is_error = |finding: &Diagnostic| finding.severity == Severity::Error;
    refusal(subject.source().name(), &findings, is_error, |errors| text_of(subject, errors))?;
    let warnings = findings.iter().filter(|finding| finding.severity >= Severity::Warning);
    Ok(warnings.map(|finding| finding.line(subject.source(), |at| subject.span_of(at))).collect())
}

/// Adds the names of objects and entries from a file to the options.
pub(super) fn rename(options: &mut generate::Options, files: &mut Vec<PathBuf>) -> Result<(), Error> {
    let Some(path) = options.rename.take() else { return Ok(()) };
    files.push(path.clone());
    let text = read_text(&path, MAX_TOML_SIZE)?;
    let renamed = generate::renames(&text).map_err(|error| Error::Names { file: shown(&path), error })?;
    options.renamed.extend(renamed);
    Ok(())
}
