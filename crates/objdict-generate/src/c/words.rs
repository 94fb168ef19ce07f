//! How the types, flags and names of a table are spelled in C.

use std::fmt::{self, Write};

use crate::model::{DataType, TypeKind};
use crate::names::{LONGEST, NameScope, clip};
use crate::resolve::{ValueShape, is_time};
use crate::table::{DeviceTable, Row, TableField};

/// A member of the struct of values.
pub(super) struct ValueMember<'a> {
    pub(super) declaration: String,
    pub(super) first: &'a Row,
    pub(super) last: &'a Row,
    pub(super) array: bool,
}

/// A macro name in lower case, short enough for the prefix. The length of its suffix is included.
pub(super) fn macro_name(
    macros: &mut NameScope,
    prefix: &str,
    words: &str,
    (suffix, length): (fmt::Arguments<'_>, usize),
) -> String {
    let room = LONGEST - prefix.len() - 2 - length; // leaves room for the suffix
    macros.claim(clip(words, room), suffix)
}

pub(super) fn field_view<'a>(table: &'a DeviceTable, field: &'a TableField, prefix: &str) -> ValueMember<'a> {
    let array = if field.array { format!("[{}]", field.rows.len()) } else { String::new() };
    let name = &field.name;
    let declaration = match field.shape {
        ValueShape::Word(data_type) if is_time(data_type) => format!("{prefix}_time_t {name}{array}"),
        ValueShape::Word(data_type) => [word_type(data_type), " ", name, &array].concat(),
        ValueShape::Bytes(_, capacity) => {
            format!("struct {{ uint16_t length; uint8_t bytes[{capacity}]; }} {name}{array}")
        }
        ValueShape::Block(length) => format!("uint8_t {name}{array}[{length}]"),
    };
    let (first, last) = (&table.rows[field.rows.start], &table.rows[field.rows.end - 1]);
    ValueMember { declaration, first, last, array: field.array }
}

/// Flags as an expression.
pub(super) fn flags(names: impl Iterator<Item = &'static str>, upper: &str) -> String {
    let mut flags = String::with_capacity(64);
    for name in names {
        let or = if flags.is_empty() { "" } else { " | " };
        flags.extend([or, upper, "_", name]);
    }
    if flags.is_empty() { "0u".to_owned() } else { flags }
}

/// The macro of a data type after the prefix.
pub(super) fn type_name(shape: ValueShape) -> &'static str {
    match shape {
        ValueShape::Word(data_type) | ValueShape::Bytes(data_type, _) => data_type.name().unwrap_or("BLOCK"),
        ValueShape::Block(_) => "BLOCK",
    }
}

/// The type of a number; integers of 24 to 56 bits use the next larger type.
pub(super) fn word_type(data_type: DataType) -> &'static str {
    match data_type.kind() {
        TypeKind::Boolean => "bool",
        TypeKind::Signed(0..=8) => "int8_t",
        TypeKind::Signed(9..=16) => "int16_t",
        TypeKind::Signed(17..=32) => "int32_t",
        TypeKind::Signed(_) => "int64_t",
        TypeKind::Unsigned(0..=8) => "uint8_t",
        TypeKind::Unsigned(9..=16) => "uint16_t",
        TypeKind::Unsigned(17..=32) => "uint32_t",
        TypeKind::Real32 => "float",
        TypeKind::Real64 => "double",
        _ => "uint64_t",
    }
}

pub(super) fn hex_bytes(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len() * 6);
    for (at, byte) in bytes.iter().enumerate() {
        let _ = write!(text, "{}0x{byte:02X}", if at == 0 { "" } else { ", " }); // writing to a String cannot fail
    }
    text
}
