//! Fast conversion of keys to fields: a large description has a hundred thousand keys.

use crate::model::Field;

/// No field.
const NONE: u8 = u8::MAX;

/// All fixed fields by number, grouped by length, first and last letter: usually one or two per group.
struct Groups {
    /// The first field of each group.
    first: [u8; 256],
    /// The next field of the same group.
    next: [u8; Field::NAMED.len()],
}

static GROUPS: Groups = {
    let mut groups = Groups { first: [NONE; 256], next: [NONE; Field::NAMED.len()] };
    let mut number = Field::NAMED.len();
    while number > 0 {
        number -= 1;
        let group = group_of(Field::NAMED[number].0.as_bytes());
        groups.next[number] = groups.first[group];
        groups.first[group] = number as u8;
    }
    groups
};

/// The group of a name, case-insensitive. With these factors there are hardly any random collisions.
#[inline]
const fn group_of(name: &[u8]) -> usize {
    match name {
        [first, .., last] => {
            let (first, last) = ((*first | 0x20) as usize, (*last | 0x20) as usize);
            (name.len() * 26 + first * 53 + last * 29) % 256
        }
        _ => name.len(),
    }
}

/// Whether two names of 8 to 16 bytes are equal: compares two integers that may overlap.
#[inline]
fn is_same(name: &[u8], text: &[u8]) -> bool {
    let ends = |name: &[u8]| Some((*name.first_chunk::<8>()?, *name.last_chunk::<8>()?));
    let is_short = name.len() == text.len() && name.len() <= 16;
    is_short && ends(name).is_some_and(|ends_of_name| ends(text) == Some(ends_of_name))
}

/// A field with a fixed name: its number in [`Field::NAMED`], small enough for a bit set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FieldKey(u8);

/// Whether CiA 306 defines a key of this name for any section.
pub fn is_key(name: &str) -> bool {
    FieldKey::find(name).is_some()
}

/// Whether python-canopen reads this key of an entry, which CiA 306 does not define: the unit, factor or
/// description of its value.
pub fn is_meaning_key(name: &str) -> bool {
    ["Unit", "Factor", "Description"].iter().any(|key| name.eq_ignore_ascii_case(key))
}

impl FieldKey {
    /// The key with this name, case-insensitive; `None` if the standard does not define it.
    #[inline]
    pub(crate) fn find(text: &str) -> Option<Self> {
        let number = GROUPS.first[group_of(text.as_bytes())];
        match Field::NAMED.get(usize::from(number)) {
            Some((name, _)) if is_same(name.as_bytes(), text.as_bytes()) => Some(Self(number)),
            _ => Self::search(text, number),
        }
    }

    /// The key with this name in a group, starting at the given number.
    fn search(text: &str, mut number: u8) -> Option<Self> {
        while let Some((name, _)) = Field::NAMED.get(usize::from(number)) {
            if name.eq_ignore_ascii_case(text) {
                return Some(Self(number));
            }
            number = GROUPS.next[usize::from(number)];
        }
        None
    }

    /// The field of the key with this name, fixed or not.
    pub(crate) fn field_of(key: Option<Self>, name: &str) -> Field {
        let other = || Field::item(name).unwrap_or_else(|| Field::Named(name.into()));
        key.map_or_else(other, |key| key.field().clone())
    }

    /// Its number in [`Field::NAMED`].
    pub(crate) fn number(self) -> usize {
        self.0.into()
    }

    /// The field.
    pub(crate) fn field(self) -> &'static Field {
        &Field::NAMED[usize::from(self.0)].1
    }
}

/// A set of keys.
#[derive(Default)]
pub(crate) struct KeySet([u64; 2]);

impl KeySet {
    /// Adds a key; `false` if the set already contains it.
    #[inline]
    pub(crate) fn insert(&mut self, FieldKey(number): FieldKey) -> bool {
        let (word, bit) = (&mut self.0[usize::from(number >> 6) & 1], 1 << (number & 63));
        let is_new = *word & bit == 0;
        *word |= bit;
        is_new
    }

    /// Whether the set contains a key.
    pub(crate) fn contains(&self, FieldKey(number): FieldKey) -> bool {
        self.0[usize::from(number >> 6) & 1] & (1 << (number & 63)) != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_is_found_in_any_case() {
        assert!(Field::NAMED.len() <= 128, "a set of keys has 128 bits");
        for (name, field) in Field::NAMED {
            assert_eq!(FieldKey::find(&name.to_ascii_uppercase()).map(FieldKey::field), Some(field));
        }
        assert_eq!(FieldKey::find("ParameterNames"), None);
        assert_eq!(FieldKey::find(""), None);
    }
}
