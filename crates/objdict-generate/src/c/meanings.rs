//! View of templates/c/_meanings.h: enumerations and bit fields.

use std::collections::BTreeSet;

use super::words::{macro_name, word_type};
use crate::meanings::{self, EnumType, NamedMeanings, WordPart, WordType};
use crate::model::{DataType, TypeKind};
use crate::names::{NameScope, clip};

/// The macros.
pub(super) struct MeaningMacros<'a> {
    upper: String,
    enums: Vec<EnumMacros<'a>>,
    words: Vec<WordMacros<'a>>,
}

include!("../../expanded/c/_meanings.h.rs");

struct EnumMacros<'a> {
    of: &'a EnumType,
    values: Vec<ValueView<'a>>,
}

struct ValueView<'a> {
    name: String,
    label: &'a str,
    number: String,
}

struct WordMacros<'a> {
    of: &'a WordType,
    parts: Vec<PartMacros<'a>>,
}

struct PartMacros<'a> {
    of: &'a WordPart,
    /// The name after the prefix.
    name: String,
    mask: String,
    /// Expressions of `word`, and of `word` and `value`.
    get: String,
    with: String,
}

/// Suffixes of the macros of a bit field.
const OF_PARTS: [&str; 5] = ["shift", "bits", "mask", "get", "with"];

impl<'a> MeaningMacros<'a> {
    /// Claims names in `macros`, which already contains those of objects and entries.
    pub(super) fn new(named: &'a NamedMeanings, prefix: &str, macros: &mut NameScope) -> Self {
        Self {
            upper: prefix.to_ascii_uppercase(),
            enums: named.enums.iter().map(|of| enum_view(of, prefix, macros)).collect(),
            words: named.words.iter().map(|of| word_view(of, prefix, macros)).collect(),
        }
    }
}

fn enum_view<'a>(of: &'a EnumType, prefix: &str, macros: &mut NameScope) -> EnumMacros<'a> {
    let mut values = Vec::new();
    for value in &of.values {
        let numbers: Vec<i128> = std::iter::once(value.number).chain(value.others.iter().copied()).collect();
        let named: Vec<(String, i128)> = match common_bits(&numbers, of.bits) {
            Some((common, mask)) => vec![(String::new(), common), ("_mask".to_owned(), mask)],
            None => {
                let others = numbers[1..].iter().map(|&number| (format!("_{}", suffix_of(number)), number));
                std::iter::once((String::new(), value.number)).chain(others).collect()
            }
        };
        values.extend(named.into_iter().map(|(behind, of_it)| {
            let suffix = suffix_of(of_it);
            let words = format!("{}_{}{behind}", of.name, value.name);
            ValueView {
                name: macro_name(macros, prefix, &words, (format_args!("{suffix}"), suffix.len())),
                label: &value.label,
                number: number(of_it, of.data_type),
            }
        }));
    }
    EnumMacros { of, values }
}

/// The common bits of several numbers, if all are numbers with a mask: the value of these bits, and their mask in a
/// value of this many bits.
fn common_bits(numbers: &[i128], bits: u8) -> Option<(i128, i128)> {
    let common = numbers.iter().copied().reduce(|all, number| all & number)?;
    let free = common ^ numbers.iter().copied().reduce(|any, number| any | number)?;
    let distinct: BTreeSet<_> = numbers.iter().collect();
    let is_complete = 1_usize.checked_shl(free.count_ones()) == Some(distinct.len());
    (common >= 0 && free != 0 && is_complete).then_some((common, (1 << bits.min(64)) - 1 - free))
}

/// A number as a part of a name.
fn suffix_of(number: i128) -> String {
    if number < 0 { format!("m{}", -number) } else { number.to_string() }
}

/// A number of a data type as an expression.
fn number(number: i128, data_type: DataType) -> String {
    match (data_type.kind(), data_type.bit_length()) {
        (TypeKind::Signed(_), _) if number == i128::from(i64::MIN) => {
            "(-INT64_C(0x7FFFFFFFFFFFFFFF) - 1)".to_owned()
        }
        (TypeKind::Signed(_), _) if number == i128::from(i32::MIN) => "(-0x7FFFFFFF - 1)".to_owned(),
        (TypeKind::Signed(_), Some(33..)) if number < 0 => format!("(-INT64_C({}))", -number),
        (TypeKind::Signed(_), Some(33..)) => format!("INT64_C({number})"),
        (TypeKind::Signed(_), _) if number < 0 => format!("({number})"),
        (TypeKind::Signed(_), _) => number.to_string(),
        (_, Some(33..)) => format!("UINT64_C({number})"),
        _ => format!("{number}u"),
    }
}

fn entries(all: &[(u16, u8)]) -> String {
    meanings::entries(all, |index, sub| format!("{index:04X}h sub-index {sub:02X}h"))
}

fn word_view<'a>(of: &'a WordType, prefix: &str, macros: &mut NameScope) -> WordMacros<'a> {
    let parts = of.parts.iter().map(|part| {
        let words = format!("{}_{}", of.name.trim_end_matches('_'), part.name.trim_end_matches('_'));
        let name = part_name(macros, prefix, &words, part.first);
        part_view(of, part, format!("{}_{}", prefix.to_ascii_uppercase(), name.to_ascii_uppercase()))
    });
    WordMacros { of, parts: parts.collect() }
}

/// A name with which no macro of a bit field conflicts.
fn part_name(macros: &mut NameScope, prefix: &str, words: &str, first: u8) -> String {
    let mut suffix = first.to_string();
    loop {
        let room = crate::names::LONGEST - prefix.len() - 8 - suffix.len();
        let name = macros.claim(clip(words, room), format_args!("{suffix}"));
        let all = OF_PARTS.map(|what| format!("{name}_{what}"));
        if all.iter().all(|name| macros.is_free(name)) {
            all.into_iter().for_each(|name| macros.take(name));
            return name;
        }
        suffix.push_str("_p");
    }
}

fn part_view<'a>(of: &WordType, part: &'a WordPart, name: String) -> PartMacros<'a> {
    let bits = of.data_type.bit_length().unwrap_or(64);
    let word = word_type(of.data_type);
    let unsigned = format!("u{}", word.trim_start_matches('u'));
    let room = match unsigned.as_str() {
        "uint8_t" => 8,
        "uint16_t" => 16,
        "uint32_t" => 32,
        _ => 64,
    };
    let literal = |number: u64| match room {
        64 => format!("UINT64_C(0x{number:X})"),
        _ => format!("0x{number:X}u"),
    };
    let type_ = word_type(part.data_type);
    let taken = format!("((({unsigned})(word) & {name}_MASK) >> {name}_SHIFT)");
    let extended = |value: &str, bits: u8| {
        let sign = literal(1 << (bits - 1));
        format!("({value} ^ {sign}) - {sign}")
    };
    let get = match part.is_signed {
        true => format!("(({type_})({}))", extended(&taken, part.bits)),
        false if type_ == "bool" => format!("((({unsigned})(word) & {name}_MASK) != 0u)"),
        false => format!("(({type_}){taken})"),
    };
    let value = format!("(({unsigned})(({unsigned})(value) << {name}_SHIFT) & {name}_MASK)");
    let whole = format!("((({unsigned})(word) & ({unsigned})~{name}_MASK) | {value})");
    let with = match of.data_type.kind() {
        TypeKind::Signed(_) if bits < room => {
            let whole = format!("({whole} & {})", literal(u64::MAX >> (64 - bits)));
            format!("(({word})({}))", extended(&whole, bits))
        }
        _ => format!("(({word}){whole})"),
    };
    PartMacros { of: part, mask: format!("(({unsigned}){})", literal(part.mask)), name, get, with }
}
