//! What is said of objects, values and rules, as Markdown.

use std::fmt::Write as _;

use objdict_document::describe::Decoder;
use objdict_model::diagnostic::RuleInfo;
use objdict_model::model::{Device, Entry, PdoMapping, Value};
use objdict_profile as profile;
use objdict_profile::{EntryFacts, Need, ObjectFacts, Profile};

/// The page of a rule.
pub(super) fn of_rule(rule: &RuleInfo) -> String {
    let mut text = format!("**{}** ({})\n\n{}", rule.id, rule.severity, rule.page());
    if let Some(address) = rule.address() {
        let _ = write!(text, "\n[{}]({address})", rule.id);
    }
    text
}

/// `6041h:00`, or `6041h` of an object without sub-indexes.
pub(super) fn address(device: &Device, index: u16, sub: Option<u8>) -> String {
    let has_subs = device.object(index).is_some_and(|object| object.object_type().has_subs());
    match sub {
        Some(sub) if has_subs || sub > 0 => format!("{index:04X}h:{sub:02X}"),
        _ => format!("{index:04X}h"),
    }
}

/// The name of an object or an entry in the description, else in the documents.
pub(super) fn name(device: &Device, index: u16, sub: Option<u8>) -> Option<String> {
    let object = device.object(index);
    let Some(object) = object else {
        return profile::of_object(device, index).next().map(|(_, facts)| facts.name.to_owned());
    };
    let entry = sub.filter(|_| object.object_type().has_subs()).and_then(|sub| object.entry(sub));
    Some(match entry {
        Some(entry) => format!("{} / {}", object.name(), entry.name),
        None => object.name().to_owned(),
    })
}

/// An object or an entry: what the description says of it, then what the documents do.
pub(super) fn of_object(device: &Device, index: u16, sub: Option<u8>) -> String {
    let name = name(device, index, sub).unwrap_or_else(|| "not described".to_owned());
    let mut text = format!("**{}** {}\n", address(device, index, sub), one_line(&name));
    if let Some(object) = device.object(index) {
        let entry = object.entry(sub.unwrap_or(0));
        let has_value = sub.is_some() || !object.object_type().has_subs();
        match entry.filter(|_| has_value) {
            Some(entry) => text += &of_entry(device, index, sub.unwrap_or(0), &entry),
            None => {
                let _ =
                    write!(text, "\n{}, {} sub-indexes\n", object.object_type(), object.entries().count());
            }
        }
    }
    for (document, facts) in profile::of_object(device, index) {
        text += &of_facts(device, document, &facts, sub);
    }
    text
}

/// Type, access, mapping and value of an entry.
fn of_entry(device: &Device, index: u16, sub: u8, entry: &Entry) -> String {
    let data_type = entry.implied_type().and_then(|data_type| data_type.name().map(str::to_owned));
    let access = entry.implied_access().map(|access| access.to_string());
    let mapping = entry.pdo_mapping.map(|mapping| match mapping {
        PdoMapping::No => "no PDO".to_owned(),
        _ => match entry.implied_access().map(|access| (access.fits_tpdo(), access.fits_rpdo())) {
            Some((true, false)) => "TPDO".to_owned(),
            Some((false, true)) => "RPDO".to_owned(),
            _ => "PDO".to_owned(),
        },
    });
    let facts: Vec<String> = [data_type, access, mapping].into_iter().flatten().collect();
    let mut text = format!("\n{}\n", facts.join(", "));
    if let Some(value) = entry.value() {
        let _ = writeln!(text, "\n{}", of_value(device, index, sub, value));
    }
    text
}

/// A value as decimal, hex and bits, for the node where that is known, and what it means.
pub(super) fn of_value(device: &Device, index: u16, sub: u8, value: &Value) -> String {
    let node_id = device.node_id();
    let resolved = node_id.and_then(|node_id| value.integer_for(node_id));
    let number = resolved.or_else(|| value.as_integer());
    let mut text = match (value, resolved) {
        (Value::NodeId(base), None) => format!("value `$NODEID+0x{base:X}`"),
        (Value::NodeId(_), Some(number)) => {
            format!("value {} for node {}", spelled(number), node_id.unwrap_or_default())
        }
        (value, _) => {
            number.map_or_else(|| format!("value `{value}`"), |number| format!("value {}", spelled(number)))
        }
    };
    if let Some(meaning) = Decoder::english(device, node_id).of(index, sub, value) {
        let _ = write!(text, "\n\n{}", one_line(&meaning));
    }
    text
}

/// `80 = 0x50 = 0b0101_0000`.
fn spelled(number: i128) -> String {
    if !(0..=i128::from(u64::MAX)).contains(&number) {
        return format!("`{number}`");
    }
    if number > 0xFFFF_FFFF {
        return format!("`{number}` = `0x{number:X}`");
    }
    let bits = format!("{number:b}");
    let width = bits.len().div_ceil(4) * 4;
    let bits = format!("{number:0width$b}");
    let groups: Vec<&str> =
        bits.as_bytes().chunks(4).filter_map(|four| std::str::from_utf8(four).ok()).collect();
    format!("`{number}` = `0x{number:X}` = `0b{}`", groups.join("_"))
}

/// What a document says of an object.
fn of_facts(device: &Device, document: &Profile, facts: &ObjectFacts<'_>, sub: Option<u8>) -> String {
    let section = facts.source.map(|source| format!(", {source}")).unwrap_or_default();
    let need = if facts.is_demanded(device, 0) { "mandatory" } else { "optional" };
    let mut text = format!("\n---\n{}{section}: {}, {need}\n", document.document, facts.name);
    if let Some(about) = facts.about {
        let _ = writeln!(text, "\n{about}");
    }
    if let Some(entry) = facts.entry(sub.unwrap_or(0)).filter(|entry| sub.is_some() || entry.name.is_empty())
    {
        text += &of_entry_facts(&entry);
    }
    text
}

fn of_entry_facts(entry: &EntryFacts<'_>) -> String {
    let types = entry.data_types.iter().filter_map(|data_type| data_type.name());
    let types: Vec<&str> = types.collect();
    let access: Vec<String> = entry.access.iter().map(ToString::to_string).collect();
    let mut facts: Vec<String> = [types.join(" or "), access.join(" or ")].into();
    facts.extend(matches!(entry.need, Need::Mandatory).then(|| "mandatory".to_owned()));
    facts.extend(entry.unit.map(|unit| format!("in {unit}")));
    facts.retain(|fact| !fact.is_empty());
    let mut text = if facts.is_empty() { String::new() } else { format!("\n{}\n", facts.join(", ")) };
    for field in entry.bits() {
        let bits = match (field.first, field.last) {
            (first, last) if first == last => format!("bit {first}"),
            (first, last) => format!("bits {first} to {last}"),
        };
        let _ = writeln!(text, "- {bits}: {}", field.name);
    }
    text
}

fn one_line(text: &str) -> String {
    // a name is data, so it is no markup
    objdict_model::diagnostic::one_line(text).replace(['*', '_', '`', '<'], " ")
}
