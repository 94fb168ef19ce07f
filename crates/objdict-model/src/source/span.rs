//! Byte ranges of a source text.

/// A half-open byte range `start..end` of the decoded text of a [`SourceFile`](super::SourceFile).
///
/// Offsets have four bytes: no source is larger than 4 GiB, and the line records of a large file stay small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Span {
    /// Offset of the first byte.
    pub start: u32,
    /// Offset of the byte after the last one.
    pub end: u32,
}

impl Span {
    /// The span from `start` up to but not including `end`.
    pub const fn new(start: u32, end: u32) -> Self {
        Self { start, end }
    }

    /// The empty span at `offset`.
    pub const fn empty(offset: u32) -> Self {
        Self { start: offset, end: offset }
    }

    /// The number of bytes.
    pub const fn len(self) -> u32 {
        self.end - self.start
    }

    /// Whether the span has no bytes.
    pub const fn is_empty(self) -> bool {
        self.start == self.end
    }

    /// The text of this span in `text`; empty if the span is not within `text`.
    #[inline]
    pub fn of(self, text: &str) -> &str {
        text.get(self.start as usize..self.end as usize).unwrap_or_default()
    }
}

/// A value from a text, with its position; the position is empty for a value derived from the rest of the
/// text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Said<T> {
    /// The value.
    pub value: T,
    /// Its position.
    pub at: Span,
}

impl<T> Said<T> {
    /// A value with its position.
    pub const fn new(value: T, at: Span) -> Self {
        Self { value, at }
    }
}
