//! The style of a new text.

use crate::literal::RealSpelling;
use crate::source::Encoding;

/// The style of a new EDS or DCF, as opposed to an edit of an existing text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// How REAL numbers are spelled.
    pub real: RealSpelling,
    /// Whether string values are quoted, as dcfgen and dcf2dev require.
    pub quote_strings: bool,
    /// Whether compact storage (`CompactSubObj`) is kept, with the names of all entries; otherwise every
    /// entry gets a section, because many readers do not support compact storage.
    pub compact: bool,
    /// Whether entries have the keys `Unit`, `Factor` and `Description`, which CiA 306 does not define and python-canopen reads.
    pub meanings: bool,
    /// The encoding; `None` for ISO 646, as the standard requires. Characters that it lacks are
    /// transliterated.
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
