//! What findings are about.

use crate::diagnostic::At;
use crate::format::Description;
use crate::source::{SourceFile, Span};

/// What the findings of a file are about.
#[derive(Clone, Copy, Debug)]
pub enum Subject<'a> {
    /// A description.
    Description(&'a Description),
    /// Another text, such as the configuration; its findings have spans and no places.
    Text(&'a SourceFile),
}

impl<'a> Subject<'a> {
    /// The text.
    pub fn source(self) -> &'a SourceFile {
        match self {
            Self::Description(description) => description.source(),
            Self::Text(source) => source,
        }
    }

    /// Where a label points; the start of the text for what is not in it.
    pub fn span_of(self, at: &At) -> Span {
        match (self, at) {
            (Self::Description(description), at) => description.span_of(at),
            (Self::Text(_), At::Span(span)) => *span,
            (Self::Text(_), At::Place(_)) => Span::default(),
        }
    }

    /// The description; `None` for another text.
    pub fn description(self) -> Option<&'a Description> {
        match self {
            Self::Description(description) => Some(description),
            Self::Text(_) => None,
        }
    }
}

impl<'a> From<&'a Description> for Subject<'a> {
    fn from(description: &'a Description) -> Self {
        Self::Description(description)
    }
}

impl<'a> From<&'a SourceFile> for Subject<'a> {
    fn from(source: &'a SourceFile) -> Self {
        Self::Text(source)
    }
}
