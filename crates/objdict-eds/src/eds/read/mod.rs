//! Reads EDS and DCF texts into the model. Reading never fails: unreadable content becomes a finding or
//! an invalid value.
//!
//! If a key or section occurs twice, the first one is used; object lists are merged. Findings report both cases.

mod again;
mod compact;
mod dictionary;
mod directions;
mod dynamic;
mod info;
mod items;
mod lists;
mod modules;
mod objects;

use std::collections::{BTreeSet, HashSet};
use std::hash::{BuildHasher, RandomState};

pub use self::again::{BeforeEdit, SectionStarts};
use self::dictionary::DictionaryReader;
use self::items::Items;
use super::findings::{self, DuplicateKind};
use super::section::{NameSpelling, SectionName};
use crate::diagnostic::{Findings, MAX_PER_RULE};
use crate::ini::{self, Document, Header, LineKind};
use crate::model::{
    Device, DeviceKind, EMBEDDED_COMMENT, EMBEDDED_SECTION, Entry, Extra, ExtraSection, Objects, Part, Place,
};
use crate::source::Span;

/// Reads a document as the description of a device type or, if `kind` requests it or there is a
/// commissioning section, of a node.
pub fn read(document: &Document, kind: DeviceKind) -> (Device, Findings) {
    let read = read_first(document, kind);
    (read.device, read.findings)
}

/// The result of reading a document.
#[derive(Debug)]
pub struct ReadDocument {
    /// The device.
    pub device: Device,
    /// The findings of the reader.
    pub findings: Findings,
    /// Objects described only by their own sections, if these have no findings.
    pub plain: Objects,
}

/// Like [`read`], with the data that is needed to read the document again after an edit.
pub fn read_first(document: &Document, kind: DeviceKind) -> ReadDocument {
    let mut reader = EdsReader::new(document.text());
    let mut embedded = Extra::default();
    document.visit(
        |section| reader.section(section),
        |line| {
            if let Some((key, value)) = embedded_in(line.span.of(document.text())) {
                embedded.push(key, value);
            }
        },
    );
    reader.keep(EMBEDDED_SECTION, &embedded);
    reader.finish(kind, Objects::default())
}

/// Like [`read_first`], based on the result before an edit: unchanged objects are not read again.
pub fn read_after(
    document: &Document,
    kind: DeviceKind,
    before: &BeforeEdit<'_>,
) -> (ReadDocument, SectionStarts) {
    let (sections, unchanged) = again::unchanged(document, before);
    if unchanged.is_empty() {
        return (read_first(document, kind), sections);
    }
    let mut reader = EdsReader::new(document.text());
    reader.section(&document.headless());
    let changed = sections.without(&unchanged).filter_map(|start| document.section_at(start));
    changed.for_each(|section| reader.section(&section));
    (reader.finish(kind, unchanged), sections)
}

/// The embedded content in a comment line, which the format does not support otherwise.
pub(super) fn embedded_in(line: &str) -> Option<(&str, &str)> {
    let (key, value) = line.trim().strip_prefix(';')?.strip_prefix(EMBEDDED_COMMENT)?.split_once('=')?;
    Some((key.trim(), value.trim()))
}

/// The comment lines that contain neither embedded content nor a setting of CANopenEditor.
pub fn comments(document: &Document) -> impl Iterator<Item = Span> {
    let is_read = |span: &Span| {
        let mut entry = Entry::default();
        objects::stack_option(&mut entry, span.of(document.text()));
        entry.stack.is_some() || embedded_in(span.of(document.text())).is_some()
    };
    let comments = document.lines().filter(|line| line.kind == LineKind::Comment).map(|line| line.span);
    comments.filter(move |span| !is_read(span))
}

/// A description during reading.
struct EdsReader<'a> {
    text: &'a str,
    device: Device,
    /// The objects of the device.
    objects: DictionaryReader,
    findings: Findings,
    /// Objects with findings, or that more than their own sections describe.
    odd: BTreeSet<u16>,
    /// The parts found so far, except objects and their entries, which are in the dictionary.
    seen: HashSet<Part>,
    /// Sections that can only be read once their objects are known, which may be defined later.
    compact: Vec<(Part, ini::Section)>,
    /// Sections with misspelt names, read once it is known that no section has the correct name.
    misspelt: Vec<(Part, ini::Section)>,
    /// The hashes of unknown section names, to find duplicates. There may be a million of them.
    unknown: HashSet<u64>,
    hasher: RandomState,
}

impl<'a> EdsReader<'a> {
    fn new(text: &'a str) -> Self {
        Self {
            text,
            device: Device::default(),
            objects: DictionaryReader::new(),
            findings: Findings::new(),
            odd: BTreeSet::new(),
            seen: HashSet::new(),
            compact: Vec::new(),
            misspelt: Vec::new(),
            unknown: HashSet::new(),
            hasher: RandomState::new(),
        }
    }

    fn section(&mut self, section: &ini::Section) {
        let Some(header) = section.header else {
            return self.before_first_section(section);
        };
        let text = header.name.of(self.text);
        let name = SectionName::parse(text);
        let (object, found) = (name.part.object(), self.findings.len());
        let is_plain = matches!(name.part, Part::Object(_) | Part::Entry(..));
        self.named_section(name, text, header, section);
        if !is_plain || self.findings.len() > found {
            self.odd.extend(object);
        }
    }

    fn named_section(&mut self, name: SectionName, text: &str, header: Header, section: &ini::Section) {
        if name.spelling == NameSpelling::Misspelt {
            return self.misspelt.push((name.part, section.clone()));
        }
        if name.spelling != NameSpelling::Standard
            && let Some(finding) = findings::section_spelling(text, &name, header.name)
        {
            self.findings.push(finding);
        }
        match name.part {
            Part::Object(index) => self.object(index, section),
            Part::Entry(index, sub) => self.entry(index, sub, section),
            Part::Section(_) => self.unknown_section(section),
            part => self.other_part(part, section),
        }
    }

    /// The section name as written, with its span; an empty span at the start before the first header.
    fn header_of(&self, section: &ini::Section) -> (&'a str, Span) {
        section.header.map_or(("", Span::empty(0)), |header| (header.name.of(self.text), header.name))
    }

    /// A section of any part except an object.
    fn other_part(&mut self, part: Part, section: &ini::Section) {
        let is_list = matches!(part, Part::List(_));
        if !self.seen.insert(part.clone()) {
            let (name, at) = self.header_of(section);
            let kind = if is_list { DuplicateKind::Joined } else { DuplicateKind::Other };
            self.findings.push(findings::duplicate_section(name, at, Place::of(part.clone()), kind));
            if !is_list {
                return;
            }
        }
        match part {
            Part::FileInfo => self.file_info(section),
            Part::DeviceInfo => self.device_info(section),
            Part::DummyUsage => self.dummy_usage(section),
            Part::Comments => self.comments(section),
            Part::Commissioning => self.commissioning(section),
            Part::List(list) => self.object_list(list, section),
            Part::Links(index) => self.links(index, section),
            Part::CompactNames(_) | Part::CompactValues(_) | Part::CompactDenotations(_) => {
                self.compact_section(part, section);
            }
            Part::SupportedModules => self.supported_modules(section),
            Part::ConnectedModules => self.connected_modules(section),
            Part::Module(number, part) => self.module(number, part, section),
            Part::DynamicChannels => self.dynamic_channels(section),
            Part::Tools => self.tools(section),
            Part::Tool(number) => self.tool(number, section),
            Part::Device | Part::Object(_) | Part::Entry(..) | Part::Section(_) => {}
            // an EDS has no section for them
            Part::Headers
            | Part::Identity
            | Part::NetworkIdentity
            | Part::Manager
            | Part::Functions
            | Part::Application
            | Part::ModuleObjects => {}
        }
    }

    /// Keys before the first header belong to no section but are kept. The line check reports them.
    fn before_first_section(&mut self, section: &ini::Section) {
        if section.entries.is_empty() {
            return;
        }
        let mut entries = Extra::default();
        for entry in &section.entries {
            entries.push(entry.key.of(self.text), entry.value.of(self.text));
        }
        self.device.extra.push(ExtraSection::new("", &entries));
    }

    fn unknown_section(&mut self, section: &ini::Section) {
        let (name, at) = self.header_of(section);
        let lower = name.to_ascii_lowercase();
        if self.unknown.insert(self.hasher.hash_one(&lower)) {
            self.findings.push(findings::unknown_section(name, at));
        } else {
            let first = Place::of(Part::Section(lower.into()));
            self.findings.push(findings::duplicate_section(name, at, first, DuplicateKind::Joined));
        }
        let mut entries = Extra::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        items.each(|_, item| entries.push(item.name, item.value));
        self.device.extra.push(ExtraSection::new(name, &entries));
    }

    /// Reads each section with a misspelt name as the intended section, if that is missing.
    fn misspelt_sections(&mut self) {
        for (part, section) in std::mem::take(&mut self.misspelt) {
            if self.seen.contains(&part) {
                self.unknown_section(&section);
                continue;
            }
            let (name, at) = self.header_of(&section);
            self.findings.push(findings::misspelt_section(name, &part, at));
            self.other_part(part, &section);
        }
    }

    /// Keeps unknown keys in a section of the same name.
    fn keep(&mut self, name: &str, entries: &Extra) {
        if !entries.is_empty() {
            self.device.extra.push(ExtraSection::new(name, entries));
        }
    }

    fn finish(mut self, kind: DeviceKind, unchanged: Objects) -> ReadDocument {
        self.misspelt_sections();
        self.apply_compact();
        self.device.objects = self.objects.into_objects(unchanged);
        let mut plain = self.device.objects.clone();
        // after this many findings, later ones are only counted
        let is_known = self.findings.len() < MAX_PER_RULE as usize;
        plain.retain(|index, _| is_known && !self.odd.contains(index));
        self.device.extra.shrink_to_fit();
        directions::unite(&mut self.device, &mut self.findings);
        self.device.kind = match self.device.commissioning {
            Some(_) => DeviceKind::Node,
            None => kind,
        };
        ReadDocument { device: self.device, findings: self.findings, plain }
    }
}
