//! Completes missing or invalid types and access types of entries for formats that require them: from CiA
//! documents, otherwise from the probable intention.

use std::borrow::Cow;

use objdict_model::model::{Access, DataType, Device, Entry, Field, InvalidValue, Object};
use objdict_profile as profile;

/// The fallback type and access of an entry.
#[derive(Clone, Copy)]
struct Assumed(DataType, Access);

const VALUE: Assumed = Assumed(DataType::DOMAIN, Access::Rw);
const COUNT: Assumed = Assumed(DataType::UNSIGNED8, Access::Ro);

/// The address of an entry; without a sub-index, the content of the object itself.
type EntryAddress = (u16, Option<u8>);

/// The data type that an entry of an object has.
fn data_type(device: &Device, (index, sub): EntryAddress, entry: &Entry) -> Option<DataType> {
    entry.implied_type().or_else(|| profile::data_type(device, index, sub))
}

/// The access that an entry of an object has.
fn access(device: &Device, (index, sub): EntryAddress, entry: &Entry) -> Option<Access> {
    let meant = || entry.invalid_values.get(&Field::AccessType).and_then(InvalidValue::intended_access);
    entry.implied_access().or_else(|| profile::access(device, index, sub)).or_else(meant)
}

/// Adds type and access to every entry with a value; `device` is the object's device.
pub(super) fn complete(device: &Device, index: u16, object: &mut Object) {
    let has_subs = object.object_type().has_subs();
    if !has_subs || object.compact.is_some() {
        complete_entry(device, (index, None), &mut object.main, VALUE);
    }
    for (sub, entry) in object.subs.iter_mut() {
        let assumed = if sub == 0 && has_subs { COUNT } else { VALUE };
        complete_entry(device, (index, Some(sub)), entry, assumed);
    }
}

fn complete_entry(device: &Device, at: EntryAddress, entry: &mut Entry, assumed: Assumed) {
    entry.data_type = data_type(device, at, entry).or(Some(assumed.0));
    entry.access = access(device, at, entry).or(Some(assumed.1));
    let stated = [Field::DataType, Field::AccessType, Field::ObjectType];
    entry.invalid_values.retain(|invalid| !stated.contains(&invalid.field));
}

/// The device with valid access types; CiA 311 does not support invalid ones.
pub(super) fn with_valid_access(device: &Device) -> Cow<'_, Device> {
    let is_due = |entry: &Entry| {
        entry.access.is_none()
            && entry.invalid_values.get(&Field::AccessType).is_some_and(|text| !text.text.is_empty())
    };
    let is_any_due =
        |object: &Object| is_due(&object.main) || object.subs.iter().any(|(_, entry)| is_due(entry));
    if !device.objects.values().any(is_any_due) {
        return Cow::Borrowed(device);
    }
    let mut valid = device.clone();
    for (&index, object) in valid.objects.iter_mut() {
        let has_subs = object.object_type().has_subs();
        if is_due(&object.main) && (!has_subs || object.compact.is_some()) {
            object.main.access = access(device, (index, None), &object.main).or(Some(VALUE.1));
        }
        for (sub, entry) in object.subs.iter_mut().filter(|(_, entry)| is_due(entry)) {
            let assumed = if sub == 0 && has_subs { COUNT } else { VALUE };
            entry.access = access(device, (index, Some(sub)), entry).or(Some(assumed.1));
        }
    }
    Cow::Owned(valid)
}

/// The fields of entries, with their values, that a text contains but its device does not.
pub(super) fn stated_anew(device: &Device, text: &Device, found: &mut dyn FnMut(String, serde_json::Value)) {
    for (index, object) in &device.objects {
        let Some(read) = text.object(*index) else { continue };
        let mut both = |entry: &Entry, read: &Entry, path: String| {
            let data_type = read.data_type.filter(|_| entry.implied_type().is_none());
            let access = read.access.filter(|_| entry.implied_access().is_none());
            if let Some(data_type) = data_type {
                found(format!("{path}/data_type"), serde_json::to_value(data_type).unwrap_or_default());
            }
            if let Some(access) = access {
                found(format!("{path}/access"), serde_json::to_value(access).unwrap_or_default());
            }
        };
        both(&object.main, &read.main, format!("/objects/0x{index:04X}"));
        for (sub, entry) in object.subs.iter() {
            if let Some(read) = read.subs.get(sub) {
                both(entry, read, format!("/objects/0x{index:04X}/subs/0x{sub:02X}"));
            }
        }
    }
}
