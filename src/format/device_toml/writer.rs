//! From a device to the text: the short form of each part, where it has one.

use std::collections::BTreeMap;

use super::defaults::{Defaults, Omission, Omissions, Role};
use super::facts::{self, Implied};
use super::keys::{DEVICE, FILE, FORMAT, NODE};
use super::reader::{numbered, sub_number, without};
use super::words::{TypeSaid, index_list, key, quoted, spelled, type_word};
use super::pdos::{PdoSaid, Standard};
use super::profile::{ProfileSaid, implied_device, take_absent};
use super::{lists, meaning};
use crate::model::{
    Compact, DataType, Device, DeviceKind, Entry, ExtraSection, Object, ObjectType, PdoKind, PdoMapping, TypeKind,
    Value,
};
use crate::scaffold;

/// An object that fits into a line of so many characters is one.
const LINE: usize = 110;

/// So many sub-indexes with values of their own are in a line.
const MAX_RANGE: usize = 16;

type Pair = (String, String);

/// Writes a device, without what it has no keys for: as what is different from the device that a profile demands, and with
/// tables of its PDOs, where that is asked for.
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
    let features = profile.map_or_else(Vec::new, |(said, _)| said.feature_lines());
    if !features.is_empty() {
        push(&mut text, "\n[features]");
        features.iter().for_each(|line| push(&mut text, line));
    }
    let defaults = usual(device);
    write_defaults(&defaults, &mut text);
    lists::write(device, &mut text);
    if let Some(base) = &mut base {
        let gone = take_absent(base, device);
        insert_removed(&gone, &mut text);
    }
    if with_pdos && let Some(base) = &mut base {
        write_pdos(device, base, &mut text);
    }
    objects(Writer { device, defaults, base: base.as_ref() }, &mut text);
    extra(device, &mut text);
    text
}

/// The objects that are not as they would be without a key.
fn objects(writer: Writer<'_>, text: &mut String) {
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
    if removed.is_empty() {
        return;
    }
    let items: Vec<String> = removed.iter().map(|address| quoted(address)).collect();
    let at = text.find("\n[").map_or(text.len(), |at| at + 1);
    let at = if at < text.len() && text[..at].ends_with("\n\n") { at - 1 } else { at };
    text.insert_str(at, &format!("remove = [{}]\n", items.join(", ")));
}

/// Writes tables of PDOs, and makes the objects in the base those that they say.
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

fn push(text: &mut String, line: &str) {
    text.push_str(line);
    text.push('\n');
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
        push(text, &format!("dummies = {}", quoted(&lists::dummy_words(&usage.types))));
    }
    match device.comments.as_deref() {
        None => {}
        Some([]) if base.is_some() => {}
        Some([]) => push(text, "comments = []"),
        Some([line]) => push(text, &format!("comments = {}", quoted(line))),
        Some(lines) => push(text, &format!("comments = {}", lists::several_lines(lines))),
    }
}

fn words(words: &[&str]) -> String {
    words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(", ")
}

fn section(
    text: &mut String,
    name: &str,
    part: Option<&impl serde::Serialize>,
    keys: &[crate::format::keyed::section::Key],
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
        // equal keys are no TOML
        return;
    }
    if device.extra.iter().all(is_table) {
        for section in &device.extra {
            push(text, &format!("\n[extra.{}]", key(section.name())));
            section.entries().for_each(|(name, value)| push(text, &format!("{} = {}", key(name), quoted(value))));
        }
        return;
    }
    // in one table, because a list cannot follow the table of another section
    text.push_str("\n[extra]\n");
    for section in &device.extra {
        push(text, &format!("{} = {}", key(section.name()), facts::table_of_pairs(&section.entries().collect::<Vec<_>>())));
    }
}

/// The most frequent of these.
fn most<T: Ord + Clone>(items: impl Iterator<Item = T>) -> Option<T> {
    let mut counts: BTreeMap<T, usize> = BTreeMap::new();
    items.for_each(|item| *counts.entry(item).or_default() += 1);
    counts.into_iter().max_by_key(|(_, count)| *count).map(|(item, _)| item)
}

/// What most entries of a device have.
fn usual(device: &Device) -> Defaults {
    let entries = || {
        let of_object = |object: &'_ Object| -> Vec<Entry> {
            let subs = object.subs.iter().filter(|(sub, _)| *sub != 0).map(|(_, entry)| entry);
            let main = Some(&object.main).filter(|_| object.subs.is_empty() && !object.object_type().has_subs());
            main.into_iter().chain(subs).map(|entry| Entry {
                object_type: entry.object_type,
                access: entry.access,
                pdo_mapping: entry.pdo_mapping,
                ..Entry::default()
            }).collect()
        };
        device.objects.values().flat_map(of_object)
    };
    let built_in = Defaults::default();
    let mut defaults = Defaults::default();
    match most(entries().map(|entry| entry.access)) {
        Some(Some(access)) => defaults.access = access,
        Some(None) => defaults.unstated.add(Omission::Access),
        None => {}
    }
    match most(entries().map(|entry| entry.pdo_mapping.map(|map| map as u8))) {
        Some(None) => defaults.unstated.add(Omission::Map),
        Some(Some(code)) => {
            let found = entries().filter_map(|entry| entry.pdo_mapping).find(|map| *map as u8 == code);
            defaults.map = found.unwrap_or_default();
        }
        None => {}
    }
    let subs = device.objects.values().flat_map(|object| object.subs.iter()).filter(|(sub, _)| *sub != 0);
    if most(subs.map(|(_, entry)| entry.object_type.is_some())) == Some(false) {
        defaults.unstated.add(Omission::ObjectType);
    }
    let described = || device.objects.values().filter(|object| !object.subs.is_empty() && object.compact.is_none());
    if most(described().map(|object| object.sub_number.is_some())) == Some(false) {
        defaults.unstated.add(Omission::SubNumber);
    }
    match usual_first(device) {
        Some(Some(first)) => defaults.sub0 = first,
        Some(None) => defaults.unstated.add(Omission::Sub0),
        None => defaults.sub0 = built_in.sub0,
    }
    defaults
}

/// What sub-index 0 is in most objects; `None` in it for none.
fn usual_first(device: &Device) -> Option<Option<Entry>> {
    let mut counts: BTreeMap<String, (usize, Option<Entry>)> = BTreeMap::new();
    let described = device.objects.values().filter(|object| !object.subs.is_empty() && object.compact.is_none());
    for object in described {
        let first = object.subs.get(0).map(|entry| Entry {
            name: entry.name.clone(),
            object_type: entry.object_type,
            data_type: entry.data_type,
            access: entry.access,
            pdo_mapping: entry.pdo_mapping,
            ..Entry::default()
        });
        let word = serde_json::to_string(&first).unwrap_or_default();
        counts.entry(word).or_insert((0, first)).0 += 1;
    }
    counts.into_values().max_by_key(|(count, _)| *count).map(|(_, first)| first)
}

fn write_defaults(defaults: &Defaults, text: &mut String) {
    let built_in = Defaults::default();
    let mut lines = Vec::new();
    if defaults.access != built_in.access {
        lines.push(format!("access = {}", quoted(defaults.access.name())));
    }
    if defaults.map != built_in.map {
        lines.push(format!("map = {}", quoted(map_word(defaults.map))));
    }
    if defaults.unstated != built_in.unstated {
        lines.push(format!("unstated = [{}]", words(&defaults.unstated.words())));
    }
    if defaults.sub0 != built_in.sub0 {
        let mut keys: Vec<Pair> = Vec::new();
        let mut given = Omissions::default();
        let (found, usual) = (&defaults.sub0, &built_in.sub0);
        if found.name != usual.name {
            keys.push(("name".to_owned(), quoted(&found.name)));
        }
        if found.data_type != usual.data_type {
            keys.extend(found.data_type.map(|data_type| ("type".to_owned(), quoted(&type_word(data_type)))));
        }
        common(found, usual, &mut keys, &mut given);
        if given != Omissions::default() {
            keys.push(("unstated".to_owned(), format!("[{}]", words(&given.words()))));
        }
        lines.push(format!("sub0 = {}", inline(&keys)));
    }
    if !lines.is_empty() {
        text.push_str("\n[defaults]\n");
        lines.iter().for_each(|line| push(text, line));
    }
}

/// Access and mapping that differ from what is implied, and what is left out.
fn common(found: &Entry, implied: &Entry, keys: &mut Vec<Pair>, left_out: &mut Omissions) {
    match (found.object_type, implied.object_type) {
        (None, Some(_)) => left_out.add(Omission::ObjectType),
        (Some(found), implied) if Some(found) != implied => {
            keys.push(("object-type".to_owned(), quoted(&found.name().to_ascii_lowercase())));
        }
        _ => {}
    }
    match (found.access, implied.access) {
        (None, Some(_)) => left_out.add(Omission::Access),
        (Some(found), implied) if Some(found) != implied => {
            keys.push(("access".to_owned(), quoted(found.name())));
        }
        _ => {}
    }
    match (found.pdo_mapping, implied.pdo_mapping) {
        (None, Some(_)) => left_out.add(Omission::Map),
        (Some(found), implied) if Some(found) != implied => {
            keys.push(("map".to_owned(), quoted(map_word(found))));
        }
        _ => {}
    }
}

pub(super) const fn map_word(map: PdoMapping) -> &'static str {
    match map {
        PdoMapping::No => "no",
        PdoMapping::Optional => "optional",
        PdoMapping::Default => "default",
        PdoMapping::Tpdo => "tpdo",
        PdoMapping::Rpdo => "rpdo",
    }
}

fn inline(pairs: &[Pair]) -> String {
    if pairs.is_empty() {
        return "{}".to_owned();
    }
    let items: Vec<String> = pairs.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    format!("{{ {} }}", items.join(", "))
}

struct Writer<'a> {
    device: &'a Device,
    defaults: Defaults,
    /// What there is without keys.
    base: Option<&'a Device>,
}

impl Writer<'_> {
    fn object(&self, index: u16, object: &Object, base: Option<&Object>, text: &mut String) {
        let mut pairs = self.main(index, object, base);
        let subs = self.subs(index, object, base);
        pairs.extend(subs.iter().map(|(subs, pairs)| (format!("sub.{subs}"), inline(pairs))));
        let line = format!("{index:04X} = {}", inline(&pairs));
        // what is one entry is one line; the keys of a record are lines of their own where that is shorter
        if subs.is_empty() || line.chars().count() <= LINE {
            push(text, &line);
            return;
        }
        pairs.iter().for_each(|(name, value)| push(text, &format!("{index:04X}.{name} = {value}")));
    }

    fn main(&self, index: u16, object: &Object, base: Option<&Object>) -> Vec<Pair> {
        let main = &object.main;
        let said = said_of(object);
        let word = said.word();
        let types = word.as_deref().and_then(TypeSaid::parse).unwrap_or_default();
        let is_whole = !object.subs.is_empty() || types.has_subs();
        let role = if is_whole { Role::Whole } else { Role::Value };
        let (unstated, own) = self.omissions(object, role, base);
        let mut implied = match base {
            Some(base) => without(base.main.clone(), unstated),
            None => self.defaults.implied(role, unstated),
        };
        let is_record = main.object_type == Some(ObjectType::Record) && main.data_type.is_none();
        let implies_record = base.is_none() && !object.subs.is_empty() && !unstated.has(Omission::ObjectType);
        let mut pairs = Vec::new();
        if base.is_none() || main.name != implied.name {
            pairs.push(("name".to_owned(), quoted(&main.name)));
        }
        let is_of_base = base.is_some_and(|base| said_of(base) == said && base.main.object_type == main.object_type);
        let word = word.filter(|_| !(is_record && implies_record) && !is_of_base);
        match &word {
            Some(word) => {
                pairs.push(("type".to_owned(), quoted(word)));
                implied.object_type = types.object_type.or(implied.object_type);
                if unstated.has(Omission::ObjectType) {
                    implied.object_type = None;
                }
            }
            None => {
                implied.object_type = if implies_record { Some(ObjectType::Record) } else { implied.object_type };
                let data_type = main.data_type.filter(|_| main.data_type != implied.data_type);
                let data_type = data_type.map(|data_type| quoted(&type_word(data_type)));
                pairs.extend(data_type.map(|word| ("data-type".to_owned(), word)));
            }
        }
        common(main, &implied, &mut pairs, &mut Omissions::default());
        self.rest(&format!("{index:04X}"), main, &implied, &mut pairs);
        if let Some(compact) = &object.compact {
            compact_keys(compact, main.data_type, &mut pairs);
        }
        if let Some(number) = object.sub_number.filter(|number| Some(*number) != sub_number(object, unstated)) {
            pairs.push(("sub-number".to_owned(), number.to_string()));
        }
        if !object.links.is_empty() {
            pairs.push(("links".to_owned(), quoted(&index_list(&object.links))));
        }
        if own {
            pairs.push(("unstated".to_owned(), format!("[{}]", words(&unstated.words()))));
        }
        pairs
    }

    /// What the description of an object leaves out, and whether that needs a key.
    fn omissions(&self, object: &Object, role: Role, base: Option<&Object>) -> (Omissions, bool) {
        let stated = match base {
            Some(base) => base.main.clone(),
            None => self.defaults.implied(role, Omissions::default()),
        };
        let mut needed = needed(&object.main, &stated);
        if base.is_some() && object.main.default.is_none() && stated.default.is_some() {
            needed.add(Omission::Default);
        }
        let has_subs = !object.subs.is_empty() && object.compact.is_none();
        if has_subs && object.sub_number.is_none() {
            needed.add(Omission::SubNumber);
        }
        if has_subs && object.subs.get(0).is_none() {
            needed.add(Omission::Sub0);
        }
        let usual = match base {
            Some(_) => Omissions::default(),
            None => self.defaults.unstated.of_role(role),
        };
        if needed.is_within(usual) { (usual, false) } else { (needed, true) }
    }

    /// The keys of the sub-indexes, each with its keys.
    fn subs(&self, index: u16, object: &Object, base: Option<&Object>) -> Vec<(String, Vec<Pair>)> {
        let of_base = |sub: u8| base.and_then(|base| base.subs.get(sub));
        let written: Vec<(u8, &Entry)> = object.subs.iter().filter(|(sub, entry)| {
            self.before(*sub, object, base).as_ref() != Some(entry)
                // an object whose only entry is implied needs a key for it
                || (base.is_none() && object.subs.len() == 1)
        }).collect();
        let mut keys = Vec::new();
        let mut rest = written.as_slice();
        while let Some(&(sub, entry)) = rest.first() {
            let alike = run(rest);
            let is_new = rest[..alike].iter().all(|(sub, _)| of_base(*sub).is_none());
            let mut pairs = self.sub(index, (sub, entry), object, base);
            let run = if is_new { alike } else { self.changed_alike(index, rest, &pairs, object, base) };
            let name = if run == 1 { format!("{sub:X}") } else { format!("{sub:X}-{:X}", rest[run - 1].0) };
            if run > 1 && is_new {
                let template = template(&entry.name, sub, &rest[1].1.name, rest[1].0).unwrap_or_default();
                range_keys(&rest[..run], &template, index, &mut pairs);
            }
            keys.push((name, pairs));
            rest = &rest[run..];
        }
        keys
    }

    /// How many entries of the base, from the first one on, are changed in the same way.
    fn changed_alike(
        &self,
        index: u16,
        entries: &[(u8, &Entry)],
        pairs: &[Pair],
        object: &Object,
        base: Option<&Object>,
    ) -> usize {
        let Some((&(first, _), rest)) = entries.split_first() else { return 0 };
        if first == 0 || pairs.iter().any(|(name, _)| name == "name" || name == "bits") {
            return 1;
        }
        let is_of_base = |sub: u8| base.is_some_and(|base| base.subs.get(sub).is_some());
        let alike = rest.iter().enumerate().take_while(|(at, (sub, entry))| {
            usize::from(*sub) == usize::from(first) + at + 1
                && is_of_base(*sub)
                && self.sub(index, (*sub, entry), object, base) == pairs
        });
        alike.count() + 1
    }

    /// What a sub-index is without a key, where it is there at all.
    fn before(&self, sub: u8, object: &Object, base: Option<&Object>) -> Option<Entry> {
        let highest = object.highest_sub();
        let value = || self.defaults.highest(highest, self.defaults.unstated);
        match base.and_then(|base| Some((base.highest_sub(), base.subs.get(sub)?))) {
            Some((before, entry)) if sub != 0 || before == highest => Some(entry.clone()),
            Some((_, entry)) => Some(Entry { default: value(), ..entry.clone() }),
            None if sub == 0 && object.compact.is_none() => {
                Some(Entry { default: value(), ..self.defaults.implied(Role::First, Omissions::default()) })
            }
            None => None,
        }
    }

    fn sub(&self, index: u16, (sub, entry): (u8, &Entry), object: &Object, base: Option<&Object>) -> Vec<Pair> {
        let role = if sub == 0 { Role::First } else { Role::Sub };
        let before = self.before(sub, object, base);
        let usual = match before {
            Some(_) => Omissions::default(),
            None => self.defaults.unstated.of_role(role),
        };
        let stated = before.clone().unwrap_or_else(|| self.defaults.implied(role, Omissions::default()));
        let mut needed = needed(entry, &stated);
        if stated.default.is_some() && entry.default.is_none() {
            needed.add(Omission::Default);
        }
        let own = !needed.is_within(usual);
        let unstated = if own { needed } else { usual };
        let mut implied = match before {
            Some(before) => without(before, unstated),
            None => self.defaults.implied(role, unstated),
        };
        let mut pairs = Vec::new();
        if entry.name != implied.name {
            pairs.push(("name".to_owned(), quoted(&entry.name)));
        }
        if entry.data_type != implied.data_type {
            let length = entry.stack.as_ref().and_then(|stack| stack.min_string_length);
            let object_type = entry.object_type.filter(|of| *of == ObjectType::Domain);
            let said = TypeSaid { object_type, data_type: entry.data_type, length, count: None };
            let word = said.word().or_else(|| entry.data_type.map(type_word));
            if let Some(word) = word {
                let parsed = TypeSaid::parse(&word).unwrap_or_default();
                if !unstated.has(Omission::ObjectType) {
                    implied.object_type = parsed.object_type.or(implied.object_type);
                }
                pairs.push(("type".to_owned(), quoted(&word)));
            }
        }
        common(entry, &implied, &mut pairs, &mut Omissions::default());
        self.rest(&format!("{index:04X}{sub:02X}"), entry, &implied, &mut pairs);
        if own {
            pairs.push(("unstated".to_owned(), format!("[{}]", words(&unstated.words()))));
        }
        pairs
    }

    /// The keys that no other facts decide about.
    fn rest(&self, address: &str, entry: &Entry, implied: &Entry, pairs: &mut Vec<Pair>) {
        // CAN-IDs, mapped entries and identity
        let hex = address.starts_with('1') && entry.data_type == Some(DataType::UNSIGNED32);
        let values = [
            ("default", entry.default.as_ref(), implied.default.as_ref()),
            ("min", entry.low_limit.as_ref(), implied.low_limit.as_ref()),
            ("max", entry.high_limit.as_ref(), implied.high_limit.as_ref()),
            ("value", entry.configured_value(), implied.configured_value()),
        ];
        for (name, value, implied) in values {
            let value = value.filter(|_| value != implied);
            let text = value.and_then(|value| stated_value(value, entry.implied_type(), hex));
            pairs.extend(text.map(|text| (name.to_owned(), text)));
        }
        let mut put = |name: &str, text: String| pairs.push((name.to_owned(), text));
        if let Some(flags) = entry.flags.filter(|_| entry.flags != implied.flags) {
            put("flags", flags.0.to_string());
        }
        if let Some(configured) = &entry.configured {
            let texts = [
                ("denotation", &configured.denotation),
                ("upload-file", &configured.upload_file),
                ("download-file", &configured.download_file),
            ];
            for (name, text) in texts {
                text.iter().for_each(|text| put(name, quoted(text)));
            }
        }
        if let Some(stack) = &entry.stack {
            stack.storage_group.iter().for_each(|text| put("group", quoted(text)));
            stack.count_label.iter().for_each(|text| put("count-label", quoted(text)));
            stack.disabled.iter().for_each(|flag| put("disabled", flag.to_string()));
            stack.detects_change.iter().for_each(|flag| put("detects-change", flag.to_string()));
            stack.io_extension.iter().for_each(|flag| put("io-extension", flag.to_string()));
            stack.srdo_access.iter().for_each(|word| put("srdo", quoted(word.name())));
        }
        for (name, text) in meaning::keys(self.device, address, entry) {
            put(name, text);
        }
        if !entry.extra.is_empty() {
            put("extra", facts::table_of_pairs(&entry.extra.iter().collect::<Vec<_>>()));
        }
    }
}

/// The facts that an entry leaves out although a missing key implies them.
fn needed(entry: &Entry, stated: &Entry) -> Omissions {
    let mut needed = Omissions::default();
    common(entry, stated, &mut Vec::new(), &mut needed);
    needed
}

/// A value as TOML, where its type reads it back.
fn stated_value(value: &Value, data_type: Option<DataType>, hex: bool) -> Option<String> {
    let kind = data_type.map_or(TypeKind::Reserved, DataType::kind);
    let is_text = matches!(kind, TypeKind::VisibleString | TypeKind::UnicodeString);
    match value {
        Value::Text(_) if !is_text => None,
        value => spelled(value, hex),
    }
}

/// What `type` says of an object.
fn said_of(object: &Object) -> TypeSaid {
    let main = &object.main;
    let count = object.compact.as_ref().map(|compact| compact.count);
    let is_word = |of: &ObjectType| matches!(of, ObjectType::Array | ObjectType::Record | ObjectType::Domain);
    let object_type = match count {
        // equal elements are an array, unless another key says what they are
        Some(_) => Some(ObjectType::Array),
        None => main.object_type.filter(is_word),
    };
    let length = main.stack.as_ref().and_then(|stack| stack.min_string_length);
    TypeSaid { object_type, data_type: main.data_type, count, length }
}

fn compact_keys(compact: &Compact, data_type: Option<DataType>, pairs: &mut Vec<Pair>) {
    let table = |items: Vec<String>| format!("{{ {} }}", items.join(", "));
    let texts = |list: &[(u8, Box<str>)]| {
        table(list.iter().map(|(sub, text)| format!("{sub:X} = {}", quoted(text))).collect())
    };
    if !compact.names.is_empty() {
        pairs.push(("names".to_owned(), texts(&compact.names)));
    }
    let values = compact.values.iter().filter_map(|(sub, value)| {
        stated_value(value, data_type, false).map(|text| format!("{sub:X} = {text}"))
    });
    let values: Vec<String> = values.collect();
    if !values.is_empty() {
        pairs.push(("values".to_owned(), table(values)));
    }
    if !compact.denotations.is_empty() {
        pairs.push(("denotations".to_owned(), texts(&compact.denotations)));
    }
}

/// How many entries from the first on differ only in the number in their names, and in their values.
fn run(entries: &[(u8, &Entry)]) -> usize {
    let Some((&(first, one), rest)) = entries.split_first() else { return 0 };
    let Some(&(second, next)) = rest.first() else { return 1 };
    if first == 0 || one.name.contains('{') {
        return 1;
    }
    let Some(template) = template(&one.name, first, &next.name, second) else { return 1 };
    let continues = |at: usize, sub: u8, entry: &Entry| {
        usize::from(sub) == usize::from(first) + at
            && numbered(&template, sub) == *entry.name
            && entry.default.is_some() == one.default.is_some()
            && is_alike(one, entry)
    };
    let alike = rest.iter().enumerate().take_while(|(at, (sub, entry))| continues(at + 1, *sub, entry)).count() + 1;
    let is_one_value = entries[..alike].iter().all(|(_, entry)| entry.default == one.default);
    if is_one_value { alike } else { alike.min(MAX_RANGE) }
}

/// Whether two entries are the same but for name and value. What names their own address has no range.
fn is_alike(one: &Entry, other: &Entry) -> bool {
    let bare = |entry: &Entry| {
        let is_own = entry.parameter.as_ref().is_some_and(|parameter| parameter.data_type.is_some());
        (!is_own).then(|| Entry { name: Box::default(), default: None, ..entry.clone() })
    };
    bare(one).is_some_and(|one| Some(one) == bare(other))
}

/// The name of two entries with a gap for the number.
fn template(one: &str, first: u8, next: &str, second: u8) -> Option<String> {
    if one == next {
        return Some(one.to_owned());
    }
    let gaps = [("{}", first.to_string()), ("{x}", format!("{first:X}"))];
    gaps.into_iter().find_map(|(gap, digits)| {
        let mut places = one.rmatch_indices(&digits);
        places.find_map(|(at, found)| {
            let template = format!("{}{gap}{}", &one[..at], &one[at + found.len()..]);
            (numbered(&template, second) == next).then_some(template)
        })
    })
}

/// Makes the keys of the first entry those of a range.
fn range_keys(entries: &[(u8, &Entry)], template: &str, index: u16, pairs: &mut [Pair]) {
    let one = entries[0].1;
    let is_one_value = entries.iter().all(|(_, entry)| entry.default == one.default);
    for (name, text) in pairs {
        match name.as_str() {
            "name" => *text = quoted(template),
            "default" if !is_one_value => {
                let value = |(_, entry): &(u8, &Entry)| {
                    let value = entry.default.as_ref()?;
                    stated_value(value, entry.implied_type(), index < 0x2000 && entry.data_type == Some(DataType::UNSIGNED32))
                };
                let values: Vec<String> = entries.iter().filter_map(value).collect();
                *text = format!("[{}]", values.join(", "));
            }
            _ => {}
        }
    }
}

