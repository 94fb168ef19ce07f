//! Names and descriptions (`g_labels`).

use super::{Group, Leftovers, Markup, Shape};
use crate::model::{Label, Labels, TextRef};
use crate::xml::Element;

variants! {
    Label {
        "label" => (Label::Name { lang, text }) ["lang" = lang, "#text" = text] {}
        "description" => (Label::Description { lang, uri, text }) ["lang" = lang, "URI" = uri, "#text" = text] {}
        "labelRef" => (Label::NameRef(TextRef { dictionary, text_id, uri }))
            ["dictID" = dictionary, "textID" = text_id, "#text" = uri] {}
        "descriptionRef" => (Label::DescriptionRef(TextRef { dictionary, text_id, uri }))
            ["dictID" = dictionary, "textID" = text_id, "#text" = uri] {}
    }
}

/// Labels that stand in a part beside its other elements.
impl Group for Labels {
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool {
        self.0.accept(child, leftovers)
    }

    fn write(&self, out: &mut Markup) {
        self.0.write(out);
    }
}

/// An element that has labels and nothing else, such as `denotation`.
impl Shape for Labels {
    fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Self {
        let mut read = Self::default();
        let labels = &mut read;
        take!(element, leftovers, [] { _ => labels });
        read
    }

    fn write(&self, name: &str, out: &mut Markup) {
        let labels = self;
        put!(out, name, [] { _ => labels });
    }
}
