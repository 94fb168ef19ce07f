//! Findings as the JSON document of `objdict check --format json`.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use objdict::check_with;
use objdict::config::{Config, Project};
use objdict::diagnostic::{Findings, Severity};
use objdict::lint::{self, Severities};
use objdict::report::{Concise, Json, Report, Subject, grouped};
use pyo3::prelude::*;

use super::dictionary::{Described, NativeDictionary, Shared, described, reading};
use super::raised;

/// The findings of a device.
#[pyfunction]
pub(crate) fn findings(py: Python<'_>, of: &NativeDictionary) -> PyResult<String> {
    py.detach(|| {
        let (subject, findings) = findings_of(&of.0)?;
        document(|report| report.file(subject, &findings))
    })
}

/// The errors of a device, a line each; empty without one.
#[pyfunction]
pub(crate) fn errors(py: Python<'_>, of: &NativeDictionary) -> PyResult<String> {
    py.detach(|| {
        let (subject, findings) = findings_of(&of.0)?;
        errors_among(subject, findings)
    })
}

/// The errors among findings, a line each.
pub(crate) fn errors_among(subject: Subject<'_>, findings: Findings) -> PyResult<String> {
    let is_error = |severity: Severity| severity == Severity::Error;
    let errors = findings.filter_map(|finding| is_error(finding.severity).then_some(finding));
    let mut text = Vec::new();
    Concise::new(&mut text).file(subject, &errors).map_err(raised)?;
    String::from_utf8(text).map_err(raised)
}

/// The findings of files, as `objdict check` reports them. Which files are below folders is found by Python.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, paths: Vec<PathBuf>) -> PyResult<String> {
    py.detach(|| {
        let mut projects = BTreeMap::new();
        document(|report| {
            paths.iter().try_for_each(|path| add(report, path, &mut projects))?;
            // several folders may have one configuration
            let named = projects.values().flatten().map(|project| (project.config.source().name(), project));
            let named: BTreeMap<&str, &Arc<Project>> = named.collect();
            named
                .values()
                .try_for_each(|project| report.file(project.config.source().into(), &project.findings))
        })
    })
}

/// Each device of a file is checked; the findings of all are those of the file.
fn add(
    report: &mut impl Report,
    path: &Path,
    projects: &mut BTreeMap<PathBuf, Option<Arc<Project>>>,
) -> io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    let project = match projects.get(&folder) {
        Some(known) => known.clone(),
        None => project_of(path).map_err(io::Error::other)?.map(Arc::new),
    };
    projects.insert(folder, project.clone());
    let reading = reading(None, None, None, project.as_deref());
    let bytes = objdict::source::read(path, reading.max_size).map_err(io::Error::other)?;
    let name = path.display().to_string();
    let (_, input) = reading.read(&name, bytes).map_err(io::Error::other)?;
    let first =
        described(&name, input, Some(path.to_owned()), &reading, project).map_err(io::Error::other)?;
    let Described::Text(description) = &first.described else {
        let (subject, findings) = findings_of(&first).map_err(io::Error::other)?;
        return report.file(subject, &findings);
    };
    let options = options(&first);
    let all = description.map_devices(|device| grouped(device, check_with(device, &options)));
    all.into_iter().try_for_each(|findings| report.file((&**description).into(), &findings))
}

/// The findings of a device with the nearest configuration, as `objdict check` reports them.
pub(crate) fn findings_of(shared: &Shared) -> PyResult<(Subject<'_>, Findings)> {
    let options = options(shared);
    Ok(match &shared.described {
        Described::Text(description) => {
            let subject = Subject::from(&**description);
            (subject, grouped(subject, check_with(description, &options)))
        }
        Described::Model(device, source) => {
            (Subject::Text(source), options.severities.apply(lint::check(device, &options)))
        }
    })
}

/// The nearest configuration of a file, with the profiles and patches that it names.
pub(crate) fn project_of(path: &Path) -> PyResult<Option<Project>> {
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    let Some(found) = Config::find(folder.unwrap_or(Path::new("."))) else { return Ok(None) };
    let mut project = Project::open(&found).map_err(raised)?;
    match project.failures.pop() {
        Some(failure) => Err(raised(failure)),
        None => Ok(Some(project)),
    }
}

/// What the configuration says of a file; bytes have none.
fn options(shared: &Shared) -> lint::Options {
    let mut options = lint::Options::default();
    if let (Some(path), Some(project)) = (&shared.path, &shared.project) {
        options = project.config.options(path, &Severities::default());
        options.profiles.extend(project.profiles.iter().cloned());
    }
    options.node_id = shared.node_id.filter(|id| (1..=127).contains(id)).or(options.node_id);
    options
}

/// A JSON document of findings.
pub(crate) fn document(add: impl FnOnce(&mut Json<&mut Vec<u8>>) -> std::io::Result<()>) -> PyResult<String> {
    let mut text = Vec::new();
    let mut report = Json::new(&mut text);
    add(&mut report).and_then(|()| report.finish()).map_err(raised)?;
    String::from_utf8(text).map_err(raised)
}
