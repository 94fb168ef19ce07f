//! What can be written at the cursor.

use super::completion_item::{item, mappable};
use super::file::CheckedFile;
use super::protocol::{CompletionItem, CompletionItemKind};
use super::sections::MissingSections;
use super::{keyed, values, words};
use objdict_eds::eds::is_key_of;
use objdict_eds::ini::{Document, LineKind};
use objdict_format::Description;
use objdict_model::diagnostic::plural;
use objdict_model::model::{
    Access, DataType, Device, DeviceKind, Field, MappedObject, ObjectList, ObjectType, Part, PdoKind, Value,
};
use objdict_model::source::Span;
use objdict_profile as profile;
use objdict_profile::ObjectFacts;
use objdict_project::registry;
use objdict_xdd::xdd::words_of;
use objdict_xdd::xml::Tree;

/// The items at an offset, for an editor that expands snippets or one that does not.
pub(super) fn completion(file: &CheckedFile, offset: u32, expands_snippets: bool) -> Vec<CompletionItem> {
    if let Some(items) = rules(file, offset) {
        return items;
    }
    let Some(description) = file.description() else { return keyed::completion(file, offset) };
    if let Some(tree) = description.tree() {
        return attribute_words(file, tree, offset);
    }
    let Some(document) = description.document() else { return keyed::completion(file, offset) };
    let completer = Completer { file, description, document, offset };
    let sections = |line| {
        let device = description.device();
        MissingSections { file, device, line_end: document.line_end(), line, expands_snippets }.items()
    };
    let Some(line) = document.line_at(offset) else {
        // an empty file, or the line behind the last one
        let is_empty = document.text().trim().is_empty();
        let here = Span::empty(offset);
        return if is_empty { sections(here) } else { completer.keys(here) };
    };
    let before = Span::new(line.span.start, offset.clamp(line.span.start, line.span.end));
    match line.kind {
        LineKind::Section { .. } => sections(line.span),
        LineKind::Entry { key, value } if offset > key.end => completer.values(key, value),
        LineKind::Entry { .. } => Vec::new(),
        _ if before.of(document.text()).trim_start().starts_with('[') => sections(line.span),
        LineKind::Comment => Vec::new(),
        LineKind::Blank | LineKind::Junk => completer.keys(line.span),
    }
}

/// Ids of rules: in comments that suppress findings, and in the configuration.
fn rules(file: &CheckedFile, offset: u32) -> Option<Vec<CompletionItem>> {
    let text = file.text();
    let before = text.get(..offset as usize)?;
    let line = &before[before.rfind(['\n', '\r']).map_or(0, |end| end + 1)..];
    let is_comment = line.to_ascii_lowercase().contains("objdict: allow");
    let is_config = file.source().name().ends_with(objdict_model::source::CONFIG_FILE);
    // settings are no rules: they begin a line before the first table
    let is_setting = is_config
        && !line.contains(['=', '"', '[', ' '])
        && !before.contains("\n[")
        && !before.starts_with('[');
    if !is_comment && (!is_config || is_setting) {
        return None;
    }
    let word = file.word(offset);
    let of_rules = registry::rules().into_iter().map(|rule| (rule.id, rule.summary));
    let groups = registry::groups().into_iter().map(|group| (group, "all rules of the group"));
    let item = |(id, summary): (&str, &str)| {
        let item = item(file, word, id, id.to_owned(), CompletionItemKind::CONSTANT);
        CompletionItem { detail: Some(summary.to_owned()), ..item }
    };
    Some(groups.chain(of_rules).map(item).collect())
}

struct Completer<'a> {
    file: &'a CheckedFile,
    description: &'a Description,
    document: &'a Document,
    offset: u32,
}

impl Completer<'_> {
    fn device(&self) -> &Device {
        self.description.device()
    }

    /// The section that the cursor is in, with the keys that it has.
    fn section(&self) -> Option<(Part, Vec<Field>)> {
        let part = self.file.place(self.offset)?.part;
        let text = self.document.text();
        let mut keys = Vec::new();
        self.document.visit(
            |section| {
                let is_here = section.header.is_some_and(|header| header.line.start <= self.offset);
                if is_here {
                    keys = section.entries.iter().map(|entry| Field::from_name(entry.key.of(text))).collect();
                }
            },
            |_| {},
        );
        Some((part, keys))
    }

    /// The keys that the section does not have, with the values that the documents demand.
    fn keys(&self, line: Span) -> Vec<CompletionItem> {
        let Some((part, present)) = self.section() else { return Vec::new() };
        let is_node = self.device().kind == DeviceKind::Node;
        let of_node = Field::ParameterValue..=Field::ParamRefd;
        let is_missing = |field: &&Field| {
            is_key_of(&part, field) && !present.contains(field) && (is_node || !of_node.contains(field))
        };
        let fields = Field::NAMED.iter().map(|(_, field)| field).filter(is_missing);
        let mut items: Vec<CompletionItem> = fields
            .map(|field| {
                let value = self.demanded(&part, field).unwrap_or_default();
                let text = format!("{}={value}", field.name());
                let item = item(self.file, line, &field.name(), text, CompletionItemKind::PROPERTY);
                CompletionItem { detail: (!value.is_empty()).then_some(value), ..item }
            })
            .collect();
        if let Part::List(list) = part {
            items.extend(self.next_member(list, line));
        }
        items
    }

    /// The next line of an object list.
    fn next_member(&self, list: ObjectList, line: Span) -> Vec<CompletionItem> {
        let number = self.device().lists.get(list).len() + 1;
        let line_of = |index: u16| format!("{number}=0x{index:04X}");
        let unlisted = self.unlisted(list).into_iter();
        unlisted
            .map(|index| {
                let item = item(self.file, line, &line_of(index), line_of(index), CompletionItemKind::VALUE);
                CompletionItem { detail: words::name(self.device(), index, None), ..item }
            })
            .collect()
    }

    /// The described objects that belong into a list and are in none.
    fn unlisted(&self, list: ObjectList) -> Vec<u16> {
        let device = self.device();
        let is_missing = |index: &u16| ObjectList::of(*index) == Some(list) && !device.lists.contains(*index);
        device.objects.keys().copied().filter(is_missing).collect()
    }

    /// The value of a key of an object that the documents state.
    fn demanded(&self, part: &Part, field: &Field) -> Option<String> {
        let (index, sub) = match part {
            Part::Object(index) => (*index, None),
            Part::Entry(index, sub) => (*index, Some(*sub)),
            _ => return None,
        };
        let objects = profile::of_object(self.device(), index).map(|(_, facts)| facts);
        objects.into_iter().find_map(|facts| stated(&facts, sub, field))
    }

    fn values(&self, key: Span, value: Span) -> Vec<CompletionItem> {
        let text = self.document.text();
        let field = Field::from_name(key.of(text));
        let span = if value.is_empty() { Span::empty(self.offset) } else { value };
        let Some(part) = self.file.place(self.offset).map(|place| place.part) else { return Vec::new() };
        let choices: Vec<(String, String)> = match (&part, &field) {
            (_, Field::DataType) => DataType::STATIC
                .iter()
                .map(|data_type| {
                    (format!("0x{:04X}", data_type.0), data_type.name().unwrap_or_default().to_owned())
                })
                .collect(),
            (_, Field::AccessType) => {
                Access::ALL.iter().map(|access| (access.to_string(), String::new())).collect()
            }
            (_, Field::ObjectType) => ObjectType::ALL
                .iter()
                .map(|kind| (format!("0x{:X}", kind.code()), kind.to_string()))
                .collect(),
            (Part::List(list), Field::Item(_)) => self.with_names(self.unlisted(*list)),
            (Part::Links(_), Field::Item(_)) => {
                self.with_names(self.device().objects.keys().copied().collect())
            }
            (Part::Entry(index, 1..), Field::DefaultValue | Field::ParameterValue)
                if PdoKind::of_mapping(*index).is_some() =>
            {
                return self.mappable(*index, span);
            }
            (_, field) if is_flag(field) => {
                [("0", "no"), ("1", "yes")].map(|(number, word)| (number.to_owned(), word.to_owned())).into()
            }
            _ => {
                let demanded = self.demanded(&part, &field).map(|value| (value, "as documented".to_owned()));
                let named = named(self.device(), &part, &field);
                let is_new = |(value, _): &(String, String)| named.iter().all(|(known, _)| known != value);
                let demanded = demanded.filter(is_new);
                named.into_iter().chain(demanded).collect()
            }
        };
        choices
            .into_iter()
            .map(|(text, word)| {
                let label = if word.is_empty() { text.clone() } else { format!("{text} {word}") };
                item(self.file, span, &label, text, CompletionItemKind::VALUE)
            })
            .collect()
    }

    fn with_names(&self, indexes: Vec<u16>) -> Vec<(String, String)> {
        let name = |index: u16| words::name(self.device(), index, None).unwrap_or_default();
        indexes.into_iter().map(|index| (format!("0x{index:04X}"), name(index))).collect()
    }

    /// The entries that a PDO can carry, as values of its mapping parameter.
    fn mappable(&self, mapping: u16, span: Span) -> Vec<CompletionItem> {
        let Some((kind, _)) = PdoKind::of_mapping(mapping) else { return Vec::new() };
        let item = |mapped: MappedObject| {
            let number = format!("0x{:08X}", mapped.to_number());
            let name = words::name(self.device(), mapped.index, Some(mapped.sub)).unwrap_or_default();
            let label = format!("{number} {name}");
            let item = item(self.file, span, &label, number, CompletionItemKind::REFERENCE);
            CompletionItem { detail: Some(plural(mapped.bits.into(), "bit")), ..item }
        };
        mappable(self.device(), kind).map(item).collect()
    }
}

/// The values of an entry with meanings, if a field holds its value.
fn named(device: &Device, part: &Part, field: &Field) -> Vec<(String, String)> {
    match (part, field) {
        (Part::Object(index), Field::DefaultValue | Field::ParameterValue) => {
            values::named(device, *index, 0)
        }
        (Part::Entry(index, sub), Field::DefaultValue | Field::ParameterValue) => {
            values::named(device, *index, *sub)
        }
        _ => Vec::new(),
    }
}

fn is_flag(field: &Field) -> bool {
    let is_of_device = (Field::BaudRate10..=Field::SimpleBootUpSlave).contains(field);
    let is_other = matches!(
        field,
        Field::PdoMapping
            | Field::GroupMessaging
            | Field::LssSupported
            | Field::CanOpenManager
            | Field::SrdoMapping
    );
    is_of_device
        || is_other
        || matches!(field, Field::Named(name) if name.to_ascii_lowercase().starts_with("dummy"))
}

/// What a document states for a key.
fn stated(facts: &ObjectFacts<'_>, sub: Option<u8>, field: &Field) -> Option<String> {
    if sub.is_none() && *field == Field::ParameterName {
        return Some(facts.name.to_owned());
    }
    if sub.is_none() && *field == Field::ObjectType {
        return Some(format!("0x{:X}", facts.object_type().code()));
    }
    let entry = facts.entry(sub.unwrap_or(0)).filter(|_| sub.is_some() || !facts.object_type().has_subs())?;
    match field {
        Field::ParameterName => Some(entry.name.to_owned()).filter(|name| !name.is_empty()),
        Field::ObjectType => Some("0x7".to_owned()),
        Field::DataType => entry.data_types.first().map(|data_type| format!("0x{:04X}", data_type.0)),
        Field::AccessType => entry.access.first().map(ToString::to_string),
        Field::PdoMapping => Some(u8::from(entry.is_mappable()).to_string()),
        Field::DefaultValue => entry.default.and_then(Value::as_integer).map(|number| number.to_string()),
        _ => None,
    }
}

/// The items in the value of an attribute: the words that CiA 311 has for it.
fn attribute_words(file: &CheckedFile, tree: &Tree, offset: u32) -> Vec<CompletionItem> {
    let Some(element) = tree.element_at(offset) else { return Vec::new() };
    let is_here = |span: Span| span.start <= offset && offset <= span.end;
    let Some(attribute) = element.attributes().find(|attribute| is_here(attribute.value_span())) else {
        return Vec::new();
    };
    let span = attribute.value_span();
    let of = |label: &str, text: String| item(file, span, label, text, CompletionItemKind::VALUE);
    if attribute.name() == "dataType" {
        let known = DataType::STATIC.iter().map(|data_type| {
            let text = format!("{:04X}", data_type.0);
            of(&format!("{text} {}", data_type.name().unwrap_or_default()), text)
        });
        return known.collect();
    }
    if let Some(place) =
        file.place(offset).filter(|_| matches!(attribute.name(), "defaultValue" | "actualValue"))
    {
        let device = file.description().map(Description::device);
        let values = device.map(|device| named(device, &place.part, &Field::DefaultValue));
        let values = values.into_iter().flatten();
        return values.map(|(text, meaning)| of(&format!("{text} {meaning}"), text)).collect();
    }
    words_of(element, attribute.name()).iter().map(|word| of(word, (*word).to_owned())).collect()
}
