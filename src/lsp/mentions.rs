//! Where a description mentions its objects: sections, lists, links and mappings.

use crate::format::Description;
use crate::format::eds::SectionName;
use crate::format::ini::Section;
use crate::model::{MappedObject, Part, PdoKind, Place};
use crate::source::Span;

/// What mentions an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MentionKind {
    /// The header of a section, or an element: what describes it.
    Section,
    /// An object list or a list of links.
    List,
    /// A mapping parameter.
    Mapping,
}

/// A place of the text that names an object or an entry.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mention {
    pub(super) kind: MentionKind,
    /// The name or number.
    pub(super) span: Span,
    pub(super) index: u16,
    pub(super) sub: Option<u8>,
}

impl Mention {
    /// The hex digits of the index in the text; `None` where it is written otherwise.
    pub(super) fn index_digits(&self, text: &str) -> Option<Span> {
        let name = self.span.of(text);
        let digits = format!("{:X}", self.index);
        let at = name.to_ascii_uppercase().find(&digits)? as u32;
        let start = self.span.start + at;
        Some(Span::new(start, start + digits.len() as u32))
    }
}

/// All mentions, in the order of the text.
pub(super) fn mentions(description: &Description) -> Vec<Mention> {
    let mut found = match description.document() {
        Some(document) => {
            let mut found = Vec::new();
            document.visit(|section| of_section(document.text(), section, &mut found), |_| {});
            found
        }
        None => of_model(description),
    };
    found.sort_by_key(|mention| mention.span.start);
    found
}

/// The mention that an offset is in.
pub(super) fn mention_at(description: &Description, offset: u32) -> Option<Mention> {
    let is_here = |mention: &Mention| mention.span.start <= offset && offset <= mention.span.end;
    mentions(description).into_iter().find(is_here)
}

fn of_section(text: &str, section: &Section, found: &mut Vec<Mention>) {
    let Some(header) = section.header else { return };
    let part = SectionName::parse(header.name.of(text)).part;
    if let Some(index) = part.object() {
        let sub = if let Part::Entry(_, sub) = part { Some(sub) } else { None };
        found.push(Mention { kind: MentionKind::Section, span: header.name, index, sub });
    }
    let values = section.entries.iter().map(|entry| (entry.key.of(text), entry.value));
    match part {
        Part::List(_) | Part::Links(_) => {
            let items = values.filter(|(key, _)| key.bytes().all(|byte| byte.is_ascii_digit()));
            found.extend(items.filter_map(|(_, span)| {
                let index = u16::try_from(number(span.of(text))?).ok()?;
                Some(Mention { kind: MentionKind::List, span, index, sub: None })
            }));
        }
        Part::Entry(index, 1..) | Part::CompactValues(index) if PdoKind::of_mapping(index).is_some() => {
            let is_value = |key: &str| {
                let names = ["DefaultValue", "ParameterValue"];
                matches!(part, Part::CompactValues(_)) && key.bytes().all(|byte| byte.is_ascii_digit())
                    || names.iter().any(|name| name.eq_ignore_ascii_case(key))
            };
            found.extend(
                values
                    .filter(|(key, _)| is_value(key))
                    .filter_map(|(_, span)| mapping(span, number(span.of(text))?)),
            );
        }
        _ => {}
    }
}

/// The same where the text is no INI file: the elements of objects, and the values of mapping parameters.
fn of_model(description: &Description) -> Vec<Mention> {
    let device = description.device();
    let mut found = Vec::new();
    for (&index, object) in &device.objects {
        if let Some(span) = description.locate(&Place::object(index)) {
            found.push(Mention { kind: MentionKind::Section, span, index, sub: None });
        }
        for (sub, _) in object.stated().filter(|_| PdoKind::of_mapping(index).is_some()) {
            let value = object.value(sub).and_then(|value| value.as_integer());
            let value = value.filter(|_| sub > 0).and_then(|value| u32::try_from(value).ok());
            let span = description.locate(&device.value_place(index, sub));
            found.extend(value.zip(span).and_then(|(value, span)| mapping(span, value)));
        }
    }
    found
}

fn mapping(span: Span, value: u32) -> Option<Mention> {
    let mapped = MappedObject::from_number(value);
    let is_object = !mapped.is_unused() && !mapped.is_dummy();
    let (index, sub) = (mapped.index, Some(mapped.sub));
    is_object.then_some(Mention { kind: MentionKind::Mapping, span, index, sub })
}

/// A number in hex or decimal, as lists and mappings have it.
fn number(text: &str) -> Option<u32> {
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) => u32::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}
