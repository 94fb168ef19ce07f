//! The entries of a dictionary as JSON, flat and with all formulas evaluated; `docs/reference/json.md` describes it. The model as
//! it is, to be read back, is what `convert` writes.

use std::collections::BTreeMap;
use std::io::{self, Write};

use serde::Serialize;
use serde_json::Value as Json;

use super::ShownDevice;
use objdict_document::describe::ValueReader;
use objdict_model::json;
use objdict_model::model::{
    Entry, ExplicitDownload, HexText, InvalidValue, Moment, Object, PdoMapping, Plain, Value,
};

/// The version of the document. It changes when a field is removed or means something else, not when one is added.
const VERSION: u32 = 1;

/// The document, which is written entry by entry.
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[allow(dead_code, reason = "its schema is all that is made of it")]
pub(crate) struct EntriesJson<'a> {
    /// The version of the document.
    version: objdict_model::json::Version<VERSION>,
    /// The file as it was given; `<stdin>` for the standard input.
    file: &'a str,
    /// The format: `EDS`, `DCF`, `XDD`, `XDC`, `CANopenNode project` or `JSON`.
    format: &'a str,
    /// The node-ID that formulas are evaluated for.
    node_id: Option<u8>,
    /// The entries by index and sub-index.
    entries: Vec<ShowRow<'a>>,
    /// The ordered downloads of a node; absent if it has none.
    #[schemars(skip_serializing_if = "Vec::is_empty")]
    downloads: Vec<Ordered<'a>>,
}

/// An entry.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Entry"))]
struct ShowRow<'a> {
    /// The index of the object.
    index: HexText<u16>,
    /// The sub-index of the entry.
    sub: HexText<u8>,
    /// The name of the entry.
    name: &'a str,
    /// The name of the object.
    object: &'a str,
    /// The type of the object: `VAR`, `ARRAY`, `RECORD` …
    #[cfg_attr(feature = "schema", schemars(with = "objdict_model::model::ObjectType"))]
    object_type: &'static str,
    /// The data type: `UNSIGNED16`, or `0060h` for a type that CiA 301 does not name.
    #[serde(skip_serializing_if = "Option::is_none")]
    data_type: Option<String>,
    /// The access type.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(with = "Option<objdict_model::model::Access>"))]
    access: Option<&'static str>,
    /// Whether a PDO may carry the entry.
    pdo_mapping: PdoMapping,
    /// The default value.
    #[serde(skip_serializing_if = "Option::is_none")]
    default: Option<Plain<'a>>,
    /// The value of a DCF.
    #[serde(skip_serializing_if = "Option::is_none")]
    value: Option<Plain<'a>>,
    /// The low limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    low_limit: Option<Plain<'a>>,
    /// The high limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    high_limit: Option<Plain<'a>>,
    /// The bytes of an SDO upload from the configured node, in hex, lowest byte first.
    #[serde(skip_serializing_if = "Option::is_none")]
    bytes: Option<String>,
    /// The texts that are not valid values, by key. The field of such a key is absent.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    invalid_values: BTreeMap<String, &'a str>,
}

/// An ordered download.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Download"))]
struct Ordered<'a> {
    /// Whether it comes before or after the values of the entries.
    when: Moment,
    /// The index of the object.
    index: HexText<u16>,
    /// The sub-index of the entry.
    sub: HexText<u8>,
    /// The value.
    value: Plain<'a>,
}

/// Writes the entries of `objects` that `is_wanted` takes, one a line, then the ordered downloads.
pub(super) fn write<'a>(
    view: &ShownDevice<'_>,
    objects: impl Iterator<Item = (u16, &'a Object)>,
    is_wanted: impl Fn(u8) -> bool,
    downloads: &[ExplicitDownload],
    out: &mut dyn Write,
) -> io::Result<()> {
    write!(out, "{{\"version\":{VERSION},\"file\":{},", json::text(&view.file)?)?;
    write!(
        out,
        "\"format\":{},\"node_id\":{},\"entries\":[",
        Json::from(view.format),
        Json::from(view.node_id)
    )?;
    let mut separator = "\n";
    for (index, object) in objects {
        for (sub, entry) in object.entries().filter(|(sub, entry)| is_wanted(*sub) && view.shows(entry)) {
            out.write_all(separator.as_bytes())?;
            json::write(out, &row(view.reader(index), sub, object, &entry))?;
            separator = ",\n";
        }
    }
    out.write_all(b"\n]")?;
    if !downloads.is_empty() {
        let ordered = |download: &ExplicitDownload| {
            let ExplicitDownload { when, index, sub, value } = download;
            let data_type = view.device.entry(*index, *sub).and_then(|entry| entry.data_type);
            let value = view.reader(*index).resolve(value, data_type).plain().into_owned();
            Ordered { when: *when, index: HexText(*index), sub: HexText(*sub), value }
        };
        out.write_all(b",\"downloads\":")?;
        json::write(out, &downloads.iter().map(ordered).collect::<Vec<_>>())?;
    }
    out.write_all(b"}\n")
}

fn row<'a>(reader: ValueReader, sub: u8, object: &'a Object, entry: &'a Entry) -> ShowRow<'a> {
    let value =
        |value: &Option<Value>| Some(reader.resolve(value.as_ref()?, entry.data_type).plain().into_owned());
    ShowRow {
        index: HexText(reader.index),
        sub: HexText(sub),
        name: &entry.name,
        object: object.name(),
        object_type: object.object_type().name(),
        data_type: entry.implied_type().map(|data_type| data_type.to_string()),
        access: entry.implied_access().map(objdict_model::model::Access::name),
        pdo_mapping: entry.pdo_mapping.unwrap_or_default(),
        default: value(&entry.default),
        value: value(&entry.configured_value().cloned()),
        low_limit: value(&entry.low_limit),
        high_limit: value(&entry.high_limit),
        bytes: entry.value().and_then(|value| reader.bytes(value, entry.data_type, "")),
        invalid_values: entry.invalid_values.iter().map(invalid).collect(),
    }
}

fn invalid(invalid: &InvalidValue) -> (String, &str) {
    (invalid.field.to_string(), &invalid.text)
}
