//! Findings in sections that do not describe entries.

use super::{DUPLICATE_KEY, DUPLICATE_SECTION};
use crate::diagnostic::{At, Diagnostic, Findings};
use crate::eds::keys::FieldKey;
use crate::eds::misspelt;
use crate::eds::section::SectionName;
use crate::ini::findings::lines::is_merge_mark;
use crate::ini::findings::{JUNK_LINE, KEY_BEFORE_SECTION};
use crate::ini::{LineKind, Lines, headers};
use crate::model::Part;

/// Marks repeated keys and sections, and lines that are not keys, as [understood](Diagnostic::understood) if no entry
/// can depend on them: in `[FileInfo]`, `[Comments]` and the like, before the first section and in comments.
pub fn idle(text: &str, findings: Findings) -> Findings {
    let rules = [&JUNK_LINE, &DUPLICATE_KEY, &DUPLICATE_SECTION];
    let is_meant = |finding: &Diagnostic| rules.iter().any(|rule| rule.id == finding.rule.id);
    if !findings.iter().any(is_meant) {
        return findings;
    }
    let sections: Vec<(u32, bool)> = headers(text)
        .filter_map(|line| match line.kind {
            LineKind::Section { name } => Some((line.span.start, is_idle(name.of(text)))),
            _ => None,
        })
        .collect();
    // keys below a possible header
    let has_headless_key = findings.iter().any(|finding| finding.rule.id == KEY_BEFORE_SECTION.id);
    let is_beside = |finding: &Diagnostic| {
        let Some(At::Span(at)) = finding.labels.first().map(|label| &label.at) else { return false };
        let above = sections.partition_point(|&(start, _)| start <= at.start).checked_sub(1);
        let is_object = above.is_some_and(|above| !sections[above].1);
        let line = at.of(text);
        match finding.rule.id == JUNK_LINE.id {
            false => !is_object,
            true if is_merge_mark(line) => false,
            true if above.is_none() && !has_headless_key => true,
            true if may_begin_object(line) => false,
            true => !is_object || is_prose(line, &text[..at.start as usize]),
        }
    };
    findings.filter_map(|finding| {
        let is_idle = is_meant(&finding) && is_beside(&finding);
        Some(if is_idle { finding.understood() } else { finding })
    })
}

/// Whether no generated table depends on a section.
fn is_idle(name: &str) -> bool {
    !matches!(
        SectionName::parse(name).part,
        Part::Object(_)
            | Part::Entry(..)
            | Part::CompactNames(_)
            | Part::CompactValues(_)
            | Part::CompactDenotations(_)
            | Part::Commissioning
    )
}

/// Whether a line that is not a key may be the malformed header of an object or a merge marker.
fn may_begin_object(line: &str) -> bool {
    let name = line.trim_matches(|c: char| !c.is_ascii_alphanumeric());
    line.trim_end().ends_with(']') || !is_idle(name)
}

/// The maximum number of examined lines of a wrapped comment.
const MOST_WRAPPED: usize = 8;

/// Whether a line that is not a key cannot be intended as one: it has no letter or digit, or continues a wrapped
/// comment, and its first word is neither a number nor similar to a key.
fn is_prose(line: &str, before: &str) -> bool {
    let is_word = |word: &str| {
        let is_number = word.starts_with(|c: char| c.is_ascii_digit());
        !is_number && FieldKey::find(word).is_none() && misspelt::key(&Part::Object(0), word).is_none()
    };
    let continues = || {
        let mut kinds = before.lines().rev().take(MOST_WRAPPED).filter_map(|line| Lines::new(line).next());
        let above = kinds.find(|line| line.kind != LineKind::Junk);
        above.is_some_and(|line| line.kind == LineKind::Comment)
    };
    match line.split(|c: char| !c.is_ascii_alphanumeric()).find(|word| !word.is_empty()) {
        Some(first) => is_word(first) && continues(),
        None => line.is_ascii(),
    }
}
