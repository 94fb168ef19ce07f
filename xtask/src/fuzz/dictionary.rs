//! The words of the formats, from the tables that the readers use: mutations rarely make a key by chance.

use std::collections::BTreeSet;

use objdict::format::XddVersion;
use objdict::format::network::schema;
use objdict::model::{Access, DataType, Field, ModulePart, ObjectList, ObjectType, Part};
use objdict_model::diagnostic::section_name;
use serde_json::Value;

use super::seeds::Seed;
use crate::mutate::VALUES;

/// libFuzzer leaves out longer words.
const LONGEST: usize = 64;

/// The parts with a section of CiA 306-1, one of each kind.
const SECTIONS: [Part; 26] = [
    Part::FileInfo,
    Part::DeviceInfo,
    Part::DummyUsage,
    Part::Comments,
    Part::Commissioning,
    Part::List(ObjectList::Mandatory),
    Part::List(ObjectList::Optional),
    Part::List(ObjectList::Manufacturer),
    Part::Object(0x2000),
    Part::Entry(0x2000, 1),
    Part::CompactNames(0x2000),
    Part::CompactValues(0x2000),
    Part::CompactDenotations(0x2000),
    Part::Links(0x2000),
    Part::SupportedModules,
    Part::ConnectedModules,
    Part::Module(1, ModulePart::Info),
    Part::Module(1, ModulePart::Comments),
    Part::Module(1, ModulePart::FixedObjects),
    Part::Module(1, ModulePart::Fixed(0x2000)),
    Part::Module(1, ModulePart::FixedEntry(0x2000, 1)),
    Part::Module(1, ModulePart::SubExtends),
    Part::Module(1, ModulePart::SubExt(0x2000)),
    Part::DynamicChannels,
    Part::Tools,
    Part::Tool(1),
];

/// Each word once. JSON and TOML have the keys of the seeds.
pub(super) fn words(seeds: &[Seed]) -> Vec<String> {
    let mut words = BTreeSet::new();
    words.extend(SECTIONS.iter().map(|part| format!("\n[{}]\n", section_name(part))));
    words.extend(Field::NAMED.iter().map(|(name, _)| format!("\n{name}=")));
    words.extend(DataType::STATIC.iter().filter_map(|data_type| data_type.name()).map(str::to_owned));
    words.extend(Access::ALL.map(|access| access.name().to_owned()));
    words.extend((0..=u8::MAX).filter_map(ObjectType::from_code).map(|kind| kind.name().to_owned()));
    for version in XddVersion::ALL {
        words.extend(names_of(&objdict_xdd::xdd::xsd(version)));
    }
    for schema in [schema::bus_yml(), schema::network_toml(), objdict::format::patch::schema::patch()] {
        of_schema(&schema, &mut words);
    }
    for seed in seeds {
        let Ok(text) = str::from_utf8(&seed.bytes) else { continue };
        let value: Option<Value> = match &*seed.ending {
            "json" => serde_json::from_str(text).ok(),
            "toml" => toml::from_str(text).ok(),
            _ => None,
        };
        keys(&value.unwrap_or_default(), &mut words);
    }
    words.extend(VALUES.map(str::to_owned));
    words.into_iter().filter(|word| (1..=LONGEST).contains(&word.len())).collect()
}

/// The elements, attributes and enumerated values of an XML Schema, and the types that documents name.
fn names_of(xsd: &str) -> impl Iterator<Item = String> {
    const DECLARED: [&str; 4] =
        ["element name=", "attribute name=", "enumeration value=", "complexType name=\"ProfileBody"];
    let tags = xsd.split("<xs:").filter(|tag| DECLARED.iter().any(|declared| tag.starts_with(declared)));
    tags.filter_map(|tag| tag.split('"').nth(1)).map(str::to_owned)
}

/// The properties and enumerated values of a JSON Schema.
fn of_schema(schema: &Value, words: &mut BTreeSet<String>) {
    match schema {
        Value::Object(fields) => {
            for (name, value) in fields {
                match (&**name, value) {
                    ("properties", Value::Object(properties)) => words.extend(properties.keys().cloned()),
                    ("enum", Value::Array(values)) => {
                        words.extend(values.iter().filter_map(Value::as_str).map(str::to_owned));
                    }
                    _ => {}
                }
                of_schema(value, words);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| of_schema(value, words)),
        _ => {}
    }
}

/// The keys of a document, and the names that an author gave.
fn keys(value: &Value, words: &mut BTreeSet<String>) {
    match value {
        Value::Object(fields) => {
            for (name, value) in fields {
                // others are indexes
                if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
                    words.insert(name.clone());
                }
                keys(value, words);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| keys(value, words)),
        _ => {}
    }
}

/// A word as a line of a dictionary of libFuzzer.
pub(super) fn line(word: &str) -> String {
    let bytes = word.bytes().map(|byte| match byte {
        b'"' | b'\\' => format!("\\{}", char::from(byte)),
        b' '..=b'~' => char::from(byte).to_string(),
        _ => format!("\\x{byte:02X}"),
    });
    format!("\"{}\"\n", bytes.collect::<String>())
}
