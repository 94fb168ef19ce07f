//! The fields of an entry that both devices have.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::audience::{Affected, Audience, is_persistent, is_writable};
use super::objects::{ObjectPair, pdo_of, place};
use super::values::{AllowedRange, is_null, is_same, shown};
use super::{DeviceComparison, Spot, rules};
use crate::diagnostic::{Text, say};
use crate::model::{
    Access, CobId, Entry, Field, Identity, InvalidValue, Meaning, Meanings, Object, PdoKind, Scaling, Value,
};

impl<'a> DeviceComparison<'a> {
    /// An entry, at its old and at its new sub-index.
    pub(super) fn entry(&mut self, pair: ObjectPair<'a>, (old_sub, new_sub): (u8, u8)) {
        let ObjectPair { index: (old_index, new_index), old: old_object, new: new_object } = pair;
        let (Some(old), Some(new)) = (old_object.entry(old_sub), new_object.entry(new_sub)) else { return };
        let affected = Affected::by_entry(&self.old, (old_index, old_sub), old_object, &old);
        let places = [place(&self.old, old_index, old_sub), place(&self.new, new_index, new_sub)];
        let [old_place, new_place] = places.map(Some);
        let spot =
            Spot { index: Some(old_index), sub: Some(old_sub), old: old_place, new: new_place, affected };
        if old_sub != new_sub {
            let values = [old_sub, new_sub].map(|sub| Some(format!("{sub:02X}h")));
            let message = say!("`{}` moves from sub-index {} to {}", &old.name, old_sub, new_sub);
            self.report(&rules::ENTRY_MOVED, &spot, values, message);
        }
        // the name of a variable is the name of the object
        let is_variable = |object: &Object| !object.object_type().has_subs() && object.subs.is_empty();
        let are_variables = is_variable(old_object) && is_variable(new_object);
        if !are_variables {
            self.name(&spot, [&old.name, &new.name], &rules::ENTRY_RENAMED);
        }
        if old != new {
            let is_typed = self.data_type(&spot, &old, &new);
            let is_count = old_sub == 0 && old_object.object_type().has_subs();
            self.access(&spot, [&old, &new], is_count);
            if is_typed {
                self.limits(&spot, &old, &new);
            }
            self.values(&spot, [old_object, new_object], [&old, &new], is_typed);
            self.flags(&spot, &old, &new);
        }
        self.meaning(&spot, pair, (old_sub, new_sub));
    }

    /// Compares the data types; returns whether they are equal.
    fn data_type(&mut self, spot: &Spot, old: &Entry, new: &Entry) -> bool {
        let types = [old.implied_type(), new.implied_type()];
        let [old, new] = types;
        if old == new {
            return true;
        }
        let spot = spot.field(&Field::DataType);
        let values = types.map(|data_type| data_type.map(|data_type| data_type.to_string()));
        let none = || "none".to_owned();
        let [old_name, new_name] = values.clone().map(|name| name.unwrap_or_else(none));
        let message = say!("the data type changes from {} to {}", old_name, new_name);
        let is_known = old.is_some() && new.is_some();
        let rule = if is_known { &rules::DATA_TYPE_CHANGED } else { &rules::DATA_TYPE_STATED };
        self.report(rule, &spot, values, message);
        false
    }

    /// Compares who may read, write and map an entry.
    fn access(&mut self, spot: &Spot, [old, new]: [&Entry; 2], is_count: bool) {
        let stated = [old.implied_access(), new.implied_access()];
        let mut is_wider = false;
        if stated.iter().flatten().count() == 1 {
            let values = [old, new].map(|entry| {
                let text = |invalid: &InvalidValue| invalid.text.to_string();
                let unknown = || entry.invalid_values.get(&Field::AccessType).map(text);
                entry.implied_access().map(|access| access.name().to_owned()).or_else(unknown)
            });
            let [old, new] = values.clone().map(|text| text.unwrap_or_else(|| "none".to_owned()));
            let message = say!("the access type changes from `{}` to `{}`", old, new);
            self.report(&rules::ACCESS_UNKNOWN, &spot.field(&Field::AccessType), values, message);
        } else if let [Some(old_access), Some(new_access)] = stated {
            let spot = spot.field(&Field::AccessType);
            let rights = |access: Access| [access.is_readable(), access.is_writable()];
            let values = stated.map(|access| access.map(|access| access.name().to_owned()));
            let message = say!("the access type changes from `{}` to `{}`", old_access, new_access);
            if let Some(is_narrower) = is_narrower(rights(old_access), rights(new_access)) {
                let rule = if is_narrower { &rules::ACCESS_NARROWED } else { &rules::ACCESS_WIDENED };
                is_wider = !is_narrower;
                self.report(rule, &spot, values, message);
            } else if (old_access == Access::Const) != (new_access == Access::Const) {
                // a number of sub-indexes is a constant of generated code in any case
                let affected = spot.affected.without(Audience::Firmware, !is_count);
                self.report(&rules::CONSTANT_CHANGED, &Spot { affected, ..spot.clone() }, values, message);
            }
        }
        self.mapping(spot, [old, new], is_wider);
    }

    /// Compares the PDOs that may carry an entry. A wider access type explains additional ones.
    fn mapping(&mut self, spot: &Spot, [old, new]: [&Entry; 2], is_wider: bool) {
        let rights = |entry: &Entry| {
            [PdoKind::Rpdo, PdoKind::Tpdo].map(|kind| entry.is_mappable() && entry.fits_pdo(kind))
        };
        let (old_rights, new_rights) = (rights(old), rights(new));
        let Some(is_narrower) = is_narrower(old_rights, new_rights) else { return };
        let is_stated = old.pdo_mapping.unwrap_or_default() != new.pdo_mapping.unwrap_or_default();
        if is_wider && !is_narrower && !is_stated {
            return;
        }
        let rule = if is_narrower { &rules::MAPPING_NARROWED } else { &rules::MAPPING_WIDENED };
        let field = if is_stated { Field::PdoMapping } else { Field::AccessType };
        let values = [directions(old_rights), directions(new_rights)];
        let message = say!("PDOs that may carry the entry change from {} to {}", values[0], values[1]);
        self.report(rule, &spot.field(&field), values.map(|text| Some(text.to_owned())), message);
    }

    fn limits(&mut self, spot: &Spot, old: &Entry, new: &Entry) {
        let is_writable = is_writable(old);
        let (old, new) = (AllowedRange::of(old), AllowedRange::of(new));
        let rule = match new.against(&old) {
            Ordering::Equal => return,
            Ordering::Less if !is_writable => &rules::READ_LIMITS_NARROWED,
            Ordering::Greater if !is_writable => &rules::READ_LIMITS_WIDENED,
            Ordering::Less => &rules::LIMITS_NARROWED,
            Ordering::Greater => &rules::LIMITS_WIDENED,
        };
        let values = [old.shown(), new.shown()];
        let [old, new] = values.clone().map(|text| text.unwrap_or_else(|| "none".to_owned()));
        let message = say!("the limits change from `{}` to `{}`", old, new);
        self.report(rule, &spot.field(&Field::LowLimit), values, message);
    }

    /// The node-ID for which formulas are evaluated: of the node that both describe.
    pub(super) fn node_id(&self) -> Option<u8> {
        let (old, new) = (self.old.device.node_id(), self.new.device.node_id());
        old.or(new).filter(|_| old.is_none() || new.is_none() || old == new)
    }

    /// Compares default and configured values.
    fn values(&mut self, spot: &Spot, objects: [&Object; 2], [old, new]: [&Entry; 2], is_typed: bool) {
        let (Some(index), Some(sub)) = (spot.index, spot.sub) else { return };
        if is_of_pdo(index, sub) || is_count(sub, objects, [old, new]) {
            return;
        }
        let node_id = self.node_id();
        let differs = |old: Option<&Value>, new: Option<&Value>| !is_same(old, new, node_id);
        // a missing or unreadable value is a consequence of a different type
        let is_understood =
            |value: Option<&Value>| value.is_some_and(|value| !matches!(value, Value::Raw(_)));
        let is_explained = |old: Option<&Value>, new: Option<&Value>| {
            !(is_typed || (is_understood(old) && is_understood(new)))
        };
        let is_configured = old.configured_value().is_some() || new.configured_value().is_some();
        let (old_value, new_value) = (old.value(), new.value());
        if differs(old_value, new_value) && !is_explained(old_value, new_value) {
            let is_known = old_value.is_some() && new_value.is_some();
            let stated = old_value.xor(new_value);
            let rule = match stated.filter(|value| !is_configured && is_null(value)) {
                Some(_) if !is_cob_id((index, sub)) => Some(&rules::DEFAULT_STATED),
                _ => rule_of_value((index, sub), is_known, is_configured, is_writable(old)),
            };
            let field = if is_configured { Field::ParameterValue } else { Field::DefaultValue };
            if let Some(rule) = rule {
                self.value(rule, &spot.field(&field), [old_value, new_value]);
            }
        }
        let (old_default, new_default) = (old.default.as_ref(), new.default.as_ref());
        if is_configured && differs(old_default, new_default) && !is_explained(old_default, new_default) {
            let spot = spot.field(&Field::DefaultValue);
            self.value(&rules::DEFAULT_CHANGED, &spot, [old_default, new_default]);
        }
    }

    fn value(&mut self, rule: &'static rules::ChangeRule, spot: &Spot, values: [Option<&Value>; 2]) {
        let is_cob_id =
            std::ptr::eq(rule, &rules::COB_ID_CHANGED) || std::ptr::eq(rule, &rules::DEVICE_TYPE_CHANGED);
        let shown = |value: &Value| match CobId::from_value(value) {
            Some(cob_id) if is_cob_id && !cob_id.depends_on_node_id() => format!("{:X}h", cob_id.number()),
            _ => shown(value),
        };
        let values = values.map(|value| value.map(shown));
        let [old, new] = values.clone().map(|value| value.unwrap_or_else(|| "none".to_owned()));
        let is_configured = spot.new.as_ref().is_some_and(|place| place.field == Some(Field::ParameterValue));
        let message = match is_configured {
            true => say!("the configured value changes from {} to {}", old, new),
            false => say!("the default value changes from {} to {}", old, new),
        };
        self.report(rule, spot, values, message);
    }

    fn flags(&mut self, spot: &Spot, old: &Entry, new: &Entry) {
        let shown = |entry: &Entry| {
            let (write, read) = (entry.flags().refuses_write(), entry.flags().refuses_read());
            (write, read, format!("{:X}h", entry.flags().0))
        };
        let (old_flags, new_flags) = (shown(old), shown(new));
        if (old_flags.0, old_flags.1) != (new_flags.0, new_flags.1) {
            let message = say!("{ObjFlags} changes from {} to {}", old_flags.2, new_flags.2);
            let values = [Some(old_flags.2), Some(new_flags.2)];
            self.report(&rules::FLAGS_CHANGED, &spot.field(&Field::ObjFlags), values, message);
        }
        let safety = |entry: &Entry| {
            let safety = entry.safety.as_deref();
            let inverted = safety.and_then(|safety| safety.inverted_srad).unwrap_or(0);
            (safety.and_then(|safety| safety.srdo_mapping).unwrap_or(false), inverted)
        };
        let (old_safety, new_safety) = (safety(old), safety(new));
        if old_safety != new_safety {
            let shown = |(is_mapped, inverted): (bool, u32)| {
                format!(
                    "{}, inverted entry {inverted:08X}h",
                    if is_mapped { "mappable" } else { "not mappable" }
                )
            };
            let values = [shown(old_safety), shown(new_safety)];
            let message = say!("the safety mapping changes from {} to {}", &values[0], &values[1]);
            let spot = Spot { affected: Affected::ALL, ..spot.field(&Field::SrdoMapping) };
            self.report(&rules::SAFETY_CHANGED, &spot, values.map(Some), message);
        }
        if is_persistent(old) != is_persistent(new) {
            let spot = Spot { affected: Affected::ALL, ..spot.clone() };
            let shown = |entry: &Entry| if is_persistent(entry) { "persistent" } else { "volatile" };
            let values = [shown(old), shown(new)];
            let message =
                say!("the value is now {} instead of {}", values[1].to_owned(), values[0].to_owned());
            self.report(&rules::STORAGE_CHANGED, &spot, values.map(|text| Some(text.to_owned())), message);
        }
    }

    /// Compares the meanings of values in the application processes.
    fn meaning(&mut self, spot: &Spot, pair: ObjectPair<'a>, (old_sub, new_sub): (u8, u8)) {
        let described = |object: &'a Object, sub: u8| object.subs.get(sub).unwrap_or(&object.main);
        let (old, new) = (described(pair.old, old_sub), described(pair.new, new_sub));
        let scales = [scale(&self.old.meanings.scaling_of(old)), scale(&self.new.meanings.scaling_of(new))];
        if scales[0] != scales[1] {
            let values = scales.map(|scale| scale.map(|scale| scale.join(" ").trim().to_owned()));
            let [old, new] = values.clone().map(|text| text.unwrap_or_else(|| "none".to_owned()));
            let is_known = values.iter().all(Option::is_some);
            let rule = if is_known { &rules::UNIT_CHANGED } else { &rules::UNIT_STATED };
            self.report(rule, spot, values, say!("the unit changes from {} to {}", old, new));
        }
        let (old_index, new_index) = pair.index;
        let old = named_values(&self.old.meanings, old_index, old_sub);
        let new = named_values(&self.new.meanings, new_index, new_sub);
        if !old.is_empty() && !new.is_empty() && old != new {
            self.named_values(spot, &old, &new);
        }
    }

    fn named_values(&mut self, spot: &Spot, old: &BTreeMap<i128, &str>, new: &BTreeMap<i128, &str>) {
        let only = |all: &BTreeMap<i128, &str>, other: &BTreeMap<i128, &str>| {
            let only = all.iter().filter(|(number, _)| !other.contains_key(number));
            only.map(|(number, name)| format!("{number} `{name}`")).collect::<Vec<_>>()
        };
        let removed = only(old, new);
        if !removed.is_empty() {
            let list = removed.join(", ");
            let message = say!("named values are removed: {}", Text::from(list.clone()));
            self.report(&rules::VALUES_REMOVED, spot, [Some(list), None], message);
        }
        let added = only(new, old);
        if !added.is_empty() {
            let list = added.join(", ");
            let message = say!("named values are added: {}", Text::from(list.clone()));
            self.report(&rules::VALUES_ADDED, spot, [None, Some(list)], message);
        }
        for (number, old) in old {
            let Some(new) = new.get(number).filter(|new| *new != old) else { continue };
            let values = [Some((*old).to_owned()), Some((*new).to_owned())];
            let message = say!("the name of the value {} changes from `{}` to `{}`", *number, *old, *new);
            self.report(&rules::VALUE_RENAMED, spot, values, message);
        }
    }
}

/// Whether the new rights lack one of the old ones; `None` if they are equal.
fn is_narrower<const N: usize>(old: [bool; N], new: [bool; N]) -> Option<bool> {
    (old != new).then(|| old.iter().zip(new).any(|(&old, new)| old && !new))
}

/// The directions of PDOs, by whether an RPDO and a TPDO may carry an entry.
const fn directions(rights: [bool; 2]) -> &'static str {
    match rights {
        [true, true] => "RPDOs and TPDOs",
        [true, false] => "RPDOs",
        [false, true] => "TPDOs",
        [false, false] => "none",
    }
}

/// Whether a value is a part of a PDO as a whole.
fn is_of_pdo(index: u16, sub: u8) -> bool {
    match pdo_of(index) {
        Some(_) if PdoKind::of_mapping(index).is_some() => sub <= 64,
        Some(_) => matches!(sub, 0 | 1 | 2 | 3 | 5 | 6),
        None => false,
    }
}

/// Whether a value is the number of sub-indexes in both devices, which follows from the sub-indexes.
fn is_count(sub: u8, objects: [&Object; 2], entries: [&Entry; 2]) -> bool {
    sub == 0
        && objects.into_iter().zip(entries).all(|(object, entry)| {
            let count = entry.value().and_then(Value::as_integer);
            let highest = object.highest_sub().map(i128::from);
            object.object_type().has_subs() && count.is_some() && count == highest
        })
}

/// Whether an entry is the COB-ID of a service.
const fn is_cob_id(at: (u16, u8)) -> bool {
    matches!(at, (0x1005 | 0x1012 | 0x1014, 0) | (0x1200..=0x12FF, 1 | 2) | (0x1301..=0x1340, 5 | 6))
}

/// The rule about a value; `None` if it is about a version. The identification of the device or a service has changed
/// only if both values are known.
fn rule_of_value(
    at: (u16, u8),
    is_known: bool,
    is_configured: bool,
    is_writable: bool,
) -> Option<&'static rules::ChangeRule> {
    Some(match at {
        (0x1000, 0) if is_known => &rules::DEVICE_TYPE_CHANGED,
        (Identity::INDEX, 1 | 2) if is_known => &rules::IDENTITY_CHANGED,
        (Identity::INDEX, 3) => return None,
        (0x1008..=0x100A, 0) | (Identity::INDEX, 4) => &rules::DEVICE_FACT_CHANGED,
        at if is_known && is_cob_id(at) => &rules::COB_ID_CHANGED,
        _ if is_configured => &rules::CONFIGURED_VALUE_CHANGED,
        _ if !is_writable => &rules::READ_ONLY_DEFAULT_CHANGED,
        _ => &rules::DEFAULT_CHANGED,
    })
}

/// Unit, multipliers and offset; `None` if nothing is stated.
fn scale(scaling: &Scaling<'_>) -> Option<[String; 4]> {
    if scaling.is_empty() {
        return None;
    }
    let unit = scaling.unit;
    let name = unit.and_then(|unit| unit.labels.name_in("en")).unwrap_or_default();
    let factor = unit.map_or("", |unit| unit.multiplier.trim());
    let factor = if factor == "1" { "" } else { factor };
    let part = |before: &str, text: Option<&str>| match text {
        None | Some("") => String::new(),
        Some(text) => format!("{before}{text}"),
    };
    let multiplier = scaling.multiplier.filter(|text| *text != "1");
    let offset = scaling.offset.filter(|text| *text != "0");
    Some([name.to_owned(), part("×", Some(factor)), part("multiplier ", multiplier), part("offset ", offset)])
}

/// The named values of an entry; of two names, the first.
fn named_values<'a>(meanings: &Meanings<'a>, index: u16, sub: u8) -> BTreeMap<i128, &'a str> {
    let Some(Meaning::Enumeration(found)) = meanings.of(index, sub) else { return BTreeMap::new() };
    let mut names = BTreeMap::new();
    for value in found.values.into_iter().filter(|value| !value.name.is_empty()) {
        names.entry(value.number).or_insert(value.name);
    }
    names
}
