//! View of templates/rust/_pdo.rs: structs of PDO frames.

use super::defaults::of_node;
use super::literal::word_type;
use super::objects::path;
use crate::frames::{CarriedType, FrameField, PdoFrame};
use crate::resolve::ValueShape;
use crate::table::{DeviceTable, Row};

/// A frame.
pub(super) struct FrameView<'a> {
    pub(super) frame: &'a PdoFrame,
    /// The COB-ID as an expression of `node_id`.
    pub(super) cob_id: Option<String>,
    /// Whether a field is stored there.
    pub(super) writes_data: bool,
    pub(super) fields: Vec<FieldView<'a>>,
}

/// A field of a frame.
pub(super) struct FieldView<'a> {
    pub(super) field: &'a FrameField,
    pub(super) row: &'a Row,
    pub(super) type_: String,
    /// The value in the dictionary.
    pub(super) load: String,
    /// The statement that stores it there; `None` for constants.
    pub(super) store: Option<String>,
}

impl<'a> FrameView<'a> {
    pub(super) fn new(table: &'a DeviceTable, frame: &'a PdoFrame) -> Self {
        let fields: Vec<FieldView<'a>> = frame.fields.iter().map(|field| field_view(table, field)).collect();
        Self {
            frame,
            cob_id: frame.cob_id.map(|cob_id| of_node(cob_id, None)),
            writes_data: fields.iter().any(|field| field.store.is_some()),
            fields,
        }
    }
}

fn field_view<'a>(table: &'a DeviceTable, field: &'a FrameField) -> FieldView<'a> {
    let row = &table.rows[field.row];
    let (handle, name) = (format!("super::{}", path(table, row)), &field.name);
    let is_whole = matches!(field.carried, CarriedType::Number(_));
    let type_ = match field.carried {
        CarriedType::Number(data_type) => match word_type(data_type) {
            "Time" => "super::Time".to_owned(),
            number => number.to_owned(),
        },
        CarriedType::Bytes(length) => format!("[u8; {length}]"),
    };
    let load = match row.resolved.shape {
        _ if is_whole => format!("data.get({handle})"),
        ValueShape::Bytes(..) => format!("first(data.get({handle}))"),
        _ => format!("first(&data.get({handle}))"),
    };
    let value = match row.resolved.shape {
        _ if is_whole => format!("self.{name}"),
        ValueShape::Bytes(..) => format!("&self.{name}"),
        _ => format!("first(&self.{name})"),
    };
    let store = row.slot.map(|_| format!("data.put({handle}, {value})"));
    FieldView { field, row, type_, load, store }
}
