//! What is wrong alike in many lines, fixed in all of them.

use super::{Document, LineKind};
use crate::diagnostic::Tidy;
use crate::source::{Edits, Span, transliterate};

/// The edits that tidy a document up; `None` where it cannot be done without losing something.
pub(crate) fn tidy(document: &Document, what: Tidy, edits: &mut Edits<'_>) -> Option<()> {
    match what {
        Tidy::LineEnds => line_ends(document, edits),
        Tidy::Comments => comments(document, edits),
        Tidy::Keys => keys(document, edits),
        Tidy::Iso646 => return iso646(document, edits),
    }
    Some(())
}

/// All lines end like most of them do, with LF or CR LF.
fn line_ends(document: &Document, edits: &mut Edits<'_>) {
    let text = document.text();
    let spans = || document.lines().map(|line| Span::new(line.span.end, line.next));
    let count = |line_end: &str| spans().filter(|span| span.of(text) == line_end).count();
    let most = if count("\n") > count("\r\n") { "\n" } else { "\r\n" };
    for span in spans().filter(|span| !span.is_empty() && span.of(text) != most) {
        edits.replace(span, most);
    }
}

/// All comments start with `;` in the first column.
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
        // what a tool would take for a setting was none before
        let blank = if behind.starts_with(['S', 'C']) { " " } else { "" };
        let span = Span::new(line.span.start, line.span.start + (start + mark) as u32);
        edits.replace(span, format!(";{blank}"));
    }
}

/// All keys start in the first column, and the `=` follows at once.
fn keys(document: &Document, edits: &mut Edits<'_>) {
    let bytes = document.text().as_bytes();
    for line in document.lines() {
        let LineKind::Entry { key, .. } = line.kind else { continue };
        if key.start > line.span.start {
            edits.replace(Span::new(line.span.start, key.start), "");
        }
        let behind = bytes.get(key.end as usize..line.span.end as usize).unwrap_or_default();
        let blanks = behind.iter().take_while(|&&byte| byte != b'=').count() as u32;
        if blanks > 0 {
            edits.replace(Span::new(key.end, key.end + blanks), "");
        }
    }
}

/// Characters of ISO 646 in the place of all others.
fn iso646(document: &Document, edits: &mut Edits<'_>) -> Option<()> {
    for (at, c) in document.text().char_indices().filter(|(_, c)| !c.is_ascii()) {
        edits.replace(Span::new(at as u32, (at + c.len_utf8()) as u32), transliterate(c)?);
    }
    Some(())
}
