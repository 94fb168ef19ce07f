//! Numbers, bytes and texts in C syntax, shared by all C targets.

use super::Options;
use super::names::words;
use super::resolve::{Encoded, EntryPlan, ValueShape, digits};
use crate::model::{DataType, TypeKind};

/// The stem of file names: the prefix as spelt, otherwise the file name of the description as a C identifier.
pub(crate) fn file_stem(options: &Options) -> String {
    match &options.prefix {
        Some(prefix) => prefix.clone(),
        None => {
            Some(words(&options.file_stem)).filter(|stem| !stem.is_empty()).unwrap_or_else(|| "od".to_owned())
        }
    }
}

/// The file stem for files whose name applications do not expect: the prefix, otherwise the [`file_stem`] and
/// the content of the files (`od` only once).
pub(crate) fn file_name(options: &Options, content: &str) -> String {
    match (options.prefix.is_some(), file_stem(options)) {
        (true, stem) => stem,
        (false, stem) if stem == content => stem,
        (false, stem) => format!("{stem}_{content}"),
    }
}

/// The C type with exactly the size and range of this data type; `None` if C has none.
pub(crate) fn exact_type(data_type: DataType) -> Option<&'static str> {
    Some(match data_type.kind() {
        TypeKind::Boolean | TypeKind::Unsigned(8) => "uint8_t",
        TypeKind::Signed(8) => "int8_t",
        TypeKind::Unsigned(16) => "uint16_t",
        TypeKind::Signed(16) => "int16_t",
        TypeKind::Unsigned(32) => "uint32_t",
        TypeKind::Signed(32) => "int32_t",
        TypeKind::Unsigned(64) => "uint64_t",
        TypeKind::Signed(64) => "int64_t",
        TypeKind::Real32 => "float",
        TypeKind::Real64 => "double",
        _ => return None,
    })
}

/// A number of a type with an [`exact_type`] as an initializer; `None` for a REAL that is not finite.
pub(crate) fn number(word: u64, data_type: DataType) -> Option<String> {
    Some(match data_type.kind() {
        TypeKind::Signed(bits) => signed(word as i64, bits), // same bits: sign-extended
        TypeKind::Unsigned(64) => format!("UINT64_C({word:#X})"),
        TypeKind::Unsigned(17..) => format!("0x{word:08X}u"),
        TypeKind::Real32 => digits(word, data_type)? + "f",
        TypeKind::Real64 => digits(word, data_type)?,
        _ => format!("{word}u"),
    })
}

/// The type and the initializer of a value, if C has both for it.
pub(crate) fn typed(shape: ValueShape, word: u64) -> Option<(DataType, String)> {
    let ValueShape::Word(data_type) = shape else { return None };
    exact_type(data_type)?;
    Some((data_type, number(word, data_type)?))
}

/// A stack's name for a C number: one of these words, for unsigned, signed and real ones, plus its bits.
pub(crate) fn number_type(data_type: DataType, [unsigned, signed, real]: [&str; 3]) -> Option<String> {
    exact_type(data_type)?;
    let word = match data_type.kind() {
        TypeKind::Signed(_) => signed,
        TypeKind::Real32 | TypeKind::Real64 => real,
        _ => unsigned,
    };
    Some(format!("{word}{}", 8 * data_type.byte_length()?))
}

/// The statement that adds `nodeId` to a variable; numbers without a C type are bytes, which the function `store` sets.
pub(crate) fn assignment(
    resolved: &EntryPlan,
    variable: &str,
    words: [&str; 3],
    store: &str,
) -> Option<String> {
    let (Encoded::Formula(offset), ValueShape::Word(data_type)) = (&resolved.default, resolved.shape) else {
        return None;
    };
    Some(match (number_type(data_type, words), number(*offset, data_type)) {
        (Some(c_type), Some(number)) => format!("{variable} = ({c_type})({number} + nodeId);"),
        _ => format!("{store}({variable}, UINT64_C(0x{offset:X}) + nodeId, {}u);", resolved.shape.size()),
    })
}

/// A signed number; the lowest one cannot be written as a literal.
fn signed(number: i64, bits: u8) -> String {
    match (number, bits) {
        (i64::MIN, _) => "INT64_C(-9223372036854775807) - 1".to_owned(),
        (_, 64) => format!("INT64_C({number})"),
        (-2_147_483_648, _) => "-2147483647 - 1".to_owned(),
        _ => number.to_string(),
    }
}

/// The bytes of a number, little-endian.
pub(crate) fn little_endian(word: u64, size: usize) -> Vec<u8> {
    word.to_le_bytes().into_iter().take(size).collect()
}

/// An initializer for an array of bytes.
pub(crate) fn bytes(bytes: &[u8]) -> String {
    let used = bytes.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1); // C zero-fills the rest
    if used == 0 {
        return "{0}".to_owned();
    }
    listed(bytes[..used].iter().map(|byte| format!("0x{byte:02X}")), "    ")
}

/// A list in braces, 16 elements per line; `indent` applies to further lines.
pub(crate) fn listed(elements: impl Iterator<Item = String>, indent: &str) -> String {
    let mut text = String::from("{");
    for (number, element) in elements.enumerate() {
        match number {
            0 => {}
            _ if number % 16 == 0 => {
                text.push_str(",\n");
                text.push_str(indent);
            }
            _ => text.push_str(", "),
        }
        text.push_str(&element);
    }
    text + "}"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_c_reads_them() {
        for (word, data_type, expected) in [
            (0xFF, DataType::UNSIGNED8, "255u"),
            (0x181, DataType::UNSIGNED32, "0x00000181u"),
            (u64::MAX, DataType::UNSIGNED64, "UINT64_C(0xFFFFFFFFFFFFFFFF)"),
            (-5_i64 as u64, DataType::INTEGER16, "-5"),
            (i64::from(i32::MIN) as u64, DataType::INTEGER32, "-2147483647 - 1"),
            (i64::MIN as u64, DataType::INTEGER64, "INT64_C(-9223372036854775807) - 1"),
            (u64::from(1.5_f32.to_bits()), DataType::REAL32, "1.5f"),
            (u64::from(1e-45_f32.to_bits()), DataType::REAL32, "1e-45f"),
            ((-0.0_f64).to_bits(), DataType::REAL64, "-0.0"),
        ] {
            assert_eq!(number(word, data_type).as_deref(), Some(expected));
        }
        assert_eq!(number(f64::NAN.to_bits(), DataType::REAL64), None);
    }

    #[test]
    fn bytes_end_with_their_last_value() {
        assert_eq!(bytes(&[1, 0, 2, 0, 0]), "{0x01, 0x00, 0x02}");
        assert_eq!(bytes(&[0, 0]), "{0}");
    }
}
