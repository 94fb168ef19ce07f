//! What `check` found, as a page tells it.

use super::anchor::{Anchor, in_one_spelling};
use super::texts::Texts;
use crate::diagnostic::{At, Diagnostic, Severity};
use crate::model::{Part, Place};

/// A finding, told for readers who may not have the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// How grave it is.
    pub severity: Severity,
    /// The rule, such as `cia301/pdo-length-exceeded`.
    pub rule: &'static str,
    /// The defect that the rule finds.
    pub title: &'static str,
    /// The public address of the rule's page, where it has one.
    pub address: Option<String>,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
    /// Where it is in the dictionary; `None` where only the text shows it.
    pub place: Option<Place>,
    /// The line of the file, counted from 1; `None` where there is no text.
    pub line: Option<u32>,
}

impl Finding {
    /// What a page tells of a finding. The line is that of the file, see `report::Location::line_of`;
    /// `None` where there is no text.
    pub fn new(finding: &Diagnostic, line: Option<u32>) -> Self {
        let place = finding.labels.iter().find_map(|label| match &label.at {
            At::Place(place) => Some(place.clone()),
            At::Span(_) => None,
        });
        Self {
            severity: finding.severity,
            rule: finding.rule.id,
            title: finding.rule.summary,
            address: finding.rule.address(),
            message: in_one_spelling(&finding.message.to_string()),
            help: finding.help.as_ref().map(|help| in_one_spelling(&help.to_string())),
            place,
            line,
        }
    }

    /// The object or entry that it is about.
    pub(crate) fn anchor(&self) -> Option<Anchor> {
        match self.place.as_ref()?.part {
            Part::Object(index)
            | Part::CompactNames(index)
            | Part::CompactValues(index)
            | Part::CompactDenotations(index)
            | Part::Links(index) => Some(Anchor::object(index)),
            Part::Entry(index, sub) => Some(Anchor::entry(index, sub)),
            _ => None,
        }
    }
}

/// What one rule found.
#[derive(Debug)]
pub(crate) struct Found<'a> {
    /// The highest severity of its findings.
    pub(crate) severity: Severity,
    /// At least one, in the order of the description.
    pub(crate) findings: Vec<&'a Finding>,
}

impl<'a> Found<'a> {
    /// Findings by rule, the highest severity first.
    pub(crate) fn by_rule(findings: &'a [Finding]) -> Vec<Self> {
        let mut rules: Vec<Self> = Vec::new();
        for finding in findings {
            match rules.iter_mut().find(|found| found.findings[0].rule == finding.rule) {
                Some(found) => {
                    found.severity = found.severity.max(finding.severity);
                    found.findings.push(finding);
                }
                None => rules.push(Self { severity: finding.severity, findings: vec![finding] }),
            }
        }
        rules.sort_by_key(|found| std::cmp::Reverse(found.severity));
        rules
    }

    /// The word for its severity.
    pub(crate) fn severity_word(&self, texts: &Texts) -> &'static str {
        match self.severity {
            Severity::Error => texts.error,
            Severity::Warning => texts.warning,
            Severity::Note => texts.note,
        }
    }

    /// One of them, for what they share.
    pub(crate) fn first(&self) -> &'a Finding {
        self.findings[0]
    }
}

/// The parts of a message, and of each whether it is quoted from the description: what stands between backticks is, unless a
/// quoted text has one itself.
pub(crate) fn quoted(message: &str) -> Vec<(bool, &str)> {
    let parts: Vec<&str> = message.split('`').collect();
    if parts.len().is_multiple_of(2) {
        return vec![(false, message)];
    }
    parts.into_iter().enumerate().map(|(number, part)| (number % 2 == 1, part)).collect()
}
