//! Resolves references in raw text.

use std::borrow::Cow;
use std::collections::HashMap;

use super::chars::{is_forbidden, is_name};

/// The maximum number of bytes that references to entities may add to the text.
pub(super) const MAX_EXPANSION: usize = 1 << 20;

/// The entities that the internal subset of a document type declares.
#[derive(Debug, Default)]
pub(super) struct Entities {
    pub(super) declared: HashMap<Box<str>, Entity>,
}

/// The value of an entity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Entity {
    /// Text with all references resolved.
    Text(Box<str>),
    /// An entity that is not read, and the reason.
    Unread(&'static str),
}

/// A reference, which starts with `&`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EntityReference<'a> {
    /// A character, by its number or by one of the five predefined names.
    Character(char),
    /// An entity of the document.
    Entity(&'a str),
    /// Not a number, or not the number of an XML character.
    BadNumber,
    /// A `&` that starts no valid reference.
    Lone,
}

/// The reference at the start of `text`, which starts with `&`, and its length.
pub(super) fn reference(text: &str) -> (EntityReference<'_>, usize) {
    let stop = |&byte: &u8| {
        !(byte.is_ascii_alphanumeric() || matches!(byte, b'#' | b'_' | b'-' | b'.' | b':' | 0x80..))
    };
    let length = text.bytes().skip(1).position(|byte| stop(&byte)).map_or(text.len(), |length| length + 1);
    if text.as_bytes().get(length) != Some(&b';') {
        return (EntityReference::Lone, 1);
    }
    let name = &text[1..length];
    let reference = match name {
        "lt" => EntityReference::Character('<'),
        "gt" => EntityReference::Character('>'),
        "amp" => EntityReference::Character('&'),
        "quot" => EntityReference::Character('"'),
        "apos" => EntityReference::Character('\''),
        _ => match name.strip_prefix('#') {
            Some(number) => character(number).map_or(EntityReference::BadNumber, EntityReference::Character),
            None if is_name(name) => EntityReference::Entity(name),
            None => return (EntityReference::Lone, 1),
        },
    };
    (reference, length + 1)
}

fn character(number: &str) -> Option<char> {
    let (digits, radix) = match number.strip_prefix('x') {
        Some(digits) => (digits, 16),
        None => (number, 10),
    };
    if !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let character = char::from_u32(u32::from_str_radix(digits, radix).ok()?)?;
    (!is_forbidden(character)).then_some(character)
}

impl Entities {
    /// Character data with references resolved, and LF for each line end (XML 1.0 §2.11).
    pub(super) fn text<'a>(&self, raw: &'a str) -> Cow<'a, str> {
        match memchr::memchr2(b'&', b'\r', raw.as_bytes()) {
            None => Cow::Borrowed(raw),
            Some(_) => {
                let mut text = String::with_capacity(raw.len());
                self.expand(raw, false, &mut text);
                Cow::Owned(text)
            }
        }
    }

    /// An attribute value with references resolved, and a space for each literal line end and tab (§3.3.3).
    pub(super) fn value<'a>(&self, raw: &'a str) -> Cow<'a, str> {
        if !raw.bytes().any(|byte| matches!(byte, b'&' | b'\t' | b'\n' | b'\r')) {
            return Cow::Borrowed(raw);
        }
        let mut text = String::with_capacity(raw.len());
        self.expand(raw, true, &mut text);
        Cow::Owned(text)
    }

    fn expand(&self, raw: &str, is_value: bool, text: &mut String) {
        let mut rest = raw;
        while let Some(at) = rest.bytes().position(|byte| matches!(byte, b'&' | b'\t' | b'\n' | b'\r')) {
            text.push_str(&rest[..at]);
            rest = &rest[at..];
            let length = match rest.as_bytes() {
                [b'&', ..] => self.push_reference(rest, is_value, text),
                [first, second, ..] => {
                    let is_crlf = (*first, *second) == (b'\r', b'\n');
                    push_blank(*first, is_value, text);
                    1 + usize::from(is_crlf)
                }
                [first] => {
                    push_blank(*first, is_value, text);
                    1
                }
                [] => 0,
            };
            rest = &rest[length..];
        }
        text.push_str(rest);
    }

    /// Appends the value of the reference at the start of `rest`, or the reference itself if its value is
    /// unknown.
    fn push_reference(&self, rest: &str, is_value: bool, text: &mut String) -> usize {
        let (reference, length) = reference(rest);
        match reference {
            EntityReference::Character(character) => text.push(character),
            EntityReference::Entity(name) => match self.declared.get(name) {
                Some(Entity::Text(entity)) if is_value => {
                    text.extend(
                        entity.chars().map(|c| if matches!(c, '\t' | '\n' | '\r') { ' ' } else { c }),
                    );
                }
                Some(Entity::Text(entity)) => text.push_str(entity),
                Some(Entity::Unread(_)) | None => text.push_str(&rest[..length]),
            },
            EntityReference::BadNumber | EntityReference::Lone => text.push_str(&rest[..length]),
        }
        length
    }
}

fn push_blank(byte: u8, is_value: bool, text: &mut String) {
    text.push(match byte {
        _ if is_value => ' ',
        b'\t' => '\t',
        _ => '\n',
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_are_replaced() {
        let entities = Entities::default();
        assert_eq!(entities.text("a &lt;&#x41;&#66;&apos; b\r\nc\rd\te"), "a <AB' b\nc\nd\te");
        assert_eq!(entities.value("a&#9;b\tc\r\nd\ne"), "a\tb c d e");
        assert_eq!(
            entities.text("AT&T &nbsp; &#0; &#xFFFF; &#x; &#+1; &"),
            "AT&T &nbsp; &#0; &#xFFFF; &#x; &#+1; &"
        );
    }

    #[test]
    fn kinds_of_references() {
        assert_eq!(reference("&nbsp; x"), (EntityReference::Entity("nbsp"), 6));
        assert_eq!(reference("&#xD800;"), (EntityReference::BadNumber, 8));
        assert_eq!(reference("& x;"), (EntityReference::Lone, 1));
        assert_eq!(reference("&amp"), (EntityReference::Lone, 1));
    }
}
