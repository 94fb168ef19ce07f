//! Escapes description texts for their position in generated code.
//!
//! The functions are the filters of the templates, which thus show how each text is escaped. All
//! characters except letters, digits and printable ASCII become `\u{…}`: line ends and other control
//! characters, direction marks, invisible and unassigned characters.

use std::borrow::Cow;
use std::fmt::{self, Write};

/// Maximum length of a displayed text; longer ones end in `...`.
const SHOWN: usize = 100;

/// Longer strings are written as bytes, because C99 compilers need not support longer literals (§5.2.4.1).
const LONGEST_LITERAL: usize = 500;

/// For a line of a Rust comment (`//` or `///`): in backticks, so that rustdoc does not interpret markup.
pub(super) fn code_span(text: &str) -> String {
    let plain = printable(text);
    match plain.trim() {
        "" => "(no name)".to_owned(),
        plain => ["`", &*plain.replace('`', "'"), "`"].concat(),
    }
}

/// For the text of a C comment: no `*/`, no `/*`, no trigraph.
pub(super) fn c_comment(text: &str) -> String {
    let plain = printable(text);
    let plain = plain.trim();
    let mut comment = String::with_capacity(plain.len());
    if plain.bytes().any(|byte| matches!(byte, b'*' | b'?')) {
        let mut last = ' ';
        for c in plain.chars() {
            if matches!((last, c), ('*', '/') | ('/', '*') | ('?', '?')) {
                comment.push(' ');
            }
            comment.push(c);
            last = c;
        }
    } else {
        comment.push_str(plain);
    }
    // the template may append `*/`, and a backslash at the end of a line would join it with the next
    comment.truncate(comment.trim_end_matches(['\\', '/', '*', ' ']).len());
    if comment.is_empty() { "(no name)".to_owned() } else { comment }
}

/// For the text of a Doxygen comment: commands, tags, entities and links are escaped.
pub(super) fn doxygen(text: &str) -> String {
    let comment = c_comment(text);
    let is_special = |c| matches!(c, '\\' | '@' | '<' | '>' | '&' | '#' | '%' | '$' | '"');
    if !comment.bytes().any(|byte| byte == b':' || is_special(byte.into())) {
        return comment;
    }
    let mut escaped = String::with_capacity(comment.len() + 8);
    for (at, c) in comment.char_indices() {
        let is_scope = comment[at..].starts_with("::") && !escaped.ends_with(':');
        if is_scope || is_special(c) {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

/// A string literal of C in UTF-8.
pub(super) fn c_text(text: &str) -> String {
    literal(printable(text).trim().as_bytes()).unwrap_or_else(|| "\"\"".to_owned()) // never that long
}

/// The content of a [`c_text`].
pub(super) fn shown(text: &str) -> String {
    printable(text).trim().to_owned()
}

/// A string literal of Rust.
pub(super) fn rust_text(text: &str) -> String {
    let plain = printable(text);
    match plain.trim() {
        plain if plain.contains(['\\', '"']) => {
            format!("\"{}\"", plain.replace('\\', "\\\\").replace('"', "\\\""))
        }
        plain => ["\"", plain, "\""].concat(),
    }
}

/// The text on one line, without unsafe characters.
fn printable(text: &str) -> Cow<'_, str> {
    let is_plain = |byte: u8| byte == b' ' || byte.is_ascii_graphic();
    if text.len() <= SHOWN && text.bytes().all(is_plain) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::new();
    for (number, c) in text.chars().enumerate() {
        if number == SHOWN {
            shown.push_str("...");
            break;
        }
        if c == ' ' || c.is_ascii_graphic() || c.is_alphanumeric() {
            shown.push(c);
        } else {
            let _ = write!(shown, "\\u{{{:04X}}}", u32::from(c)); // writing to a String cannot fail
        }
    }
    Cow::Owned(shown)
}

/// A basic string of TOML, with its quotes.
pub(super) fn toml_string(text: &str) -> String {
    let mut literal = String::with_capacity(text.len() + 2);
    literal.push('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => literal.extend(['\\', c]),
            ' ' => literal.push(c),
            c if c.is_ascii_graphic() || c.is_alphanumeric() => literal.push(c),
            c => {
                let _ = write!(literal, "\\U{:08X}", u32::from(c)); // writing to a String cannot fail
            }
        }
    }
    literal.push('"');
    literal
}

/// The content of a Rust byte string.
pub(super) fn byte_string(bytes: &[u8]) -> String {
    bytes.iter().fold(String::with_capacity(bytes.len()), |mut text, &byte| {
        match byte {
            b'"' | b'\\' => text.extend(['\\', char::from(byte)]),
            b' '..=b'~' => text.push(char::from(byte)),
            _ => {
                let _ = write!(text, "\\x{byte:02X}"); // writing to a String cannot fail
            }
        }
        text
    })
}

/// The content of a C string literal: octal escapes, which always end after three digits, and no trigraphs.
pub(super) fn c_string(bytes: &[u8]) -> String {
    bytes.iter().fold(String::with_capacity(bytes.len()), |mut text, &byte| {
        match byte {
            b'"' | b'\\' | b'?' => text.extend(['\\', char::from(byte)]),
            b' '..=b'~' => text.push(char::from(byte)),
            _ => {
                let _ = write!(text, "\\{byte:03o}"); // writing to a String cannot fail
            }
        }
        text
    })
}

/// A string literal; `None` for strings that are too long or contain bytes unsuitable for a literal.
pub(crate) fn literal(bytes: &[u8]) -> Option<String> {
    if bytes.len() > LONGEST_LITERAL {
        return None;
    }
    Some(format!("\"{}\"", c_string(bytes)))
}

/// A number with this many hexadecimal digits.
pub(super) struct HexNumber<const DIGITS: usize>(u16);

impl<const DIGITS: usize> fmt::Display for HexNumber<DIGITS> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut digits = [0; DIGITS];
        for (place, digit) in digits.iter_mut().rev().enumerate() {
            *digit = b"0123456789ABCDEF"[usize::from(self.0 >> (4 * place) & 0xF)];
        }
        f.write_str(str::from_utf8(&digits).unwrap_or_default()) // ASCII
    }
}

/// `0x1017` without its prefix.
pub(super) fn hex4(index: &u16) -> HexNumber<4> {
    HexNumber(*index)
}

/// Formats a sub-index.
pub(super) fn hex2(sub: &u8) -> HexNumber<2> {
    HexNumber(u16::from(*sub))
}

/// The first letter in upper case, and the others in lower case.
pub(super) fn capitalize(word: &str) -> String {
    let mut letters = word.chars();
    let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
    first + &letters.as_str().to_lowercase()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn long_texts_are_no_literals() {
        assert_eq!(literal(b"a\"\\?\n7").as_deref(), Some("\"a\\\"\\\\\\?\\0127\""));
        assert_eq!(literal(&[b'x'; 501]), None);
    }

    #[test]
    fn hostile_texts_stay_in_their_line() {
        assert_eq!(code_span("a\nb\u{202E}c`d"), "`a\\u{000A}b\\u{202E}c'd`");
        assert_eq!(c_comment("a */ system(\"x\"); /* ??/ \\"), "a * / system(\"x\"); / * ? ?");
        assert_eq!(c_comment("a*//*/b"), "a* // * /b");
        assert_eq!(c_comment("/"), "(no name)");
        assert_eq!(doxygen("a@b \\c <d>::e *"), "a\\@b \\\\c \\<d\\>\\::e");
        assert_eq!(code_span("  "), "(no name)");
        assert_eq!(code_span("Größe 速度"), "`Größe 速度`");
        assert_eq!(code_span(&"x".repeat(10_000)).len(), SHOWN + 5);
        assert_eq!(c_string("\"\\\n1??é".as_bytes()), "\\\"\\\\\\0121\\?\\?\\303\\251");
        assert_eq!(toml_string("a\n\"\\\u{202E}é"), "\"a\\U0000000A\\\"\\\\\\U0000202Eé\"");
        assert_eq!(byte_string(b"\"\\\n\xFFa b"), "\\\"\\\\\\x0A\\xFFa b");
    }

    proptest! {
        #[test]
        fn no_text_leaves_its_comment(text in prop_oneof![any::<String>(), "[*/?\\\\` \n\r]{0,12}"]) {
            let (in_rust, in_c) = (code_span(&text), c_comment(&text));
            for comment in [&in_rust, &in_c] {
                prop_assert!(comment.chars().all(|c| c == ' ' || c.is_ascii_graphic() || c.is_alphanumeric()));
            }
            prop_assert!(in_rust == "(no name)" || in_rust.matches('`').count() == 2);
            let whole = format!("/* {in_c} */ ");
            prop_assert_eq!(whole.find("*/"), Some(whole.len() - 3));
            prop_assert!(!whole[2..].contains("/*") && !whole.contains("??") && !in_c.ends_with('\\'));
        }
    }
}
