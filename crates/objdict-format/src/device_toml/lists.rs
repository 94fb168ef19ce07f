//! The short forms of lists: object lists, dummies, lines of comments.

use std::collections::BTreeMap;

use super::words::{data_type, index_list, quoted, type_word};
use objdict_model::model::{DataType, Device, ObjectList, ObjectLists};

/// The keys of `[lists]`.
pub(super) const NAMES: [(ObjectList, &str); 3] = [
    (ObjectList::Mandatory, "mandatory"),
    (ObjectList::Optional, "optional"),
    (ObjectList::Manufacturer, "manufacturer"),
];

/// The lists that follow from the objects.
pub(super) fn implied(device: &Device) -> ObjectLists {
    ObjectLists::naming(device.objects.keys().copied())
}

/// Writes the lists that do not follow from the objects.
pub(super) fn write(device: &Device, text: &mut String) {
    let implied = implied(device);
    if device.lists == implied {
        return;
    }
    text.push_str("\n[lists]\n");
    let mut unstated = Vec::new();
    for (list, name) in NAMES {
        match device.lists.has(list) {
            true if device.lists.get(list) == implied.get(list) => {}
            true => text.push_str(&format!("{name} = {}\n", quoted(&index_list(device.lists.get(list))))),
            false => unstated.push(quoted(name)),
        }
    }
    if !unstated.is_empty() {
        text.push_str(&format!("unstated = [{}]\n", unstated.join(", ")));
    }
}

/// The data types that CiA 306 lists under `DummyUsage`.
const DUMMIES: std::ops::RangeInclusive<u16> = 1..=7;

/// The words of the types that are allowed. Where others are listed than usual, all of them, after `only`.
pub(super) fn dummy_words(types: &BTreeMap<DataType, bool>) -> String {
    let is_usual = types.keys().map(|data_type| data_type.0).eq(DUMMIES);
    let word = |(data_type, allowed): (&DataType, &bool)| match allowed {
        true => Some(type_word(*data_type)),
        false if is_usual => None,
        false => Some(format!("!{}", type_word(*data_type))),
    };
    let only = (!is_usual).then(|| "only".to_owned());
    only.into_iter().chain(types.iter().filter_map(word)).collect::<Vec<_>>().join(" ")
}

/// The types of these words; the word that is none otherwise.
pub(super) fn dummies(text: &str) -> Result<BTreeMap<DataType, bool>, &str> {
    let listed = text.strip_prefix("only").filter(|rest| rest.is_empty() || rest.starts_with(' '));
    let usual = DUMMIES.map(|code| (DataType(code), false));
    let mut types: BTreeMap<DataType, bool> =
        if listed.is_none() { usual.collect() } else { BTreeMap::new() };
    for word in listed.unwrap_or(text).split_whitespace() {
        let name = word.strip_prefix('!').unwrap_or(word);
        types.insert(data_type(name).ok_or(word)?, name == word);
    }
    Ok(types)
}

/// Lines as a text between triple quotes.
pub(super) fn several_lines(lines: &[String]) -> String {
    let is_plain = |line: &String| {
        !line.starts_with('[') && !line.contains(|c: char| c.is_control() || matches!(c, '"' | '\\'))
    };
    let is_plain = lines.iter().all(is_plain);
    if is_plain {
        return format!("\"\"\"\n{}\"\"\"", lines.join("\n"));
    }
    let lines: Vec<String> = lines.iter().map(|line| quoted(line)).collect();
    format!("[\n    {},\n]", lines.join(",\n    "))
}
