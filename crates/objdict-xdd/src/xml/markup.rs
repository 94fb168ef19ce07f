//! Markup that starts with `<!` or `<?` and whose end may be anywhere after it.

/// A kind of markup.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Markup {
    Comment,
    Instruction,
    Section,
}

impl Markup {
    /// The markup at the start of a text.
    pub(super) fn at(text: &[u8]) -> Option<Self> {
        let kinds = [Self::Comment, Self::Instruction, Self::Section];
        kinds.into_iter().find(|kind| text.starts_with(kind.marks().0.as_bytes()))
    }

    /// How it starts and ends.
    pub(super) const fn marks(self) -> (&'static str, &'static str) {
        match self {
            Self::Comment => ("<!--", "-->"),
            Self::Instruction => ("<?", "?>"),
            Self::Section => ("<![CDATA[", "]]>"),
        }
    }

    /// The length of the markup at the start of a text; `None` if it has no end.
    pub(super) fn length(self, text: &[u8]) -> Option<usize> {
        let (start, end) = self.marks();
        // `<?>` is terminated, but malformed
        let from = if self == Self::Instruction { 1 } else { start.len() };
        memchr::memmem::find(text.get(from..)?, end.as_bytes()).map(|length| from + length + end.len())
    }
}
