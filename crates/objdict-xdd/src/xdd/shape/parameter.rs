//! Parameters, their values and their groups.

use super::{Leftovers, Markup, Shape};
use crate::model::{
    AllowedValues, AllowedValuesTemplate, Parameter, ParameterGroup, ParameterTemplate, Property,
    ScaledValue, Unit, ValueRange,
};
use crate::xml::Element;

shape! {
    Parameter [
        "uniqueID" = unique_id, "access" = access, "accessList" = access_list, "support" = support,
        "persistent" = persistent, "offset" = offset, "multiplier" = multiplier, "templateIDRef" = template,
    ] {
        _ => labels,
        _ => data_type,
        "conditionalSupport" @ "paramIDRef" => conditional_support,
        "denotation" => denotation,
        "actualValue" => actual_value,
        "defaultValue" => default_value,
        "substituteValue" => substitute_value,
        "allowedValues" => allowed_values,
        "unit" => unit,
        "property" => properties,
    }

    ScaledValue ["value" = value, "offset" = offset, "multiplier" = multiplier] { _ => labels }

    AllowedValues ["templateIDRef" = template] { "value" => values, "range" => ranges }

    ValueRange [] { "minValue" => min, "maxValue" => max, "step" => step }

    Unit ["multiplier" = multiplier, "unitURI" = uri] { _ => labels }

    Property ["name" = name, "value" = value] {}

    ParameterGroup ["uniqueID" = unique_id, "kindOfAccess" = kind_of_access] {
        _ => labels,
        "parameterGroup" => groups,
        "parameterRef" @ "uniqueIDRef" => parameters,
    }
}

/// A parameter under another name.
impl Shape for ParameterTemplate {
    fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Self {
        Self { parameter: Parameter::read(element, leftovers) }
    }

    fn write(&self, name: &str, out: &mut Markup) {
        Shape::write(&self.parameter, name, out);
    }
}

/// `allowedValues` with an id.
impl Shape for AllowedValuesTemplate {
    fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Self {
        let mut read = Self::default();
        let Self { unique_id, allowed: AllowedValues { template, values, ranges } } = &mut read;
        take!(element, leftovers, ["uniqueID" = unique_id, "templateIDRef" = template] {
            "value" => values, "range" => ranges,
        });
        read
    }

    fn write(&self, name: &str, out: &mut Markup) {
        let Self { unique_id, allowed: AllowedValues { template, values, ranges } } = self;
        put!(out, name, ["uniqueID" = unique_id, "templateIDRef" = template] {
            "value" => values, "range" => ranges,
        });
    }
}
