//! The JSON Schemas of the documents that objdict writes, made of the types that write them.

use std::fs;
use std::path::Path;

#[cfg(test)]
use serde_json::Value;

/// Writes the schemas, or with `check` fails when one is not what it would write.
pub(crate) fn run(check: bool) -> Result<(), String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../schemas");
    let schemas = objdict::cli::schemas();
    for (name, schema) in &schemas {
        let (path, shown) = (folder.join(format!("{name}.json")), format!("schemas/{name}.json"));
        let text = format!("{schema:#}\n");
        if check {
            let current =
                fs::read_to_string(&path).map_err(|error| format!("cannot read {shown}: {error}"))?;
            if current != text {
                return Err(format!("{shown} is stale: run `cargo xtask docs`"));
            }
        } else if fs::read_to_string(&path).is_ok_and(|current| current == text) {
            // what is part of the program is compiled again when it is written
        } else {
            fs::write(&path, text).map_err(|error| format!("cannot write {shown}: {error}"))?;
        }
    }
    let files = fs::read_dir(&folder).map_err(|error| format!("cannot read schemas: {error}"))?;
    let left: Vec<String> = files
        .filter_map(|file| file.ok()?.file_name().into_string().ok())
        .filter(|file| !schemas.iter().any(|(name, _)| file == &format!("{name}.json")))
        .collect();
    if left.is_empty() { Ok(()) } else { Err(format!("of no document: schemas/{}", left.join(", schemas/"))) }
}

/// The fields without a description, by their paths. The description of an alternative is that of its key.
#[cfg(test)]
fn undescribed(schema: &Value, path: &str, is_alternative: bool, found: &mut Vec<String>) {
    let Value::Object(fields) = schema else { return };
    for (key, value) in fields {
        let path = format!("{path}/{key}");
        match (key.as_str(), value) {
            ("properties", Value::Object(properties)) => {
                for (name, property) in properties {
                    let path = format!("{path}/{name}");
                    if !is_alternative && property["description"].as_str().is_none_or(str::is_empty) {
                        found.push(path.clone());
                    }
                    undescribed(property, &path, false, found);
                }
            }
            ("$defs" | "patternProperties", Value::Object(schemas)) => {
                schemas
                    .iter()
                    .for_each(|(name, schema)| undescribed(schema, &format!("{path}/{name}"), false, found));
            }
            ("oneOf" | "anyOf", Value::Array(schemas)) => {
                for schema in schemas {
                    undescribed(schema, &path, schema["description"].is_string(), found);
                }
            }
            ("items" | "additionalProperties", schema) => undescribed(schema, &path, false, found),
            _ => {}
        }
    }
}

#[test]
fn the_schemas_are_those_of_the_types() {
    assert_eq!(run(true), Ok(()));
}

#[test]
fn every_field_is_described() {
    let mut found = Vec::new();
    for (name, schema) in objdict::cli::schemas() {
        let version = &schema["properties"]["version"]["const"];
        // people write it: its version is in the key `format`, and its tables of keys describe it
        if name == "patch" {
            continue;
        }
        // a bench writes it, without a version
        if name != "answers" {
            assert_eq!(schema["$id"], format!("urn:objdict:{name}:{version}"));
        }
        undescribed(&schema, name, false, &mut found);
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
