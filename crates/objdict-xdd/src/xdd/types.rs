//! The types that the writer generates for objects without one. The reader drops them again.

use super::defaults;
use crate::model::{
    DataType, DataTypeRef, Entry, Object, ObjectType, Parameter, Property, SimpleType, Subrange,
    TypeDefinition, TypeKind, TypeShape, VarDeclaration,
};

/// The data types with simple types that may denote their values: the nearest one first. CANopenEditor converts a
/// simple type to the first data type in its row.
const SIMPLE_TYPES: [(DataType, &[SimpleType]); 13] = [
    (DataType::BOOLEAN, &[SimpleType::Bool]),
    (DataType::REAL32, &[SimpleType::Real]),
    (DataType::REAL64, &[SimpleType::Lreal]),
    (DataType::VISIBLE_STRING, &[SimpleType::String, SimpleType::Char]),
    (DataType::UNICODE_STRING, &[SimpleType::Wstring, SimpleType::String]),
    (DataType::UNSIGNED8, &[SimpleType::Usint, SimpleType::Byte, SimpleType::Char]),
    (DataType::UNSIGNED16, &[SimpleType::Uint, SimpleType::Word]),
    (DataType::UNSIGNED32, &[SimpleType::Udint, SimpleType::Dword]),
    (DataType::UNSIGNED64, &[SimpleType::Ulint, SimpleType::Lword]),
    (DataType::INTEGER8, &[SimpleType::Sint, SimpleType::Byte]),
    (DataType::INTEGER16, &[SimpleType::Int, SimpleType::Word]),
    (DataType::INTEGER32, &[SimpleType::Dint, SimpleType::Dword]),
    (DataType::INTEGER64, &[SimpleType::Lint, SimpleType::Lword]),
];

/// The simple types that may denote values of a data type; `None` if the data type has no exact one.
fn simple_types(data_type: DataType) -> Option<&'static [SimpleType]> {
    SIMPLE_TYPES.iter().find(|(known, _)| *known == data_type).map(|(_, simple)| *simple)
}

/// The simple type that is nearest to a data type; the attribute `dataType` specifies the exact one.
pub(crate) fn simple_type(data_type: DataType) -> SimpleType {
    let is_wider = |(known, _): &&(DataType, _)| match (data_type.kind(), known.kind()) {
        (TypeKind::Signed(bits), TypeKind::Signed(width))
        | (TypeKind::Unsigned(bits), TypeKind::Unsigned(width)) => bits <= width,
        _ => false,
    };
    let wider = || SIMPLE_TYPES.iter().find(is_wider).map(|(_, simple)| *simple);
    simple_types(data_type).or_else(wider).map_or(SimpleType::Bitstring, |simple| simple[0])
}

/// Whether a simple type may denote values of a data type.
pub(crate) fn agree(data_type: DataType, simple: SimpleType) -> bool {
    simple == SimpleType::Bitstring || simple_types(data_type).is_none_or(|exact| exact.contains(&simple))
}

/// The data type of a simple type, as CANopenEditor interprets it; BITSTRING depends on the object type.
pub(crate) fn data_type(simple: SimpleType, object_type: Option<ObjectType>) -> DataType {
    match SIMPLE_TYPES.iter().find(|(_, known)| known.contains(&simple)) {
        Some((data_type, _)) => *data_type,
        None if object_type == Some(ObjectType::Domain) => DataType::DOMAIN,
        None => DataType::OCTET_STRING,
    }
}

/// The index of the object that a type belongs to, by its id.
pub(crate) fn index_of(id: &str) -> Option<u16> {
    let digits = id.strip_prefix("UID_ARR_").or_else(|| id.strip_prefix("UID_REC_"))?;
    if digits.len() == 4 { u16::from_str_radix(digits, 16).ok() } else { None }
}

/// A parameter with a type, which the standard requires; a placeholder if it has none.
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
        for simple in SimpleType::ALL {
            let data_type = data_type(simple, None);
            assert_eq!(super::data_type(simple_type(data_type), None), data_type);
        }
        assert_eq!(data_type(simple_type(DataType::DOMAIN), Some(ObjectType::Domain)), DataType::DOMAIN);
        assert_eq!(simple_type(DataType::INTEGER24), SimpleType::Dint);
        assert_eq!(simple_type(DataType::UNSIGNED56), SimpleType::Ulint);
        assert_eq!(simple_type(DataType::TIME_OF_DAY), SimpleType::Bitstring);
    }
}
