//! The meaning of values of entries according to the application process (CiA 311 §6.4): named values and
//! bit fields.

mod bit_struct;
mod enumeration;

use std::collections::HashMap;

use super::{
    AllowedValues, ApplicationProcess, DataType, DataTypeRef, Device, Entry, FunctionType, Parameter,
    SimpleType, TypeDefinition, TypeShape, Unit, VarDeclaration,
};
pub use bit_struct::{BitField, BitStruct};
pub use enumeration::{Enumeration, NamedValue};

/// The maximum depth of derived types; a deeper chain is a cycle.
const MAX_DERIVATIONS: usize = 16;

/// The meaning of the values of an entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Meaning<'a> {
    /// The values have names.
    Enumeration(Enumeration<'a>),
    /// The bits form fields.
    BitStruct(BitStruct<'a>),
}

/// The types, templates and parameters of a device's application processes, by their ids.
#[derive(Debug)]
pub struct Meanings<'a> {
    device: &'a Device,
    language: &'a str,
    definitions: Definitions<'a>,
    /// Shared targets of entries: parameters, members of structs, variables of functions.
    shared: HashMap<&'a str, DescribedItem<'a>>,
}

/// How the engineering value of a parameter is calculated from its value: (value + offset) × multiplier, in a
/// unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scaling<'a> {
    /// The unit.
    pub unit: Option<&'a Unit>,
    /// The offset as written, 0 if missing.
    pub offset: Option<&'a str>,
    /// The multiplier as written, 1 if missing.
    pub multiplier: Option<&'a str>,
}

impl<'a> Scaling<'a> {
    fn new(unit: Option<&'a Unit>, offset: Option<&'a str>, multiplier: Option<&'a str>) -> Self {
        let stated = |text: Option<&'a str>| text.map(str::trim).filter(|text| !text.is_empty());
        Self { unit, offset: stated(offset), multiplier: stated(multiplier) }
    }

    fn of_variable(variable: &'a VarDeclaration) -> Self {
        Self::new(variable.unit.as_ref(), variable.offset.as_deref(), variable.multiplier.as_deref())
    }

    /// The factor that converts the value to the base unit; `None` if it is 1 or not a number, or if there is
    /// an offset.
    pub fn factor(&self) -> Option<String> {
        let has_offset = self.offset.is_some_and(|text| text.parse() != Ok(0.0));
        let of_unit = self.unit.map(|unit| &*unit.multiplier).filter(|text| *text != "1");
        let factor = match (self.multiplier, of_unit) {
            (Some(text), None) | (None, Some(text)) => text.to_owned(),
            (Some(a), Some(b)) => (a.parse::<f64>().ok()? * b.trim().parse::<f64>().ok()?).to_string(),
            (None, None) => return None,
        };
        let number: f64 = factor.trim().parse().ok()?;
        (!has_offset && number.is_finite() && number != 1.0).then_some(factor)
    }

    /// Whether neither a unit nor a scale is stated.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// The type, the allowed values and the scaling of an item.
#[derive(Clone, Copy, Debug, Default)]
struct DescribedItem<'a> {
    data_type: Option<&'a DataTypeRef>,
    allowed: Option<&'a AllowedValues>,
    scaling: Scaling<'a>,
}

impl Device {
    /// The meanings of the values of its entries, prepared for lookup; names in several languages are in
    /// English.
    pub fn meanings(&self) -> Meanings<'_> {
        self.meanings_in("en")
    }

    /// The meanings of the values of its entries, with names in a language; see
    /// [`Labels::name_in`](super::Labels::name_in).
    pub fn meanings_in<'a>(&'a self, language: &'a str) -> Meanings<'a> {
        Meanings::new(self, language)
    }
}

impl<'a> Meanings<'a> {
    fn new(device: &'a Device, language: &'a str) -> Self {
        let definitions = Definitions::of(&device.application);
        let mut found = Self { device, language, definitions, shared: HashMap::new() };
        device.application.iter().for_each(|process| found.add(process));
        found
    }

    /// Adds the types, templates and parameters of an application process. Of two equal ids, the first is
    /// used.
    fn add(&mut self, process: &'a ApplicationProcess) {
        for parameter in &process.parameters {
            let described = self.of_parameter(parameter);
            self.shared.entry(&parameter.unique_id).or_insert(described);
        }
        for variable in Definitions::variables(std::slice::from_ref(process)) {
            self.shared.entry(&variable.unique_id).or_insert(DescribedItem::of_variable(variable));
        }
    }

    /// The meaning of the values of an entry; `None` if the description does not define it.
    pub fn of(&self, index: u16, sub: u8) -> Option<Meaning<'a>> {
        let object = self.device.object(index)?;
        let entry = match object.subs.get(sub) {
            Some(entry) => entry,
            None => {
                Some(&object.main).filter(|_| object.has(sub) && (sub > 0 || object.compact.is_none()))?
            }
        };
        let data_type = entry.data_type?;
        let described = self.described(entry);
        let of_element = || {
            let array = self.described(&object.main).data_type.filter(|_| sub > 0)?;
            match &self.definition(array)?.shape {
                TypeShape::Array { element, .. } => self.definition(element.as_ref()?),
                _ => None,
            }
        };
        let definition =
            described.data_type.and_then(|reference| self.definition(reference)).or_else(of_element);
        self.of_type(definition, data_type).or_else(|| {
            Enumeration::of_allowed(self.definitions.allowed(described.allowed?), data_type, self.language)
                .map(Meaning::Enumeration)
        })
    }

    /// The meaning of the values of a type, in an entry of this data type.
    fn of_type(&self, definition: Option<&'a TypeDefinition>, data_type: DataType) -> Option<Meaning<'a>> {
        let definition = definition?;
        match &definition.shape {
            TypeShape::Enum { values, .. } if !values.is_empty() => {
                Some(Meaning::Enumeration(Enumeration::of_type(definition, values, data_type, self.language)))
            }
            TypeShape::Struct { members } if data_type.is_integer() && !members.is_empty() => {
                Some(Meaning::BitStruct(BitStruct::new(self, definition, members, data_type)))
            }
            _ => None,
        }
    }

    /// The type that the application process defines for an entry or object, with aliases resolved.
    pub fn type_of(&self, entry: &'a Entry) -> Option<&'a TypeDefinition> {
        self.definition(self.described(entry).data_type?)
    }

    /// The scaling of an entry, from its parameter, the parameter's template, or the target of its reference.
    pub fn scaling_of(&self, entry: &'a Entry) -> Scaling<'a> {
        self.described(entry).scaling
    }

    /// The scaling of a parameter, from itself or its template.
    pub fn scaling<'p>(&self, parameter: &'p Parameter) -> Scaling<'p>
    where
        'a: 'p,
    {
        let template = self.definitions.template(parameter).unwrap_or(parameter);
        Scaling::new(
            parameter.unit.as_ref().or(template.unit.as_ref()),
            parameter.offset.as_deref().or(template.offset.as_deref()),
            parameter.multiplier.as_deref().or(template.multiplier.as_deref()),
        )
    }

    /// The definition that a reference resolves to, through aliases.
    fn definition(&self, reference: &DataTypeRef) -> Option<&'a TypeDefinition> {
        let mut id = match reference {
            DataTypeRef::Defined(id) => &**id,
            _ => return None,
        };
        for _ in 0..MAX_DERIVATIONS {
            let definition = *self.definitions.types.get(id)?;
            match &definition.shape {
                TypeShape::Derived { base: Some(DataTypeRef::Defined(base)), .. } => id = base,
                TypeShape::Derived { .. } => return None,
                _ => return Some(definition),
            }
        }
        None
    }

    fn described(&self, entry: &'a Entry) -> DescribedItem<'a> {
        match (&entry.parameter, entry.extra.get("uniqueIDRef")) {
            (Some(parameter), _) => self.of_parameter(parameter),
            (None, Some(id)) => self.shared.get(id.trim_ascii()).copied().unwrap_or_default(),
            (None, None) => DescribedItem::default(),
        }
    }

    /// The properties of a parameter, or else of its template.
    fn of_parameter(&self, parameter: &'a Parameter) -> DescribedItem<'a> {
        let template = self.definitions.template(parameter).unwrap_or(parameter);
        DescribedItem {
            data_type: parameter.data_type.as_ref().or(template.data_type.as_ref()),
            allowed: parameter.allowed_values.as_ref().or(template.allowed_values.as_ref()),
            scaling: self.scaling(parameter),
        }
    }
}

impl<'a> DescribedItem<'a> {
    fn of_variable(variable: &'a VarDeclaration) -> Self {
        Self {
            data_type: variable.data_type.as_ref(),
            allowed: variable.allowed_values.as_ref(),
            scaling: Scaling::of_variable(variable),
        }
    }
}

/// Parses an integer as descriptions write it: decimal with or without a sign, or `0x` and hex digits.
fn number(text: &str) -> Option<i128> {
    let text = text.trim_ascii();
    let (sign, digits) = match text.strip_prefix('-') {
        Some(rest) => (-1, rest),
        None => (1, text.strip_prefix('+').unwrap_or(text)),
    };
    let (digits, radix) = match digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")) {
        Some(hex) => (hex, 16),
        None => (digits, 10),
    };
    let is_number = !digits.is_empty() && digits.len() <= 24 && digits.chars().all(|c| c.is_digit(radix));
    if !is_number {
        return None;
    }
    i128::from_str_radix(digits, radix).ok().map(|number| sign * number)
}

/// The targets of references in parameters: types and templates, by id. Of two equal ids, the first is used.
#[derive(Debug, Default)]
#[doc(hidden)] // for the reader of CiA 311
pub struct Definitions<'a> {
    types: HashMap<&'a str, &'a TypeDefinition>,
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

    /// The simple type of a reference, resolved through aliases and enumerations; enumerations without a type have
    /// `of_enum`. `None` for arrays, structs and dangling references.
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

    /// The template of a parameter, which supplies missing properties.
    pub fn template(&self, parameter: &Parameter) -> Option<&'a Parameter> {
        self.templates.get(parameter.template.as_deref()?).copied()
    }

    /// The allowed values, or the template's if they are only a reference.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_decimal_or_hex() {
        for (text, expected) in
            [("10", Some(10)), (" -0x10 ", Some(-16)), ("+3", Some(3)), ("007", Some(7)), ("0XfF", Some(255))]
        {
            assert_eq!(number(text), expected, "{text}");
        }
        for text in ["", "-", "0x", "1.5", "--1", "0x-1", "ä", "1000000000000000000000000"] {
            assert_eq!(number(text), None, "{text}");
        }
    }
}
