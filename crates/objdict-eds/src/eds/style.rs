//! How a new text is written.

use crate::literal::RealSpelling;
use crate::source::Encoding;

/// How an EDS or DCF is written that is no edit of another text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// How REAL numbers are spelled.
    pub real: RealSpelling,
    /// Whether strings that are values stand in quotes, as dcfgen and dcf2dev demand.
    pub quote_strings: bool,
    /// Whether what is stored compactly stays so (`CompactSubObj`), with the names of all entries; otherwise every entry
    /// gets a section, for many readers know nothing else.
    pub compact: bool,
    /// The encoding; `None` for ISO 646, as the standard demands. What it lacks is written in other letters.
    pub encoding: Option<Encoding>,
}

impl Style {
    /// Whether the encoding has a character.
    pub(super) fn can_write(&self, c: char) -> bool {
        match self.encoding {
            None => c.is_ascii(),
            Some(_) if c.is_ascii() => true,
            Some(encoding) => encoding.encode(c.encode_utf8(&mut [0; 4])).is_ok(),
        }
    }
}
