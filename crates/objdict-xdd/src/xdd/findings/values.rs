//! The rules about what attributes and texts take.

use crate::diagnostic::{Diagnostic, Findings, listing, text_rules};
use crate::source::Span;
use crate::xdd::schema::{BAUD_RATES, Kind};

text_rules! {
    /// a number is none, or too large
    ///
    /// ## What it checks
    /// Whether attributes that are numbers, such as `objectType`, `granularity` and `nodeID`, are written in decimal and fit: most into a byte, the numbers of PDOs into 16 bits.
    ///
    /// ## Why it matters
    /// Tools refuse the file, leave the value out, or cut it to size. Here only `index`, `dataType` and the like are in hex.
    ///
    /// ## Example
    /// `objectType="0x7"`
    ///
    /// ## How to mend
    /// Write the number in decimal.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_NUMBER = "cia311/invalid-number", Error;

    /// an offset or multiplier is no number
    ///
    /// ## What it checks
    /// Whether `offset` and `multiplier` of parameters and values are numbers, with or without a fraction, and no multiplier is 0.
    ///
    /// ## Why it matters
    /// The standard says (value + offset) * multiplier and calls both of them texts, so no tool finds the mistake before it calculates.
    ///
    /// ## Example
    /// `multiplier="0,1"`
    ///
    /// ## How to mend
    /// Write a number with a decimal point.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_SCALING = "cia311/invalid-scaling", Warning;

    /// a flag is neither `true` nor `false`
    ///
    /// ## What it checks
    /// Whether attributes that are flags are `true`, `false`, `1` or `0`, in small letters.
    ///
    /// ## Why it matters
    /// Tools refuse the file, or take the flag for false.
    ///
    /// ## Example
    /// `bootUpSlave="True"`
    ///
    /// ## How to mend
    /// Write `true` or `false`.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_BOOLEAN = "cia311/invalid-boolean", Error;

    /// a hex number is not written with so many hex digits and nothing else
    ///
    /// ## What it checks
    /// Whether `index` has four hex digits, `subIndex` two, `dataType` two or four, `objFlags` pairs of them, without `0x` and without `h`.
    ///
    /// ## Why it matters
    /// Tools refuse the file, or do not find the object.
    ///
    /// ## Example
    /// `index="0x1000"`, `subIndex="1"`
    ///
    /// ## How to mend
    /// Write `1000`, `01`.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_HEX = "cia311/invalid-hex", Error;

    /// a date is not written `yyyy-mm-dd`
    ///
    /// ## What it checks
    /// Whether dates are dates of the calendar and written year, month, day, with a time zone or without.
    ///
    /// ## Why it matters
    /// Tools refuse the file, or leave the date out. An EDS writes month, day, year.
    ///
    /// ## Example
    /// `fileCreationDate="01-31-2026"`
    ///
    /// ## How to mend
    /// Write `2026-01-31`.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_DATE = "cia311/invalid-date", Warning;

    /// a time of day is not written `hh:mm:ss`
    ///
    /// ## What it checks
    /// Whether times have two digits each for hour, minute and second, with a fraction and a time zone or without.
    ///
    /// ## Why it matters
    /// Tools refuse the file, or leave the time out. An EDS writes `09:45AM`.
    ///
    /// ## Example
    /// `fileCreationTime="9:45"`
    ///
    /// ## How to mend
    /// Write `09:45:00`.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_TIME = "cia311/invalid-time", Warning;

    /// a word is none of those that the standard has for it
    ///
    /// ## What it checks
    /// Whether access types, PDO mappings, LED states and all other words are words of the list, in the same capital and small letters.
    ///
    /// ## Why it matters
    /// Tools refuse the file, or take what they have as default.
    ///
    /// ## Example
    /// `accessType="rwr"`, which belongs into the parameter as `access="readWriteInput"`
    ///
    /// ## How to mend
    /// Write one of the words.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_WORD = "cia311/invalid-word", Error;

    /// a bit rate is none of those that the standard has
    ///
    /// ## What it checks
    /// Whether `supportedBaudRate` and the default are `10 Kbps`, `20 Kbps`, `50 Kbps`, `100 Kbps`, `125 Kbps`, `250 Kbps`, `500 Kbps`, `800 Kbps`, `1000 Kbps` or `auto-baudRate`.
    ///
    /// ## Why it matters
    /// Tools refuse the file, or the device seems to lack the bit rate.
    ///
    /// ## Example
    /// `<supportedBaudRate value="125"/>`
    ///
    /// ## How to mend
    /// Write `125 Kbps`.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_BAUD_RATE = "cia311/invalid-baud-rate", Error;

    /// a dummy entry is not of the form `Dummy0001=0`
    ///
    /// ## What it checks
    /// Whether `entry` of `dummy` is `Dummy0001` to `Dummy0007` with `=0` or `=1`.
    ///
    /// ## Why it matters
    /// The standard has no other ones: tools refuse the file, or the filler is not known.
    ///
    /// ## Example
    /// `<dummy entry="0005=1"/>`
    ///
    /// ## How to mend
    /// Write `Dummy0005=1`.
    ///
    /// ## Source
    /// CiA 311 annex A
    INVALID_DUMMY = "cia311/invalid-dummy", Error;

    /// an id is no name
    ///
    /// ## What it checks
    /// Whether ids start with a letter or `_` and have only letters, digits, `.`, `-` and `_` in them.
    ///
    /// ## Why it matters
    /// Tools that check a file against the schema refuse it, others do not find what refers to the id.
    ///
    /// ## Example
    /// `uniqueID="1000-1"`
    ///
    /// ## How to mend
    /// Write `UID_1000-1`, and change what refers to it.
    ///
    /// ## Source
    /// CiA 311 annex A, XML Schema (NCName)
    INVALID_ID = "cia311/invalid-id", Warning;

    /// a language is not written as `en` or `en-us`
    ///
    /// ## What it checks
    /// Whether `lang` and `supportedLanguages` are language codes of up to eight letters, with more parts behind a dash.
    ///
    /// ## Why it matters
    /// Tools refuse the file, or show the text to nobody.
    ///
    /// ## Example
    /// `lang="en_US"`
    ///
    /// ## How to mend
    /// Write `en-us`.
    ///
    /// ## Source
    /// CiA 311 annex A, XML Schema (language)
    INVALID_LANGUAGE = "cia311/invalid-language", Warning;
}

/// Whether `text`, which stands at `at` and is called `name`, is what its kind takes; if not, a finding says so.
pub(super) fn check(text: &str, kind: Kind, at: Span, name: &str, findings: &mut Findings) -> bool {
    let trimmed = text.trim_ascii();
    let is_valid = match kind {
        Kind::Text | Kind::Rate | Kind::Reference(_) => true,
        Kind::Boolean => matches!(trimmed, "true" | "false" | "1" | "0"),
        Kind::Number(low, high) => whole_number(trimmed).is_some_and(|number| (low..=high).contains(&number)),
        Kind::Decimal => decimal(trimmed).is_some_and(|number| number != 0.0 || name != "multiplier"),
        Kind::Hex(least, most) => is_hex(trimmed, least, most),
        Kind::Date => is_date(trimmed),
        Kind::Time => is_time(trimmed),
        Kind::Word(words) => words.contains(&trimmed),
        Kind::Words(words) => trimmed.split_ascii_whitespace().all(|word| words.contains(&word)),
        Kind::BaudRate => BAUD_RATES.contains(&trimmed),
        Kind::Dummy => is_dummy(trimmed),
        Kind::Id | Kind::Name => is_name(trimmed),
        Kind::Names => trimmed.split_ascii_whitespace().all(|word| word.chars().all(is_name_character)),
        Kind::Language => is_language(trimmed),
        Kind::Languages => trimmed.split_ascii_whitespace().all(is_language),
    };
    if !is_valid {
        findings.push(finding(trimmed, kind, at, name));
    }
    is_valid
}

fn finding(text: &str, kind: Kind, at: Span, name: &str) -> Diagnostic {
    let shown = if text.is_empty() { "an empty text".to_owned() } else { format!("`{text}`") };
    let new = |rule, what: &str| Diagnostic::new(rule, at, format!("{shown} is {what}"));
    match kind {
        Kind::Number(low, high) => invalid_number(text, &shown, name, (low, high), at),
        Kind::Decimal if decimal(text).is_some() => {
            new(&INVALID_SCALING, "no multiplier: all values become 0")
                .help("write the factor, or remove the attribute for 1")
        }
        Kind::Decimal => new(&INVALID_SCALING, &format!("no number; `{name}` takes one"))
            .help("write a number with a decimal point"),
        Kind::Boolean => {
            new(&INVALID_BOOLEAN, &format!("neither `true` nor `false`; `{name}` takes one of them"))
                .help("write `true` or `false` in small letters")
        }
        Kind::Hex(least, most) => {
            let digits = if least == most {
                format!("{least} hex digits")
            } else {
                format!("{least} to {most} hex digits in pairs")
            };
            new(&INVALID_HEX, &format!("not what `{name}` takes, {digits}")).help(hex_help(text, least))
        }
        Kind::Date => new(&INVALID_DATE, "no date of the form `yyyy-mm-dd`")
            .help("write year, month and day with four, two and two digits: `2026-01-31`"),
        Kind::Time => new(&INVALID_TIME, "no time of the form `hh:mm:ss`")
            .help("write hour (00 to 23), minute and second with two digits each: `09:45:00`"),
        Kind::Word(words) | Kind::Words(words) => {
            new(&INVALID_WORD, &format!("none of the words that `{name}` takes")).help(word_help(text, words))
        }
        Kind::BaudRate => {
            new(&INVALID_BAUD_RATE, "none of the bit rates that the standard has").help(rate_help(text))
        }
        Kind::Dummy => new(&INVALID_DUMMY, "not of the form `Dummy0001=0`")
            .help("write `Dummy`, the data type from 0001 to 0007, and `=0` or `=1`"),
        Kind::Language | Kind::Languages => {
            new(&INVALID_LANGUAGE, "no language code").help(language_help(text))
        }
        Kind::Id | Kind::Name | Kind::Names | Kind::Text | Kind::Rate | Kind::Reference(_) => {
            new(&INVALID_ID, &format!("no name, as `{name}` takes it"))
                .help("start with a letter or `_`, and use letters, digits, `.`, `-` and `_`")
        }
    }
}

fn invalid_number(text: &str, shown: &str, name: &str, (low, high): (i128, i128), at: Span) -> Diagnostic {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"));
    let hex = digits.and_then(|digits| i128::from_str_radix(digits, 16).ok());
    let (message, help) = match (whole_number(text), hex) {
        (Some(_), _) if high == i128::MAX => (
            format!("{shown} does not fit `{name}`, which takes {low} and more"),
            "write a number that fits".to_owned(),
        ),
        (Some(_), _) => (
            format!("{shown} does not fit `{name}`, which takes {low} to {high}"),
            "write a number that fits".to_owned(),
        ),
        (None, Some(hex)) => {
            (format!("{shown} is in hex; `{name}` takes decimal digits"), format!("write `{hex}`"))
        }
        (None, None) => (
            format!("{shown} is no number; `{name}` takes one in decimal"),
            "write decimal digits".to_owned(),
        ),
    };
    Diagnostic::new(&INVALID_NUMBER, at, message).help(help)
}

/// The hex digits that someone meant, filled up with zeros.
fn hex_help(text: &str, least: usize) -> String {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).unwrap_or(text);
    let digits = digits.strip_suffix(['h', 'H']).unwrap_or(digits);
    match u32::from_str_radix(digits, 16) {
        Ok(number) if format!("{number:X}").len() <= least => format!("write `{number:0least$X}`"),
        _ => "write pairs of hex digits without anything before or behind them".to_owned(),
    }
}

fn word_help(text: &str, words: &[&str]) -> String {
    match words.iter().find(|word| word.eq_ignore_ascii_case(text)) {
        Some(word) => format!("write `{word}`"),
        None if matches!(text, "rwr" | "rww") && words.contains(&"rw") => {
            let access = if text == "rwr" { "readWriteInput" } else { "readWriteOutput" };
            format!("write `rw`, and `access=\"{access}\"` at the parameter that the entry refers to")
        }
        None => match words {
            [word] => format!("write `{word}`"),
            _ => format!("use one of {}", listing(words)),
        },
    }
}

fn rate_help(text: &str) -> String {
    let digits: String = text.chars().take_while(char::is_ascii_digit).collect();
    let digits = digits.strip_suffix("000").filter(|digits| digits.len() > 1).unwrap_or(&digits);
    match BAUD_RATES.iter().find(|rate| rate.split(' ').next() == Some(digits)) {
        Some(rate) => format!("write `{rate}`"),
        None => format!("use one of {}", listing(BAUD_RATES)),
    }
}

fn language_help(text: &str) -> String {
    let meant = text.replace('_', "-").to_ascii_lowercase();
    if !meant.is_empty() && meant.split_ascii_whitespace().all(is_language) {
        format!("write `{meant}`")
    } else {
        "write a code such as `en`, `de` or `en-us`".to_owned()
    }
}

/// A whole number in decimal, as XML Schema writes it.
fn whole_number(text: &str) -> Option<i128> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| text.parse().unwrap_or(if text.starts_with('-') { i128::MIN } else { i128::MAX }))
}

fn decimal(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

fn is_hex(text: &str, least: usize, most: usize) -> bool {
    let length = text.len();
    // only `sortStep`, whose default the standard misprints, may have one digit
    let is_even = length.is_multiple_of(2) || least == 1;
    is_even && (least..=most).contains(&length) && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// Takes a time zone off: `Z`, or hours and minutes behind a sign.
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

/// Numbers of so many digits each, with a character between them.
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
    let Some(date) = numbers(without_zone(text), '-', &[4, 2, 2]) else { return false };
    let [year, month, day] = date[..] else { return false };
    let is_leap_year = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let days = match month {
        2 if is_leap_year => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return false,
    };
    year > 0 && (1..=days).contains(&day)
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
pub(super) fn is_name(text: &str) -> bool {
    let starts = text.chars().next().is_some_and(|first| first.is_alphabetic() || first == '_');
    starts && text.chars().all(is_name_character)
}

fn is_name_character(character: char) -> bool {
    character.is_alphanumeric() || matches!(character, '.' | '-' | '_' | '\u{B7}') || is_combining(character)
}

/// Accents and the like, which names may have behind their first character.
fn is_combining(character: char) -> bool {
    matches!(character, '\u{300}'..='\u{36F}' | '\u{203F}'..='\u{2040}')
}

fn is_language(text: &str) -> bool {
    let mut parts = text.split('-');
    let is_first = |part: &str| part.bytes().all(|byte| byte.is_ascii_alphabetic());
    let fits = |part: &str| (1..=8).contains(&part.len());
    let first = parts.next().is_some_and(|part| fits(part) && is_first(part));
    first && parts.all(|part| fits(part) && part.bytes().all(|byte| byte.is_ascii_alphanumeric()))
}

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
        assert_eq!(language_help("en_US"), "write `en-us`");
        assert_eq!(rate_help("125"), "write `125 Kbps`");
        assert_eq!(rate_help("1000000"), "write `1000 Kbps`");
        assert_eq!(hex_help("0x1000", 4), "write `1000`");
        assert_eq!(hex_help("1", 2), "write `01`");
    }
}
