//! Workflow commands, which GitHub shows as annotations of the changed lines.

use std::io::{self, Write};
use std::path::Path;

use super::path::RelativeBase;
use super::{Location, Report, Subject, Tally};
use objdict_model::diagnostic::{Diagnostic, Findings, Severity, one_line, printable};

/// Findings as one workflow command each, and a total for the log at the end.
#[derive(Debug)]
pub struct Github<W> {
    out: W,
    base: RelativeBase,
    tally: Tally,
}

impl<W: Write> Github<W> {
    /// A report that writes to `out`.
    pub fn new(out: W) -> Self {
        Self { out, base: RelativeBase::default(), tally: Tally::default() }
    }

    /// Sets the folder that paths are relative to, which is the repository's.
    #[must_use]
    pub fn base(mut self, folder: &Path) -> Self {
        self.base = RelativeBase::new(folder);
        self
    }

    fn annotation(&mut self, file: &str, subject: Subject<'_>, finding: &Diagnostic) -> io::Result<()> {
        let command = match finding.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "notice",
        };
        write!(self.out, "::{command} file={file}")?;
        let at = finding.labels.first().map(|label| Location::new(subject, label));
        if let Some(Location { start, end, .. }) = at {
            write!(self.out, ",line={},endLine={}", start.line, end.line)?;
            // GitHub rejects an annotation with columns on different lines
            if start.line == end.line {
                write!(self.out, ",col={},endColumn={}", start.column, end.column)?;
            }
        }
        let mut text = one_line(&finding.message.shown());
        if let Some(help) = &finding.help {
            text.push_str("\nhelp: ");
            text.push_str(&one_line(&help.shown()));
        }
        writeln!(self.out, ",title={}::{}", property(finding.rule.id), data(&text))
    }
}

impl<W: Write> Report for Github<W> {
    fn file(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()> {
        self.tally.take(subject, findings);
        let name = self.base.relative(subject.source().name());
        let file = property(&name);
        for finding in findings.listed() {
            self.annotation(&file, subject, finding)?;
        }
        for (rule, count) in findings.unlisted() {
            writeln!(self.out, "{}: {count} more findings of {rule} are not shown", one_line(&name))?;
        }
        Ok(())
    }

    fn unread(&mut self, message: &str) -> io::Result<()> {
        writeln!(self.out, "::error title=objdict::{}", data(&one_line(message)))
    }

    fn finish(&mut self) -> io::Result<()> {
        if self.tally.files > 0 {
            writeln!(self.out, "{}", self.tally)?;
        }
        self.out.flush()
    }
}

/// The text of a command: line ends are escaped, and terminal control characters replaced.
fn data(text: &str) -> String {
    printable(&text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")).into_owned()
}

/// A property of a command: characters that end the property are escaped as well.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_model::diagnostic::{RuleInfo, Severity};
    use objdict_model::source::{SourceFile, Span};

    static TEST: RuleInfo = RuleInfo::bare("test/test", Severity::Error);

    fn shown(name: &str, finding: Diagnostic) -> String {
        let source = SourceFile::from_text(name, "[A]\nk=1\n");
        let mut findings = Findings::new();
        findings.push(finding);
        let mut out = Vec::new();
        let mut report = Github::new(&mut out);
        report.file((&source).into(), &findings).unwrap();
        report.finish().unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn nothing_leaves_its_command() {
        let finding =
            Diagnostic::new(&TEST, Span::new(4, 5), "100 %, a: b\n::error::no\r").help("do, it: so");
        assert_eq!(
            shown("./a:b,c%d.eds", finding),
            "::error file=a%3Ab%2Cc%25d.eds,line=2,endLine=2,col=1,endColumn=2,title=test/test\
             ::100 %25, a: b\u{FFFD}::error::no\u{FFFD}%0Ahelp: do, it: so\n1 error in 1 file\n"
        );
        assert_eq!(data("a\r\n%0A"), "a%0D%0A%250A");
    }

    #[test]
    fn names_are_no_commands() {
        let name = "a\u{1B}]0;x\n::error::b\u{9B}";
        let line = "::error file=a\u{FFFD}]0;x%0A%3A%3Aerror%3A%3Ab\u{FFFD},line=1,";
        assert!(shown(name, Diagnostic::new(&TEST, Span::new(0, 1), "m")).starts_with(line));
        let mut findings = Findings::new();
        (0..2000).for_each(|_| findings.push(Diagnostic::new(&TEST, Span::new(0, 1), "m")));
        let source = SourceFile::from_text("::error::b", "[A]");
        let mut out = Vec::new();
        Github::new(&mut out).file((&source).into(), &findings).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert!(text.ends_with("\n\u{FFFD}:error::b: 1000 more findings of test/test are not shown\n"));
    }

    #[test]
    fn a_finding_over_several_lines_has_no_columns() {
        let finding = Diagnostic::new(&TEST, Span::new(1, 6), "m").severity(Severity::Note);
        let line = "::notice file=a.eds,line=1,endLine=2,title=test/test::m\n";
        assert!(shown("a.eds", finding).starts_with(line));
    }
}
