//! CSV (RFC 4180) for spreadsheets.

use std::borrow::Cow;

use super::shown;
use crate::diagnostic::printable;

/// Escapes a field: quoted if necessary, on one line, and never a formula.
///
/// Spreadsheets evaluate fields that begin with `=`, `+`, `-` or `@`, even in quotes, so such a field gets an
/// apostrophe as prefix, which marks text. Numbers are unchanged. A spreadsheet with `;` as separator sees a
/// new field after each one, so the same applies there.
pub fn field(text: &str) -> Cow<'_, str> {
    if text.bytes().all(|byte| byte.is_ascii_alphanumeric() || b" _./()".contains(&byte)) {
        return Cow::Borrowed(text); // fast path for most names and all indexes
    }
    let line = one_line(text);
    let mut field = String::with_capacity(line.len() + 3);
    for (number, part) in line.split(';').enumerate() {
        field.push_str(if number > 0 { ";" } else { "" });
        let computed = part.trim_start().starts_with(['=', '+', '-', '@']) && !is_number(part);
        field.push_str(if computed { "'" } else { "" });
        field.push_str(part);
    }
    let quoted = field.contains([',', ';', '"']) || field.starts_with(' ') || field.ends_with(' ');
    Cow::Owned(if quoted { format!("\"{}\"", field.replace('"', "\"\"")) } else { field })
}

/// Replaces line ends and tabs by spaces, and invisible characters by U+FFFD.
fn one_line(text: &str) -> String {
    let mut characters = text.chars().peekable();
    let mut line = String::with_capacity(text.len());
    while let Some(character) = characters.next() {
        line.extend(shown(character, characters.peek().copied()).map(|shown| match shown {
            '\n' | '\t' => ' ',
            other => other,
        }));
    }
    printable(&line).into_owned()
}

/// Whether a text is a signed decimal number, which spreadsheets do not evaluate as a formula.
fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    digits.starts_with(|first: char| first.is_ascii_digit())
        && digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.')
        && digits.bytes().filter(|byte| *byte == b'.').count() <= 1
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn fields_are_quoted_and_are_no_formulas() {
        for (text, written) in [
            ("Device type", "Device type"),
            ("0x6000", "0x6000"),
            ("-5", "-5"),
            ("-5.25", "-5.25"),
            ("=cmd()|' /C calc'!A0", "'=cmd()|' /C calc'!A0"),
            ("-Torque", "'-Torque"),
            ("-1+1", "'-1+1"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("\t=1", "' =1"),
            ("a,b", "\"a,b\""),
            ("say \"x\"", "\"say \"\"x\"\"\""),
            ("a\r\nb\0", "a b\u{FFFD}"),
            ("a;=1;-1", "\"a;'=1;-1\""),
            ("$NODEID+0x180", "$NODEID+0x180"),
            ("", ""),
        ] {
            assert_eq!(field(text), written);
        }
    }

    /// Parses a line as defined in RFC 4180.
    fn read(line: &str) -> Vec<String> {
        let (mut fields, mut quoted) = (vec![String::new()], false);
        let mut characters = line.chars().peekable();
        while let Some(character) = characters.next() {
            match character {
                '"' if quoted && characters.peek() == Some(&'"') => {
                    fields.last_mut().unwrap().extend(characters.next());
                }
                '"' => quoted = !quoted,
                ',' if !quoted => fields.push(String::new()),
                _ => fields.last_mut().unwrap().push(character),
            }
        }
        fields
    }

    proptest! {
        #[test]
        fn fields_come_back(texts in prop::collection::vec("(?s)(.|[,;\"'=+@\n\r-]){0,12}", 1..5)) {
            let line = texts.iter().map(|text| field(text)).collect::<Vec<_>>().join(",");
            prop_assert!(!line.contains(['\n', '\r', '\0', '\t']));
            let fields = read(&line);
            prop_assert_eq!(fields.len(), texts.len());
            for (field, text) in fields.iter().zip(&texts) {
                // ignores apostrophes added before formulas
                prop_assert_eq!(field.replace('\'', ""), one_line(text).replace('\'', ""));
                prop_assert!(is_number(field) || !field.trim_start().starts_with(['=', '+', '-', '@']));
            }
        }
    }
}
