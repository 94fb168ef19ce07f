//! Converts a device to text: each part in its short notation, if possible.

use super::facts::{self, Implied};
use super::keys::{DEVICE, FILE, FORMAT, NODE};
use super::objects::ObjectWriter;
use super::pdos::{PdoSaid, Standard};
use super::profile::{ProfileSaid, implied_device, take_absent};
use super::usual::{usual, write_defaults};
use super::words::{self, key, push, quoted, words};
use crate::scaffold;
use objdict_model::model::{Device, DeviceKind, ExtraSection, PdoKind};

/// Writes a device, without content that has no keys; optionally as differences from the device that a profile
/// requires, and with PDO tables.
pub(super) fn write(device: &Device, profile: Option<(&ProfileSaid, &Device)>, with_pdos: bool) -> String {
    let mut text = format!("format = {}\n", quoted(FORMAT));
    let mut base = profile.map(|(_, base)| base.clone());
    let info = base.as_ref().and_then(|base| base.device_info.clone());
    if let Some(base) = &mut base {
        base.device_info.clone_from(&device.device_info);
        scaffold::identify(base);
    }
    text.extend(profile.map(|(said, _)| said.line()));
    head(device, base.as_ref(), &mut text);
    section(&mut text, "file", device.file_info.as_ref(), FILE, &facts::implied_file());
    let implied = implied_device(info.as_ref(), device);
    section(&mut text, "device", device.device_info.as_ref(), DEVICE, &implied);
    if let Some(node) = &device.commissioning {
        text.push_str("\n[node]\n");
        facts::lines(node, NODE, &[]).iter().for_each(|line| push(&mut text, line));
    }
    if let Some((said, _)) = profile {
        write_features(said, &mut text);
    }
    let defaults = usual(device);
    write_defaults(&defaults, &mut text);
    words::write(device, &mut text);
    if let Some(base) = &mut base {
        let gone = take_absent(base, device);
        insert_removed(&gone, &mut text);
    }
    if with_pdos && let Some(base) = &mut base {
        write_pdos(device, base, &mut text);
    }
    objects(&ObjectWriter { device, defaults, base: base.as_ref() }, &mut text);
    extra(device, &mut text);
    text
}

/// Writes the features that are stated.
pub(super) fn write_features(said: &ProfileSaid, text: &mut String) {
    let features = said.feature_lines();
    if !features.is_empty() {
        push(text, "\n[features]");
        features.iter().for_each(|line| push(text, line));
    }
}

/// The objects that differ from their state without keys.
fn objects(writer: &ObjectWriter<'_>, text: &mut String) {
    let start = text.len();
    for (&index, object) in &writer.device.objects {
        let base = writer.base.and_then(|base| base.object(index));
        if base != Some(object) {
            writer.object(index, object, base, text);
        }
    }
    if text.len() > start {
        text.insert_str(start, "\n[object]\n");
    }
}

fn insert_removed(removed: &[String], text: &mut String) {
    if !removed.is_empty() {
        let items: Vec<String> = removed.iter().map(|address| quoted(address)).collect();
        insert_before_tables(&format!("remove = [{}]\n", items.join(", ")), text);
    }
}

/// Inserts lines before the first table. No other line begins with a bracket.
pub(super) fn insert_before_tables(lines: &str, text: &mut String) {
    let at = text.find("\n[").map_or(text.len(), |at| at + 1);
    // the empty line before the table remains there
    let at = if at < text.len() && text[..at].ends_with("\n\n") { at - 1 } else { at };
    text.insert_str(at, lines);
}

/// Writes PDO tables, and adds the resulting objects to the base.
fn write_pdos(device: &Device, base: &mut Device, text: &mut String) {
    let mut standard = Standard::default();
    for (kind, name) in [(PdoKind::Rpdo, "rpdo"), (PdoKind::Tpdo, "tpdo")] {
        let numbers = device.pdos().filter(|pdo| pdo.kind == kind).map(|pdo| pdo.number);
        for number in numbers.collect::<Vec<_>>() {
            let Some(said) = PdoSaid::of(device, kind, number) else { continue };
            let least = said.least(kind, number, &base.objects, &mut standard);
            let lines = least.lines(device, kind, number);
            if !lines.is_empty() {
                push(text, &format!("\n[{name}.{number}]"));
                lines.iter().for_each(|line| push(text, line));
                least.apply(kind, number, &mut base.objects, &mut standard);
            }
        }
    }
}

fn head(device: &Device, base: Option<&Device>, text: &mut String) {
    if (device.kind == DeviceKind::Node) != device.commissioning.is_some() {
        let kind = if device.kind == DeviceKind::Node { "node" } else { "type" };
        push(text, &format!("kind = {}", quoted(kind)));
    }
    let mut unstated = Vec::new();
    if device.file_info.is_none() {
        unstated.push("file");
    }
    if device.device_info.is_none() {
        unstated.push("device");
    }
    if device.comments.is_none() && base.is_some_and(|base| base.comments.is_some()) {
        unstated.push("comments");
    }
    if device.dummy_usage.is_none() && base.is_some_and(|base| base.dummy_usage.is_some()) {
        unstated.push("dummies");
    }
    if !unstated.is_empty() {
        push(text, &format!("unstated = [{}]", words(&unstated)));
    }
    let usual = base.and_then(|base| base.dummy_usage.as_ref());
    if let Some(usage) = device.dummy_usage.as_ref().filter(|usage| Some(*usage) != usual) {
        push(text, &format!("dummies = {}", quoted(&words::dummy_words(&usage.types))));
    }
    match device.comments.as_deref() {
        None => {}
        Some([]) if base.is_some() => {}
        Some([]) => push(text, "comments = []"),
        Some([line]) => push(text, &format!("comments = {}", quoted(line))),
        Some(lines) => push(text, &format!("comments = {}", words::several_lines(lines))),
    }
}

pub(super) fn section(
    text: &mut String,
    name: &str,
    part: Option<&impl serde::Serialize>,
    keys: &[objdict_keyed::section::Key],
    implied: &[Implied],
) {
    let Some(part) = part else { return };
    let lines = facts::lines(part, keys, implied);
    if !lines.is_empty() {
        push(text, &format!("\n[{name}]"));
        lines.iter().for_each(|line| push(text, line));
    }
}

fn extra(device: &Device, text: &mut String) {
    let is_table = |section: &ExtraSection| {
        let mut seen = std::collections::BTreeSet::new();
        section.entries().all(|(name, _)| seen.insert(name))
    };
    let mut names = std::collections::BTreeSet::new();
    if !device.extra.iter().all(|section| names.insert(section.name())) {
        // repeated keys are not valid TOML
        let section = |section: &ExtraSection| {
            let entries = facts::table_of_pairs(&section.entries().collect::<Vec<_>>());
            format!("[{}, {entries}]", quoted(section.name()))
        };
        let sections: Vec<String> = device.extra.iter().map(section).collect();
        insert_before_tables(&format!("extra = [\n    {},\n]\n", sections.join(",\n    ")), text);
        return;
    }
    if device.extra.iter().all(is_table) {
        for section in &device.extra {
            push(text, &format!("\n[extra.{}]", key(section.name())));
            section
                .entries()
                .for_each(|(name, value)| push(text, &format!("{} = {}", key(name), quoted(value))));
        }
        return;
    }
    // in one table, because a list cannot follow the table of another section
    text.push_str("\n[extra]\n");
    for section in &device.extra {
        push(
            text,
            &format!(
                "{} = {}",
                key(section.name()),
                facts::table_of_pairs(&section.entries().collect::<Vec<_>>())
            ),
        );
    }
}
