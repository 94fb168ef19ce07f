//! Projects of objdictgen (`.od`), the generator of CanFestival: the node, its values and the descriptions of its objects as
//! Python keeps them. They are read and never written.

mod device;
mod expression;
mod mapping;
mod pickle;
pub(super) mod rules;

use std::collections::HashMap;
use std::sync::OnceLock;

pub(super) use self::pickle::is_project;
use self::pickle::{Pickle, PickleDatum};
use crate::text::{DescriptionText, ReadText};
use objdict_model::model::{Part, Place};
use objdict_model::source::{SourceFile, Span};
use objdict_xdd::xml::{ElementId, Tree};

/// A project, with the values of its objects, which are looked for when they are asked for.
#[derive(Debug)]
struct ProjectText {
    tree: Tree,
    objects: OnceLock<HashMap<u16, ElementId>>,
}

/// Reads a project: its device, and what cannot be read of it.
pub(super) fn read(tree: Tree) -> ReadText {
    let (device, findings) = device::read(&Pickle::new(&tree), tree.len());
    (Box::new(ProjectText { tree, objects: OnceLock::new() }), device, findings)
}

/// The values of the objects of a project.
fn values(tree: &Tree) -> HashMap<u16, ElementId> {
    let pickle = Pickle::new(tree);
    let dictionary = pickle.attributes().find(|(name, _)| name == "Dictionary");
    let map = dictionary.and_then(|(_, element)| match pickle.datum(element)? {
        PickleDatum::Map(map) => Some(map),
        _ => None,
    });
    let values = map.into_iter().flat_map(|map| pickle.numbered(map));
    values.map(|(index, value)| (index, value.id())).collect()
}

impl DescriptionText for ProjectText {
    fn source(&self) -> &SourceFile {
        self.tree.source()
    }

    /// The value of an object or entry; `None` for anything else.
    fn locate(&self, place: &Place) -> Option<Span> {
        let (index, sub) = match place.part {
            Part::Object(index) => (index, None),
            Part::Entry(index, sub) => (index, Some(sub)),
            _ => return None,
        };
        let objects = self.objects.get_or_init(|| values(&self.tree));
        let object = self.tree.element(*objects.get(&index)?);
        let position = sub.and_then(|sub| usize::from(sub).checked_sub(1));
        let item = position.and_then(|position| object.children_named("item").nth(position));
        Some(item.unwrap_or(object).tag_span())
    }

    fn is_project(&self) -> bool {
        true
    }
}
