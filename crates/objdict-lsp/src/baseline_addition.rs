//! Findings that become known ones: an action of the editor.

use super::baseline::read;
use super::beside::created;
use super::file::CheckedFile;
use super::protocol::WorkspaceEdit;
use super::uri::of_path;
use super::workspace::EditorWorkspace;
use objdict_project::baseline::name_in;

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
