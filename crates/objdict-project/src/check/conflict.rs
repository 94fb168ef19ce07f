//! Merge conflicts: a file with their markers contains two versions, so only the markers can be checked.

use objdict_format::Description;
use objdict_model::diagnostic::{Diagnostic, Findings, Severity};

/// Whether a text has the markers of an unresolved merge conflict.
pub(crate) fn is_in(text: &str) -> bool {
    let has = |mark: &str| memchr::memmem::find(text.as_bytes(), mark.as_bytes()).is_some();
    let begins_line = |mark| has(mark) && text.lines().any(|line| line.starts_with(mark));
    begins_line("<<<<<<<") && begins_line(">>>>>>>")
}

/// The findings about the markers: keys, sections and counts of the two versions contradict each other. No finding has
/// a fix, because a fix could remove content that one of the versions needs.
pub(super) fn alone(description: &Description, findings: Findings) -> Findings {
    let text = description.source().text();
    if !is_in(text) {
        return findings;
    }
    let mut findings = findings.filter_map(|finding| Some(Diagnostic { fix: None, ..finding }));
    let is_mark = |finding: &Diagnostic| {
        let start = finding.labels.first().map_or(0, |label| description.span_of(&label.at).start);
        let marks: &[&str] = match finding.rule.id {
            "cia306/junk-line" => &["<<<<<<<", "=======", ">>>>>>>", "|||||||"],
            // the reader reports each character; the first one is the conflict
            "xml/lone-less-than" => &["<<<<<<<"],
            _ => &[],
        };
        marks.iter().any(|mark| text.get(start as usize..).is_some_and(|rest| rest.starts_with(mark)))
    };
    // rules may be disabled
    if findings.iter().any(|finding| is_mark(finding) && finding.severity == Severity::Error) {
        findings.remove_rules(|rule| !["cia306/junk-line", "xml/lone-less-than"].contains(&rule));
        let help = "resolve the merge conflict: keep one of the two versions and remove the markers";
        findings = findings.filter_map(|finding| is_mark(&finding).then(|| finding.help(help)));
    }
    findings
}
