//! Completes a description with values that the standard defines.

use std::borrow::Cow;

use super::Note;
use super::notes::once_per_device;
use crate::literal::{self, Quirks};
use crate::model::{Access, DataType, Device, Entry, Field, Object, ObjectType, Place, Value};

/// A property that an entry lacks and the standard defines.
struct Gap {
    index: u16,
    /// `None` for the entry of the object itself.
    sub: Option<u8>,
    data_type: Option<DataType>,
    access: Option<Access>,
    value: Option<Value>,
}

/// The device completed with data types, access types and values from the documents for all devices, and a note for
/// each.
pub(crate) fn filled(device: &Device) -> (Cow<'_, Device>, Vec<Note>) {
    let gaps: Vec<Gap> =
        device.objects.iter().flat_map(|(&index, object)| gaps_of(device, index, object)).collect();
    if gaps.is_empty() {
        return (Cow::Borrowed(device), Vec::new());
    }
    let notes = gaps.iter().flat_map(Gap::notes).collect();
    let mut device = device.clone();
    for Gap { index, sub, data_type, access, value } in gaps {
        let Some(object) = device.objects.get_mut(&index) else { continue };
        let entry = sub.map_or(Some(&mut object.main), |sub| object.subs.get_mut(sub));
        if let Some(entry) = entry {
            entry.access = entry.access.or(access);
            entry.default = entry.default.take().or(value);
            data_type.into_iter().for_each(|data_type| set_type(entry, data_type));
        }
    }
    (Cow::Owned(device), once_per_device(notes))
}

fn gaps_of(device: &Device, index: u16, object: &Object) -> Vec<Gap> {
    let has_subs = object.object_type().has_subs();
    if matches!(object.object_type(), ObjectType::DefType | ObjectType::DefStruct) {
        return Vec::new();
    }
    // the object states the type of compact sub-objects, but not of others
    let has_value = object.compact.is_some() || !has_subs && object.subs.is_empty();
    let entries = object.described().filter(|(sub, _)| sub.is_some() || has_value);
    let gaps = entries.map(|(sub, entry)| {
        let lacks = |field, value: bool| !value && entry.invalid_values.get(&field).is_none();
        let is_count = has_subs && sub == Some(0); // whose type is known
        let lacks_type = !is_count && lacks(Field::DataType, entry.implied_type().is_some());
        let lacks_access = lacks(Field::AccessType, entry.implied_access().is_some());
        let data_type = lacks_type.then(|| objdict_profile::data_type(device, index, sub));
        let access = lacks_access.then(|| objdict_profile::access(device, index, sub));
        let (data_type, access) = (data_type.flatten(), access.flatten());
        let value = server_cob_id(index, sub).filter(|_| {
            let is_number = data_type.or(entry.implied_type()) == Some(DataType::UNSIGNED32);
            is_number && lacks(Field::DefaultValue, entry.value().is_some())
        });
        Gap { index, sub, data_type, access, value }
    });
    gaps.filter(|gap| gap.data_type.is_some() || gap.access.is_some() || gap.value.is_some()).collect()
}

/// The COB-ID of the default SDO server (CiA 301 §7.5.2.33). Without it, stacks serve CAN-ID 0: the node does
/// not respond to SDOs.
fn server_cob_id(index: u16, sub: Option<u8>) -> Option<Value> {
    match (index, sub) {
        (0x1200, Some(1)) => Some(Value::NodeId(0x600)),
        (0x1200, Some(2)) => Some(Value::NodeId(0x580)),
        _ => None,
    }
}

impl Gap {
    fn notes(&self) -> impl Iterator<Item = Note> {
        let place = Place::at(self.index, self.sub);
        let data_type = self.data_type.map(|data_type| {
            let text = format!("an entry without a data type; the standard has {data_type}");
            Note::new(place.clone().field(Field::DataType), text)
        });
        let access = self.access.map(|access| {
            let text = format!("an entry without an access type; the standard has `{access}`");
            Note::new(place.clone().field(Field::AccessType), text)
        });
        let value = self.value.as_ref().map(|value| {
            let text = format!("an entry without a default; the standard has `{value}`");
            Note::new(place.field(Field::DefaultValue), text)
        });
        data_type.into_iter().chain(access).chain(value)
    }
}

/// Sets the type of an entry and of its values.
fn set_type(entry: &mut Entry, data_type: DataType) {
    entry.data_type = Some(data_type);
    let configured = entry.configured.as_mut().and_then(|configured| configured.value.as_mut());
    let values = [entry.default.as_mut(), entry.low_limit.as_mut(), entry.high_limit.as_mut(), configured];
    for value in values.into_iter().flatten() {
        if let Value::Raw(text) = value
            && let Ok(typed) = literal::value_in_line(text, Some(data_type), &mut Quirks::default())
        {
            *value = typed;
        }
    }
}
