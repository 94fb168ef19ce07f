//! Offsets to lines and columns.

use super::Span;

/// Where a byte stands in a text, as people count: both numbers start at 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineColumn {
    /// Line, counted from 1.
    pub line: u32,
    /// Column in characters (Unicode scalar values), counted from 1.
    pub column: u32,
}

/// The starts of all lines of a text. LF, CR LF and a lone CR end a line.
#[derive(Clone, Debug)]
pub struct LineIndex {
    starts: Vec<u32>,
}

impl LineIndex {
    /// Finds the line starts of `text`.
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let mut starts = vec![0];
        for at in memchr::memchr2_iter(b'\n', b'\r', bytes) {
            let crlf = bytes[at] == b'\r' && bytes.get(at + 1) == Some(&b'\n');
            if !crlf {
                starts.push(at as u32 + 1);
            }
        }
        Self { starts }
    }

    /// The line, counted from 0, that holds the byte at `offset`.
    pub fn line_of(&self, offset: u32) -> usize {
        self.starts.partition_point(|&start| start <= offset).saturating_sub(1)
    }

    /// Line and column of `offset`; an offset beyond the text counts as its end.
    pub fn line_column(&self, text: &str, offset: u32) -> LineColumn {
        let offset = (offset as usize).min(text.len());
        let line = self.line_of(offset as u32);
        let start = self.starts[line] as usize;
        let column = text.as_bytes()[start..offset].iter().filter(|&&byte| !is_continuation(byte)).count();
        LineColumn { line: line as u32 + 1, column: column as u32 + 1 }
    }

    /// The span of a line, counted from 0, with its line end; empty at the end for a line that is not there.
    pub fn line_span(&self, text: &str, line: usize) -> Span {
        let end = text.len() as u32;
        let start = self.starts.get(line).copied().unwrap_or(end);
        Span::new(start, self.starts.get(line + 1).copied().unwrap_or(end))
    }

    /// Number of lines; a text that ends with a line end has an empty last line.
    pub fn line_count(&self) -> usize {
        self.starts.len()
    }
}

fn is_continuation(byte: u8) -> bool {
    byte & 0b1100_0000 == 0b1000_0000
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_end_counts_once() {
        let text = "a\r\nb\rc\nd";
        let index = LineIndex::new(text);
        assert_eq!(index.line_count(), 4);
        assert_eq!(index.line_column(text, 3), LineColumn { line: 2, column: 1 });
        assert_eq!(index.line_column(text, 5), LineColumn { line: 3, column: 1 });
        assert_eq!(index.line_column(text, 7), LineColumn { line: 4, column: 1 });
    }

    #[test]
    fn columns_count_characters() {
        let text = "°C=µ";
        let index = LineIndex::new(text);
        assert_eq!(index.line_column(text, "°C=".len() as u32).column, 4);
        assert_eq!(index.line_column(text, 99).column, 5);
    }
}
