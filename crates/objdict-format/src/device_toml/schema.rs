//! The JSON Schema of `device.toml`, made of the tables that it is read by.

use serde_json::{Value, json};

use super::keys::{ENTRY, OBJECT, root, variant_keys};
use objdict_keyed::schema::{DIALECT, object};

/// The JSON Schema of `device.toml`, by which editors complete and check it.
pub fn schema() -> Value {
    let mut schema = object(root());
    refine(&mut schema["properties"]);
    let mut variant = object(variant_keys());
    refine(&mut variant["properties"]);
    schema["properties"]["variant"]["additionalProperties"] = variant;
    if let Some(fields) = schema.as_object_mut() {
        fields.insert("$schema".to_owned(), DIALECT.into());
        fields.insert("title".to_owned(), "device.toml of objdict".into());
    }
    schema
}

/// Says of tables by address what their keys are.
fn refine(properties: &mut Value) {
    let by_hex = |digits: &str, values: Value| json!({ "type": "object", "patternProperties": { digits: values }, "additionalProperties": false });
    let mut of_object = object(OBJECT);
    with_meaning(
        &mut of_object["properties"]["sub"],
        by_hex("^[0-9A-Fa-f]{1,2}(-[0-9A-Fa-f]{1,2})?$", object(ENTRY)),
    );
    with_meaning(&mut properties["object"], by_hex("^[0-9A-Fa-f]{4}$", of_object));
    with_meaning(&mut properties["raw"], by_hex("^/", json!({})));
    with_meaning(&mut properties["extra"], json!({ "type": ["object", "array"] }));
    let addresses = json!({ "type": "array", "items": { "type": "string" } });
    let reasons = json!({ "type": "object", "additionalProperties": { "type": "string" } });
    with_meaning(&mut properties["remove"], json!({ "anyOf": [addresses, reasons] }));
}

/// Replaces a schema, but for its description.
fn with_meaning(schema: &mut Value, new: Value) {
    let meaning = schema["description"].take();
    *schema = new;
    schema["description"] = meaning;
}
