//! What all parts of a page are made of.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::options::Options;
use super::subject::{Identifiers, Subject};
use super::texts::LanguageTexts;
use crate::Language;
use crate::describe::Decoder;
use crate::model::{Device, Entry, Meanings};

/// Shared state for building a page.
pub(crate) struct Context<'a> {
    pub(crate) device: &'a Device,
    /// The node-ID for formulas.
    pub(crate) node_id: Option<u8>,
    /// Describes values.
    pub(crate) decoder: Decoder<'a>,
    pub(crate) language: Language,
    pub(crate) texts: &'static LanguageTexts,
    /// The language of description texts.
    pub(crate) tag: &'a str,
    /// Meanings of values; `None` if the description has none.
    pub(crate) meanings: Option<Meanings<'a>>,
    /// The PDOs that map an entry.
    carriers: BTreeMap<(u16, u8), Vec<String>>,
    pub(super) identifiers: &'a Identifiers,
}

impl<'a> Context<'a> {
    pub(crate) fn new(subject: &Subject<'a>, options: &'a Options) -> Self {
        let device = subject.device;
        let language = options.own_language();
        let says_meanings = !device.application.is_empty()
            || device.objects.values().any(|object| object.described().any(|(_, of)| of.parameter.is_some()));
        let node_id = options.node_id.filter(|id| (1..=127).contains(id)).or(device.node_id());
        Self {
            device,
            node_id,
            decoder: Decoder { language, ..Decoder::english(device, node_id) },
            language,
            texts: LanguageTexts::of(language),
            tag: options.tag(),
            meanings: says_meanings.then(|| device.meanings_in(options.tag())),
            carriers: carriers(device),
            identifiers: subject.identifiers,
        }
    }

    /// The PDOs that map an entry.
    pub(super) fn carriers(&self, index: u16, sub: u8) -> Vec<String> {
        self.carriers.get(&(index, sub)).cloned().unwrap_or_default()
    }

    /// The name of an entry in the language of the page, and the name in the file if it differs.
    pub(super) fn names(&self, entry: Cow<'a, Entry>) -> (Cow<'a, str>, Option<Cow<'a, str>>) {
        match entry {
            Cow::Borrowed(entry) => {
                let name = self.name(entry);
                (
                    name.into(),
                    Some(&*entry.name).filter(|own| *own != name && !own.is_empty()).map(Into::into),
                )
            }
            Cow::Owned(entry) => {
                let name = self.name(&entry).to_owned();
                let own_name = Some(entry.name.into_string()).filter(|own| *own != name && !own.is_empty());
                (name.into(), own_name.map(Into::into))
            }
        }
    }

    /// The name of an entry in the language of the page, else the name in the file, else a placeholder.
    pub(super) fn name<'e>(&self, entry: &'e Entry) -> &'e str {
        let label = entry.parameter.as_ref().and_then(|parameter| parameter.labels.name_in(self.tag));
        match label.map(str::trim).filter(|label| !label.is_empty()) {
            Some(label) => label,
            None if entry.name.is_empty() => self.texts.no_name,
            None => &entry.name,
        }
    }
}

/// The PDOs that map each entry.
fn carriers(device: &Device) -> BTreeMap<(u16, u8), Vec<String>> {
    let mut carriers: BTreeMap<(u16, u8), Vec<String>> = BTreeMap::new();
    for pdo in device.pdos() {
        let name = pdo.to_string();
        for mapped in pdo.mapped().filter(|mapped| !mapped.is_dummy()) {
            let names = carriers.entry((mapped.index, mapped.sub)).or_default();
            // list a PDO that maps the entry twice only once; it would be the last in the list
            if names.last() != Some(&name) {
                names.push(name.clone());
            }
        }
    }
    carriers
}
