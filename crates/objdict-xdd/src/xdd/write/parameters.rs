//! The parameters of entries: the content of the application process, with a copy of the entries'
//! attributes, where most tools expect them, and the referenced types.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::rc::Rc;

use crate::literal::{self, Spelling};
use crate::model::{
    Access, AllowedValues, ApplicationProcess, DataType, DataTypeRef, Device, Entry, Field, Labels, Object,
    Parameter, ScaledValue, TypeDefinition, Value, ValueRange,
};
use crate::xdd::defaults::{self, written_access};
use crate::xdd::schema::{APPLICATION_PROCESS, DEVICE_MANAGER, PARAMETER, Shape, TextKind};
use crate::xdd::shape::{self, stack_properties};
use crate::xdd::types::{definition_of, simple_type};
use crate::xml::n;

/// The entries of a device that have parameters, and the types of its ARRAYs and RECORDs. The parameters are created
/// during writing: entries in compact storage become many.
#[derive(Debug, Default)]
pub(super) struct EntryParameters {
    /// The ids of the parameters of objects and sub-indexes.
    ids: HashMap<(u16, Option<u8>), Rc<str>>,
    /// The ids of the types.
    types: BTreeMap<u16, Box<str>>,
    /// The types, which need more memory than all else; writing consumes them.
    pub(super) definitions: RefCell<Vec<TypeDefinition>>,
}

impl EntryParameters {
    /// Creates the parameters of a device.
    pub(super) fn of(device: &Device) -> Self {
        let mut made = Self::default();
        let mut ids = UsedIds::of(device);
        for (&index, object) in &device.objects {
            let object = &*object.expanded();
            let main = ParameterMaker { index, sub: None, entry: &object.main };
            if object.object_type().has_subs()
                && main.start().is_some_and(|parameter| parameter.data_type.is_none())
                && let Some(definition) = ids.definition_of(index, object)
            {
                made.types.insert(index, definition.unique_id.clone());
                made.definitions.get_mut().push(definition);
            }
            for maker in makers(index, object) {
                if let Some(parameter) = made.parameter(&maker, object) {
                    let id = match parameter.unique_id {
                        id if id.is_empty() => ids.take(&Parameter::usual_id(index, maker.sub)),
                        id => id.into(),
                    };
                    made.ids.insert((index, maker.sub), id);
                }
            }
        }
        made
    }

    /// Whether there are no parameters.
    pub(super) fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }

    /// Creates all parameters of the device one by one, in the order of the objects.
    pub(super) fn each(&self, device: &Device, see: &mut dyn FnMut(Parameter)) {
        for (&index, object) in &device.objects {
            let object = &*object.expanded();
            for maker in makers(index, object) {
                if let Some(id) = self.id(index, maker.sub)
                    && let Some(parameter) = self.parameter(&maker, object)
                {
                    see(Parameter { unique_id: id.into(), ..parameter });
                }
            }
        }
    }

    /// The id of the parameter of an object or a sub-index.
    pub(super) fn id(&self, index: u16, sub: Option<u8>) -> Option<&str> {
        self.ids.get(&(index, sub)).map(|id| &**id)
    }

    fn parameter(&self, maker: &ParameterMaker<'_>, object: &Object) -> Option<Parameter> {
        if maker.sub.is_some() || !object.object_type().has_subs() {
            return maker.parameter();
        }
        // the type of an ARRAY or RECORD is composed from the types of its sub-indexes
        let mut parameter = maker.start()?;
        let composed = || Some(DataTypeRef::Defined(self.types.get(&maker.index)?.clone()));
        parameter.data_type = parameter.data_type.take().or_else(composed);
        // without a type, it is written only if it has other content
        let is_needed = parameter.data_type.is_some() || maker.says_more(&parameter);
        maker.finish(&mut parameter);
        Some(parameter).filter(|_| is_needed)
    }
}

/// The object, then its sub-indexes.
fn makers(index: u16, object: &Object) -> impl Iterator<Item = ParameterMaker<'_>> {
    let subs = object.subs.iter().map(move |(sub, entry)| ParameterMaker { index, sub: Some(sub), entry });
    std::iter::once(ParameterMaker { index, sub: None, entry: &object.main }).chain(subs)
}

/// An entry whose parameter is created.
struct ParameterMaker<'a> {
    index: u16,
    sub: Option<u8>,
    entry: &'a Entry,
}

impl ParameterMaker<'_> {
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

    /// The content of the application process for the entry; `None` if the entry refers to a shared
    /// parameter.
    fn start(&self) -> Option<Parameter> {
        if self.entry.extra.get(REFERENCE).is_some() {
            return None;
        }
        Some(self.entry.parameter.as_deref().cloned().unwrap_or_default())
    }

    /// Whether the parameter has content that is stored nowhere else.
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

    /// A value, or the invalid string.
    fn value(&self, value: Option<&Value>, field: &Field) -> Option<ScaledValue> {
        let text = print_value(self.index, self.entry, value, field)?;
        Some(ScaledValue { value: text.into(), ..ScaledValue::default() })
    }
}

/// Used ids with the prefix of the writer, because ids must be unique.
#[derive(Debug, Default)]
pub(super) struct UsedIds(HashSet<Rc<str>>);

impl UsedIds {
    /// The ids of all parts of a device.
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

/// The attribute that refers to the parameter of an entry. Among the unknown keys of an entry, it refers to
/// a parameter of others.
pub(super) const REFERENCE: &str = n::uniqueIDRef.text();

/// The string for a value, or the invalid string. CiA 311 does not support a default for a DOMAIN.
pub fn print_value(index: u16, entry: &Entry, value: Option<&Value>, field: &Field) -> Option<String> {
    let is_domain = entry.implied_type() == Some(DataType::DOMAIN);
    match value {
        _ if is_domain && *field == Field::DefaultValue => None,
        Some(value) => Some(print(index, entry.data_type, value)),
        None => entry.invalid_values.get(field).map(|invalid| invalid.text.to_string()),
    }
}

/// COB-IDs, mappings and other communication parameters are printed in hex, as in an EDS, and the bytes of an
/// OCTET_STRING with spaces between them, without which CANopenEditor reads only the first. XML preserves spaces, so a
/// string needs quotes only if it is empty or contains quotes.
fn print(index: u16, data_type: Option<DataType>, value: &Value) -> String {
    match value {
        Value::Text(text) if !text.is_empty() && !is_quoted(text) => text.to_string(),
        Value::Bytes(bytes) if data_type == Some(DataType::OCTET_STRING) && !bytes.is_empty() => {
            let bytes: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
            bytes.join(" ")
        }
        _ => {
            let hex = (0x1000..=0x1FFF).contains(&index) && data_type == Some(DataType::UNSIGNED32);
            literal::print(value, Spelling { hex, ..Spelling::default() })
        }
    }
}

fn is_quoted(text: &str) -> bool {
    text.len() > 1 && text.starts_with('"') && text.ends_with('"')
}
