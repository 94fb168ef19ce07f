//! The plain parts of CiA 311, read and written by the schema.
//!
//! Reading compares local names and never fails: of two values for one field the first counts, and
//! everything without a place in the model goes to the [`Leftovers`].

mod fields;
mod identity;
pub(crate) mod lenses;
mod parts;
mod stack;
mod text;

#[cfg(test)]
mod tests;

use std::any::Any;

pub(crate) use self::fields::{TextField, Values};
pub(crate) use self::identity::{Identity, MarkedLabels, MarkedText, MarkedVersion};
pub(crate) use self::parts::{Part, Parts};
pub(crate) use self::stack::{stack_attribute, stack_properties, take_stack_options};
pub(crate) use self::text::Text;
use super::leftovers::Leftovers;
use super::schema::{self, At, Child, Need};
use super::xdd_writer::XddWriter;
use crate::xml::{self, Name, n};

/// Reads an element.
pub(crate) fn read<'a, T: Default + 'static>(
    element: xml::Element<'a>,
    schema: &'static schema::Element,
    leftovers: &mut Leftovers<'a>,
) -> T {
    let mut part = T::default();
    Reader { leftovers, passed_over: None }.part(element, schema, &mut part);
    part
}

/// Reads an element except its children `later`, which are only collected.
pub(crate) fn read_without<'a, T: Default + 'static>(
    element: xml::Element<'a>,
    schema: &'static schema::Element,
    later: Name,
    leftovers: &mut Leftovers<'a>,
) -> (T, Vec<xml::Element<'a>>) {
    let mut part = T::default();
    let mut reader = Reader { leftovers, passed_over: Some((later, Vec::new())) };
    reader.part(element, schema, &mut part);
    (part, reader.passed_over.map_or_else(Vec::new, |(_, found)| found))
}

struct Reader<'r, 'a> {
    leftovers: &'r mut Leftovers<'a>,
    passed_over: Option<(Name, Vec<xml::Element<'a>>)>,
}

impl<'a> Reader<'_, 'a> {
    fn part(&mut self, element: xml::Element<'a>, schema: &'static schema::Element, part: &mut dyn Any) {
        self.attributes(element, |name, text| {
            let known = if name == n::text { schema.text.as_ref() } else { Some(schema.attribute(name)?.1) };
            let At::Text(lens) = known?.at else { return None };
            Some((lens.get_mut)(part)?.accept(text))
        });
        // children are usually in order
        let mut at = 0;
        let mut fixed = 0_u32;
        for child in element.children() {
            let name = child.tag();
            let is_taken = match schema.slot(name, at) {
                None => false,
                Some((number, known)) => {
                    at = number;
                    let kept = schema.content[number].kept().find(|(known, _)| known.name == name);
                    let kept = kept.map_or(schema.content[number].at, |(_, kept)| kept);
                    let is_first = fixed & 1 << number == 0;
                    let is_taken = self.child(child, known, kept, part, is_first);
                    fixed |= u32::from(is_taken) << number;
                    is_taken
                }
            };
            if !is_taken {
                self.leftovers.element(child);
            }
        }
    }

    /// Reads a child; `false` if the part has no room for it.
    fn child(
        &mut self,
        child: xml::Element<'a>,
        schema: &'static schema::Element,
        kept: Child,
        part: &mut dyn Any,
        is_first: bool,
    ) -> bool {
        if let Some((later, found)) = &mut self.passed_over
            && child.tag() == *later
        {
            found.push(child);
            return true;
        }
        match kept {
            Child::Nowhere | Child::Either(..) => return false,
            Child::Same => self.part(child, schema, part),
            Child::Fixed(expected) => {
                let is_it = is_first && text::collapsed(&child.text()) == expected;
                if is_it {
                    self.attributes(child, |name, _| Some(name == n::text));
                    child.children().for_each(|unknown| self.leftovers.element(unknown));
                }
                return is_it;
            }
            Child::Parts(lens) => {
                let room = (lens.get_mut)(part).and_then(|parts| parts.add(child.tag()));
                let Some(part) = room else { return false };
                self.part(child, schema, part);
            }
            Child::Values(lens) => {
                let room = (lens.get_mut)(part).and_then(|values| values.add());
                let Some(field) = room else { return false };
                let holder = schema.holder();
                self.attributes(child, |name, text| Some(name == holder && field.accept(text)));
                child.children().for_each(|unknown| self.leftovers.element(unknown));
            }
        }
        true
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
pub(crate) fn write(part: &dyn Any, schema: &'static schema::Element, out: &mut XddWriter) {
    write_with(part, schema, out, &mut |_, _| {});
}

/// Writes a part as an element. `first` is called with the name of each list of parts before those of the part are written,
/// and writes what comes before them: so a long list need not be in memory.
pub(crate) fn write_with(
    part: &dyn Any,
    schema: &'static schema::Element,
    out: &mut XddWriter,
    first: &mut dyn FnMut(Name, &mut XddWriter),
) {
    out.open(schema);
    write_content(part, schema, out, first);
    out.close();
}

fn write_content(
    part: &dyn Any,
    schema: &'static schema::Element,
    out: &mut XddWriter,
    first: &mut dyn FnMut(Name, &mut XddWriter),
) {
    let text_of = |attribute: &schema::Attribute| match attribute.at {
        At::Text(lens) => (lens.get)(part).and_then(TextField::text),
        _ => None,
    };
    for attribute in schema.attributes {
        if let Some(text) = text_of(attribute) {
            out.attribute(attribute.name, &text);
        }
    }
    if let Some(text) = schema.text.as_ref().and_then(text_of) {
        out.text(&text);
    }
    for slot in schema.content {
        for (element, kept) in slot.kept() {
            // a required element is written even if it is empty
            let is_demanded = slot.least > 0 && slot.of.len() == 1;
            let open = |out: &mut XddWriter, element| match slot.need {
                Need::Stray => out.open_stray(element),
                _ => out.open(element),
            };
            match kept {
                Child::Nowhere | Child::Either(..) => {}
                Child::Same => {
                    if is_demanded {
                        out.open(element);
                    } else {
                        out.open_unless_empty(element);
                    }
                    write_content(part, element, out, first);
                    out.close();
                }
                Child::Fixed(text) => {
                    out.open(element);
                    out.text(text);
                    out.close();
                }
                Child::Parts(lens) => {
                    first(element.name, out);
                    let Some(parts) = (lens.get)(part) else { continue };
                    parts.each(&mut |name, part| {
                        let known = name.map_or(Some(element), |name| slot.element(name));
                        if let Some(element) = known {
                            open(out, element);
                            write_content(part, element, out, first);
                            out.close();
                        }
                    });
                }
                Child::Values(lens) => {
                    let Some(values) = (lens.get)(part) else { continue };
                    values.each(&mut |text| {
                        open(out, element);
                        match element.holder() {
                            n::text => out.text(text),
                            holder => out.attribute(holder, text),
                        }
                        out.close();
                    });
                }
            }
        }
    }
}

/// Visits each text of a part and of its nested parts, with the attribute that holds it.
pub(crate) fn visit(
    part: &dyn Any,
    schema: &'static schema::Element,
    see: &mut dyn FnMut(&schema::Attribute, &str),
) {
    for attribute in schema.attributes {
        if let At::Text(lens) = attribute.at
            && let Some(text) = (lens.get)(part).and_then(TextField::text)
        {
            see(attribute, &text);
        }
    }
    for (slot, (element, kept)) in
        schema.content.iter().flat_map(|slot| slot.kept().map(move |kept| (slot, kept)))
    {
        match kept {
            Child::Same => visit(part, element, see),
            Child::Parts(lens) => {
                let Some(parts) = (lens.get)(part) else { continue };
                parts.each(&mut |name, part| {
                    if let Some(element) = name.map_or(Some(element), |name| slot.element(name)) {
                        visit(part, element, see);
                    }
                });
            }
            _ => {}
        }
    }
}
