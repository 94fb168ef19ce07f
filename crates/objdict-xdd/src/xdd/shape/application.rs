//! The application process: functions, and the lists of everything else.

use super::{ChildField, Leftovers, Markup, Shape};
use crate::model::{
    ApplicationProcess, Connection, FunctionInstance, FunctionInstances, FunctionType, Parameter, VersionInfo,
};
use crate::xml::{Element, ElementId};

/// Lists the parts of an application process once, for reading (`take`) and writing (`put`).
macro_rules! application_process {
    ($direction:ident, $process:expr, $parameters:expr, $($context:expr),+) => {
        let ApplicationProcess {
            data_types, function_types, functions, parameter_templates, allowed_values_templates, groups,
            parameters: _,
        } = $process;
        let parameters = $parameters;
        $direction!($($context),+, [] {
            "dataTypeList" => { _ => data_types },
            "functionTypeList" => { "functionType" => function_types },
            "functionInstanceList" => functions,
            "templateList" => {
                "parameterTemplate" => parameter_templates,
                "allowedValuesTemplate" => allowed_values_templates,
            },
            "parameterList" => [ "parameter" => parameters ],
            "parameterGroupList" => { "parameterGroup" => groups },
        });
    };
}

impl Shape for ApplicationProcess {
    fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Self {
        let (mut read, parameters) = read_application_process(element, leftovers);
        read.parameters =
            parameters.into_iter().map(|parameter| Parameter::read(parameter, leftovers)).collect();
        read
    }

    fn write(&self, name: &str, out: &mut Markup) {
        application_process!(put, self, &self.parameters, out, name);
    }
}

/// What an application process says, and where its parameters stand: there are thousands, most belong to entries of the
/// dictionary, and whoever reads those reads them one by one.
pub(crate) fn read_application_process<'a>(
    element: Element<'a>,
    leftovers: &mut Leftovers<'a>,
) -> (ApplicationProcess, Vec<Element<'a>>) {
    let mut read = ApplicationProcess::default();
    let mut found = Elements::default();
    application_process!(take, &mut read, &mut found, element, leftovers);
    (read, found.0.into_iter().map(|id| element.tree().element(id)).collect())
}

/// Elements that are read later.
#[derive(Default)]
struct Elements(Vec<ElementId>);

impl ChildField for Elements {
    fn accept<'a>(&mut self, child: Element<'a>, _: &mut Leftovers<'a>) -> bool {
        self.0.push(child.id());
        true
    }

    /// There is nothing to write: what they say is elsewhere.
    fn write(&self, _: &str, _: &mut Markup) {}
}

shape! {
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
