//! Findings as diagnostics of the protocol.

use super::analysis::{Analysis, ReadProblem};
use super::position::{ColumnUnit, Positions};
use super::protocol::{CodeDescription, Diagnostic, Location, Range, RelatedInformation};
use super::uri::of_path;
use objdict_model::diagnostic;
use objdict_model::diagnostic::{Severity, SourceLabel, Text};
use objdict_model::source::SourceFile;
use objdict_project::report::{Subject, by_place};

/// What diagnostics say that they are from.
const SOURCE: &str = "objdict";

/// So many related places of a finding are sent.
const MAX_RELATED: usize = 50;

/// The diagnostics of a file, in the order of its text; those of the devices of a file one after the other.
pub(super) fn of(analysis: &Analysis, uri: &str, unit: ColumnUnit) -> Vec<Diagnostic> {
    let maker = DiagnosticMaker { subject: analysis.subject(), uri, unit };
    let mut made: Vec<Diagnostic> = analysis.errors.iter().map(|problem| maker.of_problem(problem)).collect();
    let of_devices = analysis.map_subjects(|subject, findings| {
        let maker = DiagnosticMaker { subject, uri, unit };
        let findings = by_place(subject, findings.clone());
        findings.listed().map(|finding| maker.of_finding(finding)).collect::<Vec<_>>()
    });
    made.extend(of_devices.into_iter().flatten());
    made
}

/// Makes diagnostics of one file.
pub(super) struct DiagnosticMaker<'a> {
    pub(super) subject: Subject<'a>,
    pub(super) uri: &'a str,
    pub(super) unit: ColumnUnit,
}

impl DiagnosticMaker<'_> {
    fn of_problem(&self, problem: &ReadProblem) -> Diagnostic {
        let positions = Positions::new(self.subject.source(), self.unit);
        Diagnostic {
            range: positions.range(problem.span),
            severity: number(Severity::Error),
            source: SOURCE,
            message: with_help(problem.message.clone(), problem.help.as_deref()),
            ..Diagnostic::default()
        }
    }

    /// The diagnostic of a finding. The places that belong to it follow.
    pub(super) fn of_finding(&self, finding: &diagnostic::Diagnostic) -> Diagnostic {
        let related = finding.labels.iter().skip(1).filter_map(|label| self.related(label, &label.text));
        let related: Vec<_> = related.take(MAX_RELATED).collect();
        let help = finding.help.as_ref().map(Text::shown);
        Diagnostic {
            range: self.range_of(finding),
            severity: number(finding.severity),
            code: Some(finding.rule.id),
            code_description: finding.rule.address().map(|href| CodeDescription { href }),
            source: SOURCE,
            message: with_help(finding.message.shown().into_owned(), help.as_deref()),
            related_information: (!related.is_empty()).then_some(related),
        }
    }

    /// Where a finding is; the start of the text for one that is nowhere in it.
    pub(super) fn range_of(&self, finding: &diagnostic::Diagnostic) -> Range {
        let place = finding.labels.first().map(|label| self.located(label));
        let place = place.filter(|(source, _)| std::ptr::eq(*source, self.subject.source()));
        place.map(|(_, range)| range).unwrap_or_default()
    }

    fn located(&self, label: &SourceLabel) -> (&SourceFile, Range) {
        let of_label = self.subject.of_label(&label.at);
        let positions = Positions::new(of_label.source(), self.unit);
        (of_label.source(), positions.range(self.subject.span_of(&label.at)))
    }

    fn related(&self, label: &SourceLabel, text: &Text) -> Option<RelatedInformation> {
        let (source, range) = self.located(label);
        let is_own = std::ptr::eq(source, self.subject.source());
        let uri = if is_own { self.uri.to_owned() } else { of_path(source.name().as_ref())? };
        Some(RelatedInformation { location: Location { uri, range }, message: text.shown().into_owned() })
    }
}

/// The number of a severity in the protocol.
const fn number(severity: Severity) -> u8 {
    match severity {
        Severity::Error => 1,
        Severity::Warning => 2,
        Severity::Note => 3,
    }
}

fn with_help(message: String, help: Option<&str>) -> String {
    match help {
        Some(help) => format!("{message}\nhelp: {help}"),
        None => message,
    }
}
