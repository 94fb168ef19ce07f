//! Values as literals of Rust.

use crate::escape::byte_string;
use crate::model::{DataType, Time, TypeKind};
use crate::resolve::{Encoded, ValueShape, digits};

/// The type of a number; integers of 24 to 56 bits use the next larger type.
pub(crate) fn word_type(data_type: DataType) -> &'static str {
    match data_type.kind() {
        TypeKind::Boolean => "bool",
        TypeKind::Signed(0..=8) => "i8",
        TypeKind::Signed(9..=16) => "i16",
        TypeKind::Signed(17..=32) => "i32",
        TypeKind::Signed(_) => "i64",
        TypeKind::Unsigned(0..=8) => "u8",
        TypeKind::Unsigned(9..=16) => "u16",
        TypeKind::Unsigned(17..=32) => "u32",
        TypeKind::Real32 => "f32",
        TypeKind::Real64 => "f64",
        TypeKind::TimeOfDay | TypeKind::TimeDifference => "Time",
        _ => "u64",
    }
}

/// A value as a constant expression; formulas use the variable `node_id`.
pub(crate) fn value_of(shape: ValueShape, datum: &Encoded) -> String {
    match (shape, datum) {
        (ValueShape::Word(data_type), Encoded::Word(word)) => word_value(data_type, *word),
        (ValueShape::Word(data_type), Encoded::Formula(offset)) => {
            let node_id = match word_type(data_type) {
                "u8" => "node_id".to_owned(),
                type_ => format!("node_id as {type_}"),
            };
            if *offset == 0 { node_id } else { format!("{} + {node_id}", unsigned(*offset)) }
        }
        (ValueShape::Bytes(..), Encoded::Bytes(bytes)) => {
            format!("Octets::new(b\"{}\")", byte_string(bytes))
        }
        (ValueShape::Block(_), Encoded::Bytes(bytes)) => format!("[{}]", hex_bytes(bytes)),
        // a word has a numeric default, any other shape has bytes
        (_, Encoded::Bytes(_) | Encoded::Word(_) | Encoded::Formula(_)) => "0".to_owned(),
    }
}

fn word_value(data_type: DataType, word: u64) -> String {
    match data_type.kind() {
        TypeKind::Boolean => (word != 0).to_string(),
        TypeKind::Signed(_) => {
            let number = word as i64; // same bits
            let sign = if number < 0 { "-" } else { "" };
            format!("{sign}{}", grouped(&number.unsigned_abs().to_string(), 3))
        }
        TypeKind::Real32 | TypeKind::Real64 => match digits(word, data_type) {
            Some(digits) => real(&digits),
            None => format!("{}::from_bits({})", word_type(data_type), unsigned(word)),
        },
        TypeKind::TimeOfDay | TypeKind::TimeDifference => {
            let [a, b, c, d, e, f, ..] = word.to_le_bytes();
            let Time { days, milliseconds } = Time::from_bytes([a, b, c, d, e, f]);
            let milliseconds = grouped(&milliseconds.to_string(), 3);
            format!("Time {{ milliseconds: {milliseconds}, days: {} }}", grouped(&days.to_string(), 3))
        }
        _ => unsigned(word),
    }
}

/// Large unsigned numbers are mostly identifiers and codes, usually written in hex.
fn unsigned(number: u64) -> String {
    if number < 0x1_0000 {
        return grouped(&number.to_string(), 3);
    }
    hex(number)
}

/// A number in hexadecimal.
pub(super) fn hex(number: u64) -> String {
    format!("0x{}", grouped(&format!("{number:X}"), 4))
}

/// A floating-point literal with grouped digits.
fn real(literal: &str) -> String {
    let (sign, rest) = literal.strip_prefix('-').map_or(("", literal), |rest| ("-", rest));
    let (digits, exponent) = rest.split_at(rest.find('e').unwrap_or(rest.len()));
    let Some((whole, fraction)) = digits.split_once('.') else {
        return format!("{sign}{}{exponent}", grouped(digits, 3));
    };
    let fraction: Vec<String> =
        fraction.as_bytes().chunks(3).map(|group| String::from_utf8_lossy(group).into_owned()).collect();
    format!("{sign}{}.{}{exponent}", grouped(whole, 3), fraction.join("_"))
}

/// Groups digits from the right as clippy requires; short numbers are unchanged.
pub(super) fn grouped(digits: &str, size: usize) -> String {
    if digits.len() <= size + 1 {
        return digits.to_owned();
    }
    let mut text = String::with_capacity(digits.len() * 4 / 3 + 1);
    for (number, digit) in digits.chars().enumerate() {
        if number > 0 && (digits.len() - number).is_multiple_of(size) {
            text.push('_');
        }
        text.push(digit);
    }
    text
}

pub(super) fn hex_bytes(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("0x{byte:02X}")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_grouped_as_clippy_likes_them() {
        assert_eq!(unsigned(1000), "1000");
        assert_eq!(unsigned(65535), "65_535");
        assert_eq!(unsigned(0x8000_0180), "0x8000_0180");
        assert_eq!(unsigned(0x1_0000), "0x10000");
        assert_eq!(word_value(DataType::INTEGER64, 1 << 63), "-9_223_372_036_854_775_808");
        assert_eq!(word_value(DataType::INTEGER24, u64::MAX), "-1");
    }

    #[test]
    fn reals_are_literals_of_their_bits() {
        let real64 = |number: f64| word_value(DataType::REAL64, number.to_bits());
        assert_eq!(real64(-0.125), "-0.125");
        assert_eq!(real64(123_456_789.125_5), "123_456_789.125_5");
        assert_eq!(real64(1e-300), "1e-300");
        assert_eq!(real64(f64::INFINITY), "f64::from_bits(0x7FF0_0000_0000_0000)");
        assert_eq!(word_value(DataType::REAL32, u64::from(0.1_f32.to_bits())), "0.1");
    }

    #[test]
    fn formulas_stay_formulas() {
        let value = |data_type, offset| value_of(ValueShape::Word(data_type), &Encoded::Formula(offset));
        assert_eq!(value(DataType::UNSIGNED32, 0x180), "384 + node_id as u32");
        assert_eq!(value(DataType::UNSIGNED8, 0), "node_id");
        assert_eq!(value(DataType::INTEGER16, 1000), "1000 + node_id as i16");
    }
}
