//! The parameters of the application process, and the entry that each belongs to.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use crate::model::{ApplicationProcess, Definitions, Parameter, ParameterGroup};
use crate::xdd::layout::{Layout, with_subs};
use crate::xdd::leftovers::Leftovers;
use crate::xdd::schema::PARAMETER;
use crate::xdd::shape;
use crate::xdd::types::without_placeholder;
use crate::xml::{Attribute, Element, n};

/// All parameters of a description. They are read once their entries are known.
pub(crate) struct Parameters<'a> {
    slots: Vec<ParameterSlot<'a>>,
    /// The reference of each object and sub-object, in file order.
    references: Vec<Reference>,
    /// The ids that groups and conditions refer to.
    named: HashSet<Box<str>>,
}

/// A parameter.
#[derive(Debug)]
pub(crate) struct ParameterSlot<'a> {
    element: Element<'a>,
    /// The application process of the parameter.
    process: usize,
    /// The number of objects and sub-objects that refer to it.
    uses: u32,
    /// Whether it belongs to an entry.
    is_own: bool,
    /// The parsed parameter, if several entries refer to it and the first of them has been read.
    shared: Option<Box<Parameter>>,
}

impl<'a> ParameterSlot<'a> {
    /// A parameter of an application process.
    pub(crate) fn new(element: Element<'a>, process: usize) -> Self {
        Self { element, process, uses: 0, is_own: false, shared: None }
    }

    fn id(&self) -> Option<Cow<'a, str>> {
        self.element.attribute(n::uniqueID).map(Attribute::value)
    }
}

/// The target of `uniqueIDRef`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reference {
    /// No such attribute.
    None,
    /// No element with a type or value.
    Dangling,
    /// The parameter with this number.
    Parameter(u32),
    /// The variable with this number, in the order of [`variables`].
    Variable(u32),
}

impl<'a> Parameters<'a> {
    /// Resolves the references of the objects.
    pub(crate) fn new(
        mut slots: Vec<ParameterSlot<'a>>,
        application: &[ApplicationProcess],
        layout: &Layout<'a>,
    ) -> Self {
        let named = named_ids(&slots, application);
        let references = references(&slots, application, layout);
        for reference in &references {
            if let Reference::Parameter(number) = reference {
                slots[*number as usize].uses += 1;
            }
        }
        Self { slots, references, named }
    }

    /// The target of the object or sub-object with this number.
    pub(crate) fn reference(&self, number: usize) -> Reference {
        self.references.get(number).copied().unwrap_or(Reference::None)
    }

    /// A parameter with a single reference; it belongs to the entry.
    pub(crate) fn own(&mut self, number: u32, leftovers: &mut Leftovers<'a>) -> Option<Parameter> {
        let slot = self.slots.get_mut(number as usize).filter(|slot| slot.uses == 1)?;
        slot.is_own = true;
        Some(read(slot.element, leftovers))
    }

    /// A parameter that several entries refer to.
    pub(crate) fn shared(&mut self, number: u32, leftovers: &mut Leftovers<'a>) -> Option<&Parameter> {
        let slot = self.slots.get_mut(number as usize)?;
        let element = slot.element;
        Some(slot.shared.get_or_insert_with(|| Box::new(read(element, leftovers))))
    }

    /// Whether a group or a condition refers to an id.
    pub(crate) fn is_named(&self, id: &str) -> bool {
        self.named.contains(id)
    }

    /// Moves the parameters without an entry to their application processes.
    pub(crate) fn give_rest(self, application: &mut [ApplicationProcess], leftovers: &mut Leftovers<'a>) {
        for slot in self.slots.into_iter().filter(|slot| !slot.is_own) {
            if let Some(process) = application.get_mut(slot.process) {
                let known = slot.shared.map(|parameter| *parameter);
                process.parameters.push(known.unwrap_or_else(|| read(slot.element, leftovers)));
            }
        }
        for process in application {
            process.parameters.shrink_to_fit();
        }
    }
}

fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Parameter {
    without_placeholder(shape::read(element, &PARAMETER, leftovers))
}

/// Resolves `uniqueIDRef` of every object and sub-object in file order. Of two equal ids, the first is
/// used.
fn references(
    slots: &[ParameterSlot<'_>],
    application: &[ApplicationProcess],
    layout: &Layout<'_>,
) -> Vec<Reference> {
    let mut targets: HashMap<Cow<'_, str>, Reference> = HashMap::with_capacity(slots.len());
    for (number, slot) in (0..).zip(slots) {
        if let Some(id) = slot.id() {
            targets.entry(id).or_insert(Reference::Parameter(number));
        }
    }
    for (number, variable) in (0..).zip(Definitions::variables(application)) {
        targets.entry(Cow::Borrowed(&*variable.unique_id)).or_insert(Reference::Variable(number));
    }
    let reference = |element: Element<'_>| {
        let id = element.attribute(n::uniqueIDRef).map(Attribute::value);
        match id.as_deref().map(str::trim_ascii) {
            None | Some("") => Reference::None,
            Some(id) => targets.get(id).copied().unwrap_or(Reference::Dangling),
        }
    };
    layout.objects().flat_map(with_subs).map(reference).collect()
}

/// The ids of parameters that groups and conditions refer to.
fn named_ids(slots: &[ParameterSlot<'_>], application: &[ApplicationProcess]) -> HashSet<Box<str>> {
    fn of_groups(groups: &[ParameterGroup], ids: &mut HashSet<Box<str>>) {
        for group in groups {
            ids.extend(group.parameters.iter().cloned());
            of_groups(&group.groups, ids);
        }
    }
    let mut ids = HashSet::new();
    for process in application {
        of_groups(&process.groups, &mut ids);
        for variable in Definitions::variables(std::slice::from_ref(process)) {
            ids.extend(variable.conditional_support.iter().cloned());
        }
    }
    let conditions = slots.iter().flat_map(|slot| slot.element.children_named(n::conditionalSupport));
    let named = conditions.filter_map(|condition| condition.attribute(n::paramIDRef));
    ids.extend(named.map(|id| id.value().into()));
    ids
}
