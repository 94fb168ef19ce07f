//! The arranged text, and the extent of its changes.

use crate::model::Field;

/// The extent of the changes. If the complete rearrangement would change the meaning of a text, the extent is
/// reduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// The order of the keys in a section.
    pub(super) keys: bool,
    /// The spelling of keys.
    pub(super) names: bool,
    /// The spelling of values.
    pub(super) values: bool,
}

impl Extent {
    /// From all changes down to only the order of the sections.
    pub const ALL: [Self; 4] = [
        Self { keys: true, names: true, values: true },
        Self { keys: true, names: true, values: false },
        Self { keys: true, names: false, values: true },
        Self { keys: false, names: false, values: false },
    ];
}

/// A key of a section with its value.
pub(super) struct ArrangedKey<'a> {
    /// Its position among the keys of the section.
    pub(super) rank: u32,
    /// The start of the lines above it, and of its own line.
    pub(super) above: u32,
    pub(super) line: u32,
    pub(super) name: &'a str,
    /// What the standard defines under this name.
    pub(super) field: Option<&'static Field>,
    pub(super) value: &'a str,
}

/// An arranged text under construction.
pub(super) struct ArrangedText {
    pub text: String,
    pub line_end: &'static str,
}

impl ArrangedText {
    pub(super) fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push_str(self.line_end);
    }

    /// A line of three parts.
    pub(super) fn parts(&mut self, parts: [&str; 3]) {
        parts.iter().for_each(|part| self.text.push_str(part));
        self.text.push_str(self.line_end);
    }

    pub(super) fn lines(&mut self, lines: &[&str]) {
        lines.iter().for_each(|line| self.line(line));
    }

    pub(super) fn paragraphs(&mut self, paragraphs: &[Vec<&str>]) {
        for paragraph in paragraphs {
            self.paragraph();
            self.lines(paragraph);
        }
    }

    /// Adds an empty line, except at the start of the text.
    pub(super) fn paragraph(&mut self) {
        if !self.text.is_empty() {
            self.line("");
        }
    }
}
