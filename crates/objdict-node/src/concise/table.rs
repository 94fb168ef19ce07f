//! A concise DCF as a table.

use std::fmt::Write;

use crate::download::ConciseDcf;

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
