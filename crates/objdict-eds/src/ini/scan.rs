//! Lines of an INI file, told apart and measured; nothing is copied and nothing can fail.

use crate::source::Span;

/// One line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// What it is.
    pub kind: LineKind,
    /// The line without its line end.
    pub span: Span,
    /// Where the next line starts: [`span`](Self::span) and the line end reach up to it.
    pub next: u32,
}

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// Nothing but blanks.
    Blank,
    /// A comment: `;` by the standard (CiA 306-1 §4.2), `#` and `//` in real files.
    Comment,
    /// `[name]`; also where blanks stand before it, text behind it, or where the `]` is missing.
    Section {
        /// The name without brackets and blanks around it.
        name: Span,
    },
    /// `key=value`.
    Entry {
        /// The text before the first `=` without blanks around it; never empty.
        key: Span,
        /// The text behind it without blanks around it.
        value: Span,
    },
    /// Anything else.
    Junk,
}

/// The lines of a text. Their spans and line ends cover every byte of it.
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Lines<'a> {
    /// The lines of `text`, at most 4 GiB.
    pub fn new(text: &'a str) -> Self {
        Self { bytes: text.as_bytes(), at: 0 }
    }

    /// The lines of `text` from the line that starts at `offset`.
    pub fn from(text: &'a str, offset: u32) -> Self {
        Self { bytes: text.as_bytes(), at: (offset as usize).min(text.len()) }
    }
}

/// The section headers of a text: the lines that [`Lines`] calls so, without a look at the others.
pub(crate) fn headers(text: &str) -> impl Iterator<Item = Line> {
    let bytes = text.as_bytes();
    memchr::memchr_iter(b'[', bytes).filter_map(move |bracket| {
        let blanks = bytes[..bracket].iter().rev().take_while(|byte| is_blank(**byte)).count();
        let start = bracket - blanks;
        let is_first = bytes[..start].last().is_none_or(|before| matches!(before, b'\n' | b'\r'));
        is_first.then(|| Lines { bytes, at: start }.next()).flatten()
    })
}

impl Iterator for Lines<'_> {
    type Item = Line;

    fn next(&mut self) -> Option<Line> {
        let start = self.at;
        let rest = self.bytes.get(start..).filter(|rest| !rest.is_empty())?;
        let length = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        let (line, behind) = rest.split_at(length);
        let line_end = match behind {
            [b'\r', b'\n', ..] => 2,
            [] => 0,
            _ => 1,
        };
        self.at = start + length + line_end;
        let kind = plain_entry(line, start).unwrap_or_else(|| classify(self.bytes, start, start + length));
        Some(Line { kind, span: span(start, start + length), next: self.at as u32 })
    }
}

fn span(start: usize, end: usize) -> Span {
    Span::new(start as u32, end as u32)
}

/// What most lines are: an entry without blanks at its ends and around the `=`.
fn plain_entry(line: &[u8], start: usize) -> Option<LineKind> {
    let (first, last) = (*line.first()?, *line.last()?);
    if !first.is_ascii_alphanumeric() || is_blank(last) {
        return None;
    }
    let equals = memchr::memchr(b'=', line)?;
    if is_blank(line[equals - 1]) || line.get(equals + 1).is_some_and(|&byte| is_blank(byte)) {
        return None;
    }
    let (equals, end) = (start + equals, start + line.len());
    Some(LineKind::Entry { key: span(start, equals), value: span(equals + 1, end) })
}

fn classify(bytes: &[u8], start: usize, end: usize) -> LineKind {
    let (start, end) = trim(bytes, start, end);
    match &bytes[start..end] {
        [] => LineKind::Blank,
        [b';' | b'#', ..] | [b'/', b'/', ..] => LineKind::Comment,
        [b'[', ..] => {
            let close = memchr::memchr(b']', &bytes[start..end]).map_or(end, |length| start + length);
            let (from, to) = trim(bytes, start + 1, close);
            LineKind::Section { name: span(from, to) }
        }
        line => match memchr::memchr(b'=', line) {
            None | Some(0) => LineKind::Junk,
            Some(equals) => {
                let (key_start, key_end) = trim(bytes, start, start + equals);
                let (value_start, value_end) = trim(bytes, start + equals + 1, end);
                LineKind::Entry { key: span(key_start, key_end), value: span(value_start, value_end) }
            }
        },
    }
}

/// Blanks and tabs, and what DOS and C leave at the end of a file: NUL and Ctrl-Z.
const fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0 | 0x1A)
}

fn trim(bytes: &[u8], mut start: usize, mut end: usize) -> (usize, usize) {
    while start < end && is_blank(bytes[start]) {
        start += 1;
    }
    while start < end && is_blank(bytes[end - 1]) {
        end -= 1;
    }
    (start, end)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<String> {
        let show = |line: Line| match line.kind {
            LineKind::Section { name } => format!("[{}]", name.of(text)),
            LineKind::Entry { key, value } => format!("{}={}", key.of(text), value.of(text)),
            other => format!("{other:?}"),
        };
        Lines::new(text).map(show).collect()
    }

    #[test]
    fn lines_of_every_kind() {
        let text = "[A]\r\nk = v \n\n;c\r# c\n  [ B ] ; text\n<<<<<<< HEAD\n=======\n[1018sub1\na=b=c";
        assert_eq!(kinds("k=\n=v\nk =v\nk= v\nk=v\t\n k=v"), ["k=", "Junk", "k=v", "k=v", "k=v", "k=v"]);
        let expected =
            ["[A]", "k=v", "Blank", "Comment", "Comment", "[B]", "Junk", "Junk", "[1018sub1]", "a=b=c"];
        assert_eq!(kinds(text), expected);
    }

    #[test]
    fn headers_are_the_lines_that_are_sections() {
        for text in ["", "[", "[a]", "\t[a] [b]\n;[c]\n [[d]]\r[e\r\n\n\0[f]=1\nk=[g]\n\u{1A} [h]"] {
            let is_section = |line: &Line| matches!(line.kind, LineKind::Section { .. });
            let sections: Vec<Line> = Lines::new(text).filter(is_section).collect();
            assert_eq!(headers(text).collect::<Vec<_>>(), sections, "{text:?}");
        }
    }

    #[test]
    fn the_end_of_a_dos_file_is_blank() {
        assert_eq!(kinds("k=1\n\u{1A}"), ["k=1", "Blank"]);
    }

    #[test]
    fn lines_cover_every_byte() {
        let text = "a\r\r\n\n[x]\rk=v";
        let mut at = 0;
        for line in Lines::new(text) {
            assert_eq!(line.span.start, at);
            at = line.next;
        }
        assert_eq!(at as usize, text.len());
    }
}
