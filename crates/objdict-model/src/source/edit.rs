//! Edits a source by spans: the rest of the text remains unchanged, byte for byte.

use super::{SourceFile, Span, Unencodable};

/// The maximum number of separate changes, for changes that can occur in every line or character.
const MAX_EDITS: usize = 50_000;

/// Changes to one source, in any order. The editors of the formats determine their positions.
#[derive(Clone, Debug)]
pub struct Edits<'a> {
    source: &'a SourceFile,
    changes: Vec<SpanEdit>,
}

/// A span and its replacement; changes at the same offset keep their order.
#[derive(Clone, Debug)]
struct SpanEdit {
    span: Span,
    text: String,
}

/// Why a source cannot be edited.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EditError {
    /// Two edits touch the same bytes.
    Overlap(Span),
    /// The bytes of the file cannot be restored from its text, so an edited text cannot be written.
    ReadOnly(String),
    /// A new key, value or section name contains a line end.
    LineEnd(String),
    /// A new name, value or text contains a character that is not allowed in XML.
    NotXml(String),
    /// The file format can only be read.
    NotWritten(String),
    /// The new text would be read differently.
    OtherMeaning(String),
    /// A new text violates the standard: a bug in objdict.
    NotValid(String),
    /// Reading the new text back would lose more values of the description than allowed.
    TooMuchLost {
        /// The number of losses, including their places.
        count: usize,
        /// The limit.
        limit: usize,
    },
    /// A new text has a character that the encoding of the file lacks.
    Unencodable(Unencodable),
}

crate::error_messages! { EditError: from Unencodable as Unencodable {
    Self::Overlap(span) => "two edits touch the same text, at bytes {} to {}", span.start, span.end;
    Self::ReadOnly(name) =>
        "`{name}` is not valid in its encoding and cannot be edited; save the file as UTF-8 first";
    Self::LineEnd(text) => "`{}` contains a line end", text.escape_debug();
    Self::NotXml(text) => "`{}` cannot be written in XML", text.escape_debug();
    Self::NotWritten(name) =>
        "`{name}` is in a format that objdict reads and does not write; convert it, for example to XDD";
    Self::OtherMeaning(text) => "`{text}` cannot be formatted without changing its meaning";
    Self::NotValid(problem) => "objdict would write invalid text: {problem}";
    Self::TooMuchLost { count, limit } =>
        "the format cannot store {count} values of the description, more than the limit of {limit}";
    Self::Unencodable(error) => "{error}";
} }

impl<'a> Edits<'a> {
    /// No changes.
    pub fn new(source: &'a SourceFile) -> Self {
        Self { source, changes: Vec::new() }
    }

    /// The source.
    pub fn source(&self) -> &'a SourceFile {
        self.source
    }

    /// Whether there are no changes.
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// Replaces `span` by `text`; an empty span is an insertion point.
    pub fn replace(&mut self, span: Span, text: impl Into<String>) {
        self.changes.push(SpanEdit { span, text: text.into() });
    }

    /// Replaces `span`, which follows all previous changes, by `text`. Beyond 50,000 changes, the last change also
    /// covers it and the text between them: a file that consists of such spans would need a hundred times its size.
    pub fn append(&mut self, span: Span, text: &str) {
        let is_full = self.changes.len() >= MAX_EDITS;
        match self.changes.last_mut() {
            Some(last) if is_full => {
                last.text.push_str(Span::new(last.span.end, span.start).of(self.source.text()));
                last.text.push_str(text);
                last.span.end = span.end;
            }
            _ => self.replace(span, text),
        }
    }

    /// The changes in the order of the text; changes at one offset are merged.
    ///
    /// # Errors
    /// If two changes overlap.
    pub fn into_list(mut self) -> Result<Vec<(Span, String)>, EditError> {
        self.changes.sort_by_key(|change| (change.span.start, change.span.end));
        let mut list: Vec<(Span, String)> = Vec::with_capacity(self.changes.len());
        for SpanEdit { span, text } in self.changes {
            match list.last_mut() {
                Some((last, _)) if span.start < last.end => return Err(EditError::Overlap(span)),
                Some((last, before)) if last.is_empty() && span.is_empty() && *last == span => {
                    before.push_str(&text);
                }
                _ => list.push((span, text)),
            }
        }
        Ok(list)
    }

    /// The edited text.
    ///
    /// # Errors
    /// If two changes overlap.
    pub fn text(&self) -> Result<String, EditError> {
        let text = self.source.text();
        let mut changes: Vec<&SpanEdit> = self.changes.iter().collect();
        changes.sort_by_key(|change| (change.span.start, change.span.end));
        let mut edited = String::with_capacity(text.len());
        let mut at = 0;
        for change in changes {
            if change.span.start < at {
                return Err(EditError::Overlap(change.span));
            }
            edited.push_str(Span::new(at, change.span.start).of(text));
            edited.push_str(&change.text);
            at = change.span.end;
        }
        edited.push_str(Span::new(at, text.len() as u32).of(text));
        Ok(edited)
    }

    /// The edited text in the encoding of the file; without changes, the original bytes.
    ///
    /// # Errors
    /// If two changes overlap, or the file cannot be written in its encoding.
    pub fn to_bytes(&self) -> Result<Vec<u8>, EditError> {
        if self.is_empty() {
            return Ok(self.source.to_bytes());
        }
        if self.source.is_read_only() {
            return Err(EditError::ReadOnly(self.source.name().to_owned()));
        }
        Ok(self.source.encode(&self.text()?)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_come_in_the_order_of_the_text() {
        let source = SourceFile::from_text("test", "abc");
        let mut edits = Edits::new(&source);
        edits.replace(Span::new(2, 3), "z");
        edits.replace(Span::empty(1), "1");
        edits.replace(Span::empty(1), "2");
        edits.replace(Span::new(1, 2), "");
        assert_eq!(edits.text(), Ok("a12z".to_owned()));
    }

    #[test]
    fn changes_at_one_offset_are_one() {
        let source = SourceFile::from_text("test", "abc");
        let mut edits = Edits::new(&source);
        edits.replace(Span::new(1, 2), "");
        edits.replace(Span::empty(1), "1");
        edits.replace(Span::empty(1), "2");
        let list = [(Span::empty(1), "12".to_owned()), (Span::new(1, 2), String::new())];
        assert_eq!(edits.into_list(), Ok(list.to_vec()));
    }

    #[test]
    fn overlapping_changes_are_an_error() {
        let source = SourceFile::from_text("test", "abcd");
        let mut edits = Edits::new(&source);
        edits.replace(Span::new(0, 3), "x");
        edits.replace(Span::new(2, 4), "y");
        assert_eq!(edits.to_bytes(), Err(EditError::Overlap(Span::new(2, 4))));
    }
}
