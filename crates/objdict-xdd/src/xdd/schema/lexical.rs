//! The types of attribute values and texts in XML Schema notation.

use crate::model::Date;
use crate::xml;

impl TextKind {
    /// Whether the schema allows a string.
    pub(crate) fn accepts(self, text: &str) -> bool {
        let trimmed = text.trim_ascii();
        match self {
            // the standard declares the numbers with a fraction as strings
            Self::Text | Self::Rate | Self::Decimal => true,
            // whitespace for ASCII functions, but not in XML
            _ if text.contains('\u{c}') => false,
            Self::Boolean => matches!(trimmed, "true" | "false" | "1" | "0"),
            Self::Number(low, high) => {
                whole_number(trimmed).is_some_and(|number| (low..=high).contains(&number))
            }
            Self::Hex(least, most) => is_hex(trimmed, least, most),
            Self::Date => is_date(trimmed),
            Self::Time => is_time(trimmed),
            Self::Word(words) => words.contains(&trimmed),
            Self::Words(words) => trimmed.split_ascii_whitespace().all(|word| words.contains(&word)),
            Self::BaudRate => BAUD_RATES.contains(&trimmed),
            Self::Dummy => is_dummy(trimmed),
            Self::Id | Self::Name | Self::Reference(_) => is_name(trimmed),
            Self::Names => trimmed.split_ascii_whitespace().all(|word| word.chars().all(is_name_character)),
            Self::Language => is_language(trimmed),
            Self::Languages => trimmed.split_ascii_whitespace().all(is_language),
        }
    }
}

/// A whole number in decimal, as XML Schema writes it.
pub(crate) fn whole_number(text: &str) -> Option<i128> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| text.parse().unwrap_or(if text.starts_with('-') { i128::MIN } else { i128::MAX }))
}

pub(crate) fn decimal(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

fn is_hex(text: &str, least: usize, most: usize) -> bool {
    let length = text.len();
    // only `sortStep`, whose default the standard misprints, may have one digit
    let is_even = length.is_multiple_of(2) || least == 1;
    is_even && (least..=most).contains(&length) && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// Removes a time zone: `Z`, or a sign with hours and minutes.
fn without_zone(text: &str) -> &str {
    if let Some(text) = text.strip_suffix('Z') {
        return text;
    }
    let Some((rest, zone)) = text.len().checked_sub(6).and_then(|at| text.split_at_checked(at)) else {
        return text;
    };
    let is_zone = zone.starts_with(['+', '-'])
        && numbers(&zone[1..], ':', &[2, 2]).is_some_and(|zone| zone[0] <= 14 && zone[1] < 60);
    if is_zone { rest } else { text }
}

/// Numbers with the given lengths, delimited by a character.
fn numbers(text: &str, between: char, lengths: &[usize]) -> Option<Vec<u32>> {
    let parts: Vec<&str> = text.split(between).collect();
    let fits = parts.len() == lengths.len()
        && parts
            .iter()
            .zip(lengths)
            .all(|(part, &length)| part.len() == length && part.bytes().all(|byte| byte.is_ascii_digit()));
    fits.then(|| parts.iter().filter_map(|part| part.parse().ok()).collect())
}

fn is_date(text: &str) -> bool {
    let text = without_zone(text);
    let has_form = numbers(text, '-', &[4, 2, 2]).is_some_and(|date| date[0] > 0);
    has_form && Date::from_iso(text).is_some()
}

fn is_time(text: &str) -> bool {
    let text = without_zone(text);
    let (clock, fraction) = text.split_once('.').unwrap_or((text, "0"));
    let Some(clock) = numbers(clock, ':', &[2, 2, 2]) else { return false };
    let is_fraction = !fraction.is_empty() && fraction.bytes().all(|byte| byte.is_ascii_digit());
    let is_midnight = clock == [24, 0, 0] && fraction.bytes().all(|byte| byte == b'0');
    is_fraction && (is_midnight || (clock[0] < 24 && clock[1] < 60 && clock[2] < 60))
}

fn is_dummy(text: &str) -> bool {
    let Some((data_type, value)) = text.strip_prefix("Dummy").and_then(|entry| entry.split_once('=')) else {
        return false;
    };
    let is_type = data_type.len() == 4
        && matches!(data_type.strip_prefix("000"), Some("1" | "2" | "3" | "4" | "5" | "6" | "7"));
    is_type && matches!(value, "0" | "1")
}

/// Whether a text is a name without a colon (NCName).
pub(crate) fn is_name(text: &str) -> bool {
    xml::is_name(text) && !text.contains(':')
}

/// Whether a name without a colon can contain a character.
pub(crate) fn is_name_character(character: char) -> bool {
    xml::is_name_char(character) && character != ':'
}

pub(crate) fn is_language(text: &str) -> bool {
    let mut parts = text.split('-');
    let is_first = |part: &str| part.bytes().all(|byte| byte.is_ascii_alphabetic());
    let fits = |part: &str| (1..=8).contains(&part.len());
    let first = parts.next().is_some_and(|part| fits(part) && is_first(part));
    first && parts.all(|part| fits(part) && part.bytes().all(|byte| byte.is_ascii_alphanumeric()))
}

/// The type of a string.
#[derive(Clone, Copy, Debug)]
pub(crate) enum TextKind {
    /// Any string.
    Text,
    /// `true`, `false`, `1` or `0`.
    Boolean,
    /// A whole number in decimal within a range.
    Number(i128, i128),
    /// A number with or without a fraction. The standard declares a string.
    Decimal,
    /// Hex digits: the minimum and maximum number.
    Hex(usize, usize),
    /// `yyyy-mm-dd`, with or without a time zone.
    Date,
    /// `hh:mm:ss`, with or without a fraction and a time zone.
    Time,
    /// One of these keywords.
    Word(&'static [&'static str]),
    /// Several of these keywords, separated by spaces.
    Words(&'static [&'static str]),
    /// A bit rate of the list.
    BaudRate,
    /// A bit rate in any spelling.
    Rate,
    /// `Dummy0001=0` to `Dummy0007=1`.
    Dummy,
    /// An id that is unique in the file.
    Id,
    /// The id of another element.
    Reference(ReferenceTarget),
    /// An XML name.
    Name,
    /// A language such as `en` or `de-at`.
    Language,
    /// Languages, separated by spaces.
    Languages,
    /// Names, separated by spaces.
    Names,
}

/// The possible target of a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ReferenceTarget {
    /// The counterpart of a dictionary object in the application.
    Application,
    Parameter,
    DataType,
    ParameterTemplate,
    AllowedValuesTemplate,
    LedState,
    FunctionType,
    FunctionInstance,
    Variable,
    ModuleInterface,
}

impl TextKind {
    pub(super) const BYTE: Self = Self::Number(0, 0xFF);
    pub(super) const SHORT: Self = Self::Number(0, 0xFFFF);
    pub(super) const INT: Self = Self::Number(0, 0xFFFF_FFFF);
    pub(super) const UNSIGNED_LONG: Self = Self::Number(0, u64::MAX as i128);
    pub(super) const LONG: Self = Self::Number(i64::MIN as i128, i64::MAX as i128);
    pub(super) const POSITIVE: Self = Self::Number(1, i128::MAX);
    pub(super) const NATURAL: Self = Self::Number(0, i128::MAX);
}

/// The bit rates that `supportedBaudRate` allows.
pub(crate) const BAUD_RATES: [&str; 10] = [
    "10 Kbps",
    "20 Kbps",
    "50 Kbps",
    "100 Kbps",
    "125 Kbps",
    "250 Kbps",
    "500 Kbps",
    "800 Kbps",
    "1000 Kbps",
    "auto-baudRate",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_and_times_are_those_of_xml_schema() {
        for date in
            ["2026-01-31", "2024-02-29", "2000-02-29", "2026-01-31Z", "2026-01-31+01:00", "2026-01-31-05:00"]
        {
            assert!(is_date(date), "{date}");
        }
        for date in [
            "",
            "2026-1-31",
            "2023-02-29",
            "1900-02-29",
            "2026-04-31",
            "01-31-2026",
            "2026-13-01",
            "0000-01-01",
            "2026-01-31+25:00",
        ] {
            assert!(!is_date(date), "{date}");
        }
        for time in ["09:45:00", "23:59:59.9999999+02:00", "24:00:00", "00:00:00Z", "06:00:00.0000000-05:00"]
        {
            assert!(is_time(time), "{time}");
        }
        for time in ["", "9:45:00", "09:45", "09:45AM", "24:00:01", "09:60:00", "09:45:00."] {
            assert!(!is_time(time), "{time}");
        }
    }

    #[test]
    fn numbers_are_decimal() {
        assert_eq!(whole_number("007"), Some(7));
        assert_eq!(whole_number("-1"), Some(-1));
        for text in ["", "+", "0x7", "1.0", "7 "] {
            assert_eq!(whole_number(text), None, "{text}");
        }
        assert_eq!(whole_number(&"9".repeat(60)), Some(i128::MAX));
        assert!(is_hex("00FF", 4, 4) && is_hex("ff", 2, 4) && is_hex("1", 1, 4));
        assert!(!is_hex("FFF", 2, 4) && !is_hex("0x10", 4, 4) && !is_hex("", 2, 4) && !is_hex("é0", 2, 4));
    }

    #[test]
    fn names_and_languages() {
        assert!(is_name("UID_OBJ_1000") && is_name("_1") && is_name("größe.2-a"));
        assert!(!is_name("") && !is_name("1000") && !is_name("a b") && !is_name("a:b") && !is_name("-a"));
        assert!(
            is_language("en") && is_language("en-us") && is_language("x-klingon") && is_language("de-1996")
        );
        assert!(!is_language("") && !is_language("en_US") && !is_language("1en") && !is_language("en-"));
    }
}
