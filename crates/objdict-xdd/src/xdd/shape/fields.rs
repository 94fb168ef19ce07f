//! Fields that store values as texts.

use std::borrow::Cow;

use super::Text;

/// A field for an attribute or the text of an element.
pub(crate) trait TextField {
    /// Takes a value; `false` if the field already has one or the text is not valid.
    fn accept(&mut self, text: &str) -> bool;

    /// Whether it has a value.
    fn is_set(&self) -> bool;

    /// The value; `None` if there is nothing to write.
    fn text(&self) -> Option<Cow<'_, str>>;
}

/// A field for elements with one value each.
pub(crate) trait Values {
    /// Adds a value; `None` if the field is full.
    fn add(&mut self) -> Option<&mut dyn TextField>;

    /// Calls `put` for each value.
    fn each(&self, put: &mut dyn FnMut(&str));
}

/// A text that always exists; a missing one is empty.
impl TextField for Box<str> {
    fn accept(&mut self, text: &str) -> bool {
        let is_first = !self.is_set();
        if is_first {
            *self = text.into();
        }
        is_first
    }

    fn is_set(&self) -> bool {
        !self.is_empty()
    }

    fn text(&self) -> Option<Cow<'_, str>> {
        Some(Cow::Borrowed(self))
    }
}

impl<T: Text> TextField for Option<T> {
    fn accept(&mut self, text: &str) -> bool {
        if self.is_some() {
            return false;
        }
        *self = T::parse(text);
        self.is_some()
    }

    fn is_set(&self) -> bool {
        self.is_some()
    }

    fn text(&self) -> Option<Cow<'_, str>> {
        self.as_ref().map(T::print)
    }
}

impl<F: TextField> Values for F {
    fn add(&mut self) -> Option<&mut dyn TextField> {
        if self.is_set() { None } else { Some(self) }
    }

    fn each(&self, put: &mut dyn FnMut(&str)) {
        if let Some(text) = self.text() {
            put(&text);
        }
    }
}

impl Values for Vec<Box<str>> {
    fn add(&mut self) -> Option<&mut dyn TextField> {
        self.push(Box::default());
        self.last_mut().map(|last| last as &mut dyn TextField)
    }

    fn each(&self, put: &mut dyn FnMut(&str)) {
        self.iter().for_each(|text| put(text));
    }
}
