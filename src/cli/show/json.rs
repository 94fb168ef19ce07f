//! The entries of a dictionary as JSON, flat and with all formulas evaluated; `docs/json.md` describes it. The model as
//! it is, to be read back, is what `convert` writes.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::Value as Json;

use super::View;
use crate::describe::Reader;
use crate::json;
use crate::model::{Entry, ExplicitDownload, InvalidValue, Moment, Object, PdoMapping, Value};

/// The version of the document. It changes when a field is removed or means something else, not when one is added.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Row<'a> {
    index: String,
    sub: String,
    name: &'a str,
    object: &'a str,
    object_type: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    data_type: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    access: Option<&'static str>,
    pdo_mapping: PdoMapping,
    #[serde(skip_serializing_if = "Option::is_none")]
    default: Option<Json>,
    #[serde(skip_serializing_if = "Option::is_none")]
    value: Option<Json>,
    #[serde(skip_serializing_if = "Option::is_none")]
    low_limit: Option<Json>,
    #[serde(skip_serializing_if = "Option::is_none")]
    high_limit: Option<Json>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bytes: Option<String>,
    /// The texts that are not valid values, by key.
    #[serde(skip_serializing_if = "serde_json::Map::is_empty")]
    invalid_values: serde_json::Map<String, Json>,
}

#[derive(Serialize)]
struct Ordered {
    when: Moment,
    index: String,
    sub: String,
    value: Json,
}

/// Writes the entries of `objects` that `is_wanted` takes, one a line, then the ordered downloads.
pub(super) fn write<'a>(
    view: &View<'_>,
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
            let value = to_json(&view.reader(*index).resolve(value, data_type));
            Ordered { when: *when, index: format!("0x{index:04X}"), sub: format!("0x{sub:02X}"), value }
        };
        out.write_all(b",\"downloads\":")?;
        json::write(out, &downloads.iter().map(ordered).collect::<Vec<_>>())?;
    }
    out.write_all(b"}\n")
}

fn row<'a>(reader: Reader, sub: u8, object: &'a Object, entry: &'a Entry) -> Row<'a> {
    let value = |value: &Option<Value>| Some(to_json(&reader.resolve(value.as_ref()?, entry.data_type)));
    Row {
        index: format!("0x{:04X}", reader.index),
        sub: format!("0x{sub:02X}"),
        name: &entry.name,
        object: object.name(),
        object_type: object.object_type().name(),
        data_type: entry.implied_type().map(|data_type| data_type.to_string()),
        access: entry.implied_access().map(crate::model::Access::name),
        pdo_mapping: entry.pdo_mapping.unwrap_or_default(),
        default: value(&entry.default),
        value: value(&entry.configured_value().cloned()),
        low_limit: value(&entry.low_limit),
        high_limit: value(&entry.high_limit),
        bytes: entry.value().and_then(|value| reader.bytes(value, entry.data_type, "")),
        invalid_values: entry.invalid_values.iter().map(invalid).collect(),
    }
}

fn invalid(invalid: &InvalidValue) -> (String, Json) {
    (invalid.field.to_string(), Json::from(&*invalid.text))
}

/// Whole numbers and finite REAL as numbers, BOOLEAN as such, everything else as the text that a table shows.
fn to_json(value: &Value) -> Json {
    match value {
        Value::Boolean(value) => Json::from(*value),
        Value::Signed(value) => Json::from(*value),
        Value::Unsigned(value) => Json::from(*value),
        Value::Real32(value) if value.is_finite() => shortest(&value.to_string()),
        Value::Real64(value) if value.is_finite() => Json::from(*value),
        _ => Json::from(value.to_string()),
    }
}

/// A REAL32 with its own digits, not with those of the REAL64 next to it.
fn shortest(text: &str) -> Json {
    text.parse::<f64>().map_or_else(|_| Json::from(text), Json::from)
}
