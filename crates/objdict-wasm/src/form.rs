//! An object as a form: each field as the text of the file has it.

use objdict::describe::Decoder;
use objdict::format::Description;
use objdict::model::{Entry, Field, Object, Place};
use serde::Serialize;

/// An object with its entries.
#[derive(Debug, Serialize)]
pub(crate) struct ObjectForm {
    index: u16,
    name: String,
    kind: &'static str,
    /// Whether its entries are in sub-indexes.
    has_subs: bool,
    parts: Vec<PartForm>,
}

/// An object or entry with its fields.
#[derive(Debug, Serialize)]
struct PartForm {
    /// As findings name it: `0x1018sub1`.
    place: String,
    /// `None` for the object itself.
    sub: Option<u8>,
    name: String,
    data_type: Option<String>,
    /// The value in words.
    words: Option<String>,
    /// The line of its section or element, counted from 1; `None` in compact storage.
    line: Option<u32>,
    fields: Vec<FieldForm>,
}

/// A field that the text states, or that a form offers.
#[derive(Debug, Serialize)]
struct FieldForm {
    /// In the spelling of CiA 306.
    name: String,
    /// As it is in the text; `None` where the text does not state it.
    text: Option<String>,
    line: Option<u32>,
}

/// What a form shows of an object with entries.
const OF_OBJECT: [Field; 3] = [Field::ParameterName, Field::ObjectType, Field::ObjFlags];

/// What it shows of an entry, in this order.
const OF_ENTRY: [Field; 9] = [
    Field::ParameterName,
    Field::ObjectType,
    Field::DataType,
    Field::AccessType,
    Field::DefaultValue,
    Field::LowLimit,
    Field::HighLimit,
    Field::PdoMapping,
    Field::ObjFlags,
];

/// Beside these, what is configured for a node.
const OF_NODE: [Field; 1] = [Field::ParameterValue];

pub(crate) fn form(description: &Description, index: u16) -> Option<ObjectForm> {
    let device = description.described();
    let object = device.object(index)?;
    let decoder = Decoder::english(device, device.node_id());
    let is_node = device.kind == objdict::model::DeviceKind::Node;
    let has_subs = object.object_type().has_subs();
    let make = |sub: Option<u8>, entry: &Entry| {
        let place = sub.map_or_else(|| Place::object(index), |sub| Place::entry(index, sub));
        let fields = match (sub, has_subs) {
            (None, true) => &OF_OBJECT[..],
            _ => &OF_ENTRY[..],
        };
        let of_node = OF_NODE.iter().filter(|_| is_node && !(sub.is_none() && has_subs));
        let value = entry.value().filter(|_| sub.is_some() || !has_subs);
        PartForm {
            place: place.to_string(),
            sub,
            name: entry.name.to_string(),
            data_type: entry.data_type.map(|data_type| data_type.to_string()),
            words: value.and_then(|value| decoder.of(index, sub.unwrap_or_default(), value)),
            line: line(description, &place),
            fields: fields
                .iter()
                .chain(of_node)
                .map(|field| field_form(description, &place, field))
                .collect(),
        }
    };
    let entries = object.entries().filter(|_| has_subs);
    let mut parts = vec![make(None, &object.main)];
    parts.extend(entries.map(|(sub, entry)| make(Some(sub), &entry)));
    Some(ObjectForm {
        index,
        name: Object::name(object).to_owned(),
        kind: object.object_type().name(),
        has_subs,
        parts,
    })
}

fn field_form(description: &Description, place: &Place, field: &Field) -> FieldForm {
    let source = description.source();
    let place = place.clone().field(field.clone());
    let span = description.locate(&place).filter(|span| {
        // a place without a text of its own is located at its part
        let part = description.locate(&Place::of(place.part.clone()));
        part != Some(*span)
    });
    FieldForm {
        name: field.name().into_owned(),
        text: span.map(|span| span.of(source.text()).to_owned()),
        line: span.map(|span| source.line_column(span.start).line),
    }
}

fn line(description: &Description, place: &Place) -> Option<u32> {
    description.locate(place).map(|span| description.source().line_column(span.start).line)
}
