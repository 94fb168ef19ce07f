//! A finding a line, for editors and `grep`: `file:line:column: severity rule: message`.

use std::io::{self, Write};

use super::{Detail, Report, Statistics, Subject, Tally};
use objdict_model::diagnostic::Findings;
use objdict_model::diagnostic::one_line;

/// Findings on one line each, and a total at the end.
#[derive(Debug)]
pub struct Concise<W> {
    out: W,
    tally: Tally,
    detail: Detail,
    statistics: Statistics,
}

impl<W: Write> Concise<W> {
    /// A report that writes to `out`.
    pub fn new(out: W) -> Self {
        Self { out, tally: Tally::default(), detail: Detail::default(), statistics: Statistics::default() }
    }

    /// Sets whether statistics are written, in addition to or instead of the findings.
    #[must_use]
    pub fn detail(mut self, detail: Detail) -> Self {
        self.detail = detail;
        self
    }
}

impl<W: Write> Report for Concise<W> {
    fn file(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()> {
        self.tally.take(subject, findings);
        if self.detail.has_statistics() {
            self.statistics.add(subject, findings);
        }
        if !self.detail.has_findings() {
            return Ok(());
        }
        let name = one_line(subject.source().name());
        for finding in findings.listed() {
            writeln!(self.out, "{}", finding.line(subject.source(), |at| subject.span_of(at)))?;
        }
        for (rule, count) in findings.unlisted() {
            writeln!(self.out, "{name}: {count} more findings of {rule} are not shown")?;
        }
        Ok(())
    }

    fn is_for_people(&self) -> bool {
        true
    }

    fn finish(&mut self) -> io::Result<()> {
        self.statistics.write(&mut self.out)?;
        if self.tally.files > 0 {
            writeln!(self.out, "{}", self.tally)?;
        }
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_format as format;
    use objdict_format::Format;
    use objdict_model::source::SourceFile;

    #[test]
    fn a_finding_is_a_line() {
        let text = "[A]\nj\u{1B}unk\n";
        let description = format::read(SourceFile::from_text("a.eds", text), Format::Eds);
        let mut out = Vec::new();
        let mut report = Concise::new(&mut out);
        report.file((&description).into(), &description.text_findings()).unwrap();
        report.finish().unwrap();
        let shown = String::from_utf8(out).unwrap();
        let line = "a.eds:2:1: error cia306/junk-line: `j\u{FFFD}unk` is not a section, key or comment\n";
        assert!(shown.contains(line), "{shown}");
        assert!(shown.ends_with("in 1 file\n"), "{shown}");
    }
}
