//! The object list: objects, sub-objects, and the parameters that they refer to.

use super::absorb::{self, absorb};
use super::entry::EntryAttributes;
use super::parameters::{ParameterSlot, Parameters, Reference};
use super::{XddReader, project};
use crate::diagnostic::Findings;
use crate::model::{
    Access, ApplicationProcess, DataType, DataTypeRef, Definitions, Device, Entry, Field, InvalidValue,
    InvalidValues, Object, ObjectLists, ObjectType, Parameter, ParameterAccess, Place, VarDeclaration,
};
use crate::xdd::fact::{PlacedText, hex};
use crate::xdd::leftovers::Leftovers;
use crate::xdd::shape::take_stack_options;
use crate::xdd::types;
use crate::xml::{Element, n};

impl<'a> XddReader<'a> {
    /// Reads all objects. Parameters that belong to no entry, or to several, are added to the
    /// application processes.
    pub(super) fn objects(&mut self, application: &mut [ApplicationProcess], slots: Vec<ParameterSlot<'a>>) {
        let mut parameters = Parameters::new(slots, application, &self.layout);
        let definitions = Definitions::of(application);
        let mut entries = Entries {
            parameters: &mut parameters,
            definitions: &definitions,
            variables: Definitions::variables(application).collect(),
            findings: &mut self.findings,
            leftovers: &mut self.leftovers,
            is_project: self.layout.project().is_some(),
            number: 0,
        };
        for element in self.layout.objects() {
            let attributes = EntryAttributes::of(element);
            if attributes.is_placeholder() {
                entries.number += 1;
                continue;
            }
            let index = attributes.index().filter(|index| !self.device.objects.contains_key(index));
            match index {
                Some(index) => {
                    let object = entries.object(element, &attributes, index);
                    self.device.objects.insert(index, object);
                }
                None => {
                    entries.number += 1 + element.children_named(n::CANopenSubObject).count();
                    entries.leftovers.element(element);
                }
            }
        }
        parameters.give_rest(application, &mut self.leftovers);
        drop_written_types(&mut self.device, application);
    }

    /// The object lists of an EDS: all objects from 1000h on, by the index ranges of CiA 306-1 §4.6.3.1.
    pub(super) fn derive_lists(&mut self) {
        if self.device.objects.is_empty() {
            return;
        }
        self.device.lists = ObjectLists::naming(self.device.objects.keys().copied());
    }
}

/// The entries of an object list, in order.
struct Entries<'t, 'a> {
    parameters: &'a mut Parameters<'t>,
    definitions: &'a Definitions<'a>,
    variables: Vec<&'a VarDeclaration>,
    findings: &'a mut Findings,
    leftovers: &'a mut Leftovers<'t>,
    /// Whether texts are in the objects and not in parameters.
    is_project: bool,
    /// The number of objects and sub-objects read so far.
    number: usize,
}

impl<'t> Entries<'t, '_> {
    fn object(&mut self, element: Element<'t>, attributes: &EntryAttributes<'t>, index: u16) -> Object {
        let main = self.entry(attributes, index, None, None);
        let mut object = Object { orphan: attributes.is_orphan(), main, ..Object::default() };
        if let Some(text) = attributes.get(n::subNumber).map(PlacedText::of) {
            match text.integer(255, self.findings) {
                Ok(number) => object.sub_number = number,
                Err(reason) => object.main.invalid_values.push(Field::SubNumber, &text.text, reason),
            }
        }
        self.texts(&mut object.main, element);
        for child in element.children_named(n::CANopenSubObject) {
            let attributes = EntryAttributes::of(child);
            match attributes.sub_index().filter(|&sub| object.subs.get(sub).is_none()) {
                Some(sub) => {
                    let inherited = self.element_type(&object.main, &attributes, sub);
                    let mut entry = self.entry(&attributes, index, Some(sub), inherited);
                    if let Some(attribute) = attributes.get(n::subNumber) {
                        entry.extra.push(attribute.name(), &attribute.value());
                    }
                    self.texts(&mut entry, child);
                    if self.is_project && object.object_type() == ObjectType::Array {
                        let array = &object.main;
                        entry.access =
                            entry.access.or(if sub == 0 { Some(Access::Ro) } else { array.access });
                        entry.pdo_mapping = entry.pdo_mapping.or(array.pdo_mapping.filter(|_| sub > 0));
                    }
                    object.subs.insert(sub, entry);
                }
                None => {
                    self.number += 1;
                    self.leftovers.element(child);
                }
            }
        }
        object
    }

    /// The data type that an element inherits from an ARRAY: older versions of CANopenEditor state it there, and
    /// `0000` for the elements; projects may omit it for the elements.
    fn element_type(&self, array: &Entry, attributes: &EntryAttributes<'_>, sub: u8) -> Option<DataType> {
        let of_elements = array.data_type.filter(|_| array.object_type == Some(ObjectType::Array))?;
        let is_stated = match attributes.get(n::dataType) {
            Some(stated) => hex(stated.value().trim_ascii(), 4) != Some(0),
            None => !self.is_project,
        };
        let inherited = if sub == 0 { DataType::UNSIGNED8 } else { of_elements };
        (!is_stated).then_some(inherited)
    }

    /// The children of an object or sub-object that are not sub-objects: texts in a project, otherwise
    /// unknown.
    fn texts(&mut self, entry: &mut Entry, element: Element<'t>) {
        let mut texts = Vec::new();
        for child in element.children().filter(|child| child.tag() != n::CANopenSubObject) {
            match project::label(child).filter(|_| self.is_project) {
                Some(label) => texts.push(label),
                None => self.leftovers.element(child),
            }
        }
        let mut labels = project::labels(texts);
        absorb::name(entry, &mut labels);
        if !labels.is_empty() {
            entry.parameter_mut().labels = labels;
        }
    }

    /// An entry; `inherited` is its data type if neither the entry nor its parameter states one.
    fn entry(
        &mut self,
        attributes: &EntryAttributes<'_>,
        index: u16,
        sub: Option<u8>,
        inherited: Option<DataType>,
    ) -> Entry {
        let mut entry = attributes.read(self.findings);
        let reference = self.parameters.reference(self.number);
        self.number += 1;
        let mut source = self.source(reference);
        let place = Place::at(index, sub);
        let is_structure = sub.is_none() && entry.object_type.is_some_and(ObjectType::has_subs);
        if let Some((parameter, _)) = &mut source
            && !is_structure
        {
            // the data type must be known before the values
            absorb::data_type(&mut entry, parameter, self.definitions);
        }
        entry.data_type = entry.data_type.or(inherited);
        attributes.read_values(&mut entry, self.findings);
        match &mut source {
            None => {}
            Some((parameter, _)) if is_structure => absorb::name(&mut entry, &mut parameter.labels),
            Some((parameter, _)) => absorb(&mut entry, parameter, self.definitions, &place, self.findings),
        }
        attributes.settle_high_limit(&mut entry, self.findings);
        match (source, attributes.get(n::uniqueIDRef)) {
            (Some((mut parameter, true)), _) => {
                take_stack_options(&mut entry.stack, &mut parameter.properties);
                if parameter.has_usual_id(index, sub) && !self.parameters.is_named(&parameter.unique_id) {
                    parameter.unique_id = Box::default();
                }
                entry.parameter =
                    Some(Box::new(parameter)).filter(|parameter| **parameter != Parameter::default());
            }
            (_, Some(id)) if reference != Reference::None => entry.extra.push(id.name(), &id.value()),
            _ => {}
        }
        in_order(&mut entry.invalid_values);
        entry
    }

    /// The parameter that supplies an entry's missing attributes, and whether it belongs only to that entry; otherwise
    /// it is a copy.
    fn source(&mut self, reference: Reference) -> Option<(Parameter, bool)> {
        match reference {
            Reference::None | Reference::Dangling => None,
            Reference::Parameter(number) => match self.parameters.own(number, self.leftovers) {
                Some(own) => Some((own, true)),
                None => Some((self.parameters.shared(number, self.leftovers)?.clone(), false)),
            },
            Reference::Variable(number) => {
                let variable = self.variables.get(number as usize)?;
                let parameter = Parameter {
                    labels: variable.labels.clone(),
                    data_type: variable.data_type.clone(),
                    access: Some(ParameterAccess::NoAccess),
                    default_value: variable.default_value.clone(),
                    allowed_values: variable.allowed_values.clone(),
                    ..Parameter::default()
                };
                Some((parameter, false))
            }
        }
    }
}

/// Sorts the invalid values by field: attributes are read before parameters, and both may add some.
fn in_order(invalid_values: &mut InvalidValues) {
    if invalid_values.iter().is_sorted_by_key(|invalid| &invalid.field) {
        return;
    }
    let mut all: Vec<InvalidValue> = invalid_values.iter().cloned().collect();
    all.sort_by(|a, b| a.field.cmp(&b.field));
    *invalid_values = InvalidValues::default();
    for InvalidValue { field, text, reason } in all {
        invalid_values.push(field, &text, reason);
    }
}

/// Drops the types of ARRAYs and RECORDs that the writer generates.
fn drop_written_types(device: &mut Device, application: &mut [ApplicationProcess]) {
    for process in application {
        process.data_types.retain(|definition| {
            let Some(index) = types::index_of(&definition.unique_id) else { return true };
            let Some(object) = device.objects.get_mut(&index) else { return true };
            if types::definition_of(index, object).as_ref() != Some(definition) {
                return true;
            }
            drop_type_of(&mut object.main, &definition.unique_id);
            false
        });
    }
}

fn drop_type_of(entry: &mut Entry, id: &str) {
    let is_it = |reference: &DataTypeRef| matches!(reference, DataTypeRef::Defined(other) if &**other == id);
    if let Some(mut parameter) = entry.parameter.take() {
        parameter.data_type = parameter.data_type.take().filter(|reference| !is_it(reference));
        entry.parameter = Some(parameter).filter(|parameter| **parameter != Parameter::default());
    }
}
