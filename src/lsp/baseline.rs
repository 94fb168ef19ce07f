//! Findings that are known: the editor names a baseline, and shows what came since.

use std::path::Path;

use lsp_types::WorkspaceEdit;

use super::analysis::Analysis;
use super::beside::created;
use super::file::File;
use super::uri::of_path;
use super::workspace::Workspace;
use crate::baseline::{Baseline, MAX_SIZE, folder_of, name_in};
use crate::source::read_text;

/// Takes the findings away that a baseline has; one that cannot be read has none.
pub(super) fn sift(path: &Path, analysis: &mut Analysis) {
    let Some(baseline) = read_text(path, MAX_SIZE).ok().and_then(|text| Baseline::read(&text).ok()) else {
        return;
    };
    let is_gone = |file: &str| !folder_of(path).join(file).exists();
    let left = analysis.map_subjects(|subject, findings| {
        let mut findings = findings.clone();
        baseline.suppress(&name_in(path, subject.source().name()), subject, &mut findings, is_gone);
        findings
    });
    analysis.findings = left;
}

/// Adds the findings of a rule in a file to the baseline of the editor; a file that is no baseline stays as it is.
pub(super) fn addition(file: &File, workspace: &mut Workspace, rule: &str) -> Option<WorkspaceEdit> {
    let path = workspace.baseline.clone()?;
    let old = workspace.reading(|| read_text(&path, MAX_SIZE).ok());
    let mut baseline = match &old {
        Some(text) => Baseline::read(text).ok()?,
        None => Baseline::default(),
    };
    // with those that are known, by whose number the others of the same kind are known
    let all = workspace.reading(|| file.again(file.text()));
    all.analysis.map_subjects(|subject, findings| {
        let of_rule = findings.clone().filter_map(|finding| (finding.rule.id == rule).then_some(finding));
        baseline.add(&name_in(&path, file.source().name()), subject, &of_rule);
    });
    let text = baseline.write();
    match old {
        Some(_) => {
            let known = workspace.file(&of_path(&path)?)?;
            Some(known.workspace_edit(known.edits_to(&text)))
        }
        None if workspace.client.creates_files => created(&path, &text),
        None => None,
    }
}
