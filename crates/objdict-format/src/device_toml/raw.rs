//! Content without a key: values of the device JSON by path.

use serde_json::{Map, Value};

use super::words::{key, quoted};
use super::writer::insert_before_tables;
use crate::compare::{Datum, DatumChange, DatumDifference, overlay};
use objdict_keyed::rules::WRONG_TYPE;
use objdict_keyed::section::KeyedTable;
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::{Diagnostic, Findings, say};
use objdict_model::model::Device;
use objdict_model::source::Span;

/// Reads `raw` and `raw-remove` into a device.
pub(super) fn read(root: &KeyedTable<'_>, device: &mut Device, findings: &mut Findings) {
    let mut changes = Vec::new();
    let mut spans: Vec<(String, Span)> = Vec::new();
    let mut change = |path: String, after: Option<Value>, span| {
        spans.push((path.clone(), span));
        changes.push(DatumChange { path, before: None, after: after.as_ref().map(Datum::from) });
    };
    for text in root.texts("raw-remove", findings) {
        change(text.value.to_owned(), None, text.at);
    }
    for entry in root.named("raw", findings) {
        change(entry.key.spelled(), Some(json(&entry.value)), entry.key.span);
    }
    let (changes, mut refused): (Vec<_>, Vec<_>) =
        changes.into_iter().partition(|change| change.path.starts_with('/'));
    if !changes.is_empty() {
        refused.extend(overlay(device, changes));
    }
    for change in refused {
        let span = spans.iter().find(|(path, _)| *path == change.path).map(|(_, span)| *span);
        let message = say!("the JSON of a device has no such value at `{}`", change.path);
        let finding = Diagnostic::new(&WRONG_TYPE, span.unwrap_or_default(), message);
        findings.push(
            finding
                .help("convert the device to JSON to see its values; docs/reference/json.md lists all keys"),
        );
    }
}

fn json(tree: &KeyedTree) -> Value {
    match &*tree.kind {
        Kind::Null => Value::Null,
        Kind::Bool(flag) => (*flag).into(),
        Kind::Integer(number) => match (u64::try_from(*number), i64::try_from(*number)) {
            (Ok(number), _) => number.into(),
            (_, Ok(number)) => number.into(),
            _ => Value::Null,
        },
        Kind::Float(number) => (*number).into(),
        Kind::Text(text) => text.as_str().into(),
        Kind::List(items) => items.iter().map(json).collect(),
        Kind::Map(entries) => {
            let fields = entries.iter().map(|entry| (entry.key.spelled(), json(&entry.value)));
            Value::Object(fields.collect::<Map<_, _>>())
        }
    }
}

/// Writes values that a text does not preserve: `left` is the result of reading it, `right` the device.
pub(super) fn write(missing: &[DatumDifference], text: &mut String) {
    let removed: Vec<String> =
        missing.iter().filter(|found| found.right.is_none()).map(|found| quoted(&found.path)).collect();
    if !removed.is_empty() {
        let lines = format!("raw-remove = [\n    {},\n]\n", removed.join(",\n    "));
        insert_before_tables(&lines, text);
    }
    let mut values = missing.iter().filter(|found| found.right.is_some()).peekable();
    if values.peek().is_some() {
        text.push_str("\n[raw]\n");
    }
    for found in values {
        let value = found.right.as_ref().map(|datum| spelled(&datum.value())).unwrap_or_default();
        text.push_str(&format!("{} = {value}\n", key(&found.path)));
    }
}

fn spelled(value: &Value) -> String {
    match value {
        Value::Null => "\"\"".to_owned(),
        Value::Bool(flag) => flag.to_string(),
        Value::Number(number) => number.to_string(),
        Value::String(text) => quoted(text),
        Value::Array(items) => {
            format!("[{}]", items.iter().map(spelled).collect::<Vec<_>>().join(", "))
        }
        Value::Object(fields) => {
            // null in JSON means missing
            let fields = fields.iter().filter(|(_, value)| !value.is_null());
            let items: Vec<String> =
                fields.map(|(name, value)| format!("{} = {}", key(name), spelled(value))).collect();
            if items.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", items.join(", ")) }
        }
    }
}
