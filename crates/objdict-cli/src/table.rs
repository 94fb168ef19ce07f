//! Text in columns.

use std::io::{self, Write};

use objdict_model::diagnostic::one_line;

/// Columns with a heading; a column that is empty in every row is left out, and the headings when there are none.
pub(crate) struct TextTable<const N: usize> {
    headings: [&'static str; N],
    /// The texts of all cells, row by row, and where each of them ends: a string for each cell would take twice the time.
    text: String,
    ends: Vec<usize>,
    /// The most characters that a cell shows.
    limit: usize,
}

impl<const N: usize> TextTable<N> {
    pub(crate) fn new(headings: [&'static str; N], limit: usize) -> Self {
        Self { headings, text: String::new(), ends: Vec::new(), limit }
    }

    pub(crate) fn row(&mut self, cells: [String; N]) {
        for cell in cells {
            if is_plain(&cell, self.limit) {
                self.text.push_str(&cell);
            } else {
                self.text.push_str(&fit(&cell, self.limit));
            }
            self.ends.push(self.text.len());
        }
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    fn cells(&self) -> impl Iterator<Item = &str> {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.text[start..end])
    }

    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let is_ascii = self.text.is_ascii();
        let length = |cell: &str| if is_ascii { cell.len() } else { cell.chars().count() };
        let mut widths = [0; N];
        for (at, cell) in self.cells().enumerate() {
            widths[at % N] = length(cell).max(widths[at % N]);
        }
        let has_headings = self.headings.iter().any(|heading| !heading.is_empty());
        for (width, heading) in widths.iter_mut().zip(self.headings).filter(|(width, _)| **width > 0) {
            *width = heading.len().max(*width);
        }
        let blanks = " ".repeat(widths.iter().max().unwrap_or(&0) + 2);
        let headings = self.headings.into_iter().filter(|_| has_headings);
        let mut line = String::new();
        for (at, cell) in headings.chain(self.cells()).enumerate() {
            let width = widths[at % N];
            if width > 0 {
                line.push_str(cell);
                line.push_str(&blanks[..width.saturating_sub(length(cell)) + 2]);
            }
            if at % N == N - 1 {
                line.truncate(line.trim_end().len());
                line.push('\n');
                out.write_all(line.as_bytes())?;
                line.clear();
            }
        }
        Ok(())
    }
}

/// Whether a text is what [`fit`] makes of it.
fn is_plain(text: &str, limit: usize) -> bool {
    text.len() <= limit
        && text.bytes().all(|byte| matches!(byte, b' '..=b'~') && !matches!(byte, b'#' | b':'))
}

/// A text as one line of at most `limit` characters, safe for a terminal.
pub(crate) fn fit(text: &str, limit: usize) -> String {
    match text.chars().nth(limit) {
        None => one_line(text),
        Some(_) => one_line(&text.chars().take(limit.saturating_sub(1)).collect::<String>()) + "…",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_columns_are_left_out_and_long_cells_are_cut() {
        let mut table = TextTable::new(["A", "Empty", "Name"], 6);
        table.row(["1".into(), String::new(), "short".into()]);
        table.row(["22".into(), String::new(), "much too long\u{1B}".into()]);
        let mut out = Vec::new();
        table.write(&mut out).unwrap();
        assert_eq!(String::from_utf8(out).unwrap(), "A   Name\n1   short\n22  much …\n");
    }
}
