//! Equal if and only if built equal: `diff` has no change between two descriptions exactly if everything that is generated and
//! converted of both is the same, but for names, comments, dates, authors and versions of files, spelling and order. Each datum of
//! the fixtures is changed in turn, in JSON.

use std::collections::BTreeMap;
use std::env;
use std::path::{Path, PathBuf};

use objdict::format::{self, Format, WriteOptions, json};
use objdict::generate::{self, Options, Target};
use objdict::lint::changes::compare;
use objdict::model::{Device, FileInfo, Object};
use objdict::source::{SourceFile, SourceOptions};
use serde_json::Value;

use crate::support;
use crate::support::skips::{sample, samples_all, say, skip};

/// An edit of a JSON document: its path, and what is there then; `None` for nothing.
type Edit = (String, Option<Value>);

fn edits(value: &Value, path: &str, found: &mut Vec<Edit>) {
    let mut set = |value: Value| found.push((path.to_owned(), Some(value)));
    match value {
        Value::Bool(is) => set(Value::Bool(!is)),
        Value::Number(number) => {
            let next = number.as_i64().and_then(|number| number.checked_add(1)).map(Value::from);
            set(next.unwrap_or_else(|| Value::from(number.as_f64().unwrap_or_default() + 1.0)));
        }
        Value::String(text) => {
            set(Value::String(format!("{text}x")));
            // words and hex numbers
            let end = text.char_indices().next_back().map_or(0, |(at, _)| at);
            ["1", "2"].iter().for_each(|digit| set(Value::String(format!("{}{digit}", &text[..end]))));
            for word in ["ro", "rw", "wo", "const", "rwr", "rww", "no", "optional", "var", "record"] {
                set(Value::String(word.into()));
            }
        }
        _ => {}
    }
    let escaped = |key: &str| key.replace('~', "~0").replace('/', "~1");
    let parts: Vec<(String, &Value)> = match value {
        Value::Object(map) => map.iter().map(|(key, value)| (escaped(key), value)).collect(),
        Value::Array(items) => items.iter().enumerate().map(|(at, item)| (at.to_string(), item)).collect(),
        _ => Vec::new(),
    };
    for (key, part) in parts {
        let path = format!("{path}/{key}");
        edits(part, &path, found);
        found.push((path, None));
    }
}

fn edited(device: &Value, (path, value): &Edit) -> Option<Device> {
    let mut device = device.clone();
    let (parent, key) = path.rsplit_once('/')?;
    let key = key.replace("~1", "/").replace("~0", "~");
    match (device.pointer_mut(parent)?, value) {
        (Value::Object(map), Some(value)) => _ = map.insert(key, value.clone()),
        (Value::Object(map), None) => _ = map.remove(&key),
        (Value::Array(items), Some(value)) => items[key.parse::<usize>().ok()?] = value.clone(),
        (Value::Array(items), None) => _ = items.remove(key.parse().ok()?),
        _ => return None,
    }
    serde_json::from_value(device).ok()
}

/// Everything that is made of a device, by name.
fn outputs(device: &Device) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let device = nameless(device);
    for target in Target::all() {
        match generate::generate(&device, target, &Options::default()) {
            Ok(made) => {
                files.extend(
                    made.files
                        .into_iter()
                        .map(|file| (format!("{}/{}", target.name(), file.path), file.contents)),
                );
            }
            Err(error) => _ = files.insert(target.name().to_owned(), error.to_string().into_bytes()),
        }
    }
    let device = spelled(&device);
    for format in [Format::Eds, Format::Dcf, Format::Xdd, Format::Xdc, Format::Toml] {
        let written = format::write(&device, format, &WriteOptions::default()).map(|written| written.bytes);
        files
            .insert(format.name().to_owned(), written.unwrap_or_else(|error| error.to_string().into_bytes()));
    }
    files.insert("JSON".to_owned(), json::write_device(&device).into_bytes());
    files
}

/// The device without names, comments, dates, authors and versions of files.
fn nameless(device: &Device) -> Device {
    let mut device = Device { comments: None, ..device.clone() };
    let info = device.file_info.take().unwrap_or_default();
    let FileInfo { languages, device_class, extra, invalid_values, .. } = info;
    device.file_info =
        Some(FileInfo { languages, device_class, extra, invalid_values, ..FileInfo::default() });
    let headers = &mut device.headers;
    headers.network_file = None;
    [&mut headers.device, &mut headers.network].into_iter().flatten().for_each(|header| header.date = None);
    let modules = device.modules.iter_mut().flat_map(|modules| modules.supported.values_mut());
    modules.for_each(|module| module.comments.clear());
    device
}

/// The device in one spelling.
fn spelled(device: &Device) -> Device {
    let mut device = device.clone();
    for list in [&mut device.lists.mandatory, &mut device.lists.optional, &mut device.lists.manufacturer] {
        let mut members = list.take().unwrap_or_default();
        members.sort_unstable();
        members.dedup();
        *list = Some(members);
    }
    if let Some(modules) = &mut device.modules {
        modules.declared = None;
    }
    for (_, object) in device.objects.iter_mut() {
        drop_implied(object);
        // one that follows from the sub-indexes
        let described = object.subs.iter().filter(|(sub, _)| *sub != 0xFF).count();
        let is_compact = object.compact.is_some();
        object.sub_number.take_if(|number| usize::from(*number) == described || *number == 0 && is_compact);
    }
    device
}

/// Removes the sub-indexes that a compact object states as they follow from it.
fn drop_implied(object: &mut Object) {
    let stated: Vec<u8> =
        object.subs.iter().map(|(sub, _)| sub).filter(|_| object.compact.is_some()).collect();
    for sub in stated {
        let mut without = object.clone();
        let entry = without.subs.remove(sub);
        if entry.as_ref() == without.expanded().subs.get(sub) {
            *object = without;
        }
    }
}

/// So many edits of a device are tried, and with all samples every edit of its parts.
const EDITS: usize = 100;

/// So many objects a part of a device has: an edit takes as long as its device is large.
const OBJECTS: usize = 4;

/// The device with few objects at a time.
fn parts(device: &Device) -> Vec<Device> {
    let indexes: Vec<u16> = device.objects.keys().copied().collect();
    let part = |kept: &[u16]| {
        let mut part = device.clone();
        part.objects.retain(|index, _| kept.contains(index));
        part
    };
    indexes.chunks(OBJECTS).map(part).collect()
}

/// A device in which an edit is made, with all that is made of it before.
struct Edited<'a> {
    device: &'a Device,
    document: Value,
    json: String,
    outputs: BTreeMap<String, Vec<u8>>,
}

impl<'a> Edited<'a> {
    fn new(device: &'a Device) -> Self {
        assert_eq!(compare(device, device).len(), 0);
        let document = serde_json::to_value(device).unwrap();
        Self { device, document, json: plain(device), outputs: outputs(device) }
    }

    /// What is wrong with the verdict about an edit; `None` if the edit makes no other device.
    fn wrong(&self, edit: &Edit) -> Option<Option<String>> {
        let other = edited(&self.document, edit).filter(|other| other != self.device)?;
        let changes = compare(self.device, &other);
        // most changes are in JSON, which is made fast
        let is_same = self.json == plain(&other) && self.outputs == outputs(&other);
        if changes.is_empty() != is_same {
            let after = outputs(&other);
            let differ = self.outputs.iter().find(|(name, bytes)| after.get(*name) != Some(bytes));
            let name = differ.map_or("nothing", |(name, _)| name);
            let value = edit.1.as_ref().map_or("removed".to_owned(), ToString::to_string);
            let found: Vec<_> = changes.iter().map(|change| change.message.to_string()).collect();
            return Some(Some(format!("{} {value}: {found:?}, and {name} differs", edit.0)));
        }
        Some(None)
    }
}

/// The device as JSON in one spelling.
fn plain(device: &Device) -> String {
    json::write_device(&spelled(&nameless(device)))
}

/// Tries edits of devices. Each failure is said when it is found.
fn try_edits(files: Vec<PathBuf>) {
    let (mut tried, mut wrong) = (0, 0);
    for (number, path) in sample(files).into_iter().enumerate() {
        let Ok(description) = format::open(&path, &SourceOptions::default()) else { continue };
        let device = description.device();
        let parts = if samples_all() { parts(device) } else { Vec::new() };
        for (at, part) in parts.iter().chain([device]).enumerate() {
            let edited = Edited::new(part);
            let mut all = Vec::new();
            edits(&edited.document, "", &mut all);
            let is_whole = at == parts.len();
            let step = if is_whole { all.len().div_ceil(EDITS) } else { 1 };
            // what is beside the objects is the same in all parts
            let is_new = |(path, _): &&Edit| is_whole || at == 0 || path.starts_with("/objects/");
            for edit in all.iter().filter(is_new).skip(number % step).step_by(step) {
                let Some(verdict) = edited.wrong(edit) else { continue };
                tried += 1;
                if let Some(text) = verdict {
                    wrong += 1;
                    say(format!("{}: {text}", path.display()));
                }
            }
        }
        if samples_all() {
            say(format!("{tried} edits up to {}", path.display()));
        }
    }
    assert_eq!(wrong, 0, "of {tried} edits, which are above");
    assert!(tried > 50, "{tried}");
}

fn fixtures(folders: &[&str]) -> Vec<PathBuf> {
    let endings = ["eds", "dcf", "xdd", "xdc", "toml", "od"];
    folders.iter().flat_map(|folder| support::files(folder, &endings)).collect()
}

#[test]
fn eds_without_a_change_are_built_equal() {
    try_edits(fixtures(&["eds"]));
}

#[test]
fn dcf_without_a_change_are_built_equal() {
    try_edits(fixtures(&["dcf"]));
}

#[test]
fn xdd_and_xdc_without_a_change_are_built_equal() {
    try_edits(fixtures(&["xdd", "xdc"]));
}

#[test]
fn other_devices_without_a_change_are_built_equal() {
    try_edits(fixtures(&["bases", "toml"]));
}

#[test]
fn devices_of_the_corpus_without_a_change_are_built_equal() {
    match env::var_os("OBJDICT_CORPUS_DIR") {
        Some(corpus) => try_edits(support::files_below(Path::new(&corpus), &["eds", "dcf", "xdd", "xdc"])),
        None => skip("`OBJDICT_CORPUS_DIR` names no folder"),
    }
}

/// What follows from `CompactSubObj` is the same device, stated or not.
#[test]
fn an_implied_sub_index_may_be_stated() {
    let compact = "[ManufacturerObjects]\nSupportedObjects=1\n1=0x2000\n[2000]\nParameterName=Inputs\nObjectType=8\nDataType=5\n\
        AccessType=ro\nDefaultValue=3\nPDOMapping=1\nCompactSubObj=2\n";
    let read = |text: &str| format::read(SourceFile::from_text("a.eds", text), Format::Eds).into_device();
    let implied = read(compact);
    for (stated, is_same) in [
        (
            "[2000sub0]\nParameterName=NrOfObjects\nObjectType=7\nDataType=5\nAccessType=ro\nDefaultValue=2\nPDOMapping=0\n",
            true,
        ),
        (
            "[2000sub1]\nParameterName=Inputs1\nObjectType=7\nDataType=5\nAccessType=ro\nDefaultValue=3\nPDOMapping=1\n",
            true,
        ),
        (
            "[2000sub1]\nParameterName=Inputs1\nObjectType=7\nDataType=5\nAccessType=ro\nDefaultValue=4\nPDOMapping=1\n",
            false,
        ),
    ] {
        let stated = read(&format!("{compact}{stated}"));
        assert_eq!(compare(&implied, &stated).is_empty(), is_same);
        assert_eq!(outputs(&implied) == outputs(&stated), is_same);
    }
}
