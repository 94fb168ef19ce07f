//! View of templates/canopen-rs/od.rs.

use askama::Template;

use super::losses::is_modelled;
use crate::dictionary::{Dictionary, ResolvedEntry};
use crate::escape::{byte_string, filters};
use crate::model::{Access, DataType, TypeKind};
use crate::names::Scope;
use crate::resolve::{Datum, Shape};
use crate::rust::{value_of, word_type};
use crate::variables::{Wanted, claim};

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
        let objects = dictionary.objects.iter();
        let wanted: Vec<Wanted<'_>> = objects
            .flat_map(|object| (0..object.entries.len()).map(move |entry| (object, Some(entry))))
            .collect();
        let constants = claim(&mut Scope::of_constants(""), "", &wanted);
        let entries = dictionary
            .objects
            .iter()
            .flat_map(|object| object.entries.iter().map(move |entry| (object, entry)));
        let rows = entries.zip(constants).map(|((object, entry), constant)| Row {
            index: object.index,
            sub: entry.sub,
            name: match object.is_single() {
                true => object.object.name().to_owned(),
                false => format!("{} / {}", object.object.name(), entry.entry.name),
            },
            constant: constant.to_ascii_uppercase(),
            access: access(entry.resolved.access),
            value: value(entry),
        });
        let rows: Vec<Row> = rows.collect();
        let mut defaults =
            dictionary.objects.iter().flat_map(|object| &object.entries).map(|entry| &entry.resolved.default);
        let has_formulas = defaults.any(|default| matches!(default, Datum::Formula(_)));
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
