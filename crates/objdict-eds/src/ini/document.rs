//! An INI file as its text, split into sections on demand.
//!
//! Lines are not stored. Scanning again is fast enough for reading, printing and locating, and a file of a
//! million lines needs no more memory than its text.

use super::{EditedSpan, Line, LineKind, Lines};
use crate::source::{SourceFile, Span};

/// An INI file, well-formed or not: the text is the source, and lines and sections are views of it.
#[derive(Debug)]
pub struct Document {
    source: SourceFile,
}

/// A section with its entries, as spans of the text. The entries before the first header are a section
/// without header.
#[derive(Clone, Debug, Default)]
pub struct Section {
    /// The header line; `None` before the first header.
    pub header: Option<Header>,
    /// The entries, in order.
    pub entries: Vec<IniEntry>,
    /// The comment lines among and after the entries.
    pub comments: Vec<Span>,
}

/// The header of a section.
#[derive(Clone, Copy, Debug)]
pub struct Header {
    /// The name, without the brackets and surrounding whitespace.
    pub name: Span,
    /// The whole line.
    pub line: Span,
}

/// A key with its value.
#[derive(Clone, Copy, Debug)]
pub struct IniEntry {
    /// The key, not empty.
    pub key: Span,
    /// The value, without surrounding whitespace.
    pub value: Span,
}

impl Section {
    /// The section of the lines up to the next header.
    fn of(header: Option<Header>, lines: Lines<'_>) -> Self {
        let mut section = Self { header, ..Self::default() };
        for line in lines {
            match line.kind {
                LineKind::Section { .. } => break,
                LineKind::Entry { key, value } => section.entries.push(IniEntry { key, value }),
                LineKind::Comment => section.comments.push(line.span),
                LineKind::Blank | LineKind::Junk => {}
            }
        }
        section
    }
}

impl Document {
    /// A document of a source.
    pub fn new(source: SourceFile) -> Self {
        Self { source }
    }

    /// The source, without a copy.
    pub fn into_source(self) -> SourceFile {
        self.source
    }

    /// The source.
    pub fn source(&self) -> &SourceFile {
        &self.source
    }

    /// The decoded text.
    pub fn text(&self) -> &str {
        self.source.text()
    }

    /// The lines, in order.
    pub fn lines(&self) -> Lines<'_> {
        Lines::new(self.text())
    }

    /// The lines with section headers, in order.
    pub fn headers(&self) -> impl Iterator<Item = Line> {
        super::headers(self.text())
    }

    /// The bytes of the file, composed from its lines: always equal to the bytes that were read.
    pub fn print(&self) -> Vec<u8> {
        if self.source.is_read_only() {
            return self.source.to_bytes();
        }
        let mut text = String::with_capacity(self.text().len());
        for line in self.lines() {
            text.push_str(Span::new(line.span.start, line.next).of(self.text()));
        }
        self.source.encode(&text).unwrap_or_else(|_| self.source.to_bytes())
    }

    /// The line end of new lines: as in the first line, or CR LF if it has none.
    pub fn line_end(&self) -> &'static str {
        match self.lines().next().map(|line| Span::new(line.span.end, line.next).of(self.text())) {
            Some("\n") => "\n",
            Some("\r") => "\r",
            _ => "\r\n",
        }
    }

    /// The section whose header line starts at `offset`.
    pub fn section_at(&self, offset: u32) -> Option<Section> {
        let mut lines = Lines::from(self.text(), offset);
        let first = lines.next()?;
        let LineKind::Section { name } = first.kind else { return None };
        Some(Section::of(Some(Header { name, line: first.span }), lines))
    }

    /// The line that contains `offset`.
    pub fn line_at(&self, offset: u32) -> Option<Line> {
        let text = self.text().as_bytes();
        let before = match text.split_at((offset as usize).min(text.len())) {
            // the line feed is part of the line that it ends
            ([before @ .., b'\r'], [b'\n', ..]) => before,
            (before, _) => before,
        };
        let start = memchr::memrchr2(b'\n', b'\r', before).map_or(0, |end| end + 1);
        Lines::from(self.text(), start as u32).next()
    }

    /// The entries before the first header.
    pub(crate) fn headless(&self) -> Section {
        Section::of(None, self.lines())
    }

    /// The lines that an edit may have changed. The first one contains the byte before the edit, because a line feed
    /// after a carriage return is part of its line end; the line after the last one starts after the edit.
    pub(crate) fn changed_lines(&self, edited: EditedSpan) -> impl Iterator<Item = Line> {
        let first = self.line_at(edited.start.saturating_sub(2));
        let start = first.map_or(edited.start, |line| line.span.start);
        Lines::from(self.text(), start).take_while(move |line| line.span.start <= edited.new_end)
    }

    /// Calls `visit` for each section in order, and `other` for each line that is neither header nor entry.
    /// Only one section is in memory at a time, and its list is reused for the next.
    pub fn visit(&self, mut visit: impl FnMut(&Section), mut other: impl FnMut(&Line)) {
        let mut section = Section::default();
        let mut lines = self.lines();
        while let Some(line) = lines.advance() {
            match line.kind {
                LineKind::Section { name } => {
                    visit(&section);
                    section.header = Some(Header { name, line: line.span });
                    section.entries.clear();
                    section.comments.clear();
                }
                LineKind::Entry { key, value } => section.entries.push(IniEntry { key, value }),
                LineKind::Blank => {}
                LineKind::Comment => {
                    section.comments.push(line.span);
                    other(&line);
                }
                LineKind::Junk => other(&line),
            }
        }
        visit(&section);
    }
}
