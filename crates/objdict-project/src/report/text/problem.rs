//! An error in a text that is not a description, shown like a finding.

use miette::{LabeledSpan, Severity};

use super::Rendered;
use super::excerpt::Excerpts;
use super::printer::{Printer, WIDTH, shown};
use objdict_model::source::{SourceFile, Span};

/// A problem in a file of objdict (a profile, a configuration), with its source lines and a mark under them, without
/// colours, for the standard error.
pub fn problem(source: &SourceFile, span: Span, message: &str, help: Option<&str>) -> String {
    let excerpts = Excerpts::new(source);
    let problem = Rendered {
        code: None,
        severity: Severity::Error,
        message: shown(message),
        help: help.map(shown),
        labels: vec![LabeledSpan::new_primary_with_span(None, excerpts.cut(span))],
        excerpts: &excerpts,
        others: Vec::new(),
    };
    let mut text = String::new();
    // writing to a string cannot fail
    let _ = Printer { colour: false, width: WIDTH }.draw(&mut text, &problem, &[]);
    text
}
