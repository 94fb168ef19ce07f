//! The rules about the values of attributes and texts.

use crate::diagnostic::{Diagnostic, Findings, Fix, Text, listing, say, text_rules};
use crate::literal;
use crate::source::Span;
use crate::xdd::fact;
use crate::xdd::schema::{BAUD_RATES, TextKind, decimal, is_language, whole_number};

text_rules! {
    source: "CiA 311 annex A";

    "cia311/invalid-number" = INVALID_NUMBER, Error;
    summary: "a number is invalid or too large",
    checks: "Numeric attributes, such as `objectType`, `granularity` and `nodeID`, must be decimal and in range: 8 bits for most, 16 bits for numbers of PDOs.",
    why: "Tools reject the file, ignore the value, or truncate it. Only `index`, `dataType` and similar attributes are hexadecimal.",
    example: r#"`objectType="0x7"`"#,
    remedy: "Write the number in decimal.",

    "cia311/invalid-scaling" = INVALID_SCALING, Warning;
    summary: "an offset or multiplier is invalid",
    checks: "`offset` and `multiplier` of parameters and values must be numbers, with or without a fraction. No multiplier may be 0.",
    why: "The standard defines (value + offset) * multiplier but declares both as text, so schema validation does not find the error.",
    example: r#"`multiplier="0,1"`"#,
    remedy: "Write a number with a decimal point.",

    "cia311/invalid-boolean" = INVALID_BOOLEAN, Error;
    summary: "a Boolean is neither `true` nor `false`",
    checks: "A Boolean attribute must be `true`, `false`, `1` or `0`, in lower case.",
    why: "Tools reject the file or read the value as false.",
    example: r#"`bootUpSlave="True"`"#,
    remedy: "Write `true` or `false`.",

    "cia311/invalid-hex" = INVALID_HEX, Error, fix Safe, stops "*";
    summary: "a hexadecimal number has the wrong format",
    checks: "`index` must have four hexadecimal digits, `subIndex` two, `dataType` two or four, and `objFlags` pairs of them, without `0x` and without `h`. Additional leading zeros are ignored.",
    why: "Tools reject the file or do not find the object.",
    example: r#"`index="0x1000"`, `subIndex="1"`, `subIndex="0001"`"#,
    remedy: "Write only the digits, such as `1000` or `01`.",

    "cia311/invalid-date" = INVALID_DATE, Warning, fix Mixed;
    summary: "a date is not written `yyyy-mm-dd`",
    checks: "Dates must exist in the calendar and be written year, month, day, with or without a time zone. Other spellings, such as `01-31-2026` and `31-Jan-2026`, are read and are only a note.",
    why: "Tools reject the file or ignore the date. An EDS uses month, day, year.",
    example: r#"`fileCreationDate="01-31-2026"`"#,
    remedy: "Write `2026-01-31`.",

    "cia311/invalid-time" = INVALID_TIME, Warning, fix Safe;
    summary: "a time of day is not written `hh:mm:ss`",
    checks: "Times must have two digits each for hour, minute and second, with or without a fraction and a time zone. Other spellings, such as `9:45` and `09:45AM`, are read and are only a note.",
    why: "Tools reject the file or ignore the time. An EDS uses `09:45AM`.",
    example: r#"`fileCreationTime="9:45"`"#,
    remedy: "Write `09:45:00`.",

    "cia311/invalid-word" = INVALID_WORD, Error;
    summary: "a keyword is not defined in the standard",
    checks: "Access types, PDO mappings, LED states and all other keywords must be defined in the standard, in the same case.",
    why: "Tools reject the file or use their default.",
    example: r#"`accessType="rwr"`, which belongs into the parameter as `access="readWriteInput"`"#,
    remedy: "Write one of the keywords of the standard.",

    "cia311/invalid-baud-rate" = INVALID_BAUD_RATE, Error;
    summary: "a bit rate is not defined in the standard",
    checks: "`supportedBaudRate` and the default must be `10 Kbps`, `20 Kbps`, `50 Kbps`, `100 Kbps`, `125 Kbps`, `250 Kbps`, `500 Kbps`, `800 Kbps`, `1000 Kbps` or `auto-baudRate`.",
    why: "Tools reject the file or do not offer the bit rate.",
    example: r#"`<supportedBaudRate value="125"/>`"#,
    remedy: "Write `125 Kbps`.",

    "cia311/invalid-dummy" = INVALID_DUMMY, Error;
    summary: "a dummy entry is not of the form `Dummy0001=0`",
    checks: "`entry` of `dummy` must be `Dummy0001` to `Dummy0007` with `=0` or `=1`.",
    why: "The standard defines no others: tools reject the file or ignore the dummy entry.",
    example: r#"`<dummy entry="0005=1"/>`"#,
    remedy: "Write `Dummy0005=1`.",

    "cia311/invalid-id" = INVALID_ID, Warning;
    summary: "an id is not a valid XML name",
    checks: "An id must start with a letter or `_` and contain only letters, digits, `.`, `-` and `_`.",
    why: "Schema validation rejects the file; other tools do not resolve references to the id.",
    example: r#"`uniqueID="1000-1"`"#,
    remedy: "Write a name such as `UID_1000-1` and update its references.",
    source: "CiA 311 annex A, XML Schema (NCName)",

    "cia311/invalid-language" = INVALID_LANGUAGE, Warning;
    summary: "a language is not written as `en` or `en-us`",
    checks: "`lang` and `supportedLanguages` must be language codes of up to eight letters, with further parts after a hyphen.",
    why: "Tools reject the file or never show the text.",
    example: r#"`lang="en_US"`"#,
    remedy: "Write `en-us`.",
    source: "CiA 311 annex A, XML Schema (language)",
}

/// Reports `text`, the value of `name` at `at`, unless it is valid for its kind.
pub(super) fn check(text: &str, kind: TextKind, at: Span, name: &str, findings: &mut Findings) -> bool {
    let trimmed = text.trim_ascii();
    let is_valid = match kind {
        TextKind::Reference(_) => true,
        TextKind::Decimal => decimal(trimmed).is_some_and(|number| number != 0.0 || name != "multiplier"),
        kind => kind.accepts(trimmed),
    };
    if !is_valid {
        findings.push(finding(trimmed, kind, at, name));
    }
    is_valid
}

fn finding(text: &str, kind: TextKind, at: Span, name: &str) -> Diagnostic {
    let shown = if text.is_empty() { say!("an empty string") } else { say!("`{}`", text) };
    let new = |rule, what: &str| Diagnostic::new(rule, at, say!("{} is {!}", shown, what));
    match kind {
        TextKind::Number(low, high) => invalid_number(text, &shown, name, (low, high), at),
        TextKind::Decimal if decimal(text).is_some() => {
            new(&INVALID_SCALING, "not a valid multiplier: all values become 0")
                .help("write the factor, 1 for no scaling")
        }
        TextKind::Decimal => new(&INVALID_SCALING, &format!("not a number, as `{name}` requires"))
            .help("write a number with a decimal point"),
        TextKind::Boolean => {
            new(&INVALID_BOOLEAN, &format!("not a valid `{name}`: `true` or `false` is expected"))
                .help("write `true` or `false` in lower case")
        }
        TextKind::Hex(least, most) => {
            let digits = if least == most {
                format!("{least} hexadecimal digits")
            } else {
                format!("{least} to {most} hexadecimal digits in pairs")
            };
            let is_longer = text.len() > most && text.bytes().all(|byte| byte.is_ascii_hexdigit());
            let finding = match is_longer {
                true => Diagnostic::new(
                    &INVALID_HEX,
                    at,
                    say!(
                        "`{!}` is written with {!} digits ({}), not with {!}",
                        name,
                        text.len(),
                        shown,
                        most
                    ),
                ),
                false => new(&INVALID_HEX, &format!("not a valid `{name}`: {digits} are expected")),
            };
            let spelled = hex_digits(text, least);
            let finding = finding.help(match &spelled {
                Some(digits) => say!("write `{}`", digits.clone()),
                None => say!("write only pairs of hexadecimal digits"),
            });
            match spelled {
                _ if fact::hex(text, most).is_none() => finding,
                Some(digits) => respelled(finding, Some((digits, true)), at).understood(),
                None => finding.understood(),
            }
        }
        TextKind::Date => {
            let finding = new(&INVALID_DATE, "not a date of the form `yyyy-mm-dd`")
                .help("write year, month and day with four, two and two digits: `2026-01-31`");
            let read = literal::date(text).map(|(date, is_clear)| (date.to_iso(), is_clear));
            respelled(finding, read, at)
        }
        TextKind::Time => {
            let finding = new(&INVALID_TIME, "not a time of the form `hh:mm:ss`")
                .help("write hour (00 to 23), minute and second with two digits each: `09:45:00`");
            respelled(finding, literal::clock_time(text).map(|time| (time.to_iso(true), true)), at)
        }
        TextKind::Word(words) | TextKind::Words(words) => {
            new(&INVALID_WORD, &format!("not a valid `{name}`")).help(word_help(text, words))
        }
        TextKind::BaudRate => new(&INVALID_BAUD_RATE, "not a bit rate of CiA 311").help(rate_help(text)),
        TextKind::Dummy => new(&INVALID_DUMMY, "not of the form `Dummy0001=0`")
            .help("write the data type from 0001 to 0007 and 0 or 1, such as `Dummy0005=1`"),
        TextKind::Language | TextKind::Languages => {
            new(&INVALID_LANGUAGE, "not a language code").help(language_help(text))
        }
        TextKind::Id
        | TextKind::Name
        | TextKind::Names
        | TextKind::Text
        | TextKind::Rate
        | TextKind::Reference(_) => new(&INVALID_ID, &format!("not a valid `{name}`"))
            .help("start with a letter or `_`, and use letters, digits, `.`, `-` and `_`"),
    }
}

/// A finding about a string that is nevertheless read, with the standard notation, and whether that is
/// certain.
fn respelled(finding: Diagnostic, read: Option<(String, bool)>, at: Span) -> Diagnostic {
    let Some((text, is_certain)) = read else { return finding };
    let fix = if is_certain { Fix::safe } else { Fix::risky };
    finding.fix(fix(say!("write `{}`", text)).replace(at, text))
}

fn invalid_number(text: &str, shown: &Text, name: &str, (low, high): (i128, i128), at: Span) -> Diagnostic {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"));
    let hex = digits.and_then(|digits| i128::from_str_radix(digits, 16).ok());
    let (message, help) = match (whole_number(text), hex) {
        (Some(_), _) if high == i128::MAX => (
            say!("{} is out of range for `{!}`: at least {!}", shown, name, low),
            say!("write a number in this range"),
        ),
        (Some(_), _) => (
            say!("{} is out of range for `{!}`: {!} to {!}", shown, name, low, high),
            say!("write a number in this range"),
        ),
        (None, Some(hex)) => {
            (say!("{} is hexadecimal, but `{!}` is decimal", shown, name), say!("write `{}`", hex))
        }
        (None, None) => {
            (say!("{} is not a decimal number, as `{!}` requires", shown, name), say!("write decimal digits"))
        }
    };
    Diagnostic::new(&INVALID_NUMBER, at, message).help(help)
}

/// The intended hex digits, padded with zeros; `None` if they are ambiguous.
fn hex_digits(text: &str, least: usize) -> Option<String> {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).unwrap_or(text);
    let digits = digits.strip_suffix(['h', 'H']).unwrap_or(digits);
    let padded = u32::from_str_radix(digits, 16).ok().map(|number| format!("{number:0least$X}"))?;
    (padded.len() == least).then_some(padded)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_intended_text_is_named() {
        assert_eq!(language_help("en_US"), "write `en-us`");
        assert_eq!(rate_help("125"), "write `125 Kbps`");
        assert_eq!(rate_help("1000000"), "write `1000 Kbps`");
        assert_eq!(hex_digits("0x1000", 4).as_deref(), Some("1000"));
        assert_eq!(hex_digits("1", 2).as_deref(), Some("01"));
        assert_eq!(hex_digits("0001", 2).as_deref(), Some("01"));
    }
}
