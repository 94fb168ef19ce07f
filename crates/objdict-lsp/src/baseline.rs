//! Findings that are known: the editor names a baseline, and shows what came since.

use std::io::ErrorKind;
use std::path::Path;

use super::analysis::{Analysis, ReadProblem};
use objdict_model::source::{SourceError, Span, read_text, shown};
use objdict_project::baseline::{Baseline, MAX_SIZE};

/// Takes the findings away that a baseline has; one that cannot be read is an error of each file.
pub(super) fn sift(path: &Path, analysis: &mut Analysis) {
    let baseline = match read(path) {
        Ok(Some(baseline)) => baseline,
        Ok(None) => return,
        Err(message) => {
            let help = Some(format!("`objdict check --write-baseline {}` recreates it", shown(path)));
            return analysis.errors.push(ReadProblem { span: Span::default(), message, help });
        }
    };
    let left = analysis.map_subjects(|subject, findings| {
        let mut findings = findings.clone();
        baseline.suppress_beside(path, subject, &mut findings);
        findings
    });
    analysis.findings = left;
}

/// The baseline of a file; `None` before there is one, or why it cannot be read.
pub(super) fn read(path: &Path) -> Result<Option<Baseline>, String> {
    let text = match read_text(path, MAX_SIZE) {
        Ok(text) => text,
        Err(SourceError::Io { error, .. }) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error.to_string()),
    };
    Baseline::read(&text).map(Some).map_err(|error| format!("`{}` {error}", shown(path)))
}
