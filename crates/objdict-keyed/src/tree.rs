//! Values with positions: the common model of YAML and TOML.

use std::collections::BTreeMap;
use std::sync::Arc;

use objdict_model::source::Span;

/// A value and its position.
#[derive(Clone, Debug)]
pub struct KeyedTree {
    /// The bytes of the value in the text.
    pub span: Span,
    /// Shared, because YAML aliases may refer to an anchor more often than the text is long.
    pub kind: Arc<Kind>,
}

/// The kind of a value.
#[derive(Clone, Debug)]
pub enum Kind {
    /// No value.
    Null,
    /// A truth value.
    Bool(bool),
    /// An integer.
    Integer(i128),
    /// A number with a fraction.
    Float(f64),
    /// A string.
    Text(String),
    /// A list.
    List(Vec<KeyedTree>),
    /// A table, in text order.
    Map(Vec<Pair>),
}

/// A key and its value.
#[derive(Clone, Debug)]
pub struct Pair {
    /// The key, which is a string.
    pub key: KeyedTree,
    /// Its value.
    pub value: KeyedTree,
}

impl KeyedTree {
    /// A value at a span of the text.
    pub fn new(span: Span, kind: Kind) -> Self {
        Self { span, kind: Arc::new(kind) }
    }

    /// The value as a string; `None` for any other kind.
    pub fn text(&self) -> Option<&str> {
        match &*self.kind {
            Kind::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The entries of a map; `None` for any other kind.
    pub fn entries(&self) -> Option<&[Pair]> {
        match &*self.kind {
            Kind::Map(entries) => Some(entries),
            _ => None,
        }
    }

    /// The value of a key of a map.
    pub fn get(&self, key: &str) -> Option<&KeyedTree> {
        let entries = self.entries()?;
        entries.iter().find(|entry| entry.key.text() == Some(key)).map(|entry| &entry.value)
    }

    /// Merges this value over `far`: tables are merged key by key, any other value is replaced. Keys are equal if
    /// `name` returns the same for both.
    #[must_use]
    pub fn on(&self, far: &Self, name: &impl Fn(&str) -> String) -> Self {
        let (Some(above), Some(below)) = (self.entries(), far.entries()) else { return self.clone() };
        let name_of = |entry: &Pair| name(&entry.key.spelled());
        let mut nearer: BTreeMap<String, &Pair> = above.iter().map(|entry| (name_of(entry), entry)).collect();
        let mut entries: Vec<Pair> = Vec::with_capacity(below.len() + above.len());
        for entry in below {
            entries.push(match nearer.remove(&name_of(entry)) {
                None => entry.clone(),
                Some(own) => Pair { key: own.key.clone(), value: own.value.on(&entry.value, name) },
            });
        }
        entries.extend(above.iter().filter(|entry| nearer.contains_key(&name_of(entry))).cloned());
        Self::new(self.span, Kind::Map(entries))
    }

    /// The kind of the value, for messages.
    pub fn kind_name(&self) -> &'static str {
        match &*self.kind {
            Kind::Null => "nothing",
            Kind::Bool(_) => "true or false",
            Kind::Integer(_) => "a whole number",
            Kind::Float(_) => "a number with a fraction",
            Kind::Text(_) => "a string",
            Kind::List(_) => "a list",
            Kind::Map(_) => "a table of keys",
        }
    }

    /// The value as spelled in messages.
    pub fn spelled(&self) -> String {
        match &*self.kind {
            Kind::Bool(flag) => flag.to_string(),
            Kind::Integer(number) => number.to_string(),
            Kind::Float(number) => format!("{number:?}"),
            Kind::Text(text) => text.clone(),
            Kind::Null | Kind::List(_) | Kind::Map(_) => self.kind_name().to_owned(),
        }
    }
}
