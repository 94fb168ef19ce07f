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
        // digit by digit: a page of a large device has tens of thousands of them
        for shift in [12, 8, 4, 0] {
            f.write_str(digit(self.index >> shift))?;
        }
        let Some(sub) = self.sub else { return Ok(()) };
        f.write_str("sub")?;
        if sub > 0xF {
            f.write_str(digit((sub >> 4).into()))?;
        }
        f.write_str(digit(sub.into()))
    }
}

/// The last hex digit of a number.
fn digit(number: u16) -> &'static str {
    const DIGITS: &str = "0123456789ABCDEF";
    let at = usize::from(number & 0xF);
    &DIGITS[at..=at]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn anchors_are_called_as_sections_are() {
        let shown = |anchor: Anchor| anchor.to_string();
        assert_eq!(shown(Anchor::object(0x60AF)), "60AF");
        assert_eq!(shown(Anchor::entry(0x0005, 0)), "0005sub0");
        assert_eq!(shown(Anchor::entry(0x6000, 0xF)), "6000subF");
        assert_eq!(shown(Anchor::entry(0x6000, 0xFE)), "6000subFE");
    }
}
