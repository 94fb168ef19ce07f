//! Bytes as hex digits.

use std::fmt::Write;

/// Two upper-case hex digits a byte.
pub fn print(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(2 * bytes.len());
    for byte in bytes {
        let _ = write!(text, "{byte:02X}"); // a String takes every text
    }
    text
}

/// The bytes of a text of hex digits, two a byte.
pub fn parse(text: &str) -> Option<Box<[u8]>> {
    let digit = |byte: u8| char::from(byte).to_digit(16);
    let pairs = text.as_bytes().chunks(2);
    pairs.map(|pair| u8::try_from(digit(pair[0])? << 4 | digit(*pair.get(1)?)?).ok()).collect()
}
