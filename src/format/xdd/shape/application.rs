//! The application process: functions, and the lists of everything else.

use super::{Markup, Shape};
use crate::model::{
    ApplicationProcess, Connection, FunctionInstance, FunctionInstances, FunctionType, Parameter, VersionInfo,
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

/// Writes an application process with other parameters than its own: those that are given, in their order.
pub(crate) fn write_application_process(
    process: &ApplicationProcess,
    parameters: impl IntoIterator<Item = Parameter>,
    out: &mut Markup,
) {
    let whole = ApplicationProcess {
        data_types: process.data_types.clone(),
        function_types: process.function_types.clone(),
        functions: process.functions.clone(),
        parameter_templates: process.parameter_templates.clone(),
        allowed_values_templates: process.allowed_values_templates.clone(),
        parameters: parameters.into_iter().collect(),
        groups: process.groups.clone(),
    };
    Shape::write(&whole, "ApplicationProcess", out);
}
