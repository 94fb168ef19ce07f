//! Splits an INI file into classified lines with spans; nothing is copied and scanning never fails.

use crate::source::Span;

/// One line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// The kind of the line.
    pub kind: LineKind,
    /// The line without its line end.
    pub span: Span,
    /// The start of the next line: from the end of [`span`](Self::span) to here is the line end.
    pub next: u32,
}

/// The kind of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// Only whitespace.
    Blank,
    /// A comment: `;` by the standard (CiA 306-1 §4.2), `#` and `//` in real files.
    Comment,
    /// `[name]`; also with whitespace before it, with text after it, or without the `]`. The sections of CiA 306 may
    /// follow a few characters of junk.
    Section {
        /// The name, without the brackets and surrounding whitespace.
        name: Span,
    },
    /// `key=value`.
    Entry {
        /// The text before the first `=`, without surrounding whitespace; never empty.
        key: Span,
        /// The text after the `=`, without surrounding whitespace.
        value: Span,
    },
    /// Any other line.
    Junk,
}

/// The lines of a text. Their spans and line ends cover every byte of the text.
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    bytes: &'a [u8],
    /// The start of the next line.
    at: usize,
    /// The bytes that are not scanned yet; eight are scanned at a time.
    rest: &'a [u8],
    /// The start of the word scanned last.
    word: usize,
    /// The bytes of that word that may be a `=` or a line end and are not returned yet: their top bits.
    marks: u64,
}

impl<'a> Lines<'a> {
    /// The lines of `text`, at most 4 GiB.
    pub fn new(text: &'a str) -> Self {
        Self::from(text, 0)
    }

    /// The lines of `text`, starting with the line at `offset`.
    pub fn from(text: &'a str, offset: u32) -> Self {
        Self::of(text.as_bytes(), offset as usize)
    }

    fn of(bytes: &'a [u8], start: usize) -> Self {
        let at = start.min(bytes.len());
        Self { bytes, at, rest: bytes.get(at..).unwrap_or_default(), word: at, marks: 0 }
    }
}

/// The section headers of a text: the same lines as in [`Lines`], without scanning the others.
pub(crate) fn headers(text: &str) -> impl Iterator<Item = Line> {
    let bytes = text.as_bytes();
    memchr::memchr_iter(b'[', bytes).filter_map(move |bracket| {
        let blanks = bytes[..bracket].iter().rev().take_while(|byte| is_blank(**byte)).count();
        let start = bracket - blanks;
        let window = &bytes[start.saturating_sub(MAX_JUNK)..start];
        let junk = window.iter().rev().take_while(|byte| !matches!(byte, b'\n' | b'\r')).count();
        let line = start - junk;
        let is_first = line == 0 || matches!(bytes[line - 1], b'\n' | b'\r');
        // a previous bracket in the line is the start of the header
        let is_only = !bytes[line..start].contains(&b'[');
        if !is_first || !is_only {
            return None;
        }
        let found = Lines::of(bytes, line).next();
        found.filter(|line| matches!(line.kind, LineKind::Section { .. }))
    })
}

impl Iterator for Lines<'_> {
    type Item = Line;

    fn next(&mut self) -> Option<Line> {
        self.advance()
    }
}

impl Lines<'_> {
    /// The next line: [`next`](Self::next), inlined into loops over all lines of a file.
    #[inline(always)]
    pub(crate) fn advance(&mut self) -> Option<Line> {
        let (bytes, start) = (self.bytes, self.at);
        if start >= bytes.len() {
            return None;
        }
        let mut end = self.mark();
        let mut equals = None;
        while bytes.get(end) == Some(&b'=') {
            equals.get_or_insert(end);
            end = self.mark();
        }
        self.at = match bytes.get(end) {
            None => end,
            // the line feed is the next mark
            Some(b'\r') if bytes.get(end + 1) == Some(&b'\n') => self.mark() + 1,
            Some(_) => end + 1,
        };
        let plain = equals.filter(|&equals| equals > start);
        let plain = plain.and_then(|equals| plain_entry(bytes, start, equals, end));
        let kind = plain.unwrap_or_else(|| classify(bytes, start, equals, end));
        Some(Line { kind, span: span(start, end), next: self.at as u32 })
    }

    /// The next `=` or line end, and finally the end of the text. Lines are short, so starting a search
    /// with larger vectors costs more than checking eight bytes at a time.
    #[inline(always)]
    fn mark(&mut self) -> usize {
        loop {
            while self.marks == 0 {
                self.word = self.bytes.len() - self.rest.len();
                let word;
                (word, self.rest) = match self.rest.split_first_chunk() {
                    Some((eight, rest)) => (u64::from_le_bytes(*eight), rest),
                    None if self.rest.is_empty() => return self.bytes.len(),
                    None => (last_word(self.rest), &[][..]),
                };
                self.marks = below(word, b'\r' + 1) | below(word ^ (ONES * u64::from(b'=')), 1);
            }
            let at = self.word + (self.marks.trailing_zeros() / 8) as usize;
            self.marks &= self.marks - 1;
            if matches!(self.bytes.get(at), Some(b'=' | b'\n' | b'\r')) {
                return at;
            }
        }
    }
}

/// A one in each byte of a word.
const ONES: u64 = u64::from_ne_bytes([1; 8]);

/// Sets the top bit of each byte of a word that is less than `limit`, at most 80h; the result may be wrong
/// for bytes after the first match.
#[inline]
const fn below(word: u64, limit: u8) -> u64 {
    word.wrapping_sub(ONES * limit as u64) & !word & (ONES << 7)
}

/// Fewer than eight bytes as a word.
#[cold]
#[inline(never)]
fn last_word(bytes: &[u8]) -> u64 {
    bytes.iter().rev().fold(0, |word, byte| word << 8 | u64::from(*byte))
}

fn span(start: usize, end: usize) -> Span {
    Span::new(start as u32, end as u32)
}

/// Fast path for most lines: an entry without whitespace at its ends and around the `=`.
#[inline]
fn plain_entry(bytes: &[u8], start: usize, equals: usize, end: usize) -> Option<LineKind> {
    let around = [bytes[equals - 1], bytes[end - 1], *bytes.get(equals + 1)?];
    let is_plain = bytes[start].is_ascii_alphanumeric() && !around.into_iter().any(is_blank);
    is_plain.then(|| LineKind::Entry { key: span(start, equals), value: span(equals + 1, end) })
}

fn classify(bytes: &[u8], start: usize, equals: Option<usize>, end: usize) -> LineKind {
    if start == end {
        return LineKind::Blank;
    }
    let first = start;
    let (start, end) = trim(bytes, start, end);
    match (&bytes[start..end], equals) {
        ([], _) => LineKind::Blank,
        ([b';' | b'#', ..] | [b'/', b'/', ..], _) => LineKind::Comment,
        ([b'[', ..], _) => {
            // names are short, so the start of a vector search costs more
            let close = bytes[start..end].iter().position(|byte| *byte == b']');
            let close = close.map_or(end, |length| start + length);
            let (from, to) = trim(bytes, start + 1, close);
            LineKind::Section { name: span(from, to) }
        }
        (_, Some(equals)) if equals > start => {
            let (key_start, key_end) = trim(bytes, start, equals);
            let (value_start, value_end) = trim(bytes, equals + 1, end);
            LineKind::Entry { key: span(key_start, key_end), value: span(value_start, value_end) }
        }
        (line, _) => match line.iter().position(|byte| *byte == b'[').map(|length| start + length) {
            Some(bracket)
                if trim(bytes, start, bracket).1 - first <= MAX_JUNK && is_known(&bytes[bracket..end]) =>
            {
                LineKind::Section { name: span(bracket + 1, end - 1) }
            }
            _ => LineKind::Junk,
        },
    }
}

/// The maximum number of junk bytes before the header of a known section.
const MAX_JUNK: usize = 16;

/// Whether a text is the header of a section that CiA 306 defines: a general section, or one of an object or
/// module.
fn is_known(text: &[u8]) -> bool {
    const NAMES: [&[u8]; 13] = [
        b"FileInfo",
        b"DeviceInfo",
        b"DummyUsage",
        b"Comments",
        b"MandatoryObjects",
        b"OptionalObjects",
        b"ManufacturerObjects",
        b"DeviceComissioning",
        b"DeviceCommissioning",
        b"SupportedModules",
        b"ConnectedModules",
        b"DynamicChannels",
        b"Tools",
    ];
    let Some(name) = text.strip_prefix(b"[").and_then(|text| text.strip_suffix(b"]")) else { return false };
    NAMES.iter().any(|known| known.eq_ignore_ascii_case(name)) || is_object(name) || is_module(name)
}

/// `1018`, `1018sub1`, `1003Value`: an index of four digits, as numbers in prose rarely are.
fn is_object(name: &[u8]) -> bool {
    const LISTS: [&[u8]; 4] = [b"Name", b"Value", b"Denotation", b"ObjectLinks"];
    let Some((index, rest)) = name.split_at_checked(4) else { return false };
    let is_sub = |digits: &[u8]| matches!(digits.len(), 1 | 2) && digits.iter().all(u8::is_ascii_hexdigit);
    let sub = rest.split_at_checked(3).filter(|(word, _)| word.eq_ignore_ascii_case(b"sub"));
    index.iter().all(u8::is_ascii_hexdigit)
        && index[0] != b'0'
        && (rest.is_empty()
            || sub.is_some_and(|(_, digits)| is_sub(digits))
            || LISTS.iter().any(|list| list.eq_ignore_ascii_case(rest)))
}

/// `M1ModuleInfo`, `M1Fixed6000sub1`.
fn is_module(name: &[u8]) -> bool {
    const WORDS: [&[u8]; 5] = [b"ModuleInfo", b"Comments", b"FixedObjects", b"SubExtends", b"SubExt"];
    let Some(rest) = name.strip_prefix(b"M").or_else(|| name.strip_prefix(b"m")) else { return false };
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let rest = &rest[digits..];
    let of_object = [&b"Fixed"[..], b"SubExt"].iter().any(|word| {
        let object = rest.split_at_checked(word.len()).filter(|(start, _)| start.eq_ignore_ascii_case(word));
        object.is_some_and(|(_, object)| is_object(object))
    });
    digits > 0 && (of_object || WORDS.iter().any(|word| word.eq_ignore_ascii_case(rest)))
}

/// Spaces and tabs, and the NUL and Ctrl-Z that DOS and C leave at the end of a file.
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

    /// Lines that contain or follow junk.
    const JUNK: &str = "50[FileInfo]\n \u{FEFF}x [comments] \nsee [12]\n;[Comments]\n=[DummyUsage]\nk=[DeviceInfo]\n\
                        50[1018sub1]\n2[1003Value]\nx[M1ModuleInfo]\nsee [1018sub]\n\
                        v[10180]\na[x][FileInfo]\n[x][FileInfo]\n50[FileInfo] x\n0123456789abcdef[DeviceInfo]\n\
                        0123456789abcdefg[DeviceInfo]\n    0123456789abcdef[DeviceInfo]\na[FileInfo]b[FileInfo]";

    #[test]
    fn junk_before_a_known_section_is_passed_over() {
        let sections: Vec<String> = kinds(JUNK).into_iter().filter(|kind| kind.starts_with('[')).collect();
        let objects = ["[1018sub1]", "[1003Value]", "[M1ModuleInfo]"];
        let expected =
            [&["[FileInfo]", "[comments]", "[DummyUsage]"], &objects[..], &["[x]", "[DeviceInfo]"]];
        assert_eq!(sections, expected.concat());
    }

    #[test]
    fn headers_are_the_lines_that_are_sections() {
        for text in ["", "[", "[a]", "\t[a] [b]\n;[c]\n [[d]]\r[e\r\n\n\0[f]=1\nk=[g]\n\u{1A} [h]", JUNK] {
            let is_section = |line: &Line| matches!(line.kind, LineKind::Section { .. });
            let sections: Vec<Line> = Lines::new(text).filter(is_section).collect();
            assert_eq!(headers(text).collect::<Vec<_>>(), sections, "{text:?}");
        }
    }

    #[test]
    fn marks_are_found_wherever_they_stand() {
        for length in 0..20 {
            let padding = "x".repeat(length);
            let text =
                format!("k{padding}=v{padding}\r\n{padding}\t=\x0B{padding}=\r{padding}°\n\x0D{padding}");
            let lines: Vec<&str> = Lines::new(&text).map(|line| line.span.of(&text)).collect();
            let mut expected = vec![];
            let mut rest = text.as_str();
            while let Some(end) = rest.find(['\r', '\n']) {
                expected.push(&rest[..end]);
                rest = &rest[end + if rest[end..].starts_with("\r\n") { 2 } else { 1 }..];
            }
            expected.extend(Some(rest).filter(|rest| !rest.is_empty()));
            assert_eq!(lines, expected, "{text:?}");
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
