//! The types that the writer generates for objects without one. The reader drops them again.

use super::defaults;
use crate::model::{
    DataType, DataTypeRef, Entry, Object, ObjectType, Parameter, Property, SimpleType, Subrange,
    TypeDefinition, TypeKind, TypeShape, VarDeclaration,
};

/// The simple type that is nearest to a data type; the attribute `dataType` specifies the exact one.
pub(crate) fn simple_type(data_type: DataType) -> SimpleType {
    match data_type.kind() {
        TypeKind::Boolean => SimpleType::Bool,
        TypeKind::Signed(bits) => match bits {
            0..=8 => SimpleType::Sint,
            9..=16 => SimpleType::Int,
            17..=32 => SimpleType::Dint,
            _ => SimpleType::Lint,
        },
        TypeKind::Unsigned(bits) => match bits {
            0..=8 => SimpleType::Usint,
            9..=16 => SimpleType::Uint,
            17..=32 => SimpleType::Udint,
            _ => SimpleType::Ulint,
        },
        TypeKind::Real32 => SimpleType::Real,
        TypeKind::Real64 => SimpleType::Lreal,
        TypeKind::VisibleString => SimpleType::String,
        TypeKind::UnicodeString => SimpleType::Wstring,
        _ => SimpleType::Bitstring,
    }
}

/// The data type of a simple type, as CANopenEditor interprets it; BITSTRING depends on the object type.
pub(crate) fn data_type(simple: SimpleType, object_type: Option<ObjectType>) -> DataType {
    match simple {
        SimpleType::Bool => DataType::BOOLEAN,
        SimpleType::Sint => DataType::INTEGER8,
        SimpleType::Int => DataType::INTEGER16,
        SimpleType::Dint => DataType::INTEGER32,
        SimpleType::Lint => DataType::INTEGER64,
        SimpleType::Usint | SimpleType::Byte => DataType::UNSIGNED8,
        SimpleType::Uint | SimpleType::Word => DataType::UNSIGNED16,
        SimpleType::Udint | SimpleType::Dword => DataType::UNSIGNED32,
        SimpleType::Ulint | SimpleType::Lword => DataType::UNSIGNED64,
        SimpleType::Real => DataType::REAL32,
        SimpleType::Lreal => DataType::REAL64,
        SimpleType::String | SimpleType::Char => DataType::VISIBLE_STRING,
        SimpleType::Wstring => DataType::UNICODE_STRING,
        SimpleType::Bitstring if object_type == Some(ObjectType::Domain) => DataType::DOMAIN,
        SimpleType::Bitstring => DataType::OCTET_STRING,
    }
}

/// The index of the object that a type belongs to, by its id.
pub(crate) fn index_of(id: &str) -> Option<u16> {
    let digits = id.strip_prefix("UID_ARR_").or_else(|| id.strip_prefix("UID_REC_"))?;
    if digits.len() == 4 { u16::from_str_radix(digits, 16).ok() } else { None }
}

/// A parameter with a type, which the standard requires: without one a placeholder.
pub(crate) fn with_type(mut parameter: Parameter) -> Parameter {
    if parameter.data_type.is_none() {
        parameter.data_type = Some(DataTypeRef::Simple(SimpleType::Bitstring));
        let (name, value) = (defaults::TYPE_PROPERTY.into(), defaults::NOT_STATED.into());
        parameter.properties.push(Property { name, value });
    }
    parameter
}

/// Removes the placeholder for the type.
pub(crate) fn without_placeholder(mut parameter: Parameter) -> Parameter {
    let count = parameter.properties.len();
    parameter.properties.retain(|property| {
        &*property.name != defaults::TYPE_PROPERTY || &*property.value != defaults::NOT_STATED
    });
    if parameter.properties.len() < count {
        parameter.data_type = None;
    }
    parameter
}

/// The type of an ARRAY or RECORD, composed from the types of its sub-indexes as in CANopenEditor; `None` if
/// one of them has none.
pub(crate) fn definition_of(index: u16, object: &Object) -> Option<TypeDefinition> {
    let simple = |data_type: Option<DataType>| data_type.map(simple_type).map(DataTypeRef::Simple);
    let highest = object.highest_sub()?;
    if object.object_type() == ObjectType::Array {
        let element = object.subs.iter().find(|(sub, _)| *sub > 0)?.1.data_type;
        let range = Subrange { low: "0".into(), high: highest.to_string().into() };
        return Some(TypeDefinition {
            name: object.main.name.clone(),
            unique_id: format!("UID_ARR_{index:04X}").into(),
            shape: TypeShape::Array { ranges: vec![range], element: Some(simple(element)?) },
            ..TypeDefinition::default()
        });
    }
    let member = |(sub, entry): (u8, &Entry)| {
        Some(VarDeclaration {
            name: entry.name.clone(),
            unique_id: format!("UID_RECSUB_{index:04X}{sub:02X}").into(),
            data_type: Some(simple(entry.data_type)?),
            ..VarDeclaration::default()
        })
    };
    Some(TypeDefinition {
        name: object.main.name.clone(),
        unique_id: format!("UID_REC_{index:04X}").into(),
        shape: TypeShape::Struct { members: object.subs.iter().map(member).collect::<Option<_>>()? },
        ..TypeDefinition::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_simple_type_comes_back_from_every_data_type_that_has_its_width() {
        for &simple in SimpleType::ALL {
            let data_type = data_type(simple, None);
            assert_eq!(super::data_type(simple_type(data_type), None), data_type);
        }
        assert_eq!(data_type(simple_type(DataType::DOMAIN), Some(ObjectType::Domain)), DataType::DOMAIN);
        assert_eq!(simple_type(DataType::INTEGER24), SimpleType::Dint);
        assert_eq!(simple_type(DataType::UNSIGNED56), SimpleType::Ulint);
        assert_eq!(simple_type(DataType::TIME_OF_DAY), SimpleType::Bitstring);
    }
}
