//! The keywords and values of `device.toml`: data types, values, and lists of indexes, dummies and lines.

use std::collections::BTreeMap;

use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_keyed::types::{self, TYPES};
pub(super) use objdict_model::json::quoted;
use objdict_model::literal;
use objdict_model::model::{
    DataType, Device, ObjectList, ObjectLists, ObjectType, PdoMapping, TypeKind, Value,
};

/// The keyword for a data type, otherwise its index.
pub(super) fn type_word(data_type: DataType) -> String {
    types::word_of(data_type).map_or_else(|| format!("0x{:04X}", data_type.0), str::to_owned)
}

/// The data type of a word.
pub(super) fn data_type(word: &str) -> Option<DataType> {
    let index = || u16::from_str_radix(word.strip_prefix("0x")?, 16).ok();
    types::named(word).or_else(|| index().map(DataType))
}

/// All data type keywords, for suggestions.
pub(super) fn type_words() -> impl Iterator<Item = &'static str> {
    TYPES.iter().map(|(word, _)| *word).chain(["record", "array"])
}

/// The value of `type`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct TypeSaid {
    /// `None` if it follows from the data type.
    pub(super) object_type: Option<ObjectType>,
    pub(super) data_type: Option<DataType>,
    /// The number of equal elements.
    pub(super) count: Option<u8>,
    /// The length of a `string(20)`.
    pub(super) length: Option<u32>,
}

impl TypeSaid {
    /// Whether it is the type of the object as a whole, with separately described entries.
    pub(super) fn has_subs(&self) -> bool {
        self.count.is_none() && self.object_type.is_some_and(ObjectType::has_subs)
    }

    /// The meaning of a word.
    pub(super) fn parse(word: &str) -> Option<Self> {
        let plain = |data_type| Self { data_type: Some(data_type), ..Self::default() };
        let of = |object_type| Self { object_type: Some(object_type), ..Self::default() };
        if let Some(inner) = word.strip_prefix('[').and_then(|word| word.strip_suffix(']')) {
            let (element, count) = match inner.split_once(';') {
                Some((element, count)) => {
                    (element, Some(count.trim().parse().ok().filter(|count| matches!(count, 1..=254))?))
                }
                None => (inner, None),
            };
            let data_type = Some(data_type(element.trim())?);
            return Some(Self { data_type, count, ..of(ObjectType::Array) });
        }
        if let Some(length) = word.strip_prefix("string(").and_then(|word| word.strip_suffix(')')) {
            let length = Some(length.trim().parse().ok()?);
            return Some(Self { length, ..plain(DataType::VISIBLE_STRING) });
        }
        match word {
            "record" => Some(of(ObjectType::Record)),
            "array" => Some(of(ObjectType::Array)),
            "domain" => Some(Self { object_type: Some(ObjectType::Domain), ..plain(DataType::DOMAIN) }),
            word => data_type(word).map(plain),
        }
    }

    /// Its keyword; `None` if there is none, and the object type needs a separate key.
    pub(super) fn word(&self) -> Option<String> {
        let data_type = self.data_type.map(type_word);
        Some(match (self.object_type, data_type, self.count) {
            (Some(ObjectType::Array), Some(word), Some(count)) => format!("[{word}; {count}]"),
            (Some(ObjectType::Array), Some(word), None) => format!("[{word}]"),
            (Some(ObjectType::Array), None, None) => "array".to_owned(),
            (Some(ObjectType::Record), None, None) => "record".to_owned(),
            (Some(ObjectType::Domain), Some(word), None) if word == "domain" => word,
            (None, Some(word), None) if word != "domain" => match self.length {
                Some(length) if word == "string" => format!("string({length})"),
                _ => word,
            },
            _ => return None,
        })
    }
}

/// The value that a key states for an entry of this type; `None` if it is not valid.
pub(super) fn value_of(tree: &KeyedTree, data_type: Option<DataType>) -> Option<Value> {
    let kind = data_type.map_or(TypeKind::Reserved, DataType::kind);
    let is_open = matches!(kind, TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved);
    match &*tree.kind {
        Kind::Text(text) => match kind {
            TypeKind::VisibleString | TypeKind::UnicodeString => Some(Value::Text(text.as_str().into())),
            _ if is_open => Some(Value::Raw(text.as_str().into())),
            _ if text.is_empty() => match kind {
                TypeKind::OctetString | TypeKind::Domain => Some(Value::Bytes(Box::default())),
                _ => None,
            },
            _ => literal::written(text, data_type?).ok(),
        },
        Kind::Integer(number) => match kind {
            TypeKind::Real32 => Some(Value::Real32(*number as f32)),
            TypeKind::Real64 => Some(Value::Real64(*number as f64)),
            _ if is_open => Some(Value::Raw(number.to_string().into())),
            _ => Value::from_integer(*number, data_type?),
        },
        Kind::Float(number) => match kind {
            TypeKind::Real32 => Some(Value::Real32(*number as f32)),
            TypeKind::Real64 => Some(Value::Real64(*number)),
            _ => None,
        },
        Kind::Bool(flag) => Value::from_integer((*flag).into(), data_type?),
        Kind::Null | Kind::List(_) | Kind::Map(_) => None,
    }
}

/// A value as TOML; `None` if it has no short notation.
pub(super) fn spelled(value: &Value, hex: bool) -> Option<String> {
    Some(match value {
        Value::Boolean(value) => value.to_string(),
        Value::Signed(value) => value.to_string(),
        Value::Unsigned(value) if hex && *value >= 0x80 => format!("0x{value:X}"),
        Value::Unsigned(value) => value.to_string(),
        Value::Real32(value) if !value.is_nan() => format!("{value:?}"),
        Value::Real64(value) if !value.is_nan() => format!("{value:?}"),
        Value::Text(text) | Value::Raw(text) => quoted(text),
        Value::Bytes(bytes) => {
            quoted(&bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" "))
        }
        Value::NodeId(_) => quoted(&value.to_string()),
        Value::Real32(_) | Value::Real64(_) | Value::Time(_) => return None,
    })
}

/// The word for whether PDOs carry an entry.
pub(crate) fn map_word(map: PdoMapping) -> String {
    map.name().to_ascii_lowercase()
}

/// The mapping that a keyword represents.
pub(crate) fn mapping(word: &str) -> Option<PdoMapping> {
    PdoMapping::ALL.into_iter().find(|map| map_word(*map) == word)
}

/// A key, quoted if necessary.
pub(super) fn key(text: &str) -> String {
    let is_bare = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_');
    if !text.is_empty() && text.bytes().all(is_bare) { text.to_owned() } else { quoted(text) }
}

/// Indexes as `1000-1001 1018`.
pub(super) fn index_list(indexes: &[u16]) -> String {
    let mut words: Vec<(u16, u16)> = Vec::new();
    for &index in indexes {
        match words.last_mut() {
            Some((_, last)) if last.checked_add(1) == Some(index) => *last = index,
            _ => words.push((index, index)),
        }
    }
    let word = |(first, last): (u16, u16)| match first == last {
        true => format!("{first:04X}"),
        false => format!("{first:04X}-{last:04X}"),
    };
    words.into_iter().map(word).collect::<Vec<_>>().join(" ")
}

/// What other strings are not, and the correct notation.
pub(super) const NO_INDEXES: [&str; 2] =
    ["a list of indexes", "write indexes of four hex digits, as in `1000-1001 1018`"];

/// The indexes in such a string.
pub(super) fn indexes(text: &str) -> Option<Vec<u16>> {
    let mut indexes = Vec::new();
    for word in text.split_whitespace() {
        let (first, last) = word.split_once('-').unwrap_or((word, word));
        match (index(first), index(last)) {
            (Some(first), Some(last)) if first <= last => indexes.extend(first..=last),
            _ => return None,
        }
    }
    Some(indexes)
}

/// An index in four hex digits.
pub(super) fn index(text: &str) -> Option<u16> {
    let is_index = text.len() == 4 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_index { u16::from_str_radix(text, 16).ok() } else { None }
}

/// A sub-index in one or two hex digits.
pub(super) fn sub(text: &str) -> Option<u8> {
    let is_sub = matches!(text.len(), 1 | 2) && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_sub { u8::from_str_radix(text, 16).ok() } else { None }
}

/// The first and last sub-index of a key.
pub(super) fn subs(text: &str) -> Option<(u8, u8)> {
    let (first, last) = text.split_once('-').unwrap_or((text, text));
    let (first, last) = (sub(first)?, sub(last)?);
    (first <= last).then_some((first, last))
}

/// Adds a line.
pub(super) fn push(text: &mut String, line: &str) {
    text.push_str(line);
    text.push('\n');
}

/// Keywords in quotes.
pub(super) fn words(words: &[&str]) -> String {
    words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(", ")
}

/// The keys of `[lists]`.
pub(super) const NAMES: [(ObjectList, &str); 3] = [
    (ObjectList::Mandatory, "mandatory"),
    (ObjectList::Optional, "optional"),
    (ObjectList::Manufacturer, "manufacturer"),
];

/// The lists derived from the objects.
pub(super) fn implied(device: &Device) -> ObjectLists {
    ObjectLists::naming(device.objects.keys().copied())
}

/// Writes the lists that differ from the derived ones.
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

/// The keywords of the allowed types. If the listed types are unusual, all of them, after `only`.
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

/// The types of these keywords.
pub(super) fn dummies(text: &str) -> Option<BTreeMap<DataType, bool>> {
    let listed = text.strip_prefix("only").filter(|rest| rest.is_empty() || rest.starts_with(' '));
    let usual = DUMMIES.map(|code| (DataType(code), false));
    let mut types: BTreeMap<DataType, bool> =
        if listed.is_none() { usual.collect() } else { BTreeMap::new() };
    for word in listed.unwrap_or(text).split_whitespace() {
        let name = word.strip_prefix('!').unwrap_or(word);
        types.insert(data_type(name)?, name == word);
    }
    Some(types)
}

/// Lines as a triple-quoted string.
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
