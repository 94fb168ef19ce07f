//! JSON Schemas of network files, generated from the tables that are used for reading. Editors use them for
//! completion and checking.

use serde_json::{Value, json};

use super::bus_keys::{MASTER, NODE, OPTIONS};
use super::network_keys::NETWORK;
use objdict_keyed::schema::{DIALECT, object};

/// The JSON Schema of `bus.yml`, as dcfgen reads it and as ros2_canopen does.
pub fn bus_yml() -> Value {
    let ros = json!({
        "required": ["nodes"],
        "properties": {
            "defaults": object(NODE),
            "nodes": { "type": "object", "additionalProperties": { "$ref": "#/$defs/node" } },
        },
    });
    json!({
        "$schema": DIALECT,
        "title": "bus.yml of dcfgen and ros2_canopen",
        "type": "object",
        "required": ["master"],
        "properties": { "options": object(OPTIONS), "master": object(MASTER) },
        "if": { "required": ["nodes"] },
        "then": ros,
        "else": {
            "patternProperties": { "^\\.": true },
            "additionalProperties": { "$ref": "#/$defs/node", "required": ["dcf"] },
            "properties": { "options": true, "master": true },
        },
        "$defs": { "node": object(NODE) },
    })
}

/// The JSON Schema of `network.toml`.
pub fn network_toml() -> Value {
    let mut schema = object(NETWORK);
    // a node without a file uses the file of its type
    schema["properties"]["node"]["additionalProperties"]["anyOf"] =
        json!([{ "required": ["file"] }, { "required": ["use"] }]);
    if let Some(fields) = schema.as_object_mut() {
        fields.insert("$schema".to_owned(), DIALECT.into());
        fields.insert("title".to_owned(), "network.toml of objdict".into());
        fields.insert("minProperties".to_owned(), 1.into());
    }
    schema
}
