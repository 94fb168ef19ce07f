//! Fixes of findings: changes of the description, as data.

use super::{Applicability, Text};
use crate::model::{Field, ObjectList, Part, Place};
use crate::source::{Encoding, Span};

/// The fix of a finding: changes that belong together. The format of the description converts them to edits
/// of its text; if it cannot, the finding has no fix in that file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// The title, as an imperative: "remove the spaces before `=`".
    pub title: Text,
    /// Whether the fix preserves the meaning.
    pub safety: Applicability,
    /// The changes, of which all or none are applied.
    pub changes: Vec<Change>,
    /// Whether reports offer it; `objdict::with_sound_fixes` decides for a file.
    pub is_offered: bool,
}

/// One change of a description. Values are texts in the spelling of CiA 306-1; other formats convert them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Replaces bytes; only the reader of a format knows their position.
    Replace(Span, String),
    /// Sets a field: at its existing place, or as a new line or attribute.
    Set(Place, String),
    /// Removes a field or a whole part.
    Remove(Place),
    /// Adds a part with its fields.
    Add(Part, Vec<(Field, String)>),
    /// Sets the members of an object list, numbered from 1, with their count; replaces the list or adds a
    /// new one.
    List(ObjectList, Vec<u16>),
    /// Writes the file in an encoding that has all its characters.
    Encode(Encoding),
    /// Inserts a comment line above the line that contains the start of a span.
    Comment(Span, String),
    /// Comments out the line that contains the start of a span; for a section header, the whole section.
    CommentOut(Span),
    /// Removes the line that contains the start of a span.
    RemoveLine(Span),
    /// Removes the section whose header contains the start of a span.
    RemoveSection(Span),
    /// Fixes the same problem in all lines.
    Tidy(Tidy),
}

/// A problem that can occur in every line of a file; only the reader of the format knows the lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tidy {
    /// Mixed line ends: use the most frequent one.
    LineEnds,
    /// Comments with a marker from a different format.
    Comments,
    /// Spaces around keys.
    Keys,
    /// Characters outside ISO 646: transliterate them if possible.
    Iso646,
}

/// The maximum number of lines of a fix, and of all fixes of one rule that write long lists. Otherwise, each
/// of a thousand findings in a hostile file could contain a huge list.
pub const MAX_FIX_LINES: usize = 50_000;

impl Fix {
    /// A fix that preserves the meaning, without changes yet.
    pub fn safe(title: impl Into<Text>) -> Self {
        Self { title: title.into(), safety: Applicability::Safe, changes: Vec::new(), is_offered: true }
    }

    /// A fix that needs review, without changes yet.
    pub fn risky(title: impl Into<Text>) -> Self {
        Self { safety: Applicability::Unsafe, ..Self::safe(title) }
    }

    /// The replaced bytes, if the fix contains only replacements and so needs no reader of the format.
    pub fn replacements(&self) -> Option<Vec<(Span, String)>> {
        let replacement = |change: &Change| match change {
            Change::Replace(span, text) => Some((*span, text.clone())),
            _ => None,
        };
        self.changes.iter().map(replacement).collect()
    }

    /// Also replaces `span` by `text`.
    #[must_use]
    pub fn replace(self, span: Span, text: impl Into<String>) -> Self {
        self.with(Change::Replace(span, text.into()))
    }

    /// Also sets the field of `place`.
    #[must_use]
    pub fn set(self, place: Place, value: impl Into<String>) -> Self {
        self.with(Change::Set(place, value.into()))
    }

    /// Also removes `place`.
    #[must_use]
    pub fn remove(self, place: Place) -> Self {
        self.with(Change::Remove(place))
    }

    /// Also applies `change`.
    #[must_use]
    pub fn with(mut self, change: Change) -> Self {
        self.changes.push(change);
        self
    }
}
