//! JSON Schemas of the key tables.

use serde_json::{Map, Value, json};

use super::notation::{PARTS, TIME};
use super::section::{Key, Notation, Shape};
use super::types::TYPES;

/// The dialect of the schemas.
pub const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";

/// A map with these keys and no others.
pub fn object(keys: &[Key]) -> Value {
    let mut properties: Map<String, Value> =
        keys.iter().map(|key| (key.name.to_owned(), property(key))).collect();
    for (key, former) in keys.iter().filter_map(|key| Some((key, key.former?))) {
        let mut property = shape(&key.shape);
        property["description"] = format!("A former name of `{}`.", key.name).into();
        property["deprecated"] = true.into();
        properties.insert(former.to_owned(), property);
    }
    let required: Vec<&str> = keys.iter().filter(|key| key.is_required).map(|key| key.name).collect();
    let mut map = json!({ "type": "object", "properties": null, "additionalProperties": false });
    map["properties"] = properties.into();
    if !required.is_empty() {
        map["required"] = required.into();
    }
    map
}

fn property(key: &Key) -> Value {
    let mut value = shape(&key.shape);
    if let Some(fields) = value.as_object_mut() {
        fields.insert("description".to_owned(), key.meaning.into());
    }
    value
}

/// A string in a notation.
pub fn text(notation: Notation) -> Value {
    let types = TYPES.map(|(word, _)| word).join("|");
    let parts = PARTS.iter().fold(notation.to_owned(), |text, (name, part)| text.replace(name, part));
    json!({ "type": "string", "pattern": parts.replace("{words}", &types) })
}

/// Accepts one of these, or a list of them.
pub fn one_or_list(item: &Value) -> Value {
    json!({ "anyOf": [item, { "type": "array", "items": item }] })
}

fn shape(shape: &Shape) -> Value {
    match shape {
        Shape::Integer(low, high) => integer(*low, *high),
        Shape::Number => json!({ "type": "number", "exclusiveMinimum": 0 }),
        Shape::Flag => json!({ "anyOf": [{ "type": "boolean" }, { "enum": [0, 1] }] }),
        Shape::Spelled(notation) => text(notation),
        Shape::AllSpelled(notation) => one_or_list(&text(notation)),
        Shape::IntegerOrText(low, high, form) => json!({ "anyOf": [integer(*low, *high), text(form)] }),
        Shape::SpelledByName(notation) => with("object", "additionalProperties", text(notation)),
        Shape::ValuesOf(notation) => {
            json!({ "additionalProperties": self::shape(&Shape::Value), "propertyNames": text(notation), "type": "object" })
        }
        Shape::Text => json!({ "type": ["string", "number"] }),
        Shape::Word(words) => json!({ "enum": words }),
        Shape::IntegerOr(low, high, word) => {
            json!({ "anyOf": [integer(*low, *high), { "const": word }] })
        }
        Shape::Value => json!({ "type": ["integer", "number", "string", "boolean"] }),
        Shape::Time(high, _) => json!({ "anyOf": [integer(0, *high), text(TIME)] }),
        Shape::ValueOrList => one_or_list(&self::shape(&Shape::Value)),
        Shape::Values => with("object", "additionalProperties", self::shape(&Shape::Value)),
        Shape::ValuesOrList => {
            json!({ "anyOf": [self::shape(&Shape::Values), { "type": "array", "items": self::shape(&Shape::Value) }] })
        }
        Shape::Texts => one_or_list(&json!({ "type": "string" })),
        Shape::Numerals(low, high) => json!({ "type": "array", "items": integer(*low, *high) }),
        Shape::Map(keys) => object(keys),
        Shape::Named(keys) => with("object", "additionalProperties", object(keys)),
        Shape::List(keys) => with("array", "items", object(keys)),
        Shape::Numbered(low, high, keys) => by_number(*low, *high, object(keys)),
        Shape::Numbers((low, high), values) => by_number(*low, *high, integer(values.0, values.1)),
        Shape::Foreign => json!({}),
    }
}

/// A type with a field that is moved: `json!` would copy it at each level.
fn with(type_name: &str, key: &str, value: Value) -> Value {
    let mut map = json!({ "type": type_name });
    map[key] = value;
    map
}

fn integer(low: i128, high: i128) -> Value {
    // all ranges belong to 32-bit objects
    json!({ "type": "integer", "minimum": i64::try_from(low).ok(), "maximum": i64::try_from(high).ok() })
}

/// A map by number. JSON keys are strings, so the pattern covers the numbers of the range: shorter ones, those that are
/// less at a digit, and the highest.
fn by_number(low: i128, high: i128, values: Value) -> Value {
    let highest = high.to_string();
    let mut numbers = if low == 0 { vec!["0".to_owned()] } else { Vec::new() };
    numbers.extend((1..highest.len()).map(|digits| format!("[1-9][0-9]{{{}}}", digits - 1)));
    for (at, digit) in highest.char_indices() {
        let (first, behind) = (if at == 0 { '1' } else { '0' }, highest.len() - at - 1);
        let less = (first..digit).last();
        numbers.extend(less.map(|last| format!("{}[{first}-{last}][0-9]{{{behind}}}", &highest[..at])));
    }
    let pattern = format!("^({}|{highest})$", numbers.join("|"));
    let mut map = with("object", "patternProperties", Map::from_iter([(pattern, values)]).into());
    map["additionalProperties"] = false.into();
    map
}
