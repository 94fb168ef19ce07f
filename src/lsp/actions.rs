//! Quick fixes and other changes of a file.

use lsp_types::{CodeAction, CodeActionKind, CodeActionOrCommand, Diagnostic};
use serde::{Deserialize, Serialize};

use super::diagnostics::Maker;
use super::edits;
use super::file::File;
use crate::check::insertion;
use crate::diagnostic::{self, Applicability, Findings, Fix};
use crate::format::{self, Description};
use crate::registry;
use crate::source::{SourceFile, Span};

/// So many findings of a range get quick fixes: each is tried on the text.
const MAX_TRIED: usize = 20;

/// Which findings an action fixes that is made when the user chooses it.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Fixes {
    /// All that have a safe fix.
    Safe,
    /// All, also with fixes that need review.
    Unsafe,
    /// Those of a rule.
    OfRule(String),
}

/// What an action needs when it is resolved.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Wanted {
    pub(super) uri: String,
    fixes: Fixes,
}

/// The actions in a range of a file.
pub(super) fn actions(file: &File, span: Span, only: Option<&[CodeActionKind]>) -> Vec<CodeActionOrCommand> {
    let Some(description) = file.description() else { return Vec::new() };
    let is_asked = |kind: &CodeActionKind| {
        only.is_none_or(|only| only.iter().any(|asked| kind.as_str().starts_with(asked.as_str())))
    };
    let mut actions = Vec::new();
    if is_asked(&CodeActionKind::QUICKFIX) {
        actions.extend(quick_fixes(file, description, span));
    }
    let has_fix = file.analysis.findings.iter().flatten().any(|finding| finding.fix.is_some());
    let fix_all = CodeActionKind::SOURCE_FIX_ALL;
    if has_fix && is_asked(&fix_all) {
        actions.push(later(file, "fix all findings that have a safe fix", Fixes::Safe, fix_all));
        let title = "fix all findings, also with unsafe fixes";
        actions.push(later(file, title, Fixes::Unsafe, CodeActionKind::new("source.fixAllUnsafe")));
    }
    if is_asked(&CodeActionKind::REFACTOR) {
        actions.extend(edits::refactorings(file, description, span.start));
    }
    actions.into_iter().map(CodeActionOrCommand::CodeAction).collect()
}

/// An action whose edits are made when it is chosen.
fn later(file: &File, title: &str, fixes: Fixes, kind: CodeActionKind) -> CodeAction {
    let wanted = Wanted { uri: file.uri.as_str().to_owned(), fixes };
    let data = serde_json::to_value(wanted).ok();
    CodeAction { title: title.to_owned(), kind: Some(kind), data, ..CodeAction::default() }
}

/// The fixes of findings that touch a range, and comments that suppress them.
fn quick_fixes(file: &File, description: &Description, span: Span) -> Vec<CodeAction> {
    let subject = file.analysis.subject();
    let maker = Maker { subject, uri: &file.uri, unit: file.unit };
    let at = |finding: &diagnostic::Diagnostic| {
        finding.labels.first().map(|label| subject.span_of(&label.at)).unwrap_or_default()
    };
    let findings = file.analysis.findings.first().map(Findings::iter).unwrap_or_default();
    let is_here = |finding: &&diagnostic::Diagnostic| {
        let at = at(finding);
        at.start <= span.end && span.start <= at.end
    };
    let here: Vec<&diagnostic::Diagnostic> = findings.filter(is_here).take(MAX_TRIED).collect();
    let mut actions = Vec::new();
    for finding in &here {
        let made = maker.of_finding(finding);
        actions.extend(fix(file, description, finding, &made));
    }
    for finding in &here {
        let made = maker.of_finding(finding);
        let rule = finding.rule.id;
        if finding.fix.is_some() {
            let title = format!("fix all findings of {rule}");
            let fix_rule = later(file, &title, Fixes::OfRule(rule.to_owned()), CodeActionKind::QUICKFIX);
            if actions.iter().all(|action: &CodeAction| action.title != title) {
                actions.push(CodeAction { diagnostics: Some(vec![made.clone()]), ..fix_rule });
            }
        }
        if let Some(edit) = insertion(description, at(finding).start, rule) {
            actions.push(CodeAction {
                title: format!("allow {rule} here, with a comment"),
                kind: Some(CodeActionKind::QUICKFIX),
                diagnostics: Some(vec![made]),
                edit: Some(file.workspace_edit(file.edits(vec![edit]))),
                ..CodeAction::default()
            });
        }
    }
    actions
}

/// The fix of a finding, where it fixes the finding and causes no other.
fn fix(
    file: &File,
    description: &Description,
    finding: &diagnostic::Diagnostic,
    made: &Diagnostic,
) -> Option<CodeAction> {
    let fix: &Fix = finding.fix.as_ref()?;
    let edits = description.edits(fix)?;
    let is_it = |other: &diagnostic::Diagnostic| {
        std::ptr::eq(other.rule, finding.rule) && other.labels == finding.labels
    };
    let findings = file.analysis.findings.first()?.clone();
    let alone = findings.filter_map(|mut other| {
        other.fix = other.fix.take().filter(|_| is_it(&other));
        Some(other)
    });
    let tried = crate::with_sound_fixes(description, alone, |text| file.analysis.check(text));
    let is_sound =
        tried.iter().any(|other| is_it(other) && other.fix.as_ref().is_some_and(|fix| fix.is_offered));
    if !is_sound {
        return None;
    }
    let is_safe = fix.safety == Applicability::Safe;
    let note = if is_safe { "" } else { " (unsafe)" };
    Some(CodeAction {
        title: format!("{}{note}", fix.title.shown()),
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![made.clone()]),
        edit: Some(file.workspace_edit(file.edits(edits))),
        is_preferred: Some(is_safe),
        ..CodeAction::default()
    })
}

/// The edits of an action that was chosen.
pub(super) fn resolve(file: &File, mut action: CodeAction, wanted: &Wanted) -> CodeAction {
    if let Some(text) = file.description().and_then(|_| text_after(file, &wanted.fixes)) {
        action.edit = Some(file.workspace_edit(file.edits_to(&text)));
    }
    action
}

/// The text after fixes.
fn text_after(file: &File, fixes: &Fixes) -> Option<String> {
    let options = &file.analysis.options;
    let source = SourceFile::from_text(file.source().name(), file.text());
    let description = format::read(source, file.description()?.format());
    let fixed = match fixes {
        Fixes::Safe => crate::fix_for_readers(description, Applicability::Safe, options),
        Fixes::Unsafe => crate::fix_for_readers(description, Applicability::Unsafe, options),
        Fixes::OfRule(rule) => {
            let rule = registry::rule(rule)?;
            let safety = match rule.fix.is_some_and(|fix| fix.has(Applicability::Safe)) {
                true => Applicability::Safe,
                false => Applicability::Unsafe,
            };
            let check = |text: &Description| {
                crate::check_with(text, options).filter_map(|mut finding| {
                    finding.fix = finding.fix.take().filter(|_| finding.rule.id == rule.id);
                    Some(finding)
                })
            };
            crate::fix(description, safety, check)
        }
    };
    Some(fixed.description.source().text().to_owned())
}
