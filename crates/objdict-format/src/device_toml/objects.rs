//! Converts an object to its keys: everything that differs from the defaults.

use super::defaults::{Defaults, EntryRole, Omissions, OmittedFact};
use super::reader::{numbered, sub_number, without};
use super::words::{TypeSaid, index_list, map_word, push, quoted, spelled, type_word, words};
use super::{facts, meaning};
use objdict_model::model::{Compact, DataType, Device, Entry, Object, ObjectType, TypeKind, Value};

/// The maximum length of an object on one line.
const LINE: usize = 110;

/// The maximum number of sub-indexes with individual values on one line.
const MAX_RANGE: usize = 16;

/// A key and its value in TOML.
pub(super) type TomlPair = (String, String);

/// Access and mapping that differ from the implied ones, and omitted properties.
pub(super) fn common(found: &Entry, implied: &Entry, keys: &mut Vec<TomlPair>, left_out: &mut Omissions) {
    match (found.object_type, implied.object_type) {
        (None, Some(_)) => left_out.add(OmittedFact::ObjectType),
        (Some(found), implied) if Some(found) != implied => {
            keys.push(("object-type".to_owned(), quoted(&found.name().to_ascii_lowercase())));
        }
        _ => {}
    }
    match (found.access, implied.access) {
        (None, Some(_)) => left_out.add(OmittedFact::Access),
        (Some(found), implied) if Some(found) != implied => {
            keys.push(("access".to_owned(), quoted(found.name())));
        }
        _ => {}
    }
    match (found.pdo_mapping, implied.pdo_mapping) {
        (None, Some(_)) => left_out.add(OmittedFact::Map),
        (Some(found), implied) if Some(found) != implied => {
            keys.push(("map".to_owned(), quoted(&map_word(found))));
        }
        _ => {}
    }
}

pub(super) fn inline(pairs: &[TomlPair]) -> String {
    if pairs.is_empty() {
        return "{}".to_owned();
    }
    let items: Vec<String> = pairs.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    format!("{{ {} }}", items.join(", "))
}

pub(super) struct ObjectWriter<'a> {
    pub(super) device: &'a Device,
    pub(super) defaults: Defaults,
    /// The device without keys.
    pub(super) base: Option<&'a Device>,
}

impl ObjectWriter<'_> {
    pub(super) fn object(&self, index: u16, object: &Object, base: Option<&Object>, text: &mut String) {
        let mut pairs = self.main(index, object, base);
        let subs = self.subs(index, object, base);
        pairs.extend(subs.iter().map(|(subs, pairs)| (format!("sub.{subs}"), inline(pairs))));
        let line = format!("{index:04X} = {}", inline(&pairs));
        // a single entry is one line; the keys of a record are separate lines if that is shorter
        if subs.is_empty() || line.chars().count() <= LINE {
            push(text, &line);
            return;
        }
        pairs.iter().for_each(|(name, value)| push(text, &format!("{index:04X}.{name} = {value}")));
    }

    fn main(&self, index: u16, object: &Object, base: Option<&Object>) -> Vec<TomlPair> {
        let main = &object.main;
        let said = said_of(object);
        let word = said.word();
        let types = word.as_deref().and_then(TypeSaid::parse).unwrap_or_default();
        let is_whole = !object.subs.is_empty() || types.has_subs();
        let role = if is_whole { EntryRole::Whole } else { EntryRole::Value };
        let (unstated, own) = self.omissions(object, role, base);
        let mut implied = match base {
            Some(base) => without(base.main.clone(), unstated),
            None => self.defaults.implied(role, unstated),
        };
        let is_record = main.object_type == Some(ObjectType::Record) && main.data_type.is_none();
        let implies_record =
            base.is_none() && !object.subs.is_empty() && !unstated.has(OmittedFact::ObjectType);
        let mut pairs = Vec::new();
        if base.is_none() || main.name != implied.name {
            pairs.push(("name".to_owned(), quoted(&main.name)));
        }
        let is_of_base =
            base.is_some_and(|base| said_of(base) == said && base.main.object_type == main.object_type);
        let word = word.filter(|_| !(is_of_base || is_record && implies_record));
        match &word {
            Some(word) => {
                pairs.push(("type".to_owned(), quoted(word)));
                implied.object_type = types.object_type.or(implied.object_type);
                if unstated.has(OmittedFact::ObjectType) {
                    implied.object_type = None;
                }
            }
            None => {
                implied.object_type =
                    if implies_record { Some(ObjectType::Record) } else { implied.object_type };
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
        if let Some(number) = object.sub_number.filter(|number| Some(*number) != sub_number(object, unstated))
        {
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

    /// The omissions of an object's description, and whether they need a key.
    fn omissions(&self, object: &Object, role: EntryRole, base: Option<&Object>) -> (Omissions, bool) {
        let stated = match base {
            Some(base) => base.main.clone(),
            None => self.defaults.implied(role, Omissions::default()),
        };
        let mut needed = needed(&object.main, &stated);
        if base.is_some() && object.main.default.is_none() && stated.default.is_some() {
            needed.add(OmittedFact::Default);
        }
        let has_subs = !object.subs.is_empty() && object.compact.is_none();
        if has_subs && object.sub_number.is_none() {
            needed.add(OmittedFact::SubNumber);
        }
        if has_subs && object.subs.get(0).is_none() {
            needed.add(OmittedFact::Sub0);
        }
        let usual = match base {
            Some(_) => Omissions::default(),
            None => self.defaults.unstated.of_role(role),
        };
        if needed.is_within(usual) { (usual, false) } else { (needed, true) }
    }

    /// The keys of the sub-indexes, each with its keys.
    fn subs(&self, index: u16, object: &Object, base: Option<&Object>) -> Vec<(String, Vec<TomlPair>)> {
        let of_base = |sub: u8| base.and_then(|base| base.subs.get(sub));
        let written: Vec<(u8, &Entry)> = object
            .subs
            .iter()
            .filter(|(sub, entry)| {
                self.before(*sub, object, base).as_ref() != Some(entry)
                // an object whose only entry is implied needs a key for it
                || (base.is_none() && object.subs.len() == 1)
            })
            .collect();
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

    /// The number of leading entries of the base that are changed in the same way.
    fn changed_alike(
        &self,
        index: u16,
        entries: &[(u8, &Entry)],
        pairs: &[TomlPair],
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

    /// The sub-index without a key, if it exists.
    fn before(&self, sub: u8, object: &Object, base: Option<&Object>) -> Option<Entry> {
        let highest = object.highest_sub();
        let value = || self.defaults.highest(highest, self.defaults.unstated);
        match base.and_then(|base| Some((base.highest_sub(), base.subs.get(sub)?))) {
            Some((before, entry)) if sub != 0 || before == highest => Some(entry.clone()),
            Some((_, entry)) => Some(Entry { default: value(), ..entry.clone() }),
            None if sub == 0 && object.compact.is_none() => Some(Entry {
                default: value(),
                ..self.defaults.implied(EntryRole::First, Omissions::default())
            }),
            None => None,
        }
    }

    fn sub(
        &self,
        index: u16,
        (sub, entry): (u8, &Entry),
        object: &Object,
        base: Option<&Object>,
    ) -> Vec<TomlPair> {
        let role = if sub == 0 { EntryRole::First } else { EntryRole::Sub };
        let before = self.before(sub, object, base);
        let usual = match before {
            Some(_) => Omissions::default(),
            None => self.defaults.unstated.of_role(role),
        };
        let stated = before.clone().unwrap_or_else(|| self.defaults.implied(role, Omissions::default()));
        let mut needed = needed(entry, &stated);
        if stated.default.is_some() && entry.default.is_none() {
            needed.add(OmittedFact::Default);
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
            let length = room(entry);
            let object_type = entry.object_type.filter(|of| *of == ObjectType::Domain);
            let said = TypeSaid { object_type, data_type: entry.data_type, length, count: None };
            let word = said.word().or_else(|| entry.data_type.map(type_word));
            if let Some(word) = word {
                let parsed = TypeSaid::parse(&word).unwrap_or_default();
                if !unstated.has(OmittedFact::ObjectType) {
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

    /// The keys of independent properties.
    fn rest(&self, address: &str, entry: &Entry, implied: &Entry, pairs: &mut Vec<TomlPair>) {
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

/// The properties that an entry lacks although a missing key implies them.
fn needed(entry: &Entry, stated: &Entry) -> Omissions {
    let mut needed = Omissions::default();
    common(entry, stated, &mut Vec::new(), &mut needed);
    needed
}

/// A value as TOML, if its type reads it back.
fn stated_value(value: &Value, data_type: Option<DataType>, hex: bool) -> Option<String> {
    let kind = data_type.map_or(TypeKind::Reserved, DataType::kind);
    let is_text = matches!(kind, TypeKind::VisibleString | TypeKind::UnicodeString);
    match value {
        Value::Text(_) if !is_text => None,
        value => spelled(value, hex),
    }
}

/// The capacity of a string in characters, unless its default is longer: stating it would be wrong.
fn room(entry: &Entry) -> Option<u32> {
    let length = entry.stack.as_ref()?.min_string_length?;
    let is_enough = |text: &str| text.chars().nth(length as usize).is_none();
    let default = entry.default.as_ref();
    Some(length).filter(|_| !matches!(default, Some(Value::Text(text)) if !is_enough(text)))
}

/// The value of `type` for an object.
fn said_of(object: &Object) -> TypeSaid {
    let main = &object.main;
    let count = object.compact.as_ref().map(|compact| compact.count);
    let is_word = |of: &ObjectType| matches!(of, ObjectType::Array | ObjectType::Record | ObjectType::Domain);
    let object_type = match count {
        // equal elements are an array, unless a different key states the object type
        Some(_) => Some(ObjectType::Array),
        None => main.object_type.filter(is_word),
    };
    let length = room(main);
    TypeSaid { object_type, data_type: main.data_type, count, length }
}

fn compact_keys(compact: &Compact, data_type: Option<DataType>, pairs: &mut Vec<TomlPair>) {
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

/// The number of leading entries that differ only in the number in their names, and in their values.
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
    let alike =
        rest.iter().enumerate().take_while(|(at, (sub, entry))| continues(at + 1, *sub, entry)).count() + 1;
    let is_one_value = entries[..alike].iter().all(|(_, entry)| entry.default == one.default);
    if is_one_value { alike } else { alike.min(MAX_RANGE) }
}

/// Whether two entries are equal apart from name and value. Entries that refer to their own address cannot be
/// in a range.
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

/// Turns the keys of the first entry into those of a range.
fn range_keys(entries: &[(u8, &Entry)], template: &str, index: u16, pairs: &mut [TomlPair]) {
    let one = entries[0].1;
    let is_one_value = entries.iter().all(|(_, entry)| entry.default == one.default);
    for (name, text) in pairs {
        match name.as_str() {
            "name" => *text = quoted(template),
            "default" if !is_one_value => {
                let value = |(_, entry): &(u8, &Entry)| {
                    let value = entry.default.as_ref()?;
                    stated_value(
                        value,
                        entry.implied_type(),
                        index < 0x2000 && entry.data_type == Some(DataType::UNSIGNED32),
                    )
                };
                let values: Vec<String> = entries.iter().filter_map(value).collect();
                *text = format!("[{}]", values.join(", "));
            }
            _ => {}
        }
    }
}
