//! The common input of all parts of a page: the documented device, the output format, and the options.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::finding::Finding;
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

    /// The name of an entry in the language of the page, and the name in the file if that differs.
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

    /// The name of an entry in the language of the page, otherwise the name in the file, otherwise a
    /// placeholder.
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
            let names = carriers.entry(mapped.entry()).or_default();
            // list a PDO that maps the entry twice only once; a duplicate would be the last in the list
            if names.last() != Some(&name) {
                names.push(name.clone());
            }
        }
    }
    carriers
}

/// Options of the documentation.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The title (default: product name).
    pub title: Option<String>,
    /// The node-ID for COB-IDs, 1 to 127 (default: from the configured node, if any).
    pub node_id: Option<u8>,
    /// The language of names and descriptions, if the description has several (RFC 5646, such as `de`).
    /// Headings and sentences also use it if objdict supports it ([`Language::of_tag`]), otherwise
    /// English.
    pub language: Option<String>,
    /// The address of a workbench, the page that edits descriptions (default: no link to one). It is a URL of HTTP or a path.
    pub workbench: Option<String>,
}

impl Options {
    /// The language of headings and sentences.
    pub fn own_language(&self) -> Language {
        self.language.as_deref().and_then(Language::of_tag).unwrap_or_default()
    }

    /// The language of description texts.
    pub(crate) fn tag(&self) -> &str {
        self.language.as_deref().unwrap_or("en")
    }
}

/// The documented device with its context.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The device.
    pub device: &'a Device,
    /// The file name shown to readers.
    pub file: &'a str,
    /// The format of the file: `EDS`, `DCF`, `XDD`, `XDC`, `JSON`.
    pub format: &'a str,
    /// The findings of `check`; `None` if it did not run.
    pub findings: Option<&'a [Finding]>,
    /// Identifiers in generated code; empty if unknown.
    pub identifiers: &'a Identifiers,
}

/// Identifiers of objects (no sub-index) and entries in generated code.
pub type Identifiers = BTreeMap<(u16, Option<u8>), CodeName>;

/// The identifiers of an object or an entry in generated code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeName {
    /// The constant in Rust: `od::identity_object::VENDOR_ID`.
    pub rust: String,
    /// The macro in C: `OD_IDENTITY_OBJECT_VENDOR_ID`.
    pub c: String,
}

/// Output formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A self-contained HTML page.
    Html,
    /// A Markdown file with tables, as GitHub and GitLab render them.
    Markdown,
    /// One line per entry.
    Csv,
}

impl Form {
    /// All formats.
    pub const ALL: [Self; 3] = [Self::Html, Self::Markdown, Self::Csv];

    /// The format for a file extension (without the dot).
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|form| form.extension().eq_ignore_ascii_case(extension))
    }

    /// The file extension.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Html => "html",
            Self::Markdown => "md",
            Self::Csv => "csv",
        }
    }
}
