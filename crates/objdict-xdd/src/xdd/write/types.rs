//! The types of ARRAYs and RECORDs that their parameters refer to.

use std::collections::HashSet;
use std::rc::Rc;

use crate::model::{ApplicationProcess, Device, Object, TypeDefinition};
use crate::xdd::schema::{APPLICATION_PROCESS, DEVICE_MANAGER, PARAMETER, Shape, TextKind};
use crate::xdd::shape;
use crate::xdd::types::definition_of;

/// Used ids with the prefix of the writer, because ids must be unique.
#[derive(Debug, Default)]
pub(super) struct UsedIds(HashSet<Rc<str>>);

impl UsedIds {
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

    /// This id or, if it is used, a similar one; reserves it.
    pub(super) fn take(&mut self, id: &str) -> Rc<str> {
        let mut free = id.to_owned();
        let mut number = 1;
        while self.0.contains(free.as_str()) {
            number += 1;
            free = format!("{id}_{number}");
        }
        let id: Rc<str> = free.into();
        self.0.insert(Rc::clone(&id));
        id
    }

    /// Whether an id is unused.
    fn is_free(&self, id: &str) -> bool {
        !self.0.contains(id)
    }

    /// Records the ids of a part and of its nested parts.
    fn note<P>(&mut self, part: &P, shape: &'static Shape<P>) {
        shape::visit(part, shape, &mut |attribute, text| {
            if matches!(attribute.kind, TextKind::Id) && text.starts_with("UID_") {
                self.0.insert(text.into());
            }
        });
    }

    /// The type of an ARRAY or RECORD, if all its ids are unused; reserves them.
    pub(super) fn definition_of(&mut self, index: u16, object: &Object) -> Option<TypeDefinition> {
        let definition = definition_of(index, object)?;
        let mut ids = UsedIds::default();
        let process = ApplicationProcess { data_types: vec![definition], ..ApplicationProcess::default() };
        ids.note(&process, &APPLICATION_PROCESS);
        if !ids.0.iter().all(|id| self.is_free(id)) {
            return None;
        }
        self.0.extend(ids.0);
        process.data_types.into_iter().next()
    }
}
