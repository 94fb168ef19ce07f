//! Findings as the JSON document of `objdict check --format json`.

use std::io;
use std::path::{Path, PathBuf};

use objdict::check_with;
use objdict::diagnostic::{Findings, Severity};
use objdict::lint;
use objdict::report::{Concise, Json, Report, Subject, by_place};
use objdict::workspace::{self, Workspace};
use pyo3::prelude::*;

use super::dictionary::{NativeDictionary, described, project_of, reading};
use super::raised;
use super::shared::{Described, SharedDescription};

/// The findings of a device.
#[pyfunction]
pub(crate) fn findings(py: Python<'_>, of: &NativeDictionary) -> PyResult<String> {
    py.detach(|| {
        let shared = of.now();
        let (subject, findings) = findings_of(&shared)?;
        document(|report| report.file(subject, &findings))
    })
}

/// The errors of a device, a line each; empty without one.
#[pyfunction]
pub(crate) fn errors(py: Python<'_>, of: &NativeDictionary) -> PyResult<String> {
    py.detach(|| {
        let shared = of.now();
        let (subject, findings) = findings_of(&shared)?;
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
        let mut workspace = Workspace::default();
        document(|report| {
            paths.iter().try_for_each(|path| add(report, path, &mut workspace))?;
            workspace
                .projects()
                .try_for_each(|(_, project)| report.file(project.config.source().into(), &project.findings))
        })
    })
}

/// Each device of a file is checked; the findings of all are those of the file.
fn add(report: &mut impl Report, path: &Path, workspace: &mut Workspace) -> io::Result<()> {
    let project = project_of(workspace, path).map_err(io::Error::other)?;
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
    let all = workspace::findings(description, &first.options());
    let mut all = all.into_iter().map(|findings| by_place(&**description, findings));
    all.try_for_each(|findings| report.file((&**description).into(), &findings))
}

/// The findings of a device with the nearest configuration, as `objdict check` reports them.
pub(crate) fn findings_of(shared: &SharedDescription) -> PyResult<(Subject<'_>, Findings)> {
    let options = shared.options();
    Ok(match &shared.described {
        Described::Text(description) => {
            let subject = Subject::from(&**description);
            (subject, by_place(subject, check_with(description, &options)))
        }
        Described::Model(device, source) => {
            (Subject::Text(source), options.severities.apply(lint::check(device, &options)))
        }
    })
}

/// A JSON document of findings.
pub(crate) fn document(add: impl FnOnce(&mut Json<&mut Vec<u8>>) -> std::io::Result<()>) -> PyResult<String> {
    let mut text = Vec::new();
    let mut report = Json::new(&mut text);
    add(&mut report).and_then(|()| report.finish()).map_err(raised)?;
    String::from_utf8(text).map_err(raised)
}
