//! A parsed description: the device together with its source text.
//!
//! It and the parent module import each other, because a description reads and writes every format.

mod edits;
mod ini;
#[cfg(feature = "full")]
mod rewritten;
#[cfg(feature = "xdd")]
mod xml;

use std::borrow::Cow;
use std::path::PathBuf;
use std::sync::OnceLock;

use super::Format;
use crate::text::{self, DescriptionText};
use objdict_eds::eds;
use objdict_eds::ini::Document;
use objdict_model::diagnostic::{At, Findings, one_line};
use objdict_model::model::{Device, EMBEDDED_COMMENT, EMBEDDED_SECTION, ObjectList, Place};
use objdict_model::source::{SourceFile, Span};
#[cfg(feature = "xdd")]
use objdict_xdd::xml::Tree;

/// A parsed description: the device, its source text, and the findings of the reader.
#[derive(Debug)]
pub struct Description {
    format: Format,
    text: Box<dyn DescriptionText>,
    /// The number of the device in the file.
    number: usize,
    device: Device,
    /// The device without disabled objects, if there are any.
    enabled: OnceLock<Option<Box<Device>>>,
    findings: Findings,
    /// The type description of this node.
    origin: Option<Box<Self>>,
    /// The patches that changed the device relative to the text.
    #[cfg(feature = "full")]
    patched: Option<Box<super::patch::Patched>>,
}

/// The name of a file as a description states it: on one line, in any encoding.
pub fn stated_name(name: &str) -> String {
    one_line(name).replace(char::REPLACEMENT_CHARACTER, "_")
}

impl Description {
    pub(super) fn read(source: SourceFile, format: Format, before: Option<&Self>) -> Self {
        let read = match format.syntax() {
            #[cfg(feature = "xdd")]
            super::Syntax::Xml => xml::read(source, format.kind()),
            #[cfg(feature = "full")]
            super::Syntax::Toml => super::device_toml::document::read(source),
            // a build without XDD finds only junk in one
            _ => ini::read(source, format.kind(), before.and_then(|before| before.text.read_lines())),
        };
        let mut read = Self::of(format, 0, read);
        // a source keeps the name of the description generated from it
        if read.device_count() == 1 && format != Format::Toml {
            eds::file_name::check(&read.device, read.text.source().name(), &mut read.findings);
        }
        read
    }

    fn of(format: Format, number: usize, (text, device, findings): text::ReadText) -> Self {
        Self {
            format,
            text,
            number,
            device,
            enabled: OnceLock::new(),
            findings,
            origin: None,
            #[cfg(feature = "full")]
            patched: None,
        }
    }

    /// The same file with new bytes; `None` if they are not text, or describe fewer devices.
    pub fn with_bytes(&self, bytes: Vec<u8>) -> Option<Self> {
        Self::read(self.source().with_bytes(bytes).ok()?, self.format, None).select(self.number)
    }

    /// The number of devices in the file. A network of CANopenEditor (`.nxdd`, `.nxdc`) describes several; this
    /// description is of the first, unless a different one is [selected](Self::select).
    pub fn device_count(&self) -> usize {
        self.text.device_count()
    }

    /// Selects the description of a device of the same file by number, from 0; `None` if there are fewer.
    #[must_use]
    pub fn select(self, number: usize) -> Option<Self> {
        if number == self.number { Some(self) } else { self.sibling(number) }
    }

    /// The description of a device of the same XML file by number, from 0, which shares the text; `None` if there are
    /// fewer. In a `device.toml`, the second and later ones are its variants.
    pub fn sibling(&self, number: usize) -> Option<Self> {
        // a requested variant is the only device
        if self.number == 0 && self.variant().is_some() {
            return None;
        }
        let read = Self::of(self.format, number, self.text.sibling(number)?);
        #[cfg(feature = "full")]
        let read = read.with_patches_of(self);
        Some(read)
    }

    /// The description of a variant of a `device.toml`, as the only device of the file.
    ///
    /// # Errors
    /// If there is no variant of this name: the existing names.
    pub(super) fn into_variant(self, name: &str) -> Result<Self, Vec<String>> {
        let variants = self.text.variants();
        let number = variants.iter().position(|variant| variant == name);
        let variant = number.and_then(|number| self.sibling(number + 1));
        variant.map(|variant| Self { number: 0, ..variant }).ok_or_else(|| variants.to_vec())
    }

    /// Whether the text does not fully define the device, because it is a variant or extends another file. It
    /// is then not edited.
    pub fn is_composed(&self) -> bool {
        self.variant().is_some() || self.extended().is_some()
    }

    /// The file that a `device.toml` extends, as named in the text, and its position there.
    pub fn extended(&self) -> Option<(&str, Span)> {
        self.text.extended()
    }

    /// The files that a `device.toml` extends, which define a part of the device.
    pub fn extended_files(&self) -> &[PathBuf] {
        self.text.extended_files()
    }

    /// The name of its variant; `None` for a file as a whole.
    pub fn variant(&self) -> Option<&str> {
        self.text.variant()
    }

    /// Applies a function to each device of the file, from this one on.
    pub fn map_devices<T>(&self, mut make: impl FnMut(&Self) -> T) -> Vec<T> {
        let mut made = vec![make(self)];
        let others = (self.number + 1..).map_while(|number| self.sibling(number));
        made.extend(others.map(|other| make(&other)));
        made
    }

    /// The number of its device in the file, from 0.
    pub fn number(&self) -> usize {
        self.number
    }

    /// The format that it was read as.
    pub fn format(&self) -> Format {
        self.format
    }

    /// The source.
    pub fn source(&self) -> &SourceFile {
        self.text.source()
    }

    /// The text as lines; `None` if it is not an INI file.
    pub fn document(&self) -> Option<&Document> {
        self.text.lines()
    }

    /// The text as elements; `None` if it is not XML.
    #[cfg(feature = "xdd")]
    pub fn tree(&self) -> Option<&Tree> {
        self.text.tree()
    }

    /// Whether the text is a project of a CANopenNode editor from before XDD, or of objdictgen. Projects are never
    /// changed.
    pub fn is_project(&self) -> bool {
        self.text.is_project()
    }

    /// Whether the text is a network of several devices.
    pub fn is_network(&self) -> bool {
        self.text.is_network()
    }

    /// The bytes of the file, reassembled from the text: always identical to the input.
    pub fn print(&self) -> Vec<u8> {
        self.document().map_or_else(|| self.source().to_bytes(), Document::print)
    }

    /// The device: without the objects that are [disabled](Device::without_disabled).
    pub fn device(&self) -> &Device {
        let enabled = self.enabled.get_or_init(|| match self.device.without_disabled() {
            Cow::Owned(enabled) => Some(Box::new(enabled)),
            Cow::Borrowed(_) => None,
        });
        enabled.as_deref().unwrap_or(&self.device)
    }

    /// The complete described device including disabled objects, for writing it as a description again.
    pub fn described(&self) -> &Device {
        &self.device
    }

    /// Adds the type description to that of a configured node, for additional checks.
    #[must_use]
    pub fn with_origin(self, origin: Self) -> Self {
        Self { origin: Some(Box::new(origin)), ..self }
    }

    /// The type description of the node, if it was [given](Self::with_origin); labels at [`At::Node`] point into it.
    pub fn origin(&self) -> Option<&Self> {
        self.origin.as_deref()
    }

    /// Returns the device without its text.
    pub fn into_device(self) -> Device {
        self.device();
        self.enabled.into_inner().flatten().map_or(self.device, |enabled| *enabled)
    }

    /// Returns the [described](Self::described) device without its text.
    pub fn into_described(self) -> Device {
        self.device
    }

    /// The spans of dictionary objects, by index, in text order; an object may have several. Empty if unknown.
    pub fn object_spans(&self) -> Vec<(u16, Span)> {
        self.text.objects()
    }

    /// The span of a place of the model in the text; `None` if it has no text.
    pub fn locate(&self, place: &Place) -> Option<Span> {
        self.text.locate(place)
    }

    /// The span of a label in the text; the start of the text if it has none.
    pub fn span_of(&self, at: &At) -> Span {
        match at {
            At::Span(span) => *span,
            At::Patch(..) => Span::default(),
            At::Place(place) | At::Node(_, place) => self.locate(place).unwrap_or_default(),
        }
    }

    /// The place in the model that a label points to; for a label in the text, that of its section or
    /// element. `None` outside the parts of a description.
    pub fn place_of<'a>(&self, at: &'a At) -> Option<Cow<'a, Place>> {
        let span = match at {
            At::Place(place) | At::Node(_, place) => return Some(Cow::Borrowed(place)),
            At::Patch(..) => return None,
            At::Span(span) => span,
        };
        self.text.place_at(span.start).map(Cow::Owned)
    }

    /// The findings of the format reader about spelling and structure.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// The device as other tools read it, without content embedded in comments; `None` if there is none.
    pub fn seen_by_others(&self) -> Option<Device> {
        let document = self.document().filter(|document| document.text().contains(EMBEDDED_COMMENT))?;
        let (mut device, _) = eds::read(document, self.format.kind());
        device.extra.retain(|section| section.name() != EMBEDDED_SECTION);
        Some(device)
    }

    /// Content of the text that other tools cannot read, with `device` as read; see `compat`.
    pub fn portability_findings(&self, device: &Device) -> Findings {
        let mut findings = Findings::new();
        if let Some(document) = self.document() {
            eds::portability::check(document, device, &mut findings);
        }
        findings
    }

    /// Violations of the CiA 311 schema in the text of an XDD or XDC.
    pub fn violations(&self) -> Findings {
        self.text.violations()
    }

    /// The same description with only some objects in its object lists, to check a part of a text.
    #[doc(hidden)] // for the crate that tries fixes
    #[must_use]
    pub fn listing_only(mut self, is_listed: impl Fn(u16) -> bool) -> Self {
        for list in ObjectList::ALL {
            let members = self.device.lists.get_mut(list);
            members.iter_mut().for_each(|members| members.retain(|&index| is_listed(index)));
        }
        self
    }

    /// Whether the text has no schema violations that `other`, of the same description, does not have.
    pub fn is_as_valid_as(&self, other: &Self) -> bool {
        text::is_as_valid(&*self.text, &*other.text)
    }

    /// Additional findings about the text: the lines of an INI file, the structure of XML. Computed on demand. If a
    /// file describes several devices, they belong to the first.
    pub fn text_findings(&self) -> Findings {
        self.text.findings()
    }
}
