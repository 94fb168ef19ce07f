//! Values with places: what YAML and TOML have in common.

use std::sync::Arc;

use crate::source::Span;

/// A value and its place.
#[derive(Clone, Debug)]
pub(in crate::format) struct Tree {
    pub(in crate::format) span: Span,
    /// Shared, because an anchor of YAML may be named more often than the text is long.
    pub(in crate::format) kind: Arc<Kind>,
}

/// What a value is.
#[derive(Clone, Debug)]
pub(in crate::format) enum Kind {
    /// Nothing.
    Null,
    Bool(bool),
    Integer(i128),
    Float(f64),
    Text(String),
    List(Vec<Tree>),
    Map(Vec<Entry>),
}

/// A key and its value.
#[derive(Clone, Debug)]
pub(in crate::format) struct Entry {
    pub(in crate::format) key: Tree,
    pub(in crate::format) value: Tree,
}

impl Tree {
    pub(in crate::format) fn new(span: Span, kind: Kind) -> Self {
        Self { span, kind: Arc::new(kind) }
    }

    /// The value as a text; `None` for anything else.
    pub(in crate::format) fn text(&self) -> Option<&str> {
        match &*self.kind {
            Kind::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The entries of a map; `None` for anything else.
    pub(in crate::format) fn entries(&self) -> Option<&[Entry]> {
        match &*self.kind {
            Kind::Map(entries) => Some(entries),
            _ => None,
        }
    }

    /// The value of a key of a map.
    pub(in crate::format) fn get(&self, key: &str) -> Option<&Tree> {
        let entries = self.entries()?;
        entries.iter().find(|entry| entry.key.text() == Some(key)).map(|entry| &entry.value)
    }

    /// What the value is, for messages.
    pub(in crate::format) fn kind_name(&self) -> &'static str {
        match &*self.kind {
            Kind::Null => "nothing",
            Kind::Bool(_) => "true or false",
            Kind::Integer(_) => "a whole number",
            Kind::Float(_) => "a number with a fraction",
            Kind::Text(_) => "a text",
            Kind::List(_) => "a list",
            Kind::Map(_) => "a table of keys",
        }
    }

    /// The value as it is spelled in messages.
    pub(in crate::format) fn spelled(&self) -> String {
        match &*self.kind {
            Kind::Bool(flag) => flag.to_string(),
            Kind::Integer(number) => number.to_string(),
            Kind::Float(number) => format!("{number:?}"),
            Kind::Text(text) => text.clone(),
            Kind::Null | Kind::List(_) | Kind::Map(_) => self.kind_name().to_owned(),
        }
    }
}
