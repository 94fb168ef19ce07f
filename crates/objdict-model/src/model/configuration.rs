//! Configured values of a node's entries, and the conversion of a node's description to its type.

use std::borrow::Cow;

use super::{Device, DeviceKind, Entry, Extra, Field, InvalidValues, Labels, Object, Parameter, Value};

impl Device {
    /// The type description of the device: without the node and its configured values.
    pub fn unconfigured(&self) -> Cow<'_, Self> {
        if self.kind == DeviceKind::Type {
            return Cow::Borrowed(self);
        }
        let mut device = self.clone();
        device.kind = DeviceKind::Type;
        device.commissioning = None;
        device.downloads.clear();
        if let Some(info) = &mut device.file_info {
            info.last_eds = None;
        }
        let modules = device.modules.iter_mut();
        let of_modules = modules.flat_map(|modules| {
            modules.connected = None;
            modules.supported.values_mut()
        });
        for module in of_modules {
            module.fixed.values_mut().for_each(|object| object.remove_configuration());
            module.extensions.values_mut().for_each(|extension| extension.entry.remove_configuration());
        }
        device.objects.values_mut().for_each(Object::remove_configuration);
        let parameters = device.application.iter_mut().flat_map(|process| &mut process.parameters);
        parameters.for_each(Parameter::remove_configuration);
        Cow::Owned(device)
    }
}

impl Object {
    fn remove_configuration(&mut self) {
        self.main.remove_configuration();
        self.subs.iter_mut().for_each(|(_, entry)| entry.remove_configuration());
        if let Some(compact) = &mut self.compact {
            compact.values.clear();
            compact.denotations.clear();
            // these belong to the section of the values
            compact.extra = Extra::default();
            compact.invalid_values = InvalidValues::default();
        }
    }
}

impl Entry {
    fn remove_configuration(&mut self) {
        self.configured = None;
        self.invalid_values.retain(|invalid| invalid.field != Field::ParameterValue);
        if let Some(parameter) = &mut self.parameter {
            parameter.remove_configuration();
        }
    }
}

impl Parameter {
    fn remove_configuration(&mut self) {
        self.actual_value = None;
        self.denotation = Labels::default();
    }
}

/// An entry and its new value.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// The index of the object.
    pub index: u16,
    /// The sub-index of the entry.
    pub sub: u8,
    /// The value, as in `ParameterValue`.
    pub value: Value,
}

impl Device {
    /// Configures the values; assignments to missing entries are ignored.
    pub fn assign(&mut self, assignments: &[Assignment]) {
        for Assignment { index, sub, value } in assignments {
            let Some(object) = self.objects.get_mut(index) else { continue };
            if let Some(entry) = object.subs.get_mut(*sub) {
                entry.configured_mut().value = Some(value.clone());
                continue;
            }
            let has_subs = object.object_type().has_subs();
            match &mut object.compact {
                Some(compact) if (1..=compact.count).contains(sub) => {
                    compact.values.retain(|(other, _)| other != sub);
                    compact.values.push((*sub, value.clone()));
                    compact.values.sort_by_key(|(sub, _)| *sub);
                }
                Some(_) => {}
                None if *sub == 0 && !has_subs => {
                    object.main.configured_mut().value = Some(value.clone());
                }
                None => {}
            }
        }
    }

    /// The configured values of `other` that differ from `self`, for entries that both have.
    pub fn reconfigured(&self, other: &Self) -> Vec<Assignment> {
        let mut values = Vec::new();
        for (&index, object) in &other.objects {
            let Some(old) = self.object(index) else { continue };
            for (sub, entry) in object.entries() {
                let Some(value) = entry.configured_value() else { continue };
                let is_new = old.entry(sub).is_some_and(|old| old.configured_value() != Some(value));
                if is_new {
                    values.push(Assignment { index, sub, value: value.clone() });
                }
            }
        }
        values
    }
}
