//! Findings in sections that say nothing of an entry.

use super::{DUPLICATE_KEY, DUPLICATE_SECTION};
use crate::diagnostic::{At, Diagnostic, Findings};
use crate::eds::section::SectionName;
use crate::ini::findings::JUNK_LINE;
use crate::ini::findings::lines::is_merge_mark;
use crate::ini::{LineKind, headers};
use crate::model::Part;

/// Marks repeated keys and sections, and lines that are no key, as [understood](Diagnostic::understood) where no entry can depend on
/// them: in `[FileInfo]`, `[Comments]` and the like.
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
    let is_beside = |finding: &Diagnostic| {
        let Some(At::Span(at)) = finding.labels.first().map(|label| &label.at) else { return false };
        let above = sections.partition_point(|&(start, _)| start <= at.start).checked_sub(1);
        let is_object = above.is_some_and(|above| !sections[above].1);
        !is_object && (finding.rule.id != JUNK_LINE.id || !may_begin_object(at.of(text)))
    };
    findings.filter_map(|finding| {
        let is_idle = is_meant(&finding) && is_beside(&finding);
        Some(if is_idle { finding.understood() } else { finding })
    })
}

/// Whether a section has nothing that a table is made of.
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

/// Whether a line that is no key may be the malformed header of an object, or marks a merge.
fn may_begin_object(line: &str) -> bool {
    let name = line.trim_matches(|c: char| !c.is_ascii_alphanumeric());
    is_merge_mark(line) || line.trim_end().ends_with(']') || !is_idle(name)
}
