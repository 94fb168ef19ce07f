//! Findings as text: the offending lines with marks under them.

mod excerpt;
mod printer;
mod problem;
mod wrap;

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::fmt;
use std::io::{self, Write};

use miette::LabeledSpan;

use self::excerpt::{Excerpted, Excerpts};
use self::printer::{Printer, WIDTH, shown};
pub use self::problem::problem;
use super::statistics::offer;
use super::{Detail, Report, Statistics, Subject, Tally};
use objdict_model::diagnostic::{Applicability, At, Diagnostic, Findings, Severity};

/// The maximum number of findings of a file in a brief report, and of all findings in one that ends without a
/// table.
const MAX_BRIEF: usize = 20;

/// Findings with their source lines, and a total at the end.
pub struct TextReport<W> {
    out: W,
    printer: Printer,
    tally: Tally,
    detail: Detail,
    statistics: Statistics,
    /// The number of findings that a safe fix can fix, and of additional ones that an unsafe fix can.
    fixable: [usize; 2],
    /// Whether only the first findings of a file are shown.
    is_brief: bool,
}

impl<W> fmt::Debug for TextReport<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TextReport").field("tally", &self.tally).finish_non_exhaustive()
    }
}

impl<W: Write> TextReport<W> {
    /// A report that writes to `out`, with the colours of a terminal or without.
    pub fn new(out: W, colour: bool) -> Self {
        Self {
            out,
            printer: Printer { colour, width: WIDTH },
            tally: Tally::default(),
            detail: Detail::default(),
            statistics: Statistics::default(),
            fixable: [0; 2],
            is_brief: false,
        }
    }

    /// Sets the line width in columns, 60 to 120 (default: 80).
    #[must_use]
    pub fn width(mut self, columns: usize) -> Self {
        self.printer.width = columns.clamp(60, 120);
        self
    }

    /// Sets whether statistics are written, in addition to or instead of the findings.
    #[must_use]
    pub fn detail(mut self, detail: Detail) -> Self {
        self.detail = detail;
        self
    }

    /// Shows at most 20 findings of a file, errors first, and a table of the rules at the end if there are
    /// more in total.
    #[must_use]
    pub fn brief(mut self) -> Self {
        self.is_brief = true;
        self
    }
}

impl<W> TextReport<W> {
    fn count_fixes(&mut self, subject: Subject<'_>, findings: &Findings) {
        for fix in findings.iter().filter_map(|finding| offer(subject, finding)) {
            self.fixable[usize::from(fix.safety == Applicability::Unsafe)] += 1;
        }
    }
}

impl<W: Write> Report for TextReport<W> {
    fn file(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()> {
        self.tally.take(subject, findings);
        if self.detail.has_statistics() || self.is_brief {
            self.statistics.add(subject, findings);
        }
        if findings.is_empty() || !self.detail.has_findings() {
            return Ok(());
        }
        self.count_fixes(subject, findings);
        let excerpts = Excerpts::new(subject.source());
        let mut text = String::new();
        let mut shown: Vec<&Diagnostic> = findings.listed().collect();
        let more = if self.is_brief { shown.len().saturating_sub(MAX_BRIEF) } else { 0 };
        if more > 0 {
            shown.sort_by_key(|finding| Reverse(finding.severity));
            shown.truncate(MAX_BRIEF);
        }
        for finding in shown {
            text.clear();
            let rendered = Rendered::new(subject, &excerpts, finding);
            self.printer.draw(&mut text, &rendered, &rendered.others).map_err(io::Error::other)?;
            text.push('\n');
            self.out.write_all(text.as_bytes())?;
        }
        if more > 0 {
            writeln!(self.out, "{}: … and {more} more, shown with `--all`\n", excerpts.name())?;
        }
        for (rule, count) in findings.unlisted() {
            writeln!(self.out, "{}: {count} more findings of {rule} are not shown\n", excerpts.name())?;
        }
        Ok(())
    }

    fn is_for_people(&self) -> bool {
        true
    }

    fn finish(&mut self) -> io::Result<()> {
        if self.detail.has_statistics() || self.tally.at_least(Severity::Note) > MAX_BRIEF {
            self.statistics.write(&mut self.out)?;
        }
        if self.tally.files > 0 {
            writeln!(self.out, "{}", self.tally)?;
        }
        match self.fixable {
            [0, 0] => {}
            [safe, 0] => writeln!(self.out, "{safe} can be fixed with `--fix`")?,
            [0, others] => writeln!(self.out, "{others} can be fixed with `--fix --unsafe-fixes`")?,
            [safe, others] => {
                writeln!(self.out, "{safe} can be fixed with `--fix`, {others} more with `--unsafe-fixes`")?;
            }
        }
        self.out.flush()
    }
}

/// Findings of a file as plain text, with a total at the end.
pub fn listed(subject: Subject<'_>, findings: &Findings) -> io::Result<String> {
    let mut text = Vec::new();
    let mut report = TextReport::new(&mut text, false);
    report.file(subject, findings)?;
    report.finish()?;
    Ok(String::from_utf8_lossy(&text).into_owned())
}

/// A finding, or a problem without a rule, in the interface of miette.
#[derive(Debug)]
struct Rendered<'a> {
    code: Option<&'static str>,
    severity: miette::Severity,
    message: String,
    help: Option<String>,
    excerpts: &'a Excerpts<'a>,
    labels: Vec<LabeledSpan>,
    /// The labels in other files: the descriptions of nodes, patches.
    others: Vec<Excerpted<'a>>,
}

impl<'a> Rendered<'a> {
    fn new(subject: Subject<'a>, excerpts: &'a Excerpts<'a>, finding: &'a Diagnostic) -> Self {
        let mut labels = Vec::with_capacity(finding.labels.len());
        let mut others = BTreeMap::new();
        for (position, label) in finding.labels.iter().enumerate() {
            let text = Some(label.text.to_string()).filter(|text| !text.is_empty());
            let span = subject.span_of(&label.at);
            if let At::Node(..) | At::Patch(..) = label.at {
                let source = subject.of_label(&label.at).source();
                let new = || (Excerpts::new(source), Vec::new());
                let (excerpts, labels): &mut Excerpted<'_> = others.entry(source.name()).or_insert_with(new);
                labels.push(LabeledSpan::new_with_span(text, excerpts.cut(span)));
                continue;
            }
            let span = excerpts.cut(span);
            labels.push(match position {
                0 => LabeledSpan::new_primary_with_span(text, span),
                _ => LabeledSpan::new_with_span(text, span),
            });
        }
        let others = others.into_values().collect();
        let help = finding.help.as_ref().map(|help| shown(&help.shown()));
        let severity = match finding.severity {
            Severity::Error => miette::Severity::Error,
            Severity::Warning => miette::Severity::Warning,
            Severity::Note => miette::Severity::Advice,
        };
        let message = shown(&finding.message.shown());
        Self { code: Some(finding.rule.id), severity, message, help, excerpts, labels, others }
    }
}

impl fmt::Display for Rendered<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Rendered<'_> {}

impl miette::Diagnostic for Rendered<'_> {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.code?))
    }

    fn severity(&self) -> Option<miette::Severity> {
        Some(self.severity)
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn miette::SourceCode> {
        Some(self.excerpts)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use objdict_format as format;
    use objdict_format::Format;
    use objdict_model::diagnostic::{Fix, RuleInfo, Severity};
    use objdict_model::source::{SourceFile, Span};

    static TEST: RuleInfo = RuleInfo::bare("test/test", Severity::Warning);

    fn render(text: &str, spans: &[(u32, u32)], message: &str) -> String {
        let description = format::read(SourceFile::from_text("a.eds", text), Format::Eds);
        let mut spans = spans.iter().map(|&(start, end)| Span::new(start.min(end), start.max(end)));
        let mut finding = Diagnostic::new(&TEST, spans.next().unwrap_or_default(), message.to_owned());
        for span in spans {
            finding = finding.label(span, "related");
        }
        let mut findings = Findings::new();
        findings.push(finding);
        let mut out = Vec::new();
        let mut report = TextReport::new(&mut out, false);
        report.file((&description).into(), &findings).unwrap();
        report.finish().unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn a_long_line_is_shown_around_the_label() {
        let text = format!("[A]\nk={}MIDDLE{}\nnext=1\n", "a".repeat(5000), "z".repeat(1_000_000));
        let shown = render(&text, &[(5006, 5012)], "long");
        assert!(shown.contains("a.eds:2:5003"), "{shown}");
        assert!(shown.contains("aaaMIDDLEzzz"), "{shown}");
        assert!(shown.len() < 1000, "{} bytes", shown.len());
    }

    #[test]
    fn a_line_that_is_too_wide_is_shown_around_the_label() {
        let text = format!("[A]\nk={}MIDDLE{}\nnext=1\n", "a".repeat(100), "z".repeat(100));
        let shown = render(&text, &[(106, 112)], &"word ".repeat(30));
        let widths: Vec<usize> = shown.lines().map(|line| line.chars().count()).collect();
        assert!(widths.iter().all(|width| *width <= 80) && widths.contains(&80), "{shown}");
        let line = shown.lines().find(|line| line.contains("MIDDLE")).unwrap();
        assert!(line.contains("│ …a") && line.ends_with("z…"), "{shown}");
        let column = |line: &str, text: &str| line.find(text).map(|at| line[..at].chars().count());
        let mark =
            shown.lines().find(|line| line.contains("──────")).filter(|line| line.contains('·')).unwrap();
        assert_eq!(column(line, "MIDDLE"), column(mark, "──────"), "{shown}");
        assert!(shown.contains("  ⚠ warning: word word") && shown.contains("│ [A]\n"), "{shown}");
    }

    #[test]
    fn labels_far_apart_on_one_line_are_shown_apart() {
        let text = format!("FIRST{}LAST\n", "-".repeat(4000));
        let shown = render(&text, &[(4005, 4009), (0, 5)], "two");
        assert!(shown.contains("FIRST--") && shown.contains("--LAST"), "{shown}");
        assert!(shown.len() < 1500, "{} bytes", shown.len());
    }

    #[test]
    fn nothing_steers_the_terminal() {
        let shown = render("k=\u{1B}[31mred\u{9B}\u{202E}\u{7F}\r\n", &[(2, 5)], "`\u{1B}[0m\u{202E}`");
        assert!(!shown.contains(['\u{1B}', '\u{9B}', '\u{202E}', '\u{7F}']), "{shown:?}");
    }

    #[test]
    fn a_brief_report_shows_the_worst_and_a_table() {
        let description = format::read(SourceFile::from_text("a.eds", "x"), Format::Eds);
        let mut findings = Findings::new();
        for _ in 0..MAX_BRIEF + 1 {
            findings.push(Diagnostic::new(&TEST, Span::empty(0), "a warning"));
        }
        findings.push(Diagnostic::new(&TEST, Span::empty(0), "an error").severity(Severity::Error));
        let mut out = Vec::new();
        let mut report = TextReport::new(&mut out, false).brief();
        report.file((&description).into(), &findings).unwrap();
        report.finish().unwrap();
        let shown = String::from_utf8(out).unwrap();
        assert!(shown.starts_with("test/test\n\n  × error: an error"), "{shown}");
        assert_eq!(shown.matches("warning: a warning").count(), MAX_BRIEF - 1);
        assert!(shown.contains("a.eds: … and 2 more, shown with `--all`"), "{shown}");
        assert!(shown.contains("      22      1        0  error     test/test\n"), "{shown}");
    }

    #[test]
    fn only_offered_fixes_are_counted() {
        let description = format::read(SourceFile::from_text("a.eds", "x"), Format::Eds);
        let mut findings = Findings::new();
        for is_offered in [true, false] {
            let fix = Fix { is_offered, ..Fix::safe("remove it").replace(Span::new(0, 1), "") };
            findings.push(Diagnostic::new(&TEST, Span::empty(0), "m").fix(fix));
        }
        let shown = listed((&description).into(), &findings).unwrap();
        assert!(shown.ends_with("\n1 can be fixed with `--fix`\n"), "{shown}");
    }

    #[test]
    fn what_is_omitted_is_reported() {
        let description = format::read(SourceFile::from_text("a.eds", "x"), Format::Eds);
        let mut findings = Findings::new();
        for _ in 0..objdict_model::diagnostic::MAX_PER_RULE + 3 {
            findings.push(Diagnostic::new(&TEST, Span::empty(0), "m"));
        }
        let mut out = Vec::new();
        let mut report = TextReport::new(&mut out, false);
        report.file((&description).into(), &findings).unwrap();
        report.finish().unwrap();
        let shown = String::from_utf8(out).unwrap();
        assert!(shown.contains("a.eds: 3 more findings of test/test are not shown"));
        assert!(shown.ends_with("1003 warnings in 1 file, 3 of them not shown\n"));
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]
        #[test]
        fn any_text_with_any_spans_is_shown(
            pieces in prop::collection::vec(prop_oneof![
                ".{0,40}", "(\r\n|\n|\r|\t|=|°|\u{202E}|\0|漢){0,12}", "x{290,420}",
            ], 0..8),
            spans in prop::collection::vec((0u32..1500, 0u32..1500), 1..4),
        ) {
            let shown = render(&pieces.concat(), &spans, "message");
            prop_assert!(shown.contains("a.eds:"));
        }
    }
}
