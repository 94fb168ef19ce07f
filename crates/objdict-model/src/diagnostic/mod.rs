//! Findings as plain data: a rule, a severity, a message, places or spans, a help and a fix.
//!
//! Rules use [`Place`]s of the model; the reader of the file maps a place to a [`Span`] of the text, and
//! only for reported findings. Rendering is up to the reports.

mod findings;
mod fix;
mod notion;
mod rule;
mod safety;
mod text;
mod words;

use crate::model::Place;
use crate::source::SourceFile;
pub use crate::source::Span;

pub use crate::{fix_of, rule_info, say, text_rules};
pub use findings::{Findings, MAX_PER_RULE};
pub use fix::{Change, Fix, MAX_FIX_LINES, Tidy};
pub use notion::{Notion, Vocabulary, WORDS, assert_template, section_name};
pub use rule::{Explained, HOME, PUBLISHED, Reach, RuleInfo, Selection, Stop, Tool};
pub use safety::{Applicability, FixSafety};
pub use text::{Argument, MAX_QUOTED, Sayable, Text, joined, listing, listing_or, series, series_or};
pub use words::{
    counted, counted_bits, misspelled, nearest, one_line, plural, printable, printable_lines, sub_index,
    visible,
};

named! {
    /// The severity of a finding.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
    pub enum Severity {
        /// Style, or compatibility with a tool.
        Note = "note",
        /// A violation of the specification, or a suspicious value.
        Warning = "warning",
        /// A tool or a device will malfunction.
        Error = "error",
    }
}

/// The place of a label.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum At {
    /// Bytes of the text; only the reader of a format knows their position.
    Span(Span),
    /// An address in the model.
    Place(Place),
    /// An address in the description of a node of a network, by the position of the node, or in the type description of
    /// a configured node (0); for related places.
    Node(usize, Place),
    /// Bytes of a patch, by the position of the patch among those applied to the description; for related
    /// places.
    Patch(usize, Span),
}

impl From<Span> for At {
    fn from(span: Span) -> Self {
        Self::Span(span)
    }
}

impl From<Place> for At {
    fn from(place: Place) -> Self {
        Self::Place(place)
    }
}

/// A place with a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceLabel {
    /// The place.
    pub at: At,
    /// The text; empty if the message is sufficient.
    pub text: Text,
}

/// One finding.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// The rule of the finding.
    pub rule: &'static RuleInfo,
    /// The severity: the default of the rule unless the configuration overrides it.
    pub severity: Severity,
    /// The problem: lower case, offending text in backticks, no full stop.
    pub message: Text,
    /// The places; the first label is the place of the finding, others are related places.
    pub labels: Vec<SourceLabel>,
    /// The help, as an imperative.
    pub help: Option<Text>,
    /// The automatic fix, if there is one.
    pub fix: Option<Fix>,
    /// Findings with the same cause that a report joins with this one.
    pub also: Vec<Diagnostic>,
    /// Whether the model is correct despite the finding: objdict parsed the obvious meaning, or no entry
    /// depends on it.
    pub is_understood: bool,
}

impl Diagnostic {
    /// A finding of `rule` at a place or span.
    pub fn new(rule: &'static RuleInfo, at: impl Into<At>, message: impl Into<Text>) -> Self {
        Self {
            rule,
            severity: rule.severity,
            message: message.into(),
            labels: vec![SourceLabel { at: at.into(), text: "".into() }],
            help: None,
            fix: None,
            also: Vec::new(),
            is_understood: false,
        }
    }

    /// Whether the finding makes this target's generated tables wrong: it is an error, its rule lists the target and
    /// the affected fields, and objdict did not parse the intended meaning.
    pub fn stops(&self, target: &str) -> bool {
        let fields = || {
            self.labels.iter().filter_map(|label| match &label.at {
                At::Place(place) => place.field.as_ref(),
                _ => None,
            })
        };
        let applies = |stop: &Stop| ["*", target].contains(&stop.target);
        let is_about =
            |stop: &Stop| stop.fields.is_empty() || fields().any(|field| stop.fields.contains(field));
        let is_error = self.severity == Severity::Error && !self.is_understood;
        is_error && self.rule.stops.iter().any(|stop| applies(stop) && is_about(stop))
            || self.also.iter().any(|other| other.stops(target))
    }

    /// Whether it is an error in a key written for objdict. Its content then seems to be missing elsewhere, so it is
    /// reported first.
    pub fn is_key_error(&self) -> bool {
        self.rule.group() == "keys" && self.severity == Severity::Error
    }

    /// The finding as a line: the file with line and column, the severity, the rule and the message.
    pub fn line(&self, source: &SourceFile, span_of: impl FnOnce(&At) -> Span) -> String {
        let start = self.labels.first().map_or(0, |label| span_of(&label.at).start);
        let start = source.line_column(start);
        let (name, severity, rule) = (source.name(), self.severity, self.rule.id);
        one_line(&format!("{name}:{}:{}: {severity} {rule}: {}", start.line, start.column, self.message))
    }

    /// Overrides the severity of the rule.
    #[must_use]
    pub fn severity(mut self, severity: Severity) -> Self {
        self.severity = severity;
        self
    }

    /// Marks the entries of the model as correct.
    #[must_use]
    pub fn understood(mut self) -> Self {
        self.is_understood = true;
        self
    }

    /// Adds a related place.
    #[must_use]
    pub fn label(mut self, at: impl Into<At>, text: impl Into<Text>) -> Self {
        self.labels.push(SourceLabel { at: at.into(), text: text.into() });
        self
    }

    /// Adds related places with the same text; `None` adds none.
    #[must_use]
    pub fn label_each(mut self, places: impl IntoIterator<Item = At>, text: impl Into<Text>) -> Self {
        let text = text.into();
        self.labels.extend(places.into_iter().map(|at| SourceLabel { at, text: text.clone() }));
        self
    }

    /// Adds a help.
    #[must_use]
    pub fn help(mut self, help: impl Into<Text>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Uses the terms of a different syntax.
    #[must_use]
    pub fn in_words(mut self, words: Vocabulary) -> Self {
        self.message = self.message.in_words(words);
        self.help = self.help.map(|help| help.in_words(words));
        for label in &mut self.labels {
            label.text = std::mem::take(&mut label.text).in_words(words);
        }
        if let Some(fix) = &mut self.fix {
            fix.title = std::mem::take(&mut fix.title).in_words(words);
        }
        self
    }

    /// Adds a fix.
    #[must_use]
    pub fn fix(mut self, fix: Fix) -> Self {
        self.fix = Some(fix);
        self
    }
}
