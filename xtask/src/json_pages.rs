//! Tables of keys and fields from JSON Schemas: docs/reference/json, a page per document, and the keys of `device.toml`,
//! `network.toml` and patches.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use objdict::format::device_schema;
use objdict::format::network::schema::network_toml;
use objdict::format::patch::schema::patch;
use serde_json::{Map, Value};

use crate::docs::{Pages, text_of, with_table};

/// The documents with pages of their own, whose keys people write.
const ELSEWHERE: [&str; 2] = ["patch", "answers"];

/// The tables of docs/reference/device.md: mark, and the path of the keys in the schema, `*` for any key.
const DEVICE_TABLES: [(&str, &str); 9] = [
    ("keys", ""),
    ("features", "features"),
    ("file", "file"),
    ("device", "device"),
    ("node", "node"),
    ("pdo", "tpdo/*"),
    ("entries", "object/*/sub/*"),
    ("defaults", "defaults"),
    ("lists", "lists"),
];

/// The same of docs/reference/network.md, `[]` for an item of a list.
const NETWORK_TABLES: [(&str, &str); 6] = [
    ("bus", "bus"),
    ("manager", "manager"),
    ("node", "node/*"),
    ("sdo", "node/*/sdo/[]"),
    ("pdo", "node/*/tpdo/*"),
    ("link", "link/[]"),
];

/// The same of docs/reference/patch.md.
const PATCH_TABLES: [(&str, &str); 4] =
    [("keys", ""), ("change", "change/[]"), ("fields", "change/[]/set"), ("raw", "raw/[]")];

/// Adds the page of each document, the list of them, and the tables of `device.toml`, `network.toml` and patches.
pub(crate) fn add(docs: &Path, pages: &mut Pages) -> Result<(), String> {
    let mut list = String::from("| Name | Document |\n|---|---|\n");
    for (name, schema) in schemas(docs)? {
        let about = description(&schema);
        let _ = writeln!(list, "| [`{name}`](json/{name}.md) | {about} |");
        let page = format!("reference/json/{name}.md");
        let new = format!(
            "# {name}\n\n<!-- about -->\n<!-- end of about -->\n\n<!-- fields -->\n<!-- end of fields -->\n"
        );
        let text = with_table(&text_of(docs, &page).unwrap_or(new), &page, "about", &format!("{about}\n"))?;
        pages.insert(page.clone(), with_table(&text, &page, "fields", &fields(&schema))?);
    }
    let page = "reference/json.md";
    pages.insert(page.to_owned(), with_table(&text_of(docs, page)?, page, "documents", &list)?);
    let page = "reference/network.md";
    pages.insert(page.to_owned(), with_keys(docs, page, &network_toml(), &NETWORK_TABLES)?);
    let page = "reference/patch.md";
    pages.insert(page.to_owned(), with_keys(docs, page, &patch(), &PATCH_TABLES)?);
    let page = "reference/device.md";
    let schema = device_schema();
    let text = with_keys(docs, page, &schema, &DEVICE_TABLES)?;
    let objects = properties(at(&schema, "object/*")).zip(properties(at(&schema, "object/*/sub/*")));
    let (objects, entries) = objects.ok_or("no objects in the device schema")?;
    let own = objects.iter().filter(|(key, _)| !entries.contains_key(*key));
    pages.insert(page.to_owned(), with_table(&text, page, "objects", &keys_table(own))?);
    Ok(())
}

/// A page with these tables of keys.
fn with_keys(docs: &Path, page: &str, schema: &Value, tables: &[(&str, &str)]) -> Result<String, String> {
    let mut text = text_of(docs, page)?;
    for (mark, path) in tables {
        let keys =
            properties(at(schema, path)).ok_or_else(|| format!("no keys at `{path}` for docs/{page}"))?;
        // a patch also accepts keys of CiA 306, which begin with a capital letter
        let keys = keys.iter().filter(|(key, _)| key.starts_with(char::is_lowercase));
        text = with_table(&text, page, mark, &keys_table(keys))?;
    }
    Ok(text)
}

/// The lines of docs/SUMMARY.md.
pub(crate) fn contents(docs: &Path) -> Result<String, String> {
    let lines =
        schemas(docs)?.into_iter().map(|(name, _)| format!("    - [{name}](reference/json/{name}.md)\n"));
    Ok(lines.collect())
}

/// The committed schemas by their names.
fn schemas(docs: &Path) -> Result<Vec<(String, Value)>, String> {
    let folder = docs.join("../schemas");
    let failed = |error: std::io::Error| format!("cannot read schemas: {error}");
    let mut schemas = Vec::new();
    for file in fs::read_dir(&folder).map_err(failed)? {
        let path = file.map_err(failed)?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if !ELSEWHERE.contains(&&*name) {
            let text = fs::read_to_string(&path).map_err(failed)?;
            let schema =
                serde_json::from_str(&text).map_err(|error| format!("schemas/{name}.json: {error}"))?;
            schemas.push((name, schema));
        }
    }
    schemas.sort_by(|(a, _), (b, _)| a.cmp(b));
    Ok(schemas)
}

fn properties(schema: &Value) -> Option<&Map<String, Value>> {
    schema["properties"].as_object()
}

/// The part of a schema at a path of keys.
fn at<'s>(schema: &'s Value, path: &str) -> &'s Value {
    path.split('/').filter(|key| !key.is_empty()).fold(schema, |schema, key| match key {
        "[]" => &schema["items"],
        "*" => {
            let patterns = schema["patternProperties"].as_object();
            patterns.and_then(|keys| keys.values().next()).unwrap_or(&schema["additionalProperties"])
        }
        key => &schema["properties"][key],
    })
}

/// A description as a table cell.
fn description(schema: &Value) -> String {
    schema["description"].as_str().unwrap_or_default().replace('\n', " ").replace('|', "\\|")
}

fn keys_table<'s>(keys: impl Iterator<Item = (&'s String, &'s Value)>) -> String {
    keys.fold(String::from("| Key | Meaning |\n|---|---|\n"), |mut table, (key, schema)| {
        let _ = writeln!(table, "| `{key}` | {} |", description(schema));
        table
    })
}

/// The fields of a document, and of each type in it.
fn fields(schema: &Value) -> String {
    let mut text = String::new();
    table(schema, &mut text);
    for (name, definition) in schema["$defs"].as_object().into_iter().flatten() {
        let _ = writeln!(text, "\n## {name}\n\n{}\n", description(definition));
        table(definition, &mut text);
    }
    text
}

/// The fields of an object, or the values of an alternative.
fn table(schema: &Value, text: &mut String) {
    let mut rows = String::new();
    add_fields(schema, "", "", &mut rows);
    if alternatives(schema).all(|alternative| properties(alternative).is_none()) && rows.is_empty() {
        let values = alternatives(schema).filter(|value| value["description"].is_string());
        let rows = values.fold(String::new(), |rows, value| {
            rows + &format!("| {} | {} |\n", kind(value), description(value))
        });
        let _ = match rows.as_str() {
            "" => writeln!(text, "Type: {}.", kind(schema)),
            rows => write!(text, "| Value | Meaning |\n|---|---|\n{rows}"),
        };
        return;
    }
    for alternative in alternatives(schema) {
        if properties(alternative).is_some() {
            add_fields(alternative, "", &description(alternative), &mut rows);
        } else {
            let _ = writeln!(rows, "| {} | – | {} |", kind(alternative), description(alternative));
        }
    }
    let _ = write!(text, "| Field | Type | Meaning |\n|---|---|---|\n{rows}");
}

fn alternatives(schema: &Value) -> impl Iterator<Item = &Value> {
    ["oneOf", "anyOf"].iter().filter_map(|key| schema[key].as_array()).flatten()
}

/// The rows of an object's fields; fields of an object inside it follow with both names.
fn add_fields(schema: &Value, outer: &str, about: &str, rows: &mut String) {
    let required = schema["required"].as_array().map_or(&[][..], Vec::as_slice);
    for (name, field) in properties(schema).into_iter().flatten() {
        let optional = if required.iter().any(|key| key == name) { "" } else { ", optional" };
        let meaning = [about, &description(field)].join(" ");
        let _ = writeln!(rows, "| `{outer}{name}` | {}{optional} | {} |", kind(field), meaning.trim());
        add_fields(field, &format!("{outer}{name}."), "", rows);
    }
}

/// The type of a value in words.
fn kind(schema: &Value) -> String {
    if let Some(name) = schema["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/")) {
        return format!("[{name}](#{})", name.to_lowercase());
    }
    if let Some(value) = schema.get("const") {
        return format!("`{}`", value.to_string().trim_matches('"'));
    }
    if let Some(values) = schema["enum"].as_array() {
        let values = values.iter().map(|value| format!("`{}`", value.to_string().trim_matches('"')));
        return values.collect::<Vec<_>>().join(", ");
    }
    let kinds: Vec<String> = alternatives(schema).map(kind).collect();
    if !kinds.is_empty() {
        let mut distinct: Vec<String> = Vec::new();
        for kind in kinds {
            if !distinct.contains(&kind) {
                distinct.push(kind);
            }
        }
        return distinct.join(" or ");
    }
    let simple = |name: &str| match name {
        "array" => match (schema["prefixItems"].as_array(), schema.get("items")) {
            (Some(items), _) => {
                format!("pair of {}", items.iter().map(kind).collect::<Vec<_>>().join(" and "))
            }
            (None, Some(items)) => format!("list of {}", kind(items)),
            (None, None) => "list".to_owned(),
        },
        "object" => {
            let values = schema.get("additionalProperties").filter(|values| values.is_object());
            let values = values.or_else(|| schema["patternProperties"].as_object()?.values().next());
            values
                .map_or_else(|| "object".to_owned(), |values| format!("object with values: {}", kind(values)))
        }
        "integer" => "number".to_owned(),
        name => name.to_owned(),
    };
    match &schema["type"] {
        Value::String(name) => simple(name),
        Value::Array(names) => {
            let names = names.iter().filter_map(Value::as_str).map(simple);
            names.collect::<Vec<_>>().join(" or ")
        }
        _ => "any".to_owned(),
    }
}
