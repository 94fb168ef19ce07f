//! Locates objects and sub-objects: their attributes, or the parameter that replaces them.

use super::{ElementLocator, attribute_of, text_of, value_of};
use crate::model::{Field, SimpleType};
use crate::source::Span;
use crate::xdd::layout::{Layout, below};
use crate::xdd::read::EntryAttributes;
use crate::xdd::schema::OBJECT;
use crate::xml::{Element, Name, Tree, n};

impl ElementLocator {
    /// The span of a field of an object or sub-object; for a missing sub-object, the span of its object.
    pub(super) fn entry(
        &self,
        tree: &Tree,
        index: u16,
        sub: Option<u8>,
        field: Option<&Field>,
    ) -> Option<Span> {
        let Some(element) = self.element(tree, index, sub) else {
            return self.element(tree, index, None).map(Element::tag_span);
        };
        let Some(field) = field else { return Some(element.tag_span()) };
        // projects of CANopenNode have other names for the limits
        let other = || EntryAttributes::of(element).get(OBJECT.attribute_of(field)?.name);
        let attribute = attribute_of(element, OBJECT, field).or_else(other).map(value_of);
        let parameter = || self.in_parameter(tree, element, field);
        attribute.or_else(parameter).or(Some(element.tag_span()))
    }

    /// The element of an object or sub-object.
    pub(in crate::xdd) fn element<'a>(
        &self,
        tree: &'a Tree,
        index: u16,
        sub: Option<u8>,
    ) -> Option<Element<'a>> {
        let object = tree.element(*self.objects.get(&index)?);
        let is_sub = |child: &Element<'_>| EntryAttributes::of(*child).sub_index() == sub;
        if sub.is_none() { Some(object) } else { object.children_named(n::CANopenSubObject).find(is_sub) }
    }

    /// The span of a field in the parameter of an element.
    pub(in crate::xdd) fn in_parameter(
        &self,
        tree: &Tree,
        element: Element<'_>,
        field: &Field,
    ) -> Option<Span> {
        let id = element.attribute(n::uniqueIDRef)?;
        let parameter = self.by_id(tree, id.value().trim_ascii())?;
        let value = |path: &[Name]| below(parameter, path)?.attribute(n::value).map(value_of);
        match field {
            Field::ParameterName => parameter.child(n::label).map(text_of),
            Field::DataType => parameter.children().find(is_type).map(Element::tag_span),
            Field::AccessType => parameter.attribute(n::access).map(value_of),
            Field::DefaultValue => value(&[n::defaultValue]),
            Field::ParameterValue => value(&[n::actualValue]),
            Field::LowLimit => value(&[n::allowedValues, n::range, n::minValue]),
            Field::HighLimit => value(&[n::allowedValues, n::range, n::maxValue]),
            Field::Denotation => below(parameter, &[n::denotation, n::label]).map(text_of),
            _ => None,
        }
    }

    /// Whether no other object or sub-object has the parameter of an element.
    pub(in crate::xdd) fn has_own_parameter(&self, tree: &Tree, element: Element<'_>) -> bool {
        let reference = |element: Element<'_>| {
            let id = element.attribute(n::uniqueIDRef)?;
            Some(self.hash(id.value().trim_ascii()))
        };
        let shared = self.shared.get_or_init(|| {
            let layout = self.layout(tree);
            let objects = layout.iter().flat_map(Layout::objects);
            let entries = objects
                .flat_map(|object| std::iter::once(object).chain(object.children_named(n::CANopenSubObject)));
            let mut all: Vec<u32> = entries.filter_map(reference).collect();
            all.sort_unstable();
            let several = all.chunk_by(|one, next| one == next).filter(|same| same.len() > 1);
            several.map(|same| same[0]).collect()
        });
        reference(element).is_some_and(|hash| shared.binary_search(&hash).is_err())
    }
}

fn is_type(element: &Element<'_>) -> bool {
    SimpleType::from_name(element.tag().text()).is_some() || element.tag() == n::dataTypeIDRef
}
