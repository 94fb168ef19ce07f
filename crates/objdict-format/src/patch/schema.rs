//! The JSON Schema of patches.

use serde_json::{Value, json};

use super::keys::PATCH;
use objdict_keyed::schema::{DIALECT, object};

/// The schema of a patch.
pub fn patch() -> Value {
    let mut schema = object(PATCH);
    let changes = ["set", "unset", "add", "rename"].map(|key| json!({ "required": [key] }));
    let removal = json!({ "required": ["remove"], "properties": { "remove": { "enum": [true, 1] } } });
    schema["properties"]["change"]["items"]["anyOf"] = changes.into_iter().chain([removal]).collect();
    if let Some(fields) = schema.as_object_mut() {
        fields.insert("$schema".to_owned(), DIALECT.into());
        fields.insert("$id".to_owned(), "urn:objdict:patch:1".into());
        fields.insert("title".to_owned(), "A patch of device descriptions".into());
    }
    schema
}
