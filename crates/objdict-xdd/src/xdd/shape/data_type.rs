//! Data types: those of IEC 61131-3 and those that the description defines.

use super::{ChildField, Group, Leftovers, Markup, ValueField, read_attributes, read_children};
use crate::model::{
    Count, DataTypeRef, EnumValue, MemberRef, SimpleType, Subrange, TypeDefinition, TypeShape,
    VarDeclaration, VariableRef,
};
use crate::xml::Element;

variants! {
    TypeDefinition {
        "array" => (TypeDefinition { name, unique_id, labels, shape: TypeShape::Array { ranges, element } })
            ["name" = name, "uniqueID" = unique_id] { _ => labels, "subrange" => ranges, _ => element }
        "struct" => (TypeDefinition { name, unique_id, labels, shape: TypeShape::Struct { members } })
            ["name" = name, "uniqueID" = unique_id] { _ => labels, "varDeclaration" => members }
        "enum" => (TypeDefinition { name, unique_id, labels, shape: TypeShape::Enum { size, values, base } })
            ["name" = name, "uniqueID" = unique_id, "size" = size] { _ => labels, "enumValue" => values, _ => base }
        "derived" => (TypeDefinition { name, unique_id, labels, shape: TypeShape::Derived { count, base } })
            ["name" = name, "uniqueID" = unique_id] { _ => labels, "count" => count, _ => base }
    }
}

shape! {
    Subrange ["lowerLimit" = low, "upperLimit" = high] {}

    EnumValue ["value" = value] { _ => labels }

    Count ["uniqueID" = unique_id, "access" = access] {
        _ => labels,
        "defaultValue" => default_value,
        "allowedValues" => allowed_values,
    }

    VarDeclaration [
        "name" = name, "uniqueID" = unique_id, "start" = start, "size" = size, "signed" = signed,
        "offset" = offset, "multiplier" = multiplier, "initialValue" = initial_value,
    ] {
        _ => labels,
        _ => data_type,
        "conditionalSupport" @ "paramIDRef" => conditional_support,
        "defaultValue" => default_value,
        "allowedValues" => allowed_values,
        "unit" => unit,
    }

    VariableRef ["position" = position] {
        "instanceIDRef" @ "uniqueIDRef" => instances,
        "variableIDRef" @ "uniqueIDRef" => variable,
        "memberRef" => members,
    }

    MemberRef ["uniqueIDRef" = unique_id, "index" = index] {}
}

/// An element such as `UDINT`, which has nothing in it.
impl Group for Option<SimpleType> {
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool {
        let Some(simple) = SimpleType::from_name(child.name()).filter(|_| self.is_none()) else {
            return false;
        };
        *self = Some(simple);
        read_attributes(child, leftovers, |_, _| false);
        read_children(child, leftovers, |_, _| false);
        true
    }

    fn write(&self, out: &mut Markup) {
        if let Some(simple) = self {
            out.open(simple.name());
            out.close();
        }
    }
}

/// An element such as `UDINT`, a `dataTypeIDRef`, or several `variableRef`.
impl Group for Option<DataTypeRef> {
    fn accept<'a>(&mut self, child: Element<'a>, leftovers: &mut Leftovers<'a>) -> bool {
        match (&mut *self, child.name()) {
            (Some(DataTypeRef::Variables(variables)), "variableRef") => {
                return ChildField::accept(variables, child, leftovers);
            }
            (Some(_), _) => return false,
            (None, "variableRef") => {
                let mut variables = Vec::new();
                ChildField::accept(&mut variables, child, leftovers);
                *self = Some(DataTypeRef::Variables(variables));
            }
            (None, "dataTypeIDRef") => {
                let mut id = Box::<str>::default();
                ValueField::accept(&mut id, child, "uniqueIDRef", leftovers);
                *self = Some(DataTypeRef::Defined(id));
            }
            (None, _) => {
                let mut simple = None::<SimpleType>;
                simple.accept(child, leftovers);
                *self = simple.map(DataTypeRef::Simple);
            }
        }
        self.is_some()
    }

    fn write(&self, out: &mut Markup) {
        match self {
            None => {}
            Some(DataTypeRef::Simple(simple)) => Some(*simple).write(out),
            Some(DataTypeRef::Defined(id)) => ValueField::write(id, "dataTypeIDRef", "uniqueIDRef", out),
            Some(DataTypeRef::Variables(variables)) => ChildField::write(variables, "variableRef", out),
        }
    }
}
