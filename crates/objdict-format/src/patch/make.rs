//! Creates a patch from two descriptions: the original, and an edited one.
//!
//! It is the reverse of applying a patch; its text is read again and compared.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::ChangeWords;
use super::apply::make_words;
use super::keys::FORMAT;
use crate::compare::differences;
use crate::patch::fields::{get, set};
use crate::patch::words::{ENTRY, FACTS};
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::printable;
use objdict_model::json::quoted;
use objdict_model::model::field_names::facts_of;
use objdict_model::model::{Device, Part};
use objdict_model::source::Span;

/// The text of a patch that turns the original device into the edited one: with keywords if possible,
/// otherwise with raw data.
pub fn make(original: &Device, edited: &Device) -> String {
    let mut text = head(original);
    let mut maker = PatchMaker { work: original.clone(), edited, text: String::new() };
    maker.facts();
    let indexes: BTreeSet<u16> = original.objects.keys().chain(edited.objects.keys()).copied().collect();
    indexes.into_iter().for_each(|index| maker.object(index));
    maker.raw();
    text.push_str(&maker.text);
    text
}

/// The header of the patch, and the files that it selects.
fn head(original: &Device) -> String {
    let mut text = format!("format = \"{FORMAT}\"\n");
    let identity = original.identity();
    let info = original.device_info.as_ref();
    let mut number = |key: &str, object: Option<u32>, info: Option<u32>| {
        if let Some(number) = object.filter(|&number| number != 0 || info.is_none()).or(info) {
            let _ = writeln!(text, "{key} = 0x{number:X}");
        }
    };
    number("vendor-id", identity.vendor_id, info.and_then(|info| info.vendor_number));
    number("product-code", identity.product_code, info.and_then(|info| info.product_number));
    number("revision", identity.revision_number, info.and_then(|info| info.revision_number));
    text
}

struct PatchMaker<'a> {
    /// The result of the patch so far.
    work: Device,
    edited: &'a Device,
    text: String,
}

impl PatchMaker<'_> {
    fn facts(&mut self) {
        for (name, part, _) in FACTS {
            self.fields(&part, name);
        }
    }

    fn object(&mut self, index: u16) {
        let name = format!("{index:04X}");
        let part = Part::Object(index);
        match (self.work.object(index), self.edited.object(index)) {
            (Some(before), Some(after)) if before == after => {}
            (Some(before), Some(after)) => {
                let subs: BTreeSet<u8> =
                    before.subs.iter().chain(after.subs.iter()).map(|(sub, _)| sub).collect();
                let compact =
                    [before, after].map(|object| object.compact.as_ref().map_or(0, |compact| compact.count));
                let subs: BTreeSet<u8> = subs.into_iter().chain(1..=compact[0].min(compact[1])).collect();
                self.fields(&part, &name);
                subs.into_iter().for_each(|sub| self.entry(index, sub));
            }
            (Some(_), None) => self.remove(&part, &name),
            (None, Some(after)) => {
                let subs: Vec<u8> = after.subs.iter().map(|(sub, _)| sub).collect();
                self.add(&part, &name);
                subs.into_iter()
                    .for_each(|sub| self.add(&Part::Entry(index, sub), &format!("{name}:{sub:X}")));
            }
            (None, None) => {}
        }
    }

    fn entry(&mut self, index: u16, sub: u8) {
        let (part, name) = (Part::Entry(index, sub), format!("{index:04X}:{sub:X}"));
        let has = |device: &Device| device.object(index).is_some_and(|object| object.subs.get(sub).is_some());
        let is_there = |device: &Device| device.object(index).is_some_and(|object| object.has(sub));
        match (has(&self.work), has(self.edited)) {
            (true, false) => self.remove(&part, &name),
            // keywords do not support a described entry of compact storage
            (false, true) if is_there(&self.work) => {}
            (false, true) => self.add(&part, &name),
            _ => self.fields(&part, &name),
        }
    }

    /// The fields that differ, each with its old value.
    fn fields(&mut self, part: &Part, name: &str) {
        let words = words_of(part);
        let before: Vec<Option<Kind>> = words.iter().map(|word| get(&self.work, part, word)).collect();
        let (mut expect, mut absent, mut set, mut unset) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (word, before) in words.into_iter().zip(before) {
            let after = get(self.edited, part, word);
            if same(&get(&self.work, part, word), &after) || !self.becomes(part, word, after.as_ref()) {
                continue;
            }
            match &before {
                Some(before) => expect.push(format!("{word} = {}", toml(before))),
                None => absent.push(quoted(word)),
            }
            match &after {
                Some(after) => set.push(format!("{word} = {}", toml(after))),
                None => unset.push(quoted(word)),
            }
        }
        if set.is_empty() && unset.is_empty() {
            return;
        }
        let _ = writeln!(self.text, "\n[[change]]\nat = {}", quoted(name));
        for (key, open, items, close) in [
            ("expect", "{ ", expect, " }"),
            ("absent", "[", absent, "]"),
            ("set", "{ ", set, " }"),
            ("unset", "[", unset, "]"),
        ] {
            if !items.is_empty() {
                let _ = writeln!(self.text, "{key} = {open}{}{close}", items.join(", "));
            }
        }
    }

    /// Sets a field of the work, unless the keyword cannot express all of it or it is not valid.
    fn becomes(&mut self, part: &Part, word: &str, after: Option<&Kind>) -> bool {
        let object = part.object().and_then(|index| self.work.object(index).cloned());
        // a group or a bit type exists, and nothing else for a keyword
        let application = matches!(word, "bits" | "group").then(|| self.work.application.clone());
        let value = after.map(|kind| KeyedTree::new(Span::default(), kind.clone()));
        let is_set = set(&mut self.work, part, word, value.as_ref()).is_ok();
        if is_set && same(&get(&self.work, part, word), &after.cloned()) && self.is_sound(part, word) {
            return true;
        }
        if let (Some(index), Some(object)) = (part.object(), object) {
            self.work.objects.insert(index, object);
        }
        if let Some(application) = application {
            self.work.application = application;
        }
        false
    }

    /// Whether all values of the entry are valid for a new type.
    fn is_sound(&self, part: &Part, word: &str) -> bool {
        let entry = crate::patch::fields::entry(&self.work, part);
        word != "type" || entry.is_none_or(|entry| entry.invalid_values.is_empty())
    }

    fn remove(&mut self, part: &Part, name: &str) {
        let words = ChangeWords { is_removed: true, ..ChangeWords::of(part.clone()) };
        if make_words(&mut self.work, &words).is_ok() {
            let _ = writeln!(self.text, "\n[[change]]\nat = {}\nremove = true", quoted(name));
        }
    }

    fn add(&mut self, part: &Part, name: &str) {
        let words = ChangeWords { add: Some(Vec::new()), ..ChangeWords::of(part.clone()) };
        if make_words(&mut self.work, &words).is_err() {
            return;
        }
        let mut fields = Vec::new();
        for word in words_of(part) {
            if let Some(kind) = get(self.edited, part, word)
                && self.becomes(part, word, Some(&kind))
            {
                fields.push(format!("{word} = {}", toml(&kind)));
            }
        }
        let _ = writeln!(self.text, "\n[[change]]\nat = {}\nadd = {{ {} }}", quoted(name), fields.join(", "));
    }

    /// The remaining differences, value by value.
    fn raw(&mut self) {
        for difference in differences(&self.work, self.edited) {
            let _ = writeln!(self.text, "\n[[raw]]\npath = {}", quoted(&difference.path));
            for (key, datum) in [("expect", difference.left), ("set", difference.right)] {
                if let Some(datum) = datum {
                    let _ = writeln!(self.text, "{key} = {}", literal(datum.text()));
                }
            }
        }
    }
}

/// The keywords that a part may have.
fn words_of(part: &Part) -> Vec<&'static str> {
    match facts_of(part) {
        Some(facts) => facts.iter().map(|row| row.eds).collect(),
        None => ENTRY.iter().map(|key| key.name).collect(),
    }
}

/// Whether two fields have equal values.
fn same(one: &Option<Kind>, other: &Option<Kind>) -> bool {
    one.as_ref().map(toml) == other.as_ref().map(toml)
}

/// A value in TOML.
fn toml(kind: &Kind) -> String {
    match kind {
        Kind::Null => "\"\"".to_owned(),
        Kind::Bool(flag) => flag.to_string(),
        Kind::Integer(number) if i64::try_from(*number).is_ok() => number.to_string(),
        Kind::Integer(number) => quoted(&number.to_string()),
        Kind::Float(number) => format!("{number:?}"),
        Kind::Text(text) => quoted(text),
        Kind::List(items) => {
            format!("[{}]", items.iter().map(|item| toml(&item.kind)).collect::<Vec<_>>().join(", "))
        }
        Kind::Map(entries) => {
            let entry = |key: &KeyedTree, value: &KeyedTree| {
                format!("{} = {}", quoted(&key.spelled()), toml(&value.kind))
            };
            let entries: Vec<String> = entries.iter().map(|of| entry(&of.key, &of.value)).collect();
            format!("{{ {} }}", entries.join(", "))
        }
    }
}

/// A string that contains quotes, without escapes if possible.
fn literal(text: &str) -> String {
    let is_plain = !text.contains(['\'', '\t']) && printable(text) == text;
    if is_plain { format!("'{text}'") } else { quoted(text) }
}
