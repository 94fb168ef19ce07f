//! All that is to be said of a device, in the order in which it is said.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::card::Card;
use super::communication::Communication;
use super::finding::Found;
use super::groups::{self, ShownGroup};
use super::object::{self, Area};
use super::texts::Texts;
use super::{Identifiers, Options, Subject};
use crate::Language;
use crate::describe::Decoder;
use crate::model::{Device, Entry, Meanings};

/// The documentation of a device, in words.
#[derive(Debug)]
pub(crate) struct Page<'a> {
    pub(crate) language: Language,
    pub(crate) texts: &'static Texts,
    pub(crate) title: String,
    /// The node that formulas are worked out for.
    pub(crate) node_id: Option<u8>,
    pub(crate) card: Card,
    /// What `check` found, by rule; `None` where nothing was checked.
    pub(crate) findings: Option<Vec<Found<'a>>>,
    pub(crate) communication: Communication,
    pub(crate) areas: Vec<Area<'a>>,
    pub(crate) groups: Vec<ShownGroup<'a>>,
    /// Whether an entry has a value beside its default.
    pub(crate) is_configured: bool,
}

impl<'a> Page<'a> {
    pub(crate) fn new(subject: &Subject<'a>, options: &'a Options, context: &Context<'a>) -> Self {
        let areas = object::areas(context);
        let card = Card::new(subject, context);
        let is_configured = areas
            .iter()
            .flat_map(|area| &area.objects)
            .flat_map(|object| &object.entries)
            .any(|entry| entry.value.is_some());
        Self {
            language: context.language,
            texts: context.texts,
            title: options.title.clone().unwrap_or_else(|| card.title.clone()),
            node_id: context.node_id,
            card,
            findings: subject.findings.map(Found::by_rule),
            communication: Communication::new(&context.decoder, &|entry| context.name(entry).to_owned()),
            groups: groups::groups(context),
            areas,
            is_configured,
        }
    }

    /// The CAN-ID of the default SDO to the device in hex; `6xx` where the node is not known (CiA 301 §7.3.5).
    pub(crate) fn sdo_can_id(&self) -> String {
        self.node_id.map_or_else(|| "6xx".to_owned(), |node| format!("{:X}", 0x600 + u16::from(node)))
    }

    /// How many findings there are.
    pub(crate) fn finding_count(&self) -> usize {
        self.findings.iter().flatten().map(|found| found.findings.len()).sum()
    }

    /// How many objects there are.
    pub(crate) fn object_count(&self) -> usize {
        self.areas.iter().map(|area| area.objects.len()).sum()
    }

    /// Whether it takes a browser long to lay out what is not in its window.
    pub(crate) fn is_large(&self) -> bool {
        self.entry_count() > 1500
    }

    /// How many entries they have.
    pub(crate) fn entry_count(&self) -> usize {
        self.areas.iter().flat_map(|area| &area.objects).map(|object| object.entries.len()).sum()
    }
}

/// What the parts of a page are made of.
#[derive(Debug)]
pub(crate) struct Context<'a> {
    pub(crate) device: &'a Device,
    /// The node that formulas are worked out for.
    pub(crate) node_id: Option<u8>,
    /// Says what values mean.
    pub(crate) decoder: Decoder<'a>,
    pub(crate) language: Language,
    pub(crate) texts: &'static Texts,
    /// The language of texts of the description.
    pub(crate) tag: &'a str,
    /// What values mean; `None` where the description says that of none.
    pub(crate) meanings: Option<Meanings<'a>>,
    /// The PDOs that carry an entry, in words.
    carriers: BTreeMap<(u16, u8), String>,
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
            decoder: Decoder { device, node_id, language },
            language,
            texts: Texts::of(language),
            tag: options.tag(),
            meanings: says_meanings.then(|| device.meanings_in(options.tag())),
            carriers: carriers(device),
            identifiers: subject.identifiers,
        }
    }

    /// The PDOs that carry an entry.
    pub(super) fn carriers(&self, index: u16, sub: u8) -> Option<String> {
        self.carriers.get(&(index, sub)).cloned()
    }

    /// The name of an entry in the language of the page, and the name in the file where that is another one.
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

    /// The name of an entry in the language of the page, else in the file, else words for none.
    pub(super) fn name<'e>(&self, entry: &'e Entry) -> &'e str {
        let label = entry.parameter.as_ref().and_then(|parameter| parameter.labels.name_in(self.tag));
        match label.map(str::trim).filter(|label| !label.is_empty()) {
            Some(label) => label,
            None if entry.name.is_empty() => self.texts.no_name,
            None => &entry.name,
        }
    }
}

/// What each entry is carried by.
fn carriers(device: &Device) -> BTreeMap<(u16, u8), String> {
    let mut carriers: BTreeMap<(u16, u8), String> = BTreeMap::new();
    for pdo in device.pdos() {
        let name = pdo.to_string();
        for mapped in pdo.mapped().filter(|mapped| !mapped.is_dummy()) {
            let names = carriers.entry((mapped.index, mapped.sub)).or_default();
            // one that carries it twice is told once, and it would be the last
            if names.rsplit(", ").next() != Some(&name) {
                if !names.is_empty() {
                    names.push_str(", ");
                }
                names.push_str(&name);
            }
        }
    }
    carriers
}
