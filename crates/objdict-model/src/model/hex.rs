//! Bytes as hex digits.

use std::fmt::Write;

/// Prints two upper-case hex digits per byte.
pub fn print(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(2 * bytes.len());
    for byte in bytes {
        let _ = write!(text, "{byte:02X}"); // writing to a String never fails
    }
    text
}

/// Parses hex digits, two per byte.
pub fn parse(text: &str) -> Option<Box<[u8]>> {
    let digit = |byte: u8| char::from(byte).to_digit(16);
    let pairs = text.as_bytes().chunks(2);
    pairs.map(|pair| u8::try_from(digit(pair[0])? << 4 | digit(*pair.get(1)?)?).ok()).collect()
}
