//! The parameters of the application process, and which entry each belongs to.

use std::collections::{HashMap, HashSet};

use crate::format::xdd::layout::Layout;
use crate::format::xml::Attribute;
use crate::model::{
    AllowedValues, ApplicationProcess, DataTypeRef, FunctionType, Parameter, ParameterGroup, SimpleType,
    TypeDefinition, TypeShape, VarDeclaration,
};

/// All parameters of a description, taken out of its application processes.
pub(crate) struct Parameters {
    slots: Vec<Slot>,
    /// What each object and sub-object in the order of the file refers to.
    references: Vec<Reference>,
    /// The ids that groups and conditions speak of.
    named: HashSet<Box<str>>,
}

struct Slot {
    parameter: Option<Parameter>,
    /// Its application process.
    process: usize,
    /// How many objects and sub-objects refer to it.
    uses: u32,
}

/// What `uniqueIDRef` refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reference {
    /// There is no such attribute.
    None,
    /// Nothing that has a type or value.
    Dangling,
    /// The parameter of this number.
    Parameter(u32),
    /// The variable of this number, in the order of [`variables`].
    Variable(u32),
}

impl Parameters {
    /// Takes the parameters out of the application processes and looks up what the objects refer to.
    pub(crate) fn take(application: &mut [ApplicationProcess], layout: &Layout<'_>) -> Self {
        let named = named_ids(application);
        let mut slots = Vec::new();
        for (process, part) in application.iter_mut().enumerate() {
            let parameters = std::mem::take(&mut part.parameters);
            slots.extend(parameters.into_iter().map(|parameter| Slot {
                parameter: Some(parameter),
                process,
                uses: 0,
            }));
        }
        let references = references(&slots, application, layout);
        for reference in &references {
            if let Reference::Parameter(number) = reference {
                slots[*number as usize].uses += 1;
            }
        }
        Self { slots, references, named }
    }

    /// What the object or sub-object of this number refers to.
    pub(crate) fn reference(&self, number: usize) -> Reference {
        self.references.get(number).copied().unwrap_or(Reference::None)
    }

    /// The parameter that one entry alone refers to; it is its own from now on.
    pub(crate) fn take_own(&mut self, number: u32) -> Option<Parameter> {
        let slot = self.slots.get_mut(number as usize).filter(|slot| slot.uses == 1)?;
        slot.parameter.take()
    }

    /// A parameter that several entries refer to.
    pub(crate) fn shared(&self, number: u32) -> Option<&Parameter> {
        self.slots.get(number as usize)?.parameter.as_ref()
    }

    /// Whether a group or a condition speaks of an id.
    pub(crate) fn is_named(&self, id: &str) -> bool {
        self.named.contains(id)
    }

    /// Puts those that belong to no entry back.
    pub(crate) fn put_back(self, application: &mut [ApplicationProcess]) {
        for slot in self.slots {
            if let (Some(parameter), Some(process)) = (slot.parameter, application.get_mut(slot.process)) {
                process.parameters.push(parameter);
            }
        }
        for process in application {
            process.parameters.shrink_to_fit();
        }
    }
}

/// Looks up `uniqueIDRef` of every object and sub-object in the order of the file. Of two equal ids the first counts.
fn references(slots: &[Slot], application: &[ApplicationProcess], layout: &Layout<'_>) -> Vec<Reference> {
    let mut targets: HashMap<&str, Reference> = HashMap::with_capacity(slots.len());
    for (number, slot) in (0..).zip(slots) {
        if let Some(parameter) = &slot.parameter {
            targets.entry(&parameter.unique_id).or_insert(Reference::Parameter(number));
        }
    }
    for (number, variable) in (0..).zip(variables(application)) {
        targets.entry(&variable.unique_id).or_insert(Reference::Variable(number));
    }
    let mut references = Vec::new();
    let elements =
        layout.objects().flat_map(|object| std::iter::once(object).chain(object.children_named(SUB)));
    for element in elements {
        let id = element.attribute("uniqueIDRef").map(Attribute::value);
        references.push(match id.as_deref().map(str::trim_ascii) {
            None | Some("") => Reference::None,
            Some(id) => targets.get(id).copied().unwrap_or(Reference::Dangling),
        });
    }
    references
}

/// The element of a sub-index.
pub(crate) const SUB: &str = "CANopenSubObject";

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

/// The ids of parameters that groups and conditions speak of.
fn named_ids(application: &[ApplicationProcess]) -> HashSet<Box<str>> {
    fn of_groups(groups: &[ParameterGroup], ids: &mut HashSet<Box<str>>) {
        for group in groups {
            ids.extend(group.parameters.iter().cloned());
            of_groups(&group.groups, ids);
        }
    }
    let mut ids = HashSet::new();
    for process in application {
        of_groups(&process.groups, &mut ids);
        for parameter in &process.parameters {
            ids.extend(parameter.conditional_support.iter().cloned());
        }
        for variable in variables(std::slice::from_ref(process)) {
            ids.extend(variable.conditional_support.iter().cloned());
        }
    }
    ids
}

/// What parameters refer to: types and templates, by their ids.
pub(crate) struct Definitions<'a> {
    types: HashMap<&'a str, &'a TypeDefinition>,
    templates: HashMap<&'a str, &'a Parameter>,
    allowed: HashMap<&'a str, &'a AllowedValues>,
}

/// So many types may be defined by each other; more is a circle.
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

    /// The simple type behind a reference; `None` for arrays, structs and what is not there.
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

    /// The allowed values with those of their template, where there is nothing else.
    pub(crate) fn allowed<'b>(&self, allowed: &'b AllowedValues) -> &'b AllowedValues
    where
        'a: 'b,
    {
        let is_reference = allowed.values.is_empty() && allowed.ranges.is_empty();
        let template = allowed.template.as_deref().filter(|_| is_reference);
        template.and_then(|id| self.allowed.get(id).copied()).unwrap_or(allowed)
    }
}
