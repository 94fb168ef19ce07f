//! View of templates/rust/_pdo.rs: structs of PDO frames.

use super::view::{hex, value_of, word_type};
use crate::frames::{Carried, Frame, FrameField};
use crate::model::DataType;
use crate::resolve::{Datum, Shape};
use crate::table::{Row, Table};

/// A frame.
pub(super) struct FrameView<'a> {
    pub(super) frame: &'a Frame,
    /// `Tpdo1`.
    pub(super) type_name: String,
    /// The COB-ID as an expression of `node_id`.
    pub(super) cob_id: Option<String>,
    pub(super) depends_on_node_id: bool,
    /// Whether a field is loaded from the struct of values.
    pub(super) reads_data: bool,
    /// Whether a field is stored there.
    pub(super) writes_data: bool,
    pub(super) fields: Vec<FieldView<'a>>,
}

/// A field of a frame.
pub(super) struct FieldView<'a> {
    pub(super) field: &'a FrameField,
    pub(super) row: &'a Row,
    pub(super) type_: String,
    /// An initial value of the type.
    pub(super) zero: String,
    /// The value in the dictionary, an expression of `data`.
    pub(super) load: String,
    /// Its location in the dictionary; `None` for constants.
    pub(super) place: Option<String>,
    /// The value to store, an expression of `self`.
    pub(super) store: String,
}

impl<'a> FrameView<'a> {
    pub(super) fn new(table: &'a Table, frame: &'a Frame) -> Self {
        let fields: Vec<FieldView<'a>> = frame.fields.iter().map(|field| field_view(table, field)).collect();
        let cob_id = frame.cob_id_number();
        Self {
            frame,
            type_name: frame.name.replacen(
                |c: char| c.is_ascii_lowercase(),
                &frame.name[..1].to_uppercase(),
                1,
            ),
            cob_id: cob_id.map(|(number, per_node)| match per_node {
                true => format!("{} + node_id as u32", hex(number.into())),
                false => hex(number.into()),
            }),
            depends_on_node_id: cob_id.is_some_and(|(_, per_node)| per_node),
            reads_data: fields.iter().any(|field| field.load.contains("data.")),
            writes_data: fields.iter().any(|field| field.place.is_some()),
            fields,
        }
    }
}

fn field_view<'a>(table: &'a Table, field: &'a FrameField) -> FieldView<'a> {
    let row = &table.rows[field.row];
    let place = row.slot.map(|slot| format!("data.{}", table.place(slot)));
    let name = &field.name;
    let (type_, zero) = match field.carried {
        Carried::Number(data_type) => of_number(data_type),
        Carried::Bytes(length) => (format!("[u8; {length}]"), format!("[0; {length}]")),
    };
    let load = match (&place, field.carried, row.resolved.shape) {
        (Some(place), Carried::Number(_), _) => place.clone(),
        (Some(place), Carried::Bytes(length), Shape::Bytes(..)) => {
            format!("super::Octets::<{length}>::new({place}.as_slice()).bytes")
        }
        (Some(place), Carried::Bytes(length), _) => format!("super::Octets::<{length}>::new(&{place}).bytes"),
        (None, carried, shape) => constant(carried, shape, &row.resolved.default),
    };
    let store = match row.resolved.shape {
        Shape::Word(_) => format!("self.{name}"),
        Shape::Bytes(..) => format!("super::Octets::new(&self.{name})"),
        Shape::Block(length) => format!("super::Octets::<{length}>::new(&self.{name}).bytes"),
    };
    FieldView { field, row, type_, zero, load, place, store }
}

/// The type of a number, and its zero.
fn of_number(data_type: DataType) -> (String, String) {
    match word_type(data_type) {
        "bool" => ("bool".to_owned(), "false".to_owned()),
        "Time" => ("super::Time".to_owned(), "super::Time { milliseconds: 0, days: 0 }".to_owned()),
        real @ ("f32" | "f64") => (real.to_owned(), format!("0.0_{real}")),
        integer => (integer.to_owned(), format!("0_{integer}")),
    }
}

/// The value of an entry in flash.
fn constant(carried: Carried, shape: Shape, default: &Datum) -> String {
    match (carried, default) {
        (Carried::Bytes(length), Datum::Bytes(bytes)) => {
            let bytes = crate::escape::byte_string(bytes);
            format!("super::Octets::<{length}>::new(b\"{bytes}\").bytes")
        }
        (_, Datum::Formula(_)) => {
            format!("{{ let node_id = data.node_id; {} }}", value_of(shape, default))
        }
        _ => value_of(shape, default).replace("Time {", "super::Time {"),
    }
}
