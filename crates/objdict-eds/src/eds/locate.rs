//! Converts places to spans. The locator stores nothing per value: the place names its section and key, and
//! the text is searched only when a finding is shown.

use std::collections::HashMap;
use std::hash::{BuildHasher, RandomState};
use std::sync::{Mutex, OnceLock, PoisonError};

use super::keys::FieldKey;
use super::misspelt;
use super::order::Rank;
use super::read::embedded_in;
use super::section::{NameSpelling, SectionName};
use crate::ini::{Document, Line, LineKind, Lines, Section};
use crate::model::{EMBEDDED_SECTION, Field, Part, Place};
use crate::source::Span;

/// The headers of a document, sorted by part.
#[derive(Debug)]
pub struct SectionLocator {
    state: RandomState,
    /// The number of the part, and the start of its header line.
    headers: Vec<(u32, u32)>,
    /// Requested keys of sections, by the start of their header line. Otherwise a long list with many
    /// findings would be scanned from its start for each of them.
    keys: Mutex<HashMap<u32, Keys>>,
    /// The rank of each section in the canonical order, needed to add sections.
    outline: OnceLock<Vec<(Rank, u32)>>,
}

/// The hash of each key of a section in lower case, and the start of its line, sorted by hash.
type Keys = Vec<(u32, u32)>;

impl SectionLocator {
    /// Finds the sections of a document.
    pub fn new(document: &Document) -> Self {
        let state = RandomState::new();
        let mut found = Vec::new();
        let mut misspelt = Vec::new();
        for line in document.headers() {
            if let LineKind::Section { name } = line.kind {
                let name = SectionName::parse(name.of(document.text()));
                let sections =
                    if name.spelling == NameSpelling::Misspelt { &mut misspelt } else { &mut found };
                sections.push((number_of(&state, &name.part), line.span.start));
            }
        }
        // a misspelt section is used only if none has the correct name
        found.append(&mut misspelt);
        // sections are usually in order already
        found.sort_by_key(|(number, _)| *number);
        found.shrink_to_fit();
        Self { state, headers: found, keys: Mutex::default(), outline: OnceLock::new() }
    }

    /// The span of a place: the value of its key if not empty, otherwise the key; the name of its section if
    /// the key is missing. `None` for the device as a whole and for missing sections.
    pub fn locate(&self, document: &Document, place: &Place) -> Option<Span> {
        let text = document.text();
        let mut header = None;
        for start in self.starts(&place.part) {
            let header_line = Lines::from(text, start).next();
            let Some(LineKind::Section { name }) = header_line.map(|line| line.kind) else { continue };
            if SectionName::parse(name.of(text)).part != place.part {
                continue;
            }
            header.get_or_insert(name);
            let Some(field) = &place.field else { break };
            if let Some(span) = self.find_key(text, start, field) {
                return Some(span);
            }
        }
        let found =
            self.misspelt_key(document, place).or(header).or_else(|| self.nearest(document, &place.part));
        found.or_else(|| embedded_line(document, place))
    }

    /// The place at an offset: the field of its line in its section. `None` outside the sections of the
    /// standard.
    pub fn place_at(&self, document: &Document, offset: u32) -> Option<Place> {
        let (text, outline) = (document.text(), self.outline(document));
        let behind = outline.partition_point(|(_, start)| *start <= offset);
        let (_, start) = outline.get(behind.checked_sub(1)?)?;
        let LineKind::Section { name } = Lines::from(text, *start).next()?.kind else { return None };
        let part = SectionName::parse(name.of(text)).part;
        let lines = document.source().lines();
        let line = lines.line_span(text, lines.line_of(text, offset));
        let field = match Lines::from(text, line.start).next()?.kind {
            LineKind::Entry { key, .. } => {
                Some(FieldKey::field_of(FieldKey::find(key.of(text)), key.of(text)))
            }
            _ => None,
        };
        (!matches!(part, Part::Section(_))).then_some(Place { part, field })
    }

    /// The value of a key with a misspelt name.
    fn misspelt_key(&self, document: &Document, place: &Place) -> Option<Span> {
        let field =
            place.field.as_ref().filter(|field| !matches!(field, Field::Item(_) | Field::Named(_)))?;
        let text = document.text();
        let is_meant = |name: &str| {
            FieldKey::find(name).is_none()
                && misspelt::key(&place.part, name).is_some_and(|key| key.field() == field)
        };
        let start = self.starts(&place.part).next()?;
        let lines = Lines::from(text, start).skip(1).take_while(|line| !is_header(line));
        lines.take(SHORT).find_map(|line| match line.kind {
            LineKind::Entry { key, value } if is_meant(key.of(text)) => {
                Some(if value.is_empty() { key } else { value })
            }
            _ => None,
        })
    }

    /// The sections in text order: the canonical rank, and the start of the header line.
    pub(super) fn outline(&self, document: &Document) -> &[(Rank, u32)] {
        let text = document.text();
        self.outline.get_or_init(|| {
            let rank = |number: u32, start: u32| match object_of(number) {
                Some(part) => Some(Rank::of(&part)),
                None => match Lines::from(text, start).next()?.kind {
                    LineKind::Section { name } => Some(Rank::of(&SectionName::parse(name.of(text)).part)),
                    _ => None,
                },
            };
            let ranked =
                self.headers.iter().filter_map(|&(number, start)| Some((rank(number, start)?, start)));
            let mut outline = Vec::with_capacity(self.headers.len());
            outline.extend(ranked);
            outline.sort_unstable_by_key(|(_, start)| *start);
            outline
        })
    }

    /// The sections of a part, in order; several if the part is defined twice.
    pub(crate) fn sections(&self, document: &Document, part: &Part) -> impl Iterator<Item = Section> {
        let text = document.text();
        let is_of_part = |section: &Section| {
            section.header.is_some_and(|header| SectionName::parse(header.name.of(text)).part == *part)
        };
        self.starts(part).filter_map(|start| document.section_at(start)).filter(is_of_part)
    }

    /// The start of the headers that may belong to a part.
    fn starts(&self, part: &Part) -> impl Iterator<Item = u32> {
        let number = number_of(&self.state, part);
        let from = self.headers.partition_point(|(other, _)| *other < number);
        self.headers[from..].iter().take_while(move |(other, _)| *other == number).map(|(_, start)| *start)
    }

    /// The value of a key, or the key if the value is empty, in the section whose header line starts at
    /// `header`.
    fn find_key(&self, text: &str, header: u32, field: &Field) -> Option<Span> {
        let name = field.name();
        let value_of = |line: Line| match line.kind {
            LineKind::Entry { key, value } if key.of(text).eq_ignore_ascii_case(&name) => {
                Some(if value.is_empty() { key } else { value })
            }
            _ => None,
        };
        let mut sections = self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        if !sections.contains_key(&header) {
            let mut lines = Lines::from(text, header).skip(1).take_while(|line| !is_header(line));
            // most sections are short
            if let Some(value) = lines.by_ref().take(SHORT).find_map(value_of) {
                return Some(value);
            }
            lines.next()?;
        }
        let hash = hash(&self.state, &name.to_ascii_lowercase());
        let keys = sections.entry(header).or_insert_with(|| self.read_keys(text, header));
        let from = keys.partition_point(|(other, _)| *other < hash);
        let candidates = keys[from..].iter().take_while(|(other, _)| *other == hash);
        candidates.filter_map(|&(_, start)| Lines::from(text, start).next()).find_map(value_of)
    }

    fn read_keys(&self, text: &str, header: u32) -> Keys {
        let mut keys = Keys::new();
        for line in Lines::from(text, header).skip(1).take_while(|line| !is_header(line)) {
            if let LineKind::Entry { key, .. } = line.kind {
                keys.push((hash(&self.state, &key.of(text).to_ascii_lowercase()), line.span.start));
            }
        }
        keys.sort_unstable();
        keys
    }

    /// For an entry without its own section, the section of its object.
    fn nearest(&self, document: &Document, part: &Part) -> Option<Span> {
        match *part {
            Part::Entry(index, _) => self.locate(document, &Place::object(index)),
            _ => None,
        }
    }
}

/// The sections of each object, in order.
pub fn objects(document: &Document) -> Vec<(u16, Span)> {
    let text = document.text();
    let mut found = Vec::new();
    // backwards, because a section ends where the next one starts
    let headers: Vec<Line> = document.headers().collect();
    let mut end = text.len() as u32;
    for line in headers.into_iter().rev() {
        if let LineKind::Section { name } = line.kind {
            let object = SectionName::parse(name.of(text)).part.object();
            found.extend(object.map(|index| (index, Span::new(line.span.start, end))));
            end = line.span.start;
        }
    }
    found.reverse();
    found
}

/// The comment line that contains an embedded value, or the first such line.
fn embedded_line(document: &Document, place: &Place) -> Option<Span> {
    if place.part != Part::Section(EMBEDDED_SECTION.into()) {
        return None;
    }
    let is_wanted = |key: &str| place.field.as_ref().is_none_or(|field| field.name() == key);
    let mut lines = document.lines().map(|line| line.span);
    lines.find(|line| embedded_in(line.of(document.text())).is_some_and(|(key, _)| is_wanted(key)))
}

/// The number of lines of a section that are searched for a key before all its keys are sorted.
const SHORT: usize = 32;

fn is_header(line: &Line) -> bool {
    matches!(line.kind, LineKind::Section { .. })
}

/// Marks the lookup numbers of objects and entries.
const OBJECT: u32 = 1 << 31;

/// The lookup number of a part: its index and sub-index, or a hash that cannot collide with those.
fn number_of(state: &RandomState, part: &Part) -> u32 {
    match *part {
        Part::Object(index) => OBJECT | u32::from(index) << 9,
        Part::Entry(index, sub) => OBJECT | u32::from(index) << 9 | (u32::from(sub) + 1),
        _ => hash(state, part) & !OBJECT,
    }
}

/// The object or entry with a lookup number; `None` for other parts.
fn object_of(number: u32) -> Option<Part> {
    let index = (number >> 9) as u16;
    (number & OBJECT != 0).then(|| match (number & 0x1FF).checked_sub(1) {
        Some(sub) => Part::Entry(index, sub as u8),
        None => Part::Object(index),
    })
}

fn hash<T: std::hash::Hash>(state: &RandomState, item: &T) -> u32 {
    state.hash_one(item) as u32
}
