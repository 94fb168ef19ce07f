//! The content of a tag, step by step. A tag ends at a `>` outside quotes; if a quote is missing, that may be
//! anywhere. These steps find the intended end, and every attribute before it.

use super::chars::{ends_name, is_blank};
use crate::source::Span;

/// An attribute as written in the text.
#[derive(Clone, Copy, Debug)]
pub(super) struct RawAttribute {
    pub(super) name: Span,
    /// Without quotes.
    pub(super) value: Span,
    pub(super) flaw: Option<Flaw>,
}

/// An error in a value that can still be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flaw {
    /// It has no quotes.
    Unquoted,
    /// It has no closing quote.
    Unclosed,
    /// It has a `<`.
    LessThan(u32),
}

/// A step through a tag.
#[derive(Clone, Copy, Debug)]
pub(super) enum TagStep {
    Attribute(RawAttribute),
    /// A name without a value.
    MissingValue(Span),
    /// A missing space before an attribute.
    MissingBlank(u32),
    /// Text that is not an attribute.
    Junk(Span),
    /// The offset after the tag. The last step.
    End(u32),
    /// The tag is unclosed; the following content starts at this offset. The last step.
    Unclosed(u32),
}

/// The steps through a tag or a declaration.
pub(super) struct Steps<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Whether the steps belong to `<?xml … ?>` rather than `<a …>`.
    declaration: bool,
    /// The offset for which a missing space was last reported.
    reported: usize,
}

/// The length of the name at the start of `bytes`, valid or not.
pub(super) fn name_length(bytes: &[u8]) -> usize {
    bytes.iter().position(|&byte| ends_name(byte)).unwrap_or(bytes.len())
}

/// Whether a byte can neither be in a name nor start one; digits cannot start a name but probably belong to
/// one.
const fn is_punctuation(byte: u8) -> bool {
    byte.is_ascii_punctuation() && !matches!(byte, b'_' | b':' | b'-' | b'.')
}

fn span(start: usize, end: usize) -> Span {
    Span::new(start as u32, end as u32)
}

impl<'a> Steps<'a> {
    /// The steps from `at`, which is after the name of the tag.
    pub(super) fn tag(text: &'a str, at: usize) -> Self {
        Self { bytes: text.as_bytes(), at, declaration: false, reported: usize::MAX }
    }

    /// The steps from `at`, which is after `<?xml`.
    pub(super) fn declaration(text: &'a str, at: usize) -> Self {
        Self { declaration: true, ..Self::tag(text, at) }
    }

    pub(super) fn next(&mut self) -> TagStep {
        let before = self.at;
        self.skip_blanks();
        let at = self.at;
        let rest = self.bytes.get(at..).unwrap_or_default();
        match rest {
            [] | [b'<', ..] => return TagStep::Unclosed(at as u32),
            [b'>', ..] if !self.declaration => return TagStep::End(at as u32 + 1),
            [b'/', b'>', ..] if !self.declaration => return TagStep::End(at as u32 + 2),
            [b'?', b'>', ..] if self.declaration => return TagStep::End(at as u32 + 2),
            [b'>', ..] => return TagStep::Unclosed(at as u32 + 1),
            [byte, ..] if ends_name(*byte) || is_punctuation(*byte) => {
                self.at = self.end_of_junk(*byte);
                self.reported = self.at;
                return TagStep::Junk(span(at, self.at));
            }
            _ if at == before && self.reported != at => {
                self.reported = at;
                return TagStep::MissingBlank(at as u32);
            }
            _ => {}
        }
        self.at += name_length(rest);
        self.value_of(span(at, self.at))
    }

    fn skip_blanks(&mut self) {
        while self.bytes.get(self.at).is_some_and(|&byte| is_blank(byte)) {
            self.at += 1;
        }
    }

    /// The end of junk that starts with `byte`: a quoted string if it is closed on its line, otherwise one
    /// byte.
    fn end_of_junk(&self, byte: u8) -> usize {
        let behind = self.at + 1;
        if !matches!(byte, b'"' | b'\'') {
            return behind;
        }
        let stop = |&other: &u8| other == byte || matches!(other, b'<' | b'>' | b'\n');
        match self.bytes[behind..].iter().position(stop) {
            Some(length) if self.bytes[behind + length] == byte => behind + length + 1,
            _ => behind,
        }
    }

    fn value_of(&mut self, name: Span) -> TagStep {
        let behind_name = self.at;
        self.skip_blanks();
        if self.bytes.get(self.at) != Some(&b'=') {
            self.at = behind_name;
            return TagStep::MissingValue(name);
        }
        self.at += 1;
        let behind_equals = self.at;
        self.skip_blanks();
        let start = self.at;
        let (value, flaw) = match self.bytes.get(start) {
            Some(&quote @ (b'"' | b'\'')) => self.quoted(quote),
            _ => (self.unquoted(), Some(Flaw::Unquoted)),
        };
        let is_next_name = flaw == Some(Flaw::Unquoted) && self.bytes.get(self.at) == Some(&b'=');
        if is_next_name || flaw == Some(Flaw::Unquoted) && value.is_empty() {
            self.at = behind_equals;
            return TagStep::MissingValue(name);
        }
        TagStep::Attribute(RawAttribute { name, value, flaw })
    }

    fn unquoted(&mut self) -> Span {
        let start = self.at;
        while let Some(&byte) = self.bytes.get(self.at) {
            let is_end = matches!(byte, b'>' | b'<' | b'"' | b'\'' | b'=')
                || matches!((byte, self.bytes.get(self.at + 1)), (b'/' | b'?', Some(b'>')));
            if is_end || is_blank(byte) {
                break;
            }
            self.at += 1;
        }
        span(start, self.at)
    }

    /// The value after the quote at the current offset.
    fn quoted(&mut self, quote: u8) -> (Span, Option<Flaw>) {
        let start = self.at + 1;
        let rest = &self.bytes[start..];
        let first = rest.iter().position(|&byte| byte == quote || byte == b'<');
        let (close, less_than) = match first {
            Some(length) if rest[length] == quote => (Some(length), None),
            Some(length) => (memchr::memchr(quote, &rest[length..]).map(|more| length + more), Some(length)),
            None => (None, None),
        };
        let Some(close) = close else {
            return self.unclosed(start, rest.len());
        };
        let is_delimited = match rest.get(close + 1) {
            None | Some(b'/' | b'>' | b'?') => true,
            Some(&byte) => is_blank(byte),
        };
        // the quote that seems to close this value opens the next one
        let opens_next = rest[..close].ends_with(b"=");
        if opens_next && (!is_delimited || less_than.is_some()) || less_than.is_some() && !is_delimited {
            return self.unclosed(start, close);
        }
        self.at = start + close + 1;
        let flaw = less_than.map(|length| Flaw::LessThan((start + length) as u32));
        (span(start, start + close), flaw)
    }

    /// The unclosed value from `start`: up to the end of the tag, or to the next attribute, whose opening
    /// quote is at `limit`.
    fn unclosed(&mut self, start: usize, limit: usize) -> (Span, Option<Flaw>) {
        let rest = &self.bytes[start..start + limit];
        let mut end = match memchr::memchr2(b'<', b'>', rest) {
            Some(length) if length > 0 && rest[length] == b'>' && rest[length - 1] == b'/' => length - 1,
            Some(length) => length,
            None => {
                let name = rest.strip_suffix(b"=").unwrap_or(rest);
                name.iter().rposition(|&byte| is_blank(byte)).unwrap_or(name.len())
            }
        };
        while end > 0 && is_blank(rest[end - 1]) {
            end -= 1;
        }
        self.at = start + end;
        (span(start, start + end), Some(Flaw::Unclosed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steps(text: &str) -> Vec<String> {
        let mut steps = Steps::tag(text, 2);
        let mut shown = Vec::new();
        loop {
            let step = steps.next();
            shown.push(match step {
                TagStep::Attribute(RawAttribute { name, value, flaw }) => {
                    let flaw = flaw.map(|flaw| format!(" {flaw:?}")).unwrap_or_default();
                    format!("{}={}{flaw}", name.of(text), value.of(text))
                }
                TagStep::MissingValue(name) => format!("no value {}", name.of(text)),
                TagStep::MissingBlank(at) => format!("no blank {at}"),
                TagStep::Junk(junk) => format!("junk {}", junk.of(text)),
                TagStep::End(at) | TagStep::Unclosed(at) => {
                    shown.push(format!("{:?}", &text[at as usize..]));
                    return shown;
                }
            });
        }
    }

    #[test]
    fn healthy_tags() {
        assert_eq!(steps("<a>x"), [r#""x""#]);
        assert_eq!(steps("<a b = 'c>' \n d=\"'\"/>x"), ["b=c>", "d='", r#""x""#]);
    }

    #[test]
    fn damaged_attributes_do_not_lose_their_neighbours() {
        assert_eq!(steps("<a b c='1'>"), ["no value b", "c=1", r#""""#]);
        assert_eq!(steps("<a b=5 c='1'/>"), ["b=5 Unquoted", "c=1", r#""""#]);
        assert_eq!(steps("<a b='5'c='1'/>"), ["b=5", "no blank 8", "c=1", r#""""#]);
        assert_eq!(steps("<a b= c='1'/>"), ["no value b", "c=1", r#""""#]);
        assert_eq!(steps("<a b='1<2' c='1'/>"), ["b=1<2 LessThan(7)", "c=1", r#""""#]);
        assert_eq!(steps("<a 'x' = / c='1'/>"), ["junk 'x'", "junk =", "junk /", "c=1", r#""""#]);
    }

    #[test]
    fn a_missing_quote_costs_one_value() {
        assert_eq!(steps("<a b='1 c='2'/>"), ["b=1 Unclosed", "c=2", r#""""#]);
        assert_eq!(steps("<a b='1>\n<c d='2'/>"), ["b=1 Unclosed", r#""\n<c d='2'/>""#]);
        assert_eq!(steps("<a b='1/>\n<c d='2'/>"), ["b=1 Unclosed", r#""\n<c d='2'/>""#]);
        assert_eq!(steps("<a b='1/>\n<c/>"), ["b=1 Unclosed", r#""\n<c/>""#]);
        assert_eq!(steps("<a b='1 <c/>"), ["b=1 Unclosed", r#""<c/>""#]);
        assert_eq!(steps("<a b=1' c='2'>"), ["b=1 Unquoted", "junk ' c='", "no value 2", "junk '", r#""""#]);
    }
}
