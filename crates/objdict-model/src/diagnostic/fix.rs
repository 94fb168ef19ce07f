//! How a finding is mended: changes of the description, as data.

use std::fmt;

use super::Text;
use crate::model::{Field, ObjectList, Part, Place};
use crate::source::{Encoding, Span};

/// How a finding is mended: changes that belong together. The format of the description turns them into edits of its
/// text; where it cannot, the finding has no fix in that file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What is done, as a command: "remove the blanks before `=`".
    pub title: Text,
    /// Whether the meaning stays.
    pub safety: Applicability,
    /// The changes; all of them or none are made.
    pub changes: Vec<Change>,
}

/// Whether a fix may be applied without a person who reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Applicability {
    /// The description means the same to every tool afterwards, or what no tool could have understood is gone.
    Safe,
    /// The most likely intention; somebody should look at it.
    Unsafe,
}

impl fmt::Display for Applicability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Safe => "safe",
            Self::Unsafe => "unsafe",
        })
    }
}

/// One change of a description. Values are texts in the spelling of CiA 306-1; other formats translate them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Puts a text in the place of bytes; only the reader of a format knows them.
    Replace(Span, String),
    /// Gives a field a value: where it stands, else as a new line or attribute of its part, which exists.
    Set(Place, String),
    /// Takes a field away, or a part as a whole.
    Remove(Place),
    /// Adds a part with its fields.
    Add(Part, Vec<(Field, String)>),
    /// Gives a list of objects these members, numbered from 1, with their count; in the list's place, or as a new one.
    List(ObjectList, Vec<u16>),
    /// Writes the text in another encoding, which has all its characters.
    Encode(Encoding),
    /// Puts a comment on a line of its own, above the line in which a span starts.
    Comment(Span, String),
    /// Takes the line away that holds the start of a span.
    RemoveLine(Span),
    /// Takes the section away whose header holds the start of a span.
    RemoveSection(Span),
    /// Mends what is wrong alike in many lines, in all of them.
    Tidy(Tidy),
}

/// What can be wrong in every line of a file; only the reader of the format knows where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tidy {
    /// Line ends of several kinds: those that most lines have.
    LineEnds,
    /// Comments with another mark than the format's.
    Comments,
    /// Blanks around keys.
    Keys,
    /// Characters that ISO 646 does not have: what stands for them there, where something does.
    Iso646,
}

/// So many lines a fix touches at most, and so many all fixes of one rule that write long lists. A hostile file has lists that
/// no device has, and each of a thousand findings would hold one of them.
pub const MAX_FIX_LINES: usize = 50_000;

impl Fix {
    /// A fix without changes yet that keeps the meaning.
    pub fn safe(title: impl Into<Text>) -> Self {
        Self { title: title.into(), safety: Applicability::Safe, changes: Vec::new() }
    }

    /// A fix without changes yet that somebody should look at.
    pub fn risky(title: impl Into<Text>) -> Self {
        Self { safety: Applicability::Unsafe, ..Self::safe(title) }
    }

    /// Also puts `text` in the place of `span`.
    #[must_use]
    pub fn replace(self, span: Span, text: impl Into<String>) -> Self {
        self.with(Change::Replace(span, text.into()))
    }

    /// Also gives the field of `place` a value.
    #[must_use]
    pub fn set(self, place: Place, value: impl Into<String>) -> Self {
        self.with(Change::Set(place, value.into()))
    }

    /// Also takes `place` away.
    #[must_use]
    pub fn remove(self, place: Place) -> Self {
        self.with(Change::Remove(place))
    }

    /// Also makes another change.
    #[must_use]
    pub fn with(mut self, change: Change) -> Self {
        self.changes.push(change);
        self
    }
}
