//! SARIF 2.1.0 (OASIS), the format of code scanning services.
//!
//! Results are written immediately. Their rules, the files and the result of the run follow them, so a long run needs
//! no more memory than the list of its files.

mod log;

use std::collections::HashMap;
use std::io::{self, Write};
use std::path::Path;

use super::fingerprint::listed;
use super::group::joint_fix;
use super::path::{RelativeBase, uri};
use super::utf16::ColumnCounter;
use super::{FINGERPRINT_NAME, Fingerprint, Report, Subject};
use log::{
    Artifact, ArtifactChange, ArtifactLocation, AssociatedRule, Content, Fix, FixProperties, Invocation,
    Location, LogicalLocation, Message, Notification, PhysicalLocation, Region, Replacement,
    Result as Finding, Run, SOURCE_ROOT,
};
use objdict_model::diagnostic::printable_lines;
use objdict_model::diagnostic::{At, Diagnostic, Findings, RuleInfo, Severity};
use objdict_model::model::Place;
use objdict_model::source::{Encoding, SourceFile, Span};

/// Findings as a SARIF log with one run, one result a line.
#[derive(Debug)]
pub struct Sarif<W> {
    out: W,
    base: RelativeBase,
    is_empty: bool,
    rules: Vec<&'static RuleInfo>,
    rule_numbers: HashMap<&'static str, usize>,
    artifacts: Vec<Artifact>,
    artifact_numbers: HashMap<String, usize>,
    notifications: Vec<Notification>,
    has_failed: bool,
    exit_code: Option<u8>,
}

impl<W: Write> Sarif<W> {
    /// A report that writes to `out`.
    pub fn new(out: W) -> Self {
        Self {
            out,
            base: RelativeBase::default(),
            is_empty: true,
            rules: Vec::new(),
            rule_numbers: HashMap::new(),
            artifacts: Vec::new(),
            artifact_numbers: HashMap::new(),
            notifications: Vec::new(),
            has_failed: false,
            exit_code: None,
        }
    }

    /// Sets the folder that paths are relative to, which is the repository's.
    #[must_use]
    pub fn base(mut self, folder: &Path) -> Self {
        self.base = RelativeBase::new(folder);
        self
    }

    /// The text before the first result.
    fn start(&mut self) -> io::Result<()> {
        if self.is_empty {
            write!(self.out, "{{\"$schema\":\"{}\",\"version\":\"2.1.0\",\"runs\":[{{", log::SCHEMA)?;
            write!(
                self.out,
                "\"columnKind\":\"utf16CodeUnits\",\"newlineSequences\":[\"\\r\\n\",\"\\n\",\"\\r\"],\n\"results\":["
            )?;
        }
        Ok(())
    }

    /// The number of a rule among those with findings.
    fn rule(&mut self, rule: &'static RuleInfo) -> usize {
        let next = self.rules.len();
        let number = *self.rule_numbers.entry(rule.id).or_insert(next);
        if number == next {
            self.rules.push(rule);
        }
        number
    }

    /// The location of a file, which is added to the artifacts.
    fn artifact(&mut self, subject: Subject<'_>) -> ArtifactLocation {
        let source = subject.source();
        let uri = uri(&self.base.relative(source.name()));
        let next = self.artifacts.len();
        let number = *self.artifact_numbers.entry(uri.clone()).or_insert(next);
        let is_relative = !uri.starts_with("file:");
        let location =
            ArtifactLocation { uri, uri_base_id: is_relative.then_some(SOURCE_ROOT), index: number };
        if number == next {
            let role = match subject {
                Subject::Text(_) => "userSpecifiedConfiguration",
                _ => "analysisTarget",
            };
            let encoding = encoding(source.encoding());
            self.artifacts.push(Artifact { location: location.clone(), encoding, roles: [role] });
        }
        location
    }

    fn notify(&mut self, level: &'static str, text: &str, rule: Option<AssociatedRule>) {
        self.notifications.push(Notification { level, message: message(text), associated_rule: rule });
    }
}

impl<W: Write> Report for Sarif<W> {
    fn file(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()> {
        let mut file = self.open(subject);
        for (finding, fingerprint) in listed(subject, findings) {
            let number = self.rule(finding.rule);
            self.start()?;
            self.out.write_all(if self.is_empty { b"\n" } else { b",\n" })?;
            self.is_empty = false;
            let result = self.result(&mut file, finding, number, fingerprint);
            objdict_model::json::write(&mut self.out, &result)?;
        }
        for (rule, count) in findings.unlisted() {
            let text = format!("{}: {count} more findings of {rule} are not shown", subject.source().name());
            let associated = self.rule_numbers.get(rule).map(|&index| AssociatedRule { id: rule, index });
            self.notify("note", &text, associated);
        }
        Ok(())
    }

    fn unread(&mut self, message: &str) -> io::Result<()> {
        self.has_failed = true;
        self.notify("error", message, None);
        Ok(())
    }

    fn exit_code(&mut self, code: u8) {
        self.exit_code = Some(code);
    }

    fn finish(&mut self) -> io::Result<()> {
        self.start()?;
        self.out.write_all(if self.is_empty { b"]" } else { b"\n]" })?;
        let has_relative = self.artifacts.iter().any(|artifact| artifact.location.uri_base_id.is_some());
        let invocation = Invocation {
            execution_successful: self.exit_code.map_or(!self.has_failed, |code| code < 2),
            exit_code: self.exit_code,
            exit_code_description: self.exit_code.map(log::exit_code_description),
            tool_execution_notifications: &self.notifications,
        };
        let run = Run::new(&self.rules, &self.artifacts, has_relative, invocation);
        run.write(&mut self.out)?;
        self.out.write_all(b"}]}\n")?;
        self.out.flush()
    }
}

impl<W: Write> Sarif<W> {
    /// A file that contains places.
    fn open<'a>(&mut self, subject: Subject<'a>) -> SarifFile<'a> {
        SarifFile { subject, artifact: self.artifact(subject), columns: ColumnCounter::new(subject.source()) }
    }

    fn result(
        &mut self,
        file: &mut SarifFile<'_>,
        finding: &Diagnostic,
        rule_index: usize,
        fingerprint: Fingerprint,
    ) -> Finding {
        let mut labels = finding.labels.iter();
        let primary = labels.next().map(|label| file.location(None, &label.at, &label.text.shown()));
        let related = labels.map(|label| (&label.at, label.text.shown())).enumerate();
        let related = related.map(|(id, (at, text))| match at {
            At::Node(..) | At::Patch(..) => {
                self.open(file.subject.of_label(at)).location(Some(id), at, &text)
            }
            _ => file.location(Some(id), at, &text),
        });
        let related: Vec<Location> = related.collect();
        let text = match &finding.help {
            Some(help) => format!("{}\nhelp: {help}", finding.message),
            None => finding.message.to_string(),
        };
        Finding {
            rule_id: finding.rule.id,
            rule_index,
            level: level(finding.severity),
            message: message(&text),
            locations: primary.into_iter().collect(),
            related_locations: related,
            partial_fingerprints: [(FINGERPRINT_NAME, fingerprint)].into(),
            fixes: file.fix(finding).into_iter().collect(),
        }
    }
}

/// A file whose findings are written, or to which they refer.
struct SarifFile<'a> {
    subject: Subject<'a>,
    artifact: ArtifactLocation,
    columns: ColumnCounter<'a>,
}

impl SarifFile<'_> {
    fn location(&mut self, id: Option<usize>, at: &At, text: &str) -> Location {
        let span = self.subject.span_of(at);
        let mut region = self.region(span);
        if let Some(start) = bytes_before_text(self.subject.source()) {
            region.byte_offset = Some(start + span.start);
            region.byte_length = Some(span.len());
        }
        let place = self.subject.description().and_then(|description| description.place_of(at));
        Location {
            id,
            physical_location: PhysicalLocation { artifact_location: self.artifact.clone(), region },
            logical_locations: place.iter().map(|place| logical_location(place)).collect(),
            message: Some(text).filter(|text| !text.is_empty()).map(message),
        }
    }

    fn region(&mut self, span: Span) -> Region {
        let (start, end) = (self.columns.at(span.start), self.columns.at(span.end));
        Region {
            start_line: start.line,
            start_column: start.column,
            end_line: end.line,
            end_column: end.column,
            byte_offset: None,
            byte_length: None,
        }
    }

    /// The fix of a finding, if this text can be changed accordingly.
    fn fix(&mut self, finding: &Diagnostic) -> Option<Fix> {
        let description = self.subject.description()?;
        let fix = joint_fix(description, finding)?;
        let replacement = |(span, text): (Span, String)| Replacement {
            deleted_region: self.region(span),
            inserted_content: Some(text).filter(|text| !text.is_empty()).map(|text| Content { text }),
        };
        let replacements = description.edits(&fix)?.into_iter().map(replacement).collect();
        Some(Fix {
            description: message(&fix.title.shown()),
            artifact_changes: [ArtifactChange { artifact_location: self.artifact.clone(), replacements }],
            properties: FixProperties { safety: fix.safety },
        })
    }
}

/// A place of the object dictionary.
fn logical_location(place: &Place) -> LogicalLocation {
    let part = place.part.to_string();
    LogicalLocation {
        name: place.field.as_ref().map_or_else(|| part.clone(), |field| field.name().into_owned()),
        fully_qualified_name: place.to_string(),
        kind: if place.field.is_some() { "property" } else { "object" },
    }
}

/// The number of bytes before the text in the file; `None` if offsets in the text do not correspond to the
/// file.
fn bytes_before_text(source: &SourceFile) -> Option<u32> {
    match source.encoding() {
        _ if source.is_read_only() => None,
        Encoding::Utf8 => Some(0),
        Encoding::Utf8Bom => Some(3),
        _ => None,
    }
}

/// The name of an encoding as IANA registers it.
fn encoding(encoding: Encoding) -> &'static str {
    match encoding {
        Encoding::Utf8 | Encoding::Utf8Bom => "UTF-8",
        Encoding::Windows1252 => "windows-1252",
        Encoding::Cp850 => "IBM850",
        Encoding::Utf16Le | Encoding::Utf16Be => "UTF-16",
    }
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

/// A text as a message (§3.11): braces are doubled, because `{0}` is a placeholder, and links are disabled, because
/// messages quote untrusted files.
fn message(text: &str) -> Message {
    let text = printable_lines(text);
    Message { text: text.replace('{', "{{").replace('}', "}}").replace("](", "] (") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_hold_no_placeholders_and_no_links() {
        let text = "`[a](http://b)` and {0}\u{1B}[31m\nhelp";
        assert_eq!(message(text).text, "`[a] (http://b)` and {{0}}\u{FFFD}[31m\nhelp");
    }

    #[test]
    fn a_run_over_nothing_is_a_log() {
        let mut out = Vec::new();
        let mut report = Sarif::new(&mut out);
        report.unread("`x` is gone").unwrap();
        report.finish().unwrap();
        let log: serde_json::Value = serde_json::from_slice(&out).unwrap();
        let run = &log["runs"][0];
        assert_eq!(run["results"], serde_json::json!([]));
        assert_eq!(run["tool"]["driver"]["rules"], serde_json::json!([]));
        let invocation = &run["invocations"][0];
        assert_eq!(invocation["executionSuccessful"], false);
        assert_eq!(invocation["toolExecutionNotifications"][0]["message"]["text"], "`x` is gone");
    }

    #[test]
    fn a_fix_is_a_replacement_in_utf_16() {
        let text = "[Comments]\nLines=1\nLine1\u{1F600} =x\n";
        let source = objdict_model::source::SourceFile::from_text("a b.eds", text);
        let description = objdict_format::read(source, objdict_format::Format::Eds);
        let mut out = Vec::new();
        let mut report = Sarif::new(&mut out);
        report.file((&description).into(), &crate::check(&description)).unwrap();
        report.finish().unwrap();
        let log: serde_json::Value = serde_json::from_slice(&out).unwrap();
        let results = log["runs"][0]["results"].as_array().unwrap();
        let blank = results.iter().find(|result| result["ruleId"] == "cia306/blank-before-equals").unwrap();
        let change = &blank["fixes"][0]["artifactChanges"][0];
        assert_eq!(change["artifactLocation"]["uri"], "a%20b.eds");
        let region = serde_json::json!({ "startLine": 3, "startColumn": 8, "endLine": 3, "endColumn": 9 });
        assert_eq!(change["replacements"][0]["deletedRegion"], region);
    }
}
