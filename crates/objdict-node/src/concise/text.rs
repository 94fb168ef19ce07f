//! The text format of a concise DCF for review and version control: one line per download. Parsing it gives
//! the same bytes.
//!
//! ```text
//! 1800:01  UNSIGNED32  0x80000185  # TPDO communication parameter / COB-ID: not valid
//! 1800:02  UNSIGNED8   254
//! 2001:00  VISIBLE_STRING  "pump 3"
//! 2002:00  BYTES  00 11 22
//! ```

use std::fmt::{self, Write};

use crate::diagnostic::one_line;
use crate::download::{ConciseDcf, Download};
use crate::literal::{self, Spelling};
use crate::model::{Address, DataType, TypeKind, Value, hex};

/// Type keyword for bytes of unknown type or bytes that are not valid for their type.
const BYTES: &str = "BYTES";

/// Bytes per line; further bytes continue in indented lines.
const PER_LINE: usize = 32;

/// Column width of the data type; longer names push the value to the right.
const TYPE_WIDTH: usize = 11;

/// Column of the comments, unless the value is longer.
const COMMENT_COLUMN: usize = 40;

/// Type and comment of a download.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Annotation {
    /// The data type used to print the bytes; `None` prints raw bytes.
    pub data_type: Option<DataType>,
    /// The comment: name of the entry, meaning of the value.
    pub comment: String,
}

/// A line that is not a valid download.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TextError {
    /// The line, counted from 1.
    pub line: usize,
    /// Description of the error.
    pub message: String,
    /// How to fix it.
    pub help: &'static str,
}

objdict_model::error_messages! { TextError: { Self { line, message, .. } => "line {line}: {message}"; } }

/// The lines of a text that are not valid downloads.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TextErrors {
    /// The first 1000 errors, ordered by line; at least one.
    pub first: Vec<TextError>,
    /// The number of further errors.
    pub more: usize,
}

/// A text in a different format has as many errors as lines.
const MAX_ERRORS: usize = 1000;

impl std::error::Error for TextErrors {}

/// One error per line, each followed by its help.
impl fmt::Display for TextErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, error) in self.first.iter().enumerate() {
            let separator = if number > 0 { "\n" } else { "" };
            write!(f, "{separator}{error}; {}", error.help)?;
        }
        match self.more {
            0 => Ok(()),
            more => write!(f, "\n{more} more lines are not valid"),
        }
    }
}

/// Prints a configuration; `annotate` supplies type and comment of each download.
pub fn print(configuration: &ConciseDcf, annotate: impl Fn(&Download) -> Annotation) -> String {
    let mut text = String::new();
    for download in &configuration.0 {
        let Annotation { data_type, comment } = annotate(download);
        let (word, value) = spelled(download, data_type);
        let start = format!("{:04X}:{:02X}  {word:TYPE_WIDTH$} ", download.index, download.sub);
        // writing to a String cannot fail
        let _ = write!(text, "{start}{value}");
        let comment = one_line(&comment);
        if !comment.trim().is_empty() {
            let used = start.len() + value.rsplit('\n').next().map_or(0, |line| line.chars().count());
            let gap = COMMENT_COLUMN.saturating_sub(used).max(2);
            let _ = write!(text, "{:gap$}# {}", "", comment.trim());
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

/// The type keyword and the value; parsing them gives the same bytes.
pub fn spelled(download: &Download, data_type: Option<DataType>) -> (&'static str, String) {
    let typed = data_type.and_then(|data_type| {
        let word = data_type.name()?;
        let text = value_text(download, data_type)?;
        (bytes_of(&text, data_type, None).as_deref() == Ok(&download.data)).then_some((word, text))
    });
    typed.unwrap_or_else(|| (BYTES, byte_lines(&download.data)))
}

fn value_text(download: &Download, data_type: DataType) -> Option<String> {
    let value = Value::from_bytes(&download.data, data_type)?;
    let is_communication = download.index < 0x2000 && !matches!(download.index, 0x1006 | 0x1007);
    Some(match &value {
        Value::Text(text) => quoted(text)?,
        Value::Bytes(bytes) => byte_lines(bytes),
        value => literal::print(
            value,
            Spelling { hex: is_communication && data_type == DataType::UNSIGNED32, ..Spelling::default() },
        ),
    })
}

/// Quotes a string; `None` if it cannot be written on one line, or cannot be printed.
fn quoted(text: &str) -> Option<String> {
    if one_line(text) != text {
        return None;
    }
    Some(format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"")))
}

fn byte_lines(bytes: &[u8]) -> String {
    let line = |chunk: &[u8]| chunk.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ");
    bytes.chunks(PER_LINE).map(line).collect::<Vec<_>>().join("\n         ")
}

/// Parses the text format. Formulas such as `$NODEID+0x180` are evaluated for `node_id`.
///
/// # Errors
/// Lists the lines that are not valid downloads.
pub fn parse(text: &str, node_id: Option<u8>) -> Result<ConciseDcf, TextErrors> {
    let mut downloads = Vec::new();
    let mut errors = TextErrors { first: Vec::new(), more: 0 };
    for (line, statement) in statements(text) {
        match download(&statement, node_id) {
            Ok(download) => downloads.push(download),
            Err((message, help)) if errors.first.len() < MAX_ERRORS => {
                errors.first.push(TextError { line, message, help });
            }
            Err(_) => errors.more += 1,
        }
    }
    if errors.first.is_empty() { Ok(ConciseDcf(downloads)) } else { Err(errors) }
}

/// Whether a text looks like this format; used for format detection.
pub fn looks_like(text: &str) -> bool {
    statements(text).next().is_some_and(|(_, statement)| {
        let mut words = statement.split_whitespace();
        let at = words.next().is_some_and(|word| word.contains(':') && word.parse::<Address>().is_ok());
        at && words.next().is_some_and(|word| word == BYTES || DataType::from_name(word).is_some())
    })
}

/// The statements of a text without comments, each with its line number. Indented continuation lines are
/// joined.
fn statements(text: &str) -> impl Iterator<Item = (usize, String)> {
    let mut lines = text.lines().map(without_comment).enumerate().peekable();
    std::iter::from_fn(move || {
        let (number, line) = lines.find(|(_, line)| !line.trim().is_empty())?;
        let mut statement = line.trim().to_owned();
        while let Some((_, more)) =
            lines.next_if(|(_, line)| line.starts_with([' ', '\t']) && !line.trim().is_empty())
        {
            statement.push(' ');
            statement.push_str(more.trim());
        }
        Some((number + 1, statement))
    })
}

/// The line up to the first `#` outside quotes that follows whitespace, so that `16#3` is not shortened to
/// 16.
fn without_comment(line: &str) -> &str {
    let (mut is_quoted, mut is_escaped) = (false, false);
    for (at, c) in line.char_indices() {
        match c {
            '#' if !is_quoted && (at == 0 || line[..at].ends_with([' ', '\t'])) => return &line[..at],
            '"' if !is_escaped => is_quoted = !is_quoted,
            _ => {}
        }
        is_escaped = is_quoted && c == '\\' && !is_escaped;
    }
    line
}

type WrongText = (String, &'static str);

fn download(statement: &str, node_id: Option<u8>) -> Result<Download, WrongText> {
    let (at, rest) = word(statement);
    let address: Option<Address> = at.parse().ok();
    let Some(Address { index, sub: Some(sub) }) = address else {
        return Err((format!("`{at}` is not an entry"), "write index and sub-index in hex, as in `1800:01`"));
    };
    let (type_, value) = word(rest);
    if type_.is_empty() {
        return Err(("the data type and the value are missing".to_owned(), "write `1017:00 UNSIGNED16 250`"));
    }
    if type_.eq_ignore_ascii_case(BYTES) {
        return Ok(Download::new(index, sub, hex(value)?));
    }
    let known = DataType::from_name(&type_.to_ascii_uppercase());
    let Some(data_type) = known.filter(|data_type| DataType::STATIC.contains(data_type)) else {
        let help = "write a data type of CiA 301 such as `UNSIGNED16`, or `BYTES`";
        return Err((format!("`{type_}` is not a data type"), help));
    };
    bytes_of(value, data_type, node_id).map(|bytes| Download::new(index, sub, bytes))
}

/// Splits off the first word.
fn word(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    let (word, rest) = text.split_at(text.find(char::is_whitespace).unwrap_or(text.len()));
    (word, rest.trim())
}

/// Encodes a value given as text.
fn bytes_of(text: &str, data_type: DataType, node_id: Option<u8>) -> Result<Vec<u8>, WrongText> {
    let value = match data_type.kind() {
        TypeKind::VisibleString | TypeKind::UnicodeString => Value::Text(unquoted(text)?.into()),
        TypeKind::OctetString | TypeKind::Domain => return hex(text),
        _ => number(text, data_type)?,
    };
    let resolved = match (&value, node_id) {
        (Value::NodeId(_), None) => {
            return Err((format!("`{text}` needs the node-ID"), "state it with `--node-id`"));
        }
        (Value::NodeId(_), Some(node_id)) => value.resolve(data_type, node_id),
        _ => Some(value),
    };
    resolved.and_then(|value| value.to_bytes(data_type)).ok_or_else(|| no_value(text, data_type))
}

const WRITE_NUMBER: &str = "write a number of the type, or the type `BYTES` and hex digits";

fn no_value(text: &str, data_type: DataType) -> WrongText {
    (format!("`{text}` is not a valid {data_type}"), WRITE_NUMBER)
}

fn number(text: &str, data_type: DataType) -> Result<Value, WrongText> {
    if text.is_empty() {
        return Err((format!("the value of type {data_type} is missing"), "write `1017:00 UNSIGNED16 250`"));
    }
    literal::written(text, data_type).map_err(|wrong| (wrong.message, wrong.help.unwrap_or(WRITE_NUMBER)))
}

/// Removes the quotes of a string.
fn unquoted(text: &str) -> Result<String, WrongText> {
    let wrong = |what: &str| {
        Err((format!("`{text}` {what}"), "write the string in double quotes, with `\\\"` for a quote in it"))
    };
    let Some(inner) = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')) else {
        return wrong("is not in double quotes");
    };
    let mut unquoted = String::with_capacity(inner.len());
    let mut chars = inner.chars();
    while let Some(c) = chars.next() {
        match c {
            '"' => return wrong("contains a quote"),
            '\\' => match chars.next() {
                Some(escaped @ ('"' | '\\')) => unquoted.push(escaped),
                _ => return wrong("contains a `\\` that does not precede `\\` or `\"`"),
            },
            c => unquoted.push(c),
        }
    }
    Ok(unquoted)
}

/// Parses pairs of hex digits, with or without spaces between them.
fn hex(text: &str) -> Result<Vec<u8>, WrongText> {
    let digits: String = text.split_whitespace().collect();
    match hex::parse(&digits) {
        Some(bytes) => Ok(bytes.into()),
        None => Err((
            format!("`{text}` is not a sequence of hexadecimal bytes"),
            "write two hexadecimal digits per byte, as in `00 1F`",
        )),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn of(data_type: DataType) -> impl Fn(&Download) -> Annotation {
        move |_| Annotation { data_type: Some(data_type), comment: String::new() }
    }

    #[test]
    fn every_type_is_spelled_and_read_back() {
        for (data_type, data, text) in [
            (DataType::BOOLEAN, &[1][..], "1"),
            (DataType::BOOLEAN, &[2], "BYTES 02"),
            (DataType::INTEGER16, &[0xFE, 0xFF], "-2"),
            (DataType::UNSIGNED24, &[0x56, 0x34, 0x12], "1193046"),
            (DataType::UNSIGNED24, &[0x56, 0x34, 0x12, 0], "BYTES 56 34 12 00"),
            (DataType::REAL32, &[0, 0, 0xC0, 0x3F], "1.5"),
            (DataType::REAL32, &[1, 0, 0xC0, 0x7F], "0x7FC00001"),
            (DataType::VISIBLE_STRING, b"a \"b\" \\ # c", "\"a \\\"b\\\" \\\\ # c\""),
            (DataType::VISIBLE_STRING, b"", "\"\""),
            (DataType::VISIBLE_STRING, b"a\nb", "BYTES 61 0A 62"),
            (DataType::UNICODE_STRING, &[0xE4, 0], "\"ä\""),
            (DataType::UNICODE_STRING, &[0xE4], "BYTES E4"),
            (DataType::OCTET_STRING, &[], ""),
            (DataType::TIME_OF_DAY, &[1, 0, 0, 0, 2, 0], "2 1"),
        ] {
            let configuration = ConciseDcf(vec![Download::new(0x2000, 1, data)]);
            let printed = print(&configuration, of(data_type));
            let words: Vec<&str> = printed.split_whitespace().skip(1).collect();
            let name = data_type.name().unwrap();
            let expected = if text.starts_with(BYTES) { text.to_owned() } else { format!("{name} {text}") };
            assert_eq!(words.join(" "), expected.trim());
            assert_eq!(parse(&printed, None), Ok(configuration), "{printed}");
        }
    }

    #[test]
    fn all_wrong_lines_are_reported() {
        let text = "# a comment\n1017 UNSIGNED16 1\n1017:00 UNSIGNED9 1\n1017:00 UNSIGNED16 65536\n\n1017:00\n1400:01 UNSIGNED32 $NODEID+0x200\n\
                    2000:00 VISIBLE_STRING a\n2000:00 BYTES 0\n2000:00 UNSIGNED8 010\n";
        let errors = parse(text, None).unwrap_err();
        let told: Vec<String> = errors.first.iter().map(ToString::to_string).collect();
        insta::assert_snapshot!(told.join("\n"), @r#"
        line 2: `1017` is not an entry
        line 3: `UNSIGNED9` is not a data type
        line 4: `65536` is not a valid UNSIGNED16
        line 6: the data type and the value are missing
        line 7: `$NODEID+0x200` needs the node-ID
        line 8: `a` is not in double quotes
        line 9: `0` is not a sequence of hexadecimal bytes
        line 10: `010` is octal by CiA 306, but some tools read it as decimal
        "#);
        let formula = parse("1400:01 unsigned32 $NODEID+0x200", Some(5)).unwrap();
        assert_eq!(formula.0[0].data, [5, 2, 0, 0]);
    }

    #[test]
    fn long_data_go_on_in_further_lines() {
        let configuration =
            ConciseDcf(vec![Download::new(0x2000, 0, [7; 70]), Download::new(0x2001, 0, [1])]);
        let printed = print(&configuration, |_| Annotation { data_type: None, comment: "a\nb".into() });
        assert_eq!(printed.lines().count(), 4);
        assert_eq!(parse(&printed, None), Ok(configuration));
        assert!(looks_like(&printed) && !looks_like("[1000]\nParameterName=x") && !looks_like(""));
    }

    proptest! {
        #[test]
        fn what_is_printed_is_read_back(
            downloads in prop::collection::vec((any::<u16>(), any::<u8>(), prop::collection::vec(any::<u8>(), 0..80)), 0..8),
            number in 0usize..DataType::STATIC.len(),
            comment in ".*",
        ) {
            let downloads = downloads.into_iter().map(|(index, sub, data)| Download::new(index, sub, data));
            let configuration = ConciseDcf(downloads.collect());
            let annotate = |_: &Download| Annotation { data_type: Some(DataType::STATIC[number]), comment: comment.clone() };
            prop_assert_eq!(parse(&print(&configuration, annotate), None), Ok(configuration));
        }

        #[test]
        fn any_text_is_read_or_refused(text in "[0-9A-F:. \\n\"#\\\\a-z]*") {
            let _ = parse(&text, Some(5));
        }
    }
}
