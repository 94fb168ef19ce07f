//! Values as initializers of `union co_val`.

use crate::c_code::{listed, number};
use crate::escape::literal;
use crate::model::{DataType, TypeKind};
use crate::resolve::{Encoded, EntryPlan, ValueShape, is_time};

/// The indentation of further lines of a value.
const INDENT: &str = "        ";

/// The node-ID of an unconfigured node (CiA 305).
pub(super) const UNCONFIGURED: u8 = 0xFF;

/// The type of an entry in the library: for a device-specific type, the number or octet string of its length.
pub(super) fn data_type(shape: ValueShape) -> DataType {
    match shape {
        ValueShape::Word(data_type) | ValueShape::Bytes(data_type, _) => data_type,
        ValueShape::Block(length) => {
            DataType::unsigned(usize::from(length)).unwrap_or(DataType::OCTET_STRING)
        }
    }
}

/// The name of a type after `CO_DEFTYPE_` and in its limit macros.
pub(super) fn type_name(data_type: DataType) -> &'static str {
    match data_type.kind() {
        TypeKind::TimeDifference => "TIME_DIFF",
        _ => data_type.name().unwrap_or("DOMAIN"), // the others have names
    }
}

/// The member of the union for a type.
fn member(data_type: DataType) -> String {
    match data_type.kind() {
        TypeKind::Boolean => "b".to_owned(),
        TypeKind::Signed(bits) => format!("i{bits}"),
        TypeKind::Unsigned(bits) => format!("u{bits}"),
        TypeKind::Real32 => "r32".to_owned(),
        TypeKind::Real64 => "r64".to_owned(),
        TypeKind::VisibleString => "vs".to_owned(),
        TypeKind::OctetString => "os".to_owned(),
        TypeKind::UnicodeString => "us".to_owned(),
        TypeKind::TimeOfDay => "t".to_owned(),
        TypeKind::TimeDifference => "td".to_owned(),
        _ => "dom".to_owned(),
    }
}

/// Whether values of the type have limits.
pub(super) fn has_limits(data_type: DataType) -> bool {
    data_type.is_numeric() || is_time(data_type)
}

/// A limit of an entry: the limit of its type (`MIN` or `MAX`) if the description has none.
pub(super) fn limit(limit: Option<&Encoded>, data_type: DataType, of_type: &str, node_id: u8) -> String {
    match limit {
        Some(limit) => value(limit, data_type, node_id),
        None => format!(".{} = CO_{}_{of_type}", member(data_type), type_name(data_type)),
    }
}

/// The initial value of an entry.
pub(super) fn initial(resolved: &EntryPlan, node_id: u8) -> String {
    value(&resolved.default, data_type(resolved.shape), node_id)
}

fn value(datum: &Encoded, data_type: DataType, node_id: u8) -> String {
    let word = match datum {
        Encoded::Word(word) => *word,
        Encoded::Formula(offset) => wrapped(offset.wrapping_add(u64::from(node_id)), data_type),
        Encoded::Bytes(bytes) if data_type.is_numeric() => {
            bytes.iter().rev().fold(0, |word, &byte| word << 8 | u64::from(byte))
        }
        Encoded::Bytes(bytes) => return texts(bytes, data_type),
    };
    let member = member(data_type);
    if is_time(data_type) {
        let (milliseconds, days) = (word & 0x0FFF_FFFF, word >> 32);
        return format!(".{member} = {{.ms = {milliseconds}u, .days = {days}u}}");
    }
    match number(word, data_type) {
        Some(number) => format!(".{member} = {number}"),
        // C has no literal for a non-finite REAL: uses its bits
        None if data_type.kind() == TypeKind::Real32 => format!(".u32 = 0x{word:08X}u"),
        None => format!(".u64 = UINT64_C(0x{word:016X})"),
    }
}

/// A sum in the C type of its number. The library adds the difference of node-IDs in the same type, so a sum
/// that overflows becomes correct with a node-ID for which it fits.
fn wrapped(sum: u64, data_type: DataType) -> u64 {
    match data_type.kind() {
        TypeKind::Signed(8) => i64::from(sum as i8) as u64, // the same bits
        TypeKind::Signed(16) => i64::from(sum as i16) as u64,
        TypeKind::Signed(17..=32) => i64::from(sum as i32) as u64,
        TypeKind::Unsigned(8) => sum & 0xFF,
        TypeKind::Unsigned(16) => sum & 0xFFFF,
        TypeKind::Unsigned(17..=32) => sum & 0xFFFF_FFFF,
        _ => sum,
    }
}

/// A string, octet string or DOMAIN; the source defines `EMPTY_ARRAY` for libraries with and without
/// `malloc()`.
fn texts(bytes: &[u8], data_type: DataType) -> String {
    let member = member(data_type);
    if bytes.is_empty() {
        return format!(".{member} = EMPTY_ARRAY");
    }
    let list = |bytes: &[u8]| listed(bytes.iter().map(|byte| format!("0x{byte:02X}")), INDENT);
    match (data_type.kind(), literal(bytes)) {
        (TypeKind::VisibleString, Some(text)) => format!(".vs = CO_VISIBLE_STRING_C({text})"),
        (TypeKind::OctetString, Some(text)) => format!(".os = CO_OCTET_STRING_C({text})"),
        (TypeKind::UnicodeString, _) => {
            let characters = bytes.chunks(2).map(|pair| match *pair {
                [low, high] => format!("0x{high:02X}{low:02X}"),
                _ => "0x0000".to_owned(), // a UNICODE_STRING has whole characters
            });
            let ended = characters.chain(std::iter::once("0x0000".to_owned()));
            format!(".us = CO_UNICODE_STRING_C({})", listed(ended, INDENT))
        }
        (TypeKind::Domain, _) => format!(".dom = CO_DOMAIN_C(co_unsigned8_t, {})", list(bytes)),
        // longer than a literal; one byte more, for a zero at the end
        (kind, _) => {
            let cast = if kind == TypeKind::VisibleString { "(char *)" } else { "" };
            let room = bytes.len() + 1;
            format!(".{member} = {cast}CO_DOMAIN_NC(co_unsigned8_t, {room}, {})", list(bytes))
        }
    }
}

/// The zero-terminated name of a file from which the library reads a DOMAIN, or to which it writes one.
pub(super) fn file(name: &str) -> String {
    let ended: Vec<u8> = name.bytes().chain([0]).collect();
    texts(&ended, DataType::DOMAIN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_the_members_of_their_types() {
        let word = |word, data_type| value(&Encoded::Word(word), data_type, UNCONFIGURED);
        assert_eq!(word(5, DataType::UNSIGNED8), ".u8 = 5u");
        assert_eq!(word(-5_i64 as u64, DataType::INTEGER40), ".i40 = -5");
        assert_eq!(word(u64::from(f32::NAN.to_bits()), DataType::REAL32), ".u32 = 0x7FC00000u");
        assert_eq!(word(2 << 32 | 7, DataType::TIME_DIFFERENCE), ".td = {.ms = 7u, .days = 2u}");
        let bytes = |bytes: &[u8], data_type| value(&Encoded::Bytes(bytes.to_vec()), data_type, UNCONFIGURED);
        assert_eq!(bytes(b"a\"", DataType::VISIBLE_STRING), ".vs = CO_VISIBLE_STRING_C(\"a\\\"\")");
        assert_eq!(
            bytes(&[0x41, 0], DataType::UNICODE_STRING),
            ".us = CO_UNICODE_STRING_C({0x0041, 0x0000})"
        );
        assert_eq!(bytes(&[1, 2], DataType::DOMAIN), ".dom = CO_DOMAIN_C(co_unsigned8_t, {0x01, 0x02})");
        assert_eq!(bytes(&[], DataType::OCTET_STRING), ".os = EMPTY_ARRAY");
        assert_eq!(bytes(&[1, 2, 3], DataType::UNSIGNED24), ".u24 = 0x00030201u");
        assert_eq!(file("a"), ".dom = CO_DOMAIN_C(co_unsigned8_t, {0x61, 0x00})");
    }

    #[test]
    fn a_sum_beyond_its_type_wraps() {
        let sum = |offset, data_type| value(&Encoded::Formula(offset), data_type, UNCONFIGURED);
        assert_eq!(sum(0x80, DataType::UNSIGNED8), ".u8 = 127u");
        assert_eq!(sum(0, DataType::INTEGER8), ".i8 = -1");
        assert_eq!(sum(0x180, DataType::UNSIGNED32), ".u32 = 0x0000027Fu");
    }
}
