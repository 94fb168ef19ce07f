//! What templates/c/od.h and od.c show.

use askama::Template;

use super::defaults::{Defaults, take_names};
use super::meanings::Meanings;
use super::stored::{self, GroupView, MemberView};
use crate::defaults::Constant;
use crate::escape::filters;
use crate::hooks;
use crate::meanings::Named;
use crate::model::{DataType, TypeKind};
use crate::names::{LONGEST, Scope};
use crate::resolve::Shape;
use crate::table::{Row, Table, TableField, TableObject};

/// The header.
#[derive(Template)]
#[template(path = "c/od.h")]
pub(super) struct Header<'a> {
    /// What identifiers start with.
    pub(super) lower: &'a str,
    pub(super) upper: String,
    pub(super) table: &'a Table,
    /// The integer type of places in RAM and flash.
    offset: &'static str,
    pub(super) objects: Vec<ObjectView<'a>>,
    /// Whether the entries have names.
    names: bool,
    pub(super) defaults: Defaults,
    pub(super) meanings: Option<Meanings<'a>>,
    /// Members of the struct of values, the structs of storage groups among them.
    pub(super) fields: Vec<MemberView<'a>>,
    pub(super) groups: Vec<GroupView<'a>>,
    /// Whether an entry has a hook.
    pub(super) hooks: bool,
}

/// What headers show beside the table.
pub(super) struct Facts {
    pub(super) constants: Vec<Constant>,
    pub(super) named: Named,
    pub(super) names: bool,
}

/// The source.
#[derive(Template)]
#[template(path = "c/od.c")]
pub(super) struct Source<'a> {
    /// What identifiers start with.
    lower: &'a str,
    upper: String,
    table: &'a Table,
    rows: Vec<RowView<'a>>,
    rom: Vec<String>,
    groups: Vec<GroupView<'a>>,
    hooks: bool,
    /// Bytes of the longest value that a hook may refuse.
    hook_room: usize,
    /// Whether rows have pointers.
    has_pointers: bool,
    names: bool,
    /// Whether `float` and `double` are used.
    real32: bool,
    real64: bool,
}

/// An object with the macros that name it and its entries.
pub(super) struct ObjectView<'a> {
    pub(super) object: &'a TableObject,
    pub(super) name: String,
    /// None for a single value.
    pub(super) entries: Vec<(String, &'a Row)>,
}

/// A member of the struct of values.
pub(super) struct FieldView<'a> {
    pub(super) declaration: String,
    pub(super) first: &'a Row,
    pub(super) last: &'a Row,
    pub(super) array: bool,
}

/// A row of the table.
struct RowView<'a> {
    row: &'a Row,
    type_: &'static str,
    flags: String,
    /// The place in RAM, `0` for none.
    ram: String,
}

/// The macros of the templates, without the prefix, in lower case.
const MACROS: &str = "
    h c ram rom_size entry_count node_id read write tpdo rpdo low high node_id_default low_node_id
    high_node_id block boolean integer8 integer16 integer24 integer32 integer40 integer48 integer56
    integer64 unsigned8 unsigned16 unsigned24 unsigned32 unsigned40 unsigned48 unsigned56 unsigned64
    real32 real64 visible_string octet_string unicode_string time_of_day time_difference domain ok
    abort_out_of_memory abort_write_only abort_read_only abort_no_object abort_length_mismatch
    abort_too_long abort_too_short abort_no_sub_index abort_invalid_value abort_too_high abort_too_low
    abort_cannot_store abort_no_data no_names no_limits no_pdo
";

impl<'a> Header<'a> {
    pub(super) fn new(table: &'a Table, prefix: &'a str, facts: &'a Facts) -> Self {
        let mut macros = Scope::of_constants(MACROS);
        take_names(&facts.constants, &mut macros);
        for taken in stored::macros(table).into_iter().chain(hook_macros(table)) {
            macros.claim(&taken, "");
        }
        // objects first, so that no entry takes the name of one
        let names: Vec<String> = table
            .objects
            .iter()
            .map(|object| macro_name(&mut macros, prefix, &object.module, &format!("{:04x}", object.index)))
            .collect();
        let objects = table
            .objects
            .iter()
            .zip(names)
            .map(|(object, name)| object_view(table, object, name, (prefix, &mut macros)))
            .collect();
        let meanings = (!facts.named.is_empty()).then(|| Meanings::new(&facts.named, prefix, &mut macros));
        Self {
            lower: prefix,
            upper: prefix.to_ascii_uppercase(),
            table,
            offset: if table.is_wide() { "uint32_t" } else { "uint16_t" },
            objects,
            names: facts.names,
            defaults: Defaults::new(&facts.constants, prefix),
            meanings,
            fields: stored::members(table, prefix),
            groups: stored::group_views(table, prefix),
            hooks: hooks::has_hooks(table),
        }
    }
}

impl<'a> Source<'a> {
    pub(super) fn new(table: &'a Table, prefix: &'a str, names: bool) -> Self {
        Self {
            lower: prefix,
            upper: prefix.to_ascii_uppercase(),
            table,
            rows: table.rows.iter().map(|row| row_view(table, row, &prefix.to_ascii_uppercase())).collect(),
            names,
            rom: table.rom.chunks(16).map(hex_bytes).collect(),
            groups: stored::group_views(table, prefix),
            hooks: hooks::has_hooks(table),
            hook_room: hooks::room(table),
            has_pointers: false,
            real32: table.keeps(DataType::REAL32),
            real64: table.keeps(DataType::REAL64),
        }
    }
}

/// What hooks may answer beside the other codes, and how they are defined.
fn hook_macros(table: &Table) -> Vec<String> {
    const MACROS: &str =
        "hook weak abort_incompatible abort_hardware abort_general abort_local_control abort_device_state";
    if hooks::has_hooks(table) { MACROS.split(' ').map(str::to_owned).collect() } else { Vec::new() }
}

fn object_view<'a>(
    table: &'a Table,
    object: &'a TableObject,
    name: String,
    (prefix, macros): (&str, &mut Scope),
) -> ObjectView<'a> {
    let rows = if object.single { &[] } else { &table.rows[object.rows.clone()] };
    let entries = rows.iter().map(|row| {
        let words = format!("{}_{}", name.trim_end_matches('_'), row.constant);
        (macro_name(macros, prefix, &words, &format!("{:04x}_{:02x}", row.index, row.sub)), row)
    });
    let entries = entries.collect();
    ObjectView { object, name, entries }
}

/// The name of a macro in lower case, short enough for the prefix before it.
pub(super) fn macro_name(macros: &mut Scope, prefix: &str, words: &str, suffix: &str) -> String {
    let room = LONGEST - prefix.len() - 2 - suffix.len(); // so that the suffix fits too
    macros.claim(&words[..words.len().min(room)], suffix)
}

pub(super) fn field_view<'a>(table: &'a Table, field: &'a TableField, prefix: &str) -> FieldView<'a> {
    let array = if field.array { format!("[{}]", field.rows.len()) } else { String::new() };
    let name = &field.name;
    let declaration = match field.shape {
        Shape::Word(data_type) if is_time(data_type) => format!("{prefix}_time_t {name}{array}"),
        Shape::Word(data_type) => format!("{} {name}{array}", word_type(data_type)),
        Shape::Bytes(_, capacity) => {
            format!("struct {{ uint16_t length; uint8_t bytes[{capacity}]; }} {name}{array}")
        }
        Shape::Block(length) => format!("uint8_t {name}{array}[{length}]"),
    };
    let (first, last) = (&table.rows[field.rows.start], &table.rows[field.rows.end - 1]);
    FieldView { declaration, first, last, array: field.array }
}

fn row_view<'a>(table: &Table, row: &'a Row, upper: &str) -> RowView<'a> {
    let type_ = type_name(row.resolved.shape);
    let flags: Vec<String> = row.flags().into_iter().map(|flag| format!("{upper}_{flag}")).collect();
    let flags = if flags.is_empty() { "0u".to_owned() } else { flags.join(" | ") };
    let ram = row.slot.map_or("0u".to_owned(), |slot| format!("{upper}_RAM({})", table.place(slot)));
    RowView { row, type_, flags, ram }
}

/// The macro of a data type, behind the prefix.
pub(super) fn type_name(shape: Shape) -> &'static str {
    match shape {
        Shape::Word(data_type) | Shape::Bytes(data_type, _) => data_type.name().unwrap_or("BLOCK"),
        Shape::Block(_) => "BLOCK",
    }
}

pub(super) fn is_time(data_type: DataType) -> bool {
    matches!(data_type.kind(), TypeKind::TimeOfDay | TypeKind::TimeDifference)
}

/// The type of a number: an integer of 24 to 56 bits is kept in the next longer one.
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
    bytes.iter().map(|byte| format!("0x{byte:02X}")).collect::<Vec<_>>().join(", ")
}
