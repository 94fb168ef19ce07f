//! The terms of findings: their names in CiA 306 and in other syntaxes.

use std::borrow::Cow;

use crate::model::{Field, ModulePart, Part};

/// Maps a CiA 306 term to its name in a different syntax; `None` if both names are equal.
pub type Vocabulary = fn(&Notion<'_>) -> Option<String>;

/// A term with a different name in each syntax.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notion<'a> {
    /// A key.
    Key(&'a str),
    /// A key with a value.
    Setting(&'a str, &'a str),
    /// The value of a key.
    ValueOf(&'a str, &'a str),
    /// A section, by the name in its header.
    Section(&'a str),
    /// One of [`WORDS`].
    Word(&'a str),
}

/// The terms that templates put in braces because they differ between syntaxes.
pub const WORDS: &[&str] =
    &["section", "a section", "sections", "a key", "the key", "the keys", "DCF", "a DCF", ".dcf", "EDS"];

impl<'a> Notion<'a> {
    /// The term in the braces of a template.
    pub(super) fn of(gap: &'a str) -> Self {
        if WORDS.contains(&gap) {
            return Self::Word(gap);
        }
        if let Some(name) = gap.strip_prefix('[') {
            return Self::Section(name.strip_suffix(']').unwrap_or(name));
        }
        match (gap.split_once('='), gap.split_once(':')) {
            (Some((key, value)), _) => Self::Setting(key, value),
            (None, Some((key, value))) => Self::ValueOf(key, value),
            (None, None) => Self::Key(gap),
        }
    }

    /// The term in the vocabulary of a syntax; `None` for CiA 306.
    pub(super) fn shown(self, words: Option<Vocabulary>) -> Cow<'a, str> {
        if let Some(shown) = words.and_then(|words| words(&self)) {
            return Cow::Owned(shown);
        }
        match self {
            Self::Key(text) | Self::ValueOf(_, text) | Self::Word(text) => Cow::Borrowed(text),
            Self::Setting(key, value) => Cow::Owned(format!("{key}={value}")),
            Self::Section(name) => Cow::Owned(format!("[{name}]")),
        }
    }
}

/// The name of the section that describes a part (CiA 306-1 §4.6), with as few digits as possible.
pub fn section_name(part: &Part) -> String {
    // written without `format!`, because large files have ten thousand sections
    let of = |index: u16, word: &str| {
        let mut name = String::with_capacity(16);
        push_hex(&mut name, index);
        name + word
    };
    match *part {
        Part::Object(index) => of(index, ""),
        Part::Entry(index, sub) => {
            let mut name = of(index, "sub");
            push_hex(&mut name, sub.into());
            name
        }
        Part::CompactNames(index) => of(index, "Name"),
        Part::CompactValues(index) => of(index, "Value"),
        Part::CompactDenotations(index) => of(index, "Denotation"),
        Part::Links(index) => of(index, "ObjectLinks"),
        Part::Module(number, ModulePart::Fixed(index)) => format!("M{number}Fixed{index:X}"),
        Part::Module(number, ModulePart::FixedEntry(index, sub)) => {
            format!("M{number}Fixed{index:X}sub{sub:X}")
        }
        Part::Module(number, ModulePart::SubExt(index)) => format!("M{number}SubExt{index:X}"),
        _ => part.to_string(),
    }
}

/// Adds a number in hexadecimal, without leading zeros.
fn push_hex(text: &mut String, number: u16) {
    let digits = (u16::BITS - number.leading_zeros()).div_ceil(4).max(1);
    let digit = |at: u32| char::from(b"0123456789ABCDEF"[usize::from(number >> (4 * at) & 0xF)]);
    text.extend((0..digits).rev().map(digit));
}

/// Rejects a template with an unknown name in braces, or with a number of gaps that differs from the
/// number of values. [`say!`](crate::say) calls it at compile time.
pub const fn assert_template(template: &str, values: usize) {
    let text = template.as_bytes();
    let (mut at, mut gaps) = (0, 0);
    while at < text.len() {
        if text[at] == b'{' {
            let start = at + 1;
            while at < text.len() && text[at] != b'}' {
                at += 1;
            }
            assert!(at < text.len(), "a brace is not closed");
            if start == at || matches!(text[start], b':' | b'!') {
                gaps += 1;
            } else {
                assert!(text[start] == b'[' || is_known(text, start, at), "unknown key or word in braces");
            }
        }
        at += 1;
    }
    assert!(gaps == values, "the number of gaps differs from the number of values");
}

/// Whether the text is a known key or word.
const fn is_known(text: &[u8], start: usize, end: usize) -> bool {
    let mut key_end = start;
    while key_end < end && text[key_end] != b'=' && text[key_end] != b':' {
        key_end += 1;
    }
    let mut number = 0;
    while number < Field::NAMED.len() {
        if is_at(text, start, key_end, Field::NAMED[number].0.as_bytes()) {
            return true;
        }
        number += 1;
    }
    number = 0;
    while number < WORDS.len() {
        if is_at(text, start, end, WORDS[number].as_bytes()) {
            return true;
        }
        number += 1;
    }
    is_at(text, start, end, b"BaudRate_x")
}

const fn is_at(text: &[u8], start: usize, end: usize, name: &[u8]) -> bool {
    let mut at = 0;
    while at < name.len() && start + at < end && text[start + at] == name[at] {
        at += 1;
    }
    at == name.len() && start + at == end
}
