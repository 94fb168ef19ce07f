//! Profiles as JSON; `docs/json.md` describes it.

use std::io::{self, Write};

use serde_json::{Map, Value as Json, json};

use crate::json;
use crate::model::Value;
use crate::profile::{BitField, EntryFacts, Mapping, Need, ObjectFacts, Profile};

/// The version of the documents. It changes when a field is removed or means something else, not when one is added.
const VERSION: u32 = 1;

/// The documents, one a line.
pub(super) fn list<'a>(profiles: impl Iterator<Item = &'a Profile>, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "{{\"version\":{VERSION},\"profiles\":[")?;
    lines(profiles.map(|profile| Json::Object(head(profile))), out)
}

/// A profile, one object a line.
pub(super) fn profile<'a>(
    profile: &Profile,
    objects: impl Iterator<Item = ObjectFacts<'a>>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let head = json::text(&head(profile))?;
    write!(out, "{{\"version\":{VERSION},\"profile\":{head},\"objects\":[")?;
    lines(objects.map(|facts| Json::Object(object(&facts))), out)
}

fn lines(items: impl Iterator<Item = Json>, out: &mut dyn Write) -> io::Result<()> {
    let mut separator = "\n";
    for item in items {
        write!(out, "{separator}{}", json::text(&item)?)?;
        separator = ",\n";
    }
    out.write_all(b"\n]}\n")
}

fn head(profile: &Profile) -> Map<String, Json> {
    let mut fields = Map::new();
    let mut field = |name: &str, value: Json| fields.insert(name.to_owned(), value);
    if profile.group != "custom" {
        field("name", profile.document_number().into());
    }
    field("document", (&*profile.document).into());
    field("title", (&*profile.title).into());
    if let Some(edition) = &profile.version {
        field("edition", (&**edition).into());
    }
    if let Some(number) = profile.number {
        field("number", number.into());
    }
    field("repeats", profile.repeats.into());
    field("count", profile.objects().len().into());
    fields
}

fn object(facts: &ObjectFacts<'_>) -> Map<String, Json> {
    let mut fields = Map::new();
    let mut field = |name: &str, value: Json| fields.insert(name.to_owned(), value);
    field("index", format!("0x{:04X}", facts.first).into());
    if facts.last > facts.first {
        field("last", format!("0x{:04X}", facts.last).into());
    }
    field("name", facts.name.into());
    if facts.states_type() {
        field("object_types", names(facts.object_types));
    }
    field("need", need(facts.need));
    if let Some(only) = facts.only {
        field("only", only.to_string().into());
    }
    if !facts.as_many_as.is_empty() {
        let indexes = facts.as_many_as.iter().map(|index| format!("0x{index:04X}"));
        field("as_many_as", indexes.collect());
    }
    if facts.entries().len() > 0 {
        field("entries", facts.entries().map(|facts| Json::Object(entry(&facts))).collect());
    }
    if let Some(source) = facts.source {
        field("source", source.into());
    }
    fields
}

fn entry(facts: &EntryFacts<'_>) -> Map<String, Json> {
    let mut fields = Map::new();
    let mut field = |name: &str, value: Json| fields.insert(name.to_owned(), value);
    field("sub", format!("0x{:02X}", facts.first).into());
    if facts.last > facts.first {
        field("last", format!("0x{:02X}", facts.last).into());
    }
    if !facts.name.is_empty() {
        field("name", facts.name.into());
    }
    field("need", need(facts.need));
    if !facts.data_types.is_empty() {
        field("data_types", names(facts.data_types));
    }
    if !facts.access.is_empty() {
        field("access", names(facts.access));
    }
    if let Some(mapping) = facts.mapping {
        field("mapping", Mapping::name(mapping).into());
    }
    if !facts.values.is_empty() {
        let bound =
            |number: i128| i64::try_from(number).map_or_else(|_| number.to_string().into(), Json::from);
        field(
            "values",
            facts.values.iter().map(|range| json!([bound(*range.start()), bound(*range.end())])).collect(),
        );
    }
    if let Some(default) = facts.default {
        field("default", value(default));
    }
    if facts.bits().len() > 0 {
        field("bits", facts.bits().map(bits).collect());
    }
    fields
}

fn bits(field: BitField<'_>) -> Json {
    let mut bits = json!({ "first": field.first, "last": field.last, "name": field.name });
    if field.meanings().len() > 0 {
        let meanings = field.meanings().map(
            |(range, meaning)| json!({ "first": range.start(), "last": range.end(), "meaning": meaning }),
        );
        bits["values"] = meanings.collect();
    }
    bits
}

fn names<T: ToString>(items: &[T]) -> Json {
    items.iter().map(ToString::to_string).collect()
}

fn need(need: Need<'_>) -> Json {
    match need {
        Need::Optional => "optional".into(),
        Need::Mandatory => "mandatory".into(),
        Need::When(condition) => format!("if {condition}").into(),
    }
}

/// A default as a number where it is one, else as the text that a table shows.
fn value(value: &Value) -> Json {
    match value {
        Value::Boolean(flag) => Json::from(*flag),
        Value::Signed(number) => Json::from(*number),
        Value::Unsigned(number) => Json::from(*number),
        _ => Json::from(value.to_string()),
    }
}
