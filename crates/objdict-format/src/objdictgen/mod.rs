//! Projects of objdictgen (`.od`), the generator of CanFestival: the node, its values and the descriptions of its
//! objects, serialised by Python. Read-only.

mod device;
mod expression;
mod mapping;
mod pickle;

use std::collections::HashMap;
use std::sync::OnceLock;

pub(super) use self::pickle::is_project;
use self::pickle::{Pickle, PickleDatum};
use crate::text::{DescriptionText, ReadText};
use objdict_model::diagnostic::text_rules;
use objdict_model::model::{Part, Place};
use objdict_model::source::{SourceFile, Span};
use objdict_xdd::xml::{ElementId, Tree};

/// A project, with the values of its objects, which are located on demand.
#[derive(Debug)]
struct ProjectText {
    tree: Tree,
    objects: OnceLock<HashMap<u16, ElementId>>,
}

/// Reads a project: its device, and its unreadable content.
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

    /// The value of an object or entry; `None` for any other place.
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

text_rules! {
    source: "CanFestival 3, objdictgen";

    "objdictgen/not-read" = NOT_READ, Warning;
    summary: "a part of the project cannot be read",
    checks: "Each part of an objdictgen project must have the format that objdictgen writes. Where objdictgen has a number, a string, a list or a map, the project must have one too. Lists may have at most 254 values, and names at most 241 characters.",
    why: "The part is omitted from all output generated from the project.",
    example: "`<val type=\"complex\" value=\"1j\" />` as the value of an object",
    remedy: "Open the project with objdictedit, correct the object and save it.",

    "objdictgen/unknown-object" = UNKNOWN_OBJECT, Warning;
    summary: "no part of the project describes an object",
    checks: "The project must describe each object that it has a value for. The description may be in the user's map or in the map of its profile, of CiA 302 or of CiA 301. objdictgen itself contains the map of CiA 301.",
    why: "Its name, type and access are unknown, so it is omitted. objdictgen stops with an exception.",
    example: "a value for 2004h in `Dictionary`, and no 2004h in `UserMapping`",
    remedy: "Open the project with objdictedit and add the object again.",
}
