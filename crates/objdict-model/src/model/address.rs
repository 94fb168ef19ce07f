//! Addresses of objects and entries.

use std::str::FromStr;

/// An object or entry, in the notations that users write.
///
/// ```
/// use objdict_model::model::Address;
///
/// let address: Address = "1018sub1".parse()?;
/// assert_eq!(address, Address { index: 0x1018, sub: Some(1) });
/// # Ok::<(), objdict_model::model::NoAddress>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// The index.
    pub index: u16,
    /// The sub-index; `None` for the object as a whole.
    pub sub: Option<u8>,
}

/// A text that is not an address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoAddress;

crate::error_messages! { NoAddress: {
    Self => "write the index in hex, and the sub-index in hex behind it: `1018`, `0x1018`, `1018:1`, `1018sub1`";
} }

/// `1018`, `0x1018` or `1018h`, optionally followed by `:1`, `sub1`, `.1` or `/1`. All numbers are
/// hexadecimal, as in the section names of an EDS.
impl FromStr for Address {
    type Err = NoAddress;

    fn from_str(text: &str) -> Result<Self, NoAddress> {
        let text = text.trim().to_ascii_lowercase();
        let (index, sub) = match text.split_once("sub").or_else(|| text.split_once([':', '.', '/'])) {
            Some((index, sub)) => (index, Some(sub)),
            None => (text.as_str(), None),
        };
        let index = hex(index).ok_or(NoAddress)?;
        let sub =
            sub.map(|sub| hex(sub).and_then(|sub| u8::try_from(sub).ok()).ok_or(NoAddress)).transpose()?;
        Ok(Self { index, sub })
    }
}

fn hex(text: &str) -> Option<u16> {
    let text = text.trim();
    let digits = text.strip_prefix("0x").or_else(|| text.strip_suffix('h')).unwrap_or(text);
    let is_hex = (1..=4).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_hex { u16::from_str_radix(digits, 16).ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_of_the_field() {
        let entry = Ok(Address { index: 0x1018, sub: Some(0xA) });
        for text in ["1018:a", "0x1018:0x0A", "1018subA", "1018h:0Ah", "1018.A", "1018/0a", "0x1018 sub a"] {
            assert_eq!(text.parse::<Address>(), entry, "{text}");
        }
        for text in ["1018", "0x1018", "1018h", "0X1018"] {
            assert_eq!(text.parse(), Ok(Address { index: 0x1018, sub: None }), "{text}");
        }
    }

    #[test]
    fn what_is_none() {
        for text in ["", "10181", "name", "1018:", "1018:100", "0x", ":1", "+101", "1018:-1"] {
            assert_eq!(text.parse::<Address>(), Err(NoAddress), "{text}");
        }
    }
}
