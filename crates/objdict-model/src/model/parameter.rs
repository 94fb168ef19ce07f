//! Parameters of the application process: what an entry means to people and applications (CiA 311 §6.4.5).

use super::part::{part, words};
use super::{DataTypeRef, Labels};

part! {
    /// A parameter. Most describe one entry of the dictionary and then belong to that [`Entry`](super::Entry); what the
    /// entry says itself (data type, access, values, limits, denotation) stands there and is empty here.
    pub struct Parameter {
        /// `uniqueID`: what groups, conditions and objects call it.
        pub unique_id: Box<str>,
        /// Names and descriptions.
        pub labels: Labels,
        /// The data type; `None` where the entry has it.
        pub data_type: Option<DataTypeRef>,
        /// `access`.
        pub access: Option<ParameterAccess>,
        /// `accessList`: further access rights, as the manufacturer names them.
        pub access_list: Option<Box<str>>,
        /// `support`.
        pub support: Option<Support>,
        /// `persistent`: whether the value outlives the supply; missing means no.
        pub persistent: Option<bool>,
        /// `offset` of the engineering value, which is (value + offset) * multiplier; missing means 0.
        pub offset: Option<Box<str>>,
        /// `multiplier` of the engineering value; missing means 1.
        pub multiplier: Option<Box<str>>,
        /// `templateIDRef`: the parameter template with everything that is not said here.
        pub template: Option<Box<str>>,
        /// `conditionalSupport`: the parameters that decide whether this one is supported.
        pub conditional_support: Vec<Box<str>>,
        /// `denotation`: names in the application.
        pub denotation: Labels,
        /// `actualValue` of a configured device.
        pub actual_value: Option<ScaledValue>,
        /// `defaultValue`.
        pub default_value: Option<ScaledValue>,
        /// `substituteValue`: what holds while the device has no valid value.
        pub substitute_value: Option<ScaledValue>,
        /// `allowedValues`; missing means every value of the type.
        pub allowed_values: Option<AllowedValues>,
        /// `unit`.
        pub unit: Option<Unit>,
        /// `property`: what the manufacturer or a tool adds.
        pub properties: Vec<Property>,
    }

    /// A value with its own scaling (`ag_value`) and perhaps with names.
    pub struct ScaledValue {
        /// `value`, as it is written: what it means depends on the data type of the parameter.
        pub value: Box<str>,
        /// `offset`.
        pub offset: Option<Box<str>>,
        /// `multiplier`.
        pub multiplier: Option<Box<str>>,
        /// What the value means: names and descriptions.
        pub labels: Labels,
    }

    /// The values that a parameter may have: single ones and ranges.
    pub struct AllowedValues {
        /// `templateIDRef`: the template with more of them.
        pub template: Option<Box<str>>,
        /// `value`: single values.
        pub values: Vec<ScaledValue>,
        /// `range`.
        pub ranges: Vec<ValueRange>,
    }

    /// A range of values, both ends in it.
    pub struct ValueRange {
        /// `minValue`.
        pub min: ScaledValue,
        /// `maxValue`.
        pub max: ScaledValue,
        /// `step`: the distance of neighbouring values.
        pub step: Option<ScaledValue>,
    }

    /// The unit of the engineering value.
    pub struct Unit {
        /// `multiplier`: by what the value is multiplied to get the base unit.
        pub multiplier: Box<str>,
        /// `unitURI`.
        pub uri: Option<Box<str>>,
        /// Its symbol or name, such as `mm`.
        pub labels: Labels,
    }

    /// A name with a value, which the standard gives no meaning.
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
        /// Groups in it.
        pub groups: Vec<ParameterGroup>,
        /// `parameterRef`: the ids of its parameters.
        pub parameters: Vec<Box<str>>,
    }

    /// What parameters have in common (`parameterTemplate`): a parameter without names.
    pub struct ParameterTemplate {
        /// What each of them says.
        pub parameter: Parameter,
    }

    /// Allowed values that several parameters have (`allowedValuesTemplate`).
    pub struct AllowedValuesTemplate {
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// The values.
        pub allowed: AllowedValues,
    }
}

words! {
    /// How applications may use a parameter.
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
        /// Not over the network.
        NoAccess = "noAccess",
    }

    /// Whether a device must have a parameter.
    pub enum Support {
        /// Always.
        Mandatory = "mandatory",
        /// As the manufacturer likes.
        Optional = "optional",
        /// When the parameters of `conditionalSupport` are supported.
        Conditional = "conditional",
    }
}

impl Parameter {
    /// The id that a parameter without one is given, after its index or sub-index: `UID_OBJ_1018`, `UID_SUB_101801`.
    pub fn usual_id(index: u16, sub: Option<u8>) -> String {
        match sub {
            Some(sub) => format!("UID_SUB_{index:04X}{sub:02X}"),
            None => format!("UID_OBJ_{index:04X}"),
        }
    }

    /// Whether it has the id that it would be given, or none, which is the same.
    pub fn has_usual_id(&self, index: u16, sub: Option<u8>) -> bool {
        let is_number = |digits: &str, number: u32| {
            let is_hex = digits.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'A'..=b'F'));
            is_hex && u32::from_str_radix(digits, 16) == Ok(number)
        };
        // as `usual_id`, without making a text for each
        let usual = match sub {
            None => self.unique_id.strip_prefix("UID_OBJ_").filter(|digits| digits.len() == 4),
            Some(_) => self.unique_id.strip_prefix("UID_SUB_").filter(|digits| digits.len() == 6),
        };
        let number = sub.map_or(u32::from(index), |sub| u32::from(index) << 8 | u32::from(sub));
        self.unique_id.is_empty() || usual.is_some_and(|digits| is_number(digits, number))
    }

    /// Whether it says nothing but that the entry exists.
    pub fn is_implied(&self, index: u16, sub: Option<u8>) -> bool {
        self.has_usual_id(index, sub)
            && *self == Self { unique_id: self.unique_id.clone(), ..Self::default() }
    }
}
