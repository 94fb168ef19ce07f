//! What is under the cursor.

use super::file::CheckedFile;
use super::mentions::mention_at;
use super::mentions::node_mention_at;
use super::protocol::{Hover, Markdown};
use super::words;
use objdict_format::Description;
use objdict_format::mention::{Mention, MentionKind};
use objdict_model::diagnostic::plural;
use objdict_model::model::{DataType, Field, ObjectType, Part, Place};
use objdict_model::source::Span;
use objdict_project::registry;

/// What is said of an offset.
pub(super) fn hover(file: &CheckedFile, offset: u32) -> Option<Hover> {
    let (span, text) = of_rule(file, offset)
        .or_else(|| of_description(file, offset))
        .or_else(|| of_network(file, offset))?;
    Some(Hover { contents: Markdown::new(text), range: file.positions().range(span) })
}

/// The page of the rule whose id is under the cursor.
fn of_rule(file: &CheckedFile, offset: u32) -> Option<(Span, String)> {
    let word = file.word(offset);
    let id = word.of(file.text());
    let rule = registry::rule(id).filter(|_| id.contains('/'))?;
    Some((word, words::of_rule(rule)))
}

fn of_description(file: &CheckedFile, offset: u32) -> Option<(Span, String)> {
    let description = file.description()?;
    let device = description.device();
    if let Some(mention) = mention_at(description, offset) {
        let mut text = words::of_object(device, mention.index, mention.sub);
        if mention.kind == MentionKind::Mapping {
            let place = file.place(mention.span.start)?;
            let value = of_value(description, &place).unwrap_or_default();
            text = format!("{value}\n\n---\n{text}");
        }
        return Some((mention.span, text));
    }
    let place = file.place(offset)?;
    let span = description.locate(&place)?;
    let index = place.part.object()?;
    let sub = sub_of(&place.part);
    let text = match &place.field {
        Some(Field::DataType) => of_type(description, &place).unwrap_or_default(),
        Some(Field::ObjectType) => {
            let object_type = device.object(index)?.entry(sub.unwrap_or(0))?.object_type;
            object_type.map(explained).unwrap_or_default().to_owned()
        }
        Some(Field::DefaultValue | Field::ParameterValue | Field::LowLimit | Field::HighLimit) => {
            of_value(description, &place).unwrap_or_default()
        }
        _ => String::new(),
    };
    let object = words::of_object(device, index, sub);
    Some((span, if text.is_empty() { object } else { format!("{text}\n\n---\n{object}") }))
}

fn sub_of(part: &Part) -> Option<u8> {
    if let Part::Entry(_, sub) = part { Some(*sub) } else { None }
}

fn of_value(description: &Description, place: &Place) -> Option<String> {
    let device = description.device();
    let (index, sub) = (place.part.object()?, sub_of(&place.part).unwrap_or(0));
    let entry = match (&place.part, &place.field) {
        (Part::CompactValues(_), Some(Field::Item(item))) => {
            let sub = u8::try_from(*item).ok()?;
            let value = device.object(index)?.value(sub)?;
            return Some(words::of_value(device, index, sub, &value));
        }
        _ => device.object(index)?.entry(sub)?,
    };
    let value = match place.field {
        Some(Field::LowLimit) => entry.low_limit.as_ref(),
        Some(Field::HighLimit) => entry.high_limit.as_ref(),
        Some(Field::ParameterValue) => entry.configured_value(),
        _ => entry.default.as_ref(),
    };
    Some(words::of_value(device, index, sub, value?))
}

fn of_type(description: &Description, place: &Place) -> Option<String> {
    let (index, sub) = (place.part.object()?, sub_of(&place.part).unwrap_or(0));
    let data_type: DataType = description.device().object(index)?.entry(sub)?.data_type?;
    let name = data_type.name()?;
    let bits =
        data_type.bit_length().map(|bits| format!(", {}", plural(bits as usize, "bit"))).unwrap_or_default();
    let range = data_type.integer_range().map(|(low, high)| format!(", {low} to {high}")).unwrap_or_default();
    Some(format!("data type {name} (0x{:04X}){bits}{range}", data_type.0))
}

fn explained(object_type: ObjectType) -> &'static str {
    match object_type {
        ObjectType::Domain => "DOMAIN: a block of data of any length",
        ObjectType::DefType => "DEFTYPE: the definition of a data type",
        ObjectType::DefStruct => "DEFSTRUCT: the definition of a record type",
        ObjectType::Var => "VAR: a single value",
        ObjectType::Array => "ARRAY: values of one data type; sub-index 0 is their number",
        ObjectType::Record => "RECORD: values of several data types; sub-index 0 is the highest sub-index",
        ObjectType::Null => "NULL: no data",
    }
}

/// An entry of a node: at an end of a link, in its settings, in a mapping.
fn of_network(file: &CheckedFile, offset: u32) -> Option<(Span, String)> {
    let network = file.analysis.network()?.network()?;
    let found = node_mention_at(file, offset)?;
    let node = network.nodes.get(found.node)?;
    let Mention { span, index, sub, .. } = found.mention;
    let sub = sub.or(Some(0));
    Some((span, format!("node {}\n\n{}", node.name.value, words::of_object(&node.device, index, sub))))
}
