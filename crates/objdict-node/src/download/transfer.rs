//! Encoding of values for a transfer.

use std::borrow::Cow;
use std::cmp::Ordering;

use super::ProblemKind;
use crate::literal::{self, Quirks};
use crate::model::{DataType, Device, Entry, Object, ObjectType, TypeKind, Value};

/// The data type of an entry.
#[derive(Clone, Copy, Debug)]
pub(super) struct EntryType {
    /// The type stated in the description.
    stated: Option<DataType>,
    /// The static type that determines the encoding; `None` if unknown.
    pub(super) transferred: Option<DataType>,
}

impl EntryType {
    /// The type of an entry; if not stated, the type implied by its place.
    pub(super) fn of(device: &Device, object: &Object, (index, sub): (u16, u8), entry: &Entry) -> Self {
        let has_subs = object.object_type().has_subs();
        let transferred = match entry.data_type {
            Some(data_type) if data_type.kind() == TypeKind::Defined => own_type(device, data_type),
            Some(data_type) => Some(data_type),
            None if has_subs && sub == 0 => DataType::of_sub_0(index),
            None if has_subs && sub == 0xFF => Some(DataType::UNSIGNED32),
            None => entry.implied_type(),
        };
        Self { stated: entry.data_type, transferred }
    }

    /// Encodes a value for a node.
    pub(super) fn bytes(self, value: &Value, node_id: Option<u8>) -> Result<Vec<u8>, ProblemKind> {
        let unknown = || ProblemKind::UnknownType { value: value.clone(), data_type: self.stated };
        let data_type = self.transferred.ok_or_else(unknown)?;
        let invalid = || ProblemKind::NotOfType { value: value.clone(), data_type };
        let typed = match (value, node_id) {
            (Value::Raw(text), _) => Cow::Owned(number_of_own_type(text, data_type).ok_or_else(unknown)?),
            (Value::NodeId(_), None) => return Err(ProblemKind::NeedsNodeId(value.clone())),
            (Value::NodeId(_), Some(node_id)) => {
                Cow::Owned(value.resolve(data_type, node_id).ok_or_else(invalid)?)
            }
            _ => Cow::Borrowed(value),
        };
        // a value created by code may exceed its type and would wrap
        let fits = typed
            .as_integer()
            .is_none_or(|number| Value::from_integer(number, data_type).as_ref() == Some(&*typed));
        typed.to_bytes(data_type).filter(|_| fits).ok_or_else(invalid)
    }
}

/// The static data type used to transfer an entry: its own type, or the base type of a device-specific type.
/// `None` if unknown.
pub fn transferred_type(device: &Device, index: u16, sub: u8) -> Option<DataType> {
    let object = device.object(index)?;
    let entry = object.entry(sub)?;
    EntryType::of(device, object, (index, sub), &entry).transferred
}

/// Encodes a value for a transfer to the node `node_id`.
///
/// # Errors
/// If the value does not fit the data type, the data type is unknown, or the node-ID is missing.
pub fn bytes_of(
    device: &Device,
    index: u16,
    sub: u8,
    value: &Value,
    node_id: Option<u8>,
) -> Result<Vec<u8>, ProblemKind> {
    let unknown = || ProblemKind::UnknownType { value: value.clone(), data_type: None };
    let object = device.object(index).ok_or_else(unknown)?;
    let entry = object.entry(sub).ok_or_else(unknown)?;
    EntryType::of(device, object, (index, sub), &entry).bytes(value, node_id)
}

/// The static type of a simple device-specific type. A DEFTYPE object states its number of bits (CiA 301
/// §7.4.7.2); CanFestival instead writes the base type in sub-index 1.
fn own_type(device: &Device, data_type: DataType) -> Option<DataType> {
    let definition =
        device.object(data_type.0).filter(|object| object.object_type() != ObjectType::DefStruct)?;
    let number = |sub| definition.entry(sub).and_then(|entry| entry.value()?.as_integer());
    if definition.object_type().has_subs() || !definition.subs.is_empty() {
        let narrowed = u16::try_from(number(1)?).ok().map(DataType);
        return narrowed.filter(|narrowed| narrowed.byte_length().is_some());
    }
    let bits = u8::try_from(number(0)?).ok()?;
    let of_length = |data_type: &&DataType| data_type.kind() == TypeKind::Unsigned(bits);
    match bits {
        1 => Some(DataType::BOOLEAN),
        _ => DataType::STATIC.iter().find(of_length).copied(),
    }
}

/// Parses a number of a device-specific type.
fn number_of_own_type(text: &str, data_type: DataType) -> Option<Value> {
    let number = literal::integer_in_line(text, i64::MIN, u64::MAX, &mut Quirks::default());
    Value::from_integer(number.ok()?, data_type)
}

/// A limit that a value violates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// Below `LowLimit`.
    Low(Value),
    /// Above `HighLimit`.
    High(Value),
}

/// The limit that a value violates on a node. Limits that cannot be compared are ignored, and so are contradictory
/// ones, where the low limit exceeds the high one.
pub fn beyond(entry: &Entry, value: &Value, node_id: Option<u8>) -> Option<Beyond> {
    let limits = entry.low_limit.as_ref().zip(entry.high_limit.as_ref());
    if limits.is_some_and(|(low, high)| compare(low, high, node_id) == Some(Ordering::Greater)) {
        return None;
    }
    let against = |limit: &Option<Value>, wrong: Ordering| {
        limit.as_ref().filter(|limit| compare(value, limit, node_id) == Some(wrong)).cloned()
    };
    against(&entry.low_limit, Ordering::Less)
        .map(Beyond::Low)
        .or_else(|| against(&entry.high_limit, Ordering::Greater).map(Beyond::High))
}

fn compare(value: &Value, limit: &Value, node_id: Option<u8>) -> Option<Ordering> {
    let integer = |value: &Value| match node_id {
        Some(node_id) => value.integer_for(node_id),
        None => value.as_integer(),
    };
    match (integer(value), integer(limit)) {
        (Some(value), Some(limit)) => Some(value.cmp(&limit)),
        _ => value.as_real()?.partial_cmp(&limit.as_real()?),
    }
}
