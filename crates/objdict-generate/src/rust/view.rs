//! View of templates/rust/od.rs.

use askama::Template;

use super::defaults::Defaults;
use super::meanings::Meanings;
use super::pdo::FrameView;
use super::stored::{GroupView, group_views};
use crate::defaults::Constant;
use crate::escape::{byte_string, filters};
use crate::frames::Frame;
use crate::hooks;
use crate::meanings::Named;
use crate::model::{DataType, Time, TypeKind};
use crate::resolve::{Datum, Shape};
use crate::table::{Row, Table, TableField, TableObject};
use crate::{Derive, Options};

/// The file `od.rs`.
#[derive(Template)]
#[template(path = "rust/od.rs", escape = "none")]
pub(super) struct Od<'a> {
    table: &'a Table,
    /// The integer type of offsets into RAM and flash.
    offset: &'static str,
    objects: Vec<ObjectView<'a>>,
    /// The fields without storage group.
    fields: Vec<FieldView<'a>>,
    groups: Vec<GroupView<'a>>,
    /// Whether an entry has a hook.
    hooks: bool,
    /// Size of the longest value that a hook may reject.
    hook_room: usize,
    rows: Vec<RowView<'a>>,
    rom: Vec<String>,
    defaults: Defaults,
    meanings: Option<Meanings<'a>>,
    frames: Vec<FrameView<'a>>,
    /// Whether the entries have names.
    names: bool,
    /// Whether optional parts depend on features.
    gates: bool,
    /// Traits of other crates to derive.
    defmt: bool,
    serde: bool,
}

/// An object with the constants of its entries.
struct ObjectView<'a> {
    object: &'a TableObject,
    /// Empty for a single value.
    entries: &'a [Row],
}

/// A field of `Data` or of a storage group.
pub(super) struct FieldView<'a> {
    pub(super) name: &'a str,
    /// Its first row, for the documentation.
    pub(super) first: &'a Row,
    pub(super) last: &'a Row,
    pub(super) array: bool,
    pub(super) type_: String,
    /// The default as an expression.
    pub(super) value: String,
    /// The module required by serde.
    pub(super) serde_with: Option<&'static str>,
    /// Its locations in RAM as a pattern.
    pub(super) pattern: String,
    /// Its first location.
    pub(super) place: usize,
}

/// A row of the table.
struct RowView<'a> {
    row: &'a Row,
    type_: &'static str,
    flags: String,
    /// The location in RAM; 0 for none.
    ram: usize,
}

impl<'a> Od<'a> {
    pub(super) fn new(
        table: &'a Table,
        frames: &'a [Frame],
        constants: &[Constant],
        named: &'a Named,
    ) -> Self {
        let places = places(table);
        let ram = |row: &Row| row.slot.map_or(0, |slot| places[slot.field] + slot.element.unwrap_or(0));
        let rows = table.rows.iter().map(|row| row_view(row, ram(row))).collect();
        let objects = table.objects.iter().map(|object| ObjectView {
            object,
            entries: if object.single { &[] } else { &table.rows[object.rows.clone()] },
        });
        Self {
            table,
            offset: if has_wide_places(table) { "u32" } else { "u16" },
            objects: objects.collect(),
            fields: fields_of(table, None, &places),
            groups: group_views(table, &places),
            hooks: hooks::has_hooks(table),
            hook_room: hooks::room(table),
            rows,
            rom: table.rom.chunks(16).map(hex_bytes).collect(),
            defaults: Defaults::new(constants),
            meanings: (!named.is_empty()).then(|| Meanings::new(named)),
            frames: frames.iter().map(|frame| FrameView::new(table, frame)).collect(),
            names: true,
            gates: false,
            defmt: false,
            serde: false,
        }
    }

    /// Applies the user options.
    pub(super) fn with(self, options: &Options) -> Self {
        let derives = |derive| options.derives.contains(&derive);
        let lines = derive_lines(derives(Derive::Defmt), derives(Derive::Serde), "    ");
        Self {
            names: options.entry_names,
            gates: options.feature_gates,
            defmt: derives(Derive::Defmt),
            serde: derives(Derive::Serde),
            meanings: self.meanings.map(|meanings| meanings.with(lines)),
            ..self
        }
    }

    /// The attribute lines after the standard derives, indented.
    fn derives(&self, indent: &str) -> String {
        derive_lines(self.defmt, self.serde, indent)
    }
}

/// One line per crate with derived traits.
fn derive_lines(defmt: bool, serde: bool, indent: &str) -> String {
    let line = |traits: &str| format!("\n{indent}#[derive({traits})]");
    let defmt = defmt.then(|| line("defmt::Format"));
    let serde = serde.then(|| line("serde::Serialize, serde::Deserialize"));
    [defmt, serde].into_iter().flatten().collect()
}

/// Whether field numbers or offsets into flash need more than 16 bits.
pub(super) fn has_wide_places(table: &Table) -> bool {
    let fields: usize = table.fields.iter().map(|field| field.rows.len()).sum();
    table.rom.len().max(fields + 1) > usize::from(u16::MAX)
}

/// The first location of each field; fields of a group are consecutive.
fn places(table: &Table) -> Vec<usize> {
    let mut places = vec![0; table.fields.len()];
    let mut next = 1;
    for group in std::iter::once(None).chain((0..table.groups.len()).map(Some)) {
        for (field, place) in table.fields.iter().zip(&mut places).filter(|(field, _)| field.group == group) {
            *place = next;
            next += field.rows.len();
        }
    }
    places
}

/// The fields of a group, or those without a group.
pub(super) fn fields_of<'a>(table: &'a Table, group: Option<usize>, places: &[usize]) -> Vec<FieldView<'a>> {
    let fields = table.fields.iter().zip(places).filter(|(field, _)| field.group == group);
    fields.map(|(field, &place)| field_view(table, field, place)).collect()
}

fn field_view<'a>(table: &'a Table, field: &'a TableField, place: usize) -> FieldView<'a> {
    let rows = &table.rows[field.rows.clone()];
    let element = type_of(field.shape);
    let values: Vec<String> = rows.iter().map(|row| value_of(field.shape, &row.resolved.default)).collect();
    let (type_, value) = match values.as_slice() {
        [value] if !field.array => (element, value.clone()),
        values => (format!("[{element}; {}]", rows.len()), format!("[{}]", values.join(", "))),
    };
    let serde_with = serde_with(field, rows.len());
    let last = place + rows.len() - 1;
    let pattern = if last == place { place.to_string() } else { format!("{place}..={last}") };
    let (first, last) = (&table.rows[field.rows.start], &table.rows[field.rows.end - 1]);
    FieldView { name: &field.name, first, last, array: field.array, type_, value, serde_with, pattern, place }
}

/// The module for arrays longer than serde supports.
fn serde_with(field: &TableField, rows: usize) -> Option<&'static str> {
    const LONGEST: usize = 32;
    let long_block = matches!(field.shape, Shape::Block(length) if usize::from(length) > LONGEST);
    match (field.array, long_block) {
        (true, true) => Some("serde_blocks"),
        (true, false) if rows > LONGEST => Some("serde_array"),
        (false, true) => Some("serde_array"),
        _ => None,
    }
}

fn row_view(row: &Row, ram: usize) -> RowView<'_> {
    let type_ = match row.resolved.shape {
        Shape::Word(data_type) | Shape::Bytes(data_type, _) => data_type.name().unwrap_or("BLOCK"),
        Shape::Block(_) => "BLOCK",
    };
    let flags: Vec<&str> = row.flags().collect();
    let flags = if flags.is_empty() { "0".to_owned() } else { flags.join(" | ") };
    RowView { row, type_, flags, ram }
}

/// The type of a field with one value.
fn type_of(shape: Shape) -> String {
    match shape {
        Shape::Word(data_type) => word_type(data_type).to_owned(),
        Shape::Bytes(_, capacity) => format!("Octets<{capacity}>"),
        Shape::Block(length) => format!("[u8; {length}]"),
    }
}

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
pub(crate) fn value_of(shape: Shape, datum: &Datum) -> String {
    match (shape, datum) {
        (Shape::Word(data_type), Datum::Word(word)) => word_value(data_type, *word),
        (Shape::Word(data_type), Datum::Formula(offset)) => {
            let node_id = match word_type(data_type) {
                "u8" => "node_id".to_owned(),
                type_ => format!("node_id as {type_}"),
            };
            if *offset == 0 { node_id } else { format!("{} + {node_id}", unsigned(*offset)) }
        }
        (Shape::Bytes(..), Datum::Bytes(bytes)) => format!("Octets::new(b\"{}\")", byte_string(bytes)),
        (Shape::Block(_), Datum::Bytes(bytes)) => format!("[{}]", hex_bytes(bytes)),
        // a word has a numeric default, any other shape has bytes
        (_, Datum::Bytes(_) | Datum::Word(_) | Datum::Formula(_)) => "0".to_owned(),
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
        TypeKind::Real32 => {
            let number = f32::from_bits(word as u32); // a REAL32 is in the lower half
            if number.is_finite() {
                real(&format!("{number:?}"))
            } else {
                format!("f32::from_bits({})", unsigned(word))
            }
        }
        TypeKind::Real64 => {
            let number = f64::from_bits(word);
            if number.is_finite() {
                real(&format!("{number:?}"))
            } else {
                format!("f64::from_bits({})", unsigned(word))
            }
        }
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

fn hex_bytes(bytes: &[u8]) -> String {
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
        let value = |data_type, offset| value_of(Shape::Word(data_type), &Datum::Formula(offset));
        assert_eq!(value(DataType::UNSIGNED32, 0x180), "384 + node_id as u32");
        assert_eq!(value(DataType::UNSIGNED8, 0), "node_id");
        assert_eq!(value(DataType::INTEGER16, 1000), "1000 + node_id as i16");
    }
}
