//! The names of data types, object types and access types in files that users write.

use objdict_model::model::DataType;

/// The keywords for access from the network.
pub const ACCESS: &[&str] = &["ro", "wo", "rw", "rwr", "rww", "const"];

/// The keywords for object types.
pub const OBJECT_TYPES: &[&str] = &["null", "domain", "deftype", "defstruct", "var", "array", "record"];

/// The keywords for data types.
pub const TYPES: [(&str, DataType); 25] = [
    ("bool", DataType::BOOLEAN),
    ("i8", DataType::INTEGER8),
    ("i16", DataType::INTEGER16),
    ("i24", DataType::INTEGER24),
    ("i32", DataType::INTEGER32),
    ("i40", DataType::INTEGER40),
    ("i48", DataType::INTEGER48),
    ("i56", DataType::INTEGER56),
    ("i64", DataType::INTEGER64),
    ("u8", DataType::UNSIGNED8),
    ("u16", DataType::UNSIGNED16),
    ("u24", DataType::UNSIGNED24),
    ("u32", DataType::UNSIGNED32),
    ("u40", DataType::UNSIGNED40),
    ("u48", DataType::UNSIGNED48),
    ("u56", DataType::UNSIGNED56),
    ("u64", DataType::UNSIGNED64),
    ("f32", DataType::REAL32),
    ("f64", DataType::REAL64),
    ("string", DataType::VISIBLE_STRING),
    ("bytes", DataType::OCTET_STRING),
    ("unicode", DataType::UNICODE_STRING),
    ("time", DataType::TIME_OF_DAY),
    ("time-difference", DataType::TIME_DIFFERENCE),
    ("domain", DataType::DOMAIN),
];

/// The data type of a word.
pub fn named(word: &str) -> Option<DataType> {
    TYPES.iter().find(|(known, _)| *known == word).map(|(_, data_type)| *data_type)
}

/// The keyword for a data type, if there is one.
pub fn word_of(data_type: DataType) -> Option<&'static str> {
    TYPES.iter().find(|(_, known)| *known == data_type).map(|(word, _)| *word)
}
