//! Names of objects and entries in page addresses and in text.

use std::fmt;

/// The fragment identifier of an object or entry: `6000`, `6000sub1`, like the section names of an EDS.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Anchor {
    pub(crate) index: u16,
    /// `None` for the object as a whole.
    pub(crate) sub: Option<u8>,
}

impl Anchor {
    /// The anchor of an object.
    pub(crate) const fn object(index: u16) -> Self {
        Self { index, sub: None }
    }

    /// The anchor of an entry.
    pub(crate) const fn entry(index: u16, sub: u8) -> Self {
        Self { index, sub: Some(sub) }
    }

    /// The name in text: `0x6000`, `0x6000:01`.
    pub(crate) fn spoken(self) -> String {
        match self.sub {
            Some(sub) => format!("0x{:04X}:{sub:02X}", self.index),
            None => format!("0x{:04X}", self.index),
        }
    }
}

/// Converts hex numbers in an objdict sentence to the spelling of the page: `0x6000:01` instead of
/// `6000h:01`. Quoted text is unchanged.
pub(crate) fn in_one_spelling(sentence: &str) -> String {
    let mut parts = sentence.split('`');
    let mut text = spelled(parts.next().unwrap_or_default());
    for (number, part) in parts.enumerate() {
        text.push('`');
        text += &if number % 2 == 0 { part.to_owned() } else { spelled(part) };
    }
    text
}

fn spelled(part: &str) -> String {
    let mut text = String::with_capacity(part.len() + 8);
    let mut rest = part;
    while let Some(end) = rest.find('h') {
        let (before, behind) = rest.split_at(end);
        let is_digit = |c: char| c.is_ascii_digit() || ('A'..='F').contains(&c);
        let digits = before.len() - before.trim_end_matches(is_digit).len();
        let (words, number) = before.split_at(before.len() - digits);
        let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '$';
        let is_number = digits >= 2 && !words.ends_with(is_word) && !behind[1..].starts_with(is_word);
        text += words;
        text += if is_number { "0x" } else { "" };
        text += number;
        text += if is_number { "" } else { "h" };
        rest = &behind[1..];
    }
    text + rest
}

impl fmt::Display for Anchor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // digit by digit, not formatted: a page of a large device contains tens of thousands of them
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
    fn hex_numbers_have_one_spelling() {
        let shown =
            in_one_spelling("2000h:01 of `2000h` and 6260h to 6267h, 1F22h[3], FEh, hash, 12 h, 0x12h");
        assert_eq!(shown, "0x2000:01 of `2000h` and 0x6260 to 0x6267, 0x1F22[3], 0xFE, hash, 12 h, 0x12h");
        assert_eq!(in_one_spelling("größer als 10h"), "größer als 0x10");
    }

    #[test]
    fn anchors_are_called_as_sections_are() {
        let shown = |anchor: Anchor| anchor.to_string();
        assert_eq!(shown(Anchor::object(0x60AF)), "60AF");
        assert_eq!(shown(Anchor::entry(0x0005, 0)), "0005sub0");
        assert_eq!(shown(Anchor::entry(0x6000, 0xF)), "6000subF");
        assert_eq!(shown(Anchor::entry(0x6000, 0xFE)), "6000subFE");
    }
}
