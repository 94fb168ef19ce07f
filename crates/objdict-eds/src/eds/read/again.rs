//! Reads a text again after an edit: objects whose sections are unchanged are reused from the previous
//! result.

use std::collections::BTreeSet;

use crate::eds::section::SectionName;
use crate::ini::{Document, EditedSpan, Line, LineKind};
use crate::model::{EMBEDDED_COMMENT, Objects};

/// The previous result, for the text before the edit.
#[derive(Clone, Copy, Debug)]
pub struct BeforeEdit<'a> {
    /// Its [plain objects](super::ReadDocument::plain).
    pub plain: &'a Objects,
    /// Its sections.
    pub sections: &'a SectionStarts,
    /// How the texts differ.
    pub edited: EditedSpan,
}

/// The starts of a document's headers, in order, each with the object of its section.
#[derive(Clone, Debug, Default)]
pub struct SectionStarts(Vec<(u32, Option<u16>)>);

impl SectionStarts {
    /// Finds the sections of a document.
    pub fn of(document: &Document) -> Self {
        Self(document.headers().filter_map(|line| start_of(document, &line)).collect())
    }

    /// Finds the sections of the document after an edit, and the objects of the sections that the edit
    /// changed, added or removed.
    fn after(&self, document: &Document, edited: EditedSpan) -> (Self, BTreeSet<u16>) {
        let EditedSpan { old_end, new_end, .. } = edited;
        let mut lines = document.changed_lines(edited).peekable();
        let first = lines.peek().map_or(edited.start, |line| line.span.start);
        let before = self.0.partition_point(|(start, _)| *start < first);
        let behind = self.0.partition_point(|(start, _)| *start <= old_end);
        let found: Vec<_> = lines.filter_map(|line| start_of(document, &line)).collect();
        let touched = self.0[before.saturating_sub(1)..behind].iter().chain(&found);
        let touched = touched.filter_map(|(_, object)| *object).collect();
        let mut starts = self.0[..before].to_vec();
        starts.extend(found);
        starts.extend(self.0[behind..].iter().map(|(start, object)| (start - old_end + new_end, *object)));
        (Self(starts), touched)
    }

    /// The starts of the sections that belong to none of these objects.
    pub(super) fn without<'a>(&'a self, objects: &'a Objects) -> impl Iterator<Item = u32> + 'a {
        let others =
            self.0.iter().filter(|(_, object)| !object.is_some_and(|index| objects.contains_key(&index)));
        others.map(|(start, _)| *start)
    }
}

/// The start of a header, and the object of its section.
fn start_of(document: &Document, line: &Line) -> Option<(u32, Option<u16>)> {
    let LineKind::Section { name } = line.kind else { return None };
    Some((line.span.start, SectionName::parse(name.of(document.text())).part.object()))
}

/// The sections after an edit, and the objects that need not be read again: only their own sections describe them, and
/// the edit did not touch these.
pub(super) fn unchanged(document: &Document, before: &BeforeEdit<'_>) -> (SectionStarts, Objects) {
    let (sections, touched) = before.sections.after(document, before.edited);
    let mut objects = before.plain.clone();
    // data of any object may be embedded in any comment
    let has_embedded =
        memchr::memmem::find(document.text().as_bytes(), EMBEDDED_COMMENT.as_bytes()).is_some();
    objects.retain(|index, _| !has_embedded && !touched.contains(index));
    (sections, objects)
}
