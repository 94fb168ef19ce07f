//! Converts the tree to objects.

use std::collections::BTreeSet;

use super::defaults::{Defaults, EntryRole, Omissions, OmittedFact};
use super::facts::pairs;
use super::keys::{DEFAULTS, ENTRY, OBJECT};
use super::meaning;
use super::words::{NO_INDEXES, TypeSaid, data_type, index, indexes, mapping, subs, type_words, value_of};
use objdict_keyed::rules::{DUPLICATE_KEY, OUT_OF_RANGE, UNKNOWN_KEY, WRONG_TYPE};
use objdict_keyed::section::KeyedTable;
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::{Diagnostic, Findings, Severity, nearest, say};
use objdict_model::literal::{NoValue, written};
use objdict_model::model::{
    Access, ApplicationProcess, Compact, Entry, ObjFlags, Object, ObjectType, Objects, SrdoAccess, Value,
};

/// Reads objects.
pub(super) struct ObjectReader<'f> {
    pub(super) defaults: Defaults,
    pub(super) findings: &'f mut Findings,
    /// The types that the meanings of values need.
    pub(super) application: ApplicationProcess,
    /// The entries of ranges so far.
    pub(super) ranged: usize,
}

/// The keys of values.
const VALUES: [&str; 4] = ["default", "min", "max", "value"];

/// The maximum number of entries in ranges, because a few bytes of text can create an object of them. Real
/// devices have a few thousand.
const MAX_RANGED: usize = 15_000;

impl ObjectReader<'_> {
    /// Reads `[defaults]`.
    pub(super) fn read_defaults(&mut self, tree: &KeyedTree) {
        let Some(section) = KeyedTable::new("defaults", tree, DEFAULTS, self.findings) else { return };
        if let Some(access) = section.word("access", self.findings) {
            self.defaults.access = Access::from_name(&access.value).unwrap_or(Access::Rw);
        }
        if let Some(map) = section.word("map", self.findings) {
            self.defaults.map = mapping(&map.value).unwrap_or_default();
        }
        self.defaults.unstated = Omissions::read(&section, self.findings).unwrap_or_default();
        if let Some(tree) = section.get("sub0")
            && let Some(section) = KeyedTable::new("sub0", tree, ENTRY, self.findings)
        {
            let implied = self.defaults.sub0.clone();
            let unstated = Omissions::read(&section, self.findings).unwrap_or_default();
            self.defaults.sub0 = without(implied, unstated);
            self.defaults.sub0 = self.entry("sub0", &section, EntryRole::First, None).0;
        }
    }

    /// Reads the selected objects of a table by index, and merges them into those that a profile requires.
    pub(super) fn read_objects(&mut self, tree: &KeyedTree, objects: &mut Objects, wanted: fn(u16) -> bool) {
        let Some(entries) = tree.entries() else {
            let message = say!("`object` is {}, not a table of objects", tree.kind_name());
            let finding = Diagnostic::new(&WRONG_TYPE, tree.span, message);
            self.findings.push(finding.help("write the objects below it by index"));
            return;
        };
        let mut seen = BTreeSet::new();
        for entry in entries {
            let name = entry.key.spelled();
            let Some(index) = index(&name) else {
                // reported once
                if wanted(0) {
                    let message = say!("`{}` is not an index", name);
                    let finding = Diagnostic::new(&UNKNOWN_KEY, entry.key.span, message);
                    self.findings.push(finding.help("write four hex digits, as in `[object.2000]`"));
                }
                continue;
            };
            if !wanted(index) {
                continue;
            }
            if !seen.insert(index) {
                let message = say!("object {}h is defined twice", format!("{index:04X}"));
                let finding = Diagnostic::new(&DUPLICATE_KEY, entry.key.span, message);
                self.findings.push(finding.help("remove one of them"));
            }
            let base = objects.get(&index).cloned();
            if let Some(object) = self.object(index, &name, &entry.value, base) {
                objects.insert(index, object);
            }
        }
    }

    fn object(&mut self, index: u16, name: &str, tree: &KeyedTree, base: Option<Object>) -> Option<Object> {
        let section = KeyedTable::new(name, tree, OBJECT, self.findings)?;
        let said = self.said(&section);
        let is_new = base.is_none();
        let mut object = base.unwrap_or_default();
        let has_subs = section.get("sub").is_some() || !object.subs.is_empty();
        let role = match said {
            Some(said) if said.has_subs() => EntryRole::Whole,
            _ if has_subs => EntryRole::Whole,
            _ => EntryRole::Value,
        };
        let before = Some(&object.main).filter(|_| !is_new).cloned();
        let (main, unstated) = self.entry(name, &section, role, before);
        object.main = main;
        if role == EntryRole::Whole && said.is_none() && is_new && !unstated.has(OmittedFact::ObjectType) {
            object.main.object_type = Some(ObjectType::Record);
        }
        self.override_types(&section, &mut object.main);
        if let Some(count) = said.and_then(|said| said.count) {
            object.compact = Some(Box::new(self.compact(&section, count, &object.main)));
            self.elements(&section, count, &mut object);
        }
        self.subs(index, &section, &mut object, unstated);
        if let Some(links) = section.parsed("links", indexes, NO_INDEXES, self.findings) {
            object.links = links.value;
        }
        Some(object)
    }

    /// The types of an object that `type` does not imply.
    fn override_types(&mut self, section: &KeyedTable<'_>, main: &mut Entry) {
        if let Some(word) = section.text("data-type", self.findings) {
            main.data_type = data_type(&word.value);
            if main.data_type.is_none() {
                self.no_type(&word.value, word.at);
            }
        }
        if let Some(word) = section.word("object-type", self.findings) {
            main.object_type = object_type(&word.value);
        }
    }

    fn compact(&mut self, section: &KeyedTable<'_>, count: u8, main: &Entry) -> Compact {
        let mut compact = Compact { count, ..Compact::default() };
        let mut listed = |name: &str, keep: &mut dyn FnMut(u8, &KeyedTree) -> bool| {
            let items = items_of(section, name);
            if let Some(items) = items {
                self.count_items(name, items, count.into());
            }
            for (sub, item) in (1..=count).zip(items.into_iter().flat_map(|(_, items)| items)) {
                if !keep(sub, item) {
                    let message =
                        say!("`{}` has `{}`, which is not a value of its type", name, item.spelled());
                    self.findings
                        .push(Diagnostic::new(&WRONG_TYPE, item.span, message).help("correct the value"));
                }
            }
            for entry in if items.is_some() { &[] } else { section.named(name, self.findings) } {
                let sub = subs(&entry.key.spelled()).filter(|(first, last)| first == last);
                if sub.is_some_and(|(sub, _)| sub == 0 || sub > count) {
                    let message =
                        say!("`{}` has the element {}, but there are {}", name, entry.key.spelled(), count);
                    let finding = Diagnostic::new(&OUT_OF_RANGE, entry.key.span, message);
                    self.findings
                        .push(finding.severity(Severity::Warning).help("elements are counted from 1"));
                }
                if !sub.is_some_and(|(sub, _)| keep(sub, &entry.value)) {
                    let message =
                        say!("`{}` has no `{}` for `{}`", name, entry.value.spelled(), entry.key.spelled());
                    let finding = Diagnostic::new(&WRONG_TYPE, entry.key.span, message);
                    self.findings.push(finding.help("write a sub-index and its value"));
                }
            }
        };
        listed("names", &mut |sub, tree| {
            compact.names.push((sub, tree.spelled().into()));
            true
        });
        listed("values", &mut |sub, tree| {
            let value = value_of(tree, main.data_type);
            let is_value = value.is_some();
            compact.values.extend(value.map(|value| (sub, value)));
            is_value
        });
        listed("denotations", &mut |sub, tree| {
            compact.denotations.push((sub, tree.spelled().into()));
            true
        });
        compact
    }

    /// The values of an array's elements, listed one per element. Such elements get separate entries.
    fn elements(&mut self, section: &KeyedTable<'_>, count: u8, object: &mut Object) {
        for (name, items) in self.listed(section, count.into()) {
            let items = (1..=count).zip(items);
            if let Some(compact) = object.compact.as_mut().filter(|_| name == "value") {
                for (sub, item) in items {
                    let value = self.value(name, item, &object.main);
                    compact.values.extend(value.map(|value| (sub, value)));
                }
                continue;
            }
            *object = object.expanded().into_owned();
            for (sub, item) in items {
                if let Some(entry) = object.subs.get_mut(sub) {
                    self.put(name, item, entry);
                }
            }
        }
    }

    /// The lists of values among the keys of a section, with one value for each of this many entries.
    fn listed<'t>(&mut self, section: &KeyedTable<'t>, count: usize) -> Vec<(&'static str, &'t [KeyedTree])> {
        let listed = VALUES.into_iter().filter_map(|name| Some((name, items_of(section, name)?)));
        let listed: Vec<_> = listed.collect();
        listed.iter().for_each(|(name, items)| self.count_items(name, *items, count));
        listed.into_iter().map(|(name, (_, items))| (name, items)).collect()
    }

    fn count_items(&mut self, name: &str, (tree, items): (&KeyedTree, &[KeyedTree]), count: usize) {
        if items.len() != count {
            let message = say!("`{}` has {} values for {} entries", name, items.len(), count);
            self.findings.push(Diagnostic::new(&WRONG_TYPE, tree.span, message).help("write one for each"));
        }
    }

    /// The entries of an object, and the resulting properties.
    fn subs(&mut self, index: u16, section: &KeyedTable<'_>, object: &mut Object, unstated: Omissions) {
        let entries = section.named("sub", self.findings);
        self.check_hexadecimal(index, entries);
        let highest_before = Some(object.highest_sub()).filter(|_| object.subs.get(0).is_some());
        let mut seen = BTreeSet::new();
        for entry in entries {
            let name = entry.key.spelled();
            let Some((first, last)) = subs(&name) else {
                let message = say!("`{}` is not a sub-index", name);
                let finding = Diagnostic::new(&UNKNOWN_KEY, entry.key.span, message);
                self.findings
                    .push(finding.help("write one or two hex digits, or a range of them such as `1-8`"));
                continue;
            };
            let Some(section) = KeyedTable::new(&name, &entry.value, ENTRY, self.findings) else { continue };
            if let Some(twice) = (first..=last).find(|sub| !seen.insert(*sub)) {
                let message = say!("sub-index {} is defined twice", format!("{twice:X}"));
                let finding = Diagnostic::new(&DUPLICATE_KEY, entry.key.span, message);
                self.findings.push(finding.help("remove one of them"));
            }
            self.range(index, &section, (first, last), object);
        }
        if object.subs.is_empty() {
            return;
        }
        let highest = object.highest_sub();
        let has_default = |entries: &[objdict_keyed::tree::Pair]| {
            let first =
                entries.iter().find(|entry| subs(&entry.key.spelled()).is_some_and(|(first, _)| first == 0));
            first.is_some_and(|entry| {
                entry.value.get("default").is_some()
                    || entry.value.get("unstated").is_some_and(|unstated| names(unstated, "default"))
            })
        };
        let value = self.defaults.highest(highest, self.defaults.unstated);
        match object.subs.get_mut(0) {
            // the profile's value remains if the number of sub-indexes is unchanged
            Some(_) if highest_before == Some(highest) => {}
            Some(entry) if !has_default(entries) => entry.default = value,
            Some(_) => {}
            None if object.compact.is_none() && !unstated.has(OmittedFact::Sub0) => {
                let first = Entry { default: value, ..self.defaults.implied(EntryRole::First, unstated) };
                object.subs.insert(0, first);
            }
            None => {}
        }
        object.sub_number = sub_number(object, unstated);
        if let Some(number) = section.integer("sub-number", self.findings) {
            object.sub_number = Some(number.value);
        }
    }

    /// Puts an entry into an object, once or for each sub-index of a range.
    fn range(&mut self, index: u16, section: &KeyedTable<'_>, (first, last): (u8, u8), object: &mut Object) {
        let count = usize::from(last - first) + 1;
        self.ranged += count - 1;
        if self.ranged > MAX_RANGED {
            let message = say!("the ranges of sub-indexes have more than {} entries", MAX_RANGED);
            self.findings
                .push(Diagnostic::new(&OUT_OF_RANGE, section.span(), message).help("describe fewer entries"));
            return;
        }
        let listed = self.listed(section, count);
        let address = format!("{index:04X}{first:02X}");
        let mut template: Option<Entry> = None;
        for (at, sub) in (first..=last).enumerate() {
            let role = if sub == 0 { EntryRole::First } else { EntryRole::Sub };
            let before = object.subs.get(sub).cloned();
            let mut entry = match (&template, before) {
                (Some(template), None) => template.clone(),
                (_, before) => self.sub(&address, section, role, before),
            };
            template.get_or_insert_with(|| entry.clone());
            if first != last && section.get("name").is_some() {
                entry.name = numbered(&entry.name, sub).into();
            }
            for (name, item) in listed.iter().filter_map(|(name, items)| Some((*name, items.get(at)?))) {
                self.put(name, item, &mut entry);
            }
            object.subs.insert(sub, entry);
        }
    }

    fn sub(
        &mut self,
        address: &str,
        section: &KeyedTable<'_>,
        role: EntryRole,
        before: Option<Entry>,
    ) -> Entry {
        let (mut entry, _) = self.entry(address, section, role, before);
        if let Some(word) = section.word("object-type", self.findings) {
            entry.object_type = object_type(&word.value);
        }
        entry
    }

    /// Sub-indexes are hexadecimal, but `9` and `10` without `A` look decimal.
    fn check_hexadecimal(&mut self, index: u16, entries: &[objdict_keyed::tree::Pair]) {
        let keys: Vec<String> =
            entries.iter().map(|entry| entry.key.spelled().to_ascii_uppercase()).collect();
        let has = |key: &str| keys.iter().any(|other| other == key);
        if has("9") && has("10") && !["A", "B", "C", "D", "E", "F", "0A"].into_iter().any(has) {
            let at = entries.iter().find(|entry| entry.key.spelled() == "10");
            let message =
                say!("sub-index `10` of {}h is 16: sub-indexes are hexadecimal", format!("{index:04X}"));
            let span = at.map(|entry| entry.key.span).unwrap_or_default();
            let finding = Diagnostic::new(&OUT_OF_RANGE, span, message).severity(Severity::Warning);
            self.findings.push(finding.help("write `A` for the sub-index after `9`"));
        }
    }

    fn said(&self, section: &KeyedTable<'_>) -> Option<TypeSaid> {
        let word = section.get("type")?.text()?;
        TypeSaid::parse(word)
    }

    fn no_type(&mut self, word: &str, span: objdict_model::source::Span) {
        let finding = Diagnostic::new(&WRONG_TYPE, span, say!("`{}` is not a data type", word));
        self.findings.push(match nearest(word, type_words()) {
            _ if word.starts_with("[string(") => {
                finding.help("elements cannot have individual lengths: write `string`")
            }
            Some(meant) => finding.help(say!("did you mean `{}`?", meant)),
            None => finding.help("write a word such as `u16`, or the index of a definition as `0x0023`"),
        });
    }

    /// An entry, and its omissions.
    fn entry(
        &mut self,
        address: &str,
        section: &KeyedTable<'_>,
        role: EntryRole,
        before: Option<Entry>,
    ) -> (Entry, Omissions) {
        let own = Omissions::read(section, self.findings);
        let unstated = own.unwrap_or(match before {
            Some(_) => Omissions::default(),
            None => self.defaults.unstated.of_role(role),
        });
        let mut entry = match before {
            Some(before) => without(before, unstated),
            None if role == EntryRole::First => without(self.defaults.implied(role, unstated), unstated),
            None => self.defaults.implied(role, unstated),
        };
        if let Some(name) = section.text("name", self.findings) {
            entry.name = name.value.into();
        }
        if let Some(word) = section.text("type", self.findings) {
            match TypeSaid::parse(&word.value) {
                Some(said) => {
                    entry.data_type = said.data_type;
                    if said.object_type.is_some() && !unstated.has(OmittedFact::ObjectType) {
                        entry.object_type = said.object_type;
                    }
                    if said.length.is_some() {
                        entry.stack_mut().min_string_length = said.length;
                    }
                }
                None => self.no_type(&word.value, word.at),
            }
        }
        if let Some(access) = section.word("access", self.findings) {
            entry.access = Access::from_name(&access.value);
        }
        if let Some(map) = section.word("map", self.findings) {
            entry.pdo_mapping = mapping(&map.value);
        }
        let has_elements = || self.said(section).is_some_and(|said| said.count.is_some());
        let takes_lists = matches!(role, EntryRole::First | EntryRole::Sub) || has_elements();
        self.values(section, takes_lists, &mut entry);
        self.check_length(section, &entry);
        self.stack(section, &mut entry);
        meaning::read(section, address, &mut entry, &mut self.application, self.findings);
        if let Some(tree) = section.get("extra") {
            let json = pairs(tree);
            entry.extra = serde_json::from_str(&json.to_string()).unwrap_or_default();
        }
        (entry, unstated)
    }

    /// The values of an entry. Lists of them may be read elsewhere, with one value for each of several
    /// entries.
    fn values(&mut self, section: &KeyedTable<'_>, takes_lists: bool, entry: &mut Entry) {
        for name in VALUES {
            if let Some(tree) =
                section.get(name).filter(|_| !takes_lists || items_of(section, name).is_none())
            {
                self.put(name, tree, entry);
            }
        }
        if let Some(flags) = section.integer("flags", self.findings) {
            entry.flags = Some(ObjFlags(flags.value));
        }
        for name in ["denotation", "upload-file", "download-file"] {
            let Some(text) = section.text(name, self.findings) else { continue };
            let configured = entry.configured_mut();
            let field = match name {
                "denotation" => &mut configured.denotation,
                "upload-file" => &mut configured.upload_file,
                _ => &mut configured.download_file,
            };
            *field = Some(text.value.into());
        }
    }

    /// A string has at least the capacity that its type states.
    fn check_length(&mut self, section: &KeyedTable<'_>, entry: &Entry) {
        let length = self.said(section).and_then(|said| said.length);
        let (Some(length), Some(Value::Text(text))) = (length, &entry.default) else { return };
        let (Some(tree), count) = (section.get("default"), text.chars().count()) else { return };
        if u32::try_from(count).is_ok_and(|count| count > length) {
            let message = say!("`default` has {} characters, but its type has room for {}", count, length);
            let finding = Diagnostic::new(&OUT_OF_RANGE, tree.span, message).severity(Severity::Warning);
            self.findings.push(finding.help("write a longer type, or a shorter string"));
        }
    }

    fn stack(&mut self, section: &KeyedTable<'_>, entry: &mut Entry) {
        for name in ["group", "count-label"] {
            let Some(text) = section.text(name, self.findings) else { continue };
            let stack = entry.stack_mut();
            let field = if name == "group" { &mut stack.storage_group } else { &mut stack.count_label };
            *field = Some(text.value.into());
        }
        for name in ["disabled", "detects-change", "io-extension"] {
            let Some(flag) = section.flag(name, self.findings) else { continue };
            let stack = entry.stack_mut();
            let field = match name {
                "disabled" => &mut stack.disabled,
                "detects-change" => &mut stack.detects_change,
                _ => &mut stack.io_extension,
            };
            *field = Some(flag.value);
        }
        if let Some(word) = section.word("srdo", self.findings) {
            entry.stack_mut().srdo_access = SrdoAccess::from_name(&word.value);
        }
    }

    /// Sets one of the values of an entry.
    fn put(&mut self, name: &str, tree: &KeyedTree, entry: &mut Entry) {
        let value = self.value(name, tree, entry);
        match name {
            "default" => entry.default = value,
            "min" => entry.low_limit = value,
            "max" => entry.high_limit = value,
            _ => entry.configured_mut().value = value,
        }
    }

    /// A value of an entry, whose type is known.
    fn value(&mut self, name: &str, tree: &KeyedTree, entry: &Entry) -> Option<Value> {
        let data_type = entry.implied_type();
        let value = value_of(tree, data_type);
        if value.is_none() {
            let word = data_type.map_or("missing".to_owned(), super::words::type_word);
            let wrong =
                tree.text().zip(data_type).and_then(|(text, data_type)| written(text, data_type).err());
            let (message, help) = match wrong {
                Some(NoValue { message, help: Some(help) }) => (say!("`{}`: {}", name, message), help),
                _ => (
                    say!("`{}` is `{}`, which is not a value of the type `{}`", name, tree.spelled(), word),
                    "write a value of its data type, or correct `type`",
                ),
            };
            self.findings.push(Diagnostic::new(&WRONG_TYPE, tree.span, message).help(help));
        }
        value
    }
}

/// The list in a key, and its items.
fn items_of<'t>(section: &KeyedTable<'t>, name: &str) -> Option<(&'t KeyedTree, &'t [KeyedTree])> {
    let tree = section.get(name)?;
    match &*tree.kind {
        Kind::List(items) => Some((tree, items)),
        _ => None,
    }
}

/// Whether a string or a list of strings contains a keyword.
pub(super) fn names(tree: &KeyedTree, word: &str) -> bool {
    match &*tree.kind {
        Kind::List(items) => items.iter().any(|item| item.text() == Some(word)),
        _ => tree.text() == Some(word),
    }
}

/// `SubNumber` of an object that does not state a different one.
pub(super) fn sub_number(object: &Object, unstated: Omissions) -> Option<u8> {
    let count = object.subs.iter().filter(|(sub, _)| *sub != 0xFF).count();
    let is_there =
        !object.subs.is_empty() && object.compact.is_none() && !unstated.has(OmittedFact::SubNumber);
    u8::try_from(count).ok().filter(|_| is_there)
}

/// An entry without its omitted properties.
pub(super) fn without(mut entry: Entry, unstated: Omissions) -> Entry {
    if unstated.has(OmittedFact::ObjectType) {
        entry.object_type = None;
    }
    if unstated.has(OmittedFact::Access) {
        entry.access = None;
    }
    if unstated.has(OmittedFact::Map) {
        entry.pdo_mapping = None;
    }
    if unstated.has(OmittedFact::Default) {
        entry.default = None;
    }
    entry
}

/// A name with the number of a sub-index in it.
pub(super) fn numbered(template: &str, sub: u8) -> String {
    template.replace("{}", &sub.to_string()).replace("{x}", &format!("{sub:X}"))
}

fn object_type(word: &str) -> Option<ObjectType> {
    ObjectType::ALL.into_iter().find(|known| known.name().eq_ignore_ascii_case(word))
}
