//! The plain parts of CiA 311, read and written by the schema.
//!
//! Reading compares local names and never fails: of two values for one field the first counts, and
//! everything without a place in the model goes to the [`Leftovers`].

mod fields;
mod identity;
mod kept;
mod stack;
mod text;

#[cfg(test)]
mod tests;

pub(crate) use self::fields::{Holds, TextField, Values};
pub(crate) use self::identity::{Identity, MarkedLabels, MarkedText, MarkedVersion};
pub(crate) use self::kept::{Fixed, Keep, PartsIn, Same, ValuesIn};
pub(crate) use self::stack::{stack_attribute, stack_properties, take_stack_options};
pub(crate) use self::text::Text;
use super::leftovers::Leftovers;
use super::schema::{At, Attribute, Shape};
use super::xdd_writer::XddWriter;
use crate::xml::{self, Name, n};

/// The part of an element that is not kept, or by the code that reads it.
#[derive(Debug, Default)]
pub(crate) struct Nothing;

/// Reads an element.
pub(crate) fn read<'a, P>(
    element: xml::Element<'a>,
    shape: &'static Shape<P>,
    leftovers: &mut Leftovers<'a>,
) -> P {
    let mut part = (shape.new)();
    Reader { leftovers, passed_over: None }.part(element, shape, &mut part);
    part
}

/// Reads an element except its children `later`, which are only collected.
pub(crate) fn read_without<'a, P>(
    element: xml::Element<'a>,
    shape: &'static Shape<P>,
    later: Name,
    leftovers: &mut Leftovers<'a>,
) -> (P, Vec<xml::Element<'a>>) {
    let mut part = (shape.new)();
    let mut reader = Reader { leftovers, passed_over: Some((later, Vec::new())) };
    reader.part(element, shape, &mut part);
    (part, reader.passed_over.map_or_else(Vec::new, |(_, found)| found))
}

pub(crate) struct Reader<'r, 'a> {
    leftovers: &'r mut Leftovers<'a>,
    passed_over: Option<(Name, Vec<xml::Element<'a>>)>,
}

impl<'a> Reader<'_, 'a> {
    fn part<P>(&mut self, element: xml::Element<'a>, shape: &'static Shape<P>, part: &mut P) {
        self.attributes(element, |name, text| {
            let number = if name == n::text { shape.attributes.len() } else { shape.attribute(name)?.0 };
            let At::Text(field) = shape.values.get(number)? else { return None };
            Some((field.get_mut)(part)?.accept(text))
        });
        // children are usually in order
        let mut at = 0;
        let mut taken = 0_u32;
        for child in element.children() {
            let is_taken = shape.slot(child.tag(), at).is_some_and(|(number, _)| {
                at = number;
                let is_first = taken & 1 << number == 0;
                let is_taken = self.passes_over(child)
                    || shape.children[number].iter().any(|kept| kept.read(child, is_first, part, self));
                taken |= u32::from(is_taken) << number;
                is_taken
            });
            if !is_taken {
                self.leftovers.element(child);
            }
        }
    }

    /// Collects a child that is read later.
    fn passes_over(&mut self, child: xml::Element<'a>) -> bool {
        let Some((later, found)) = &mut self.passed_over else { return false };
        let is_later = child.tag() == *later;
        found.extend(is_later.then_some(child));
        is_later
    }

    /// Reads the value of an element that holds only this: in an attribute or the text. All else in it becomes leftovers.
    fn value(&mut self, element: xml::Element<'a>, holder: Name, accept: &mut dyn FnMut(&str) -> bool) {
        self.attributes(element, |name, text| Some(name == holder && accept(text)));
        element.children().for_each(|unknown| self.leftovers.element(unknown));
    }

    /// Passes each attribute and the text of an element to `accept`. What it does not accept becomes a
    /// leftover.
    fn attributes(&mut self, element: xml::Element<'a>, mut accept: impl FnMut(Name, &str) -> Option<bool>) {
        for attribute in element.attributes() {
            if accept(attribute.tag(), &attribute.value()) != Some(true) {
                self.leftovers.attribute(element, attribute);
            }
        }
        // an element with children contains blanks between them
        if element.has_text() {
            if accept(n::text, &element.text()) != Some(true) {
                self.leftovers.text(element);
            }
        } else if element.children().next().is_none() {
            accept(n::text, &element.text());
        }
    }
}

/// Writes a part as an element.
pub(crate) fn write<P>(part: &P, shape: &'static Shape<P>, out: &mut XddWriter) {
    write_with(part, shape, out, &mut |_, _| {});
}

/// Writes a part as an element. `first` is called with the name of each list of parts before those of the part are written,
/// and writes what comes before them: so a long list need not be in memory.
pub(crate) fn write_with<P>(
    part: &P,
    shape: &'static Shape<P>,
    out: &mut XddWriter,
    first: &mut dyn FnMut(Name, &mut XddWriter),
) {
    out.open(shape);
    write_content(part, shape, out, first);
    out.close();
}

fn write_content<P>(
    part: &P,
    shape: &'static Shape<P>,
    out: &mut XddWriter,
    first: &mut dyn FnMut(Name, &mut XddWriter),
) {
    each_text(part, shape, &mut |attribute, text| match attribute.name {
        n::text => out.text(text),
        name => out.attribute(name, text),
    });
    for (slot, kept) in shape.content.iter().zip(shape.children) {
        kept.iter().for_each(|kept| kept.write(part, slot, out, first));
    }
}

/// Visits each text of a part and of its nested parts, with the attribute that holds it.
pub(crate) fn visit<P>(part: &P, shape: &'static Shape<P>, see: &mut dyn FnMut(&Attribute, &str)) {
    each_text(part, shape, see);
    shape.children.iter().copied().flatten().for_each(|kept| kept.visit(part, see));
}

/// Visits the attributes of a part, then its text.
fn each_text<P>(part: &P, shape: &'static Shape<P>, see: &mut dyn FnMut(&Attribute, &str)) {
    for (attribute, at) in shape.attributes.iter().chain(&shape.text).zip(shape.values) {
        if let At::Text(field) = at
            && let Some(text) = (field.get)(part).and_then(TextField::text)
        {
            see(attribute, &text);
        }
    }
}
