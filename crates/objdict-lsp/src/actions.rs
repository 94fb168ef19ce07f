//! Quick fixes and other changes of a file.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::beside::{self, OtherSyntax};
use super::diagnostics::DiagnosticMaker;
use super::file::CheckedFile;
use super::protocol::{CodeAction, FIX_ALL, QUICKFIX, REFACTOR, WorkspaceEdit};
use super::workspace::EditorWorkspace;
use super::{baseline_addition, documentation, edits};
use objdict_format as format;
use objdict_format::Description;
use objdict_model::diagnostic;
use objdict_model::diagnostic::{Applicability, Findings, Fix, RuleInfo};
use objdict_model::source::{SourceFile, Span};
use objdict_project::check::insertion;
use objdict_project::registry;
use objdict_project::report::Subject;

/// So many findings of a range get quick fixes: each is tried on the text.
const MAX_TRIED: usize = 20;

/// Fixes of all findings, which an editor does not make when a file is saved.
pub(super) const FIX_ALL_UNSAFE: &str = "source.fixAllUnsafe";

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

/// What an action does that is made when the user chooses it.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Work {
    Fix(Fixes),
    /// Writes the entries of an object out of compact storage, or stores them so.
    Store(u16),
    /// Writes the description in another syntax into a new file.
    Convert(OtherSyntax),
    /// Adds the node of a DCF to the network of its folder.
    AddNode,
    /// Adds the findings of a rule to the baseline.
    AddToBaseline(String),
}

/// What an action needs when it is resolved.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct WantedAction {
    pub(super) uri: String,
    work: Work,
}

/// The actions in a range of a file.
pub(super) fn actions(
    file: &CheckedFile,
    workspace: &EditorWorkspace,
    span: Span,
    only: Option<&[String]>,
) -> Vec<CodeAction> {
    // `source` asks for `source.fixAll`, which does not ask for `source.fixAllUnsafe`
    let is_in = |kind: &str, asked: &String| {
        let rest = kind.strip_prefix(asked.as_str());
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    let is_asked = |kind: &str| only.is_none_or(|only| only.iter().any(|asked| is_in(kind, asked)));
    let mut actions = Vec::new();
    if is_asked(QUICKFIX) {
        actions.extend(quick_fixes(file, span));
        actions.extend(known(file, workspace, span));
    }
    let Some(description) = file.description() else { return actions };
    let has_fix = file.analysis.findings.iter().flatten().any(|finding| finding.fix.is_some());
    for (title, fixes, kind) in [
        ("fix all findings that have a safe fix", Fixes::Safe, FIX_ALL),
        ("fix all findings, also with unsafe fixes", Fixes::Unsafe, FIX_ALL_UNSAFE),
    ] {
        if has_fix && is_asked(kind) {
            actions.push(later(file, title, Work::Fix(fixes), kind));
        }
    }
    if is_asked(REFACTOR) {
        let refactor = |title: &str, work| later(file, title, work, REFACTOR);
        actions.extend(edits::refactorings(file, description, span.start));
        let storage = edits::storage(file, description, span.start);
        actions.extend(storage.map(|(index, title)| refactor(&title, Work::Store(index))));
        if workspace.client.creates_files {
            let targets = beside::targets(file, description).into_iter();
            actions.extend(targets.map(|target| refactor(&target.title(file), Work::Convert(target))));
            if beside::is_node(description) {
                actions.push(refactor("add the node to the network of the folder", Work::AddNode));
            }
        }
    }
    if workspace.client.shows_documents && is_asked(documentation::KIND) {
        actions.push(documentation::action(file));
    }
    actions
}

/// An action whose edits are made when it is chosen.
fn later(file: &CheckedFile, title: &str, work: Work, kind: &'static str) -> CodeAction {
    let wanted = WantedAction { uri: file.uri.clone(), work };
    let data = serde_json::to_value(wanted).ok();
    CodeAction { title: title.to_owned(), kind, data, ..CodeAction::default() }
}

/// Adding the findings of a range to the baseline, if there is one.
fn known(file: &CheckedFile, workspace: &EditorWorkspace, span: Span) -> Vec<CodeAction> {
    let Some(name) = workspace.baseline.as_deref().and_then(Path::file_name) else { return Vec::new() };
    let mut rules = Vec::new();
    file.analysis.map_subjects(|subject, findings| {
        let is_here = |finding: &&diagnostic::Diagnostic| {
            let at = finding.labels.first().map(|label| subject.span_of(&label.at)).unwrap_or_default();
            at.start <= span.end && span.start <= at.end
        };
        rules.extend(findings.iter().filter(is_here).map(|finding| finding.rule.id));
    });
    rules.sort_unstable();
    rules.dedup();
    let action = |rule: &str| {
        let title = format!("add the findings of {rule} in this file to `{}`", name.to_string_lossy());
        later(file, &title, Work::AddToBaseline(rule.to_owned()), QUICKFIX)
    };
    rules.into_iter().map(action).collect()
}

/// The fixes of findings that touch a range, and comments that suppress them; of each device of a file.
fn quick_fixes(file: &CheckedFile, span: Span) -> Vec<CodeAction> {
    let mut left = MAX_TRIED;
    let mut actions = Vec::new();
    file.analysis.map_subjects(|subject, findings| {
        let at = |finding: &diagnostic::Diagnostic| {
            finding.labels.first().map(|label| subject.span_of(&label.at)).unwrap_or_default()
        };
        let is_here = |finding: &&diagnostic::Diagnostic| {
            let at = at(finding);
            at.start <= span.end && span.start <= at.end
        };
        let here: Vec<&diagnostic::Diagnostic> = findings.iter().filter(is_here).take(left).collect();
        left -= here.len();
        let maker = DiagnosticMaker { subject, uri: &file.uri, unit: file.unit };
        for finding in here {
            of_finding(file, &maker, findings, (finding, at(finding)), &mut actions);
        }
    });
    // what fixes a finding comes before what hides it
    actions.sort_by_key(|action| action.edit.is_none() || action.title.starts_with("allow "));
    actions
}

/// What can be done about a finding at its place.
fn of_finding(
    file: &CheckedFile,
    maker: &DiagnosticMaker<'_>,
    findings: &Findings,
    (finding, at): (&diagnostic::Diagnostic, Span),
    actions: &mut Vec<CodeAction>,
) {
    let made = maker.of_finding(finding);
    let rule = finding.rule.id;
    let quick = |title: String, edits: Vec<(Span, String)>| CodeAction {
        title,
        kind: QUICKFIX,
        diagnostics: Some(vec![made.clone()]),
        edit: Some(file.workspace_edit(file.edits(edits))),
        ..CodeAction::default()
    };
    if let Some(meant) = meant(file, finding, at) {
        actions.push(CodeAction {
            is_preferred: Some(true),
            ..quick(format!("replace it with `{meant}`"), vec![(at, meant)])
        });
    }
    let Subject::Description(description) = maker.subject else {
        let edits = finding.fix.as_ref().and_then(|fix| Some((fix, fix.replacements()?)));
        actions.extend(edits.map(|(fix, edits)| quick(fix.title.shown().into_owned(), edits)));
        return;
    };
    actions.extend(fix(file, description, findings, finding).map(|(fix, edits)| {
        let is_safe = fix.safety == Applicability::Safe;
        let title = format!("{}{}", fix.title.shown(), note(fix.safety));
        CodeAction { is_preferred: Some(is_safe), ..quick(title, edits) }
    }));
    if finding.fix.is_some() {
        let title = format!("fix all findings of {rule}{}", note(safety(finding.rule)));
        if actions.iter().all(|action| action.title != title) {
            let work = Work::Fix(Fixes::OfRule(rule.to_owned()));
            let fix_rule = later(file, &title, work, QUICKFIX);
            actions.push(CodeAction { diagnostics: Some(vec![made.clone()]), ..fix_rule });
        }
    }
    if let Some(edit) = insertion(description, at.start, rule) {
        actions.push(quick(format!("allow {rule} here with a comment"), vec![edit]));
    }
}

/// How safe the fixes of all findings of a rule are that are made at once.
fn safety(rule: &RuleInfo) -> Applicability {
    match rule.fix.is_some_and(|fix| fix.has(Applicability::Safe)) {
        true => Applicability::Safe,
        false => Applicability::Unsafe,
    }
}

/// What the title of an action says of its safety.
const fn note(safety: Applicability) -> &'static str {
    match safety {
        Applicability::Safe => "",
        Applicability::Unsafe => " (unsafe)",
    }
}

/// The edits of the fix of a finding, where it fixes the finding and causes no other.
fn fix<'f>(
    file: &CheckedFile,
    description: &Description,
    findings: &Findings,
    finding: &'f diagnostic::Diagnostic,
) -> Option<(&'f Fix, Vec<(Span, String)>)> {
    let fix = finding.fix.as_ref()?;
    let edits = description.edits(fix)?;
    let is_it = |other: &diagnostic::Diagnostic| {
        std::ptr::eq(other.rule, finding.rule) && other.labels == finding.labels
    };
    let alone = findings.clone().filter_map(|mut other| {
        other.fix = other.fix.take().filter(|_| is_it(&other));
        Some(other)
    });
    let tried = objdict_project::with_sound_fixes(description, alone, |text| file.analysis.check(text));
    let is_sound =
        tried.iter().any(|other| is_it(other) && other.fix.as_ref().is_some_and(|fix| fix.is_offered));
    is_sound.then_some((fix, edits))
}

/// The word that a finding asks for in place of a misspelled one, if the file has one finding less with it and no other.
fn meant(file: &CheckedFile, finding: &diagnostic::Diagnostic, at: Span) -> Option<String> {
    let help = finding.help.as_ref()?.shown();
    let word = help.strip_prefix("did you mean `")?.strip_suffix("`?")?;
    let text = at.of(file.text());
    let quote = text.chars().next().filter(|first| matches!(first, '"' | '\''));
    let quote = quote.map(String::from).unwrap_or_default();
    let new = format!("{quote}{word}{quote}");
    let after = file.again_with(&[(at, new.clone())])?;
    let counts = |file: &CheckedFile| {
        let mut counts = BTreeMap::new();
        for found in file.analysis.findings.iter().flatten() {
            *counts.entry(found.rule.id).or_insert(0_usize) += 1;
        }
        (counts, file.analysis.errors.len())
    };
    let (mut before, errors) = counts(file);
    let (after, errors_after) = counts(&after);
    *before.get_mut(finding.rule.id)? -= 1;
    let causes_none =
        after.iter().all(|(rule, count)| before.get(rule).is_some_and(|before| count <= before));
    (causes_none && errors_after <= errors).then_some(new)
}

/// The edits of an action that was chosen.
pub(super) fn resolve(
    file: &CheckedFile,
    workspace: &mut EditorWorkspace,
    wanted: &WantedAction,
) -> Option<WorkspaceEdit> {
    match &wanted.work {
        Work::Fix(fixes) => workspace.reading(|| {
            let text = file.description().and_then(|_| text_after(file, fixes))?;
            Some(file.workspace_edit(file.edits_to(&text)))
        }),
        Work::Store(index) => edits::restored(file, *index).map(|edits| file.workspace_edit(edits)),
        Work::Convert(target) => workspace.reading(|| target.edit(file)),
        Work::AddNode => beside::add_node(file, workspace),
        Work::AddToBaseline(rule) => baseline_addition::addition(file, workspace, rule),
    }
}

/// The text after fixes.
fn text_after(file: &CheckedFile, fixes: &Fixes) -> Option<String> {
    let options = &file.analysis.options;
    let source = SourceFile::from_text(file.source().name(), file.text());
    let description = format::read(source, file.description()?.format());
    let fixed = match fixes {
        Fixes::Safe => objdict_project::fix_for_readers(description, Applicability::Safe, options),
        Fixes::Unsafe => objdict_project::fix_for_readers(description, Applicability::Unsafe, options),
        Fixes::OfRule(rule) => {
            let rule = registry::rule(rule)?;
            let check = |text: &Description| {
                objdict_project::check_with(text, options).filter_map(|mut finding| {
                    finding.fix = finding.fix.take().filter(|_| finding.rule.id == rule.id);
                    Some(finding)
                })
            };
            objdict_project::fix(description, safety(rule), check)
        }
    };
    Some(fixed.description.source().text().to_owned())
}
