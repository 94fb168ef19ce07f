//! The application process: functions, and the lists of everything else.

use crate::model::{
    ApplicationProcess, Connection, FunctionInstance, FunctionInstances, FunctionType, VersionInfo,
};

shape! {
    ApplicationProcess [] {
        "dataTypeList" => { _ => data_types },
        "functionTypeList" => { "functionType" => function_types },
        "functionInstanceList" => functions,
        "templateList" => {
            "parameterTemplate" => parameter_templates,
            "allowedValuesTemplate" => allowed_values_templates,
        },
        "parameterList" => [ "parameter" => parameters ],
        "parameterGroupList" => { "parameterGroup" => groups },
    }

    FunctionType ["name" = name, "uniqueID" = unique_id, "package" = package] {
        _ => labels,
        "versionInfo" => versions,
        "interfaceList" => [
            "inputVars" => { "varDeclaration" => inputs },
            "outputVars" => { "varDeclaration" => outputs },
            "configVars" => { "varDeclaration" => configuration },
        ],
        "functionInstanceList" => functions,
    }

    VersionInfo [
        "organization" = organization, "version" = version, "author" = author, "date" = date,
    ] { _ => labels }

    FunctionInstances [] { "functionInstance" => instances, "connection" => connections }

    FunctionInstance ["name" = name, "uniqueID" = unique_id, "typeIDRef" = function_type] { _ => labels }

    Connection ["source" = source, "destination" = destination, "description" = description] {}
}
