//! View of templates/canopen-rs/od.rs.

use askama::Template;

use super::losses::is_modelled;
use crate::dictionary::{Dictionary, ResolvedEntry};
use crate::escape::{byte_string, filters};
use crate::model::{Access, DataType, TypeKind};
use crate::names::{Scope, words};
use crate::resolve::{Datum, Shape};
use crate::rust::{value_of, word_type};

/// The file.
#[derive(Template)]
#[template(path = "canopen-rs/od.rs", escape = "none")]
pub(super) struct Od {
    made_by: String,
    product: String,
    vendor: String,
    node_id: Option<u8>,
    /// The name of the function.
    function: String,
    /// Whether an entry is stored as an octet string.
    has_octets: bool,
    /// Whether a value depends on the node-ID.
    has_formulas: bool,
    rows: Vec<Row>,
}

/// An entry.
struct Row {
    index: u16,
    sub: u8,
    /// The names of object and entry, for a comment.
    name: String,
    constant: String,
    /// A variant of `AccessType`.
    access: &'static str,
    /// An expression of type `Value`.
    value: String,
}

impl Od {
    pub(super) fn new(dictionary: &Dictionary<'_>, made_by: String, function: String) -> Self {
        let info = dictionary.device.device_info.as_ref();
        let mut constants = Scope::of_constants("");
        let mut rows = Vec::new();
        let mut has_formulas = false;
        for object in &dictionary.objects {
            let object_words = words(&object.name);
            let object_words =
                if object_words.is_empty() { format!("x{:04x}", object.index) } else { object_words };
            for entry in &object.entries {
                let (identifier, suffix, name) = if object.is_single() {
                    (object_words.clone(), format!("{:04x}", object.index), object.object.name().to_owned())
                } else {
                    let entry_words = words(&entry.name);
                    let entry_words =
                        if entry_words.is_empty() { format!("x{:02x}", entry.sub) } else { entry_words };
                    let name = format!("{} / {}", object.object.name(), entry.entry.name);
                    (
                        format!("{object_words}_{entry_words}"),
                        format!("{:04x}_{:02x}", object.index, entry.sub),
                        name,
                    )
                };
                has_formulas |= matches!(entry.resolved.default, Datum::Formula(_));
                rows.push(Row {
                    index: object.index,
                    sub: entry.sub,
                    name,
                    constant: constants.claim(&identifier, format_args!("{suffix}")).to_ascii_uppercase(),
                    access: access(entry.resolved.access),
                    value: value(entry),
                });
            }
        }
        let has_octets = rows.iter().any(|row| row.value.contains("octets("));
        Self {
            made_by,
            product: info.and_then(|info| info.product_name.clone()).unwrap_or_default(),
            vendor: info.and_then(|info| info.vendor_name.clone()).unwrap_or_default(),
            node_id: dictionary.node_id,
            function,
            has_octets,
            has_formulas,
            rows,
        }
    }
}

/// In the crate, the access type does not restrict the entry to RPDOs or TPDOs.
fn access(access: Access) -> &'static str {
    match access {
        Access::Ro => "Ro",
        Access::Wo => "Wo",
        Access::Rw | Access::Rwr | Access::Rww => "Rw",
        Access::Const => "Const",
    }
}

fn value(entry: &ResolvedEntry<'_>) -> String {
    let resolved = &entry.resolved;
    let octets = |bytes: &[u8]| format!("octets(b\"{}\")", byte_string(bytes));
    match (resolved.shape, &resolved.default) {
        (Shape::Word(data_type), datum) => match (variant(data_type), datum) {
            (Some(variant), datum) => format!("Value::{variant}({})", value_of(resolved.shape, datum)),
            (None, Datum::Word(word)) => {
                let bytes = word.to_le_bytes();
                format!("Value::OctetString({})", octets(&bytes[..resolved.shape.size().min(8)]))
            }
            (None, datum) => {
                let sum = match value_of(resolved.shape, datum) {
                    sum if sum.contains('+') => sum,
                    _ => format!("node_id as {}", word_type(data_type)),
                };
                format!("Value::OctetString(octets(&({sum}).to_le_bytes()[..{}]))", resolved.shape.size())
            }
        },
        (Shape::Bytes(data_type, _), Datum::Bytes(bytes)) => {
            let variant = match data_type.kind() {
                TypeKind::VisibleString => "VisibleString",
                TypeKind::Domain => "Domain",
                _ => "OctetString",
            };
            format!("Value::{variant}({})", octets(bytes))
        }
        (_, Datum::Bytes(bytes)) => format!("Value::OctetString({})", octets(bytes)),
        // numbers only occur with words
        (_, Datum::Word(_) | Datum::Formula(_)) => format!("Value::OctetString({})", octets(&[])),
    }
}

/// The variant of `Value` for a number; `None` for unsupported types.
fn variant(data_type: DataType) -> Option<String> {
    is_modelled(data_type).then(|| match data_type.kind() {
        TypeKind::Boolean => "Boolean".to_owned(),
        TypeKind::Real32 => "Real32".to_owned(),
        TypeKind::Real64 => "Real64".to_owned(),
        TypeKind::Signed(bits) => format!("Integer{bits}"),
        TypeKind::Unsigned(bits) => format!("Unsigned{bits}"),
        _ => String::new(), // not supported
    })
}
