//! The keywords for fields of a device in files that users write, and the allowed keys.
//!
//! A new word of a field also needs its arms in `fields` and a row in `field_names`; `cargo xtask docs` writes the page.

use objdict_keyed::section::{Key, Shape, bits, key};
use objdict_keyed::types::{self, ACCESS, OBJECT_TYPES};
use objdict_model::literal::written_number;
use objdict_model::model::field_names::{self, COMMISSIONING, DEVICE, FILE};
use objdict_model::model::{DataType, ObjectType, Part};

/// The fields of an object or entry.
pub(crate) const ENTRY: &[Key] = &[
    key("name", Shape::Text, "The name."),
    key("object-type", Shape::Word(OBJECT_TYPES), "The object type."),
    key(
        "type",
        Shape::Text,
        "The data type: `u16`, `i32`, `f32`, `bool`, `string`, `bytes`, `domain`, a name of CiA 301, or its index.",
    ),
    key("access", Shape::Word(ACCESS), "The access of the network."),
    key("default", Shape::Value, "The default value: a number, a text, or `$NODEID+n`."),
    key("value", Shape::Value, "The configured value of a node."),
    key("min", Shape::Value, "The low limit."),
    key("max", Shape::Value, "The high limit."),
    key(
        "map",
        Shape::Value,
        "Whether PDOs may carry the entry: `true`, `false`, `default`, `tpdo` or `rpdo`.",
    ),
    key("flags", bits(32), "`ObjFlags`: bit 0 refuses downloads of a configuration tool, bit 1 uploads."),
    key("unit", Shape::Text, "The unit of the engineering value."),
    key("factor", Shape::Value, "The engineering value is (value + offset) * factor."),
    key("offset", Shape::Value, "The engineering value is (value + offset) * factor."),
    key("enum", Shape::Values, "Names of values: `{ Off = 0, On = 1 }`."),
    key("bits", Shape::Values, "Names of bits and bit fields: `{ Ready = 0, Mode = \"4-6\" }`."),
    key("description", Shape::Text, "What the entry is for."),
    key(
        "group",
        Shape::Text,
        "The group that configuration tools show the entry in; `/` separates nested groups.",
    ),
    key("denotation", Shape::Text, "The name of the entry in the application of a node."),
];

/// The parts with properties, by keyword, with their JSON paths in the model.
pub(crate) const FACTS: [(&str, Part, &str); 3] = [
    ("file", Part::FileInfo, "/file_info"),
    ("device", Part::DeviceInfo, "/device_info"),
    ("commissioning", Part::Commissioning, "/commissioning"),
];

/// All keys of fields: the keywords, the keys of CiA 306, and those of properties.
pub(crate) const FIELDS: &[Key] = &{
    const COUNT: usize =
        ENTRY.len() + field_names::ENTRY.len() + FILE.len() + DEVICE.len() + COMMISSIONING.len();
    let mut keys = [ENTRY[0]; COUNT];
    let mut at = 0;
    while at < COUNT {
        let [cia306, file, device, commissioning] = [
            ENTRY.len(),
            ENTRY.len() + field_names::ENTRY.len(),
            ENTRY.len() + field_names::ENTRY.len() + FILE.len(),
            ENTRY.len() + field_names::ENTRY.len() + FILE.len() + DEVICE.len(),
        ];
        keys[at] = match at {
            at if at < cia306 => ENTRY[at],
            at if at < file => {
                key(field_names::ENTRY[at - cia306].eds, Shape::Value, "The key of CiA 306 for the word.")
            }
            at if at < device => key(FILE[at - file].eds, Shape::Value, "A fact about the file."),
            at if at < commissioning => {
                key(DEVICE[at - device].eds, Shape::Value, "A fact about the device.")
            }
            at => key(COMMISSIONING[at - commissioning].eds, Shape::Value, "A fact about the node."),
        };
        at += 1;
    }
    keys
};

/// The keyword for a key, which may be one of CiA 306.
pub(crate) fn word_of(name: &str) -> Option<&'static str> {
    let known = ENTRY.iter().find(|key| key.name == name).map(|key| key.name);
    known.or_else(|| {
        field_names::ENTRY.iter().find(|row| row.eds.eq_ignore_ascii_case(name)).map(|row| row.key)
    })
}

/// The data type for a string: a keyword, the name in CiA 301, or its index.
pub(crate) fn data_type(text: &str) -> Option<DataType> {
    let index = || written_number(text, u16::MAX.into()).map(|index| DataType(index as u16));
    types::named(text).or_else(|| DataType::from_name(&text.to_ascii_uppercase())).or_else(index)
}

/// The word for a data type.
pub(crate) fn data_type_word(data_type: DataType) -> String {
    let word = types::word_of(data_type).or_else(|| data_type.name());
    word.map_or_else(|| format!("0x{:04X}", data_type.0), str::to_owned)
}

/// The object type for a string: a keyword, or its code.
pub(crate) fn object_type(text: &str) -> Option<ObjectType> {
    let code = written_number(text, u8::MAX.into());
    let is = |kind: &ObjectType| kind.name().eq_ignore_ascii_case(text) || Some(kind.code().into()) == code;
    ObjectType::ALL.into_iter().find(is)
}

#[cfg(test)]
mod tests {
    use super::types::TYPES;
    use super::*;

    #[test]
    fn words_of_types_read_back() {
        for (word, of) in TYPES {
            assert_eq!((data_type(word), data_type_word(of)), (Some(of), word.to_owned()));
        }
        for of in DataType::STATIC.iter().copied().chain([DataType(0x21), DataType(0x60)]) {
            assert_eq!(data_type(&data_type_word(of)), Some(of));
        }
        assert_eq!(data_type("unsigned16"), Some(DataType::UNSIGNED16));
        assert_eq!(data_type("0x0006"), Some(DataType::UNSIGNED16));
        assert_eq!(data_type("u12"), None);
    }

    #[test]
    fn keys_of_cia_306_have_words() {
        assert_eq!(word_of("datatype"), Some("type"));
        assert_eq!(word_of("unit"), Some("unit"));
        assert!(field_names::ENTRY.iter().all(|row| word_of(row.key) == Some(row.key)));
        assert!(OBJECT_TYPES.iter().all(|word| object_type(word).is_some()));
    }
}
