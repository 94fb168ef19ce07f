//! JSON: the complete model of a device, or a configuration, with stable names.
//!
//! A document states its content in `kind` and its names in `version`. A name that a version does not have, a key
//! that is defined twice and a value that does not fit its data type are errors with line and column: no part of a
//! document is ignored.

use serde::{Deserialize, Serialize};

use objdict_model::json::Version;
use objdict_model::model::{Device, WithPlainValues};
use objdict_node::download::ConciseDcf;

/// The version of the names. It is incremented by changes that older readers would not understand.
pub const VERSION: u32 = 1;

/// The content of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum DocumentKind {
    /// A device description.
    Device,
    /// A configuration, as a concise DCF carries it.
    ConciseDcf,
}

/// The reason why a text is not a valid document.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct JsonError {
    /// Line, counted from 1.
    pub line: usize,
    /// Column in bytes, counted from 1; 0 at the end of a line.
    pub column: usize,
    /// The problem.
    pub message: String,
}

objdict_model::error_messages! { JsonError: {
    Self { line, column, message } => "line {line}, column {column}: {message}";
} }

/// The JSON of a device.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DeviceDocument<T> {
    /// The version of the document.
    version: Version<VERSION>,
    /// The kind of document.
    #[cfg_attr(feature = "schema", schemars(extend("const" = "device")))]
    kind: DocumentKind,
    /// The device: the parts of its description.
    device: T,
}

/// The JSON of a concise DCF.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ConciseDocument<T> {
    /// The version of the document.
    version: Version<VERSION>,
    /// The kind of document.
    #[cfg_attr(feature = "schema", schemars(extend("const" = "concise-dcf")))]
    kind: DocumentKind,
    /// The downloads, in order.
    entries: T,
}

/// The start of every document, which is read before the rest.
#[derive(Deserialize)]
#[serde(expecting = "an object with `version` and `kind`")]
struct DocumentHead {
    #[serde(rename = "version")]
    _version: Version<VERSION>,
    kind: DocumentKind,
}

/// The device as a document, indented, with a final line feed. Each value is written in plain and exact
/// notation.
pub fn write_device(device: &Device) -> String {
    print(&DeviceDocument { version: Version, kind: DocumentKind::Device, device: WithPlainValues(device) })
}

/// The configuration as a document, indented, with a line feed at its end.
pub fn write_configuration(configuration: &ConciseDcf) -> String {
    print(&ConciseDocument { version: Version, kind: DocumentKind::ConciseDcf, entries: configuration })
}

/// The kind of a document.
///
/// # Errors
/// If it is not JSON, or not a document of this version.
pub fn kind(text: &str) -> Result<DocumentKind, JsonError> {
    serde_json::from_str(text).map(|DocumentHead { kind, .. }| kind).map_err(JsonError::from)
}

/// The device of a document.
///
/// # Errors
/// The first problem with its position.
pub fn read_device(text: &str) -> Result<Device, JsonError> {
    expect(text, DocumentKind::Device)?;
    let document: DeviceDocument<Device> = serde_json::from_str(text)?;
    Ok(document.device)
}

/// The configuration of a document.
///
/// # Errors
/// The first problem with its position.
pub fn read_configuration(text: &str) -> Result<ConciseDcf, JsonError> {
    expect(text, DocumentKind::ConciseDcf)?;
    let document: ConciseDocument<ConciseDcf> = serde_json::from_str(text)?;
    Ok(document.entries)
}

fn expect(text: &str, expected: DocumentKind) -> Result<(), JsonError> {
    let found = kind(text)?;
    if found == expected {
        return Ok(());
    }
    let message = format!("the document contains {}, not {}", found.name(), expected.name());
    Err(JsonError { line: 1, column: 1, message })
}

fn print(document: &impl Serialize) -> String {
    // only a map with non-string keys could fail, and the model has none
    let mut text = objdict_model::json::pretty(document).unwrap_or_default();
    text.push('\n');
    text
}

impl DocumentKind {
    /// Its common name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Device => "a device description",
            Self::ConciseDcf => "a concise DCF",
        }
    }
}

impl From<serde_json::Error> for JsonError {
    fn from(error: serde_json::Error) -> Self {
        let (line, column) = (error.line(), error.column());
        let text = error.to_string();
        let place = format!(" at line {line} column {column}");
        Self { line, column, message: text.strip_suffix(&place).unwrap_or(&text).to_owned() }
    }
}

#[cfg(feature = "schema")]
objdict_model::inline_schemas! {
    // each document is of one kind
    DocumentKind: |_| schemars::json_schema!({ "type": "string" });
}
