//! The parameters of the application process, and which entry each belongs to.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use crate::model::{
    AllowedValues, ApplicationProcess, DataTypeRef, FunctionType, Parameter, ParameterGroup, SimpleType,
    TypeDefinition, TypeShape, VarDeclaration,
};
use crate::xdd::layout::{Layout, with_subs};
use crate::xdd::leftovers::Leftovers;
use crate::xdd::schema::PARAMETER;
use crate::xdd::shape;
use crate::xdd::types::without_placeholder;
use crate::xml::{Attribute, Element, n};

/// All parameters of a description. They are read once it is known which entry they belong to.
pub(crate) struct Parameters<'a> {
    slots: Vec<ParameterSlot<'a>>,
    /// What each object and sub-object refers to, in the order of the file.
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
    /// The parsed parameter, if several entries refer to it and the first of them was read.
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

    /// Moves the parameters that belong to no entry to their application processes.
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

/// Resolves `uniqueIDRef` of every object and sub-object in the order of the file. Of two equal ids, the
/// first counts.
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
    for (number, variable) in (0..).zip(variables(application)) {
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

/// The variables that objects may refer to: members of structs, and variables of functions.
pub(crate) fn variables(application: &[ApplicationProcess]) -> impl Iterator<Item = &VarDeclaration> {
    fn of_function(function: &FunctionType) -> impl Iterator<Item = &VarDeclaration> {
        function.inputs.iter().chain(&function.outputs).chain(&function.configuration)
    }
    application.iter().flat_map(|process| {
        let members = process.data_types.iter().filter_map(|definition| match &definition.shape {
            TypeShape::Struct { members } => Some(members),
            _ => None,
        });
        members.flatten().chain(process.function_types.iter().flat_map(of_function))
    })
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
        for variable in variables(std::slice::from_ref(process)) {
            ids.extend(variable.conditional_support.iter().cloned());
        }
    }
    let conditions = slots.iter().flat_map(|slot| slot.element.children_named(n::conditionalSupport));
    let named = conditions.filter_map(|condition| condition.attribute(n::paramIDRef));
    ids.extend(named.map(|id| id.value().into()));
    ids
}

/// The targets of references in parameters: types and templates, by id.
pub(crate) struct Definitions<'a> {
    types: HashMap<&'a str, &'a TypeDefinition>,
    templates: HashMap<&'a str, &'a Parameter>,
    allowed: HashMap<&'a str, &'a AllowedValues>,
}

/// The maximum depth of derived types; a deeper chain is a cycle.
const MAX_DERIVATIONS: usize = 16;

impl<'a> Definitions<'a> {
    /// The types and templates of the application processes.
    pub(crate) fn of(application: &'a [ApplicationProcess]) -> Self {
        let mut found = Self { types: HashMap::new(), templates: HashMap::new(), allowed: HashMap::new() };
        for process in application {
            for definition in &process.data_types {
                found.types.entry(&definition.unique_id).or_insert(definition);
            }
            for template in &process.parameter_templates {
                found.templates.entry(&template.parameter.unique_id).or_insert(&template.parameter);
            }
            for template in &process.allowed_values_templates {
                found.allowed.entry(&template.unique_id).or_insert(&template.allowed);
            }
        }
        found
    }

    /// The simple type behind a reference; `None` for arrays, structs and dangling references.
    pub(crate) fn simple(&self, reference: &DataTypeRef) -> Option<SimpleType> {
        let mut reference = reference;
        for _ in 0..MAX_DERIVATIONS {
            let id = match reference {
                DataTypeRef::Simple(simple) => return Some(*simple),
                DataTypeRef::Defined(id) => id,
                DataTypeRef::Variables(_) => return None,
            };
            match &self.types.get(&**id)?.shape {
                TypeShape::Enum { base, .. } => return *base,
                TypeShape::Derived { base, .. } => reference = base.as_ref()?,
                TypeShape::Array { .. } | TypeShape::Struct { .. } => return None,
            }
        }
        None
    }

    /// The template of a parameter.
    pub(crate) fn template(&self, parameter: &Parameter) -> Option<&'a Parameter> {
        self.templates.get(parameter.template.as_deref()?).copied()
    }

    /// The allowed values, or those of their template if they only refer to it.
    pub(crate) fn allowed<'b>(&self, allowed: &'b AllowedValues) -> &'b AllowedValues
    where
        'a: 'b,
    {
        let is_reference = allowed.values.is_empty() && allowed.ranges.is_empty();
        let template = allowed.template.as_deref().filter(|_| is_reference);
        template.and_then(|id| self.allowed.get(id).copied()).unwrap_or(allowed)
    }
}
