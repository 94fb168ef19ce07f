//! A mistake in a text that is no description, shown like a finding.

use std::fmt;

use miette::LabeledSpan;

use super::excerpt::Excerpts;
use super::printer::{Printer, WIDTH, shown};
use objdict_model::source::{SourceFile, Span};

/// A problem in a file of objdict (a profile, a configuration), with the lines and a mark under them, without colours:
/// it goes to the standard error.
pub fn problem(source: &SourceFile, span: Span, message: &str, help: Option<&str>) -> String {
    let excerpts = Excerpts::new(source);
    let label = LabeledSpan::new_primary_with_span(None, excerpts.cut(span));
    let problem = DrawnProblem { message: shown(message), help: help.map(shown), excerpts, label };
    let mut text = String::new();
    // writing to a string cannot fail
    let _ = Printer { colour: false, width: WIDTH }.draw(&mut text, &problem, &[]);
    text
}

#[derive(Debug)]
struct DrawnProblem<'a> {
    message: String,
    help: Option<String>,
    excerpts: Excerpts<'a>,
    label: LabeledSpan,
}

impl fmt::Display for DrawnProblem<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for DrawnProblem<'_> {}

impl miette::Diagnostic for DrawnProblem<'_> {
    fn severity(&self) -> Option<miette::Severity> {
        Some(miette::Severity::Error)
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn miette::SourceCode> {
        Some(&self.excerpts)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(std::iter::once(self.label.clone())))
    }
}
