//! Parameters of the application process: the meaning of entries for users and applications (CiA 311
//! §6.4.5).
//!
//! Attributes that a parameter shares with an entry are stored in the entry, so rules and generators see one
//! dictionary for all formats.

use super::part::{part, words};
use super::{DataTypeRef, LANGUAGE, Labels};

part! {
    /// A parameter. Most parameters describe one entry of the dictionary and belong to that
    /// [`Entry`](super::Entry); fields that the entry already contains (data type, access, values,
    /// limits, denotation) are empty here.
    pub struct Parameter {
        /// `uniqueID`: the id in references of groups, conditions and objects.
        pub unique_id: Box<str>,
        /// Names and descriptions.
        pub labels: Labels,
        /// The data type; `None` if the entry has it.
        pub data_type: Option<DataTypeRef>,
        /// `access`.
        pub access: Option<ParameterAccess>,
        /// `accessList`: further access rights, with names of the vendor.
        pub access_list: Option<Box<str>>,
        /// `support`.
        pub support: Option<Support>,
        /// `persistent`: whether the value survives power-off; no if missing.
        pub persistent: Option<bool>,
        /// `offset` of the engineering value, which is (value + offset) * multiplier; 0 if missing.
        pub offset: Option<Box<str>>,
        /// `multiplier` of the engineering value; 1 if missing.
        pub multiplier: Option<Box<str>>,
        /// `templateIDRef`: the parameter template with the remaining properties.
        pub template: Option<Box<str>>,
        /// `conditionalSupport`: the parameters on which the support of this one depends.
        pub conditional_support: Vec<Box<str>>,
        /// `denotation`: names in the application.
        pub denotation: Labels,
        /// `actualValue` of a configured device.
        pub actual_value: Option<ScaledValue>,
        /// `defaultValue`.
        pub default_value: Option<ScaledValue>,
        /// `substituteValue`: the value to use if the device has no valid value.
        pub substitute_value: Option<ScaledValue>,
        /// `allowedValues`; every value of the type if missing.
        pub allowed_values: Option<AllowedValues>,
        /// `unit`.
        pub unit: Option<Unit>,
        /// `property`: additions of the vendor or a tool.
        pub properties: Vec<Property>,
    }

    /// A value with its own scaling (`ag_value`) and optional names.
    pub struct ScaledValue {
        /// `value`, as written: its meaning depends on the data type of the parameter.
        pub value: Box<str>,
        /// `offset`.
        pub offset: Option<Box<str>>,
        /// `multiplier`.
        pub multiplier: Option<Box<str>>,
        /// The meaning of the value: names and descriptions.
        pub labels: Labels,
    }

    /// The allowed values of a parameter: single values and ranges.
    pub struct AllowedValues {
        /// `templateIDRef`: the template with further values.
        pub template: Option<Box<str>>,
        /// `value`: single values.
        pub values: Vec<ScaledValue>,
        /// `range`.
        pub ranges: Vec<ValueRange>,
    }

    /// A range of values, including both ends.
    pub struct ValueRange {
        /// `minValue`.
        pub min: ScaledValue,
        /// `maxValue`.
        pub max: ScaledValue,
        /// `step`: the distance between neighbouring values.
        pub step: Option<ScaledValue>,
    }

    /// The unit of the engineering value.
    pub struct Unit {
        /// `multiplier`: the factor to convert the value to the base unit.
        pub multiplier: Box<str>,
        /// `unitURI`.
        pub uri: Option<Box<str>>,
        /// The symbol or name of the unit, such as `mm`.
        pub labels: Labels,
    }

    /// A name with a value, without a meaning in the standard.
    pub struct Property {
        /// `name`.
        pub name: Box<str>,
        /// `value`.
        pub value: Box<str>,
    }

    /// A group of parameters, as configuration tools show them.
    pub struct ParameterGroup {
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// `kindOfAccess`.
        pub kind_of_access: Option<Box<str>>,
        /// Names and descriptions.
        pub labels: Labels,
        /// The nested groups.
        pub groups: Vec<ParameterGroup>,
        /// `parameterRef`: the ids of its parameters.
        pub parameters: Vec<Box<str>>,
    }

    /// Common properties of parameters (`parameterTemplate`): a parameter without names.
    pub struct ParameterTemplate {
        /// The common properties.
        pub parameter: Parameter,
    }

    /// Common allowed values of parameters (`allowedValuesTemplate`).
    pub struct AllowedValuesTemplate {
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// The values.
        pub allowed: AllowedValues,
    }
}

words! {
    /// The access of applications to a parameter.
    pub enum ParameterAccess {
        /// The value never changes.
        Const = "const",
        /// Read only.
        Read = "read",
        /// Write only.
        Write = "write",
        /// Read and write.
        ReadWrite = "readWrite",
        /// Read and write; a process input, so `rwr`.
        ReadWriteInput = "readWriteInput",
        /// Read and write; a process output, so `rww`.
        ReadWriteOutput = "readWriteOutput",
        /// No access over the network.
        NoAccess = "noAccess",
    }

    /// Whether a device must have a parameter.
    pub enum Support {
        /// Always.
        Mandatory = "mandatory",
        /// At the choice of the vendor.
        Optional = "optional",
        /// If the parameters of `conditionalSupport` are supported.
        Conditional = "conditional",
    }
}

impl AllowedValues {
    /// Single values, each with its name in the language of objdict's own texts.
    pub fn named(values: impl IntoIterator<Item = (impl Into<Box<str>>, impl AsRef<str>)>) -> Self {
        let values = values.into_iter().map(|(value, name)| ScaledValue {
            value: value.into(),
            labels: Labels::name(LANGUAGE, name.as_ref()),
            ..ScaledValue::default()
        });
        Self { values: values.collect(), ..Self::default() }
    }
}

impl Unit {
    /// A unit by its symbol or name.
    pub fn named(lang: &str, name: &str) -> Self {
        Self { multiplier: "1".into(), uri: None, labels: Labels::name(lang, name) }
    }
}

impl Parameter {
    /// The generated id of a parameter without one, from its index or sub-index: `UID_OBJ_1018`,
    /// `UID_SUB_101801`.
    pub fn usual_id(index: u16, sub: Option<u8>) -> String {
        match sub {
            Some(sub) => format!("UID_SUB_{index:04X}{sub:02X}"),
            None => format!("UID_OBJ_{index:04X}"),
        }
    }

    /// Whether the parameter has the generated id, or none, which is equivalent.
    pub fn has_usual_id(&self, index: u16, sub: Option<u8>) -> bool {
        let is_number = |digits: &str, number: u32| {
            let is_hex = digits.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'A'..=b'F'));
            is_hex && u32::from_str_radix(digits, 16) == Ok(number)
        };
        // like `usual_id`, without allocating a text
        let usual = match sub {
            None => self.unique_id.strip_prefix("UID_OBJ_").filter(|digits| digits.len() == 4),
            Some(_) => self.unique_id.strip_prefix("UID_SUB_").filter(|digits| digits.len() == 6),
        };
        let number = sub.map_or(u32::from(index), |sub| u32::from(index) << 8 | u32::from(sub));
        self.unique_id.is_empty() || usual.is_some_and(|digits| is_number(digits, number))
    }

    /// Whether the parameter has no content beyond the existence of the entry.
    pub fn is_implied(&self, index: u16, sub: Option<u8>) -> bool {
        self.has_usual_id(index, sub)
            && *self == Self { unique_id: self.unique_id.clone(), ..Self::default() }
    }
}
