//! The values of entries as members of structures.

use crate::Options;
use crate::c_code::{bytes, little_endian, number_type, typed};
use crate::canopennode::names::Naming;
use crate::dictionary::{ResolvedEntry, ResolvedObject};
use crate::memory::TypeExtent;
use crate::model::DataType;
use crate::resolve::ValueShape;

/// The memory of a value.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ValueLocation {
    Rom,
    Ram,
    Eeprom,
}

impl ValueLocation {
    pub(super) const ALL: [Self; 3] = [Self::Ram, Self::Eeprom, Self::Rom];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Rom => "ROM",
            Self::Ram => "RAM",
            Self::Eeprom => "EEPROM",
        }
    }

    /// Its bits in an attribute.
    fn bits(self) -> u16 {
        match self {
            Self::Rom => 1,
            Self::Ram => 2,
            Self::Eeprom => 3,
        }
    }

    /// The memory of an object: from the description, otherwise from the options, otherwise by index and
    /// access.
    pub(super) fn of(object: &ResolvedObject<'_>, options: &Options) -> Self {
        let name = object.group(options).map(|name| name.trim().to_ascii_uppercase());
        match name.as_deref() {
            Some("RAM") => Self::Ram,
            Some("ROM" | "PERSIST_COMM") => Self::Rom,
            Some(_) => Self::Eeprom,
            None => match object.index {
                0x1001..=0x1003 | 0x1010 | 0x1011 | 0x1020..=0x1027 | 0x1F50..=0x1F57 => Self::Ram,
                0x1000..=0x1FFF => Self::Rom,
                _ if object.entries.iter().all(|entry| entry.resolved.constant) => Self::Rom,
                _ => Self::Ram,
            },
        }
    }
}

/// A value in a structure.
#[derive(Clone)]
pub(super) struct StructureCell {
    /// The type of `CO_OD.h`.
    pub(super) c_type: String,
    /// The number of elements of a string or of bytes.
    pub(super) room: Option<usize>,
    pub(super) value: String,
    pub(super) attribute: u16,
    /// The length of the value; 0 without memory, where the application provides the data.
    pub(super) length: usize,
}

impl StructureCell {
    pub(super) fn new(entry: &ResolvedEntry<'_>, location: ValueLocation, word: Option<u64>) -> Self {
        let resolved = &entry.resolved;
        let length = resolved.shape.size();
        let attribute = attribute(entry, location);
        let bytes_of = |c_type: &str, value: String| {
            let c_type = c_type.to_owned();
            Self { c_type, room: Some(length), value, attribute, length }
        };
        let word = word.unwrap_or_else(|| resolved.default.word());
        let number = typed(resolved.shape, word)
            .and_then(|(data_type, value)| Some((number_type(data_type, NUMBERS)?, value)));
        match (resolved.shape, number) {
            (_, Some((c_type, value))) => {
                let multiple = if length > 1 { 0x80 } else { 0 };
                Self { c_type, room: None, value, attribute: attribute | multiple, length }
            }
            (ValueShape::Word(_), None) => bytes_of("UNSIGNED8", bytes(&little_endian(word, length))),
            (ValueShape::Bytes(DataType::VISIBLE_STRING, _), _) => {
                bytes_of("VISIBLE_STRING", characters(resolved.default.bytes()))
            }
            _ => bytes_of("OCTET_STRING", bytes(resolved.default.bytes())),
        }
    }

    /// Whether it has memory.
    pub(super) fn is_stored(&self) -> bool {
        self.length > 0
    }

    /// Whether both can be elements of the same array.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let facts = |cell: &Self| (cell.c_type.clone(), cell.room, cell.attribute, cell.length);
        facts(self) == facts(other)
    }

    /// The part after the name of a member.
    pub(super) fn suffix(&self) -> String {
        self.room.map(|room| format!("[{room}]")).unwrap_or_default()
    }

    pub(super) fn extent(&self) -> TypeExtent {
        TypeExtent::of_c(&self.c_type).times(self.room.unwrap_or(1)) // characters and octets have 1 byte
    }
}

/// The types of `CO_OD.h` for numbers that C has.
pub(super) const NUMBERS: [&str; 3] = ["UNSIGNED", "INTEGER", "REAL"];

/// The attribute of an entry without the bit for values of several bytes.
fn attribute(entry: &ResolvedEntry<'_>, location: ValueLocation) -> u16 {
    let resolved = &entry.resolved;
    let stack = entry.entry.stack.as_ref();
    let detects_change = stack.is_some_and(|stack| stack.detects_change == Some(true)) && resolved.tpdo;
    let flags = [
        (resolved.sdo().0, 0x04),
        (resolved.sdo().1, 0x08),
        (resolved.rpdo, 0x10),
        (resolved.tpdo, 0x20),
        (detects_change, 0x40),
    ];
    flags.iter().filter(|(set, _)| *set).fold(location.bits(), |bits, (_, bit)| bits | bit)
}

/// A string as a list of characters.
fn characters(text: &[u8]) -> String {
    let character = |&byte: &u8| match byte {
        b'\'' | b'\\' => format!("'\\{}'", char::from(byte)),
        b' '..=b'~' => format!("'{}'", char::from(byte)),
        _ => format!("'\\{byte:03o}'"),
    };
    let characters: Vec<String> = text.iter().map(character).collect();
    if characters.is_empty() { "{0}".to_owned() } else { format!("{{{}}}", characters.join(", ")) }
}

/// The naming rule of the editors for this stack.
pub(super) const NAMES: Naming = Naming::Legacy;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_characters() {
        assert_eq!(characters(b"a'\\\xE9?"), "{'a', '\\'', '\\\\', '\\351', '?'}");
        assert_eq!(characters(b""), "{0}");
    }
}
