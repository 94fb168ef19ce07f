//! View of templates/c/od_pdo.h and od_pdo.c: structs of PDO frames.

use super::view::of_node;
use super::words::{hex_bytes, word_type};
use crate::frames::{CarriedType, FrameField, PdoFrame};
use crate::model::{DataType, TypeKind};
use crate::resolve::{Encoded, ValueShape, is_time};
use crate::table::{DeviceTable, Row};

/// The content of the files.
pub(super) struct PdoFiles<'a> {
    /// The prefix of identifiers.
    lower: &'a str,
    /// The base name of the dictionary's files.
    stem: &'a str,
    upper: String,
    table: &'a DeviceTable,
    frames: Vec<FrameStruct<'a>>,
    /// Whether SDOs cannot write the mappings.
    are_fixed: bool,
}

include!("../../expanded/c/od_pdo.h.rs");
include!("../../expanded/c/od_pdo.c.rs");

/// A frame.
struct FrameStruct<'a> {
    frame: &'a PdoFrame,
    /// `od_tpdo1`.
    type_name: String,
    /// `OD_TPDO1`.
    macro_prefix: String,
    /// The COB-ID as an expression of `node_id`.
    cob_id: Option<String>,
    /// Whether a member is loaded from the struct of values.
    reads_data: bool,
    /// Whether a member is stored there.
    writes_data: bool,
    fields: Vec<FrameMember<'a>>,
}

/// A member of a frame; statements are without `;`.
struct FrameMember<'a> {
    field: &'a FrameField,
    row: &'a Row,
    declaration: String,
    load: String,
    /// Empty for constants.
    store: Vec<String>,
    /// An expression for the value as a number.
    pack: String,
    unpack: String,
}

impl<'a> PdoFiles<'a> {
    pub(super) fn new(
        table: &'a DeviceTable,
        (prefix, stem): (&'a str, &'a str),
        frames: &'a [PdoFrame],
        are_fixed: bool,
    ) -> Self {
        let frames = frames.iter().map(|frame| frame_view(table, prefix, frame)).collect();
        Self { lower: prefix, stem, upper: prefix.to_ascii_uppercase(), table, frames, are_fixed }
    }

    /// Whether a number of a kind is in a frame.
    fn uses(&self, kind: TypeKind) -> bool {
        let mut fields = self.frames.iter().flat_map(|view| &view.fields);
        fields.any(|view| matches!(view.field.carried, CarriedType::Number(number) if number.kind() == kind))
    }

    fn uses_signs(&self) -> bool {
        self.frames.iter().flat_map(|view| &view.fields).any(|view| view.field.is_signed())
    }
}

fn frame_view<'a>(table: &'a DeviceTable, prefix: &str, frame: &'a PdoFrame) -> FrameStruct<'a> {
    let fields: Vec<FrameMember<'a>> =
        frame.fields.iter().map(|field| field_view(table, prefix, field)).collect();
    let type_name = format!("{prefix}_{}", frame.name);
    FrameStruct {
        frame,
        macro_prefix: type_name.to_ascii_uppercase(),
        type_name,
        cob_id: frame.cob_id.map(|cob_id| of_node(cob_id, None)),
        reads_data: fields.iter().any(|field| field.load.contains("data->")),
        writes_data: fields.iter().any(|field| !field.store.is_empty()),
        fields,
    }
}

fn field_view<'a>(table: &'a DeviceTable, prefix: &str, field: &'a FrameField) -> FrameMember<'a> {
    let row = &table.rows[field.row];
    let name = &field.name;
    let member = format!("pdo->{name}");
    let place = row.slot.as_ref().map(|slot| format!("data->{}", table.place(slot)));
    let (first, bits) = (field.first, field.bits);
    let taken = format!("{prefix}_lowest(number >> {first}, {bits}u)");
    match field.carried {
        CarriedType::Number(data_type) => {
            let type_ = type_of(data_type, prefix);
            let (pack, unpack) = conversions(data_type, prefix, &member, &taken, bits);
            let value = place.clone().unwrap_or_else(|| constant(data_type, prefix, &row.resolved.default));
            FrameMember {
                field,
                row,
                declaration: format!("{type_} {name}"),
                load: format!("{member} = {value}"),
                store: place.into_iter().map(|place| format!("{place} = {member}")).collect(),
                pack,
                unpack: format!("{member} = {unpack}"),
            }
        }
        CarriedType::Bytes(length) => {
            let is_block = matches!(row.resolved.shape, ValueShape::Block(_));
            let source = match &place {
                Some(place) if is_block => place.clone(),
                Some(place) => format!("{place}.bytes"),
                None => constant_bytes(&row.resolved.default, length),
            };
            let store =
                place.map(|place| stored_bytes(&place, &member, length, is_block)).unwrap_or_default();
            FrameMember {
                field,
                row,
                declaration: format!("uint8_t {name}[{length}]"),
                load: format!("memcpy({member}, {source}, {length}u)"),
                store,
                pack: format!("{prefix}_from_frame({member}, {length}u)"),
                unpack: format!("{prefix}_to_frame({taken}, {member}, {length}u)"),
            }
        }
    }
}

/// Conversions of a value to a number and of a number with this many bits to a value.
fn conversions(data_type: DataType, prefix: &str, member: &str, taken: &str, bits: u32) -> (String, String) {
    let type_ = type_of(data_type, prefix);
    match data_type.kind() {
        TypeKind::Boolean => (format!("({member} ? 1u : 0u)"), format!("{taken} != 0u")),
        TypeKind::Signed(_) => {
            (format!("(uint64_t){member}"), format!("({type_}){prefix}_signed({taken}, {bits}u)"))
        }
        TypeKind::Real32 => {
            (format!("{prefix}_from_real32({member})"), format!("{prefix}_to_real32({taken})"))
        }
        TypeKind::Real64 => {
            (format!("{prefix}_from_real64({member})"), format!("{prefix}_to_real64({taken})"))
        }
        _ if is_time(data_type) => {
            (format!("{prefix}_from_time({member})"), format!("{prefix}_to_time({taken})"))
        }
        _ => (member.to_owned(), format!("({type_}){taken}")),
    }
}

fn type_of(data_type: DataType, prefix: &str) -> String {
    if is_time(data_type) { format!("{prefix}_time_t") } else { word_type(data_type).to_owned() }
}

/// The value of an entry in flash.
fn constant(data_type: DataType, prefix: &str, default: &Encoded) -> String {
    let type_ = type_of(data_type, prefix);
    match (data_type.kind(), default) {
        (_, Encoded::Formula(offset)) => format!("({type_})(0x{offset:X}u + data->node_id)"),
        (TypeKind::Boolean, Encoded::Word(word)) => format!("{}", *word != 0),
        (TypeKind::Signed(_), Encoded::Word(word)) => {
            let number = *word as i64; // same bits
            match number.checked_neg() {
                Some(positive) if number < 0 => format!("({type_})-INT64_C({positive})"),
                Some(_) => format!("({type_})INT64_C({number})"),
                None => "INT64_MIN".to_owned(),
            }
        }
        (TypeKind::Real32, Encoded::Word(word)) => format!("{prefix}_to_real32(0x{word:X}u)"),
        (TypeKind::Real64, Encoded::Word(word)) => format!("{prefix}_to_real64(UINT64_C(0x{word:X}))"),
        (_, Encoded::Word(word)) if is_time(data_type) => {
            format!("{prefix}_to_time(UINT64_C(0x{word:X}))")
        }
        (_, Encoded::Word(word)) => format!("({type_})UINT64_C(0x{word:X})"),
        (_, Encoded::Bytes(_)) => "0".to_owned(), // bytes have other shapes
    }
}

/// The bytes of an entry in flash, as many as the frame contains.
fn constant_bytes(default: &Encoded, length: u32) -> String {
    let mut bytes = default.bytes().to_vec();
    bytes.resize(length as usize, 0);
    format!("((const uint8_t[]){{{}}})", hex_bytes(&bytes))
}

/// Stores frame bytes in the struct of values; a longer member is filled with zeros.
fn stored_bytes(place: &str, member: &str, length: u32, is_block: bool) -> Vec<String> {
    if is_block {
        return vec![format!("memcpy({place}, {member}, {length}u)")];
    }
    vec![
        format!("memset({place}.bytes, 0, sizeof {place}.bytes)"),
        format!("memcpy({place}.bytes, {member}, {length}u)"),
        format!("{place}.length = {length}u"),
    ]
}
