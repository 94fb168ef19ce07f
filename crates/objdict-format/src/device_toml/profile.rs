//! The profile of a device: all its requirements, before the device's own keys.

use std::collections::BTreeSet;

use serde_json::Value;

use super::facts::{self, Implied};
use super::keys::{DEVICE, features};
use super::words::{index, quoted, sub};
use crate::scaffold::{self, FEATURES, FeatureValue, Features};
use objdict_keyed::rules::{UNKNOWN_PROFILE, WRONG_TYPE};
use objdict_keyed::section::{KeyedTable, Shape};
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::{Diagnostic, Findings, say};
use objdict_model::model::{DataType, Device, DeviceInfo, Object};

/// The profile of a device with its version and features.
#[derive(Clone, Debug)]
pub(super) struct ProfileSaid {
    pub(super) profile: u16,
    pub(super) version: u16,
    pub(super) features: Features,
}

impl ProfileSaid {
    /// The profile and features closest to a device.
    pub(super) fn of(device: &Device) -> Option<Self> {
        let (profile, inferred) = scaffold::infer(device);
        let mut features = Features::default();
        for feature in FEATURES {
            if let Some(value) = inferred.get(feature.word) {
                // values that a file cannot state keep their defaults
                let _ = features.set(feature.word, &value);
            }
        }
        Some(Self { profile, version: scaffold::newest_version(profile)?, features })
    }

    /// The device with all required objects.
    pub(super) fn base(&self) -> Option<Device> {
        scaffold::base(self.profile, self.version, &self.features).ok()
    }

    /// The lines of the file.
    pub(super) fn line(&self) -> String {
        format!("profile = \"{}@{}\"\n", self.profile, self.version)
    }

    pub(super) fn feature_lines(&self) -> Vec<String> {
        let value = |value| match value {
            FeatureValue::Flag(flag) => flag.to_string(),
            FeatureValue::Number(number) => number.to_string(),
            FeatureValue::Name(name) => quoted(&name),
            FeatureValue::Names(names) => {
                format!("[{}]", names.iter().map(|name| quoted(name)).collect::<Vec<_>>().join(", "))
            }
        };
        let stated =
            FEATURES.iter().filter_map(|feature| Some((feature.word, self.features.get(feature.word)?)));
        stated.map(|(word, stated)| format!("{word} = {}", value(stated))).collect()
    }
}

/// Reads `profile` and `features` into the device that they require; an empty one without a profile.
pub(super) fn read(root: &KeyedTable<'_>, findings: &mut Findings) -> Option<Device> {
    let said = root.text("profile", findings)?;
    let numbers = said
        .value
        .split_once('@')
        .and_then(|(profile, version)| Some((profile.parse().ok()?, version.parse().ok()?)));
    let Some((profile, version)) = numbers else {
        let finding = Diagnostic::new(
            &UNKNOWN_PROFILE,
            said.at,
            say!("`{}` is not a profile with a version", said.value),
        );
        findings
            .push(finding.help("write the number of the profile and the version of its data, as in `402@1`"));
        return None;
    };
    let features = read_features(root, findings);
    match scaffold::base(profile, version, &features) {
        Ok(device) => Some(device),
        Err(error) => {
            let finding = Diagnostic::new(&UNKNOWN_PROFILE, said.at, say!("{}", error.to_string()));
            findings.push(finding.help(error.help()));
            None
        }
    }
}

fn read_features(root: &KeyedTable<'_>, findings: &mut Findings) -> Features {
    let mut read = Features::default();
    let section =
        root.get("features").and_then(|tree| KeyedTable::new("features", tree, features(), findings));
    let Some(section) = section else { return read };
    for key in features() {
        let Some(tree) = section.get(key.name) else { continue };
        let value = match key.shape {
            Shape::Flag => section.flag(key.name, findings).map(|flag| FeatureValue::Flag(flag.value)),
            Shape::Integer(..) => {
                section.integer(key.name, findings).map(|number| FeatureValue::Number(number.value))
            }
            Shape::Word(_) => section.word(key.name, findings).map(|word| FeatureValue::Name(word.value)),
            _ => {
                let texts = section.texts(key.name, findings).into_iter();
                Some(FeatureValue::Names(texts.map(|text| text.value.to_owned()).collect()))
            }
        };
        let set = value.map(|value| read.set(key.name, &value));
        if let Some(Err(error)) = set {
            let finding = Diagnostic::new(&WRONG_TYPE, tree.span, say!("{}", error.to_string()));
            findings.push(finding.help("write a value that the feature accepts"));
        }
    }
    read
}

/// The implied values of `[device]`: from a profile, otherwise those of most devices.
pub(super) fn implied_device(base: Option<&DeviceInfo>, device: &Device) -> Vec<Implied> {
    let count = |kind: objdict_model::model::PdoKind| u16::try_from(device.pdo_count(kind)).unwrap_or(512);
    let counts = [count(objdict_model::model::PdoKind::Rpdo), count(objdict_model::model::PdoKind::Tpdo)];
    let Some(base) = base else { return facts::implied_device(counts[0], counts[1]) };
    let Ok(Value::Object(fields)) = serde_json::to_value(base) else { return Vec::new() };
    let implied = DEVICE.iter().filter_map(|key| {
        let value = match key.name {
            "rpdo-count" => counts[0].into(),
            "tpdo-count" => counts[1].into(),
            "granularity" => implied_granularity(base.granularity, counts)?.into(),
            name => fields.get(&facts::field(name))?.clone(),
        };
        Some((key.name, value))
    });
    implied.collect()
}

/// The granularity without a key: in bytes if a device has PDOs in addition to its profile's.
pub(super) fn implied_granularity(of_profile: Option<u8>, pdo_counts: [u16; 2]) -> Option<u8> {
    if of_profile == Some(0) && pdo_counts != [0, 0] { Some(8) } else { of_profile }
}

/// Removes objects that the device does not have; they may already be removed, or missing in the profile.
pub(super) fn remove(
    root: &KeyedTable<'_>,
    taken: &BTreeSet<String>,
    device: &mut Device,
    findings: &mut Findings,
) {
    let Some(tree) = root.get("remove") else { return };
    let mut take =
        |at: &KeyedTree| {
            let text = at.spelled();
            if !take_away(&text, device) && !taken.contains(&text.to_ascii_uppercase()) {
                let message = say!("`{}` cannot be removed: the profile does not contain it", text);
                let finding = Diagnostic::new(&WRONG_TYPE, at.span, message);
                findings.push(finding.help(
                    "write the address of an object or an entry of the profile, as in `1006` or `1018:4`",
                ));
            }
        };
    match &*tree.kind {
        Kind::List(items) => items.iter().for_each(&mut take),
        Kind::Map(entries) => entries.iter().for_each(|entry| take(&entry.key)),
        _ => take(tree),
    }
}

fn take_away(text: &str, device: &mut Device) -> bool {
    match text.split_once(':') {
        None => index(text).is_some_and(|index| device.objects.remove(&index).is_some()),
        Some((object, entry)) => {
            let Some((index, sub)) = index(object).zip(sub(entry)) else { return false };
            let Some(object) = device.objects.get_mut(&index) else { return false };
            let highest = object.highest_sub();
            let is_there = object.subs.remove(sub).is_some();
            recount(object, highest);
            is_there
        }
    }
}

/// Updates the sub-index counts of an object after its sub-indexes have changed.
fn recount(object: &mut Object, highest_before: Option<u8>) {
    let highest = object.highest_sub();
    if let Some(entry) = object.subs.get_mut(0).filter(|_| highest != highest_before) {
        let data_type = entry.data_type.unwrap_or(DataType::UNSIGNED8);
        entry.default =
            highest.and_then(|highest| objdict_model::model::Value::from_integer(highest.into(), data_type));
    }
    let count = object.subs.iter().filter(|(sub, _)| *sub != 0xFF).count();
    object.sub_number = object.sub_number.and(u8::try_from(count).ok());
}

/// Removes profile content that a device does not have; returns the addresses.
pub(super) fn take_absent(base: &mut Device, device: &Device) -> Vec<String> {
    let mut absent = Vec::new();
    for (&index, object) in &base.objects {
        let Some(own) = device.object(index) else {
            absent.push(format!("{index:04X}"));
            continue;
        };
        let subs = object.subs.iter().filter(|(sub, _)| own.subs.get(*sub).is_none());
        absent.extend(subs.map(|(sub, _)| format!("{index:04X}:{sub:X}")));
    }
    for address in &absent {
        take_away(address, base);
    }
    absent
}
