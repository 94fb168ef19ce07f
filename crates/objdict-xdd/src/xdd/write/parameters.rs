//! The parameters of entries: the content of the application process, and a copy of the attributes of the
//! entries, where most tools look for it.

use std::collections::HashMap;

use super::objects::{REFERENCE, value_text};
use super::types::Ids;
use crate::model::{
    Access, AllowedValues, DataTypeRef, Device, Entry, Field, Labels, Object, Parameter, ScaledValue,
    TypeDefinition, Value, ValueRange,
};
use crate::xdd::defaults;
use crate::xdd::read::written_access;
use crate::xdd::shape::stack_properties;
use crate::xdd::types::simple_type;

/// The parameters of the entries of a device, and the types of its ARRAYs and RECORDs.
#[derive(Debug, Default)]
pub(super) struct EntryParameters {
    parameters: Vec<Parameter>,
    /// The number of the parameter of an object or a sub-index.
    numbers: HashMap<(u16, Option<u8>), usize>,
    pub(super) types: Vec<TypeDefinition>,
}

impl EntryParameters {
    /// Creates the parameters of a device.
    pub(super) fn of(device: &Device) -> Self {
        let mut made = Self::default();
        let mut ids = Ids::of(device);
        for (&index, object) in &device.objects {
            let main = Maker { index, sub: None, entry: &object.main };
            if object.object_type().has_subs() {
                let parameter = made.structure(&main, object, &mut ids);
                made.add(&main, parameter, &mut ids);
            } else {
                made.add(&main, main.parameter(), &mut ids);
            }
            for (sub, entry) in object.subs.iter() {
                let maker = Maker { index, sub: Some(sub), entry };
                made.add(&maker, maker.parameter(), &mut ids);
            }
        }
        made
    }

    /// All parameters, in the order of the objects.
    pub(super) fn all(&self) -> impl Iterator<Item = &Parameter> {
        self.parameters.iter()
    }

    /// The id of the parameter of an object or a sub-index.
    pub(super) fn id(&self, index: u16, sub: Option<u8>) -> Option<&str> {
        let number = self.numbers.get(&(index, sub))?;
        Some(&self.parameters.get(*number)?.unique_id)
    }

    fn add(&mut self, maker: &Maker<'_>, parameter: Option<Parameter>, ids: &mut Ids) {
        let Some(mut parameter) = parameter else { return };
        if parameter.unique_id.is_empty() {
            parameter.unique_id = ids.take(&Parameter::usual_id(maker.index, maker.sub));
        }
        self.numbers.insert((maker.index, maker.sub), self.parameters.len());
        self.parameters.push(parameter);
    }

    /// The parameter of an ARRAY or RECORD: its type is composed from those of its sub-indexes.
    fn structure(&mut self, maker: &Maker<'_>, object: &Object, ids: &mut Ids) -> Option<Parameter> {
        let mut parameter = maker.start()?;
        if parameter.data_type.is_none()
            && let Some(definition) = ids.definition_of(maker.index, object)
        {
            parameter.data_type = Some(DataTypeRef::Defined(definition.unique_id.clone()));
            self.types.push(definition);
        }
        // it has no type, so it is only written if it has other content
        let is_needed = parameter.data_type.is_some() || maker.says_more(&parameter);
        maker.finish(&mut parameter);
        Some(parameter).filter(|_| is_needed)
    }
}

/// An entry whose parameter is created.
struct Maker<'a> {
    index: u16,
    sub: Option<u8>,
    entry: &'a Entry,
}

impl Maker<'_> {
    /// The parameter of an entry with a value. An entry without data type or access type gets a parameter
    /// only if needed, because a parameter always implies both.
    fn parameter(&self) -> Option<Parameter> {
        let entry = self.entry;
        let mut parameter = self.start()?;
        let has_access = entry.access.is_some() || entry.invalid_values.get(&Field::AccessType).is_some();
        let is_special = matches!(entry.access, Some(Access::Rwr | Access::Rww));
        if !(entry.data_type.is_some() && has_access || is_special || self.says_more(&parameter)) {
            return None;
        }
        let simple = entry.data_type.map(simple_type).map(DataTypeRef::Simple);
        parameter.data_type = parameter.data_type.take().or(simple);
        parameter.access = parameter.access.or(entry.access.map(written_access));
        let default = || self.value(entry.default.as_ref(), &Field::DefaultValue);
        parameter.default_value = parameter.default_value.take().or_else(default);
        if parameter.allowed_values.is_none() {
            parameter.allowed_values = self.allowed_values();
        }
        let actual = || self.value(entry.configured_value(), &Field::ParameterValue);
        parameter.actual_value = parameter.actual_value.take().or_else(actual);
        let denotation = entry.configured.as_ref().and_then(|configured| configured.denotation.as_deref());
        if let Some(denotation) = denotation.filter(|_| parameter.denotation.is_empty()) {
            parameter.denotation = Labels::name(defaults::LANGUAGE, denotation);
        }
        self.finish(&mut parameter);
        Some(parameter)
    }

    /// The content of the application process for the entry; `None` if the entry refers to a parameter of
    /// others.
    fn start(&self) -> Option<Parameter> {
        if self.entry.extra.get(REFERENCE).is_some() {
            return None;
        }
        Some(self.entry.parameter.as_deref().cloned().unwrap_or_default())
    }

    /// Whether the parameter has content with no other place.
    fn says_more(&self, parameter: &Parameter) -> bool {
        *parameter != Parameter::default() || self.entry.stack.is_some()
    }

    /// Adds names and properties, which every parameter has.
    fn finish(&self, parameter: &mut Parameter) {
        if parameter.labels.is_empty() {
            parameter.labels = Labels::name(defaults::LANGUAGE, &self.entry.name);
        }
        if let Some(stack) = &self.entry.stack {
            parameter.properties.splice(0..0, stack_properties(stack));
        }
    }

    /// The range of the limits, if both are set.
    fn allowed_values(&self) -> Option<AllowedValues> {
        let min = self.value(self.entry.low_limit.as_ref(), &Field::LowLimit)?;
        let max = self.value(self.entry.high_limit.as_ref(), &Field::HighLimit)?;
        let range = ValueRange { min, max, ..ValueRange::default() };
        Some(AllowedValues { ranges: vec![range], ..AllowedValues::default() })
    }

    /// A value, or the invalid text.
    fn value(&self, value: Option<&Value>, field: &Field) -> Option<ScaledValue> {
        let text = value_text(self.index, self.entry, value, field)?;
        Some(ScaledValue { value: text.into(), ..ScaledValue::default() })
    }
}
