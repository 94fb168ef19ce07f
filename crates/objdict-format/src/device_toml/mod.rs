//! `device.toml`: a compact device description without derivable content (docs/reference/device.md).

mod defaults;
pub(super) mod document;
mod edits;
mod extends;
mod facts;
pub mod keys;
pub(crate) mod meaning;
mod mentions;
mod merge;
mod objects;
mod pdos;
mod places;
mod profile;
mod raw;
mod reader;
mod start;
mod usual;
mod variants;
pub mod wording;
pub(crate) mod words;
mod writer;

use self::defaults::Defaults;
use self::extends::Base;
pub use self::keys::schema;
use self::keys::{DEVICE, FILE, LISTS, NODE};
use self::merge::Merged;
use self::profile::ProfileSaid;
use self::reader::ObjectReader;
pub use self::start::new_device_toml;
use crate::compare::each_difference;
use crate::scaffold;
use objdict_keyed::section::{self, KeyedTable};
use objdict_keyed::toml;
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::Findings;
use objdict_model::model::{
    ApplicationProcess, Device, DeviceInfo, DeviceKind, DummyUsage, Extra, ExtraSection, Object, ObjectLists,
    PdoKind,
};
use objdict_model::source::EditError;

/// The device of a text that extends no file.
pub(super) fn read(text: &str) -> (Device, Findings) {
    let mut findings = Findings::new();
    let device = read_on(text, None, &mut findings);
    (device, findings)
}

/// The device of a text, based on the file that it extends.
fn read_on(text: &str, base: Option<&Base>, findings: &mut Findings) -> Device {
    let merged = merged(text, base, None, findings);
    merged.map_or_else(Device::default, |merged| {
        variants::check_product_codes(&merged.tree, findings);
        of_tree(&merged, findings)
    })
}

/// The device of a variant in a text.
fn read_variant(text: &str, base: Option<&Base>, variant: &str) -> (Device, Findings) {
    let mut findings = Findings::new();
    let Some(merged) = merged(text, base, Some(variant), &mut findings) else {
        return (Device::default(), findings);
    };
    let mut device = of_tree(&merged, &mut findings);
    variants::name_file(&merged.tree, variant, &mut device);
    (device, findings)
}

/// The tree of a text, or of a variant in it, merged over the file that the text extends.
fn merged(text: &str, base: Option<&Base>, variant: Option<&str>, findings: &mut Findings) -> Option<Merged> {
    let tree = toml::read(text, findings)?;
    let own = match base {
        None => Merged::new(tree),
        Some(base) => base.merged.clone().with(&tree),
    };
    Some(match variant {
        None => own,
        Some(variant) => variants::merged(own, variant, findings),
    })
}

/// The names of the variants in a text.
fn variants_of(text: &str) -> Vec<String> {
    toml::read(text, &mut Findings::new()).map(|tree| variants::names(&tree)).unwrap_or_default()
}

/// The device of a tree.
fn of_tree(merged: &Merged, findings: &mut Findings) -> Device {
    let Some(root) = KeyedTable::new("device.toml", &merged.tree, keys::root(), findings) else {
        return Device::default();
    };
    if let Some(format) = root.required("device.toml", "format", findings).and(root.word("format", findings))
    {
        debug_assert_eq!(format.value, keys::FORMAT);
    }
    variants::check(&root, findings);
    let base = profile::read(&root, findings);
    let info = base.as_ref().and_then(|base| base.device_info.clone());
    let mut device = base.unwrap_or_default();
    device.lists = ObjectLists::default();
    frame(&root, &mut device, info.as_ref(), findings);
    if info.is_some() {
        scaffold::identify(&mut device);
    }
    profile::remove(&root, &merged.taken, &mut device, findings);
    read_objects(&root, &mut device, findings);
    count_pdos(&root, &mut device);
    device.lists = read_lists(&root, &device, findings);
    raw::read(&root, &mut device, findings);
    section::check("device.toml", &merged.tree, keys::of_one_device(), findings);
    device
}

/// A reader of objects, with the defaults of the text.
fn reader<'f>(root: &KeyedTable<'_>, findings: &'f mut Findings) -> ObjectReader<'f> {
    let application = ApplicationProcess::default();
    let mut reader = ObjectReader { defaults: Defaults::default(), findings, application, ranged: 0 };
    if let Some(tree) = root.get("defaults") {
        reader.read_defaults(tree);
    }
    reader
}

/// Returns a writer for an object that a text lacks, as a line of the table `object` of a `device.toml`;
/// `None` if the text is not one.
pub fn object_writer(text: &str) -> Option<impl Fn(u16, &Object) -> String> {
    let mut findings = Findings::new();
    let tree = merged(text, None, None, &mut findings)?.tree;
    let root = KeyedTable::new("device.toml", &tree, keys::root(), &mut findings)?;
    let defaults = reader(&root, &mut findings).defaults;
    Some(move |index, object: &Object| {
        let mut line = String::new();
        objects::ObjectWriter { device: &Device::default(), defaults: defaults.clone(), base: None }
            .object(index, object, None, &mut line);
        line
    })
}

/// Reads the objects; PDOs are read after their mapped objects.
fn read_objects(root: &KeyedTable<'_>, device: &mut Device, findings: &mut Findings) {
    let mut reader = reader(root, findings);
    let tree = root.get("object");
    if let Some(tree) = tree {
        reader.read_objects(tree, &mut device.objects, |index| !pdos::is_pdo(index));
    }
    for kind in [PdoKind::Rpdo, PdoKind::Tpdo] {
        pdos::read(root, kind, device, reader.findings);
    }
    if let Some(tree) = tree {
        reader.read_objects(tree, &mut device.objects, pdos::is_pdo);
    }
    if reader.application != ApplicationProcess::default() {
        device.application.push(reader.application);
    }
}

/// The final numbers of PDOs of the device, if no key states them.
fn count_pdos(root: &KeyedTable<'_>, device: &mut Device) {
    let section = root.get("device");
    let is_stated = |key: &str| {
        let unstated = section.and_then(|section| section.get("unstated"));
        section.is_some_and(|section| section.get(key).is_some())
            || unstated.is_some_and(|unstated| reader::names(unstated, key))
    };
    let count = |kind| u16::try_from(device.pdo_count(kind)).unwrap_or(PdoKind::MAX);
    let counts = (count(PdoKind::Rpdo), count(PdoKind::Tpdo));
    let Some(info) = &mut device.device_info else { return };
    if !is_stated("rpdo-count") {
        info.rpdo_count = Some(counts.0);
    }
    if !is_stated("tpdo-count") {
        info.tpdo_count = Some(counts.1);
    }
    if !is_stated("granularity") {
        info.granularity = profile::implied_granularity(info.granularity, [counts.0, counts.1]);
    }
}

/// The parts about file, device and node.
fn frame(root: &KeyedTable<'_>, device: &mut Device, base: Option<&DeviceInfo>, findings: &mut Findings) {
    let unstated: Vec<String> =
        root.texts("unstated", findings).into_iter().map(|text| text.value.to_owned()).collect();
    let is_stated = |name: &str| !unstated.iter().any(|word| word == name);
    let section = |name: &str, keys, findings: &mut Findings| {
        root.get(name).and_then(|tree| KeyedTable::new(name, tree, keys, findings))
    };
    let file = section("file", FILE, findings);
    if is_stated("file") {
        device.file_info = Some(facts::read(file.as_ref(), FILE, &facts::implied_file(), findings));
    }
    let about = section("device", DEVICE, findings);
    device.device_info = None;
    if is_stated("device") {
        let implied = profile::implied_device(base, device);
        device.device_info = Some(facts::read(about.as_ref(), DEVICE, &implied, findings));
    }
    if let Some(node) = section("node", NODE, findings) {
        device.commissioning = Some(facts::read(Some(&node), NODE, &[], findings));
        device.kind = DeviceKind::Node;
    }
    if let Some(kind) = root.word("kind", findings) {
        device.kind = if kind.value == "node" { DeviceKind::Node } else { DeviceKind::Type };
    }
    device.dummy_usage = device.dummy_usage.take().filter(|_| is_stated("dummies"));
    let expected = ["a list of data types", "write words of data types, as in `u8 u16 u32`"];
    if let Some(dummies) = root.parsed("dummies", words::dummies, expected, findings) {
        device.dummy_usage = Some(DummyUsage { types: dummies.value, ..DummyUsage::default() });
    }
    device.comments = match root.get("comments") {
        None => device.comments.take().filter(|_| is_stated("comments")),
        Some(tree) => Some(match &*tree.kind {
            Kind::List(items) => items.iter().map(KeyedTree::spelled).collect(),
            _ => tree.spelled().split('\n').map(str::to_owned).collect(),
        }),
    };
    device.extra = extra(root, findings);
}

/// Non-CiA sections; a list if several have the same name.
fn extra(root: &KeyedTable<'_>, findings: &mut Findings) -> Vec<ExtraSection> {
    let section = |name: &str, entries: &KeyedTree| {
        let entries: Extra = serde_json::from_str(&facts::pairs(entries).to_string()).unwrap_or_default();
        ExtraSection::new(name, &entries)
    };
    if let Some(Kind::List(items)) = root.get("extra").map(|tree| &*tree.kind) {
        let named = items.iter().filter_map(|item| match &*item.kind {
            Kind::List(pair) => Some((pair.first()?.spelled(), pair.get(1)?)),
            _ => None,
        });
        return named.map(|(name, entries)| section(&name, entries)).collect();
    }
    let named = root.named("extra", findings).iter();
    named.map(|entry| section(&entry.key.spelled(), &entry.value)).collect()
}

fn read_lists(root: &KeyedTable<'_>, device: &Device, findings: &mut Findings) -> ObjectLists {
    let mut read = words::implied(device);
    let section = root.get("lists").and_then(|tree| KeyedTable::new("lists", tree, LISTS, findings));
    let Some(section) = section else { return read };
    let unstated: Vec<String> =
        section.texts("unstated", findings).into_iter().map(|text| text.value.to_owned()).collect();
    for (list, name) in words::NAMES {
        if unstated.iter().any(|word| word == name) {
            *read.get_mut(list) = None;
        }
        let listed = section.parsed(name, words::indexes, words::NO_INDEXES, findings);
        if let Some(listed) = listed {
            *read.get_mut(list) = Some(listed.value);
        }
    }
    read
}

/// The complete text of a device. Content without a key is detected and written as `[raw]`.
///
/// # Errors
/// If more values have no key than allowed.
pub(super) fn write(device: &Device, max_raw: usize) -> Result<String, EditError> {
    let profile = ProfileSaid::of(device);
    let with_profile = profile.as_ref().and_then(|profile| Some((profile, profile.base()?)));
    let mut texts = Vec::new();
    if let Some((profile, base)) = &with_profile {
        let forms = [true, false];
        texts.extend(forms.map(|with_pdos| writer::write(device, Some((profile, base)), with_pdos)));
    }
    texts.push(writer::write(device, None, false));
    let mut shortest: Option<String> = None;
    let length = |text: &str| text.lines().filter(|line| !line.is_empty()).count();
    for mut text in texts {
        let (read, _) = read(&text);
        let mut missing = Vec::new();
        each_difference(&read, device, max_raw, &mut |difference| missing.push(difference))
            .map_err(|found| EditError::TooMuchLost { count: found.count, limit: found.limit })?;
        raw::write(&missing, &mut text);
        if shortest.as_ref().is_none_or(|shortest| length(&text) < length(shortest)) {
            shortest = Some(text);
        }
    }
    Ok(shortest.unwrap_or_default())
}
