//! The content of a page in reading order.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::card::Card;
use super::communication::Communication;
use super::downloads::{self, DownloadView};
use super::finding::Found;
use super::groups::{self, ShownGroup};
use super::object::{self, Area};
use super::states::{self, ErrorCode, StatesView};
use super::texts::Texts;
use super::{Identifiers, Options, Subject};
use crate::Language;
use crate::describe::Decoder;
use crate::model::{Device, Entry, Meanings};

/// The documentation of a device in words.
pub(crate) struct Page<'a> {
    pub(crate) language: Language,
    pub(crate) texts: &'static Texts,
    pub(crate) title: String,
    /// The node-ID for formulas.
    pub(crate) node_id: Option<u8>,
    pub(crate) card: Card,
    /// The findings of `check` by rule; `None` if it did not run.
    pub(crate) findings: Option<Vec<Found<'a>>>,
    pub(crate) communication: Communication,
    /// What configures the node, in order; empty for a device type.
    pub(crate) downloads: Vec<DownloadView>,
    /// The state machine of the device profile.
    pub(crate) states: Option<StatesView>,
    /// The error codes that EMCY may have; empty if the device profile has none.
    pub(crate) error_codes: Vec<ErrorCode>,
    pub(crate) areas: Vec<Area<'a>>,
    pub(crate) groups: Vec<ShownGroup<'a>>,
    /// Whether any entry has a configured value.
    pub(crate) is_configured: bool,
    /// The URL of the index of the site; `None` for a page alone.
    pub(crate) site: Option<String>,
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
            downloads: downloads::downloads(context),
            states: states::states(context),
            error_codes: states::error_codes(context),
            groups: groups::groups(context),
            areas,
            is_configured,
            site: None,
        }
    }

    /// The CAN-ID of the default SDO request in hex; `6xx` if the node-ID is unknown (CiA 301 §7.3.5).
    pub(crate) fn sdo_can_id(&self) -> String {
        self.node_id.map_or_else(|| "6xx".to_owned(), |node| format!("{:X}", 0x600 + u16::from(node)))
    }

    /// The number of findings.
    pub(crate) fn finding_count(&self) -> usize {
        self.findings.iter().flatten().map(|found| found.findings.len()).sum()
    }

    /// The number of objects.
    pub(crate) fn object_count(&self) -> usize {
        self.areas.iter().map(|area| area.objects.len()).sum()
    }

    /// Whether browsers need long to lay out parts outside the viewport.
    pub(crate) fn is_large(&self) -> bool {
        self.entry_count() > 1500
    }

    /// The number of entries.
    pub(crate) fn entry_count(&self) -> usize {
        self.areas.iter().flat_map(|area| &area.objects).map(|object| object.entries.len()).sum()
    }
}

/// Shared state for building a page.
pub(crate) struct Context<'a> {
    pub(crate) device: &'a Device,
    /// The node-ID for formulas.
    pub(crate) node_id: Option<u8>,
    /// Describes values.
    pub(crate) decoder: Decoder<'a>,
    pub(crate) language: Language,
    pub(crate) texts: &'static Texts,
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
            decoder: Decoder { device, node_id, language },
            language,
            texts: Texts::of(language),
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
