//! The tables of plain properties: keys that are fields of a part of the model, with hyphens instead of JSON's
//! underscores.

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

use super::words::{key, quoted};
use objdict_keyed::rules::WRONG_TYPE;
use objdict_keyed::section::{Key, KeyedTable, Shape};
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::{Diagnostic, Findings, say};

/// The value of a field whose key is missing.
pub(super) type Implied = (&'static str, Value);

/// The file information of a generated file.
pub(super) fn implied_file() -> Vec<Implied> {
    vec![("file-version", json!(1)), ("file-revision", json!(0)), ("eds-version", json!("4.0"))]
}

/// The device information of most devices.
pub(super) fn implied_device(rpdos: u16, tpdos: u16) -> Vec<Implied> {
    vec![
        ("simple-boot-up-master", json!(false)),
        ("simple-boot-up-slave", json!(true)),
        ("granularity", json!(8)),
        ("dynamic-channels-supported", json!(0)),
        ("group-messaging", json!(false)),
        ("rpdo-count", json!(rpdos)),
        ("tpdo-count", json!(tpdos)),
        ("lss-supported", json!(false)),
    ]
}

/// The part that a section describes; `None` means a section without keys.
pub(super) fn read<T: DeserializeOwned + Default>(
    section: Option<&KeyedTable<'_>>,
    keys: &'static [Key],
    implied: &[Implied],
    findings: &mut Findings,
) -> T {
    let has_unstated = keys.iter().any(|key| key.name == "unstated");
    let unstated = section.filter(|_| has_unstated).map(|section| section.texts("unstated", findings));
    let unstated = unstated.unwrap_or_default();
    let mut fields = Map::new();
    for (name, value) in implied {
        if !unstated.iter().any(|unstated| unstated.value == *name) {
            fields.insert(field(name), value.clone());
        }
    }
    for known in keys {
        let Some((section, tree)) = section.and_then(|section| Some((section, section.get(known.name)?)))
        else {
            continue;
        };
        let Some((name, value)) = stated(known, section, tree, findings) else { continue };
        let mut alone = Map::new();
        alone.insert(name.clone(), value.clone());
        match parse::<T>(alone) {
            Ok(_) => {
                fields.insert(name, value);
            }
            Err(error) => {
                let message = say!("`{}` is not valid: {}", known.name, error);
                findings.push(Diagnostic::new(&WRONG_TYPE, tree.span, message).help("correct the value"));
            }
        }
    }
    parse(fields).unwrap_or_default()
}

fn parse<T: DeserializeOwned>(fields: Map<String, Value>) -> Result<T, String> {
    // from a string, because a second deserializer would add a megabyte of code
    serde_json::from_str(&Value::Object(fields).to_string()).map_err(|error| {
        let text = error.to_string();
        text.split(" at line ").next().unwrap_or_default().to_owned()
    })
}

/// The field of a key with its value in JSON.
fn stated(
    key: &Key,
    section: &KeyedTable<'_>,
    tree: &KeyedTree,
    findings: &mut Findings,
) -> Option<(String, Value)> {
    let value = match (key.name, &key.shape) {
        ("unstated", _) => return None,
        ("bit-rates", _) => return Some(("baud_rates".to_owned(), bit_rates(tree))),
        ("extra", _) => pairs(tree),
        (name, Shape::Flag) => section.flag(name, findings)?.value.into(),
        (name, Shape::Integer(..)) => section.integer::<i64>(name, findings)?.value.into(),
        (name, Shape::Texts) => {
            section.texts(name, findings).into_iter().map(|text| Value::from(text.value)).collect()
        }
        (name, _) => section.text(name, findings)?.value.into(),
    };
    Some((field(key.name), value))
}

/// The name of a key in JSON.
pub(super) fn field(key: &str) -> String {
    if key == "bit-rates" { "baud_rates".to_owned() } else { key.replace('-', "_") }
}

/// The bit rates of a list: all other rates of CiA 301 are not supported.
fn bit_rates(tree: &KeyedTree) -> Value {
    let one = std::slice::from_ref(tree);
    let listed = match &*tree.kind {
        Kind::List(items) => items.as_slice(),
        _ => one,
    };
    let mut rates: Map<String, Value> = objdict_model::model::BaudRates::DEFINED
        .iter()
        .map(|rate| (rate.to_string(), false.into()))
        .collect();
    rates.extend(listed.iter().map(|rate| (rate.spelled(), true.into())));
    Value::Object(rates)
}

/// Pairs of strings from a table, or from a list if keys are repeated.
pub(super) fn pairs(tree: &KeyedTree) -> Value {
    if let Kind::List(items) = &*tree.kind {
        let pair = |item: &KeyedTree| match &*item.kind {
            Kind::List(pair) => pair.iter().map(|text| Value::from(text.spelled())).collect(),
            _ => json!([item.spelled(), ""]),
        };
        return items.iter().map(pair).collect();
    }
    let entries = tree.entries().unwrap_or_default().iter();
    entries.map(|entry| json!([entry.key.spelled(), entry.value.spelled()])).collect()
}

/// Pairs of strings as a table, or as a list if a key is repeated.
pub(super) fn table_of_pairs(pairs: &[(&str, &str)]) -> String {
    let mut seen = std::collections::BTreeSet::new();
    let is_table = pairs.iter().all(|(name, _)| seen.insert(name));
    let item = |&(name, value): &(&str, &str)| match is_table {
        true => format!("{} = {}", key(name), quoted(value)),
        false => format!("[{}, {}]", quoted(name), quoted(value)),
    };
    let items = pairs.iter().map(item).collect::<Vec<_>>().join(", ");
    if is_table { format!("{{ {items} }}") } else { format!("[{items}]") }
}

/// The lines of a part: values that differ from the implied ones.
pub(super) fn lines(part: &impl Serialize, keys: &[Key], implied: &[Implied]) -> Vec<String> {
    let Ok(Value::Object(fields)) = serde_json::to_value(part) else { return Vec::new() };
    let mut lines = Vec::new();
    let mut unstated = Vec::new();
    for known in keys {
        let usual = implied.iter().find(|(name, _)| *name == known.name).map(|(_, value)| value);
        match (fields.get(&field(known.name)), usual) {
            (None, Some(_)) => unstated.push(quoted(known.name)),
            (Some(value), usual) if Some(value) != usual => {
                lines.extend(spelled(known, value).map(|value| format!("{} = {value}", known.name)));
            }
            _ => {}
        }
    }
    if !unstated.is_empty() {
        lines.push(format!("unstated = [{}]", unstated.join(", ")));
    }
    lines
}

fn spelled(key: &Key, value: &Value) -> Option<String> {
    match (key.name, value) {
        ("bit-rates", Value::Object(rates)) => {
            let listed = rates.iter().filter(|(_, supported)| **supported == Value::Bool(true));
            let mut listed: Vec<&String> = listed.map(|(rate, _)| rate).collect();
            listed.sort_by_key(|rate| rate.parse().unwrap_or(u32::MAX));
            let word = |rate: &String| if rate.parse::<u16>().is_ok() { rate.clone() } else { quoted(rate) };
            Some(format!("[{}]", listed.into_iter().map(word).collect::<Vec<_>>().join(", ")))
        }
        ("extra", Value::Array(pairs)) => {
            let texts =
                pairs.iter().filter_map(|pair| Some((pair.get(0)?.as_str()?, pair.get(1)?.as_str()?)));
            Some(table_of_pairs(&texts.collect::<Vec<_>>()))
        }
        (_, Value::String(text)) => Some(quoted(text)),
        (_, Value::Array(items)) => {
            let texts: Option<Vec<String>> = items.iter().map(|item| item.as_str().map(quoted)).collect();
            Some(format!("[{}]", texts?.join(", ")))
        }
        (name, Value::Number(number)) if name.ends_with("-number") && number.as_u64() > Some(0xFFFF) => {
            Some(format!("0x{:X}", number.as_u64()?))
        }
        (_, Value::Number(_) | Value::Bool(_)) => Some(value.to_string()),
        _ => None,
    }
}
