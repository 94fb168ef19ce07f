//! Findings of `check` on a page.

use super::anchor::{Anchor, in_one_spelling};
use super::texts::LanguageTexts;
use crate::diagnostic::{At, Diagnostic, Severity};
use crate::model::{Device, Part, Place};

/// A finding, for readers who may not have the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The severity.
    pub severity: Severity,
    /// The rule, such as `cia301/pdo-length-exceeded`.
    pub rule: &'static str,
    /// The problem that the rule finds.
    pub title: &'static str,
    /// The public URL of the rule's page ([`RuleInfo::address`](crate::diagnostic::RuleInfo::address)).
    pub address: Option<String>,
    /// The message.
    pub message: String,
    /// How to fix it.
    pub help: Option<String>,
    /// The place in the dictionary; `None` if it has only a position in the text.
    pub place: Option<Place>,
    /// The places of the findings that are joined with it ([`Diagnostic::also`]).
    pub also: Vec<Place>,
    /// The line in the file, counted from 1; `None` without a text.
    pub line: Option<u32>,
}

impl Finding {
    /// Converts a diagnostic. For the line in the file see `report::Location::line_of`; `None` without a
    /// text.
    pub fn new(finding: &Diagnostic, line: Option<u32>) -> Self {
        let place = |finding: &Diagnostic| {
            finding.labels.iter().find_map(|label| match &label.at {
                At::Place(place) => Some(place.clone()),
                At::Span(_) | At::Node(..) | At::Patch(..) => None,
            })
        };
        Self {
            severity: finding.severity,
            rule: finding.rule.id,
            title: finding.rule.summary,
            address: finding.rule.address(),
            message: in_one_spelling(&finding.message.to_string()),
            help: finding.help.as_ref().map(|help| in_one_spelling(&help.to_string())),
            place: place(finding),
            also: finding.also.iter().filter_map(place).collect(),
            line,
        }
    }

    /// Moves the finding to the page of a device, which does not contain disabled objects.
    #[must_use]
    pub fn on_page_of(mut self, device: &Device) -> Self {
        let is_there =
            |place: &Place| place.part.object().is_none_or(|index| device.objects.contains_key(&index));
        self.place = self.place.filter(is_there);
        self.also.retain(is_there);
        self
    }

    /// The object or entry of the finding.
    pub(crate) fn anchor(&self) -> Option<Anchor> {
        anchor(self.place.as_ref()?)
    }

    /// The objects and entries of the findings that are joined with it.
    pub(crate) fn others(&self) -> Vec<Anchor> {
        self.also.iter().filter_map(anchor).collect()
    }
}

fn anchor(place: &Place) -> Option<Anchor> {
    match place.part {
        Part::Entry(index, sub) => Some(Anchor::entry(index, sub)),
        ref part => part.object().map(Anchor::object),
    }
}

/// The findings of one rule.
pub(crate) struct RuleFindings<'a> {
    /// The highest severity of its findings.
    pub(crate) severity: Severity,
    /// At least one, in the order of the description.
    pub(crate) findings: Vec<&'a Finding>,
}

impl<'a> RuleFindings<'a> {
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
    pub(crate) fn severity_word(&self, texts: &LanguageTexts) -> &'static str {
        match self.severity {
            Severity::Error => texts.error,
            Severity::Warning => texts.warning,
            Severity::Note => texts.note,
        }
    }

    /// The first finding, for properties common to all.
    pub(crate) fn first(&self) -> &'a Finding {
        self.findings[0]
    }
}

/// Splits a message into parts and flags quotations from the description: text between backticks, unless
/// the quotation contains a backtick.
pub(crate) fn quoted(message: &str) -> Vec<(bool, &str)> {
    let parts: Vec<&str> = message.split('`').collect();
    if parts.len().is_multiple_of(2) {
        return vec![(false, message)];
    }
    parts.into_iter().enumerate().map(|(number, part)| (number % 2 == 1, part)).collect()
}
