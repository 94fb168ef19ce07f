//! View of an entry.

use std::borrow::Cow;

use super::anchor::Anchor;
use super::context::{CodeName, Context};
use super::details::{self, Details};
use crate::describe::ValueReader;
use crate::model::{DataType, Entry, Field, Value};
use crate::profile::ObjectFacts;

/// The view of a sub-index.
pub(crate) struct EntryView<'a> {
    pub(crate) index: u16,
    pub(crate) sub: u8,
    /// The name in the language of the page if available, otherwise the name in the file.
    pub(crate) name: Cow<'a, str>,
    /// The name in the file, if it differs from the displayed one.
    pub(crate) own_name: Option<Cow<'a, str>>,
    /// Empty if unknown.
    pub(crate) data_type: Cow<'static, str>,
    /// Length in bits, if known.
    pub(crate) bits: Option<u8>,
    /// Empty if not stated.
    pub(crate) access: &'static str,
    /// The PDO kinds that may map it: `RPDO`, `TPDO`, both, or empty.
    pub(crate) pdo: &'static str,
    /// The default value; formulas are evaluated if the node-ID is known. Empty if there is none.
    pub(crate) default: String,
    /// The value configured by a DCF.
    pub(crate) value: Option<String>,
    /// Whether the configured value differs from the default.
    pub(crate) is_changed: bool,
    /// Empty if not stated.
    pub(crate) low: String,
    /// Empty if not stated.
    pub(crate) high: String,
    /// The meaning of the value as text.
    pub(crate) meaning: Option<String>,
    pub(crate) details: Details<'a>,
    pub(crate) code: Option<&'a CodeName>,
}

impl<'a> EntryView<'a> {
    /// Creates the view; `documents` contains the definitions of the object in CiA documents.
    pub(crate) fn new(
        context: &Context<'a>,
        (index, sub): (u16, u8),
        entry: Cow<'a, Entry>,
        documents: &[ObjectFacts<'static>],
    ) -> Self {
        let reader = ValueReader { index, node_id: context.node_id };
        let field = |field: Field, value: Option<&Value>| reader.field(&entry, &field, value);
        let value = entry.configured_value().map(|value| field(Field::ParameterValue, Some(value)));
        let meaning = entry.value().and_then(|value| {
            let value = reader.resolve(value, entry.data_type);
            context.decoder.of(index, sub, &value)
        });
        let mut details = details::of(context, index, sub, &entry);
        details.add_documents(sub, &entry, documents);
        let mut view = Self {
            index,
            sub,
            name: Cow::Borrowed(""),
            own_name: None,
            data_type: data_type(&entry),
            bits: entry.data_type.and_then(DataType::bit_length),
            access: entry.access.map_or("", |access| access.name()),
            pdo: entry.pdo_directions(),
            default: field(Field::DefaultValue, entry.default.as_ref()),
            is_changed: entry.is_changed(context.node_id),
            value: value.or_else(|| {
                entry.invalid_values.get(&Field::ParameterValue).map(|invalid| format!("`{}`?", invalid.text))
            }),
            low: field(Field::LowLimit, entry.low_limit.as_ref()),
            high: field(Field::HighLimit, entry.high_limit.as_ref()),
            meaning,
            details,
            code: context.identifiers.get(&(index, Some(sub))),
        };
        (view.name, view.own_name) = context.names(entry);
        view
    }

    /// The anchor in the page.
    pub(crate) fn anchor(&self) -> Anchor {
        Anchor::entry(self.index, self.sub)
    }

    /// The sub-index: `0x0A`.
    pub(crate) fn shown_sub(&self) -> String {
        format!("0x{:02X}", self.sub)
    }

    /// Whether it has more content than name, type, access, mapping and value.
    pub(crate) fn has_more(&self) -> bool {
        self.meaning.is_some() || self.has_limits() || self.own_name.is_some() || !self.details.is_empty()
    }

    /// The identifier in generated code if only the entry's part differs from the names of its object, and
    /// the C macro if it is not composed of both.
    pub(crate) fn code_names(&self, object: &CodeName) -> Option<(&'a str, Option<&'a str>)> {
        let code = self.code?;
        let constant = code.rust.rsplit("::").next()?;
        let is_joined =
            code.c.strip_prefix(object.c.trim_end_matches('_'))?.strip_prefix('_') == Some(constant);
        Some((constant, Some(&*code.c).filter(|_| !is_joined)))
    }

    /// Whether a limit is stated.
    pub(crate) fn has_limits(&self) -> bool {
        !self.low.is_empty() || !self.high.is_empty()
    }
}

fn data_type(entry: &Entry) -> Cow<'static, str> {
    match entry.implied_type() {
        None => "".into(),
        Some(data_type) => match data_type.name() {
            Some(name) => name.into(),
            None => data_type.to_string().into(),
        },
    }
}
