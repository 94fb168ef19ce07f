//! Output formats of a stream: binary, hex, C, Rust, or a table.

use std::fmt::Write;

use crate::download::ConciseDcf;
use crate::model::hex;

/// Bytes per line.
const PER_LINE: usize = 16;

/// The output format of a stream.
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
    /// Returns the stream in this format. C and Rust derive an identifier from `name`.
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

/// Data bytes shown per line.
const SHOWN: usize = 16;

/// Formats the configuration as a table for reading: one line per download, with its offset in the stream,
/// its bytes and their likely meaning as a number or text.
pub fn table(configuration: &ConciseDcf) -> String {
    let mut text = format!("{} downloads\n", configuration.0.len());
    if !configuration.0.is_empty() {
        text.push_str("offset  entry    size  data\n");
    }
    for (offset, download) in configuration.with_offsets() {
        let size = download.data.len();
        // writing to a String cannot fail
        let _ = write!(text, "{offset:6}  {:04X}:{:02X}  {size:4}  ", download.index, download.sub);
        text.push_str(&data(&download.data));
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

/// The bytes in hex, followed by their likely meaning.
fn data(data: &[u8]) -> String {
    let shown = &data[..data.len().min(SHOWN)];
    let mut text: Vec<String> = shown.iter().map(|byte| format!("{byte:02X}")).collect();
    if shown.len() < data.len() {
        text.push("…".to_owned());
    }
    if let Some(meaning) = meaning(data) {
        text.push(format!(" {meaning}"));
    }
    text.join(" ")
}

/// Reads up to eight bytes as a number and longer data as text, if printable.
fn meaning(data: &[u8]) -> Option<String> {
    let printable = data.iter().all(|byte| (0x20..0x7F).contains(byte));
    match data.len() {
        0 => None,
        1..=8 => {
            let number = data.iter().rev().fold(0u64, |number, &byte| number << 8 | u64::from(byte));
            Some(format!("0x{number:0width$X} = {number}", width = 2 * data.len()))
        }
        _ if printable => {
            let text: String = data.iter().take(4 * SHOWN).map(|&byte| char::from(byte)).collect();
            Some(format!("{text:?}"))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::download::Download;

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

    #[test]
    fn the_table_shows_what_is_written_where() {
        let configuration = ConciseDcf(vec![
            Download::new(0x1017, 0, [0xFA, 0]),
            Download::new(0x2001, 0x1F, *b"a text of 18 bytes"),
            Download::new(0x2002, 0, [0; 17]),
            Download::new(0x2003, 0, []),
        ]);
        insta::assert_snapshot!(table(&configuration), @r#"
        4 downloads
        offset  entry    size  data
             4  1017:00     2  FA 00  0x00FA = 250
            13  2001:1F    18  61 20 74 65 78 74 20 6F 66 20 31 38 20 62 79 74 …  "a text of 18 bytes"
            38  2002:00    17  00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 …
            62  2003:00     0
        "#);
        assert_eq!(table(&ConciseDcf::default()), "0 downloads\n");
    }
}
