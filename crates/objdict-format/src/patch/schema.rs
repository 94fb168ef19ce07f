//! The JSON Schema of patches.

use serde_json::{Value, json};

use super::keys::PATCH;
use objdict_keyed::schema::{DIALECT, object};

/// The schema of a patch.
pub fn patch() -> Value {
    let mut schema = object(PATCH);
    if let Some(fields) = schema.as_object_mut() {
        fields.insert("$schema".to_owned(), DIALECT.into());
        fields.insert("$id".to_owned(), "urn:objdict:patch:1".into());
        fields.insert("title".to_owned(), "A patch of device descriptions".into());
        fields.insert("required".to_owned(), json!(["format"]));
    }
    schema
}
