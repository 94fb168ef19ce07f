//! Storage of a value in CANopenNode: type, length, attributes and initialiser in C.

use crate::c_code::exact_type;
use crate::dictionary::ResolvedEntry;
use crate::model::{DataType, SrdoAccess, TypeKind};
use crate::resolve::{Encoded, EntryPlan, ValueShape, digits};

/// Location and representation of a value.
pub(super) struct ValueStorage {
    /// The type of the variable or its elements; `None` if the stack has no suitable type and the application
    /// must provide the value.
    pub(super) type_: Option<&'static str>,
    /// Number of elements; `None` for a number.
    pub(super) elements: Option<usize>,
    /// Size of a value in bytes, according to the stack.
    pub(super) length: usize,
    /// Attributes of the entry, such as `ODA_SDO_R`, or `0`.
    pub(super) attribute: String,
    /// The initialiser: a number, or all elements up to the last non-zero one, at least one.
    pub(super) value: Vec<String>,
}

impl ValueStorage {
    /// The storage of an entry; without it, the stack only knows its length.
    pub(super) fn new(entry: &ResolvedEntry<'_>, is_stored: bool) -> Self {
        let resolved = &entry.resolved;
        let (type_, elements, length, value) = match (resolved.shape, &resolved.default) {
            (ValueShape::Word(data_type), default) => word(data_type, default.word()),
            (ValueShape::Bytes(data_type, room), Encoded::Bytes(bytes)) => {
                let has_room =
                    entry.entry.stack.as_ref().is_some_and(|stack| stack.min_string_length > Some(0));
                text(data_type, usize::from(room), has_room, bytes)
            }
            (ValueShape::Bytes(..), _) => (None, None, 0, Vec::new()), // numbers do not have this shape
            (ValueShape::Block(_), Encoded::Bytes(block)) => bytes(block.len(), block),
            (ValueShape::Block(length), _) => bytes(usize::from(length), &[]),
        };
        // an application that attaches an extension determines the length of a string, as with CANopenEditor
        let is_sized = is_stored || !matches!(resolved.shape, ValueShape::Bytes(..));
        let attribute = attribute(entry, type_);
        Self {
            type_: type_.filter(|_| is_stored),
            elements,
            length: if is_sized { length } else { 0 },
            attribute,
            value,
        }
    }

    /// Whether elements of an array can share this storage.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let facts = |storage: &Self| (storage.type_, storage.elements, storage.length);
        facts(self) == facts(other) && self.attribute == other.attribute
    }

    /// The suffix of a variable's declarator.
    pub(super) fn dimension(&self) -> String {
        self.elements.map_or_else(String::new, |elements| format!("[{elements}]"))
    }
}

/// Type, elements, length and initialiser.
type KeptVariable = (Option<&'static str>, Option<usize>, usize, Vec<String>);

fn word(data_type: DataType, word: u64) -> KeptVariable {
    let length = data_type.byte_length().map_or(0, usize::from);
    let type_ = match data_type.kind() {
        TypeKind::Boolean => Some("bool_t"),
        TypeKind::Real32 => Some("float32_t"),
        TypeKind::Real64 => Some("float64_t"),
        _ => exact_type(data_type),
    };
    let value = match data_type.kind() {
        _ if type_.is_none() => return bytes(length, word.to_le_bytes().get(..length).unwrap_or_default()),
        TypeKind::Boolean => (word != 0).to_string(),
        TypeKind::Signed(_) => signed(word),
        TypeKind::Real32 => digits(word, data_type).map_or_else(
            || not_finite(f32::from_bits(word as u32).into()).to_owned(), // the lower half contains all bits
            |digits| digits + "f",
        ),
        TypeKind::Real64 => {
            digits(word, data_type).unwrap_or_else(|| not_finite(f64::from_bits(word)).to_owned())
        }
        _ => format!("0x{word:0width$X}", width = 2 * length),
    };
    (type_, None, length, vec![value])
}

fn signed(word: u64) -> String {
    match word as i64 {
        // C has no literal for these: the minus sign is not part of a literal, and the positive number does
        // not fit
        i64::MIN => "INT64_MIN".to_owned(),
        number if number == i64::from(i32::MIN) => "INT32_MIN".to_owned(),
        number if number == i64::from(i16::MIN) => "INT16_MIN".to_owned(),
        number => number.to_string(),
    }
}

/// The math.h name of a number that cannot be written as a literal.
fn not_finite(number: f64) -> &'static str {
    match number.is_nan() {
        true => "NAN",
        false if number < 0.0 => "-INFINITY",
        false => "INFINITY",
    }
}

/// Whether a number is a NaN other than the one of math.h; its other bits are lost.
pub(super) fn is_odd_nan(resolved: &EntryPlan) -> bool {
    let word = resolved.default.word();
    match resolved.shape {
        ValueShape::Word(DataType::REAL32) => {
            f32::from_bits(word as u32).is_nan() && word as u32 != f32::NAN.to_bits()
        }
        ValueShape::Word(DataType::REAL64) => f64::from_bits(word).is_nan() && word != f64::NAN.to_bits(),
        _ => false,
    }
}

/// A string or block of at most `room` bytes; only strings may be shorter. `has_room`: the description states
/// the capacity.
fn text(data_type: DataType, room: usize, has_room: bool, value: &[u8]) -> KeptVariable {
    match data_type.kind() {
        TypeKind::VisibleString if room > 0 => {
            let letters = value.iter().map(|&byte| letter(byte));
            (Some("char"), Some(room + 1), room, up_to_last(letters, value.iter().map(|&byte| byte != 0)))
        }
        TypeKind::UnicodeString if room > 0 => {
            let units = value
                .chunks(2)
                .map(|pair| pair.iter().rev().fold(0, |unit, &byte| unit << 8 | u16::from(byte)));
            let length = room.div_ceil(2);
            let numbers = units.clone().map(|unit| format!("0x{unit:04X}"));
            (Some("uint16_t"), Some(length + 1), 2 * length, up_to_last(numbers, units.map(|unit| unit != 0)))
        }
        TypeKind::OctetString if has_room => bytes(room.max(value.len()), value),
        TypeKind::OctetString | TypeKind::Domain if !value.is_empty() => bytes(value.len(), value),
        _ => (None, None, 0, Vec::new()),
    }
}

fn bytes(length: usize, value: &[u8]) -> KeptVariable {
    let numbers = value.iter().map(|byte| format!("0x{byte:02X}"));
    (Some("uint8_t"), Some(length), length, up_to_last(numbers, value.iter().map(|&byte| byte != 0)))
}

/// The numbers up to the last significant one, at least one; C zero-fills the rest.
fn up_to_last(numbers: impl Iterator<Item = String>, counts: impl Iterator<Item = bool>) -> Vec<String> {
    let length =
        counts.zip(1..).filter_map(|(counts, position)| counts.then_some(position)).last().unwrap_or(0);
    let mut numbers: Vec<String> = numbers.take(length).collect();
    if numbers.is_empty() {
        numbers.push("0".to_owned());
    }
    numbers
}

/// A byte of a string as a character constant.
fn letter(byte: u8) -> String {
    match byte {
        b'\'' | b'\\' => format!("'\\{}'", char::from(byte)),
        b'?' => "'\\?'".to_owned(), // not a trigraph
        b' '..=b'~' => format!("'{}'", char::from(byte)),
        _ => format!("'\\x{byte:02X}'"),
    }
}

fn attribute(entry: &ResolvedEntry<'_>, type_: Option<&str>) -> String {
    let resolved = &entry.resolved;
    let sdo = resolved.sdo_word(["", "ODA_SDO_R", "ODA_SDO_W", "ODA_SDO_RW"]);
    let pdo = resolved.pdo_word(["", "ODA_TPDO", "ODA_RPDO", "ODA_TRPDO"]);
    let srdo = match entry.entry.stack.as_ref().and_then(|stack| stack.srdo_access) {
        Some(SrdoAccess::Trx) => "ODA_TRSRDO",
        Some(SrdoAccess::Tx) => "ODA_TSRDO",
        Some(SrdoAccess::Rx) => "ODA_RSRDO",
        Some(SrdoAccess::No) | None => "",
    };
    let kept = match (resolved.shape, type_) {
        (ValueShape::Word(_), Some("bool_t" | "uint8_t" | "int8_t")) => "", // includes odd widths
        (ValueShape::Word(_), Some(_)) => "ODA_MB",
        (ValueShape::Bytes(data_type, _), _) if is_text(data_type) => "ODA_STR",
        _ => "",
    };
    let flags: Vec<&str> = [sdo, pdo, srdo, kept].into_iter().filter(|flag| !flag.is_empty()).collect();
    if flags.is_empty() { "0".to_owned() } else { flags.join(" | ") }
}

/// Whether values of a type may be shorter than their capacity.
pub(super) fn is_text(data_type: DataType) -> bool {
    matches!(data_type.kind(), TypeKind::VisibleString | TypeKind::UnicodeString)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_out_as_c_takes_them() {
        let value = |data_type, bits: u64| word(data_type, bits).3.join(" ");
        assert_eq!(value(DataType::UNSIGNED16, 0x1F), "0x001F");
        assert_eq!(value(DataType::INTEGER64, 1 << 63), "INT64_MIN");
        assert_eq!(value(DataType::INTEGER32, (-3_i64) as u64), "-3");
        assert_eq!(value(DataType::INTEGER24, (-3_i64) as u64), "0xFD 0xFF 0xFF");
        assert_eq!(value(DataType::REAL32, u64::from(1.5_f32.to_bits())), "1.5f");
        assert_eq!(value(DataType::REAL32, u64::from(f32::MAX.to_bits())), "3.4028235e38f");
        assert_eq!(value(DataType::REAL64, f64::NEG_INFINITY.to_bits()), "-INFINITY");
        assert_eq!(value(DataType::REAL64, 1.0_f64.to_bits()), "1.0");
    }

    #[test]
    fn texts_come_out_as_letters() {
        let (type_, elements, length, value) = text(DataType::VISIBLE_STRING, 8, false, b"a'\\?\xE9\n");
        assert_eq!((type_, elements, length), (Some("char"), Some(9), 8));
        assert_eq!(value, ["'a'", "'\\''", "'\\\\'", "'\\?'", "'\\xE9'", "'\\x0A'"]);
        assert_eq!(text(DataType::UNICODE_STRING, 4, false, &[0xE9, 0]).3, ["0x00E9"]);
        assert_eq!(text(DataType::OCTET_STRING, 8, false, &[]).0, None);
        assert_eq!(text(DataType::OCTET_STRING, 8, true, &[]).1, Some(8));
        assert_eq!(text(DataType::OCTET_STRING, 10, true, &[1, 2, 3]).1, Some(10));
        assert_eq!(text(DataType::DOMAIN, 0, false, &[1, 0, 0]).3, ["0x01"]);
    }
}
