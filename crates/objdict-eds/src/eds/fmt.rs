//! A text in the canonical order and spelling. Sections and keys are moved as they stand, with the comments that belong to
//! them, so nothing is lost that a writer of the model does not know of.

mod section;
mod spell;

use self::section::Block;
use super::order::Rank;
use super::section::{SectionName, section_name};
use crate::ini::{Document, Line, LineKind};
use crate::model::{Device, Part};

/// How much is changed. A text of which something else would be read with all of it gets less.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// The order of the keys in a section.
    keys: bool,
    /// The spelling of keys.
    names: bool,
    /// The spelling of values.
    values: bool,
}

impl Extent {
    /// From all to the order of the sections alone.
    pub const ALL: [Self; 4] = [
        Self { keys: true, names: true, values: true },
        Self { keys: true, names: true, values: false },
        Self { keys: true, names: false, values: true },
        Self { keys: false, names: false, values: false },
    ];
}

/// The arranged text of a document, from which `device` was read.
pub fn arrange(document: &Document, device: &Device, extent: Extent) -> String {
    let mut layout = Layout::of(document);
    layout.blocks.sort_by_key(|block| block.rank);
    let line_end = document.line_end();
    let mut text = Text { text: String::with_capacity(document.text().len()), line_end };
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

/// A text in the making.
struct Text {
    text: String,
    line_end: &'static str,
}

impl Text {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push_str(self.line_end);
    }

    fn lines(&mut self, lines: &[&str]) {
        lines.iter().for_each(|line| self.line(line));
    }

    fn paragraphs(&mut self, paragraphs: &[Vec<&str>]) {
        for paragraph in paragraphs {
            self.paragraph();
            self.lines(paragraph);
        }
    }

    /// An empty line before what follows, but for the start of the text.
    fn paragraph(&mut self) {
        if !self.text.is_empty() {
            self.line("");
        }
    }
}

/// A document as blocks that can be moved.
#[derive(Default)]
struct Layout<'a> {
    /// What stands before the first section, and belongs to none.
    start: Vec<Vec<&'a str>>,
    blocks: Vec<Block<'a>>,
    /// What stands behind the last section with an empty line between.
    end: Vec<Vec<&'a str>>,
}

/// Lines that are neither header nor key, since the last one of these: paragraphs between empty lines.
#[derive(Default)]
struct Notes<'a> {
    paragraphs: Vec<Vec<&'a str>>,
    /// Whether an empty line stands before the first paragraph.
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

    /// All lines, whatever is between them.
    fn all(self) -> Vec<&'a str> {
        self.paragraphs.into_iter().flatten().collect()
    }

    /// What belongs to the section before: the lines that follow it at once, unless they stand right above the next header;
    /// then only those that say something to a tool.
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

impl<'a> Layout<'a> {
    fn of(document: &'a Document) -> Self {
        let text = document.text();
        let mut layout = Self::default();
        let mut notes = Notes::default();
        for line in document.lines() {
            match line.kind {
                LineKind::Blank => notes.blank(),
                LineKind::Comment | LineKind::Junk => notes.line(line.span.of(text).trim_end()),
                LineKind::Section { name } => {
                    layout.end_section(&mut notes, false);
                    let notes = std::mem::take(&mut notes);
                    let (name, header) = (name.of(text), &line);
                    layout.blocks.push(block(name, header, text, notes));
                }
                LineKind::Entry { key, value } => {
                    let entry = section::Entry {
                        notes: std::mem::take(&mut notes).all(),
                        key: key.of(text),
                        value: value.of(text),
                    };
                    match layout.blocks.last_mut() {
                        Some(block) => block.entries.push(entry),
                        // what belongs to no section stays where it is
                        None => layout.before_sections(&entry, line.span.of(text).trim()),
                    }
                }
            }
        }
        layout.end_section(&mut notes, true);
        layout.end = notes.paragraphs;
        layout
    }

    /// Keeps a key that belongs to no section where it is.
    fn before_sections(&mut self, entry: &section::Entry<'a>, line: &'a str) {
        if self.start.is_empty() {
            self.start.push(Vec::new());
        }
        if let Some(paragraph) = self.start.last_mut() {
            paragraph.extend(&entry.notes);
            paragraph.push(line);
        }
    }

    /// Gives the section before, or the start of the text, the notes that belong to it.
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

/// A section without its keys yet. What stands behind the header in its line becomes a comment above it.
fn block<'a>(name: &'a str, header: &Line, text: &'a str, notes: Notes<'a>) -> Block<'a> {
    let part = SectionName::parse(name).part;
    let line = header.span.of(text);
    let behind = line.find(']').map_or("", |close| line[close + 1..].trim());
    let remark = behind.trim_start_matches([';', '#', '/']).trim_start();
    Block {
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
