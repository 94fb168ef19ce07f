//! Unambiguous properties of a description. A rule that uses them reports nothing if a more basic rule has a
//! finding.

use std::cmp::Ordering;

use crate::model::{Device, Entry, Field, Object, ObjectType, Place, TypeKind, Value};

/// The object type; VAR if it is missing. `None` if the text of `ObjectType` or `CompactSubObj` is not a
/// valid value, if the object has no section of its own, or if `ObjectType` is missing although the
/// object has sub-indexes.
pub(crate) fn object_type(object: &Object) -> Option<ObjectType> {
    let invalid_values = &object.main.invalid_values;
    let unreadable = !invalid_values.is_empty()
        && (invalid_values.get(&Field::ObjectType).is_some()
            || invalid_values.get(&Field::CompactSubObj).is_some());
    if object.orphan || unreadable {
        return None;
    }
    match object.main.object_type {
        None if is_structured(object) => None,
        None => Some(ObjectType::Var),
        stated => stated,
    }
}

/// Whether an object has or states sub-indexes, regardless of its object type.
pub(crate) fn is_structured(object: &Object) -> bool {
    !object.subs.is_empty() || object.compact.is_some() || object.sub_number.is_some_and(|number| number > 0)
}

/// Whether the device has an object: described, or only listed, which another rule reports.
pub(crate) fn is_there(device: &Device, index: u16) -> bool {
    device.objects.contains_key(&index) || device.lists.contains(index)
}

/// Whether the text of a field is not a valid value, which `cia306/invalid-value` reports.
pub(crate) fn is_invalid(entry: &Entry, field: &Field) -> bool {
    !entry.invalid_values.is_empty() && entry.invalid_values.get(field).is_some()
}

/// The number of described sub-indexes according to `SubNumber`: without FFh.
pub(crate) fn described_subs(object: &Object) -> usize {
    object.subs.len() - usize::from(object.subs.get(0xFF).is_some())
}

/// The node-IDs for which formulas are evaluated: the node's, otherwise the lowest and the highest.
pub(crate) fn node_ids(device: &Device) -> [u8; 2] {
    device.node_id().map_or([1, 127], |node_id| [node_id, node_id])
}

/// Compares two numbers for the node `node_id`; REAL values in the precision of the type. `None` if one is
/// not a number.
pub(crate) fn compare(left: &Value, right: &Value, node_id: u8) -> Option<Ordering> {
    match (left, right) {
        (Value::Unsigned(left), Value::Unsigned(right)) => Some(left.cmp(right)),
        (Value::Signed(left), Value::Signed(right)) => Some(left.cmp(right)),
        (Value::Real32(left), Value::Real32(right)) => left.partial_cmp(right),
        (Value::Real64(left), Value::Real64(right)) => left.partial_cmp(right),
        _ => Some(left.integer_for(node_id)?.cmp(&right.integer_for(node_id)?)),
    }
}

/// The first of the node-IDs for which comparing two numbers results in `order`; only formulas depend
/// on the node-ID.
pub(crate) fn first_node(left: &Value, right: &Value, order: Ordering, node_ids: [u8; 2]) -> Option<u8> {
    let [first, last] = node_ids;
    let holds = |node_id| compare(left, right, node_id) == Some(order);
    if holds(first) {
        return Some(first);
    }
    let is_formula = matches!(left, Value::NodeId(_)) || matches!(right, Value::NodeId(_));
    (is_formula && holds(last)).then_some(last)
}

/// Whether sub-index 0 does not count all sub-indexes, or counts only those in use: the error history, the
/// number of PDOs of version 3, mappings of PDOs and SRDOs, the lists of multiplexed PDOs (CiA 301 §7.5.2,
/// EN 50325-5).
pub(crate) fn counts_otherwise(index: u16) -> bool {
    matches!(index, 0x1003 | 0x1004 | 0x1381..=0x13C0 | 0x1600..=0x17FF | 0x1A00..=0x1BFF | 0x1FA0..=0x1FFF)
}

/// Whether values of the type have variable length or a structure, so that they cannot be mapped to a PDO.
pub(crate) fn is_unmappable(kind: TypeKind) -> bool {
    matches!(
        kind,
        TypeKind::VisibleString
            | TypeKind::OctetString
            | TypeKind::UnicodeString
            | TypeKind::Domain
            | TypeKind::Structure
    )
}

/// The first value that depends on the node-ID.
pub(crate) fn first_formula(device: &Device) -> Option<Place> {
    device.objects.iter().find_map(|(&index, object)| {
        object.described().find_map(|(sub, entry)| {
            let is_formula = matches!(entry.value(), Some(Value::NodeId(_)));
            let field =
                if entry.configured_value().is_some() { Field::ParameterValue } else { Field::DefaultValue };
            let place = Place::at(index, sub);
            is_formula.then(|| place.field(field))
        })
    })
}

/// Each entry of the objects of the device itself, with its place.
#[cfg(feature = "catalogue")]
pub(crate) fn entries(device: &Device) -> impl Iterator<Item = (Place, &Entry)> {
    device.objects.iter().flat_map(|(&index, object)| {
        object.described().map(move |(sub, entry)| (Place::at(index, sub), entry))
    })
}
