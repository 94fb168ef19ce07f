//! Tables of answers, CSV or JSON: those of the script, and those that a bench dumps.
//!
//! A row has `index` and `sub`, and the answer in `bytes` (hex digits, as transferred), `value` (a number or text, or bytes with blanks
//! between them) or `abort` (the code). `action` is `read` if it is not there, `sent` has the bytes of a write. Other columns are skipped.

use std::collections::BTreeMap;

use super::exchange::{Exchange, SdoAnswer, SdoRequest};
use objdict_format::csv::records;

/// Why a table is not one of answers.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum AnswersError {
    /// Not JSON.
    Json {
        /// The line, from 1.
        line: usize,
        /// What the parser says.
        message: String,
    },
    /// The document is JSON, but no list of objects.
    NoList,
    /// A column is missing.
    MissingColumn(&'static str),
    /// A cell is not what its column needs.
    Cell {
        /// The row, from 1, without the headings.
        row: usize,
        /// The column.
        column: &'static str,
        /// The cell.
        text: String,
    },
}

objdict_model::error_messages! { AnswersError: {
    Self::Json { line, message } => "line {line}: {message}";
    Self::NoList => "expected a list of objects with `index`, `sub` and `bytes`, `value` or `abort`";
    Self::MissingColumn(column) => "there is no column `{column}`";
    Self::Cell { row, column, text } => "row {row}: `{text}` is not a valid `{column}`";
} }

/// The names of the columns, in lower case.
pub(super) const INDEX: &str = "index";
pub(super) const SUB: &str = "sub";
pub(super) const ACTION: &str = "action";
pub(super) const SENT: &str = "sent";
pub(super) const BYTES: &str = "bytes";
pub(super) const VALUE: &str = "value";
pub(super) const ABORT: &str = "abort";
pub(super) const SIZE: &str = "size";

/// Reads a table; a list or object of JSON by its first character, else CSV with commas, semicolons or tabs.
///
/// # Errors
/// When it is not a table of answers.
pub fn read_answers(text: &str) -> Result<Vec<Exchange>, AnswersError> {
    let text = text.trim_start_matches('\u{FEFF}');
    let rows = if text.trim_start().starts_with(['[', '{']) { of_json(text)? } else { of_csv(text)? };
    rows.iter().enumerate().map(|(at, cells)| AnswerRow { number: at + 1, cells }.exchange()).collect()
}

/// The cells of a row by the names of their columns; empty ones are not there.
type NamedCells = BTreeMap<String, String>;

fn of_json(text: &str) -> Result<Vec<NamedCells>, AnswersError> {
    let document: serde_json::Value = serde_json::from_str(text)
        .map_err(|error| AnswersError::Json { line: error.line(), message: error.to_string() })?;
    let list = document.as_array().or_else(|| document.get("answers")?.as_array());
    let list = list.ok_or(AnswersError::NoList)?;
    let row = |row: &serde_json::Value| {
        let members = row.as_object().ok_or(AnswersError::NoList)?.iter();
        let cells = members.filter_map(|(name, value)| Some((name.to_ascii_lowercase(), cell(name, value)?)));
        Ok(cells.collect())
    };
    list.iter().map(row).collect()
}

/// What a cell of CSV would be; numbers of addresses and codes are written as CSV has them, in hex.
fn cell(column: &str, value: &serde_json::Value) -> Option<String> {
    let bytes = |list: &Vec<serde_json::Value>| {
        list.iter()
            .map(|byte| Some(format!("{:02X}", u8::try_from(byte.as_u64()?).ok()?)))
            .collect::<Option<Vec<_>>>()
    };
    match value {
        serde_json::Value::Null => None,
        serde_json::Value::String(text) => Some(text.clone()),
        serde_json::Value::Bool(is_set) => Some(u8::from(*is_set).to_string()),
        serde_json::Value::Array(list) => {
            Some(bytes(list).map_or_else(|| value.to_string(), |bytes| bytes.join(" ")))
        }
        value => match value.as_u64().filter(|_| [INDEX, SUB, ABORT].contains(&column)) {
            Some(number) => Some(format!("0x{number:X}")),
            None => Some(value.to_string()),
        },
    }
}

fn of_csv(text: &str) -> Result<Vec<NamedCells>, AnswersError> {
    let mut rows = records(text).into_iter().map(|(_, row)| row);
    let headings: Vec<String> = rows.next().unwrap_or_default().iter().map(|name| heading(name)).collect();
    for column in [INDEX, SUB] {
        if !headings.iter().any(|name| name == column) {
            return Err(AnswersError::MissingColumn(column));
        }
    }
    let is_there = |(_, cell): &(String, String)| !cell.is_empty();
    Ok(rows.map(|row| headings.iter().cloned().zip(row).filter(is_there).collect()).collect())
}

/// A heading as it is known here.
fn heading(name: &str) -> String {
    match name.trim().to_ascii_lowercase().replace(['-', '_', ' '], "").as_str() {
        "subindex" => SUB.to_owned(),
        name => name.to_owned(),
    }
}

/// A row that is read.
struct AnswerRow<'a> {
    number: usize,
    cells: &'a NamedCells,
}

impl AnswerRow<'_> {
    fn exchange(&self) -> Result<Exchange, AnswersError> {
        let address = |column| self.hex(column)?.ok_or(AnswersError::MissingColumn(column));
        let (index, sub) = (address(INDEX)?, address(SUB)?);
        let index = u16::try_from(index).map_err(|_| self.invalid(INDEX))?;
        let sub = u8::try_from(sub).map_err(|_| self.invalid(SUB))?;
        let request = match self.get(ACTION).map(str::to_ascii_lowercase).as_deref() {
            None | Some("read" | "upload") => SdoRequest::Upload,
            Some("write" | "download") => SdoRequest::Download(self.bytes(SENT)?.unwrap_or_default()),
            Some(_) => return Err(self.invalid(ACTION)),
        };
        let answer = self.answer(&request)?;
        Ok(Exchange { reset: None, index, sub, request, answer })
    }

    fn answer(&self, request: &SdoRequest) -> Result<SdoAnswer, AnswersError> {
        if let Some(code) = self.hex(ABORT)? {
            return Ok(SdoAnswer::Abort(code.into()));
        }
        let size =
            self.get(SIZE).map(|text| text.trim().parse().map_err(|_| self.invalid(SIZE))).transpose()?;
        let value = self.get(VALUE);
        if let Some(code) = value.and_then(|text| text.trim().strip_prefix("abort")) {
            return number(code).map(|code| SdoAnswer::Abort(code.into())).ok_or_else(|| self.invalid(VALUE));
        }
        if let SdoRequest::Download(_) = request {
            // the script writes the number of bytes that were accepted
            return Ok(if size.is_some() || value.is_some() { SdoAnswer::Done } else { SdoAnswer::Silence });
        }
        if let Some(bytes) = self.bytes(BYTES)? {
            return Ok(SdoAnswer::Bytes(bytes));
        }
        Ok(match (value, size) {
            (Some(text), _) => match digits(text).filter(|_| text.trim().contains(' ')) {
                Some(bytes) => SdoAnswer::Bytes(bytes),
                None => SdoAnswer::Text(text.to_owned()),
            },
            (None, Some(0)) => SdoAnswer::Bytes(Vec::new()),
            (None, Some(size)) => SdoAnswer::Length(Some(size)),
            (None, None) => SdoAnswer::Silence,
        })
    }

    fn get(&self, column: &str) -> Option<&str> {
        self.cells.get(column).map(String::as_str)
    }

    fn hex(&self, column: &'static str) -> Result<Option<u32>, AnswersError> {
        self.get(column).map(|text| number(text).ok_or_else(|| self.invalid(column))).transpose()
    }

    fn bytes(&self, column: &'static str) -> Result<Option<Vec<u8>>, AnswersError> {
        self.get(column).map(|text| digits(text).ok_or_else(|| self.invalid(column))).transpose()
    }

    fn invalid(&self, column: &'static str) -> AnswersError {
        let text = self.get(column).unwrap_or_default().to_owned();
        AnswersError::Cell { row: self.number, column, text }
    }
}

/// A number in hex, as addresses and abort codes are written: `1018`, `0x1018`, `1018h`.
fn number(text: &str) -> Option<u32> {
    let text = text.trim();
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).unwrap_or(text);
    let digits = digits.strip_suffix(['h', 'H']).unwrap_or(digits);
    u32::from_str_radix(digits, 16).ok().filter(|_| !digits.starts_with('+'))
}

/// Bytes as hex digits, two each, with or without blanks.
fn digits(text: &str) -> Option<Vec<u8>> {
    let digits: Vec<u8> = text
        .chars()
        .filter(|character| *character != ' ')
        .map(|digit| Some(digit.to_digit(16)? as u8))
        .collect::<Option<_>>()?;
    digits.len().is_multiple_of(2).then(|| digits.chunks(2).map(|pair| pair[0] << 4 | pair[1]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_bus::Abort;

    fn answers(text: &str) -> Vec<SdoAnswer> {
        read_answers(text).unwrap().into_iter().map(|exchange| exchange.answer).collect()
    }

    #[test]
    fn a_bench_may_dump_values() {
        let text = "Index;Subindex;Value\n1000h;0;0x00020192\n0x1018;1;306\n1008;0;\"a ; \"\"b\"\"\"\n2000;1;12 34\n2001;0;abort 0x06020000\n";
        let text_of = |text: &str| SdoAnswer::Text(text.to_owned());
        assert_eq!(
            answers(text),
            [
                text_of("0x00020192"),
                text_of("306"),
                text_of("a ; \"b\""),
                SdoAnswer::Bytes(vec![0x12, 0x34]),
                SdoAnswer::Abort(Abort::NoObject)
            ]
        );
        let json = "[{\"index\": 4120, \"sub\": 1, \"value\": 306}, {\"index\": \"1018\", \"sub\": 1, \"value\": [50, 1]}]";
        let read = read_answers(json).unwrap();
        assert!(read.iter().all(|exchange| (exchange.index, exchange.sub) == (0x1018, 1)));
        assert_eq!(read[1].answer, SdoAnswer::Bytes(vec![0x32, 0x01]));
    }

    #[test]
    fn an_invalid_cell_is_named() {
        let error = |text: &str| read_answers(text).unwrap_err().to_string();
        assert_eq!(error("index,value\n"), "there is no column `sub`");
        assert_eq!(error("index,sub\n12345,0\n"), "row 1: `12345` is not a valid `index`");
        assert_eq!(error("index,sub,bytes\n1000,0,123\n"), "row 1: `123` is not a valid `bytes`");
        assert_eq!(
            error("{}"),
            "expected a list of objects with `index`, `sub` and `bytes`, `value` or `abort`"
        );
    }
}
