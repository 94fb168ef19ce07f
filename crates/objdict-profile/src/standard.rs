//! The built-in documents.

use std::ops::RangeInclusive;

use super::constants::DOCUMENTS;
use super::{EntryFacts, Profile};
use crate::model::{Access, DataType, Device};

/// Documents below this number apply to devices of any profile (CiA 301 and its additions).
const FIRST_DEVICE_PROFILE: u16 = 400;

/// All built-in documents in ascending order.
pub fn standard() -> impl Iterator<Item = &'static Profile> {
    DOCUMENTS.iter().map(|&(_, profile)| profile)
}

/// The document with a number, given as `401`, `CiA 401` or `cia401`.
pub fn named(name: &str) -> Option<&'static Profile> {
    let digits = name.trim_start_matches(|c: char| c.is_ascii_alphabetic() || c == ' ' || c == '-');
    let number: u16 = digits.parse().ok()?;
    DOCUMENTS.iter().find(|(of, _)| *of == number).map(|&(_, profile)| profile)
}

/// The document for a device profile number.
pub fn of_number(number: u16) -> Option<&'static Profile> {
    standard().find(|profile| profile.number == Some(number))
}

/// The device profile of a device; for a module with several logical devices, that of the first.
pub fn of_device(device: &Device) -> Option<&'static Profile> {
    of_number(super::number_of(device, 0)?)
}

/// The documents that apply to a device regardless of its profile. The document for network managers applies
/// only to devices with at least one of its objects.
pub fn for_all(device: &Device) -> impl Iterator<Item = &'static Profile> {
    below_profiles(has_object_of_managers(device))
}

/// The documents that apply regardless of a profile.
pub(super) fn below_profiles(is_manager: bool) -> impl Iterator<Item = &'static Profile> {
    let for_all = DOCUMENTS.iter().filter(|(number, _)| *number < FIRST_DEVICE_PROFILE);
    let for_it = for_all.filter(move |(number, _)| is_manager || *number != 302);
    for_it.map(|&(_, profile)| profile)
}

/// The only data type that the documents for all devices allow for an entry. The sub-index `None` refers to the content
/// of the object itself: its value, or all of its compact sub-objects.
pub fn data_type(device: &Device, index: u16, sub: Option<u8>) -> Option<DataType> {
    let only = |entry: EntryFacts<'static>| match *entry.data_types {
        [data_type] => Some(data_type),
        _ => None,
    };
    common(device, index, sub, only)
}

/// The access type that the documents for all devices define for a described entry, in their current edition; see [`data_type`].
pub fn access(device: &Device, index: u16, sub: Option<u8>) -> Option<Access> {
    common(device, index, sub, |entry| entry.access.first().copied())
}

/// The common property, in the documents, of all entries that a section describes.
fn common<T: PartialEq>(
    device: &Device,
    index: u16,
    sub: Option<u8>,
    fact: impl Fn(EntryFacts<'static>) -> Option<T>,
) -> Option<T> {
    let object = for_all(device).find_map(|document| document.object(index))?;
    let compact = device.object(index).and_then(|object| object.compact.as_ref());
    let subs = match (sub, compact) {
        (Some(sub), _) => sub..=sub,
        (None, Some(compact)) => 1..=compact.count,
        (None, None) => 0..=0,
    };
    let facts = subs.map(|sub| fact(object.entry(sub)?));
    facts.reduce(|one, other| one.filter(|one| Some(one) == other.as_ref()))?
}

/// The objects of CiA 302, which are required only if the device has at least one of them.
pub(super) const OF_MANAGERS: [RangeInclusive<u16>; 2] = [0x102A..=0x102A, 0x1F00..=0x1FFF];

pub(super) fn has_object_of_managers(device: &Device) -> bool {
    OF_MANAGERS.into_iter().any(|range| device.objects.range(range).next().is_some())
}

/// The former purpose of an object removed from CiA 301 in version 4.
pub fn obsolete(index: u16) -> Option<&'static str> {
    Some(match index {
        0x1004 => "number of PDOs supported",
        0x100B => "node-ID",
        0x100E => "COB-ID of the guarding protocol",
        0x100F => "number of SDOs supported",
        _ => return None,
    })
}
