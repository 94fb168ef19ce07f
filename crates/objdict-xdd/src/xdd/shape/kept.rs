//! The storage of child elements in a part: how each is read, written and visited.

use super::{Holds, Keep, Lens, Reader, Shape, ValueFields, WriteFirst, text, visit, write_content};
use crate::xdd::element::{Child, Occurrence, SchemaAttribute, SchemaElement};
use crate::xdd::xdd_writer::XddWriter;
use crate::xml::{self, n};

/// The element groups other elements of the same part.
pub(crate) struct Same<P: 'static>(pub &'static Shape<P>);

/// The element has this constant content.
pub(crate) struct FixedContent(pub &'static SchemaElement, pub &'static str);

/// As parts `C`.
pub(crate) struct PartsIn<P, C: 'static> {
    pub shapes: &'static [&'static Shape<C>],
    pub field: Lens<P, dyn Holds<C>>,
}

/// As values: the first attribute of the element, otherwise its text.
pub(crate) struct ValuesIn<P> {
    pub element: &'static SchemaElement,
    pub field: Lens<P, dyn ValueFields>,
}

impl<P> Keep<P> for Same<P> {
    fn read<'a>(&self, child: xml::Element<'a>, part: &mut P, reader: &mut Reader<'_, 'a>) -> bool {
        let is_it = child.tag() == self.0.name;
        if is_it {
            reader.part(child, self.0, part);
        }
        is_it
    }

    fn write(&self, part: &P, slot: &Child, out: &mut XddWriter, first: &mut WriteFirst<'_>) {
        // a required element is written even if it is empty
        match slot.least > 0 && slot.of.len() == 1 {
            true => out.open(self.0),
            false => out.open_unless_empty(self.0),
        }
        write_content(part, self.0, out, first);
        out.close();
    }

    fn visit(&self, part: &P, see: &mut dyn FnMut(&SchemaAttribute, &str)) {
        visit(part, self.0, see);
    }
}

impl<P> Keep<P> for FixedContent {
    fn read<'a>(&self, child: xml::Element<'a>, _: &mut P, reader: &mut Reader<'_, 'a>) -> bool {
        let is_it = reader.number == 1 && text::collapsed(&child.text()) == self.1;
        if is_it {
            reader.value(child, n::text, &mut |_| true);
        }
        is_it
    }

    fn write(&self, _: &P, _: &Child, out: &mut XddWriter, _: &mut WriteFirst<'_>) {
        out.open(self.0);
        out.text(self.1);
        out.close();
    }
}

impl<P, C> PartsIn<P, C> {
    fn each(&self, part: &P, mut see: impl FnMut(&'static Shape<C>, &C)) {
        let Some(field) = (self.field.get)(part) else { return };
        field.each(&mut |part| {
            if let Some(shape) = self.shapes.iter().find(|shape| (shape.is)(part)) {
                see(shape, part);
            }
        });
    }
}

impl<P, C> Keep<P> for PartsIn<P, C> {
    fn read<'a>(&self, child: xml::Element<'a>, part: &mut P, reader: &mut Reader<'_, 'a>) -> bool {
        let Some(shape) = self.shapes.iter().find(|shape| shape.name == child.tag()) else { return false };
        let Some(room) = (self.field.get_mut)(part).and_then(|field| field.add(shape.new)) else {
            return false;
        };
        reader.part(child, shape, room);
        true
    }

    fn write(&self, part: &P, slot: &Child, out: &mut XddWriter, first: &mut WriteFirst<'_>) {
        first(self.shapes[0].name, out);
        let mut number = 0;
        self.each(part, |shape, part| {
            number += 1;
            out.number = number;
            open(out, slot, shape);
            write_content(part, shape, out, first);
            out.close();
        });
    }

    fn visit(&self, part: &P, see: &mut dyn FnMut(&SchemaAttribute, &str)) {
        self.each(part, |shape, part| visit(part, shape, see));
    }
}

impl<P> Keep<P> for ValuesIn<P> {
    fn read<'a>(&self, child: xml::Element<'a>, part: &mut P, reader: &mut Reader<'_, 'a>) -> bool {
        let Some(field) = (self.field.get_mut)(part).and_then(|values| values.add()) else { return false };
        reader.value(child, self.element.holder(), &mut |text| field.accept(text));
        true
    }

    fn write(&self, part: &P, slot: &Child, out: &mut XddWriter, _: &mut WriteFirst<'_>) {
        let Some(values) = (self.field.get)(part) else { return };
        values.each(&mut |text| {
            open(out, slot, self.element);
            match self.element.holder() {
                n::text => out.text(text),
                holder => out.attribute(holder, text),
            }
            out.close();
        });
    }
}

fn open(out: &mut XddWriter, slot: &Child, element: &'static SchemaElement) {
    match slot.need {
        Occurrence::Stray => out.open_stray(element),
        _ => out.open(element),
    }
}
