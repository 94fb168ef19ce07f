//! The rules about the structure of CiA 311, which depend on the text of an XDD or XDC.

mod ids;
mod objects;
mod parameters;
mod profiles;
mod structure;
mod texts;
mod values;
mod walk;

use self::walk::Walk;
use super::layout::containers;
use super::schema::CONTAINER;
use crate::diagnostic::{Findings, RuleInfo};
use crate::xml::{Element, Tree};

/// Every rule of this module.
pub fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    let groups = [
        structure::RULES,
        profiles::RULES,
        values::RULES,
        ids::RULES,
        objects::RULES,
        parameters::RULES,
        texts::RULES,
    ];
    groups.into_iter().flatten().copied()
}

/// Checks each container of a document against CiA 311; a project file has several. A file without a
/// container is not an XDD and is not checked.
pub fn check(tree: &Tree, findings: &mut Findings) {
    for container in containers(tree).into_iter().filter(|container| container.tag() == CONTAINER.name) {
        check_container(container, findings);
    }
}

/// The findings of schema validation in a document.
pub fn violations(tree: &Tree) -> Findings {
    let mut all = Findings::new();
    for container in containers(tree) {
        ids::check(&mut walked(container, &mut all));
    }
    let of_schema = [structure::RULES, values::RULES, ids::OF_SCHEMA].into_iter().flatten();
    // the standard declares the numbers of a scaling as texts
    all.remove_rules(|id| id == values::INVALID_SCALING.id || !of_schema.clone().any(|rule| rule.id == id));
    all
}

/// The walk over all elements of a container.
fn walked<'a, 'f>(container: Element<'a>, findings: &'f mut Findings) -> Walk<'a, 'f> {
    let mut walk = Walk::new(container, findings);
    walk.element(container, &CONTAINER);
    walk.forms.report(walk.findings);
    walk
}

/// Checks one container against CiA 311: the description of one device.
pub(crate) fn check_container(container: Element<'_>, findings: &mut Findings) {
    let mut walk = walked(container, findings);
    profiles::check(container, &mut walk);
    profiles::check_identities(&mut walk);
    ids::check(&mut walk);
    objects::check(&mut walk);
    parameters::check(&mut walk);
    parameters::check_types(&mut walk);
    texts::check_dictionaries(&mut walk);
}

/// The schema element of a profile body; `None` for any other element, and for a body of an unknown type.
pub(super) fn body_schema(element: Element<'_>) -> Option<&'static super::schema::SchemaElement> {
    profiles::body(element)?.schema
}
