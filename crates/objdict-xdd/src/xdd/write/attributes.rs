//! Attributes that are collected before anybody knows whether their element is written.

use crate::model::{Field, Misfits};
use crate::xdd::markup::Markup;

/// Names and values of attributes. Where a field has no value, the text that is none is written.
#[derive(Default)]
pub(super) struct Attributes<'a> {
    list: Vec<(&'static str, String)>,
    misfits: Option<&'a Misfits>,
}

impl<'a> Attributes<'a> {
    /// None yet, of a part with these misfits.
    pub(super) fn of(misfits: &'a Misfits) -> Self {
        Self { list: Vec::new(), misfits: Some(misfits) }
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// An attribute, where it has a value.
    pub(super) fn put(&mut self, name: &'static str, text: Option<String>) {
        self.list.extend(text.map(|text| (name, text)));
    }

    /// A truth value.
    pub(super) fn flag(&mut self, name: &'static str, field: &Field, flag: Option<bool>) {
        self.text(name, field, flag.map(|flag| flag.to_string()));
    }

    /// A number.
    pub(super) fn number(&mut self, name: &'static str, field: &Field, number: Option<impl Into<u64>>) {
        self.text(name, field, number.map(|number| number.into().to_string()));
    }

    /// An attribute that the standard demands.
    pub(super) fn demand(&mut self, name: &'static str, nothing: &str) {
        if !self.list.iter().any(|(known, _)| *known == name) {
            self.list.insert(0, (name, nothing.to_owned()));
        }
    }

    /// Adds them to the element that was opened last.
    pub(super) fn write(&self, out: &mut Markup) {
        self.list.iter().for_each(|(name, text)| out.attribute(name, text));
    }

    /// A text.
    pub(super) fn text(&mut self, name: &'static str, field: &Field, text: Option<String>) {
        let text = text.or_else(|| misfit(self.misfits?, field));
        self.put(name, text);
    }
}

/// The text that is no value of a field.
pub(super) fn misfit(misfits: &Misfits, field: &Field) -> Option<String> {
    misfits.get(field).map(|misfit| misfit.text.to_string())
}
