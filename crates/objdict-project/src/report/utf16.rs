//! Columns in UTF-16 units, as in SARIF and editors.

use objdict_model::source::{LineColumn, SourceFile};

/// Finds lines and columns. Findings are in text order, so on a long line counting continues from the
/// previous one.
#[derive(Debug)]
pub(super) struct ColumnCounter<'a> {
    source: &'a SourceFile,
    line: usize,
    /// The end of the last count, and its column, from 0.
    at: (usize, u32),
}

impl<'a> ColumnCounter<'a> {
    pub(super) fn new(source: &'a SourceFile) -> Self {
        Self { source, line: 0, at: (0, 0) }
    }

    /// Line and column of a byte offset, both counted from 1.
    pub(super) fn at(&mut self, offset: u32) -> LineColumn {
        let text = self.source.text();
        let lines = self.source.lines();
        let line = lines.line_of(text, offset);
        let offset = (offset as usize).min(text.len());
        if line != self.line || offset < self.at.0 {
            self.line = line;
            self.at = (lines.line_span(text, line).start as usize, 0);
        }
        let between = text.get(self.at.0..offset).unwrap_or_default();
        let column = self.at.1 + between.chars().map(|c| c.len_utf16() as u32).sum::<u32>();
        self.at = (offset, column);
        LineColumn { line: lines.number(line), column: column + 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_beyond_the_basic_plane_are_two_units() {
        let text = "a°\u{1F600}b\r\nc\u{1F600}d";
        let source = SourceFile::from_text("a", text);
        let mut columns = ColumnCounter::new(&source);
        let mut at = |part: &str| columns.at(text.find(part).unwrap_or(text.len()) as u32);
        assert_eq!(at("b"), LineColumn { line: 1, column: 5 });
        assert_eq!(at("d"), LineColumn { line: 2, column: 4 });
        assert_eq!(at("°"), LineColumn { line: 1, column: 2 });
        assert_eq!(at("b"), LineColumn { line: 1, column: 5 });
        assert_eq!(at("no such"), LineColumn { line: 2, column: 5 });
    }
}
