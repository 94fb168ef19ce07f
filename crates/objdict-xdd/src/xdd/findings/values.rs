//! The rules about the values of attributes and texts.

use crate::diagnostic::{Diagnostic, Findings, listing, text_rules};
use crate::source::Span;
use crate::xdd::schema::{BAUD_RATES, Kind};

text_rules! {
    INVALID_NUMBER = "cia311/invalid-number", Error;
    summary: "a number is invalid or too large",
    checks: "Whether numeric attributes, such as `objectType`, `granularity` and `nodeID`, are decimal and in range: 8 bits for most, 16 bits for numbers of PDOs.",
    why: "Tools reject the file, ignore the value, or truncate it. Only `index`, `dataType` and similar attributes are hexadecimal.",
    example: r#"`objectType="0x7"`"#,
    remedy: "Write the number in decimal.",
    source: "CiA 311 annex A",

    INVALID_SCALING = "cia311/invalid-scaling", Warning;
    summary: "an offset or multiplier is invalid",
    checks: "Whether `offset` and `multiplier` of parameters and values are numbers, with or without a fraction, and no multiplier is 0.",
    why: "The standard defines (value + offset) * multiplier but declares both as text, so schema validation does not find the error.",
    example: r#"`multiplier="0,1"`"#,
    remedy: "Write a number with a decimal point.",
    source: "CiA 311 annex A",

    INVALID_BOOLEAN = "cia311/invalid-boolean", Error;
    summary: "a Boolean is neither `true` nor `false`",
    checks: "Whether Boolean attributes are `true`, `false`, `1` or `0`, in lower case.",
    why: "Tools reject the file, or read the value as false.",
    example: r#"`bootUpSlave="True"`"#,
    remedy: "Write `true` or `false`.",
    source: "CiA 311 annex A",

    INVALID_HEX = "cia311/invalid-hex", Error;
    summary: "a hexadecimal number has the wrong form",
    checks: "Whether `index` has four hexadecimal digits, `subIndex` two, `dataType` two or four, `objFlags` pairs of them, without `0x` and without `h`.",
    why: "Tools reject the file, or do not find the object.",
    example: r#"`index="0x1000"`, `subIndex="1"`"#,
    remedy: "Write only the digits, such as `1000` or `01`.",
    source: "CiA 311 annex A",

    INVALID_DATE = "cia311/invalid-date", Warning;
    summary: "a date is not written `yyyy-mm-dd`",
    checks: "Whether dates exist in the calendar and are written year, month, day, with or without a time zone.",
    why: "Tools reject the file, or ignore the date. An EDS uses month, day, year.",
    example: r#"`fileCreationDate="01-31-2026"`"#,
    remedy: "Write `2026-01-31`.",
    source: "CiA 311 annex A",

    INVALID_TIME = "cia311/invalid-time", Warning;
    summary: "a time of day is not written `hh:mm:ss`",
    checks: "Whether times have two digits each for hour, minute and second, with or without a fraction and a time zone.",
    why: "Tools reject the file, or ignore the time. An EDS uses `09:45AM`.",
    example: r#"`fileCreationTime="9:45"`"#,
    remedy: "Write `09:45:00`.",
    source: "CiA 311 annex A",

    INVALID_WORD = "cia311/invalid-word", Error;
    summary: "a keyword is not defined in the standard",
    checks: "Whether access types, PDO mappings, LED states and all other keywords are those of the standard, in the same case.",
    why: "Tools reject the file, or use their default.",
    example: r#"`accessType="rwr"`, which belongs into the parameter as `access="readWriteInput"`"#,
    remedy: "Write one of the keywords of the standard.",
    source: "CiA 311 annex A",

    INVALID_BAUD_RATE = "cia311/invalid-baud-rate", Error;
    summary: "a bit rate is not defined in the standard",
    checks: "Whether `supportedBaudRate` and the default are `10 Kbps`, `20 Kbps`, `50 Kbps`, `100 Kbps`, `125 Kbps`, `250 Kbps`, `500 Kbps`, `800 Kbps`, `1000 Kbps` or `auto-baudRate`.",
    why: "Tools reject the file, or do not offer the bit rate.",
    example: r#"`<supportedBaudRate value="125"/>`"#,
    remedy: "Write `125 Kbps`.",
    source: "CiA 311 annex A",

    INVALID_DUMMY = "cia311/invalid-dummy", Error;
    summary: "a dummy entry is not of the form `Dummy0001=0`",
    checks: "Whether `entry` of `dummy` is `Dummy0001` to `Dummy0007` with `=0` or `=1`.",
    why: "The standard defines no others: tools reject the file, or ignore the dummy entry.",
    example: r#"`<dummy entry="0005=1"/>`"#,
    remedy: "Write `Dummy0005=1`.",
    source: "CiA 311 annex A",

    INVALID_ID = "cia311/invalid-id", Warning;
    summary: "an id is not a valid XML name",
    checks: "Whether ids start with a letter or `_` and contain only letters, digits, `.`, `-` and `_`.",
    why: "Schema validation rejects the file, other tools do not resolve references to the id.",
    example: r#"`uniqueID="1000-1"`"#,
    remedy: "Write a name such as `UID_1000-1`, and update its references.",
    source: "CiA 311 annex A, XML Schema (NCName)",

    INVALID_LANGUAGE = "cia311/invalid-language", Warning;
    summary: "a language is not written as `en` or `en-us`",
    checks: "Whether `lang` and `supportedLanguages` are language codes of up to eight letters, with further parts after a hyphen.",
    why: "Tools reject the file, or never show the text.",
    example: r#"`lang="en_US"`"#,
    remedy: "Write `en-us`.",
    source: "CiA 311 annex A, XML Schema (language)",
}

/// Reports `text`, the value of `name` at `at`, unless it is valid for its kind.
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
            new(&INVALID_SCALING, "not a valid multiplier: all values become 0")
                .help("write the factor or remove the attribute for 1")
        }
        Kind::Decimal => new(&INVALID_SCALING, &format!("not a number, as `{name}` requires"))
            .help("write a number with a decimal point"),
        Kind::Boolean => {
            new(&INVALID_BOOLEAN, &format!("not a valid `{name}`: `true` or `false` is expected"))
                .help("write `true` or `false` in lower case")
        }
        Kind::Hex(least, most) => {
            let digits = if least == most {
                format!("{least} hexadecimal digits")
            } else {
                format!("{least} to {most} hexadecimal digits in pairs")
            };
            new(&INVALID_HEX, &format!("not a valid `{name}`: {digits} are expected"))
                .help(hex_help(text, least))
        }
        Kind::Date => new(&INVALID_DATE, "not a date of the form `yyyy-mm-dd`")
            .help("write year, month and day with four, two and two digits: `2026-01-31`"),
        Kind::Time => new(&INVALID_TIME, "not a time of the form `hh:mm:ss`")
            .help("write hour (00 to 23), minute and second with two digits each: `09:45:00`"),
        Kind::Word(words) | Kind::Words(words) => {
            new(&INVALID_WORD, &format!("not a valid `{name}`")).help(word_help(text, words))
        }
        Kind::BaudRate => new(&INVALID_BAUD_RATE, "not a bit rate of CiA 311").help(rate_help(text)),
        Kind::Dummy => new(&INVALID_DUMMY, "not of the form `Dummy0001=0`")
            .help("write `Dummy`, the data type from 0001 to 0007, and `=0` or `=1`"),
        Kind::Language | Kind::Languages => {
            new(&INVALID_LANGUAGE, "not a language code").help(language_help(text))
        }
        Kind::Id | Kind::Name | Kind::Names | Kind::Text | Kind::Rate | Kind::Reference(_) => {
            new(&INVALID_ID, &format!("not a valid `{name}`"))
                .help("start with a letter or `_`, and use letters, digits, `.`, `-` and `_`")
        }
    }
}

fn invalid_number(text: &str, shown: &str, name: &str, (low, high): (i128, i128), at: Span) -> Diagnostic {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"));
    let hex = digits.and_then(|digits| i128::from_str_radix(digits, 16).ok());
    let (message, help) = match (whole_number(text), hex) {
        (Some(_), _) if high == i128::MAX => (
            format!("{shown} is out of range for `{name}`: at least {low}"),
            "write a number in this range".to_owned(),
        ),
        (Some(_), _) => (
            format!("{shown} is out of range for `{name}`: {low} to {high}"),
            "write a number in this range".to_owned(),
        ),
        (None, Some(hex)) => {
            (format!("{shown} is hexadecimal, but `{name}` is decimal"), format!("write `{hex}`"))
        }
        (None, None) => (
            format!("{shown} is not a decimal number, as `{name}` requires"),
            "write decimal digits".to_owned(),
        ),
    };
    Diagnostic::new(&INVALID_NUMBER, at, message).help(help)
}

/// The intended hex digits, padded with zeros.
fn hex_help(text: &str, least: usize) -> String {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).unwrap_or(text);
    let digits = digits.strip_suffix(['h', 'H']).unwrap_or(digits);
    match u32::from_str_radix(digits, 16) {
        Ok(number) if format!("{number:X}").len() <= least => format!("write `{number:0least$X}`"),
        _ => "write only pairs of hexadecimal digits".to_owned(),
    }
}

fn word_help(text: &str, words: &[&str]) -> String {
    match words.iter().find(|word| word.eq_ignore_ascii_case(text)) {
        Some(word) => format!("write `{word}`"),
        None if matches!(text, "rwr" | "rww") && words.contains(&"rw") => {
            let access = if text == "rwr" { "readWriteInput" } else { "readWriteOutput" };
            format!("write `rw`, and `access=\"{access}\"` in the parameter that the entry refers to")
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

/// Numbers with the given lengths, separated by a character.
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

/// Combining characters, which are allowed in names except as the first character.
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
