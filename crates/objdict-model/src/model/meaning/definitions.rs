//! What application processes define, by id.

use std::collections::HashMap;

use super::MAX_DERIVATIONS;
use crate::model::{
    AllowedValues, ApplicationProcess, DataTypeRef, FunctionType, Parameter, SimpleType, TypeDefinition,
    TypeShape, VarDeclaration,
};

/// The targets of references in parameters: types and templates, by id. Of two equal ids, the first counts.
#[derive(Debug, Default)]
pub struct Definitions<'a> {
    pub(super) types: HashMap<&'a str, &'a TypeDefinition>,
    templates: HashMap<&'a str, &'a Parameter>,
    allowed: HashMap<&'a str, &'a AllowedValues>,
}

impl<'a> Definitions<'a> {
    /// The types and templates of the application processes.
    pub fn of(application: &'a [ApplicationProcess]) -> Self {
        let mut found = Self::default();
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

    /// The simple type behind a reference, through aliases and enumerations, of which those without a type have `of_enum`;
    /// `None` for arrays, structs and dangling references.
    pub fn simple(&self, reference: &DataTypeRef, of_enum: Option<SimpleType>) -> Option<SimpleType> {
        let mut reference = reference;
        for _ in 0..MAX_DERIVATIONS {
            let id = match reference {
                DataTypeRef::Simple(simple) => return Some(*simple),
                DataTypeRef::Defined(id) => id,
                DataTypeRef::Variables(_) => return None,
            };
            match &self.types.get(&**id)?.shape {
                TypeShape::Enum { base, .. } => return base.or(of_enum),
                TypeShape::Derived { base, .. } => reference = base.as_ref()?,
                TypeShape::Array { .. } | TypeShape::Struct { .. } => return None,
            }
        }
        None
    }

    /// The template of a parameter, for what the parameter does not define.
    pub fn template(&self, parameter: &Parameter) -> Option<&'a Parameter> {
        self.templates.get(parameter.template.as_deref()?).copied()
    }

    /// The allowed values, or those of their template if they only refer to it.
    pub fn allowed<'b>(&self, allowed: &'b AllowedValues) -> &'b AllowedValues
    where
        'a: 'b,
    {
        let is_reference = allowed.values.is_empty() && allowed.ranges.is_empty();
        let template = allowed.template.as_deref().filter(|_| is_reference);
        template.and_then(|id| self.allowed.get(id).copied()).unwrap_or(allowed)
    }

    /// The variables that objects may refer to: members of structs, and variables of functions.
    pub fn variables(application: &'a [ApplicationProcess]) -> impl Iterator<Item = &'a VarDeclaration> {
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
}
