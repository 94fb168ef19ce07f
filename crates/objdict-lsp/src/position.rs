//! Lines and columns as editors count them: from 0, in units of UTF-16 or UTF-8.

use std::borrow::Cow;

use super::protocol::{ContentChange, Position, Range, TextEdit};
use objdict_model::source::{LineIndex, SourceFile, Span};

/// The unit of columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum ColumnUnit {
    Utf8,
    /// What each client knows.
    #[default]
    Utf16,
}

impl ColumnUnit {
    /// The first one of a client's list that is known.
    pub(super) fn of<'a>(mut offered: impl Iterator<Item = &'a str>) -> Self {
        let known = offered.find_map(|kind| match kind {
            "utf-8" => Some(Self::Utf8),
            "utf-16" => Some(Self::Utf16),
            _ => None,
        });
        known.unwrap_or_default()
    }

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "utf-8",
            Self::Utf16 => "utf-16",
        }
    }

    fn width(self, c: char) -> u32 {
        (match self {
            Self::Utf8 => c.len_utf8(),
            Self::Utf16 => c.len_utf16(),
        }) as u32
    }
}

/// The positions of a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Positions<'a> {
    text: &'a str,
    lines: &'a LineIndex,
    unit: ColumnUnit,
}

impl<'a> Positions<'a> {
    pub(super) fn new(source: &'a SourceFile, unit: ColumnUnit) -> Self {
        Self { text: source.text(), lines: source.lines(), unit }
    }

    /// The position of a byte.
    pub(super) fn of(&self, offset: u32) -> Position {
        let text = self.text;
        let line = self.lines.line_of(text, offset);
        let start = self.lines.line_span(text, line).start as usize;
        let before = text.get(start..(offset as usize).min(text.len())).unwrap_or_default();
        Position::new(line as u32, before.chars().map(|c| self.unit.width(c)).sum())
    }

    /// The byte of a position; behind the end of a line it is that end, inside of a character its start.
    pub(super) fn offset(&self, position: Position) -> u32 {
        let span = self.lines.line_span(self.text, position.line as usize);
        let line = span.of(self.text);
        let mut left = position.character;
        let mut at = 0;
        for c in line.trim_end_matches(['\n', '\r']).chars() {
            let width = self.unit.width(c);
            if width > left {
                break;
            }
            left -= width;
            at += c.len_utf8() as u32;
        }
        span.start + at
    }

    pub(super) fn range(&self, span: Span) -> Range {
        Range::new(self.of(span.start), self.of(span.end))
    }

    pub(super) fn span(&self, range: Range) -> Span {
        let start = self.offset(range.start);
        Span::new(start, self.offset(range.end).max(start))
    }

    pub(super) fn edit(&self, (span, text): (Span, String)) -> TextEdit {
        TextEdit { range: self.range(span), new_text: text }
    }
}

/// Makes a change that an editor sends: of a range, or of the whole text, whose lines may be known.
pub(super) fn apply(text: &mut String, lines: Option<&LineIndex>, change: ContentChange, unit: ColumnUnit) {
    let Some(range) = change.range else {
        *text = change.text;
        return;
    };
    let lines = lines.map_or_else(|| Cow::Owned(LineIndex::new(text)), Cow::Borrowed);
    let span = Positions { text, lines: &lines, unit }.span(range);
    text.replace_range(span.start as usize..span.end as usize, &change.text);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_beyond_the_basic_plane_count_as_editors_count_them() {
        let source = SourceFile::from_text("a", "a°\u{1F600}b\r\nc\u{1F600}d");
        let at = |part: &str| source.text().find(part).unwrap_or(source.text().len()) as u32;
        for (unit, part, line, column) in [
            (ColumnUnit::Utf16, "b", 0, 4),
            (ColumnUnit::Utf8, "b", 0, 7),
            (ColumnUnit::Utf16, "d", 1, 3),
            (ColumnUnit::Utf8, "d", 1, 5),
            (ColumnUnit::Utf16, "no such", 1, 4),
        ] {
            let positions = Positions::new(&source, unit);
            let position = Position::new(line, column);
            assert_eq!(positions.of(at(part)), position);
            assert_eq!(positions.offset(position), at(part));
        }
        let positions = Positions::new(&source, ColumnUnit::Utf16);
        assert_eq!(positions.offset(Position::new(0, 3)), at("\u{1F600}"), "in the middle of a character");
        assert_eq!(positions.offset(Position::new(0, 99)), at("\r\n"));
        assert_eq!(positions.offset(Position::new(9, 9)), at("no such"));
    }

    #[test]
    fn the_first_known_unit_counts() {
        let of = |kinds: &[&'static str]| ColumnUnit::of(kinds.iter().copied());
        assert_eq!(of(&["utf-32", "utf-8", "utf-16"]), ColumnUnit::Utf8);
        assert_eq!(of(&["utf-16", "utf-8"]), ColumnUnit::Utf16);
        assert_eq!(of(&[]), ColumnUnit::Utf16);
    }
}
