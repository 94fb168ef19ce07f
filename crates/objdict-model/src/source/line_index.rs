//! Converts offsets to lines and columns.

use super::Span;

/// The position of a byte in a text; both numbers start at 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineColumn {
    /// Line, counted from 1.
    pub line: u32,
    /// Column in characters (Unicode scalar values), counted from 1.
    pub column: u32,
}

/// The lines of a text. LF, CR LF and a lone CR end a line.
#[derive(Clone, Debug)]
pub struct LineIndex {
    /// The number of lines that end before each block of the text, and in the whole text. Counting within a
    /// block is as fast as searching a table of all lines, which would need time and memory to build.
    ended: Vec<u32>,
    /// The line numbers, if the text contains only some lines of a file; otherwise empty.
    numbers: Vec<u32>,
}

/// The size of a block in bytes: a block rarely has more than three lines, and their number fits in a byte.
const BLOCK: usize = 64;

impl LineIndex {
    /// Counts the lines of `text`.
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let mut ended = Vec::with_capacity(bytes.len() / BLOCK + 2);
        let mut count = 0;
        ended.push(count);
        for start in (0..bytes.len()).step_by(BLOCK) {
            count += line_ends(bytes, start, (start + BLOCK).min(bytes.len()));
            ended.push(count);
        }
        Self { ended, numbers: Vec::new() }
    }

    /// Counts the lines of `text`, whose numbers in the file, from 1, are `numbers`.
    pub(super) fn with_numbers(text: &str, numbers: Vec<u32>) -> Self {
        Self { numbers, ..Self::new(text) }
    }

    /// The number in the file, from 1, of a line whose number in the text starts from 0.
    pub fn number(&self, line: usize) -> u32 {
        match self.numbers.as_slice() {
            [] => line as u32 + 1,
            numbers => numbers.get(line).or(numbers.last()).copied().unwrap_or(1),
        }
    }

    /// The line, numbered from 0, that contains the byte at `offset`; an offset beyond the text is treated
    /// as its end.
    pub fn line_of(&self, text: &str, offset: u32) -> usize {
        let offset = (offset as usize).min(text.len());
        let block = offset / BLOCK;
        let before = self.ended.get(block).copied().unwrap_or_default();
        (before + line_ends(text.as_bytes(), block * BLOCK, offset)) as usize
    }

    /// Line and column of `offset`; an offset beyond the text is treated as its end.
    pub fn line_column(&self, text: &str, offset: u32) -> LineColumn {
        let offset = (offset as usize).min(text.len());
        let line = self.line_of(text, offset as u32);
        let start = self.line_start(text, line).min(offset);
        let column = text.as_bytes()[start..offset].iter().filter(|&&byte| !is_continuation(byte)).count();
        LineColumn { line: self.number(line), column: column as u32 + 1 }
    }

    /// The span of a line, numbered from 0, with its line end; empty at the end of the text for a
    /// missing line.
    pub fn line_span(&self, text: &str, line: usize) -> Span {
        Span::new(self.line_start(text, line) as u32, self.line_start(text, line + 1) as u32)
    }

    /// The number of lines; a text that ends with a line end has an empty last line.
    pub fn line_count(&self) -> usize {
        self.ended.last().map_or(0, |ended| *ended as usize) + 1
    }

    /// The start of a line; the end of the text for a missing line. Scans one block, regardless of the
    /// line length.
    fn line_start(&self, text: &str, line: usize) -> usize {
        let bytes = text.as_bytes();
        // editors express "to the end" as the maximum number
        let line = line.min(self.line_count());
        // the block in which the previous line ends
        let block = self.ended.partition_point(|ended| (*ended as usize) < line).saturating_sub(1);
        let before = self.ended.get(block).map_or(0, |ended| *ended as usize);
        let mut start = if line == 0 { 0 } else { (block * BLOCK).min(bytes.len()) };
        for _ in before..line {
            start = next_line(bytes, start);
        }
        start
    }
}

/// The number of lines that end in `start..end`: at each LF, and at each CR without a following LF.
fn line_ends(bytes: &[u8], start: usize, end: usize) -> u32 {
    let here = bytes.get(start..end).unwrap_or_default();
    let behind = bytes.get(start + 1..).unwrap_or_default();
    let (lf, cr) = match here.first_chunk::<BLOCK>() {
        // its length is known, so the compiler vectorises the count
        Some(block) => (count(block, b'\n'), count(block, b'\r')),
        None => (count(here, b'\n'), count(here, b'\r')),
    };
    if cr == 0 {
        return u32::from(lf);
    }
    let followed = here.iter().zip(behind).filter(|pair| matches!(pair, (b'\r', b'\n'))).count() as u32;
    u32::from(lf) + u32::from(cr) - followed
}

/// How often a byte is in a block.
#[inline(always)]
fn count(block: &[u8], wanted: u8) -> u8 {
    block.iter().fold(0, |count, byte| count + u8::from(*byte == wanted))
}

/// The start of the next line after `at`.
fn next_line(bytes: &[u8], at: usize) -> usize {
    let rest = bytes.get(at..).unwrap_or_default();
    match memchr::memchr2(b'\n', b'\r', rest) {
        None => bytes.len(),
        Some(length) if rest[length..].starts_with(b"\r\n") => at + length + 2,
        Some(length) => at + length + 1,
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
    fn a_line_far_behind_the_end_is_the_end() {
        for text in ["", "a", "a\nb", "a\r\n", "\n\n"] {
            let index = LineIndex::new(text);
            for line in [index.line_count(), u32::MAX as usize, usize::MAX - 1] {
                assert_eq!(index.line_span(text, line), Span::empty(text.len() as u32), "{text:?} {line}");
            }
        }
    }

    #[test]
    fn lines_are_found_in_every_block() {
        for line_end in ["\n", "\r\n", "\r", "\n\r"] {
            for length in [0, 1, 40, 126, 127, 128, 300] {
                let line = format!("{}{line_end}", "x".repeat(length));
                let text = format!("{}last", line.repeat(9));
                let index = LineIndex::new(&text);
                let (mut start, mut line) = (0, 0);
                for (offset, _) in text.char_indices() {
                    let ended = text[start..offset].ends_with('\n')
                        || text[start..offset].ends_with('\r') && !text[offset..].starts_with('\n');
                    (start, line) = if ended { (offset, line + 1) } else { (start, line) };
                    assert_eq!(index.line_of(&text, offset as u32), line, "{text:?} at {offset}");
                    assert_eq!(index.line_span(&text, line).start as usize, start, "{text:?}");
                }
                assert_eq!(index.line_count(), line + 1);
                assert_eq!(index.line_span(&text, line).end as usize, text.len());
                assert_eq!(index.line_span(&text, line + 1), Span::empty(text.len() as u32));
            }
        }
    }

    #[test]
    fn columns_count_characters() {
        let text = "°C=µ";
        let index = LineIndex::new(text);
        assert_eq!(index.line_column(text, "°C=".len() as u32).column, 4);
        assert_eq!(index.line_column(text, 99).column, 5);
    }
}
