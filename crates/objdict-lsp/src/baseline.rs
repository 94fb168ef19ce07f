//! Findings that are known: the editor names a baseline, and shows what came since.

use std::io::ErrorKind;
use std::path::Path;

use super::analysis::{Analysis, ReadProblem};
use super::beside::created;
use super::file::CheckedFile;
use super::protocol::WorkspaceEdit;
use super::uri::of_path;
use super::workspace::EditorWorkspace;
use objdict_model::source::{SourceError, Span, read_text, shown};
use objdict_project::baseline::{Baseline, MAX_SIZE, name_in};

/// Takes the findings away that a baseline has; one that cannot be read is an error of each file.
pub(super) fn sift(path: &Path, analysis: &mut Analysis) {
    let baseline = match read(path) {
        Ok(Some(baseline)) => baseline,
        Ok(None) => return,
        Err(message) => {
            let help = Some(format!("`objdict check --write-baseline {}` writes it anew", shown(path)));
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
fn read(path: &Path) -> Result<Option<Baseline>, String> {
    let text = match read_text(path, MAX_SIZE) {
        Ok(text) => text,
        Err(SourceError::Io { error, .. }) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error.to_string()),
    };
    Baseline::read(&text).map(Some).map_err(|error| format!("`{}` {error}", shown(path)))
}

/// Adds the findings of a rule in a file to the baseline of the editor; a file that is no baseline stays as it is.
pub(super) fn addition(
    file: &CheckedFile,
    workspace: &mut EditorWorkspace,
    rule: &str,
) -> Option<WorkspaceEdit> {
    let path = workspace.baseline.clone()?;
    let old = workspace.reading(|| read(&path)).ok()?;
    let is_new = old.is_none();
    let mut baseline = old.unwrap_or_default();
    // with those that are known, by whose number the others of the same kind are known
    let all = workspace.reading(|| file.again(file.text()));
    all.analysis.map_subjects(|subject, findings| {
        let of_rule = findings.clone().filter_map(|finding| (finding.rule.id == rule).then_some(finding));
        baseline.add(&name_in(&path, file.source().name()), subject, &of_rule);
    });
    let text = baseline.write();
    if is_new {
        return if workspace.client.creates_files { created(&path, &text) } else { None };
    }
    let known = workspace.file(&of_path(&path)?)?;
    Some(known.workspace_edit(known.edits_to(&text)))
}
