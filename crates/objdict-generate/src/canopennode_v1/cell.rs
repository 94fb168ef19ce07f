//! The values of entries as members of structures.

use crate::c_code::{bytes, exact_type, little_endian, number};
use crate::dictionary::{ResolvedEntry, ResolvedObject};
use crate::memory::Extent;
use crate::model::{DataType, TypeKind};
use crate::resolve::{Datum, Shape};
use crate::{Options, StackLayout};

/// The memory of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Location {
    Rom,
    Ram,
    Eeprom,
}

impl Location {
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

    /// The memory of an object: from the description, else from the options, else by index and access.
    pub(super) fn of(object: &ResolvedObject<'_>, options: &Options) -> Self {
        let stated = object.object.main.stack.as_ref().and_then(|stack| stack.storage_group.as_deref());
        let name = stated.filter(|name| !name.trim().is_empty()).or_else(|| options.group_of(object.index));
        let is = |name: &str, other: &str| name.trim().eq_ignore_ascii_case(other);
        match name {
            Some(name) if is(name, "RAM") => Self::Ram,
            Some(name) if is(name, "ROM") || is(name, "PERSIST_COMM") => Self::Rom,
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
#[derive(Clone, Debug)]
pub(super) struct Cell {
    /// The type of `CO_OD.h`.
    pub(super) c_type: &'static str,
    /// The number of elements of a text or of bytes.
    pub(super) room: Option<usize>,
    pub(super) value: String,
    pub(super) attribute: u16,
    /// The length of the value; 0 without memory, where the application provides the data.
    pub(super) length: usize,
}

impl Cell {
    pub(super) fn new(entry: &ResolvedEntry<'_>, location: Location, word: Option<u64>) -> Self {
        let resolved = &entry.resolved;
        let length = resolved.shape.size();
        let attribute = attribute(entry, location);
        let bytes_of = |c_type: &'static str, value: String| Self {
            c_type,
            room: Some(length),
            value,
            attribute,
            length,
        };
        match (resolved.shape, &resolved.default) {
            (Shape::Word(data_type), Datum::Word(default) | Datum::Formula(default)) => {
                let word = word.unwrap_or(*default);
                match (c_type(data_type), number(word, data_type)) {
                    (Some(c_type), Some(value)) => {
                        let multiple = if length > 1 { 0x80 } else { 0 };
                        Self { c_type, room: None, value, attribute: attribute | multiple, length }
                    }
                    _ => bytes_of("UNSIGNED8", bytes(&little_endian(word, length))),
                }
            }
            (Shape::Bytes(data_type, _), Datum::Bytes(value))
                if data_type.kind() == TypeKind::VisibleString =>
            {
                bytes_of("VISIBLE_STRING", characters(value))
            }
            (_, Datum::Bytes(value)) => bytes_of("OCTET_STRING", bytes(value)),
            _ => bytes_of("UNSIGNED8", "{0}".to_owned()),
        }
    }

    /// Whether it has memory.
    pub(super) fn is_stored(&self) -> bool {
        self.length > 0
    }

    /// Whether another one can be an element of the same array.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let facts = |cell: &Self| (cell.c_type, cell.room, cell.attribute, cell.length);
        facts(self) == facts(other)
    }

    /// What is behind the name of a member.
    pub(super) fn suffix(&self) -> String {
        self.room.map(|room| format!("[{room}]")).unwrap_or_default()
    }

    pub(super) fn extent(&self) -> Extent {
        let element = match self.c_type {
            "UNSIGNED8" | "INTEGER8" | "VISIBLE_STRING" | "OCTET_STRING" => Extent::BYTE,
            "UNSIGNED16" | "INTEGER16" => Extent::HALF,
            "UNSIGNED64" | "INTEGER64" | "REAL64" => Extent::number(8),
            _ => Extent::WORD,
        };
        element.times(self.room.unwrap_or(1))
    }
}

/// The type of `CO_OD.h` for a number that C has.
pub(super) fn c_type(data_type: DataType) -> Option<&'static str> {
    Some(match exact_type(data_type)? {
        "uint8_t" => "UNSIGNED8",
        "int8_t" => "INTEGER8",
        "uint16_t" => "UNSIGNED16",
        "int16_t" => "INTEGER16",
        "uint32_t" => "UNSIGNED32",
        "int32_t" => "INTEGER32",
        "uint64_t" => "UNSIGNED64",
        "int64_t" => "INTEGER64",
        "float" => "REAL32",
        _ => "REAL64",
    })
}

/// The attribute of an entry without the bit for values of several bytes.
fn attribute(entry: &ResolvedEntry<'_>, location: Location) -> u16 {
    let resolved = &entry.resolved;
    let stack = entry.entry.stack.as_ref();
    let detects_change = stack.is_some_and(|stack| stack.detects_change == Some(true)) && resolved.tpdo;
    let flags = [
        (resolved.access.is_readable(), 0x04),
        (resolved.access.is_writable(), 0x08),
        (resolved.rpdo, 0x10),
        (resolved.tpdo, 0x20),
        (detects_change, 0x40),
    ];
    flags.iter().filter(|(set, _)| *set).fold(location.bits(), |bits, (_, bit)| bits | bit)
}

/// A text as a list of characters.
fn characters(text: &[u8]) -> String {
    let character = |&byte: &u8| match byte {
        b'\'' | b'\\' => format!("'\\{}'", char::from(byte)),
        b' '..=b'~' => format!("'{}'", char::from(byte)),
        _ => format!("'\\{byte:03o}'"),
    };
    let characters: Vec<String> = text.iter().map(character).collect();
    if characters.is_empty() { "{0}".to_owned() } else { format!("{{{}}}", characters.join(", ")) }
}

/// The rule for names: that of the current editor.
pub(super) const NAMES: StackLayout = StackLayout::Complete;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_characters() {
        assert_eq!(characters(b"a'\\\xE9?"), "{'a', '\\'', '\\\\', '\\351', '?'}");
        assert_eq!(characters(b""), "{0}");
    }
}
