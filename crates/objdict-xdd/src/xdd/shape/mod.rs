//! The plain parts of CiA 311, read and written by the schema.
//!
//! A `Shape<P>` links an element to the part `P` of the model that stores it: `Lens` pairs access one field,
//! `Keep` states how children are stored. A field of a different part therefore does not compile.
//!
//! Reading compares local names and never fails: of two values for one field the first is used, and
//! content without a place in the model is added to the [`Leftovers`].

pub(crate) mod facts;
mod fields;
mod kept;
mod text;

#[cfg(test)]
mod tests;

use std::borrow::Cow;
use std::ops::Deref;

pub(crate) use self::fields::{
    Holds, IdentityContent, Slots, TextField, ValueFields, stack_attribute, stack_properties,
    take_stack_options,
};
pub(crate) use self::kept::{FixedContent, PartsIn, Same, ValuesIn};
pub(crate) use self::text::TextForm;
use super::element::{Child, MAX_SLOTS, Marks, SchemaAttribute, SchemaElement};
use super::fact::Fact;
use super::leftovers::Leftovers;
use super::xdd_writer::XddWriter;
use crate::xml::{self, Name, n};

/// An element, and the mapping of its content to a part `P` of the model.
pub(crate) struct Shape<P: 'static> {
    pub element: SchemaElement,
    /// An empty part.
    pub new: fn() -> P,
    /// Whether a part is this element and not a different one of the same choice.
    pub is: fn(&P) -> bool,
    /// The storage of each attribute, followed by that of the text.
    pub values: &'static [AttributePlace<P>],
    /// The storage of the children in each slot.
    pub children: &'static [&'static [&'static (dyn Keep<P> + Sync)]],
    /// The storage of the children's marks.
    pub marks: Option<Lens<P, Marks>>,
}

impl<P> Deref for Shape<P> {
    type Target = SchemaElement;

    fn deref(&self) -> &SchemaElement {
        &self.element
    }
}

/// A field of a part: for writing, and for reading. `None` for a part without it.
pub(crate) struct Lens<P, T: ?Sized + 'static> {
    pub get: fn(&P) -> Option<&T>,
    pub get_mut: fn(&mut P) -> Option<&mut T>,
}

/// The storage of an attribute value.
pub(crate) enum AttributePlace<P> {
    /// Not stored, or stored by the code that reads the element.
    Nowhere,
    /// In a field for strings; a string that it does not accept becomes a leftover.
    Text(Lens<P, dyn TextField>),
    /// In a field that an EDS has too; a string that it does not accept becomes an invalid value.
    Fact(Lens<P, dyn Fact>),
    /// Among the values of an entry, which are read once the data type is known.
    Value(Slots),
    /// Among the marks that the part of the parent element keeps, under the name of the element; the second element of
    /// a name is `orderNumber[2]`.
    Mark,
}

/// The alternatives of a choice that a part of one type is.
pub(crate) struct ElementChoice<C: 'static> {
    pub elements: &'static [&'static SchemaElement],
    pub shapes: &'static [&'static Shape<C>],
}

/// A callback that writes content before each list of parts, by the name of the list.
pub(crate) type WriteFirst<'a> = dyn FnMut(Name, &mut XddWriter) + 'a;

/// How a part `P` keeps children.
pub(crate) trait Keep<P> {
    /// Reads a child; `false` if it has a different storage, or if the part is full.
    fn read<'a>(&self, child: xml::Element<'a>, part: &mut P, reader: &mut Reader<'_, 'a>) -> bool;

    /// Writes the children with this storage. For `first`, see [`write_with`].
    fn write(&self, part: &P, slot: &Child, out: &mut XddWriter, first: &mut WriteFirst<'_>);

    /// Visits the texts of nested parts.
    fn visit(&self, _part: &P, _see: &mut dyn FnMut(&SchemaAttribute, &str)) {}
}

/// The part of an element that is not stored, or stored by the code that reads it.
#[derive(Debug, Default)]
pub(crate) struct Nothing;

/// Reads an element.
pub(crate) fn read<'a, P>(
    element: xml::Element<'a>,
    shape: &'static Shape<P>,
    leftovers: &mut Leftovers<'a>,
) -> P {
    let mut part = (shape.new)();
    Reader::new(leftovers, None).part(element, shape, &mut part);
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
    let mut reader = Reader::new(leftovers, Some((later, Vec::new())));
    reader.part(element, shape, &mut part);
    (part, reader.passed_over.map_or_else(Vec::new, |(_, found)| found))
}

pub(crate) struct Reader<'r, 'a> {
    leftovers: &'r mut Leftovers<'a>,
    passed_over: Option<(Name, Vec<xml::Element<'a>>)>,
    /// The position of the element among those with the same name in its part.
    number: u32,
    marks: Marks,
}

impl<'r, 'a> Reader<'r, 'a> {
    fn new(leftovers: &'r mut Leftovers<'a>, passed_over: Option<(Name, Vec<xml::Element<'a>>)>) -> Self {
        Self { leftovers, passed_over, number: 0, marks: Vec::new() }
    }

    fn part<P>(&mut self, element: xml::Element<'a>, shape: &'static Shape<P>, part: &mut P) {
        let mut mark: Option<bool> = None;
        self.attributes(element, |name, text| {
            let number = if name == n::text { shape.attributes.len() } else { shape.attribute(name)?.0 };
            match shape.values.get(number)? {
                AttributePlace::Text(field) => Some((field.get_mut)(part)?.accept(text)),
                AttributePlace::Mark => Some(mark.accept(text)),
                _ => None,
            }
        });
        self.marks.extend(mark.map(|mark| (mark_name(shape, self.number), mark)));
        // children are usually in order
        let mut at = 0;
        let mut taken = [0_u32; MAX_SLOTS];
        for child in element.children() {
            let is_taken = shape.slot(child.tag(), at).is_some_and(|(slot, _)| {
                at = slot;
                self.number = taken[slot] + 1;
                let is_taken = self.passes_over(child)
                    || shape.children[slot].iter().any(|kept| kept.read(child, part, self));
                taken[slot] += u32::from(is_taken);
                is_taken
            });
            if !is_taken {
                self.leftovers.element(child);
            }
        }
        if let Some(marks) = shape.marks.as_ref().and_then(|field| (field.get_mut)(part)) {
            *marks = std::mem::take(&mut self.marks);
            let slot = |name: &str| shape.slot(Name::of(name.split('[').next().unwrap_or(name)), 0);
            marks.sort_by_key(|(name, _)| slot(name).map(|(slot, _)| slot));
        }
    }

    /// Collects a child for later reading.
    fn passes_over(&mut self, child: xml::Element<'a>) -> bool {
        let Some((later, found)) = &mut self.passed_over else { return false };
        let is_later = child.tag() == *later;
        found.extend(is_later.then_some(child));
        is_later
    }

    /// Reads the value of an element without other content: from an attribute or the text. Other content
    /// becomes leftovers.
    fn value(&mut self, element: xml::Element<'a>, holder: Name, accept: &mut dyn FnMut(&str) -> bool) {
        self.attributes(element, |name, text| Some(name == holder && accept(text)));
        element.children().for_each(|unknown| self.leftovers.element(unknown));
    }

    /// Passes each attribute and the text of an element to `accept`. Rejected strings become
    /// leftovers.
    fn attributes(&mut self, element: xml::Element<'a>, mut accept: impl FnMut(Name, &str) -> Option<bool>) {
        for attribute in element.attributes() {
            if accept(attribute.tag(), &attribute.value()) != Some(true) {
                self.leftovers.attribute(element, attribute);
            }
        }
        // an element with children contains whitespace between them
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

/// Writes a part as an element. `first` is called with the name of each list of parts before the list is written, and
/// can write items before it, so a long list need not be in memory.
pub(crate) fn write_with<P>(
    part: &P,
    shape: &'static Shape<P>,
    out: &mut XddWriter,
    first: &mut WriteFirst<'_>,
) {
    out.open(shape);
    write_content(part, shape, out, first);
    out.close();
}

fn write_content<P>(part: &P, shape: &'static Shape<P>, out: &mut XddWriter, first: &mut WriteFirst<'_>) {
    if let Some(marks) = shape.marks.as_ref().and_then(|field| (field.get)(part)) {
        out.marks = marks.clone();
    }
    for (attribute, text) in texts(part, shape) {
        match attribute.name {
            n::text => out.text(&text),
            name => out.attribute(name, &text),
        }
    }
    if shape.values.iter().any(|at| matches!(at, AttributePlace::Mark)) {
        out.mark(&mark_name(shape, out.number));
    }
    for (slot, kept) in shape.content.iter().zip(shape.children) {
        kept.iter().for_each(|kept| kept.write(part, slot, out, first));
    }
}

/// Visits each string of a part and of its nested parts, with its attribute.
pub(crate) fn visit<P>(part: &P, shape: &'static Shape<P>, see: &mut dyn FnMut(&SchemaAttribute, &str)) {
    texts(part, shape).for_each(|(attribute, text)| see(attribute, &text));
    shape.children.iter().copied().flatten().for_each(|kept| kept.visit(part, see));
}

/// The attributes of a part, then its text.
fn texts<'p, P>(
    part: &'p P,
    shape: &'static Shape<P>,
) -> impl Iterator<Item = (&'static SchemaAttribute, Cow<'p, str>)> {
    let attributes = shape.attributes.iter().chain(&shape.text).zip(shape.values);
    attributes.filter_map(move |(attribute, at)| match at {
        AttributePlace::Text(field) => Some((attribute, (field.get)(part)?.text()?)),
        _ => None,
    })
}

/// The name of an element in the list of marks.
fn mark_name(element: &SchemaElement, number: u32) -> Box<str> {
    match number {
        1 => element.name.text().into(),
        _ => format!("{}[{number}]", element.name.text()).into(),
    }
}
