//! JUnit XML: a suite per file, a test case per finding, and a passed one for a file without findings.

use std::collections::HashMap;
use std::io::{self, Write};
use std::path::Path;

use super::path::RelativeBase;
use super::{Location, Report, Subject};
use objdict_model::diagnostic::one_line;
use objdict_model::diagnostic::{Diagnostic, Findings, Severity};
use objdict_xdd::xml::XmlWriter;

/// Findings as failed tests. There is no schema that all readers agree on; this is their common subset.
#[derive(Debug)]
pub struct Junit<W> {
    out: W,
    base: RelativeBase,
    deny: Severity,
    xml: XmlWriter,
}

/// A test of a suite.
#[derive(Clone, Debug)]
#[expect(clippy::exhaustive_structs, reason = "the attributes of a test case of JUnit")]
pub struct TestCase<'a> {
    /// The group of the test.
    pub class: &'a str,
    /// The name, unique in its group.
    pub name: String,
    /// The result.
    pub result: TestResult,
}

/// The result of a test.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(clippy::exhaustive_enums, reason = "the results of JUnit")]
pub enum TestResult {
    /// It passed.
    Passed,
    /// Why it failed.
    Failed(String),
    /// Why it was not made.
    Skipped(String),
}

/// JUnit XML of a suite of tests.
pub fn junit_suite(name: &str, tests: &[TestCase<'_>]) -> String {
    let count = |is_meant: fn(&TestResult) -> bool| {
        tests.iter().filter(|test| is_meant(&test.result)).count().to_string()
    };
    let failures = count(|result| matches!(result, TestResult::Failed(_)));
    let skipped = count(|result| matches!(result, TestResult::Skipped(_)));
    let (name, total) = (one_line(name), tests.len().to_string());
    let mut xml = XmlWriter::new();
    xml.open("testsuites", [("name", "objdict")]);
    let attributes = [
        ("name", &*name),
        ("tests", &*total),
        ("failures", &*failures),
        ("errors", "0"),
        ("skipped", &*skipped),
    ];
    xml.open("testsuite", attributes);
    for TestCase { class, name, result } in tests {
        let (name, class) = (one_line(name), one_line(class));
        let attributes = [("name", &*name), ("classname", &*class)];
        let (element, reason) = match result {
            TestResult::Passed => {
                xml.empty("testcase", attributes);
                continue;
            }
            TestResult::Failed(reason) => ("failure", one_line(reason)),
            TestResult::Skipped(reason) => ("skipped", one_line(reason)),
        };
        xml.open("testcase", attributes);
        xml.empty(element, [("message", &*reason)]);
        xml.close();
    }
    xml.finish()
}

impl<W: Write> Junit<W> {
    /// A report that writes to `out`.
    pub fn new(out: W) -> Self {
        let mut xml = XmlWriter::new();
        xml.open("testsuites", [("name", "objdict")]);
        Self { out, base: RelativeBase::default(), deny: Severity::Error, xml }
    }

    /// Sets the folder that paths are relative to, which is the repository's.
    #[must_use]
    pub fn base(mut self, folder: &Path) -> Self {
        self.base = RelativeBase::new(folder);
        self
    }

    /// Writes findings below `severity` as passed tests with output.
    #[must_use]
    pub fn deny(mut self, severity: Severity) -> Self {
        self.deny = severity;
        self
    }

    fn suite(&mut self, name: &str, tests: usize, failures: usize, errors: usize) {
        let (tests, failures, errors) = (tests.to_string(), failures.to_string(), errors.to_string());
        let attributes = [("name", name), ("tests", &*tests), ("failures", &*failures), ("errors", &*errors)];
        self.xml.open("testsuite", attributes);
    }

    /// A test case; `seen` counts the names in its file, because readers merge cases with the same name.
    fn case(
        &mut self,
        file: &str,
        subject: Subject<'_>,
        finding: &Diagnostic,
        seen: &mut HashMap<String, u32>,
    ) {
        let at = finding.labels.first().map(|label| Location::new(subject, label));
        let start = Location::start_of(subject, finding);
        let position = format!("{}:{}", start.line, start.column);
        let place = at.and_then(|at| at.place).map_or_else(|| position.clone(), |place| place.to_string());
        let mut name = format!("{}: {place}", finding.rule.id);
        let count = seen.entry(name.clone()).or_default();
        *count += 1;
        if *count > 1 {
            name.push_str(&format!(" ({count})"));
        }
        self.xml.open("testcase", [("name", &*name), ("classname", file)]);
        let message = one_line(&finding.message.shown());
        let severity = finding.severity.to_string();
        let mut text = format!("{file}:{position}: {severity}: {message}");
        if let Some(help) = &finding.help {
            text.push_str("\nhelp: ");
            text.push_str(&one_line(&help.shown()));
        }
        if finding.severity >= self.deny {
            self.xml.text_element("failure", [("type", &*severity), ("message", &*message)], &text);
        } else {
            self.xml.text_element("system-out", [], &text);
        }
        self.xml.close();
    }
}

impl<W: Write> Report for Junit<W> {
    fn deny_from(&mut self, severity: Severity) {
        self.deny = severity;
    }

    fn file(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()> {
        let name = one_line(&self.base.relative(subject.source().name()));
        let failures = findings.listed().filter(|finding| finding.severity >= self.deny).count();
        self.suite(&name, findings.listed().count().max(1), failures, 0);
        let mut seen = HashMap::new();
        for finding in findings.listed() {
            self.case(&name, subject, finding, &mut seen);
        }
        if findings.is_empty() {
            self.xml.empty("testcase", [("name", "no findings"), ("classname", &*name)]);
        }
        let omitted: Vec<String> = findings
            .unlisted()
            .map(|(rule, count)| format!("{count} more findings of {rule} are not shown"))
            .collect();
        if !omitted.is_empty() {
            self.xml.text_element("system-out", [], &omitted.join("\n"));
        }
        self.xml.close();
        self.out.write_all(self.xml.take().as_bytes())
    }

    fn unread(&mut self, message: &str) -> io::Result<()> {
        let message = one_line(message);
        self.suite("objdict", 1, 0, 1);
        self.xml.open("testcase", [("name", &*message), ("classname", "objdict")]);
        self.xml.empty("error", [("type", "unreadable"), ("message", &*message)]);
        self.xml.close();
        self.xml.close();
        self.out.write_all(self.xml.take().as_bytes())
    }

    fn finish(&mut self) -> io::Result<()> {
        let rest = std::mem::take(&mut self.xml).finish();
        self.out.write_all(rest.as_bytes())?;
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_format as format;
    use objdict_format::Format;
    use objdict_model::diagnostic::{RuleInfo, Severity};
    use objdict_model::source::{SourceFile, Span};

    static TEST: RuleInfo = RuleInfo::bare("test/test", Severity::Error);

    #[test]
    fn whatever_is_found_is_well_formed() {
        let source = SourceFile::from_text("a&\u{1}<b>.eds", "x");
        let mut findings = Findings::new();
        for message in ["]]> <&\"'>", "\u{0}\u{8}\u{B}\u{FFFE}\u{FFFF}\u{1F600}\n\t"] {
            findings.push(Diagnostic::new(&TEST, Span::new(0, 1), message).help("<help>"));
        }
        findings.push(Diagnostic::new(&TEST, Span::new(0, 1), "mild").severity(Severity::Note));
        let clean = SourceFile::from_text("clean.eds", "");
        let mut out = Vec::new();
        let mut report = Junit::new(&mut out);
        report.file((&source).into(), &findings).unwrap();
        report.file((&clean).into(), &Findings::new()).unwrap();
        report.unread("cannot read `<x>`").unwrap();
        report.finish().unwrap();
        let text = String::from_utf8(out).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let count = |name| document.descendants().filter(|node| node.has_tag_name(name)).count();
        assert_eq!((count("testsuite"), count("testcase"), count("failure"), count("error")), (3, 5, 2, 1));
        let suite = document.descendants().find(|node| node.has_tag_name("testsuite")).unwrap();
        assert_eq!((suite.attribute("tests"), suite.attribute("failures")), (Some("3"), Some("2")));
    }

    #[test]
    fn a_suite_of_tests_is_well_formed() {
        let results = [
            TestResult::Passed,
            TestResult::Failed("<&>".to_owned()),
            TestResult::Skipped("\u{1}".to_owned()),
        ];
        let test = |result| TestCase { class: "a<b", name: "x\ny".to_owned(), result };
        let text = junit_suite("node & bus", &results.map(test));
        let document = roxmltree::Document::parse(&text).unwrap();
        let suite = document.descendants().find(|node| node.has_tag_name("testsuite")).unwrap();
        let counts = ["tests", "failures", "skipped"].map(|name| suite.attribute(name));
        assert_eq!(counts, [Some("3"), Some("1"), Some("1")]);
        let failure = suite.descendants().find(|node| node.has_tag_name("failure")).unwrap();
        assert_eq!(failure.attribute("message"), Some("<&>"));
        assert_eq!(suite.descendants().filter(|node| node.has_tag_name("testcase")).count(), 3);
    }

    #[test]
    fn nothing_checked_is_a_document_too() {
        let mut out = Vec::new();
        Junit::new(&mut out).finish().unwrap();
        let text = String::from_utf8(out).unwrap();
        assert!(roxmltree::Document::parse(&text).unwrap().root_element().has_tag_name("testsuites"));
    }

    #[test]
    fn cases_are_named_by_their_place() {
        let text = "[2000]\nParameterName=A\nObjectType=7\nDataType=5\nAccessType=rw\nDefaultValue=300\n";
        let description = format::read(SourceFile::from_text("a.eds", text), Format::Eds);
        let mut out = Vec::new();
        let mut report = Junit::new(&mut out);
        report.file((&description).into(), &crate::check(&description)).unwrap();
        report.finish().unwrap();
        let text = String::from_utf8(out).unwrap();
        assert!(text.contains("name=\"cia306/invalid-value: 0x2000 / DefaultValue\""), "{text}");
    }
}
