//! Rewrites a text in canonical order and spelling. Sections and keys are moved unchanged with their
//! comments, so content without a place in the model is kept.

mod section;
mod spell;
mod text;

use self::section::SectionBlock;
pub use self::text::Extent;
use self::text::{ArrangedKey, ArrangedText};
use super::keys::FieldKey;
use super::order::Rank;
use super::section::{SectionName, section_name};
use crate::ini::{Document, Line, LineKind, Lines};
use crate::model::{Device, Part};

/// The rearranged text of a document from which `device` was read. Only one section is in memory at a time.
pub fn arrange(document: &Document, device: &Device, extent: Extent) -> String {
    let mut starts = starts(document);
    let last = starts.last().map_or(0, |(_, start)| *start);
    starts.sort_unstable();
    let line_end = document.line_end();
    let mut text = ArrangedText { text: String::with_capacity(document.text().len()), line_end };
    text.paragraphs(&Stretch::of(document, 0).start);
    for (_, start) in starts {
        if let Some(mut block) = Stretch::of(document, start).block {
            text.paragraph();
            block.write(document.text(), device, extent, &mut text);
        }
    }
    for paragraph in &Stretch::of(document, last).end {
        text.paragraph();
        text.lines(paragraph);
    }
    text.text
}

/// For each section, the start of the lines that may move with it: after the last preceding header or key.
fn starts(document: &Document) -> Vec<(Rank, u32)> {
    let (mut starts, mut start) = (Vec::new(), 0);
    let mut lines = document.lines();
    while let Some(line) = lines.advance() {
        if let LineKind::Section { name } = line.kind {
            starts.push((Rank::of(&SectionName::parse(name.of(document.text())).part), start));
        }
        if let LineKind::Section { .. } | LineKind::Entry { .. } = line.kind {
            // if there are keys without a section, the first section takes its preceding lines as the start
            // of the text
            start = if starts.is_empty() { 0 } else { line.next };
        }
    }
    starts
}

/// A section as a block that is moved as a whole, and its surrounding lines.
#[derive(Default)]
struct Stretch<'a> {
    /// The lines before the first section.
    start: Vec<Vec<&'a str>>,
    block: Option<SectionBlock<'a>>,
    /// The lines after the last section, separated from it by an empty line.
    end: Vec<Vec<&'a str>>,
}

/// Lines since the last header or key that are neither: paragraphs between empty lines.
#[derive(Default)]
struct Notes<'a> {
    paragraphs: Vec<Vec<&'a str>>,
    /// Whether an empty line precedes the first paragraph.
    is_apart: bool,
    /// Whether the last line was empty.
    is_open: bool,
}

impl<'a> Notes<'a> {
    fn blank(&mut self) {
        self.is_apart |= self.paragraphs.is_empty();
        self.is_open = true;
    }

    fn line(&mut self, line: &'a str) {
        match self.paragraphs.last_mut().filter(|_| !self.is_open) {
            Some(paragraph) => paragraph.push(line),
            None => self.paragraphs.push(vec![line]),
        }
        self.is_open = false;
    }

    /// All lines of all paragraphs.
    fn all(self) -> Vec<&'a str> {
        self.paragraphs.into_iter().flatten().collect()
    }

    /// The lines that belong to the preceding section: those directly after it. If they are directly above
    /// the next header, only tool settings among them.
    fn split_behind(&mut self, is_end: bool) -> Vec<&'a str> {
        if self.is_apart || self.paragraphs.is_empty() {
            return Vec::new();
        }
        let is_between = self.paragraphs.len() == 1 && !self.is_open && !is_end;
        if !is_between {
            return self.paragraphs.remove(0);
        }
        let settings = self.paragraphs[0].iter().take_while(|line| is_setting(line)).count();
        let behind = self.paragraphs[0].drain(..settings).collect();
        self.paragraphs.retain(|paragraph| !paragraph.is_empty());
        behind
    }
}

/// Whether a comment is a tool setting, such as `;StorageLocation=RAM`.
fn is_setting(line: &str) -> bool {
    (line.starts_with(";S") || line.starts_with(";C")) && line.contains('=')
}

impl<'a> Stretch<'a> {
    /// The section after the first header from an offset on.
    fn of(document: &'a Document, offset: u32) -> Self {
        let text = document.text();
        let mut stretch = Self::default();
        let mut notes = Notes::default();
        let mut above = offset;
        let mut lines = Lines::from(text, offset);
        while let Some(line) = lines.advance() {
            match line.kind {
                LineKind::Blank => notes.blank(),
                LineKind::Comment | LineKind::Junk => {
                    let line = line.span.of(text).trim_end();
                    // whitespace that the line scanner does not treat as blank, also behind what it does
                    let is_blank = |c: char| c.is_whitespace() || matches!(c, '\0' | '\u{1A}');
                    if line.chars().all(is_blank) { notes.blank() } else { notes.line(line) }
                }
                LineKind::Section { name } => {
                    stretch.end_section(&mut notes, offset == 0, false);
                    if stretch.block.is_some() {
                        return stretch;
                    }
                    stretch.block = Some(block(name.of(text), &line, text, std::mem::take(&mut notes)));
                }
                LineKind::Entry { key, value } => {
                    let notes = std::mem::take(&mut notes);
                    match &mut stretch.block {
                        Some(block) => {
                            let (name, value) = (key.of(text), value.of(text));
                            let key = FieldKey::find(name);
                            let (rank, field) = (block.rank_of(key), key.map(FieldKey::field));
                            let line = line.span.start;
                            block.keys.push(ArrangedKey { rank, above, line, name, field, value });
                        }
                        // lines without a section keep their position
                        None => stretch.before_sections(notes.all(), line.span.of(text).trim()),
                    }
                }
            }
            if let LineKind::Section { .. } | LineKind::Entry { .. } = line.kind {
                above = line.next;
            }
        }
        stretch.end_section(&mut notes, offset == 0, true);
        stretch.end = notes.paragraphs;
        stretch
    }

    /// Keeps the position of a key without a section.
    fn before_sections(&mut self, notes: Vec<&'a str>, line: &'a str) {
        if self.start.is_empty() {
            self.start.push(Vec::new());
        }
        if let Some(paragraph) = self.start.last_mut() {
            paragraph.extend(notes);
            paragraph.push(line);
        }
    }

    /// Adds notes that belong to the preceding section, or to the start of the text.
    fn end_section(&mut self, notes: &mut Notes<'a>, is_start: bool, is_end: bool) {
        match &mut self.block {
            Some(block) => block.behind = notes.split_behind(is_end),
            None if !is_start => drop(notes.split_behind(is_end)),
            None => {
                let is_above = !notes.is_open && !is_end;
                let above = if is_above { notes.paragraphs.pop() } else { None };
                self.start.append(&mut notes.paragraphs);
                notes.paragraphs.extend(above);
            }
        }
    }
}

/// As many keys as most sections have.
const USUAL_KEYS: usize = 8;

/// A section, still without its keys. Text after the header becomes a comment above it.
fn block<'a>(name: &'a str, header: &Line, text: &'a str, notes: Notes<'a>) -> SectionBlock<'a> {
    let part = SectionName::parse(name).part;
    let line = header.span.of(text);
    let behind = line.find(']').map_or("", |close| line[close + 1..].trim());
    let remark = behind.trim_start_matches([';', '#', '/']).trim_start();
    SectionBlock {
        name: match part {
            Part::Section(_) => name.to_owned(),
            _ => section_name(&part).unwrap_or_else(|| name.to_owned()),
        },
        is_above: !notes.is_open,
        above: notes.paragraphs,
        remark: Some(remark).filter(|remark| !remark.is_empty()),
        part,
        keys: Vec::with_capacity(USUAL_KEYS),
        behind: Vec::new(),
    }
}
