//! One JSON document for all files; `docs/reference/json.md` describes it.

use std::borrow::Cow;
use std::io::{self, Write};

use serde::Serialize;

use super::group::joint_fix;
use super::{Detail, Fingerprint, Location, Report, Statistics, Subject, Tally, fingerprint::listed};
use objdict_model::diagnostic::{Applicability, Diagnostic, Findings, Severity, Text};
use objdict_model::source::Span;

/// The version of the document. It changes when a field is removed or its meaning changes, not when a field
/// is added.
const VERSION: u32 = 1;

/// Findings as a JSON document, one finding a line.
#[derive(Debug)]
pub struct Json<W> {
    out: W,
    tally: Tally,
    detail: Detail,
    statistics: Statistics,
    omitted: Vec<Omitted>,
    is_empty: bool,
}

/// The document, which is written finding by finding.
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[allow(dead_code, reason = "its schema is all that is made of it")]
pub struct CheckJson<'a> {
    /// The version of the document.
    version: objdict_model::json::Version<VERSION>,
    /// The findings, file by file in the order of the arguments, and in text order within a file; absent with
    /// `--statistics=only`.
    #[schemars(skip_serializing_if = "Option::is_none")]
    findings: Option<Vec<FindingJson<'a>>>,
    /// With `--statistics`, the rules with findings: by severity, then by number of findings.
    #[schemars(skip_serializing_if = "Option::is_none")]
    statistics: Option<Vec<super::statistics::Statistic>>,
    /// Rules with more than 1000 findings in a file, of which `findings` contains 1000.
    omitted: Vec<Omitted>,
    /// The number of findings in all files.
    summary: FindingCounts,
}

/// A finding.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Finding"))]
struct FindingJson<'a> {
    /// The file as given; `<stdin>` for the standard input.
    file: &'a str,
    /// The id of the rule; `objdict explain` prints its page.
    rule: &'a str,
    /// How severe it is.
    severity: Severity,
    #[serde(flatten)]
    at: PositionJson,
    /// The problem; quoted values are cut to 80 characters and `…`.
    message: Cow<'a, str>,
    /// The advice.
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<Cow<'a, str>>,
    /// Related places.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related: Vec<Related<'a>>,
    /// Other places with the same cause, in documents for display, such as for the page of `objdict open`; `check`
    /// reports each place as a finding.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    places: Vec<Related<'a>>,
    /// 16 hex digits that identify the finding in its file, and remain when lines move, lists are renumbered or a
    /// message is reworded.
    fingerprint: Fingerprint,
    /// The changes of `check --fix`, with `--unsafe-fixes` if it is `unsafe`; changes in one file never
    /// overlap.
    #[serde(skip_serializing_if = "Option::is_none")]
    fix: Option<FixJson>,
}

/// A fix.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Fix"))]
struct FixJson {
    /// A description of the fix, as an imperative.
    title: String,
    /// Whether it may be made without review.
    safety: Applicability,
    /// The new encoding of the file, if it changes.
    #[serde(skip_serializing_if = "Option::is_none")]
    encoding: Option<String>,
    /// The edits, in text order and without overlaps.
    edits: Vec<Edit>,
}

/// A piece of text and its replacement.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Edit {
    /// The line of the first character, counted from 1.
    line: u32,
    /// The column of the first character, counted from 1 in Unicode scalar values.
    column: u32,
    /// The line after the last character.
    end_line: u32,
    /// The column after the last character.
    end_column: u32,
    /// The new text.
    text: String,
}

/// A related place of a finding.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Related<'a> {
    /// The file, if it differs: the description of a node, for a finding about a network.
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<&'a str>,
    #[serde(flatten)]
    at: PositionJson,
    /// The remark about the place.
    message: Cow<'a, str>,
    /// For a place with the same cause, its help if that differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<Cow<'a, str>>,
}

/// A place in the text.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Position"))]
struct PositionJson {
    /// The line of the first character, counted from 1.
    line: u32,
    /// The column of the first character, counted from 1 in Unicode scalar values.
    column: u32,
    /// The line after the last character.
    end_line: u32,
    /// The column after the last character.
    end_column: u32,
    /// The address in the object dictionary, such as `0x1018sub1 / DefaultValue`; absent outside the sections and elements
    /// of a description.
    #[serde(skip_serializing_if = "Option::is_none")]
    place: Option<String>,
}

/// A rule with more findings in a file than are listed.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Omitted {
    /// The file.
    file: String,
    /// The id of the rule.
    rule: &'static str,
    /// The number of findings that are not listed.
    count: u32,
}

/// The number of findings in all files.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Summary"))]
struct FindingCounts {
    /// The number of files that were checked.
    files: usize,
    /// The number of errors, listed or not.
    errors: usize,
    /// The number of warnings, listed or not.
    warnings: usize,
    /// The number of notes, listed or not.
    notes: usize,
    /// The number of findings that comments or a baseline suppress.
    suppressed: usize,
}

impl<W: Write> Json<W> {
    /// A report that writes to `out`.
    pub fn new(out: W) -> Self {
        Self {
            out,
            tally: Tally::default(),
            detail: Detail::default(),
            statistics: Statistics::default(),
            omitted: Vec::new(),
            is_empty: true,
        }
    }

    /// Sets whether statistics are written, in addition to or instead of the findings.
    #[must_use]
    pub fn detail(mut self, detail: Detail) -> Self {
        self.detail = detail;
        self
    }

    /// The first line, before the first finding.
    fn start(&mut self) -> io::Result<()> {
        if self.is_empty {
            write!(self.out, "{{\"version\":{VERSION},\"findings\":[")?;
        }
        Ok(())
    }

    fn findings(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()> {
        let file = subject.source().name();
        for (finding, fingerprint) in listed(subject, findings) {
            self.start()?;
            self.out.write_all(if self.is_empty { b"\n" } else { b",\n" })?;
            self.is_empty = false;
            objdict_model::json::write(&mut self.out, &record(file, subject, finding, fingerprint))?;
        }
        Ok(())
    }
}

impl<W: Write> Report for Json<W> {
    fn file(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()> {
        self.tally.take(subject, findings);
        if self.detail.has_statistics() {
            self.statistics.add(subject, findings);
        }
        if self.detail.has_findings() {
            self.findings(subject, findings)?;
        }
        let file = subject.source().name();
        for (rule, count) in findings.unlisted() {
            self.omitted.push(Omitted { file: file.to_owned(), rule, count });
        }
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        if self.detail.has_findings() {
            self.start()?;
            self.out.write_all(if self.is_empty { b"],\n" } else { b"\n],\n" })?;
        } else {
            write!(self.out, "{{\"version\":{VERSION},")?;
        }
        if self.detail.has_statistics() {
            let rows: Result<Vec<String>, _> =
                self.statistics.rows().iter().map(objdict_model::json::text).collect();
            let rows = rows?;
            let (start, end) = if rows.is_empty() { ("", "") } else { ("\n", "\n") };
            writeln!(self.out, "\"statistics\":[{start}{}{end}],", rows.join(",\n"))?;
        }
        self.out.write_all(b"\"omitted\":")?;
        objdict_model::json::write(&mut self.out, &self.omitted)?;
        self.out.write_all(b",\n\"summary\":")?;
        let Tally { files, errors, warnings, notes, suppressed, .. } = self.tally;
        objdict_model::json::write(
            &mut self.out,
            &FindingCounts { files, errors, warnings, notes, suppressed },
        )?;
        self.out.write_all(b"}\n")?;
        self.out.flush()
    }
}

fn record<'a>(
    file: &'a str,
    subject: Subject<'a>,
    finding: &'a Diagnostic,
    fingerprint: Fingerprint,
) -> FindingJson<'a> {
    let start = || PositionJson { line: 1, column: 1, end_line: 1, end_column: 1, place: None };
    let first = |finding: &'a Diagnostic| {
        finding.labels.first().map_or_else(start, |label| position(&Location::new(subject, label)))
    };
    let help = finding.help.as_ref().map(Text::shown);
    let place = |other: &'a Diagnostic| Related {
        file: None,
        at: first(other),
        message: other.message.shown(),
        help: other.help.as_ref().map(Text::shown).filter(|other| help.as_ref() != Some(other)),
    };
    let related = |label| {
        let location = Location::new(subject, label);
        let name = location.source.name();
        Related {
            file: Some(name).filter(|name| *name != file),
            at: position(&location),
            message: location.text,
            help: None,
        }
    };
    FindingJson {
        file,
        rule: finding.rule.id,
        severity: finding.severity,
        at: first(finding),
        message: finding.message.shown(),
        related: finding.labels.iter().skip(1).map(related).collect(),
        places: finding.also.iter().map(place).collect(),
        help,
        fingerprint,
        fix: fix(subject, finding),
    }
}

fn position(location: &Location<'_>) -> PositionJson {
    PositionJson {
        line: location.start.line,
        column: location.start.column,
        end_line: location.end.line,
        end_column: location.end.column,
        place: location.place.as_deref().map(ToString::to_string),
    }
}

/// The fix of a finding, if this file can be changed accordingly.
fn fix(subject: Subject<'_>, finding: &Diagnostic) -> Option<FixJson> {
    let description = subject.description()?;
    let fix = joint_fix(description, finding)?;
    let encoding = description.encoding_of(&fix).map(|encoding| encoding.to_string());
    let edits = description.edits(&fix);
    if edits.is_none() && encoding.is_none() {
        return None;
    }
    let edit = |(span, text): (Span, String)| {
        let source = subject.source();
        let (start, end) = (source.line_column(span.start), source.line_column(span.end));
        Edit { line: start.line, column: start.column, end_line: end.line, end_column: end.column, text }
    };
    let edits = edits.unwrap_or_default().into_iter().map(edit).collect();
    Some(FixJson { title: fix.title.to_string(), safety: fix.safety, encoding, edits })
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_format as format;
    use objdict_format::Format;
    use objdict_model::source::SourceFile;

    fn report(texts: &[(&str, &str)]) -> serde_json::Value {
        let mut out = Vec::new();
        let mut report = Json::new(&mut out);
        for (name, text) in texts {
            let description = format::read(SourceFile::from_text(*name, *text), Format::Eds);
            report.file((&description).into(), &description.text_findings()).unwrap();
        }
        report.finish().unwrap();
        serde_json::from_slice(&out).unwrap()
    }

    #[test]
    fn no_findings_are_a_document_too() {
        let document = report(&[("a.eds", "[FileInfo]\n")]);
        assert_eq!(document["version"], VERSION);
        assert_eq!(document["findings"], serde_json::json!([]));
        assert_eq!(document["summary"]["files"], 1);
    }

    #[test]
    fn findings_of_all_files_are_one_list() {
        let document = report(&[("a.eds", "[A]\njunk \"°\"\n"), ("b.eds", "")]);
        let findings = document["findings"].as_array().unwrap();
        let place = |finding: &serde_json::Value| {
            (
                finding["file"].as_str().unwrap().to_owned(),
                finding["line"].as_u64(),
                finding["column"].as_u64(),
            )
        };
        assert!(findings.iter().any(|finding| place(finding) == ("a.eds".to_owned(), Some(2), Some(1))));
        assert!(findings.iter().any(|finding| finding["file"] == "b.eds"));
    }

    #[test]
    fn a_fix_is_edits_of_the_text() {
        let document = report(&[("a.eds", "[Comments]\nLines = 0\n")]);
        let findings = document["findings"].as_array().unwrap();
        let fixes: Vec<_> = findings.iter().filter(|f| f["rule"] == "cia306/blank-before-equals").collect();
        let fix = &fixes[0]["fix"];
        assert_eq!(fix["safety"], "safe");
        let edit = serde_json::json!({ "line": 2, "column": 6, "end_line": 2, "end_column": 7, "text": "" });
        assert_eq!(fix["edits"][0], edit, "{fix}");
    }
}
