//! What objects and entries are called in addresses of a page, and in its text.

use std::fmt;

/// The name of an object or entry in an address: `6000`, `6000sub1`, as the sections of an EDS are called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Anchor {
    pub(crate) index: u16,
    /// `None` for the object as a whole.
    pub(crate) sub: Option<u8>,
}

impl Anchor {
    /// That of an object.
    pub(crate) const fn object(index: u16) -> Self {
        Self { index, sub: None }
    }

    /// That of an entry.
    pub(crate) const fn entry(index: u16, sub: u8) -> Self {
        Self { index, sub: Some(sub) }
    }

    /// The name in a text, as the field writes it: `6000h`, `6000h:01`.
    pub(crate) fn spoken(self) -> String {
        match self.sub {
            Some(sub) => format!("{:04X}h:{sub:02X}", self.index),
            None => format!("{:04X}h", self.index),
        }
    }
}

impl fmt::Display for Anchor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}", self.index)?;
        match self.sub {
            Some(sub) => write!(f, "sub{sub:X}"),
            None => Ok(()),
        }
    }
}
