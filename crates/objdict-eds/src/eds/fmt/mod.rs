//! A text in canonical order and spelling. Sections and keys are moved unchanged with their comments, so
//! nothing is lost that the model does not contain.

mod section;
mod spell;
mod text;

use self::section::SectionBlock;
use self::text::ArrangedText;
pub use self::text::Extent;
use super::order::Rank;
use super::section::{SectionName, section_name};
use crate::ini::{Document, Line, LineKind};
use crate::model::{Device, Part};

/// The rearranged text of a document from which `device` was read.
pub fn arrange(document: &Document, device: &Device, extent: Extent) -> String {
    let mut layout = DocumentLayout::of(document);
    layout.blocks.sort_by_key(|block| block.rank);
    let line_end = document.line_end();
    let mut text = ArrangedText { text: String::with_capacity(document.text().len()), line_end };
    text.paragraphs(&layout.start);
    for block in &layout.blocks {
        text.paragraph();
        block.write(device, extent, &mut text);
    }
    for paragraph in &layout.end {
        text.paragraph();
        text.lines(paragraph);
    }
    text.text
}

/// A document as blocks that are moved as a whole.
#[derive(Default)]
struct DocumentLayout<'a> {
    /// The lines before the first section.
    start: Vec<Vec<&'a str>>,
    blocks: Vec<SectionBlock<'a>>,
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

    /// The lines that belong to the section before: those directly after it. If they are directly above the
    /// next header, only the settings of tools among them.
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

/// Whether a comment is a setting for a tool, such as `;StorageLocation=RAM`.
fn is_setting(line: &str) -> bool {
    (line.starts_with(";S") || line.starts_with(";C")) && line.contains('=')
}

impl<'a> DocumentLayout<'a> {
    fn of(document: &'a Document) -> Self {
        let text = document.text();
        let mut layout = Self::default();
        let mut notes = Notes::default();
        for line in document.lines() {
            match line.kind {
                LineKind::Blank => notes.blank(),
                LineKind::Comment | LineKind::Junk => match line.span.of(text).trim_end() {
                    // of blanks that are none to the reader of lines
                    "" => notes.blank(),
                    line => notes.line(line),
                },
                LineKind::Section { name } => {
                    layout.end_section(&mut notes, false);
                    let notes = std::mem::take(&mut notes);
                    let (name, header) = (name.of(text), &line);
                    layout.blocks.push(block(name, header, text, notes));
                }
                LineKind::Entry { key, value } => {
                    let entry = section::KeyBlock {
                        notes: std::mem::take(&mut notes).all(),
                        key: key.of(text),
                        value: value.of(text),
                    };
                    match layout.blocks.last_mut() {
                        Some(block) => block.entries.push(entry),
                        // lines without a section keep their place
                        None => layout.before_sections(&entry, line.span.of(text).trim()),
                    }
                }
            }
        }
        layout.end_section(&mut notes, true);
        layout.end = notes.paragraphs;
        layout
    }

    /// Keeps the place of a key without a section.
    fn before_sections(&mut self, entry: &section::KeyBlock<'a>, line: &'a str) {
        if self.start.is_empty() {
            self.start.push(Vec::new());
        }
        if let Some(paragraph) = self.start.last_mut() {
            paragraph.extend(&entry.notes);
            paragraph.push(line);
        }
    }

    /// Adds notes that belong to the section before, or to the start of the text.
    fn end_section(&mut self, notes: &mut Notes<'a>, is_end: bool) {
        match self.blocks.last_mut() {
            Some(block) => block.behind = notes.split_behind(is_end),
            None => {
                let is_above = !notes.is_open && !is_end;
                let above = if is_above { notes.paragraphs.pop() } else { None };
                self.start.append(&mut notes.paragraphs);
                notes.paragraphs.extend(above);
            }
        }
    }
}

/// A section without its keys yet. Text after the header becomes a comment above it.
fn block<'a>(name: &'a str, header: &Line, text: &'a str, notes: Notes<'a>) -> SectionBlock<'a> {
    let part = SectionName::parse(name).part;
    let line = header.span.of(text);
    let behind = line.find(']').map_or("", |close| line[close + 1..].trim());
    let remark = behind.trim_start_matches([';', '#', '/']).trim_start();
    SectionBlock {
        rank: Rank::of(&part),
        name: match part {
            Part::Section(_) => name.to_owned(),
            _ => section_name(&part).unwrap_or_else(|| name.to_owned()),
        },
        is_above: !notes.is_open,
        above: notes.paragraphs,
        remark: Some(remark).filter(|remark| !remark.is_empty()),
        part,
        entries: Vec::new(),
        behind: Vec::new(),
    }
}
