//! How texts of several formats name objects and entries: `6041`, `1018:1`, `0x60410010`.

use objdict_model::source::Span;

/// Digits of an index or a sub-index in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digits {
    /// Their bytes in the text.
    pub span: Span,
    /// Whether they are a decimal number, which is replaced by hex with `0x`.
    is_decimal: bool,
}

impl Digits {
    /// A hexadecimal number at these bytes.
    pub const fn hex(span: Span) -> Self {
        Self { span, is_decimal: false }
    }

    /// The digits of a complete number: `0x6041`, or `24641`.
    pub fn of_number(text: &str, span: Span) -> Self {
        let has_prefix = span.of(text).get(..2).is_some_and(|prefix| prefix.eq_ignore_ascii_case("0x"));
        match has_prefix {
            true => Self::hex(Span::new(span.start + 2, span.end)),
            false => Self { span, is_decimal: true },
        }
    }

    /// The edit that replaces them with a different number, with the same number of digits.
    pub fn replaced(self, number: u16) -> (Span, String) {
        let width = (self.span.end - self.span.start) as usize;
        let new = if self.is_decimal { format!("0x{number:X}") } else { format!("{number:0width$X}") };
        (self.span, new)
    }
}

/// The kind of a reference to an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MentionKind {
    /// The header of a section or table, or an element, which describes it.
    Section,
    /// A list, a link, or a setting.
    List,
    /// A mapping parameter.
    Mapping,
}

/// A reference in a text to an object or an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mention {
    /// The kind of reference.
    pub kind: MentionKind,
    /// The span of the whole reference.
    pub span: Span,
    /// The index of the object.
    pub index: u16,
    /// The sub-index; for a range, the first.
    pub sub: Option<u8>,
    /// `None` if it is not written as digits.
    pub index_at: Option<Digits>,
    /// `None` if it is not written as digits, or is inside a range.
    pub sub_at: Option<Digits>,
    /// The last sub-index of a range.
    pub last: Option<u8>,
}

impl Mention {
    /// The reference in an address: `6041`, `0x6041`, `1018:1`, `6000:1-5`, `2000:1/8`, also in quotes.
    /// `None` for any other text.
    pub fn of_address(text: &str, span: Span, kind: MentionKind) -> Option<Self> {
        let is_quote = |c: char| matches!(c, '"' | '\'' | ' ');
        let quoted = span.of(text);
        let inner = quoted.trim_start_matches(is_quote);
        let start = span.start + (quoted.len() - inner.len()) as u32;
        let inner = inner.trim_end_matches(is_quote);
        let span = Span::new(start, start + inner.len() as u32);
        let (index_text, subs) =
            inner.split_once(':').map_or((inner, None), |(index, subs)| (index, Some(subs)));
        let index_at = hex_digits(index_text, start)?;
        let index = u16::from_str_radix(index_at.span.of(text), 16).ok()?;
        let mention =
            Self { kind, span, index, sub: None, index_at: Some(index_at), sub_at: None, last: None };
        let Some(subs) = subs else { return Some(mention) };
        let subs = subs.split('/').next().unwrap_or_default();
        let (first, last) = subs.split_once('-').map_or((subs, None), |(first, last)| (first, Some(last)));
        let sub_at = hex_digits(first, start + index_text.len() as u32 + 1)?;
        let sub = u8::from_str_radix(sub_at.span.of(text), 16).ok()?;
        let last = match last {
            Some(last) => Some(u8::from_str_radix(last.strip_prefix("0x").unwrap_or(last), 16).ok()?),
            None => None,
        };
        Some(Self { sub: Some(sub), sub_at: last.is_none().then_some(sub_at), last, ..mention })
    }

    /// The reference in the value of a mapping parameter; `None` for an unused one or a dummy.
    pub fn of_mapping(text: &str, span: Span, value: u32) -> Option<Self> {
        let mapped = objdict_model::model::MappedObject::from_number(value);
        if mapped.is_unused() || mapped.is_dummy() {
            return None;
        }
        let digits = Digits::of_number(text, span);
        let is_whole = !digits.is_decimal && digits.span.end - digits.span.start == 8;
        let part = |from: u32, to: u32| {
            let start = digits.span.start;
            is_whole.then(|| Digits::hex(Span::new(start + from, start + to)))
        };
        let (index, sub) = (mapped.index, Some(mapped.sub));
        let kind = MentionKind::Mapping;
        Some(Self { kind, span, index, sub, index_at: part(0, 4), sub_at: part(4, 6), last: None })
    }

    /// Whether it refers to the object, and to the sub-index if given, alone or in a range.
    pub fn is_of(&self, index: u16, sub: Option<u8>) -> bool {
        let names =
            |sub: u8| self.sub.is_some_and(|first| (first..=self.last.unwrap_or(first)).contains(&sub));
        self.index == index && sub.is_none_or(names)
    }

    /// Whether an offset is in it, or directly after it.
    pub fn has(&self, offset: u32) -> bool {
        self.span.start <= offset && offset <= self.span.end
    }
}

/// The digits of `6041`, `0x6041` or `6041h`, starting at an offset.
fn hex_digits(text: &str, start: u32) -> Option<Digits> {
    let bare = text.trim_start_matches("0x").trim_end_matches('h');
    let at = start + (text.len() - text.trim_start_matches("0x").len()) as u32;
    let is_hex = (1..=4).contains(&bare.len()) && bare.bytes().all(|byte| byte.is_ascii_hexdigit());
    is_hex.then(|| Digits::hex(Span::new(at, at + bare.len() as u32)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_and_their_digits() {
        let of = |text: &str| {
            let mention = Mention::of_address(text, Span::new(0, text.len() as u32), MentionKind::List)?;
            let digits = |digits: Option<Digits>| digits.map_or("", |digits| digits.span.of(text)).to_owned();
            Some((mention.index, mention.sub, mention.last, digits(mention.index_at), digits(mention.sub_at)))
        };
        assert_eq!(of("\"6041\""), Some((0x6041, None, None, "6041".into(), String::new())));
        assert_eq!(of("0x1018:0x1"), Some((0x1018, Some(1), None, "1018".into(), "1".into())));
        assert_eq!(of("'6000:1-A'"), Some((0x6000, Some(1), Some(10), "6000".into(), String::new())));
        assert_eq!(of("2000:1/8"), Some((0x2000, Some(1), None, "2000".into(), "1".into())));
        for text in ["Statusword", "", "1018:", ":1", "60410:1", "1018:100", "°"] {
            assert_eq!(of(text), None, "{text}");
        }
    }

    #[test]
    fn numbers_keep_their_width() {
        let text = "0x60410010 24641";
        let mapping = Mention::of_mapping(text, Span::new(0, 10), 0x6041_0010).unwrap();
        assert_eq!(mapping.sub_at.unwrap().replaced(0xA), (Span::new(6, 8), "0A".to_owned()));
        assert_eq!(mapping.index_at.unwrap().replaced(0x2041), (Span::new(2, 6), "2041".to_owned()));
        let decimal = Digits::of_number(text, Span::new(11, 16));
        assert_eq!(decimal.replaced(0x2041).1, "0x2041");
    }
}
