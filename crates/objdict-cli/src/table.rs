//! Text in columns.

use std::io::{self, Write};

use objdict_model::diagnostic::one_line;

/// Columns with a heading; a column that is empty in every row is left out, and the headings when there are none.
pub(crate) struct TextTable<const N: usize> {
    headings: [&'static str; N],
    rows: Vec<[String; N]>,
    /// The most characters that a cell shows.
    limit: usize,
}

impl<const N: usize> TextTable<N> {
    pub(crate) fn new(headings: [&'static str; N], limit: usize) -> Self {
        Self { headings, rows: Vec::new(), limit }
    }

    pub(crate) fn row(&mut self, cells: [String; N]) {
        let limit = self.limit;
        self.rows.push(cells.map(|cell| if is_plain(&cell, limit) { cell } else { fit(&cell, limit) }));
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let width = |column: usize| {
            let widest = self.rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default();
            if widest == 0 { 0 } else { widest.max(self.headings[column].chars().count()) }
        };
        let widths: [usize; N] = std::array::from_fn(width);
        let headings = self.headings.map(str::to_owned);
        let has_headings = headings.iter().any(|heading| !heading.is_empty());
        let blanks = " ".repeat(widths.iter().max().unwrap_or(&0) + 2);
        let mut line = String::new();
        for row in has_headings.then_some(&headings).into_iter().chain(&self.rows) {
            line.clear();
            for (cell, &width) in row.iter().zip(&widths).filter(|(_, width)| **width > 0) {
                let padding = width.saturating_sub(cell.chars().count());
                line.push_str(cell);
                line.push_str(&blanks[..padding + 2]);
            }
            line.truncate(line.trim_end().len());
            line.push('\n');
            out.write_all(line.as_bytes())?;
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
