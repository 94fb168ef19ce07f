//! Projects of objdictgen (`.od`), the generator of CanFestival: the node, its values and the descriptions of its objects as
//! Python keeps them. They are read and never written.

mod device;
mod expression;
mod mapping;
mod pickle;
pub(super) mod rules;

use std::collections::HashMap;

pub(super) use self::pickle::is_project;
use self::pickle::{Datum, Pickle};
use objdict_model::diagnostic::Findings;
use objdict_model::model::{Device, Part, Place};
use objdict_model::source::Span;
use objdict_xdd::xml::{ElementId, Tree};

/// The device of a project, and what cannot be read of it.
pub(super) fn read(tree: &Tree) -> (Device, Findings) {
    device::read(&Pickle::new(tree), tree.len())
}

/// The positions of the values of a project.
#[derive(Debug)]
pub(super) struct Locator {
    objects: HashMap<u16, ElementId>,
}

impl Locator {
    pub(super) fn new(tree: &Tree) -> Self {
        let pickle = Pickle::new(tree);
        let dictionary = pickle.attributes().find(|(name, _)| name == "Dictionary");
        let map = dictionary.and_then(|(_, element)| match pickle.datum(element)? {
            Datum::Map(map) => Some(map),
            _ => None,
        });
        let values = map.into_iter().flat_map(|map| pickle.numbered(map));
        Self { objects: values.map(|(index, value)| (index, value.id())).collect() }
    }

    /// The value of an object or entry; `None` for anything else.
    pub(super) fn locate(&self, tree: &Tree, place: &Place) -> Option<Span> {
        let (index, sub) = match place.part {
            Part::Object(index) => (index, None),
            Part::Entry(index, sub) => (index, Some(sub)),
            _ => return None,
        };
        let object = tree.element(*self.objects.get(&index)?);
        let position = sub.and_then(|sub| usize::from(sub).checked_sub(1));
        let item = position.and_then(|position| object.children_named("item").nth(position));
        Some(item.unwrap_or(object).tag_span())
    }
}
