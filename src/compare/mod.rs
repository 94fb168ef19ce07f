//! Two devices, datum by datum: where they differ, and how one becomes the other.
//!
//! A datum is named by its path in the JSON of the model (docs/json.md), as a JSON pointer (RFC 6901):
//! `/objects/0x1018/subs/0x01/default`. Objects that are equal are never turned into JSON, so that a comparison of
//! equal devices costs no more than looking at them.

mod apply;
mod place;
mod sections;

use serde::Serialize;
use serde_json::{Map, Value};

pub use apply::{DatumChange, apply};

use crate::model::{Device, ExtraSection, Place};

/// A datum that two devices do not have alike.
#[derive(Clone, Debug, PartialEq)]
pub struct DatumDifference {
    /// Its place: a JSON pointer into the JSON of the device.
    pub path: String,
    /// What the left device says; `None` for nothing.
    pub left: Option<Value>,
    /// What the right device says; `None` for nothing.
    pub right: Option<Value>,
}

impl DatumDifference {
    /// The address of the datum.
    pub fn place(&self) -> Place {
        place::of(&self.path)
    }
}

/// Where two devices differ, in the order of the model. The order of sections that the model does not know says nothing.
///
/// ```
/// use objdict::compare::differences;
/// use objdict::model::{Device, Entry, Object};
///
/// let named = |name: &str| {
///     let main = Entry { name: name.into(), ..Entry::default() };
///     let mut device = Device::default();
///     device.objects.insert(0x2000, Object { main, ..Object::default() });
///     device
/// };
/// let found = differences(&named("Speed"), &named("Velocity"));
/// assert_eq!(found[0].path, "/objects/0x2000/name");
/// assert_eq!(found[0].place().to_string(), "0x2000 / ParameterName");
/// ```
pub fn differences(left: &Device, right: &Device) -> Vec<DatumDifference> {
    let mut found = Vec::new();
    each_difference(left, right, &mut |difference| found.push(difference));
    found
}

/// Calls `found` for each of the [`differences`]: their values may be much more than the devices.
pub(crate) fn each_difference(left: &Device, right: &Device, found: &mut dyn FnMut(DatumDifference)) {
    let mut path = String::new();
    if left == right {
        return;
    }
    diff_maps(&mut path, frame(left), frame(right), found);
    diff_extra(&mut path, left, right, found);
    path.push_str("/objects");
    let indexes: std::collections::BTreeSet<u16> =
        left.objects.keys().chain(right.objects.keys()).copied().collect();
    for index in indexes {
        let (of_left, of_right) = (left.object(index), right.object(index));
        if of_left != of_right {
            let length = path.len();
            path.push_str(&format!("/0x{index:04X}"));
            let json = |object: Option<&_>| object.map(to_value);
            diff(&mut path, json(of_left), json(of_right), found);
            path.truncate(length);
        }
    }
}

/// Everything of a device but its objects and the sections that the model does not know.
fn frame(device: &Device) -> Map<String, Value> {
    let frame = Device {
        kind: device.kind,
        file_info: device.file_info.clone(),
        device_info: device.device_info.clone(),
        dummy_usage: device.dummy_usage.clone(),
        comments: device.comments.clone(),
        commissioning: device.commissioning.clone(),
        downloads: device.downloads.clone(),
        lists: device.lists.clone(),
        objects: std::collections::BTreeMap::new(),
        modules: device.modules.clone(),
        dynamic_channels: device.dynamic_channels.clone(),
        tools: device.tools.clone(),
        headers: device.headers.clone(),
        identity: device.identity.clone(),
        network_identity: device.network_identity.clone(),
        manager: device.manager.clone(),
        functions: device.functions.clone(),
        application: device.application.clone(),
        module_objects: device.module_objects.clone(),
        extra: Vec::new(),
    };
    match to_value(&frame) {
        Value::Object(mut map) => {
            map.remove("objects");
            map
        }
        _ => Map::new(),
    }
}

/// The sections that the model does not know: those that differ where both devices have as many, else all as one text,
/// because the JSON of a short section takes a hundred times its memory.
fn diff_extra(path: &mut String, left: &Device, right: &Device, found: &mut dyn FnMut(DatumDifference)) {
    const MAX_SINGLE: usize = 1000;
    let (left, right) = (sorted_extra(left), sorted_extra(right));
    let differs = |(left, right): &(&&ExtraSection, &&ExtraSection)| left != right;
    let differing = || left.iter().zip(&right).enumerate().filter(|(_, pair)| differs(pair));
    path.push_str("/extra");
    if left.len() == right.len() && differing().count() <= MAX_SINGLE {
        for (position, (left, right)) in differing() {
            let (left, right) = (to_value(left), to_value(right));
            step(path, &position.to_string(), |path| diff(path, Some(left), Some(right), found));
        }
    } else {
        let text =
            |sections: &[&ExtraSection]| (!sections.is_empty()).then(|| sections::print(sections).into());
        found(DatumDifference { path: path.clone(), left: text(&left), right: text(&right) });
    }
    path.truncate(path.len() - "/extra".len());
}

/// The sections that the model does not know in an order, so that paths into them mean the same in two devices.
fn sorted_extra(device: &Device) -> Vec<&ExtraSection> {
    let mut sections: Vec<&ExtraSection> = device.extra.iter().collect();
    sections.sort_by_key(|section| section.name());
    sections
}

/// The JSON of a part of the model, which always has one: its keys are texts.
fn to_value(part: &impl Serialize) -> Value {
    serde_json::to_value(part).unwrap_or_default()
}

/// Takes the values, because a copy of a large one takes much memory.
fn diff(
    path: &mut String,
    left: Option<Value>,
    right: Option<Value>,
    found: &mut dyn FnMut(DatumDifference),
) {
    match (left, right) {
        (left, right) if left == right => {}
        (Some(Value::Object(left)), Some(Value::Object(right))) => diff_maps(path, left, right, found),
        // of lists of one length, the items that differ; of others the items cannot be matched
        (Some(Value::Array(left)), Some(Value::Array(right))) if left.len() == right.len() => {
            for (position, (left, right)) in left.into_iter().zip(right).enumerate() {
                step(path, &position.to_string(), |path| diff(path, Some(left), Some(right), found));
            }
        }
        (left, right) => found(DatumDifference { path: path.clone(), left, right }),
    }
}

fn diff_maps(
    path: &mut String,
    left: Map<String, Value>,
    mut right: Map<String, Value>,
    found: &mut dyn FnMut(DatumDifference),
) {
    for (key, value) in left {
        let other = right.remove(&key);
        step(path, &key, |path| diff(path, Some(value), other, found));
    }
    for (key, value) in right {
        step(path, &key, |path| diff(path, None, Some(value), found));
    }
}

fn step(path: &mut String, key: &str, visit: impl FnOnce(&mut String)) {
    let length = path.len();
    path.push('/');
    path.push_str(&key.replace('~', "~0").replace('/', "~1"));
    visit(path);
    path.truncate(length);
}
