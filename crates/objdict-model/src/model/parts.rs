//! Walks over all parts of a device that store texts.

use super::{Device, Entry, Extra, Field, InvalidValues, ModulePart, Object, Part};

impl Device {
    /// Every part with invalid values.
    pub fn invalid_values(&self) -> Vec<(Part, &InvalidValues)> {
        let mut found = Vec::new();
        self.visit_parts(&mut |part, invalid_values, _| {
            if !invalid_values.is_empty() {
                found.push((part.clone(), invalid_values));
            }
        });
        found
    }

    /// Every part with keys that have no field in the model. Unknown sections are in [`Device::extra`].
    pub fn extras(&self) -> Vec<(Part, &Extra)> {
        let mut found = Vec::new();
        self.visit_parts(&mut |part, _, extra| {
            if !extra.is_empty() {
                found.push((part.clone(), extra));
            }
        });
        found
    }

    fn visit_parts<'a>(&'a self, visit: &mut dyn FnMut(&Part, &'a InvalidValues, &'a Extra)) {
        if let Some(info) = &self.file_info {
            visit(&Part::FileInfo, &info.invalid_values, &info.extra);
        }
        if let Some(info) = &self.device_info {
            visit(&Part::DeviceInfo, &info.invalid_values, &info.extra);
        }
        if let Some(usage) = &self.dummy_usage {
            visit(&Part::DummyUsage, &usage.invalid_values, &usage.extra);
        }
        if let Some(node) = &self.commissioning {
            visit(&Part::Commissioning, &node.invalid_values, &node.extra);
        }
        for (&index, object) in &self.objects {
            let part_of = |sub: Option<u8>| Part::at(index, sub);
            visit_object(object, &part_of, visit);
            if let Some(compact) = &object.compact {
                visit(&Part::CompactValues(index), &compact.invalid_values, &compact.extra);
            }
        }
        if let Some(modules) = &self.modules {
            visit(&Part::SupportedModules, &modules.invalid_values, &modules.extra);
            for (&number, module) in &modules.supported {
                visit(&Part::Module(number, ModulePart::Info), &module.invalid_values, &module.extra);
                for (&index, object) in &module.fixed {
                    let part_of = |sub: Option<u8>| match sub {
                        Some(sub) => Part::Module(number, ModulePart::FixedEntry(index, sub)),
                        None => Part::Module(number, ModulePart::Fixed(index)),
                    };
                    visit_object(object, &part_of, visit);
                }
                for (&index, extension) in &module.extensions {
                    let part = Part::Module(number, ModulePart::SubExt(index));
                    visit_entry(&extension.entry, &part, visit);
                }
            }
        }
        if let Some(channels) = &self.dynamic_channels {
            visit(&Part::DynamicChannels, &channels.invalid_values, &channels.extra);
        }
    }

    /// The data type of the entry at a part, to explain why its text is not valid.
    pub fn data_type_of(&self, part: &Part, field: &Field) -> Option<super::DataType> {
        let is_value =
            matches!(field, Field::DefaultValue | Field::LowLimit | Field::HighLimit | Field::ParameterValue);
        match part {
            Part::Object(index) if is_value => self.object(*index)?.main.implied_type(),
            Part::Entry(index, sub) if is_value => self.object(*index)?.subs.get(*sub)?.implied_type(),
            Part::CompactValues(index) => self.object(*index)?.main.implied_type(),
            _ => None,
        }
    }
}

fn visit_object<'a>(
    object: &'a Object,
    part_of: &dyn Fn(Option<u8>) -> Part,
    visit: &mut dyn FnMut(&Part, &'a InvalidValues, &'a Extra),
) {
    for (sub, entry) in object.described() {
        visit_entry(entry, &part_of(sub), visit);
    }
}

fn visit_entry<'a>(
    entry: &'a Entry,
    part: &Part,
    visit: &mut dyn FnMut(&Part, &'a InvalidValues, &'a Extra),
) {
    if !entry.invalid_values.is_empty() || !entry.extra.is_empty() {
        visit(part, &entry.invalid_values, &entry.extra);
    }
}
