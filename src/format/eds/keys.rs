//! Keys to fields, fast: a large description has a hundred thousand of them.

use std::sync::LazyLock;

use crate::model::Field;

/// The names of all fixed fields with their numbers, in groups of equal length.
static BY_LENGTH: LazyLock<Vec<Vec<(&'static str, u8)>>> = LazyLock::new(|| {
    let longest = Field::NAMED.iter().map(|(name, _)| name.len()).max().unwrap_or_default();
    let mut groups = vec![Vec::new(); longest + 1];
    for (number, (name, _)) in Field::NAMED.iter().enumerate() {
        groups[name.len()].push((*name, number as u8));
    }
    groups
});

/// A field with a fixed name: its number in [`Field::NAMED`], small enough for a bit set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Key(u8);

impl Key {
    /// The key of a text, whatever the case of its letters; `None` for one that the standard does not have.
    pub(crate) fn find(text: &str) -> Option<Self> {
        let group = BY_LENGTH.get(text.len())?;
        let first = text.as_bytes().first()?.to_ascii_lowercase();
        let mut candidates =
            group.iter().filter(|(name, _)| name.as_bytes()[0].to_ascii_lowercase() == first);
        let found = candidates.find(|(name, _)| *name == text || name.eq_ignore_ascii_case(text));
        found.map(|&(_, number)| Self(number))
    }

    /// The field.
    pub(crate) fn field(self) -> &'static Field {
        &Field::NAMED[usize::from(self.0)].1
    }

    /// The bit of this key in a set of keys.
    pub(crate) fn bit(self) -> u128 {
        1 << self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_is_found_in_any_case() {
        assert!(Field::NAMED.len() <= 128, "a set of keys has 128 bits");
        for (name, field) in Field::NAMED {
            assert_eq!(Key::find(&name.to_ascii_uppercase()).map(Key::field), Some(field));
        }
        assert_eq!(Key::find("ParameterNames"), None);
        assert_eq!(Key::find(""), None);
    }
}
