//! Fixes for problems that affect many lines in the same way.

use super::{Document, LineKind};
use crate::diagnostic::Tidy;
use crate::source::{Edits, Span, transliterate};

/// The edits that tidy up a document; `None` if something would be lost.
pub(crate) fn tidy(document: &Document, what: Tidy, edits: &mut Edits<'_>) -> Option<()> {
    match what {
        Tidy::LineEnds => line_ends(document, edits),
        Tidy::Comments => comments(document, edits),
        Tidy::Keys => keys(document, edits),
        Tidy::Iso646 => return iso646(document, edits),
    }
    Some(())
}

/// Converts all lines to the most frequent line end, LF or CR LF.
fn line_ends(document: &Document, edits: &mut Edits<'_>) {
    let text = document.text();
    let spans = || document.lines().map(|line| Span::new(line.span.end, line.next));
    let count = |line_end: &str| spans().filter(|span| span.of(text) == line_end).count();
    let most = if count("\n") > count("\r\n") { "\n" } else { "\r\n" };
    for span in spans().filter(|span| !span.is_empty() && span.of(text) != most) {
        edits.append(span, most);
    }
}

/// Starts all comments with `;` in the first column.
fn comments(document: &Document, edits: &mut Edits<'_>) {
    let text = document.text();
    for line in document.lines().filter(|line| line.kind == LineKind::Comment) {
        let comment = line.span.of(text);
        if comment.starts_with(';') {
            continue;
        }
        let start = comment.find([';', '#', '/']).unwrap_or_default();
        let mark = if comment[start..].starts_with("//") { 2 } else { 1 };
        let behind = &comment[start + mark..];
        // prevents that a tool reads the comment as a setting
        let is_setting = behind.starts_with(['S', 'C']);
        let span = Span::new(line.span.start, line.span.start + (start + mark) as u32);
        edits.append(span, [";", "; "][usize::from(is_setting)]);
    }
}

/// Starts all keys in the first column, directly followed by the `=`.
fn keys(document: &Document, edits: &mut Edits<'_>) {
    let bytes = document.text().as_bytes();
    for line in document.lines() {
        let LineKind::Entry { key, .. } = line.kind else { continue };
        if key.start > line.span.start {
            edits.append(Span::new(line.span.start, key.start), "");
        }
        let behind = bytes.get(key.end as usize..line.span.end as usize).unwrap_or_default();
        let blanks = behind.iter().take_while(|&&byte| byte != b'=').count() as u32;
        if blanks > 0 {
            edits.append(Span::new(key.end, key.end + blanks), "");
        }
    }
}

/// Transliterates all other characters to ISO 646.
fn iso646(document: &Document, edits: &mut Edits<'_>) -> Option<()> {
    for (at, c) in document.text().char_indices().filter(|(_, c)| !c.is_ascii()) {
        edits.append(Span::new(at as u32, (at + c.len_utf8()) as u32), transliterate(c)?);
    }
    Some(())
}
