//! Converts places to spans. The locator stores little: the place names its element and attribute, and the
//! tree is searched only when a finding is shown.

mod entry;
mod facts;

use std::collections::HashMap;
use std::hash::{BuildHasher, RandomState};
use std::sync::OnceLock;

use super::layout::Layout;
use super::schema;
use crate::model::{Field, ObjectList, Part, Place};
use crate::source::Span;
use crate::xml::{Attribute, Element, ElementId, Tree, n};

/// The positions of the objects of a tree, and of the targets of their references.
#[derive(Debug)]
pub struct ElementLocator {
    /// The number of the container.
    number: usize,
    objects: HashMap<u16, ElementId>,
    /// The objects of each list, in order.
    lists: [Vec<ElementId>; 3],
    state: RandomState,
    /// The hash of each id with its element, sorted by hash.
    ids: Vec<(u32, ElementId)>,
    /// The hashes of the parameters that several objects or sub-objects refer to, sorted; determined only
    /// when a parameter is changed.
    shared: OnceLock<Vec<u32>>,
}

impl ElementLocator {
    /// Finds the objects of one device of the file.
    pub fn new(tree: &Tree, number: usize) -> Self {
        let (objects, lists) = Default::default();
        let (ids, shared) = Default::default();
        let mut found = Self { number, objects, lists, state: RandomState::new(), ids, shared };
        let Some(layout) = Layout::of(tree, number) else { return found };
        for object in layout.objects() {
            let attributes = super::read::EntryAttributes::of(object);
            if let Some(index) = attributes.index() {
                found.objects.entry(index).or_insert(object.id());
                if let Some(list) = ObjectList::of(index) {
                    found.lists[list as usize].push(object.id());
                }
            }
        }
        for process in
            layout.device.iter().flat_map(|device| device.body.children_named(n::ApplicationProcess))
        {
            for element in process.descendants() {
                if let Some(id) = element.attribute(n::uniqueID) {
                    found.ids.push((found.hash(&id.value()), element.id()));
                }
            }
        }
        found.ids.sort_unstable();
        found
    }

    /// The span of a place: its attribute or element if that exists, otherwise the tag of its part.
    /// `None` for the device as a whole, and for parts that do not exist.
    pub fn locate(&self, tree: &Tree, place: &Place) -> Option<Span> {
        let layout = Layout::of(tree, self.number)?;
        let field = place.field.as_ref();
        match &place.part {
            Part::Object(index) => self.entry(tree, *index, None, field),
            Part::Entry(index, sub) => self.entry(tree, *index, Some(*sub), field),
            Part::Section(name) => section(&layout, name, field),
            Part::List(list) => {
                self.item(tree, *list, field).or_else(|| facts::locate(&layout, &place.part, field))
            }
            part => facts::locate(&layout, part, field),
        }
    }

    /// The object or sub-object at an offset, with the field of its attribute. `None` outside the object
    /// list.
    pub fn place_at(&self, tree: &Tree, offset: u32) -> Option<Place> {
        let innermost = tree.element_at(offset)?;
        let is_entry =
            |element: &Element<'_>| matches!(element.tag(), n::CANopenObject | n::CANopenSubObject);
        let element = std::iter::successors(Some(innermost), |element| element.parent()).find(is_entry)?;
        let attributes = super::read::EntryAttributes::of(element);
        let part = match element.tag() {
            n::CANopenObject => Part::Object(attributes.index()?),
            _ => {
                let object = super::read::EntryAttributes::of(element.parent()?);
                Part::Entry(object.index()?, attributes.sub_index()?)
            }
        };
        let mut attributes = element.attributes();
        let attribute = attributes.find(|attribute| attribute.span().end > offset);
        let attribute = attribute.filter(|attribute| attribute.span().start <= offset);
        let known = attribute.and_then(|attribute| schema::OBJECT.attribute(attribute.tag()));
        Some(Place { part, field: known.and_then(|(_, known)| known.field()) })
    }

    /// The element of each object, in text order; the first one if an index is defined twice.
    pub fn objects(&self, tree: &Tree) -> Vec<(u16, Span)> {
        let mut found: Vec<_> =
            self.objects.iter().map(|(&index, &id)| (index, tree.element(id).span())).collect();
        found.sort_by_key(|(_, span)| span.start);
        found
    }

    /// The object that an item of a list refers to.
    fn item(&self, tree: &Tree, list: ObjectList, field: Option<&Field>) -> Option<Span> {
        let Some(Field::Item(number)) = field else { return None };
        let position = usize::try_from(*number).ok()?.checked_sub(1)?;
        self.lists[list as usize].get(position).map(|id| tree.element(*id).tag_span())
    }

    /// The container of this locator.
    pub(super) fn layout<'a>(&self, tree: &'a Tree) -> Option<Layout<'a>> {
        Layout::of(tree, self.number)
    }

    /// The element with an id.
    fn by_id<'a>(&self, tree: &'a Tree, id: &str) -> Option<Element<'a>> {
        let hash = self.hash(id);
        let from = self.ids.partition_point(|(other, _)| *other < hash);
        let candidates = self.ids[from..].iter().take_while(|(other, _)| *other == hash);
        let mut elements = candidates.map(|(_, element)| tree.element(*element));
        elements.find(|element| element.attribute(n::uniqueID).is_some_and(|other| other.value() == id))
    }

    fn hash(&self, id: &str) -> u32 {
        self.state.hash_one(id) as u32
    }
}

/// The attribute of a field, by the schema; otherwise the attribute with the name of the field.
pub(super) fn attribute_of<'a>(
    element: Element<'a>,
    schema: &schema::SchemaElement,
    field: &Field,
) -> Option<Attribute<'a>> {
    match schema.attribute_of(field) {
        Some(known) => element.attribute(known.name),
        None => element.attribute(&*field.name()),
    }
}

/// The value of an attribute, or the whole attribute if the value is empty.
fn value_of(attribute: Attribute<'_>) -> Span {
    let value = attribute.value_span();
    if value.is_empty() { attribute.span() } else { value }
}

/// The text of an element, or its tag if it has no text.
fn text_of(element: Element<'_>) -> Span {
    let text = element.text_span();
    if text.is_empty() { element.tag_span() } else { text }
}

/// A leftover element, by the path that [`Leftovers`](super::leftovers::Leftovers) gave it.
fn section(layout: &Layout<'_>, name: &str, field: Option<&Field>) -> Option<Span> {
    let path = name.get(..4).filter(|prefix| prefix.eq_ignore_ascii_case("xml:")).map(|_| &name[4..]);
    let Some(path) = path else { return facts::carried(layout, name) };
    let bodies = [layout.device, layout.network].into_iter().flatten().map(|profile| profile.body);
    let mut roots = bodies.chain([layout.container]).chain(layout.container.parent());
    let element = roots.find_map(|root| follow(root, path))?;
    let Some(field) = field.map(Field::name) else { return Some(element.tag_span()) };
    let attribute = element.attributes().find(|attribute| attribute.name().eq_ignore_ascii_case(&field));
    Some(attribute.map_or_else(|| text_of(element), value_of))
}

/// The element at a path such as `DeviceFunction/foo[2]`.
fn follow<'a>(root: Element<'a>, path: &str) -> Option<Element<'a>> {
    let is_root = root.name().eq_ignore_ascii_case(path);
    let step = |element: Element<'a>, step: &str| {
        let (name, number) = match step.split_once('[') {
            Some((name, number)) => (name, number.strip_suffix(']')?.parse::<usize>().ok()?),
            None => (step, 1),
        };
        let mut children = element.children().filter(|child| child.name().eq_ignore_ascii_case(name));
        children.nth(number.checked_sub(1)?)
    };
    if is_root { Some(root) } else { path.split('/').try_fold(root, step) }
}
