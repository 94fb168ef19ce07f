//! The application process: data types, functions, parameters and their groups (CiA 311 §6.4).

use super::part::part;
use super::{
    AllowedValues, AllowedValuesTemplate, DataTypeRef, Labels, Parameter, ParameterAccess, ParameterGroup,
    ParameterTemplate, ScaledValue, SimpleType, Unit,
};

part! {
    /// The application process of a device.
    pub struct ApplicationProcess {
        /// `dataTypeList`.
        pub data_types: Vec<TypeDefinition>,
        /// `functionTypeList`.
        pub function_types: Vec<FunctionType>,
        /// `functionInstanceList`.
        pub functions: FunctionInstances,
        /// `templateList`: templates of parameters.
        pub parameter_templates: Vec<ParameterTemplate>,
        /// `templateList`: templates of allowed values.
        pub allowed_values_templates: Vec<AllowedValuesTemplate>,
        /// Parameters that belong to no entry of the dictionary, or to several.
        pub parameters: Vec<Parameter>,
        /// `parameterGroupList`.
        pub groups: Vec<ParameterGroup>,
    }

    /// A data type that the description defines.
    pub struct TypeDefinition {
        /// `name`.
        pub name: Box<str>,
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// Names and descriptions.
        pub labels: Labels,
        /// The content of the type.
        pub shape: TypeShape,
    }

    /// One of the indexes of an array.
    pub struct Subrange {
        /// `lowerLimit`.
        pub low: Box<str>,
        /// `upperLimit`.
        pub high: Box<str>,
    }

    /// A value of an enumeration.
    pub struct EnumValue {
        /// Names and descriptions.
        pub labels: Labels,
        /// `value`; by default one more than the previous value.
        pub value: Option<Box<str>>,
    }

    /// The number of elements of a derived type (`count`).
    pub struct Count {
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// `access`.
        pub access: Option<ParameterAccess>,
        /// Names and descriptions.
        pub labels: Labels,
        /// `defaultValue`.
        pub default_value: Option<ScaledValue>,
        /// `allowedValues`.
        pub allowed_values: Option<AllowedValues>,
    }

    /// A member of a struct, or a variable of a function.
    pub struct VarDeclaration {
        /// `name`.
        pub name: Box<str>,
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// Names and descriptions.
        pub labels: Labels,
        /// The data type.
        pub data_type: Option<DataTypeRef>,
        /// `start`: the first bit.
        pub start: Option<Box<str>>,
        /// `size`: the number of elements.
        pub size: Option<Box<str>>,
        /// `signed`: whether a bit string is a signed number.
        pub signed: Option<bool>,
        /// `offset` of the engineering value.
        pub offset: Option<Box<str>>,
        /// `multiplier` of the engineering value.
        pub multiplier: Option<Box<str>>,
        /// `initialValue`.
        pub initial_value: Option<Box<str>>,
        /// `conditionalSupport`: the parameters on which the support depends.
        pub conditional_support: Vec<Box<str>>,
        /// `defaultValue`.
        pub default_value: Option<ScaledValue>,
        /// `allowedValues`.
        pub allowed_values: Option<AllowedValues>,
        /// `unit`.
        pub unit: Option<Unit>,
    }

    /// A kind of function.
    pub struct FunctionType {
        /// `name`.
        pub name: Box<str>,
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// `package`: the library of the function type.
        pub package: Option<Box<str>>,
        /// Names and descriptions.
        pub labels: Labels,
        /// `versionInfo`.
        pub versions: Vec<VersionInfo>,
        /// `inputVars`.
        pub inputs: Vec<VarDeclaration>,
        /// `outputVars`.
        pub outputs: Vec<VarDeclaration>,
        /// `configVars`.
        pub configuration: Vec<VarDeclaration>,
        /// The functions that it consists of.
        pub functions: FunctionInstances,
    }

    /// The origin of a version of a function type.
    pub struct VersionInfo {
        /// `organization`.
        pub organization: Box<str>,
        /// `version`.
        pub version: Box<str>,
        /// `author`.
        pub author: Box<str>,
        /// `date`, as written.
        pub date: Box<str>,
        /// Names and descriptions.
        pub labels: Labels,
    }

    /// Functions and their connections.
    pub struct FunctionInstances {
        /// `functionInstance`.
        pub instances: Vec<FunctionInstance>,
        /// `connection`.
        pub connections: Vec<Connection>,
    }

    /// A function of a function type.
    pub struct FunctionInstance {
        /// `name`.
        pub name: Box<str>,
        /// `uniqueID`.
        pub unique_id: Box<str>,
        /// `typeIDRef`: its function type.
        pub function_type: Box<str>,
        /// Names and descriptions.
        pub labels: Labels,
    }

    /// A connection from an output to an input.
    pub struct Connection {
        /// `source`.
        pub source: Box<str>,
        /// `destination`.
        pub destination: Box<str>,
        /// `description`.
        pub description: Option<Box<str>>,
    }
}

/// The content of a data type.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case", deny_unknown_fields))]
pub enum TypeShape {
    /// Elements of one type, with one dimension per range.
    Array {
        /// `subrange`.
        #[cfg_attr(feature = "serde", serde(default))]
        ranges: Vec<Subrange>,
        /// The type of an element.
        #[cfg_attr(feature = "serde", serde(default))]
        element: Option<DataTypeRef>,
    },
    /// Members of any types.
    Struct {
        /// `varDeclaration`.
        #[cfg_attr(feature = "serde", serde(default))]
        members: Vec<VarDeclaration>,
    },
    /// Values with names.
    Enum {
        /// `size`: the number of values.
        #[cfg_attr(feature = "serde", serde(default))]
        size: Option<Box<str>>,
        /// `enumValue`.
        #[cfg_attr(feature = "serde", serde(default))]
        values: Vec<EnumValue>,
        /// The type of a value.
        #[cfg_attr(feature = "serde", serde(default))]
        base: Option<SimpleType>,
    },
    /// An alias of a type.
    Derived {
        /// `count`: the number of elements.
        #[cfg_attr(feature = "serde", serde(default))]
        count: Option<Box<Count>>,
        /// The type.
        #[cfg_attr(feature = "serde", serde(default))]
        base: Option<DataTypeRef>,
    },
}

impl Default for TypeShape {
    fn default() -> Self {
        Self::Struct { members: Vec::new() }
    }
}
