//! The types of ARRAYs and RECORDs that the parameters of these objects refer to.

use std::collections::HashSet;

use crate::model::{ApplicationProcess, Device, Object, TypeDefinition, TypeShape};
use crate::xdd::types::definition_of;

/// Ids that start like those that the writer gives: no id may stand twice.
#[derive(Debug, Default)]
pub(super) struct Ids(HashSet<Box<str>>);

impl Ids {
    /// The ids of everything in a device.
    pub(super) fn of(device: &Device) -> Self {
        let mut ids = Self::default();
        device.application.iter().for_each(|process| ids.process(process));
        if let Some(manager) = &device.manager {
            manager.leds.iter().flat_map(|led| &led.states).for_each(|state| ids.note(&state.unique_id));
            for interface in &manager.module_interfaces {
                ids.note(&interface.unique_id);
                interface
                    .module_types
                    .iter()
                    .filter_map(|of| of.unique_id.as_ref())
                    .for_each(|id| ids.note(id));
            }
        }
        for object in device.objects.values() {
            let entries = std::iter::once(&object.main).chain(object.subs.iter().map(|(_, entry)| entry));
            entries.filter_map(|entry| entry.parameter.as_ref()).for_each(|of| ids.note(&of.unique_id));
        }
        ids
    }

    /// This id or, where it is taken, one like it; it is taken from now on.
    pub(super) fn take(&mut self, id: &str) -> Box<str> {
        let mut free = id.to_owned();
        let mut number = 1;
        while self.0.contains(free.as_str()) {
            number += 1;
            free = format!("{id}_{number}");
        }
        self.0.insert(free.as_str().into());
        free.into()
    }

    /// Whether an id is free.
    fn is_free(&self, id: &str) -> bool {
        !self.0.contains(id)
    }

    fn note(&mut self, id: &str) {
        if id.starts_with("UID_") {
            self.0.insert(id.into());
        }
    }

    fn process(&mut self, process: &ApplicationProcess) {
        for definition in &process.data_types {
            self.definition(definition);
        }
        for function in &process.function_types {
            self.note(&function.unique_id);
            let variables = function.inputs.iter().chain(&function.outputs).chain(&function.configuration);
            variables.for_each(|variable| self.note(&variable.unique_id));
            function.functions.instances.iter().for_each(|instance| self.note(&instance.unique_id));
        }
        process.functions.instances.iter().for_each(|instance| self.note(&instance.unique_id));
        process.parameter_templates.iter().for_each(|template| self.note(&template.parameter.unique_id));
        process.allowed_values_templates.iter().for_each(|template| self.note(&template.unique_id));
        process.parameters.iter().for_each(|parameter| self.note(&parameter.unique_id));
        let mut groups: Vec<_> = process.groups.iter().collect();
        while let Some(group) = groups.pop() {
            self.note(&group.unique_id);
            groups.extend(&group.groups);
        }
    }

    fn definition(&mut self, definition: &TypeDefinition) {
        self.note(&definition.unique_id);
        match &definition.shape {
            TypeShape::Struct { members } => members.iter().for_each(|member| self.note(&member.unique_id)),
            TypeShape::Derived { count: Some(count), .. } => self.note(&count.unique_id),
            _ => {}
        }
    }

    /// The type of an ARRAY or RECORD, if all of its ids are free; they are taken from now on.
    pub(super) fn definition_of(&mut self, index: u16, object: &Object) -> Option<TypeDefinition> {
        let definition = definition_of(index, object)?;
        let mut ids = Ids::default();
        ids.definition(&definition);
        if !ids.0.iter().all(|id| self.is_free(id)) {
            return None;
        }
        self.0.extend(ids.0);
        Some(definition)
    }
}
