//! Every other value that differs and has no rule of its own. So two devices without a change lead to the same
//! generated and converted files.

use std::mem;

use objdict_model::compare::{Datum, DatumDifference, differences};

use super::audience::{Affected, Audience};
use super::objects::pdo_of;
use super::{DeviceChange, DeviceComparison, Spot, rules};
use crate::diagnostic::say;
use crate::model::{Compact, Device, Field, FileInfo, Identity, Modules, Object, ObjectList, Part, Place};

/// Longer values are not displayed.
const LONGEST: usize = 60;

impl DeviceComparison<'_> {
    /// Reports differences that no change contains so far.
    pub(super) fn rest(&mut self) {
        let old = counted(self.old.device, self.new.device);
        let mut new = counted(self.new.device, self.old.device);
        // at their old places
        let moved = self.moved.iter().filter(|(from, to)| from.0 != to.0);
        let moved: Vec<_> =
            moved.filter_map(|(from, to)| Some((from.0, new.objects.remove(&to.0)?))).collect();
        new.objects.extend(moved);
        let mut told = mem::take(&mut self.changes);
        told.sort_by_key(order);
        for difference in differences(&old, &new) {
            self.datum(&difference, &told);
        }
        told.append(&mut self.changes);
        told.sort_by_key(order);
        self.changes = told;
    }

    fn datum(&mut self, difference: &DatumDifference, told: &[DeviceChange]) {
        let place = difference.place();
        let index = place.part.object();
        let sub = if let Part::Entry(_, sub) = place.part { Some(sub) } else { None };
        let of_pdo = index.and_then(pdo_of).and_then(|(kind, number)| kind.communication_index(number));
        let mut near = changes_of(index, told).chain(changes_of(of_pdo.or(index), told));
        if self.follows(&place, told) || near.any(|change| is_about(change, &place)) {
            return;
        }
        let name =
            place.field.as_ref().map_or_else(|| place.part.to_string(), |field| field.name().into_owned());
        let is_built =
            index.is_some() && name != "SubNumber" && (!name.contains('/') || name.starts_with("stack"));
        let affected = Affected::ALL.without(Audience::Firmware, is_built);
        let spot = Spot { index, sub, affected, ..Spot::part(&place) };
        let [old, new] = [&difference.left, &difference.right].map(|datum| datum.as_ref().map(shown));
        let values = [old, new].map(|text| text.map(|text| text.trim_matches('"').to_owned()));
        let [old, new] = [old, new].map(|text| text.unwrap_or("none"));
        let is_long = |text: &str| text.len() > LONGEST || text.contains(['{', '[', ',']);
        let message = match is_long(old) || is_long(new) {
            true => say!("`{}` changes", name),
            false => say!("`{}` changes from {} to {}", name, old, new),
        };
        // no network is network 0
        let is_set = [old, new].iter().any(|text| !["none", "0"].contains(text));
        let rule = match (&place.part, &place.field) {
            (Part::DeviceInfo, _) => &rules::DEVICE_FACT_CHANGED,
            (Part::Commissioning, Some(Field::NodeId | Field::Baudrate | Field::NetNumber)) if is_set => {
                &rules::NODE_CHANGED
            }
            (Part::Commissioning, _) => &rules::NODE_FACT_CHANGED,
            (_, Some(Field::DownloadFile)) => &rules::CONFIGURED_VALUE_CHANGED,
            _ => &rules::DATA_CHANGED,
        };
        self.report(rule, &spot, values, message);
    }

    /// Whether a value follows from others, or rules cover it completely.
    fn follows(&self, place: &Place, told: &[DeviceChange]) -> bool {
        let [old, new] = [self.old.device, self.new.device].map(Device::identity);
        let is_raised =
            old.revision_number.is_some_and(|old| new.revision_number.is_some_and(|new| new != old));
        let has = |kind: &str| told.iter().any(|change| change.rule.info.name().starts_with(kind));
        match (&place.part, &place.field) {
            (Part::Application, _) => has("value") || has("unit-"),
            (_, Some(Field::ParameterName)) => true,
            (_, Some(Field::VendorNumber)) => old.vendor_id != new.vendor_id,
            (_, Some(Field::ProductNumber)) => old.product_code != new.product_code,
            (_, Some(Field::NrOfRxPdo | Field::NrOfTxPdo)) => has("pdo-added") || has("pdo-removed"),
            (_, Some(Field::RevisionNumber)) => is_raised,
            (part, Some(Field::DefaultValue | Field::ParameterValue)) => {
                is_raised && *part == self.new.device.value_place(Identity::INDEX, 3).part
            }
            _ => false,
        }
    }
}

/// A value, without its kind.
fn shown(datum: &Datum) -> &str {
    let text = datum.text();
    let value = text.strip_prefix('{').and_then(|text| text.strip_suffix('}')?.split_once(':'));
    value.map_or(text, |(_, value)| value)
}

/// Whether a change of the same object, or of the device as a whole, also covers a value.
fn is_about(change: &DeviceChange, place: &Place) -> bool {
    let rule = change.rule.info.name();
    let is_value = matches!(place.field, Some(Field::DefaultValue | Field::ParameterValue));
    let is_limit = matches!(place.field, Some(Field::LowLimit | Field::HighLimit));
    // a compact object's value has the place of the object
    let is_entry = matches!(place.part, Part::Entry(index, sub) if (change.index, change.sub) == (Some(index), Some(sub)));
    let is_part = |told: &Place| is_entry || told.part == place.part;
    let mut places = [&change.old_place, &change.new_place].into_iter().flatten();
    match rule {
        "object-type-changed" | "object-removed" | "object-added" => change.index == place.part.object(),
        "entry-removed" | "entry-added" | "entry-moved" => {
            let is_count = is_value && matches!(place.part, Part::Entry(_, 0));
            is_count || is_entry || places.any(|told| matches!(told.part, Part::Entry(..)) && is_part(told))
        }
        _ if rule.starts_with("pdo-") => is_value || place.field.is_none(),
        _ => places.any(|told| match (&told.field, &place.field) {
            (None, Some(Field::Named(path))) => {
                path.starts_with("parameter") || ["stack", "stack/storage_group"].contains(&&**path)
            }
            (Some(Field::DataType), _) if is_value || is_limit => is_part(told),
            (Some(Field::LowLimit), _) if is_limit => is_part(told),
            (Some(Field::AccessType), Some(Field::Named(path))) => is_part(told) && **path == *"misfits",
            (Some(Field::SrdoMapping), Some(Field::InvertedSrad)) => is_part(told),
            // only one device has any of it
            (Some(Field::ParameterValue | Field::SrdoMapping), Some(Field::Named(path))) => {
                is_part(told) && ["configured", "safety"].contains(&&**path)
            }
            (told_field, field) => is_part(told) && (told_field == field || told.part == Part::DummyUsage),
        }),
    }
}

const fn order(change: &DeviceChange) -> (bool, Option<u16>) {
    (change.index.is_none(), change.index)
}

/// The changes of an object, or of the device as a whole, in an ordered list.
fn changes_of(index: Option<u16>, all: &[DeviceChange]) -> impl Iterator<Item = &DeviceChange> {
    let from = all.partition_point(|change| order(change) < (index.is_none(), index));
    all[from..].iter().take_while(move |change| change.index == index)
}

/// A device without irrelevant content: authors and dates, comments, notation, and content that other rules cover
/// completely.
fn counted(device: &Device, other: &Device) -> Device {
    let stated = &device.objects;
    let mut device = Device { comments: None, ..device.expanded().into_owned() };
    let FileInfo { languages, device_class, extra, invalid_values, .. } =
        device.file_info.unwrap_or_default();
    device.file_info =
        Some(FileInfo { languages, device_class, extra, invalid_values, ..FileInfo::default() });
    device.headers.network_file = None;
    let headers = [&mut device.headers.device, &mut device.headers.network].into_iter().flatten();
    headers.for_each(|header| header.date = None);
    let Modules { invalid_values, extra, .. } = device.modules.unwrap_or_default();
    device.modules = Some(Modules { invalid_values, extra, ..Modules::default() });
    for list in ObjectList::ALL {
        let mut members = device.lists.get(list).to_vec();
        members.retain(|index| device.objects.contains_key(index) == other.objects.contains_key(index));
        members.sort_unstable();
        members.dedup();
        *device.lists.get_mut(list) = Some(members);
    }
    for (index, object) in device.objects.iter_mut() {
        let odd = [stated, &other.objects].map(|objects| objects.get(index).and_then(odd_sub_number));
        object.sub_number = stated.get(index).and_then(|of| of.sub_number).filter(|_| odd != [None; 2]);
        if let Some((stated, compact)) = stated.get(index).and_then(|of| Some((of, of.compact.as_deref()?))) {
            keep_unused(object, stated, compact);
        }
    }
    device
}

/// A `SubNumber` that does not match the sub-indexes; it need not count compact ones.
fn odd_sub_number(object: &Object) -> Option<u8> {
    let described = object.subs.iter().filter(|(sub, _)| *sub != 0xFF).count();
    let is_uncounted = |number: u8| number == 0 && object.compact.is_some();
    object.sub_number.filter(|&number| usize::from(number) != described && !is_uncounted(number))
}

/// Transfers to an expanded object properties that are stated for all its entries, or for one of them, and properties
/// that no entry has: individually described entries have their own values.
fn keep_unused(object: &mut Object, stated: &Object, compact: &Compact) {
    let is_described = |sub: u8| stated.subs.get(sub).is_some();
    let mut unused = compact.clone();
    unused.names.retain(|(sub, _)| is_described(*sub));
    unused.values.retain(|(sub, _)| is_described(*sub));
    unused.denotations.retain(|(sub, _)| is_described(*sub));
    let is_idle = (1..=compact.count).all(is_described);
    if is_idle {
        object.main = stated.main.clone();
    }
    if is_idle || !(unused.names.is_empty() && unused.values.is_empty() && unused.denotations.is_empty()) {
        object.compact = Some(Box::new(unused));
    }
}
