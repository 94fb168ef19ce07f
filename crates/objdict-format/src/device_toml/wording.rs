//! The terms of CiA 306 in findings, as the keys of `device.toml`.

use super::edits::stated_of;
use super::keys::{DEVICE, FILE, NODE, OBJECT};
use super::places::keys_of;
use objdict_keyed::section::Key;
use objdict_model::diagnostic::Notion;
use objdict_model::model::{DataType, Field, Part};

/// The tables that a field may be in, with the keys of each.
const TABLES: [(Part, &[Key]); 4] = [
    (Part::Object(0), OBJECT),
    (Part::DeviceInfo, DEVICE),
    (Part::FileInfo, FILE),
    (Part::Commissioning, NODE),
];

/// The sections of CiA 306 that are tables with a different name.
const SECTIONS: [(&str, &str); 7] = [
    ("FileInfo", "[file]"),
    ("DeviceInfo", "[device]"),
    ("DeviceComissioning", "[node]"),
    ("MandatoryObjects", "[lists]"),
    ("OptionalObjects", "[lists]"),
    ("ManufacturerObjects", "[lists]"),
    ("DummyUsage", "dummies"),
];

const WORDS: [(&str, &str); 3] = [("section", "table"), ("a section", "a table"), ("sections", "tables")];

/// The term of `device.toml` for a term of CiA 306.
pub fn words(notion: &Notion<'_>) -> Option<String> {
    match *notion {
        Notion::Key(name) => Some(key(name)?.2),
        Notion::Setting(name, text) => {
            let (_, _, key) = key(name)?;
            Some(format!("{key} = {}", value(name, text).unwrap_or_else(|| "…".to_owned())))
        }
        Notion::ValueOf(name, text) => value(name, text).map(|value| value.trim_matches('"').to_owned()),
        Notion::Section(name) => section(name),
        Notion::Word(word) => WORDS.iter().find(|(eds, _)| *eds == word).map(|(_, toml)| (*toml).to_owned()),
    }
}

/// The part and the field that have this name in CiA 306, and the key.
fn key(name: &str) -> Option<(&'static Part, Field, String)> {
    let field = Field::from_name(name);
    if field == Field::DataType {
        return Some((&TABLES[0].0, field, "type".to_owned()));
    }
    TABLES.iter().find_map(|(part, keys)| {
        let key =
            keys_of(part, &field).into_iter().find(|key| keys.iter().any(|known| known.name == *key))?;
        Some((part, field.clone(), key))
    })
}

fn value(name: &str, text: &str) -> Option<String> {
    let (part, field, key) = key(name)?;
    if key == "bit-rates" {
        return Some(format!("[{}]", name.rsplit('_').next()?));
    }
    if text.is_empty() {
        return Some("\"…\"".to_owned());
    }
    stated_of(Some(DataType::INTEGER64), part, &field, text).map(|(_, value)| value)
}

/// The table of a section: for `1018` and `1018sub1`, that of the object.
fn section(name: &str) -> Option<String> {
    if let Some((_, table)) = SECTIONS.iter().find(|(known, _)| *known == name) {
        return Some((*table).to_owned());
    }
    let is_hex = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    match name.split_once("sub") {
        Some((index, sub)) if is_hex(index) && is_hex(sub) => Some(format!("[object.{index:0>4}.sub.{sub}]")),
        None if is_hex(name) => Some(format!("[object.{name:0>4}]")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_model::diagnostic::say;

    #[test]
    fn keys_become_those_of_toml() {
        for (eds, toml) in [
            (say!("`{LowLimit}` is 5, but `{HighLimit}` is 2"), "`min` is 5, but `max` is 2"),
            (
                say!("write `{PDOMapping=1}`, or `{PDOMapping=0}`"),
                "write `map = \"optional\"`, or `map = \"no\"`",
            ),
            (say!("write `{AccessType=rw}`"), "write `access = \"rw\"`"),
            (say!("add `{DataType=0x0007}`, not `{DataType:0x0005}`"), "add `type = \"u32\"`, not `u8`"),
            (say!("write `{ParameterName=}` and a name"), "write `name = \"…\"` and a name"),
            (say!("`{[DeviceInfo]}` has no `{VendorNumber}`"), "`[device]` has no `vendor-number`"),
            (
                say!("write `{VendorNumber=0x59}`, `{BaudRate_125=1}`"),
                "write `vendor-number = 0x59`, `bit-rates = [125]`",
            ),
            (say!("add {a section} `{[1018sub1]}`"), "add a table `[object.1018.sub.1]`"),
            (say!("{LSS_Supported:1}: write `{LSS_Supported=0}`"), "true: write `lss-supported = false`"),
            (say!("write `{ObjectType=0x9}`"), "write `object-type = \"record\"`"),
        ] {
            assert_eq!(eds.in_words(words), toml);
        }
    }
}
