//! The application process: data types, functions, templates, parameters and their groups (CiA 311 annex A).

use super::device::LABELS;
use super::{
    AttributePlace, Child, ElementChoice, Occurrence, ReferenceTarget, SchemaAttribute, SchemaElement, Shape,
    TextKind, at, attribute, choice, elements, kept, lens, of, slot,
};
use crate::model::{
    AllowedValues, AllowedValuesTemplate, ApplicationProcess, Connection, Count, EnumValue, FunctionInstance,
    FunctionInstances, FunctionType, Labels, MemberRef, Parameter, ParameterGroup, ParameterTemplate,
    Property, ScaledValue, SimpleType, Subrange, TypeDefinition, TypeShape, Unit, ValueRange, VarDeclaration,
    VariableRef, VersionInfo,
};
use crate::xdd::shape::{Nothing, PartsIn, Same, ValuesIn};
use crate::xml::n;

const ACCESS: TextKind =
    TextKind::Word(&["const", "read", "write", "readWrite", "readWriteInput", "readWriteOutput", "noAccess"]);
const COUNT_ACCESS: TextKind = TextKind::Word(&["const", "read", "write", "readWrite", "noAccess"]);
const SUPPORT: TextKind = TextKind::Word(&["mandatory", "optional", "conditional"]);

/// Declares the simple types, and their list followed by a type that the description defines and a variable.
macro_rules! simple_types {
    ($($NAME:ident $Type:ident)+) => {
        elements! { $($NAME local $NAME of SimpleType as (SimpleType::$Type, SimpleType::$Type);)+ }
        choice! { SIMPLE_TYPES of SimpleType: $($NAME)+ }
        static ALL_TYPES: [&SchemaElement; 21] = [$(&$NAME.element,)+ &DATA_TYPE_REF.element, &VARIABLE_REF.element];
    };
}

simple_types! {
    USINT Usint UINT Uint UDINT Udint SINT Sint INT Int DINT Dint BOOL Bool STRING String REAL Real LREAL Lreal ULINT Ulint
    LINT Lint BITSTRING Bitstring BYTE Byte WORD Word DWORD Dword LWORD Lword CHAR Char WSTRING Wstring
}

choice! { DEFINED_TYPES of Id: DATA_TYPE_REF }
choice! { VARIABLES of VariableRef: VARIABLE_REF }
static TYPES: &[&SchemaElement] = ALL_TYPES.split_at(20).0;
static PARAMETER_TYPES: &[&SchemaElement] = &ALL_TYPES;

elements! {
    DATA_TYPE_REF global dataTypeIDRef of Id (uniqueIDRef*: TextKind::Reference(ReferenceTarget::DataType) => [self]);

    APPLICATION_PROCESS global ApplicationProcess of ApplicationProcess, [
        maybe DATA_TYPE_LIST => same,
        maybe FUNCTION_TYPE_LIST => same,
        maybe FUNCTION_INSTANCE_LIST => [functions],
        maybe TEMPLATE_LIST => same,
        one PARAMETER_LIST => same,
        maybe PARAMETER_GROUP_LIST => same,
    ];

    DATA_TYPE_LIST global dataTypeList of ApplicationProcess, [some [ARRAY | STRUCT | ENUM | DERIVED] => [data_types]];
    ARRAY global array of TypeDefinition as (of_shape(TypeShape::Array { ranges: Vec::new(), element: None }), TypeDefinition { shape: TypeShape::Array { .. }, .. }) (name!: TextKind::Text => [name], uniqueID*: TextKind::Id => [unique_id]), [
        any (LABELS) => [labels.0], some SUBRANGE => [in shape TypeShape::Array { ranges, .. } => ranges], one (TYPES: SIMPLE_TYPES DEFINED_TYPES) => [in shape TypeShape::Array { element, .. } => element], stray (VARIABLES) => [in shape TypeShape::Array { element, .. } => element],
    ];
    SUBRANGE global subrange of Subrange (lowerLimit*: TextKind::LONG => [low], upperLimit*: TextKind::LONG => [high]);
    STRUCT global r#struct of TypeDefinition as (of_shape(TypeShape::Struct { members: Vec::new() }), TypeDefinition { shape: TypeShape::Struct { .. }, .. }) (name!: TextKind::Text => [name], uniqueID*: TextKind::Id => [unique_id]), [
        any (LABELS) => [labels.0], some VAR_DECLARATION => [in shape TypeShape::Struct { members } => members],
    ];
    ENUM global r#enum of TypeDefinition as (of_shape(TypeShape::Enum { size: None, values: Vec::new(), base: None }), TypeDefinition { shape: TypeShape::Enum { .. }, .. }) (
        name!: TextKind::Text => [name], uniqueID*: TextKind::Id => [unique_id], size?: TextKind::Text => [in shape TypeShape::Enum { size, .. } => size],
    ), [any (LABELS) => [labels.0], some ENUM_VALUE => [in shape TypeShape::Enum { values, .. } => values], maybe (SIMPLE_TYPES) => [in shape TypeShape::Enum { base, .. } => base]];
    ENUM_VALUE global enumValue of EnumValue (value?: TextKind::Text => [value]), [some (LABELS) => [labels.0]];
    DERIVED global derived of TypeDefinition as (of_shape(TypeShape::Derived { count: None, base: None }), TypeDefinition { shape: TypeShape::Derived { .. }, .. }) (name!: TextKind::Text => [name], uniqueID*: TextKind::Id => [unique_id]), [
        any (LABELS) => [labels.0], maybe COUNT => [in shape TypeShape::Derived { count, .. } => count], one (TYPES: SIMPLE_TYPES DEFINED_TYPES) => [in shape TypeShape::Derived { base, .. } => base], stray (VARIABLES) => [in shape TypeShape::Derived { base, .. } => base],
    ];
    COUNT global count of Count (uniqueID*: TextKind::Id => [unique_id], access?: COUNT_ACCESS => [access]), [
        any (LABELS) => [labels.0], one DEFAULT_VALUE => [default_value], maybe ALLOWED_VALUES => [allowed_values],
    ];
    VAR_DECLARATION global varDeclaration of VarDeclaration (
        name!: TextKind::Text => [name],
        uniqueID*: TextKind::Id => [unique_id],
        start?: TextKind::Text => [start],
        size?: TextKind::Text => [size],
        signed?: TextKind::Boolean => [signed],
        offset?: TextKind::Decimal => [offset],
        multiplier?: TextKind::Decimal => [multiplier],
        initialValue?: TextKind::Text => [initial_value],
    ), [
        any (LABELS) => [labels.0],
        one (TYPES: SIMPLE_TYPES DEFINED_TYPES) => [data_type],
        stray (VARIABLES) => [data_type],
        any CONDITIONAL_SUPPORT => {conditional_support},
        maybe DEFAULT_VALUE => [default_value],
        maybe ALLOWED_VALUES => [allowed_values],
        maybe UNIT => [unit],
    ], newer [start, signed, offset, multiplier, conditionalSupport, defaultValue, allowedValues, unit];

    FUNCTION_TYPE_LIST global functionTypeList of ApplicationProcess, [some FUNCTION_TYPE => [function_types]];
    FUNCTION_TYPE global functionType of FunctionType (
        name!: TextKind::Text => [name], uniqueID*: TextKind::Id => [unique_id], package?: TextKind::Text => [package],
    ), [
        any (LABELS) => [labels.0], some VERSION_INFO => [versions], one INTERFACE_LIST => same,
        maybe FUNCTION_INSTANCE_LIST => [functions],
    ];
    VERSION_INFO global versionInfo of VersionInfo (
        organization!: TextKind::Text => [organization], version!: TextKind::Text => [version],
        author!: TextKind::Text => [author], date!: TextKind::Date => [date],
    ), [any (LABELS) => [labels.0]];
    INTERFACE_LIST global interfaceList of FunctionType, [
        maybe INPUT_VARS => same, maybe OUTPUT_VARS => same, maybe CONFIG_VARS => same,
    ];
    INPUT_VARS global inputVars of FunctionType, [some VAR_DECLARATION => [inputs]];
    OUTPUT_VARS global outputVars of FunctionType, [some VAR_DECLARATION => [outputs]];
    CONFIG_VARS global configVars of FunctionType, [some VAR_DECLARATION => [configuration]];
    FUNCTION_INSTANCE_LIST global functionInstanceList of FunctionInstances, [
        some FUNCTION_INSTANCE => [instances], any CONNECTION => [connections],
    ];
    FUNCTION_INSTANCE global functionInstance of FunctionInstance (
        name!: TextKind::Text => [name], uniqueID*: TextKind::Id => [unique_id],
        typeIDRef*: TextKind::Reference(ReferenceTarget::FunctionType) => [function_type],
    ), [any (LABELS) => [labels.0]];
    CONNECTION global connection of Connection (
        source*: TextKind::Text => [source], destination*: TextKind::Text => [destination], description?: TextKind::Text => [description],
    );

    TEMPLATE_LIST global templateList of ApplicationProcess, [
        any PARAMETER_TEMPLATE => [parameter_templates], any ALLOWED_VALUES_TEMPLATE => [allowed_values_templates],
    ];
    ALLOWED_VALUES_TEMPLATE global allowedValuesTemplate of AllowedValuesTemplate (
        uniqueID*: TextKind::Id => [unique_id], templateIDRef+: TextKind::Text => [allowed.template],
    ), [any VALUE => [allowed.values], any RANGE => [allowed.ranges]];

    PARAMETER_LIST global parameterList of ApplicationProcess, [some PARAMETER => [parameters]];
    VARIABLE_REF global variableRef of VariableRef (position?: TextKind::BYTE => [position]), [
        some INSTANCE_REF => {instances}, one VARIABLE_ID_REF => {variable}, any MEMBER_REF => [members],
    ];
    INSTANCE_REF global instanceIDRef of Nothing (uniqueIDRef*: TextKind::Reference(ReferenceTarget::FunctionInstance));
    VARIABLE_ID_REF global variableIDRef of Nothing (uniqueIDRef*: TextKind::Reference(ReferenceTarget::Variable));
    MEMBER_REF global memberRef of MemberRef (
        uniqueIDRef?: TextKind::Reference(ReferenceTarget::Variable) => [unique_id], index?: TextKind::LONG => [index],
    );
    CONDITIONAL_SUPPORT global conditionalSupport of Nothing (paramIDRef*: TextKind::Reference(ReferenceTarget::Parameter));
    DENOTATION global denotation of Labels, [some (LABELS) => [0]];
    ALLOWED_VALUES global allowedValues of AllowedValues (
        templateIDRef?: TextKind::Reference(ReferenceTarget::AllowedValuesTemplate) => [template],
    ), [any VALUE => [values], any RANGE => [ranges]];
    RANGE global range of ValueRange, [one MIN_VALUE => [min], one MAX_VALUE => [max], maybe STEP => [step]];
    UNIT global unit of Unit (multiplier!: TextKind::Decimal => [multiplier], unitURI?: TextKind::Text => [uri]), [some (LABELS) => [labels.0]];
    PROPERTY global property of Property (name*: TextKind::Text => [name], value!: TextKind::Text => [value]);

    PARAMETER_GROUP_LIST global parameterGroupList of ApplicationProcess, [some PARAMETER_GROUP => [groups]];
    PARAMETER_GROUP global parameterGroup of ParameterGroup (
        uniqueID*: TextKind::Id => [unique_id], kindOfAccess?: TextKind::Text => [kind_of_access],
    ), [some (LABELS) => [labels.0], any PARAMETER_GROUP => [groups], any PARAMETER_REF => {parameters}];
    PARAMETER_REF global parameterRef of Nothing (uniqueIDRef*: TextKind::Reference(ReferenceTarget::Parameter));
}

/// An element with only a reference.
type Id = Box<str>;

fn of_shape(shape: TypeShape) -> TypeDefinition {
    TypeDefinition { shape, ..TypeDefinition::default() }
}

/// Declares the elements that contain a value with its own scaling.
macro_rules! values {
    ($($NAME:ident $form:ident $name:ident)+) => {elements! {
        $($NAME $form $name of ScaledValue (
            value*: TextKind::Text => [value], offset?: TextKind::Decimal => [offset], multiplier?: TextKind::Decimal => [multiplier],
        ), [any (LABELS) => [labels.0]];)+
    }};
}

values! {
    ACTUAL_VALUE global actualValue
    DEFAULT_VALUE global defaultValue
    SUBSTITUTE_VALUE global substituteValue
    VALUE global value
    MIN_VALUE local minValue
    MAX_VALUE local maxValue
    STEP local step
}

/// Declares parameters and their templates, which have fewer children.
macro_rules! parameters {
    ($($NAME:ident $name:ident ($Part:ident $($in:tt)*) $labels:ident $least:ident $types:tt $denotation:ident [$($more:tt)*];)+) => {elements! {
        $($NAME global $name of $Part (
            uniqueID*: TextKind::Id => [$($in)*unique_id],
            access?: ACCESS => [$($in)*access],
            accessList?: TextKind::Names => [$($in)*access_list],
            support?: SUPPORT => [$($in)*support],
            persistent?: TextKind::Boolean => [$($in)*persistent],
            offset?: TextKind::Decimal => [$($in)*offset],
            multiplier?: TextKind::Decimal => [$($in)*multiplier],
            templateIDRef?: TextKind::Reference(ReferenceTarget::ParameterTemplate) => [$($in)*template],
        ), [
            $labels (LABELS) => [$($in)*labels.0],
            $least $types => [$($in)*data_type],
            $($more)*
            any CONDITIONAL_SUPPORT => {$($in)*conditional_support},
            $denotation DENOTATION => [$($in)*denotation],
            maybe ACTUAL_VALUE => [$($in)*actual_value],
            maybe DEFAULT_VALUE => [$($in)*default_value],
            maybe SUBSTITUTE_VALUE => [$($in)*substitute_value],
            maybe ALLOWED_VALUES => [$($in)*allowed_values],
            maybe UNIT => [$($in)*unit],
            any PROPERTY => [$($in)*properties],
        ];)+
    }};
}

parameters! {
    PARAMETER parameter (Parameter) some one (PARAMETER_TYPES: SIMPLE_TYPES DEFINED_TYPES VARIABLES) maybe [];
    PARAMETER_TEMPLATE parameterTemplate (ParameterTemplate parameter.) stray maybe (TYPES: SIMPLE_TYPES DEFINED_TYPES) stray
        [stray (VARIABLES) => [parameter.data_type],];
}
