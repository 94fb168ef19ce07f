//! View of templates/rust/_meanings.rs: enumerations and bit fields.

use std::collections::HashSet;

use super::literal::{value_of, word_type};
use crate::meanings::{self, EnumType, NamedMeanings, WordPart, WordType};
use crate::model::{DataType, TypeKind};
use crate::resolve::{Encoded, ValueShape};

/// The modules `enums` and `bits`, if not empty.
pub(super) struct MeaningModules<'a> {
    enums: Vec<EnumView<'a>>,
    words: Vec<WordView<'a>>,
    /// Attribute lines after the standard derives of enumerations.
    derives: String,
}

include!("../../expanded/rust/_meanings.rs.rs");

struct EnumView<'a> {
    name: String,
    of: &'a EnumType,
    /// The type of a value.
    type_: &'static str,
    /// The representation of the enumeration.
    repr: &'static str,
    /// Whether every value of the type has a name.
    is_complete: bool,
    variants: Vec<VariantView<'a>>,
    aliases: Vec<AliasView<'a>>,
}

struct VariantView<'a> {
    name: String,
    label: &'a str,
    /// A literal of type `repr`, and a pattern of type `type_`.
    number: String,
    pattern: String,
}

struct AliasView<'a> {
    name: String,
    label: &'a str,
    variant: String,
}

struct WordView<'a> {
    of: &'a WordType,
    parts: Vec<PartView<'a>>,
}

struct PartView<'a> {
    of: &'a WordPart,
    /// `bit 3`, `bits 4 to 7`.
    place: String,
    /// The type of the word, and the unsigned type of the same size.
    word: &'static str,
    unsigned: &'static str,
    /// The type of the bit field.
    type_: &'static str,
    mask: String,
    /// Expressions of `word`, and of `word` and `value`.
    get: String,
    with: String,
}

impl<'a> MeaningModules<'a> {
    /// `derives` are attribute lines.
    pub(super) fn new(named: &'a NamedMeanings, derives: String) -> Self {
        let mut taken = HashSet::from(["Self".to_owned()]);
        let enums = named.enums.iter().map(|of| enum_view(of, &mut taken)).collect();
        Self { enums, words: named.words.iter().map(word_view).collect(), derives }
    }
}

fn enum_view<'a>(of: &'a EnumType, taken: &mut HashSet<String>) -> EnumView<'a> {
    let is_bool = of.data_type == DataType::BOOLEAN;
    let kept_as = if is_bool { DataType::UNSIGNED8 } else { of.data_type };
    let literal = |number: i128, data_type: DataType| {
        let word = number as u64; // same bits, checked to fit into 64
        value_of(ValueShape::Word(data_type), &Encoded::Word(word))
    };
    let mut names = HashSet::from(["Self".to_owned()]);
    let mut all: Vec<String> = Vec::new();
    let (mut variants, mut aliases, mut count) = (Vec::new(), Vec::new(), 0_usize);
    for value in &of.values {
        match value.alias_of {
            None => {
                let name = type_name(&value.name, &mut names);
                all.push(name.clone());
                let number = literal(value.number, kept_as);
                let patterns = std::iter::once(&value.number).chain(&value.others);
                count += 1 + value.others.len();
                let patterns: Vec<String> = patterns.map(|&number| literal(number, of.data_type)).collect();
                let pattern = patterns.join(" | ");
                variants.push(VariantView { name, label: &value.label, number, pattern });
            }
            Some(first) => {
                all.push(String::new());
                aliases.push((value, first));
            }
        }
    }
    let aliases = aliases.into_iter().map(|(value, first)| {
        let mut name = value.name.to_ascii_uppercase();
        while !names.insert(name.clone()) {
            name.push_str("_ALIAS");
        }
        AliasView { name, label: &value.label, variant: all[first].clone() }
    });
    let aliases = aliases.collect();
    let (low, high) = of.data_type.integer_range().unwrap_or((0, i128::MAX));
    EnumView {
        name: type_name(&of.name, taken),
        of,
        type_: word_type(of.data_type),
        repr: word_type(kept_as),
        is_complete: has_whole_range(of.data_type) && count as i128 == high - low + 1,
        variants,
        aliases,
    }
}

/// Whether the Rust type has the same range as the data type.
fn has_whole_range(data_type: DataType) -> bool {
    matches!(data_type.bit_length(), Some(1 | 8 | 16 | 32 | 64))
}

/// The words of a name in type notation: `ControlMode`.
fn type_name(words: &str, taken: &mut HashSet<String>) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters
            .next()
            .map_or(String::new(), |first| format!("{}{}", first.to_ascii_uppercase(), letters.as_str()))
    };
    let plain: String = words.split('_').map(capital).collect();
    let mut name = plain.clone();
    let mut number = 2_u32;
    while !taken.insert(name.clone()) {
        name = format!("{plain}N{number}");
        number += 1;
    }
    name
}

fn entries(all: &[(u16, u8)]) -> String {
    meanings::entries(all, |index, sub| format!("`0x{index:04X}` sub-index `0x{sub:02X}`"))
}

fn word_view(of: &WordType) -> WordView<'_> {
    WordView { of, parts: of.parts.iter().map(|part| part_view(of, part)).collect() }
}

fn part_view<'a>(of: &WordType, part: &'a WordPart) -> PartView<'a> {
    let bits = u32::from(of.data_type.bit_length().unwrap_or(64));
    let word_is_signed = matches!(of.data_type.kind(), TypeKind::Signed(_));
    let word = word_type(of.data_type);
    let (room, unsigned) = match word.trim_start_matches(['i', 'u']) {
        "8" => (8, "u8"),
        "16" => (16, "u16"),
        "32" => (32, "u32"),
        _ => (64, "u64"),
    };
    let type_ = word_type(part.data_type);
    let taken = format!("(word as {unsigned} & MASK) >> SHIFT");
    let get = match part.is_signed {
        true => format!("(((({taken}) as u64) << (64 - BITS)) as i64 >> (64 - BITS)) as {type_}"),
        false if type_ == "bool" => format!("word as {unsigned} & MASK != 0"),
        false => format!("({taken}) as {type_}"),
    };
    let whole = format!("(word as {unsigned} & !MASK) | ((value as {unsigned}) << SHIFT & MASK)");
    let with = match word_is_signed && bits < room {
        true => format!("(({whole}) << {0}) as {word} >> {0}", room - bits),
        false => format!("({whole}) as {word}"),
    };
    PartView {
        of: part,
        place: place(part),
        word,
        unsigned,
        type_,
        mask: super::literal::hex(part.mask),
        get,
        with,
    }
}

fn place(part: &WordPart) -> String {
    match part.bits {
        1 => format!("bit {}", part.first),
        bits => format!("bits {} to {}", part.first, part.first + bits - 1),
    }
}
