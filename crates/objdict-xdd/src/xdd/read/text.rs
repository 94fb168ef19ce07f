//! Texts of attributes and elements as numbers and words.

use std::borrow::Cow;

use crate::diagnostic::Findings;
use crate::literal::{self, Quirks};
use crate::model::{DataType, Field, Misfits, Reason, Value};
use crate::source::Span;
use crate::xml::{Attribute, Element};

/// A text with where it stands.
#[derive(Clone, Debug)]
pub(crate) struct Text<'a> {
    /// The text, without blanks at its ends where it is an element's.
    pub(crate) text: Cow<'a, str>,
    /// Where it stands.
    pub(crate) at: Span,
}

impl<'a> Text<'a> {
    /// The value of an attribute.
    pub(crate) fn of(attribute: Attribute<'a>) -> Self {
        Self { text: attribute.value(), at: attribute.value_span() }
    }

    /// The text of an element, without blanks at its ends.
    pub(crate) fn in_element(element: Element<'a>) -> Self {
        let text = match element.text() {
            Cow::Borrowed(text) => Cow::Borrowed(text.trim_ascii()),
            Cow::Owned(text) => Cow::Owned(text.trim_ascii().to_owned()),
        };
        Self { text, at: element.text_span() }
    }

    /// The text without blanks at its ends.
    pub(crate) fn trimmed(&self) -> &str {
        self.text.trim_ascii()
    }

    /// Whether it says nothing.
    pub(crate) fn is_blank(&self) -> bool {
        self.trimmed().is_empty()
    }

    /// Notes that the text is no value of its field.
    pub(crate) fn misfit(&self, field: Field, reason: Reason, misfits: &mut Misfits) {
        misfits.push(field, &self.text, reason);
    }

    /// A whole number within `low..=high`, in decimal or behind `0x` in hex.
    pub(crate) fn integer<T: TryFrom<i128>>(
        &self,
        field: Field,
        (low, high): (i64, u64),
        misfits: &mut Misfits,
        findings: &mut Findings,
    ) -> Option<T> {
        let text = self.trimmed();
        if text.is_empty() {
            return None;
        }
        let mut quirks = Quirks::default();
        match literal::integer(text, low, high, &mut quirks) {
            Ok(number) => {
                literal::spelling(text, self.at, quirks, None, findings);
                T::try_from(number).ok()
            }
            Err(reason) => {
                self.misfit(field, reason, misfits);
                None
            }
        }
    }

    /// A number in hex, with or without `0x`, of at most `digits` digits.
    pub(crate) fn hex(&self, field: Field, digits: usize, misfits: &mut Misfits) -> Option<u32> {
        let text = self.trimmed();
        if text.is_empty() {
            return None;
        }
        let number = hex(text, digits);
        if number.is_none() {
            self.misfit(field, Reason::NotANumber, misfits);
        }
        number
    }

    /// `true` or `false`, `1` or `0`.
    pub(crate) fn boolean(&self, field: Field, misfits: &mut Misfits) -> Option<bool> {
        self.word(field, boolean, misfits)
    }

    /// A word that `find` knows.
    pub(crate) fn word<T>(
        &self,
        field: Field,
        find: impl FnOnce(&str) -> Option<T>,
        misfits: &mut Misfits,
    ) -> Option<T> {
        let text = self.trimmed();
        if text.is_empty() {
            return None;
        }
        let word = find(text);
        if word.is_none() {
            self.misfit(field, Reason::UnknownWord, misfits);
        }
        word
    }

    /// A value of a data type; an empty text is none.
    pub(crate) fn value(
        &self,
        data_type: Option<DataType>,
        findings: &mut Findings,
    ) -> Option<Result<Value, Reason>> {
        let text = value_text(&self.text, data_type)?;
        let mut quirks = Quirks::default();
        let value = literal::value(text, data_type, &mut quirks);
        if let Ok(value) = &value {
            literal::spelling(text, self.at, quirks, Some(value), findings);
        }
        Some(value)
    }
}

/// The part of a text that is a value: blanks at its ends only belong to strings. `None` for an empty one.
pub(crate) fn value_text(text: &str, data_type: Option<DataType>) -> Option<&str> {
    let is_string = matches!(data_type, Some(DataType::VISIBLE_STRING | DataType::UNICODE_STRING));
    let text = if is_string { text } else { text.trim_ascii() };
    Some(text).filter(|text| !text.is_empty())
}

/// A number in hex, with or without `0x`, of at most `digits` digits.
pub(crate) fn hex(text: &str, digits: usize) -> Option<u32> {
    let text = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).unwrap_or(text);
    let is_hex = (1..=digits).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_hex { u32::from_str_radix(text, 16).ok() } else { None }
}

/// A truth value of XML Schema, in any case.
pub(crate) fn boolean(text: &str) -> Option<bool> {
    match () {
        () if text == "1" || text.eq_ignore_ascii_case("true") => Some(true),
        () if text == "0" || text.eq_ignore_ascii_case("false") => Some(false),
        () => None,
    }
}

/// A bit rate: `250 Kbps`, or as other tools spell it.
pub(crate) fn bit_rate(text: &str) -> Option<u16> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let unit = text[digits..].trim_ascii().to_ascii_lowercase();
    let number: u32 = text[..digits].parse().ok()?;
    let kbit = match unit.as_str() {
        "" | "kbps" | "kbit/s" | "kbits/s" | "kb/s" | "kbit" | "kbaud" | "k" => number,
        "mbps" | "mbit/s" => number.checked_mul(1000)?,
        "bps" | "bit/s" if number.is_multiple_of(1000) => number / 1000,
        _ => return None,
    };
    u16::try_from(kbit).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bit_rates_in_the_spellings_of_real_files() {
        for text in ["250 Kbps", "250 kbit/s", "250Kbps", "250", "250000 bit/s"] {
            assert_eq!(bit_rate(text), Some(250), "{text}");
        }
        assert_eq!(bit_rate("1 Mbit/s"), Some(1000));
        for text in ["", "fast", "250 rpm", "70000 Kbps", "-5 Kbps", "1.5 Mbps"] {
            assert_eq!(bit_rate(text), None, "{text}");
        }
    }

    #[test]
    fn hex_digits_with_and_without_a_prefix() {
        assert_eq!(hex("1018", 4), Some(0x1018));
        assert_eq!(hex("0x1a", 4), Some(0x1A));
        for text in ["", "0x", "1 8", "+18", "12345", "10G0"] {
            assert_eq!(hex(text, 4), None, "{text}");
        }
    }
}
