//! Values with places: what YAML and TOML have in common.

use std::rc::Rc;

use crate::source::Span;

/// A value and its place.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    pub(super) span: Span,
    /// Shared, because an anchor of YAML may be named more often than the text is long.
    pub(super) kind: Rc<Kind>,
}

/// What a value is.
#[derive(Clone, Debug)]
pub(super) enum Kind {
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
pub(super) struct Entry {
    pub(super) key: Tree,
    pub(super) value: Tree,
}

impl Tree {
    pub(super) fn new(span: Span, kind: Kind) -> Self {
        Self { span, kind: Rc::new(kind) }
    }

    /// The value as a text; `None` for anything else.
    pub(super) fn text(&self) -> Option<&str> {
        match &*self.kind {
            Kind::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The entries of a map; `None` for anything else.
    pub(super) fn entries(&self) -> Option<&[Entry]> {
        match &*self.kind {
            Kind::Map(entries) => Some(entries),
            _ => None,
        }
    }

    /// The value of a key of a map.
    pub(super) fn get(&self, key: &str) -> Option<&Tree> {
        let entries = self.entries()?;
        entries.iter().find(|entry| entry.key.text() == Some(key)).map(|entry| &entry.value)
    }

    /// What the value is, for messages.
    pub(super) fn kind_name(&self) -> &'static str {
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
    pub(super) fn spelled(&self) -> String {
        match &*self.kind {
            Kind::Bool(flag) => flag.to_string(),
            Kind::Integer(number) => number.to_string(),
            Kind::Float(number) => format!("{number:?}"),
            Kind::Text(text) => text.clone(),
            Kind::Null | Kind::List(_) | Kind::Map(_) => self.kind_name().to_owned(),
        }
    }
}
