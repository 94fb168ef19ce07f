//! Reports of findings: one module per format. A report receives checked files one by one and writes immediately, so
//! the findings of a thousand files are never in memory at once.

mod concise;
mod consequences;
#[cfg(feature = "full")]
mod fingerprint;
mod github;
#[cfg(feature = "full")]
mod gitlab;
mod group;
#[cfg(feature = "full")]
mod json;
#[cfg(feature = "xdd")]
mod junit;
#[cfg(feature = "network")]
mod of_network;
mod path;
#[cfg(any(test, not(feature = "text")))]
#[cfg_attr(feature = "text", allow(unreachable_pub, reason = "`text` takes its place"))]
mod plain;
#[cfg(feature = "full")]
mod sarif;
mod statistics;
mod subject;
#[cfg(feature = "text")]
mod text;
#[cfg(feature = "full")]
mod utf16;

use std::borrow::Cow;
use std::fmt;
use std::io;

use objdict_model::diagnostic::{Diagnostic, Findings, Severity, SourceLabel, plural};
use objdict_model::model::Place;
use objdict_model::source::{LineColumn, SourceFile, Span};

pub use concise::Concise;
pub use github::Github;
pub use group::{by_place, grouped};
#[cfg(feature = "schema")]
pub use json::CheckJson;
#[cfg(feature = "xdd")]
pub use junit::{Junit, TestCase, TestResult, junit_suite};
#[cfg(not(feature = "text"))]
pub use plain::listed;
#[cfg(all(feature = "lint", not(feature = "text")))]
pub use plain::problem;
pub use statistics::{Detail, Statistic, Statistics};
pub use subject::Subject;
#[cfg(feature = "text")]
pub use text::{TextReport, listed, problem};
#[cfg(feature = "full")]
pub use {
    fingerprint::{FINGERPRINT_NAME, Fingerprint, fingerprint, fingerprints},
    gitlab::Gitlab,
    json::Json,
    sarif::Sarif,
};

/// Writes the findings of files.
pub trait Report {
    /// Writes the findings of the next file, in the order of the report.
    ///
    /// # Errors
    /// If the output cannot be written.
    fn file(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()>;

    /// Records a file that could not be read, which the message names. Most formats do not support this, so the
    /// caller also reports it elsewhere.
    ///
    /// # Errors
    /// If the output cannot be written.
    fn unread(&mut self, message: &str) -> io::Result<()> {
        let _ = message;
        Ok(())
    }

    /// Records the exit code of the process, before the report ends.
    fn exit_code(&mut self, code: u8) {
        let _ = code;
    }

    /// Sets the lowest severity that fails the run, for the following files.
    fn deny_from(&mut self, severity: Severity) {
        let _ = severity;
    }

    /// Whether the report is for display, with findings of the same cause joined ([`grouped`]) instead of
    /// listed by place ([`by_place`]).
    fn is_for_people(&self) -> bool {
        false
    }

    /// Ends the report, after the last file.
    ///
    /// # Errors
    /// If the output cannot be written.
    fn finish(&mut self) -> io::Result<()>;
}

/// The location of a label, in the file and in the model.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Location<'a> {
    /// The file: that of the finding, or the description of a network node.
    pub source: &'a SourceFile,
    /// The bytes of the decoded text.
    pub span: Span,
    /// Line and column of the first character.
    pub start: LineColumn,
    /// Line and column after the last character.
    pub end: LineColumn,
    /// The address in the model; `None` outside the parts of a description.
    pub place: Option<Cow<'a, Place>>,
    /// The remark; empty if the message is sufficient.
    pub text: Cow<'a, str>,
}

impl<'a> Location<'a> {
    /// The location of a label of a finding about `subject`.
    pub fn new(subject: Subject<'a>, label: &'a SourceLabel) -> Self {
        let subject = subject.of_label(&label.at);
        let span = subject.span_of(&label.at);
        let source = subject.source();
        Self {
            source,
            span,
            start: source.line_column(span.start),
            end: source.line_column(span.end),
            place: subject.description().and_then(|description| description.place_of(&label.at)),
            text: label.text.shown(),
        }
    }

    /// Line and column of a finding; the start of the text if it has no place.
    pub fn start_of(subject: Subject<'_>, finding: &Diagnostic) -> LineColumn {
        let start = finding.labels.first().map_or(0, |label| subject.span_of(&label.at).start);
        subject.source().line_column(start)
    }

    /// The line of a finding, counted from 1; `None` if it has no place.
    pub fn line_of(subject: Subject<'_>, finding: &Diagnostic) -> Option<u32> {
        (!finding.labels.is_empty()).then(|| Self::start_of(subject, finding).line)
    }

    /// The locations of a finding: its own, then the related ones.
    pub fn all(subject: Subject<'a>, finding: &'a Diagnostic) -> Vec<Self> {
        finding.labels.iter().map(|label| Self::new(subject, label)).collect()
    }
}

/// How much was found in how many files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Tally {
    /// Files that were checked.
    pub files: usize,
    /// Files with at least one finding.
    pub files_with_findings: usize,
    /// Places of findings, including [joined](grouped) ones.
    pub places: usize,
    /// Findings of severity error.
    pub errors: usize,
    /// Findings of severity warning.
    pub warnings: usize,
    /// Findings of severity note.
    pub notes: usize,
    /// Findings that a report does not list, because their rule has too many in one file.
    pub unlisted: usize,
    /// Findings suppressed by the file, the configuration or a baseline.
    pub suppressed: usize,
    /// Whether the last added file is among those with findings.
    has_last: bool,
}

impl Tally {
    /// Adds the findings of a file, or of one more device of the last file.
    pub(crate) fn take(&mut self, subject: Subject<'_>, findings: &Findings) {
        let is_same = subject.description().is_some_and(|description| description.number() > 0);
        let before = *self;
        self.add(findings);
        if is_same && before.files > 0 {
            self.files = before.files;
            self.has_last |= before.has_last;
            self.files_with_findings =
                before.files_with_findings + usize::from(self.has_last && !before.has_last);
        }
    }

    /// Adds one file.
    pub fn add(&mut self, findings: &Findings) {
        self.files += 1;
        self.has_last = !findings.is_empty();
        self.files_with_findings += usize::from(self.has_last);
        for finding in findings {
            self.places += 1 + finding.also.len();
            self.count(finding.severity, 1);
        }
        for (rule, count) in findings.omitted() {
            self.places += count as usize;
            let of_rule = findings.iter().rfind(|finding| finding.rule.id == rule);
            self.count(of_rule.map_or(Severity::Note, |finding| finding.severity), count as usize);
        }
        self.unlisted += findings.unlisted().map(|(_, count)| count as usize).sum::<usize>();
        self.suppressed += findings.suppressed() as usize;
    }

    fn count(&mut self, severity: Severity, findings: usize) {
        *match severity {
            Severity::Error => &mut self.errors,
            Severity::Warning => &mut self.warnings,
            Severity::Note => &mut self.notes,
        } += findings;
    }

    /// Number of findings of at least this severity.
    pub fn at_least(&self, severity: Severity) -> usize {
        match severity {
            Severity::Error => self.errors,
            Severity::Warning => self.errors + self.warnings,
            Severity::Note => self.errors + self.warnings + self.notes,
        }
    }
}

/// `3 errors, 2 warnings, 1 note in 2 of 5 files`.
impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [(self.errors, "error"), (self.warnings, "warning"), (self.notes, "note")];
        let found: Vec<String> =
            counts.iter().filter(|(count, _)| *count > 0).map(|&(count, word)| plural(count, word)).collect();
        if found.is_empty() {
            let no_findings = if self.suppressed == 0 { "no findings" } else { "nothing to report" };
            write!(f, "{no_findings} in {}", plural(self.files, "file"))?;
        } else {
            f.write_str(&found.join(", "))?;
            if self.places > self.at_least(Severity::Note) {
                write!(f, " at {} places", self.places)?;
            }
            f.write_str(" in ")?;
            if self.files_with_findings < self.files {
                write!(f, "{} of ", self.files_with_findings)?;
            }
            f.write_str(&plural(self.files, "file"))?;
        }
        if self.unlisted > 0 {
            write!(f, ", {} of them not shown", self.unlisted)?;
        }
        match self.suppressed {
            0 => Ok(()),
            suppressed => write!(f, "; {suppressed} suppressed"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tally_reads_as_a_sentence() {
        let tally = Tally { files: 5, files_with_findings: 2, errors: 3, notes: 1, ..Tally::default() };
        assert_eq!(tally.to_string(), "3 errors, 1 note in 2 of 5 files");
        let tally = Tally { files: 1, files_with_findings: 1, warnings: 9, unlisted: 7, ..Tally::default() };
        assert_eq!(tally.to_string(), "9 warnings in 1 file, 7 of them not shown");
        assert_eq!(Tally { files: 2, ..Tally::default() }.to_string(), "no findings in 2 files");
        assert_eq!(tally.at_least(Severity::Error), 0);
        assert_eq!(tally.at_least(Severity::Warning), 9);
    }
}
