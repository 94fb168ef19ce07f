//! The JSON Schema of tables of answers.

use serde_json::{Value, json};

use super::answers::{ABORT, ACTION, BYTES, INDEX, SENT, SIZE, SUB, VALUE};

/// The schema of the JSON that [`read_answers`](super::read_answers) takes. Other fields of a row are skipped.
pub fn answers_schema() -> Value {
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": "urn:objdict:answers:1",
        "title": "Answers of a device",
        "description": "Answers of a device, which `objdict probe --answers` judges: a list of rows, or an object with this list in `answers`.",
        "anyOf": [
            { "type": "array", "items": { "$ref": "#/$defs/Row" } },
            {
                "type": "object",
                "properties": {
                    "answers": {
                        "description": "The rows, in the order of the requests.",
                        "type": "array",
                        "items": { "$ref": "#/$defs/Row" },
                    },
                },
                "required": ["answers"],
            },
        ],
        "$defs": { "Row": row() },
    })
}

fn row() -> Value {
    json!({
        "description": "A request and its answer; without `bytes`, `value`, `abort` and `size`, a request that was not answered.",
        "type": "object",
        "properties": {
            INDEX: address("The index, as a number or a hexadecimal text: `1018`, `0x1018`, `1018h`.", 0xFFFF),
            SUB: address("The sub-index, as a number or a hexadecimal text.", 0xFF),
            ACTION: {
                "description": "What was asked; absent: to read.",
                "enum": ["read", "upload", "write", "download", null],
            },
            SENT: bytes("The bytes of a write, as hexadecimal digits or numbers."),
            BYTES: bytes("The bytes of the answer as they were transferred, as hexadecimal digits or numbers."),
            VALUE: {
                "description": "Instead of `bytes`: a number or a text of the entry's type, the bytes as numbers, or `abort` and a code.",
                "anyOf": [{ "type": ["number", "string", "boolean", "null"] }, octets()],
            },
            ABORT: address("The abort code, as a number or a hexadecimal text.", u32::MAX),
            SIZE: {
                "description": "The number of bytes, if the value is not known, or that were accepted.",
                "anyOf": [
                    { "type": "integer", "minimum": 0 },
                    { "type": "string", "pattern": r"^\s*\+?[0-9]+\s*$" },
                    { "type": "null" },
                ],
            },
        },
        "required": [INDEX, SUB],
    })
}

/// A number, or its hexadecimal text.
fn address(description: &str, highest: u32) -> Value {
    let digits = format!("{highest:X}").len();
    let mut kinds = vec![
        json!({ "type": "integer", "minimum": 0, "maximum": highest }),
        json!({ "type": "string", "pattern": format!(r"^\s*(0[xX])?0*[0-9A-Fa-f]{{1,{digits}}}[hH]?\s*$") }),
    ];
    // a row without a code was not aborted
    if highest == u32::MAX {
        kinds.push(json!({ "type": "null" }));
    }
    json!({ "description": description, "anyOf": kinds })
}

fn bytes(description: &str) -> Value {
    let digits = json!({ "type": "string", "pattern": r"^ *([0-9A-Fa-f] *[0-9A-Fa-f] *)*$" });
    json!({ "description": description, "anyOf": [digits, octets(), { "type": "null" }] })
}

fn octets() -> Value {
    json!({ "type": "array", "items": { "type": "integer", "minimum": 0, "maximum": 255 } })
}
