//! CSV output: one line per entry, for spreadsheets and scripts.
//!
//! Column names are the same in every language; new columns are appended.

use std::borrow::{Borrow, Cow};
use std::collections::HashMap;
use std::fmt::{Display, Write};

use super::anchor::Anchor;
use super::details::{Details, VALUES};
use super::entry::EntryView;
use super::escape;
use super::object::ObjectView;
use super::page::Page;
use crate::model::{Device, Entry, Object, Value};

/// The content of a line; an object without entries also has a line.
struct CsvRow<'a> {
    node_id: Option<u8>,
    object: &'a ObjectView<'a>,
    view: Option<&'a EntryView<'a>>,
    entry: Option<Cow<'a, Entry>>,
    /// The groups of the entry: `Drive / Limits`.
    groups: &'a str,
    /// The numbers of its downloads with their values: `3 = 0x80000201; 9 = 0x201`.
    downloads: &'a str,
}

type EntryColumn = (&'static str, for<'a> fn(&'a CsvRow<'a>) -> Cow<'a, str>);

/// The columns in order. This is a stable interface: columns are never renamed, moved or removed.
const COLUMNS: [EntryColumn; 34] = [
    ("index", |row| format!("0x{:04X}", row.object.index).into()),
    ("sub", |row| row.view.map_or("".into(), |view| format!("0x{:02X}", view.sub).into())),
    ("object_name", |row| row.object.name.as_ref().into()),
    ("name", |row| row.of(|view| &view.name)),
    ("object_type", |row| row.object.object_type.as_str().into()),
    ("data_type", |row| row.of(|view| &view.data_type)),
    ("bits", |row| row.view.and_then(|view| view.bits).map_or("".into(), |bits| bits.to_string().into())),
    ("access", |row| row.of(|view| view.access)),
    ("pdo", |row| row.of(|view| view.pdo)),
    ("default", |row| row.value(|entry| entry.default.as_ref())),
    ("value", |row| row.value(Entry::configured_value)),
    ("changed", |row| row.changed().into()),
    ("low_limit", |row| row.value(|entry| entry.low_limit.as_ref())),
    ("high_limit", |row| row.value(|entry| entry.high_limit.as_ref())),
    ("unit", |row| row.of(|view| view.details.unit.as_deref().unwrap_or_default())),
    ("meaning", |row| row.of(|view| view.meaning.as_deref().unwrap_or_default())),
    ("denotation", |row| row.of(|view| view.details.denotation.as_deref().unwrap_or_default())),
    ("description", |row| row.of(|view| view.details.description.as_deref().unwrap_or_default())),
    ("object_description", |row| row.object.details.description.as_deref().unwrap_or_default().into()),
    ("name_in_file", |row| row.of(|view| view.own_name.as_deref().unwrap_or_default())),
    ("object_name_in_file", |row| row.object.own_name.as_deref().unwrap_or_default().into()),
    ("default_formula", |row| row.formula(|entry| entry.default.as_ref())),
    ("value_formula", |row| row.formula(Entry::configured_value)),
    ("mapped_in", |row| row.details(|details| details.carried_by.join(", "))),
    ("named_values", |row| row.details(|details| named(&details.values, "; "))),
    ("bit_fields", |row| row.details(bit_fields)),
    ("groups", |row| row.groups.into()),
    ("facts", |row| row.details(|details| pairs(&details.facts))),
    ("keys", |row| row.details(|details| pairs(&details.keys))),
    ("object_facts", |row| pairs(&row.object.details.facts).into()),
    ("object_keys", |row| pairs(&row.object.details.keys).into()),
    ("links", |row| links(row.object).into()),
    ("invalid_values", |row| row.invalid_values().into()),
    ("downloads", |row| row.downloads.into()),
];

impl<'a> CsvRow<'a> {
    fn of(&self, text: impl FnOnce(&'a EntryView<'a>) -> &'a str) -> Cow<'a, str> {
        self.view.map(text).unwrap_or_default().into()
    }

    /// Invalid field values: `DefaultValue = 300`.
    fn invalid_values(&self) -> String {
        let invalid_values = self.entry.iter().flat_map(|entry| entry.invalid_values.iter());
        let invalid = invalid_values.filter(|invalid| VALUES.contains(&invalid.field));
        let texts: Vec<_> =
            invalid.map(|invalid| (invalid.field.to_string(), invalid.text.to_string())).collect();
        pairs(&texts)
    }

    /// A value in spreadsheet notation; empty if it is missing or invalid.
    fn value(&self, value: impl FnOnce(&Entry) -> Option<&Value>) -> Cow<'_, str> {
        let Some(entry) = &self.entry else { return "".into() };
        let Some(value) = value(entry) else { return "".into() };
        let resolved =
            self.node_id.zip(entry.data_type).and_then(|(node, data_type)| value.resolve(data_type, node));
        plain(resolved.as_ref().unwrap_or(value)).into()
    }

    /// A value that depends on the node-ID, as a formula.
    fn formula(&self, value: impl FnOnce(&Entry) -> Option<&Value>) -> Cow<'_, str> {
        let value = self.entry.as_ref().and_then(|entry| value(entry));
        value
            .filter(|value| matches!(value, Value::NodeId(_)))
            .map_or("".into(), |value| value.to_string().into())
    }

    fn changed(&self) -> &'static str {
        match self.view {
            Some(view) if view.value.is_some() => {
                if view.is_changed {
                    "yes"
                } else {
                    "no"
                }
            }
            _ => "",
        }
    }

    fn details(&self, text: impl FnOnce(&Details<'_>) -> String) -> Cow<'_, str> {
        self.view.map(|view| text(&view.details)).unwrap_or_default().into()
    }
}

/// A value without quotes; numbers in decimal.
fn plain(value: &Value) -> String {
    match value {
        Value::Text(text) => text.to_string(),
        _ => value.as_integer().map_or_else(|| value.to_string(), |number| number.to_string()),
    }
}

/// `0 = off; 1 = on`, with a separator.
fn named(values: &[(impl Display, &str)], between: &str) -> String {
    values.iter().map(|(number, name)| format!("{number} = {name}")).collect::<Vec<_>>().join(between)
}

/// `0: ready; 4–7: mode (0 = off, 1 = on)`.
fn bit_fields(details: &Details<'_>) -> String {
    let fields = details.parts.iter().map(|part| match part.values.as_slice() {
        [] => format!("{}: {}", part.range(), part.name),
        values => format!("{}: {} ({})", part.range(), part.name, named(values, ", ")),
    });
    fields.collect::<Vec<_>>().join("; ")
}

/// `Key = text; Key = text`.
fn pairs(pairs: &[(impl AsRef<str>, String)]) -> String {
    pairs.iter().map(|(key, text)| format!("{} = {text}", key.as_ref())).collect::<Vec<_>>().join("; ")
}

/// The objects that an object refers to.
fn links(object: &ObjectView<'_>) -> String {
    object.links.iter().map(|link| format!("0x{:04X}", link.index)).collect::<Vec<_>>().join("; ")
}

/// Writes the dictionary as CSV (RFC 4180) with a byte order mark, without which spreadsheets guess the
/// encoding.
pub(super) fn write(page: &Page<'_>, device: &Device) -> String {
    let (groups, downloads) = (groups(page), downloads(page));
    let mut text = String::with_capacity(1000 + 150 * page.entry_count());
    text.push('\u{FEFF}');
    line(&mut text, COLUMNS.iter().map(|(name, _)| Cow::Borrowed(*name)));
    for object in page.areas.iter().flat_map(|area| &area.objects) {
        let mut row =
            CsvRow { node_id: page.node_id, object, view: None, entry: None, groups: "", downloads: "" };
        let in_group = |anchor: Anchor| groups.get(&(anchor.index, anchor.sub)).map(String::as_str);
        let of_object = in_group(object.anchor()).unwrap_or_default();
        if object.entries.is_empty() {
            row.groups = of_object;
            line(&mut text, COLUMNS.iter().map(|(_, field)| field(&row)));
        }
        let entries = device.object(object.index).into_iter().flat_map(Object::entries);
        for (view, (_, entry)) in object.entries.iter().zip(entries) {
            row = CsvRow {
                view: Some(view),
                entry: Some(entry),
                groups: in_group(view.anchor()).unwrap_or(of_object),
                downloads: downloads.get(&(view.index, Some(view.sub))).map_or("", String::as_str),
                ..row
            };
            line(&mut text, COLUMNS.iter().map(|(_, field)| field(&row)));
        }
    }
    text
}

/// A column: its name, and its content for a row.
pub(super) type CsvColumn<R> = (&'static str, fn(&R) -> String);

/// A table with a line for each row.
pub(super) fn table<R>(columns: &[CsvColumn<R>], rows: impl IntoIterator<Item: Borrow<R>>) -> String {
    let mut text = "\u{FEFF}".to_owned();
    line(&mut text, columns.iter().map(|(name, _)| Cow::Borrowed(*name)));
    for row in rows {
        line(&mut text, columns.iter().map(|(_, field)| field(row.borrow()).into()));
    }
    text
}

/// Writes the fields of a line.
fn line<'a>(text: &mut String, fields: impl IntoIterator<Item = Cow<'a, str>>) {
    for (number, field) in fields.into_iter().enumerate() {
        let between = if number > 0 { "," } else { "" };
        let _ = write!(text, "{between}{}", escape::field(&field)); // writing to a String cannot fail
    }
    text.push_str("\r\n");
}

/// The downloads to each entry.
fn downloads(page: &Page<'_>) -> HashMap<(u16, Option<u8>), String> {
    let mut found: HashMap<_, String> = HashMap::new();
    for (number, download) in (1_u32..).zip(&page.downloads) {
        let value = download.value.as_ref().map_or_else(|| download.shown.clone(), plain);
        let texts = found.entry((download.entry.index, download.entry.sub)).or_default();
        let between = if texts.is_empty() { "" } else { "; " };
        let _ = write!(texts, "{between}{number} = {value}"); // writing to a String cannot fail
    }
    found
}

/// The groups of each object and entry, with their parent groups.
fn groups(page: &Page<'_>) -> HashMap<(u16, Option<u8>), String> {
    let mut found: HashMap<_, String> = HashMap::new();
    let mut path: Vec<&str> = Vec::new();
    for group in &page.groups {
        path.truncate(group.depth);
        path.push(group.name);
        let name = path.iter().copied().filter(|name| !name.is_empty()).collect::<Vec<_>>().join(" / ");
        for anchor in group.members.iter().filter_map(|member| member.anchor) {
            let names = found.entry((anchor.index, anchor.sub)).or_default();
            if !names.is_empty() {
                names.push_str("; ");
            }
            names.push_str(&name);
        }
    }
    found
}
