//! Output forms of a stream: binary, hex, C or Rust.

use std::fmt::Write;

use crate::model::hex;

/// Bytes per line.
const PER_LINE: usize = 16;

/// The output form of a stream.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BlobSpelling {
    /// The raw bytes.
    #[default]
    Binary,
    /// Pairs of hex digits, 16 per line.
    Hex,
    /// `const uint8_t name[]`, C99.
    C,
    /// `const NAME: [u8; N]`.
    Rust,
}

impl BlobSpelling {
    /// Returns the stream in this form. C and Rust derive an identifier from `name`.
    pub fn spell(self, stream: &[u8], name: &str) -> Vec<u8> {
        match self {
            Self::Binary => stream.to_vec(),
            Self::Hex => lines(stream, |byte| format!("{byte:02X}"), " ", "").into_bytes(),
            Self::C => {
                let name = identifier(name);
                let bytes = lines(stream, |byte| format!("0x{byte:02X}"), ", ", "    ");
                let start = format!("#include <stdint.h>\n\nconst uint8_t {name}[{}] = {{\n", stream.len());
                format!("{start}{}}};\n", bytes.replace('\n', ",\n")).into_bytes()
            }
            Self::Rust => {
                let name = identifier(name).to_ascii_uppercase();
                let bytes = lines(stream, |byte| format!("0x{byte:02X}"), ", ", "    ");
                let start = format!("#[rustfmt::skip]\npub const {name}: [u8; {}] = [\n", stream.len());
                format!("{start}{}];\n", bytes.replace('\n', ",\n")).into_bytes()
            }
        }
    }
}

/// Parses hex digits separated by spaces and line ends; `None` for any other text.
pub fn of_hex(text: &str) -> Option<Vec<u8>> {
    let digits: String = text.split_whitespace().collect();
    if digits.is_empty() { None } else { hex::parse(&digits).map(Vec::from) }
}

fn lines(stream: &[u8], byte: impl Fn(u8) -> String, between: &str, before: &str) -> String {
    let mut text = String::with_capacity(stream.len() * 6);
    for chunk in stream.chunks(PER_LINE) {
        let line: Vec<String> = chunk.iter().map(|&number| byte(number)).collect();
        // writing to a String cannot fail
        let _ = writeln!(text, "{before}{}", line.join(between));
    }
    text
}

/// Converts a name to a lower-case identifier of C and Rust.
fn identifier(name: &str) -> String {
    let mut word = String::new();
    for c in name.chars() {
        match c {
            c if c.is_ascii_alphanumeric() => word.push(c.to_ascii_lowercase()),
            _ if !word.is_empty() && !word.ends_with('_') => word.push('_'),
            _ => {}
        }
    }
    let word = word.trim_end_matches('_');
    match word.chars().next() {
        Some(c) if c.is_ascii_alphabetic() => format!("{word}_dcf"),
        Some(_) => format!("dcf_{word}"),
        None => "concise_dcf".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(spelling: BlobSpelling, length: u8, name: &str) -> String {
        String::from_utf8(spelling.spell(&(0..length).collect::<Vec<_>>(), name)).unwrap()
    }

    #[test]
    fn hex_reads_back() {
        let hex = text(BlobSpelling::Hex, 18, "");
        assert_eq!(hex, "00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F\n10 11\n");
        assert_eq!(of_hex(&hex), Some((0..18).collect()));
        assert_eq!((of_hex(""), of_hex("0"), of_hex("0G")), (None, None, None));
    }

    #[test]
    fn identifiers_are_made_of_names() {
        insta::assert_snapshot!(text(BlobSpelling::C, 17, "Pump 3"), @r"
        #include <stdint.h>

        const uint8_t pump_3_dcf[17] = {
            0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0A, 0x0B, 0x0C, 0x0D, 0x0E, 0x0F,
            0x10,
        };
        ");
        insta::assert_snapshot!(text(BlobSpelling::Rust, 2, "3. Ventil"), @r"
        #[rustfmt::skip]
        pub const DCF_3_VENTIL: [u8; 2] = [
            0x00, 0x01,
        ];
        ");
        assert_eq!(
            ["", "ä", "_a_", "switch"].map(identifier),
            ["concise_dcf", "concise_dcf", "a_dcf", "switch_dcf"]
        );
    }
}
