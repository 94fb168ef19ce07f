//! The rules about labels and languages.

use std::collections::HashSet;

use crate::diagnostic::{Diagnostic, Findings, text_rules};
use crate::xml::{Attribute, Element, n};

use super::walk::Walk;

text_rules! {
    source: "CiA 311 annex A";

    "cia311/duplicate-label" = DUPLICATE_LABEL, Warning;
    summary: "a label or description is defined twice in one language",
    checks: "An element may have at most one `label` and one `description` per language.",
    why: "Some tools show the first one, some the last one.",
    example: r#"`<label lang="en">Speed</label><label lang="en">Velocity</label>`"#,
    remedy: "Keep one of them, or correct the language of the other.",

    "cia311/unlisted-language" = UNLISTED_LANGUAGE, Note;
    summary: "a text is in a language that the file does not list",
    checks: "If the profile body has `supportedLanguages`, the language of each `label` and `description` must be in it. Each language is reported once.",
    why: "Tools that offer the listed languages never show the text.",
    example: r#"`<label lang="de">` in a body with `supportedLanguages="en"`"#,
    remedy: "Add the language to `supportedLanguages`.",

    "cia311/dangling-dictionary-ref" = DANGLING_DICTIONARY_REF, Warning;
    summary: "a text refers to a dictionary that does not exist",
    checks: "A `dictionary` must exist with the `dictID` of each `labelRef` and `descriptionRef`.",
    why: "Tools have no text to show.",
    example: r#"`<labelRef dictID="texts" textID="speed"/>` without a `dictionaryList`"#,
    remedy: "Correct the id, or add the dictionary to `DeviceFunction/dictionaryList`.",
}

/// The languages found so far that the bodies of a container do not list.
#[derive(Default)]
pub(super) struct Languages<'a> {
    unlisted: Vec<(Element<'a>, String)>,
}

/// Checks the names and descriptions of an element.
pub(super) fn check<'a>(
    element: Element<'a>,
    body: Option<Element<'a>>,
    languages: &mut Languages<'a>,
    findings: &mut Findings,
) {
    let is_text = |child: &Element<'_>| matches!(child.tag(), n::label | n::description);
    let mut before: Vec<Element<'a>> = Vec::new();
    for child in element.children().filter(is_text) {
        let Some(language) = child.attribute(n::lang) else { continue };
        let text = language.value();
        let first = before.iter().find(|first| {
            let other = first.attribute(n::lang).map(Attribute::value);
            first.tag() == child.tag()
                && other.is_some_and(|other| other.trim_ascii().eq_ignore_ascii_case(text.trim_ascii()))
        });
        if let Some(first) = first {
            let message =
                format!("`{}` has two `{}` elements in the language `{text}`", element.name(), child.name());
            let finding = Diagnostic::new(&DUPLICATE_LABEL, language.value_span(), message);
            let finding = finding.label(first.tag_span(), "first here");
            findings.push(finding.help("keep one of them or correct the language of the other"));
        }
        // a hostile file can have thousands
        if before.len() < 64 {
            before.push(child);
        }
        if let Some(body) = body {
            check_language(child, text.trim_ascii(), body, languages, findings);
        }
    }
}

fn check_language<'a>(
    child: Element<'a>,
    language: &str,
    body: Element<'a>,
    languages: &mut Languages<'a>,
    findings: &mut Findings,
) {
    let Some(listed) = body.attribute(n::supportedLanguages) else { return };
    let value = listed.value();
    let is_same = |one: &str| {
        let primary = |tag: &str| tag.split(['-', '_']).next().unwrap_or_default().to_ascii_lowercase();
        one.eq_ignore_ascii_case(language) || primary(one) == primary(language)
    };
    if language.is_empty() || value.split_ascii_whitespace().any(is_same) {
        return;
    }
    let is_known = |(known, text): &(Element<'_>, String)| known.id() == body.id() && text == language;
    if languages.unlisted.len() < 64 && !languages.unlisted.iter().any(is_known) {
        languages.unlisted.push((body, language.to_owned()));
        let at = child.attribute(n::lang).map_or(child.name_span(), Attribute::value_span);
        let message = format!("the language `{language}` is not in `supportedLanguages`");
        let finding = Diagnostic::new(&UNLISTED_LANGUAGE, at, message);
        let help = format!("add `{language}` to `supportedLanguages`");
        findings.push(finding.label(listed.value_span(), "the languages of the profile").help(help));
    }
}

/// Whether all dictionaries exist that texts refer to.
pub(super) fn check_dictionaries(walk: &mut Walk<'_, '_>) {
    let dictionaries = walk.seen.of([n::dictionary]);
    let ids: HashSet<_> =
        dictionaries.filter_map(|dictionary| Some(dictionary.attribute(n::dictID)?.value())).collect();
    for text in walk.seen.of([n::labelRef, n::descriptionRef]) {
        let Some(id) = text.attribute(n::dictID) else { continue };
        let value = id.value();
        if !ids.contains(&value) {
            let message = format!("the dictionary `{value}` does not exist");
            let finding = Diagnostic::new(&DANGLING_DICTIONARY_REF, id.value_span(), message);
            walk.findings.push(finding.help("correct the id or add the dictionary to `dictionaryList`"));
        }
    }
}
