//! View of templates/rust/_objects.rs: objects and entries as typed constants.

use super::literal::{value_of, word_type};
use crate::escape::code_span;
use crate::model::{DataType, Device, TypeKind};
use crate::resolve::{Encoded, ValueShape};
use crate::table::{DeviceTable, Row, TableField, TableObject};

/// The areas of indexes (CiA 301 §7.4.1) as modules: name, title, first and last index.
pub(super) const AREAS: [(&str, &str, u16, u16); 5] = [
    ("data_types", "Definitions of data types", 0x0000, 0x0FFF),
    ("communication", "Communication objects", 0x1000, 0x1FFF),
    ("manufacturer", "Objects of the manufacturer", 0x2000, 0x5FFF),
    ("profile", "Objects of the device profile", 0x6000, 0x9FFF),
    ("interface", "Network variables and objects of interface profiles", 0xA000, 0xFFFF),
];

/// The modules of all areas with objects.
pub(super) struct ObjectModules<'a> {
    areas: Vec<AreaView<'a>>,
}

include!("../../expanded/rust/_objects.rs.rs");

struct AreaView<'a> {
    name: &'static str,
    title: &'static str,
    first: u16,
    last: u16,
    objects: Vec<ObjectModule<'a>>,
}

/// An object: one value, or a module of entries.
struct ObjectModule<'a> {
    object: &'a TableObject,
    array: Option<ArrayView>,
    handles: Vec<HandleView<'a>>,
}

/// An entry as a constant.
struct HandleView<'a> {
    name: String,
    /// The documentation.
    doc: String,
    row: &'a Row,
}

impl HandleView<'_> {
    /// The type of a value.
    fn type_of(&self) -> String {
        type_of(self.row.resolved.shape)
    }
}

/// Elements with a common type.
struct ArrayView {
    name: String,
    type_: String,
    access: &'static str,
    length: usize,
}

impl<'a> ObjectModules<'a> {
    pub(super) fn new(device: &Device, table: &'a DeviceTable) -> Self {
        let meanings = device.meanings();
        let unit = |row: &Row| {
            let object = device.object(row.index)?;
            let entry = object.subs.get(row.sub).unwrap_or(&object.main);
            let labels = &meanings.scaling_of(entry).unit?.labels;
            Some(labels.name_in("en")?.to_owned())
        };
        let areas = AREAS.into_iter().map(|(name, title, first, last)| {
            let objects = table.objects.iter().filter(|object| (first..=last).contains(&object.index));
            let objects = objects.map(|object| object_view(table, object, unit)).collect();
            AreaView { name, title, first, last, objects }
        });
        Self { areas: areas.filter(|area| !area.objects.is_empty()).collect() }
    }
}

fn object_view<'a>(
    table: &'a DeviceTable,
    object: &'a TableObject,
    unit: impl Fn(&Row) -> Option<String>,
) -> ObjectModule<'a> {
    let rows = &table.rows[object.rows.clone()];
    let is_array = |field: &&TableField| field.array && object.rows.contains(&field.rows.start);
    let array = table.fields.iter().find(is_array).map(|field| {
        let elements = &table.rows[field.rows.clone()];
        let kinds: Vec<&str> = elements.iter().map(access).collect();
        let is_mixed = kinds.iter().any(|kind| *kind != kinds[0]);
        ArrayView {
            name: object.module.to_ascii_uppercase(),
            type_: type_of(field.shape),
            access: if is_mixed { "Ro" } else { kinds[0] },
            length: elements.len(),
        }
    });
    let handles = rows.iter().map(|row| {
        let name = if object.single { &object.module } else { &row.constant };
        HandleView { name: name.to_ascii_uppercase(), doc: doc(row, unit(row)), row }
    });
    ObjectModule { object, array, handles: handles.collect() }
}

/// The path of an entry's constant.
pub(super) fn path(table: &DeviceTable, row: &Row) -> String {
    let object = table.objects.iter().find(|object| object.index == row.index);
    match object {
        Some(object) if object.single => object.module.to_ascii_uppercase(),
        Some(object) => format!("{}::{}", object.module, row.constant.to_ascii_uppercase()),
        None => row.constant.to_ascii_uppercase(),
    }
}

/// The type of an entry's values.
pub(super) fn type_of(shape: ValueShape) -> String {
    match shape {
        ValueShape::Word(data_type) => word_type(data_type).to_owned(),
        ValueShape::Bytes(..) => "[u8]".to_owned(),
        ValueShape::Block(length) => format!("[u8; {length}]"),
    }
}

fn access(row: &Row) -> &'static str {
    let access = row.access();
    match (row.slot.is_some(), access.is_readable(), access.is_writable()) {
        (true, true, true) => "Rw",
        (true, false, _) => "Wo",
        (true, ..) => "Ro",
        (false, ..) if !row.resolved.constant => "Elsewhere",
        (false, ..) if matches!(row.resolved.default, Encoded::Formula(_)) => "NodeConst",
        (false, ..) => "Const",
    }
}

/// Name, access, default, limits, unit and PDO mapping.
fn doc(row: &Row, unit: Option<String>) -> String {
    let resolved = &row.resolved;
    let value = |datum: &Encoded| match (resolved.shape, datum) {
        (shape @ ValueShape::Word(_), Encoded::Word(_)) => format!("`{}`", value_of(shape, datum)),
        (_, Encoded::Formula(0) | Encoded::Word(_)) => "the node-ID".to_owned(),
        (_, Encoded::Formula(offset)) => format!("`{}` plus the node-ID", super::literal::hex(*offset)),
        (ValueShape::Bytes(data_type, _), Encoded::Bytes(bytes)) if is_text(data_type, bytes) => {
            code_span(&String::from_utf8_lossy(bytes))
        }
        (_, Encoded::Bytes(bytes)) => format!("{} bytes", bytes.len()),
    };
    let mut doc =
        format!("{}, `{}`, default {}", code_span(&row.name), row.access(), value(&resolved.default));
    match (&resolved.low, &resolved.high) {
        (Some(low), Some(high)) => doc.push_str(&format!(", {} to {}", value(low), value(high))),
        (Some(low), None) => doc.push_str(&format!(", at least {}", value(low))),
        (None, Some(high)) => doc.push_str(&format!(", at most {}", value(high))),
        (None, None) => {}
    }
    if let Some(unit) = unit {
        doc.push_str(&format!(", in {}", code_span(&unit)));
    }
    doc.push_str(resolved.pdo_word(["", ", in TPDOs", ", in RPDOs", ", in any PDO"]));
    doc
}

/// Whether bytes are displayed as a string.
fn is_text(data_type: DataType, bytes: &[u8]) -> bool {
    data_type.kind() == TypeKind::VisibleString && !bytes.is_empty()
}
