//! Removes what belongs to one node and not to its type.

use std::borrow::Cow;

use super::{Device, DeviceKind, Entry, Extra, Field, InvalidValues, Labels, Object, Parameter};

impl Device {
    /// The device as a description of its type: without the node and its configured values.
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
