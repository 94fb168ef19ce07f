//! View of templates/canopen-rs/od.rs.

use super::losses::is_modelled;
use crate::dictionary::{ResolvedEntry, TableDictionary};
use crate::escape::byte_string;
use crate::head::Head;
use crate::model::{DataType, TypeKind};
use crate::names::NameScope;
use crate::resolve::{Encoded, ValueShape};
use crate::rust::{value_of, word_type};
use crate::variables::{WantedName, claim};

/// The file.
pub(super) struct CanOpenRsView {
    /// Its `lower` is the name of the function.
    head: Head,
    node_id: Option<u8>,
    /// Whether a value depends on the node-ID.
    has_formulas: bool,
    rows: Vec<CanOpenRsEntry>,
}

include!("../../expanded/canopen-rs/od.rs.rs");

/// An entry.
struct CanOpenRsEntry {
    index: u16,
    sub: u8,
    /// The names of object and entry, for a comment.
    name: String,
    constant: String,
    /// A variant of `AccessType`, in lower case.
    access: &'static str,
    /// An expression of type `Value`.
    value: String,
}

impl CanOpenRsView {
    pub(super) fn new(dictionary: &TableDictionary<'_>, head: Head) -> Self {
        let objects = dictionary.objects.iter();
        let wanted: Vec<WantedName<'_>> = objects
            .flat_map(|object| (0..object.entries.len()).map(move |entry| (object, Some(entry))))
            .collect();
        let constants = claim(&mut NameScope::of_constants(""), "", &wanted);
        let rows = dictionary.entries().zip(constants).map(|((object, entry), constant)| CanOpenRsEntry {
            index: object.index,
            sub: entry.sub,
            name: match object.is_single() {
                true => object.object.name().to_owned(),
                false => format!("{} / {}", object.object.name(), entry.entry.name),
            },
            constant: constant.to_ascii_uppercase(),
            access: entry.resolved.plain_access(),
            value: value(entry),
        });
        let rows = rows.collect();
        let has_formulas = dictionary.entries().any(|(_, entry)| entry.resolved.default.is_formula());
        Self { head, node_id: dictionary.node_id, has_formulas, rows }
    }

    /// Whether an entry is stored as an octet string.
    fn has_octets(&self) -> bool {
        self.rows.iter().any(|row| row.value.contains("octets("))
    }
}

fn value(entry: &ResolvedEntry<'_>) -> String {
    let resolved = &entry.resolved;
    let octets = |bytes: &[u8]| format!("octets(b\"{}\")", byte_string(bytes));
    match (resolved.shape, &resolved.default) {
        (ValueShape::Word(data_type), datum) => match (variant(data_type), datum) {
            (Some(variant), datum) => format!("Value::{variant}({})", value_of(resolved.shape, datum)),
            (None, Encoded::Word(_)) => {
                format!("Value::OctetString({})", octets(&datum.bytes_on(None, resolved.shape.size())))
            }
            (None, datum) => {
                let sum = match value_of(resolved.shape, datum) {
                    sum if sum.contains('+') => sum,
                    _ => format!("node_id as {}", word_type(data_type)),
                };
                format!("Value::OctetString(octets(&({sum}).to_le_bytes()[..{}]))", resolved.shape.size())
            }
        },
        (shape, datum) => {
            let variant = match shape.data_type().map(DataType::kind) {
                Some(TypeKind::VisibleString) => "VisibleString",
                Some(TypeKind::Domain) => "Domain",
                _ => "OctetString",
            };
            format!("Value::{variant}({})", octets(datum.bytes()))
        }
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
