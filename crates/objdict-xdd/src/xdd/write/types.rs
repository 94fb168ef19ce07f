//! The types of ARRAYs and RECORDs that the parameters of these objects refer to.

use std::any::Any;
use std::collections::HashSet;

use crate::model::{ApplicationProcess, Device, Object, TypeDefinition};
use crate::xdd::schema::{APPLICATION_PROCESS, DEVICE_MANAGER, Element, Kind, PARAMETER};
use crate::xdd::shape;
use crate::xdd::types::definition_of;

/// Ids that start like those that the writer gives: no id may stand twice.
#[derive(Debug, Default)]
pub(super) struct Ids(HashSet<Box<str>>);

impl Ids {
    /// The ids of everything in a device.
    pub(super) fn of(device: &Device) -> Self {
        let mut ids = Self::default();
        device.application.iter().for_each(|process| ids.note(process, &APPLICATION_PROCESS));
        if let Some(manager) = &device.manager {
            ids.note(&**manager, &DEVICE_MANAGER);
        }
        for object in device.objects.values() {
            let entries = std::iter::once(&object.main).chain(object.subs.iter().map(|(_, entry)| entry));
            entries.filter_map(|entry| entry.parameter.as_ref()).for_each(|of| ids.note(&**of, &PARAMETER));
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

    /// The ids of a part and of all parts in it.
    fn note(&mut self, part: &dyn Any, schema: &'static Element) {
        shape::visit(part, schema, &mut |attribute, text| {
            if matches!(attribute.kind, Kind::Id) && text.starts_with("UID_") {
                self.0.insert(text.into());
            }
        });
    }

    /// The type of an ARRAY or RECORD, if all of its ids are free; they are taken from now on.
    pub(super) fn definition_of(&mut self, index: u16, object: &Object) -> Option<TypeDefinition> {
        let definition = definition_of(index, object)?;
        let mut ids = Ids::default();
        let process = ApplicationProcess { data_types: vec![definition], ..ApplicationProcess::default() };
        ids.note(&process, &APPLICATION_PROCESS);
        if !ids.0.iter().all(|id| self.is_free(id)) {
            return None;
        }
        self.0.extend(ids.0);
        process.data_types.into_iter().next()
    }
}
