//! Names, texts and meanings of a node's values.

use std::io::{self, Write};

use objdict_document::describe::frames::{FrameReader, Talker, raw_bytes};
use objdict_document::describe::{Decoder, ValueReader};
use objdict_model::json::Version;
use objdict_model::model::{DataType, Device, Value};
use objdict_node::download::{Download, transferred_type};
use serde::Serialize;

use crate::annotation::DescribedStream;
use crate::args::ShowFormat;
use crate::stdout::Output;
use crate::table::TextTable;

/// The most characters of a cell.
const CELL: usize = 60;

/// The values of a node, as its description reads them.
pub(super) struct ValueWords<'d> {
    device: &'d Device,
    node_id: u8,
    reader: FrameReader<'d>,
}

/// A decoded value.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Value"))]
pub(super) struct ValueRow {
    /// The index in hex.
    index: String,
    /// The sub-index in hex.
    sub: String,
    /// The names of the object and the entry; absent without a description.
    #[serde(skip_serializing_if = "String::is_empty")]
    name: String,
    /// The data type; absent if it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    data_type: Option<String>,
    /// The bytes as they were transferred, in hex.
    #[serde(skip_serializing_if = "Option::is_none")]
    bytes: Option<String>,
    /// The value in its type, or the bytes; absent if the entry cannot be read.
    #[serde(skip_serializing_if = "Option::is_none")]
    value: Option<String>,
    /// The number in its unit, such as `12.5 rpm`.
    #[serde(skip_serializing_if = "String::is_empty")]
    in_unit: String,
    /// The meaning of the value.
    #[serde(skip_serializing_if = "String::is_empty")]
    meaning: String,
    /// Why the entry cannot be read.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct ValuesJson {
    /// The version of the document.
    version: Version<1>,
    /// The node-ID.
    node_id: u8,
    /// The values, in the order of the request.
    values: Vec<ValueRow>,
}

impl<'d> ValueWords<'d> {
    pub(super) fn new(device: &'d Device, node_id: u8) -> Self {
        let talker = Talker { name: "", node_id, device, is_counterpart: false };
        Self { device, node_id, reader: FrameReader::new(vec![talker]) }
    }

    /// The name of an entry.
    pub(super) fn name(&self, (index, sub): (u16, u8)) -> String {
        DescribedStream { device: Some(self.device), node_id: Some(self.node_id) }.name_of(index, sub)
    }

    fn value(&self, (index, sub): (u16, u8), bytes: &[u8]) -> (Option<DataType>, Option<Value>) {
        let described = transferred_type(self.device, index, sub);
        let stream = DescribedStream { device: None, node_id: None };
        let data_type = described.or_else(|| stream.annotate(&Download::new(index, sub, bytes)).data_type);
        (described, data_type.and_then(|data_type| Value::from_bytes(bytes, data_type)))
    }

    /// The value with its meaning, in one cell.
    pub(super) fn text(&self, entry: (u16, u8), bytes: &[u8]) -> String {
        let ValueRow { value, in_unit, meaning, .. } = self.row(entry, Ok(bytes));
        let words: Vec<String> = [in_unit, meaning].into_iter().filter(|text| !text.is_empty()).collect();
        let value = value.unwrap_or_default();
        if words.is_empty() { value } else { format!("{value} ({})", words.join("; ")) }
    }

    /// A row of a table.
    pub(super) fn row(&self, entry: (u16, u8), bytes: Result<&[u8], String>) -> ValueRow {
        let (index, sub) = entry;
        let mut row = ValueRow {
            index: format!("{index:04X}"),
            sub: format!("{sub:02X}"),
            name: self.name(entry),
            data_type: None,
            bytes: None,
            value: None,
            in_unit: String::new(),
            meaning: String::new(),
            error: None,
        };
        let bytes = match bytes {
            Ok(bytes) => bytes,
            Err(error) => return ValueRow { error: Some(error), ..row },
        };
        let (data_type, value) = self.value(entry, bytes);
        row.bytes = Some(raw_bytes(bytes));
        row.data_type = data_type.and_then(DataType::name).map(str::to_owned);
        let Some(value) = value else { return ValueRow { value: Some(raw_bytes(bytes)), ..row } };
        let reading = self.reader.reading(self.node_id, entry, &value);
        row.in_unit = match reading.number.filter(|_| !reading.unit.is_empty()) {
            Some(number) => format!("{number} {}", reading.unit),
            None => String::new(),
        };
        let meaning = Decoder::english(self.device, Some(self.node_id)).of(index, sub, &value);
        if meaning.is_some() && index < 0x2000 {
            // the meaning has the unit
            row.in_unit.clear();
        }
        row.meaning = meaning.or(reading.word).filter(|words| *words != row.in_unit).unwrap_or_default();
        let shown = ValueReader { index, node_id: Some(self.node_id) };
        row.value = Some(shown.short(Some(&value), data_type.or(Some(DataType::UNSIGNED32))));
        row
    }
}

impl ValueRow {
    /// Unit, meaning and error of the value.
    fn words(&self) -> String {
        let error = self.error.as_ref().map(|error| format!("({error})")).unwrap_or_default();
        let words = [&self.in_unit, &self.meaning, &error].map(String::as_str);
        words.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join("; ")
    }

    /// Writes a line about another value than before, with a time in microseconds.
    pub(super) fn write_change(&self, time: u64, format: ShowFormat, out: &mut Output) -> io::Result<()> {
        if format == ShowFormat::Json {
            let line = serde_json::to_string(&ChangedValueJson { time: time / 1000, value: self })?;
            return writeln!(out, "{line}");
        }
        let value = self.value.as_deref().unwrap_or_default();
        let (seconds, rest) = (time / 1_000_000, time % 1_000_000 / 1000);
        let line = format!(
            "{seconds}.{rest:03}  {}:{} {}  {value}  {}",
            self.index,
            self.sub,
            self.name,
            self.words()
        );
        writeln!(out, "{}", line.trim_end())
    }
}

/// A value that has changed.
#[derive(Serialize)]
struct ChangedValueJson<'r> {
    /// Milliseconds since the bus was opened.
    time: u64,
    #[serde(flatten)]
    value: &'r ValueRow,
}

/// Writes values as a table.
pub(super) fn write_table(rows: Vec<ValueRow>, out: &mut Output) -> io::Result<()> {
    let mut table = TextTable::new(["Entry", "Name", "Type", "Value", "Meaning"], CELL);
    for row in rows {
        let words = row.words();
        table.row([
            format!("{}:{}", row.index, row.sub),
            row.name,
            row.data_type.unwrap_or_default(),
            row.value.unwrap_or_default(),
            words,
        ]);
    }
    table.write(out)
}

/// Writes values as JSON.
pub(super) fn write_json(node_id: u8, values: Vec<ValueRow>, out: &mut Output) -> io::Result<()> {
    out.flush()?;
    out.json(&ValuesJson { version: Version, node_id, values })
}
