//! The application process: data types, functions, templates, parameters and their groups (CiA 311 annex A).

use super::device::LABELS;
use super::values::{Kind, Target};
use super::{Element, elements, need, slot};

const ACCESS: Kind =
    Kind::Word(&["const", "read", "write", "readWrite", "readWriteInput", "readWriteOutput", "noAccess"]);
const COUNT_ACCESS: Kind = Kind::Word(&["const", "read", "write", "readWrite", "noAccess"]);
const SUPPORT: Kind = Kind::Word(&["mandatory", "optional", "conditional"]);

/// A type of IEC 61131-3, or one that the description defines.
static TYPES: &[&Element] = &[
    &USINT,
    &UINT,
    &UDINT,
    &SINT,
    &INT,
    &DINT,
    &DATA_TYPE_REF,
    &BOOL,
    &STRING,
    &REAL,
    &LREAL,
    &ULINT,
    &LINT,
    &BITSTRING,
    &BYTE,
    &WORD,
    &DWORD,
    &LWORD,
    &CHAR,
    &WSTRING,
];
/// The same, or variables of functions that have their own.
static PARAMETER_TYPES: &[&Element] = &[
    &USINT,
    &UINT,
    &UDINT,
    &SINT,
    &INT,
    &DINT,
    &DATA_TYPE_REF,
    &BOOL,
    &STRING,
    &REAL,
    &LREAL,
    &ULINT,
    &LINT,
    &BITSTRING,
    &BYTE,
    &WORD,
    &DWORD,
    &LWORD,
    &CHAR,
    &WSTRING,
    &VARIABLE_REF,
];
static SIMPLE_TYPES: &[&Element] = &[
    &USINT, &UINT, &UDINT, &SINT, &INT, &DINT, &BOOL, &STRING, &REAL, &LREAL, &ULINT, &LINT, &BITSTRING,
    &BYTE, &WORD, &DWORD, &LWORD, &CHAR, &WSTRING,
];

elements! {
    BOOL local "BOOL";
    BITSTRING local "BITSTRING";
    BYTE local "BYTE";
    CHAR local "CHAR";
    WORD local "WORD";
    DWORD local "DWORD";
    LWORD local "LWORD";
    SINT local "SINT";
    INT local "INT";
    DINT local "DINT";
    LINT local "LINT";
    USINT local "USINT";
    UINT local "UINT";
    UDINT local "UDINT";
    ULINT local "ULINT";
    REAL local "REAL";
    LREAL local "LREAL";
    STRING local "STRING";
    WSTRING local "WSTRING";
    DATA_TYPE_REF global "dataTypeIDRef" (uniqueIDRef*: Kind::Reference(Target::DataType));

    APPLICATION_PROCESS global "ApplicationProcess", [
        maybe DATA_TYPE_LIST,
        maybe FUNCTION_TYPE_LIST,
        maybe FUNCTION_INSTANCE_LIST,
        maybe TEMPLATE_LIST,
        one PARAMETER_LIST,
        maybe PARAMETER_GROUP_LIST,
    ];

    DATA_TYPE_LIST global "dataTypeList", [some [ARRAY | STRUCT | ENUM | DERIVED]];
    ARRAY global "array" (name!: Kind::Text, uniqueID*: Kind::Id), [
        any (LABELS), some SUBRANGE, one (TYPES),
    ];
    SUBRANGE global "subrange" (lowerLimit*: Kind::LONG, upperLimit*: Kind::LONG);
    STRUCT global "struct" (name!: Kind::Text, uniqueID*: Kind::Id), [any (LABELS), some VAR_DECLARATION];
    ENUM global "enum" (name!: Kind::Text, uniqueID*: Kind::Id, size?: Kind::Text), [
        any (LABELS), some ENUM_VALUE, maybe (SIMPLE_TYPES),
    ];
    ENUM_VALUE global "enumValue" (value?: Kind::Text), [some (LABELS)];
    DERIVED global "derived" (name!: Kind::Text, uniqueID*: Kind::Id), [
        any (LABELS), maybe COUNT, one (TYPES),
    ];
    COUNT global "count" (uniqueID*: Kind::Id, access?: COUNT_ACCESS), [
        any (LABELS), one DEFAULT_VALUE, maybe ALLOWED_VALUES,
    ];
    VAR_DECLARATION global "varDeclaration" (
        name!: Kind::Text,
        uniqueID*: Kind::Id,
        start?: Kind::Text,
        size?: Kind::Text,
        signed?: Kind::Boolean,
        offset?: Kind::Decimal,
        multiplier?: Kind::Decimal,
        initialValue?: Kind::Text,
    ), [
        any (LABELS),
        one (TYPES),
        any CONDITIONAL_SUPPORT,
        maybe DEFAULT_VALUE,
        maybe ALLOWED_VALUES,
        maybe UNIT,
    ], newer [
        "start", "signed", "offset", "multiplier", "conditionalSupport", "defaultValue", "allowedValues", "unit"
    ];

    FUNCTION_TYPE_LIST global "functionTypeList", [some FUNCTION_TYPE];
    FUNCTION_TYPE global "functionType" (name!: Kind::Text, uniqueID*: Kind::Id, package?: Kind::Text), [
        any (LABELS), some VERSION_INFO, one INTERFACE_LIST, maybe FUNCTION_INSTANCE_LIST,
    ];
    VERSION_INFO global "versionInfo" (
        organization!: Kind::Text, version!: Kind::Text, author!: Kind::Text, date!: Kind::Date,
    ), [any (LABELS)];
    INTERFACE_LIST global "interfaceList", [maybe INPUT_VARS, maybe OUTPUT_VARS, maybe CONFIG_VARS];
    INPUT_VARS global "inputVars", [some VAR_DECLARATION];
    OUTPUT_VARS global "outputVars", [some VAR_DECLARATION];
    CONFIG_VARS global "configVars", [some VAR_DECLARATION];
    FUNCTION_INSTANCE_LIST global "functionInstanceList", [some FUNCTION_INSTANCE, any CONNECTION];
    FUNCTION_INSTANCE global "functionInstance" (
        name!: Kind::Text, uniqueID*: Kind::Id, typeIDRef*: Kind::Reference(Target::FunctionType),
    ), [any (LABELS)];
    CONNECTION global "connection" (source*: Kind::Text, destination*: Kind::Text, description?: Kind::Text);

    TEMPLATE_LIST global "templateList", [any PARAMETER_TEMPLATE, any ALLOWED_VALUES_TEMPLATE];
    PARAMETER_TEMPLATE global "parameterTemplate" (
        uniqueID*: Kind::Id,
        access?: ACCESS,
        accessList?: Kind::Names,
        support?: SUPPORT,
        persistent?: Kind::Boolean,
        offset?: Kind::Decimal,
        multiplier?: Kind::Decimal,
        templateIDRef?: Kind::Reference(Target::ParameterTemplate),
    ), [
        maybe (TYPES),
        any CONDITIONAL_SUPPORT,
        maybe ACTUAL_VALUE,
        maybe DEFAULT_VALUE,
        maybe SUBSTITUTE_VALUE,
        maybe ALLOWED_VALUES,
        maybe UNIT,
        any PROPERTY,
    ];
    ALLOWED_VALUES_TEMPLATE global "allowedValuesTemplate" (uniqueID*: Kind::Id), [any VALUE, any RANGE];

    PARAMETER_LIST global "parameterList", [some PARAMETER];
    PARAMETER global "parameter" (
        uniqueID*: Kind::Id,
        access?: ACCESS,
        accessList?: Kind::Names,
        support?: SUPPORT,
        persistent?: Kind::Boolean,
        offset?: Kind::Decimal,
        multiplier?: Kind::Decimal,
        templateIDRef?: Kind::Reference(Target::ParameterTemplate),
    ), [
        some (LABELS),
        one (PARAMETER_TYPES),
        any CONDITIONAL_SUPPORT,
        maybe DENOTATION,
        maybe ACTUAL_VALUE,
        maybe DEFAULT_VALUE,
        maybe SUBSTITUTE_VALUE,
        maybe ALLOWED_VALUES,
        maybe UNIT,
        any PROPERTY,
    ];
    VARIABLE_REF global "variableRef" (position?: Kind::BYTE), [
        some INSTANCE_REF, one VARIABLE_ID_REF, any MEMBER_REF,
    ];
    INSTANCE_REF global "instanceIDRef" (uniqueIDRef*: Kind::Reference(Target::FunctionInstance));
    VARIABLE_ID_REF global "variableIDRef" (uniqueIDRef*: Kind::Reference(Target::Variable));
    MEMBER_REF global "memberRef" (uniqueIDRef?: Kind::Reference(Target::Variable), index?: Kind::LONG);
    CONDITIONAL_SUPPORT global "conditionalSupport" (paramIDRef*: Kind::Reference(Target::Parameter));
    DENOTATION global "denotation", [some (LABELS)];
    ACTUAL_VALUE global "actualValue" (
        value*: Kind::Text, offset?: Kind::Decimal, multiplier?: Kind::Decimal,
    ), [any (LABELS)];
    DEFAULT_VALUE global "defaultValue" (
        value*: Kind::Text, offset?: Kind::Decimal, multiplier?: Kind::Decimal,
    ), [any (LABELS)];
    SUBSTITUTE_VALUE global "substituteValue" (
        value*: Kind::Text, offset?: Kind::Decimal, multiplier?: Kind::Decimal,
    ), [any (LABELS)];
    ALLOWED_VALUES global "allowedValues" (
        templateIDRef?: Kind::Reference(Target::AllowedValuesTemplate),
    ), [any VALUE, any RANGE];
    VALUE global "value" (
        value*: Kind::Text, offset?: Kind::Decimal, multiplier?: Kind::Decimal,
    ), [any (LABELS)];
    RANGE global "range", [one MIN_VALUE, one MAX_VALUE, maybe STEP];
    MIN_VALUE local "minValue" (
        value*: Kind::Text, offset?: Kind::Decimal, multiplier?: Kind::Decimal,
    ), [any (LABELS)];
    MAX_VALUE local "maxValue" (
        value*: Kind::Text, offset?: Kind::Decimal, multiplier?: Kind::Decimal,
    ), [any (LABELS)];
    STEP local "step" (
        value*: Kind::Text, offset?: Kind::Decimal, multiplier?: Kind::Decimal,
    ), [any (LABELS)];
    UNIT global "unit" (multiplier!: Kind::Text, unitURI?: Kind::Text), [some (LABELS)];
    PROPERTY global "property" (name*: Kind::Text, value!: Kind::Text);

    PARAMETER_GROUP_LIST global "parameterGroupList", [some PARAMETER_GROUP];
    PARAMETER_GROUP global "parameterGroup" (uniqueID*: Kind::Id, kindOfAccess?: Kind::Text), [
        some (LABELS), any PARAMETER_GROUP, any PARAMETER_REF,
    ];
    PARAMETER_REF global "parameterRef" (uniqueIDRef*: Kind::Reference(Target::Parameter));
}
