//! The plain parts of CiA 311: each one declared once, and by that read from elements and written to elements.
//!
//! Reading goes by local names and never fails: of two things that can stand once the first counts, and everything that
//! has no place in the model goes to the [`Leftovers`].

#[macro_use]
mod declare;

mod application;
mod data_type;
mod device;
mod header;
mod identity;
mod label;
mod module;
mod parameter;
mod stack;
mod text;

#[cfg(test)]
mod tests;

use std::borrow::Cow;

pub(crate) use self::application::read_application_process;
pub(crate) use self::header::{ProfileClass, read_header, write_header};
pub(crate) use self::identity::Identity;
pub(crate) use self::stack::{stack_attribute, stack_properties, take_stack_options};
pub(crate) use self::text::Text;
use super::leftovers::{Leftovers, TEXT};
use super::markup::Markup;
use crate::xml::Element;

/// A part that stands in one element.
pub(crate) trait Shape: Default + PartialEq {
    /// What an element says.
    fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Self;

    /// Writes it as an element of a name.
    fn write(&self, name: &str, out: &mut Markup);
}

/// A part whose variants stand in elements of different names.
pub(crate) trait Variant: Sized {
    /// What an element says; `None` where it has none of the names.
    fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Option<Self>;

    /// Writes it.
    fn write(&self, out: &mut Markup);
}

/// A field that an attribute holds.
pub(crate) trait AttributeField {
    /// Takes a value; `false` when it has one already, or when this is none.
    fn accept(&mut self, text: &str) -> bool;

    /// Whether it has a value.
    fn is_set(&self) -> bool;

    /// The value; `None` when there is nothing to write.
    fn text(&self) -> Option<Cow<'_, str>>;
}

/// A field that elements of one name hold.
pub(crate) trait ChildField {
    /// Takes an element; `false` when it has one already and no room for more.
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool;

    /// Writes its elements.
    fn write(&self, name: &str, out: &mut Markup);
}

/// A field that elements of one name hold, each of which has one value in the attribute `holder` or as its text.
pub(crate) trait ValueField {
    /// Takes an element; `false` when it has one already and no room for more.
    fn accept<'a>(&mut self, child: Element<'a>, holder: &str, leftovers: &mut Leftovers<'a>) -> bool;

    /// Writes its elements.
    fn write(&self, name: &str, holder: &str, out: &mut Markup);
}

/// A field that elements of several names hold.
pub(crate) trait Group {
    /// Takes an element; `false` when it is none of those, or has no room any more.
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool;

    /// Writes its elements.
    fn write(&self, out: &mut Markup);
}

/// A text that is always there; missing, it is empty.
impl AttributeField for Box<str> {
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

impl<T: Text> AttributeField for Option<T> {
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

/// One that is always there; it is written when it says something.
impl<T: Shape> ChildField for T {
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool {
        let is_first = *self == T::default();
        if is_first {
            *self = T::read(child, leftovers);
        }
        is_first
    }

    fn write(&self, name: &str, out: &mut Markup) {
        if *self != T::default() {
            Shape::write(self, name, out);
        }
    }
}

impl<T: Shape> ChildField for Option<T> {
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool {
        let is_first = self.is_none();
        if is_first {
            *self = Some(T::read(child, leftovers));
        }
        is_first
    }

    fn write(&self, name: &str, out: &mut Markup) {
        self.iter().for_each(|part| Shape::write(part, name, out));
    }
}

impl<T: Shape> ChildField for Vec<T> {
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool {
        self.push(T::read(child, leftovers));
        true
    }

    fn write(&self, name: &str, out: &mut Markup) {
        self.iter().for_each(|part| Shape::write(part, name, out));
    }
}

impl<T: Shape> Shape for Box<T> {
    fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Self {
        Self::new(T::read(element, leftovers))
    }

    fn write(&self, name: &str, out: &mut Markup) {
        Shape::write(&**self, name, out);
    }
}

impl<F: AttributeField> ValueField for F {
    fn accept<'a>(&mut self, child: Element<'a>, holder: &str, leftovers: &mut Leftovers<'a>) -> bool {
        let is_first = !self.is_set();
        if is_first {
            read_attributes(child, leftovers, |name, text| {
                name == holder && AttributeField::accept(self, text)
            });
            read_children(child, leftovers, |_, _| false);
        }
        is_first
    }

    fn write(&self, name: &str, holder: &str, out: &mut Markup) {
        if self.text().is_some() {
            out.open(name);
            write_attribute(self, holder, out);
            out.close();
        }
    }
}

impl ValueField for Vec<Box<str>> {
    fn accept<'a>(&mut self, child: Element<'a>, holder: &str, leftovers: &mut Leftovers<'a>) -> bool {
        let mut text = Box::<str>::default();
        ValueField::accept(&mut text, child, holder, leftovers);
        self.push(text);
        true
    }

    fn write(&self, name: &str, holder: &str, out: &mut Markup) {
        self.iter().for_each(|text| ValueField::write(text, name, holder, out));
    }
}

impl<V: Variant> Group for Vec<V> {
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool {
        let read = V::read(child, leftovers);
        let is_one = read.is_some();
        self.extend(read);
        is_one
    }

    fn write(&self, out: &mut Markup) {
        self.iter().for_each(|variant| variant.write(out));
    }
}

/// Offers each attribute and the text of an element, which is called [`TEXT`]. What is not accepted is left over.
fn read_attributes<'a>(
    element: Element<'a>,
    leftovers: &mut Leftovers<'a>,
    mut accept: impl FnMut(&str, &str) -> bool,
) {
    for attribute in element.attributes() {
        if !accept(attribute.name(), &attribute.value()) {
            leftovers.attribute(element, attribute);
        }
    }
    // an element around others has blanks between them
    if element.has_text() {
        if !accept(TEXT, &element.text()) {
            leftovers.text(element);
        }
    } else if element.children().next().is_none() {
        accept(TEXT, &element.text());
    }
}

/// Offers each child of an element. What is not accepted is left over.
fn read_children<'a>(
    element: Element<'a>,
    leftovers: &mut Leftovers<'a>,
    mut accept: impl FnMut(Element<'a>, &mut Leftovers<'a>) -> bool,
) {
    for child in element.children() {
        if !accept(child, leftovers) {
            leftovers.element(child);
        }
    }
}

/// Writes a field as an attribute or as the text of the element that was opened last.
fn write_attribute(field: &impl AttributeField, name: &str, out: &mut Markup) {
    match field.text() {
        Some(text) if name == TEXT => out.text(&text),
        Some(text) => out.attribute(name, &text),
        None => {}
    }
}
