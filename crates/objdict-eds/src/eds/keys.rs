//! Keys to fields, fast: a large description has a hundred thousand of them.

use std::sync::LazyLock;

use crate::model::Field;

/// The numbers of all fixed fields, in groups that share length, first and last letter: one or two each.
static GROUPS: LazyLock<[Vec<u8>; 256]> = LazyLock::new(|| {
    let mut groups = [const { Vec::new() }; 256];
    for (number, (name, _)) in Field::NAMED.iter().enumerate() {
        groups[group_of(name.as_bytes())].push(number as u8);
    }
    groups
});

/// The group of a name, the same for upper and lower case.
fn group_of(name: &[u8]) -> usize {
    let lower = |byte: Option<&u8>| byte.map_or(0, |byte| usize::from(byte | 0x20));
    (name.len() * 3 + lower(name.first()) * 5 + lower(name.last()) * 11) % 256
}

/// A field with a fixed name: its number in [`Field::NAMED`], small enough for a bit set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Key(u8);

impl Key {
    /// The key of a text, whatever the case of its letters; `None` for one that the standard does not have.
    pub(crate) fn find(text: &str) -> Option<Self> {
        let group = &GROUPS[group_of(text.as_bytes())];
        let is_name = |number: &&u8| {
            let (name, _) = Field::NAMED[usize::from(**number)];
            name.len() == text.len() && (name == text || name.eq_ignore_ascii_case(text))
        };
        group.iter().find(is_name).map(|&number| Self(number))
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
