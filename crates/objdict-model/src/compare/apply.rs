//! Applies the changes that turn one device into the other.

use std::collections::BTreeMap;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use super::{Datum, to_value};
use crate::model::{Device, ExtraSection, Object};

/// A value of the model and its replacement.
#[derive(Clone, Debug, PartialEq)]
pub struct DatumChange {
    /// The location: a JSON pointer into the JSON of the device.
    pub path: String,
    /// The [`fingerprint`](Datum::fingerprint) of the old value; `None` if there was none.
    pub before: Option<u32>,
    /// The new value; `None` removes the old one.
    pub after: Option<Datum>,
}

/// Applies changes. Returns those that could not be applied: the value has changed since, the part no
/// longer exists, or the result would not be a valid device.
pub fn apply(device: &mut Device, changes: Vec<DatumChange>) -> Vec<DatumChange> {
    make_changes(device, changes, DatumDemand::Before)
}

/// Applies changes without checking the old values. Returns those whose result would not be a valid device.
pub fn overlay(device: &mut Device, changes: Vec<DatumChange>) -> Vec<DatumChange> {
    make_changes(device, changes, DatumDemand::Nothing)
}

/// The precondition of a change.
#[derive(Clone, Copy, PartialEq, Eq)]
enum DatumDemand {
    /// The current value is the old value of the change.
    Before,
    /// No condition.
    Nothing,
}

fn make_changes(device: &mut Device, changes: Vec<DatumChange>, check: DatumDemand) -> Vec<DatumChange> {
    let mut of_objects: BTreeMap<u16, Vec<DatumChange>> = BTreeMap::new();
    let mut others = Vec::new();
    for change in changes {
        match index_of(&change.path) {
            Some(index) => of_objects.entry(index).or_default().push(change),
            None => others.push(change),
        }
    }
    let mut refused = Vec::new();
    for (index, changes) in of_objects {
        let mut object = device.objects.remove(&index);
        apply_to(&mut object, &format!("/objects/0x{index:04X}"), changes, check, &mut refused);
        device.objects.extend(object.map(|object: Object| (index, object)));
    }
    if !others.is_empty() {
        let objects = std::mem::take(&mut device.objects);
        let mut frame = std::mem::take(device);
        if others.iter().any(|change| change.path.starts_with("/extra")) {
            frame.extra.sort_by(|a, b| a.name().cmp(b.name()));
        }
        let set = |change| {
            set_extra(&mut frame, change, check).and_then(|change| set_large(&mut frame, change, check))
        };
        let others = others.into_iter().filter_map(set).collect::<Vec<_>>();
        // the JSON of the other parts needs much memory
        let mut untouched = Device::default();
        let paths: Vec<String> = others.iter().map(|change| change.path.clone()).collect();
        exchange_untouched(&mut frame, &mut untouched, &paths);
        let mut frame = Some(frame);
        if !others.is_empty() {
            apply_to(&mut frame, "", others, check, &mut refused);
        }
        *device = Device { objects, ..frame.unwrap_or_default() };
        exchange_untouched(device, &mut untouched, &paths);
    }
    refused
}

/// Swaps the large parts of two devices that no path refers to.
fn exchange_untouched(one: &mut Device, other: &mut Device, paths: &[String]) {
    let is_touched = |name: &str| {
        paths.iter().any(|path| path.get(1..).is_some_and(|path| path.split('/').next() == Some(name)))
    };
    macro_rules! exchange {
        ($($name:ident)*) => {
            $(if !is_touched(stringify!($name)) {
                std::mem::swap(&mut one.$name, &mut other.$name);
            })*
        };
    }
    exchange! { application comments downloads extra functions lists module_objects modules tools }
}

/// Applies a change to all unknown sections, which are one string. Returns any other change, and any change that
/// failed, which is then reported as stale.
fn set_extra(frame: &mut Device, change: DatumChange, check: DatumDemand) -> Option<DatumChange> {
    if change.path != "/extra" || change.after.as_ref().is_some_and(|after| !after.text().starts_with('"')) {
        return Some(change);
    }
    let present: Vec<&ExtraSection> = frame.extra.iter().collect();
    let before =
        (!present.is_empty()).then(|| Datum::from(Value::String(super::print(&present))).fingerprint());
    let after = match change.after.as_ref().map(Datum::value) {
        Some(Value::String(text)) => super::parse(&text),
        _ => Some(Vec::new()),
    };
    match after.filter(|_| check == DatumDemand::Nothing || before == change.before) {
        Some(sections) => {
            frame.extra = sections;
            None
        }
        None => Some(change),
    }
}

/// Replaces a part of the device as a whole, without a tree of its JSON. Returns any other change, and any
/// change that failed.
fn set_large(frame: &mut Device, change: DatumChange, check: DatumDemand) -> Option<DatumChange> {
    let Some(after) = change.after.as_ref().filter(|after| after.is_large()) else { return Some(change) };
    let absent = Device::default();
    macro_rules! set {
        ($($name:ident)*) => {
            match change.path.strip_prefix('/') {
                $(Some(stringify!($name)) => {
                    let present = Some(&frame.$name).filter(|present| **present != absent.$name);
                    if check == DatumDemand::Before && change.before != present.map(|present| Datum::of(present).fingerprint()) {
                        return Some(change);
                    }
                    let document = format!("{{\"{}\":{after}}}", stringify!($name));
                    let Ok(read) = serde_json::from_str::<Device>(&document) else { return Some(change) };
                    frame.$name = read.$name;
                    None
                })*
                _ => Some(change),
            }
        };
    }
    set! {
        application comments commissioning device_info downloads dummy_usage dynamic_channels file_info functions headers
        identity lists manager module_objects modules network_identity tools
    }
}

/// The index of the object that a path refers to, as a whole or in part.
fn index_of(path: &str) -> Option<u16> {
    let digits = path.strip_prefix("/objects/0x")?.split('/').next()?;
    u16::from_str_radix(digits, 16).ok()
}

/// Applies the changes of one part: all at once or, if the result is not valid, one by one.
fn apply_to<T: Serialize + DeserializeOwned>(
    part: &mut Option<T>,
    root: &str,
    changes: Vec<DatumChange>,
    check: DatumDemand,
    refused: &mut Vec<DatumChange>,
) {
    let before = part.as_ref().map(to_value);
    let mut after = before.clone();
    let mut made = Vec::new();
    for change in changes {
        match set(&mut after, &change, &change.path[root.len()..], check) {
            true => made.push(change),
            false => refused.push(change),
        }
    }
    // from a string, because a second deserializer would add a megabyte of code
    match after.map(|after| serde_json::from_str(&after.to_string())) {
        None => *part = None,
        Some(Ok(changed)) => *part = Some(changed),
        // one invalid value must not affect the others
        Some(Err(_)) if made.len() > 1 => {
            for change in made {
                apply_to(part, root, vec![change], check, refused);
            }
        }
        Some(Err(_)) => refused.append(&mut made),
    }
}

/// Sets the value at a path if the present value is the expected one.
fn set(root: &mut Option<Value>, change: &DatumChange, path: &str, check: DatumDemand) -> bool {
    let is_expected = |found: Option<&Value>| {
        check == DatumDemand::Nothing || found.map(|value| Datum::from(value).fingerprint()) == change.before
    };
    let after = || change.after.as_ref().map(Datum::value);
    let Some((parent, key)) = path.rsplit_once('/') else {
        let as_expected = is_expected(root.as_ref());
        if as_expected {
            *root = after();
        }
        return as_expected;
    };
    let Some(root) = root.as_mut() else { return false };
    let parent = match root.pointer_mut(parent) {
        Some(parent) => parent,
        // empty parts are omitted from the JSON
        None if check == DatumDemand::Nothing || change.before.is_none() => match make(root, parent) {
            Some(parent) => parent,
            None => return false,
        },
        None => return false,
    };
    let key = key.replace("~1", "/").replace("~0", "~");
    match parent {
        Value::Object(map) if is_expected(map.get(&key)) => {
            match after() {
                Some(value) => map.insert(key, value),
                None => map.remove(&key),
            };
            true
        }
        Value::Array(items) => match (key.parse().ok().and_then(|at: usize| items.get_mut(at)), after()) {
            (Some(item), Some(value)) if is_expected(Some(item)) => {
                *item = value;
                true
            }
            _ => false,
        },
        _ => false,
    }
}

/// The map at a path, created if missing.
fn make<'a>(root: &'a mut Value, path: &str) -> Option<&'a mut Value> {
    path.split('/').skip(1).try_fold(root, |at, key| {
        let key = key.replace("~1", "/").replace("~0", "~");
        match at {
            Value::Object(map) => Some(map.entry(key).or_insert_with(|| Value::Object(Map::new()))),
            _ => None,
        }
    })
}
