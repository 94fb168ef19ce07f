//! The bits of a value in words.

use std::ops::Range;

use super::{BitField, EntryFacts, Profile, for_all, of_number};
use crate::model::{Device, Value};

impl EntryFacts<'_> {
    /// What the bits of a number say, as far as the document knows: groups of bits with what their value means, single bits
    /// that are set by their names. A negative number counts as its two's complement. `None` where it says nothing.
    pub fn meaning(&self, number: i128) -> Option<String> {
        // what lies beyond 64 bits has no fields
        let value = (number & i128::from(u64::MAX)) as u64;
        let parts: Vec<String> = self.bits().filter_map(|field| part(field, value)).collect();
        match parts.is_empty() {
            true if self.bits().len() == 0 => None,
            true => Some("no bit is set".to_owned()),
            false => Some(parts.join(", ")),
        }
    }
}

/// What a group of bits says; `None` for one that is 0 and has no word for that.
fn part(field: BitField<'_>, value: u64) -> Option<String> {
    let number = field.of(value);
    match (field.meaning(value), number) {
        (Some(meaning), _) => Some(format!("{}: {meaning}", field.name)),
        (None, 0) => None,
        (None, _) if field.first == field.last => Some(field.name.to_owned()),
        (None, _) => Some(format!("{}: {number}", field.name)),
    }
}

/// The area of a dictionary that is the manufacturer's (CiA 301 §7.4.1).
const MANUFACTURER: Range<u16> = 0x2000..0x6000;

/// What the bits of an entry's value say, after the documents that the device follows.
pub fn meaning(device: &Device, index: u16, sub: u8, value: &Value) -> Option<String> {
    // no document of CiA describes what is the manufacturer's
    let number = value.as_integer().filter(|_| !MANUFACTURER.contains(&index))?;
    let of = |profile: &Profile, block| profile.object_in(block, index)?.entry(sub)?.meaning(number);
    let own = (0..super::MAX_BLOCKS).find_map(|block| {
        let number = super::number_of(device, if device.profile() == Some(0xFFFF) { block } else { 0 })?;
        let profile = of_number(number)?;
        of(profile, if block == 0 || profile.repeats { block } else { return None })
    });
    own.or_else(|| for_all(device).find_map(|profile| of(profile, 0)))
}

#[cfg(test)]
mod tests {
    use crate::named;

    #[test]
    fn words_of_a_drive() {
        let meaning = |index, number| {
            let facts =
                named("402").and_then(|profile| profile.object(index)).and_then(|facts| facts.entry(0));
            facts.and_then(|facts| facts.meaning(number)).unwrap_or_default()
        };
        let shown = meaning(0x6041, 0x0237);
        assert!(shown.starts_with("state: operation enabled, ready to switch on, switched on"), "{shown}");
        assert!(shown.ends_with("quick stop off, remote"), "{shown}");
        assert_eq!(meaning(0x6060, -3), "mode: manufacturer-specific");
        assert_eq!(meaning(0x6060, 8), "mode: cyclic synchronous position");
        assert_eq!(meaning(0x6502, 0x0001_0001), "profile position, of the manufacturer: 1");
        assert_eq!(meaning(0x6502, 0), "no bit is set");
        assert_eq!(meaning(0x607A, 7), "");
    }
}
