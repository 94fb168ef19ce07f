//! Custom names for identifiers in TOML, one per line: `"2000sub1" = "speed"`.

#[cfg(feature = "toml")]
use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::str::FromStr;

use super::StorageGroup;
use crate::model::Address;
#[cfg(feature = "toml")]
use crate::model::NoAddress;

/// An invalid value of an option.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChoiceError {
    /// Line in a file, counted from 1.
    pub line: Option<usize>,
    /// Description of the error: lower case, no full stop.
    pub message: String,
}

objdict_model::error_messages! { ChoiceError: { Self { message, .. } => "{message}"; } }

impl ChoiceError {
    fn new(message: impl Into<String>) -> Self {
        Self { line: None, message: message.into() }
    }
}

/// Parses a file with names of objects and entries.
///
/// # Errors
/// If the TOML is invalid or contains anything other than addresses and names.
#[cfg(feature = "toml")]
pub fn renames(text: &str) -> Result<BTreeMap<Address, String>, ChoiceError> {
    let line_of = |at: usize| Some(text.get(..at).unwrap_or(text).matches('\n').count() + 1);
    let table: BTreeMap<toml::Spanned<String>, String> = toml::from_str(text).map_err(|error| {
        let line = error.span().and_then(|span| line_of(span.start));
        ChoiceError { line, message: error.message().trim_end().to_owned() }
    })?;
    let mut names = BTreeMap::new();
    for (key, name) in table {
        let on_line = |error: ChoiceError| ChoiceError { line: line_of(key.span().start), ..error };
        let no_address = |error: NoAddress| {
            on_line(ChoiceError::new(format!("`{}` is not an object; {error}", key.get_ref())))
        };
        let at: Address = key.get_ref().parse().map_err(no_address)?;
        if name.bytes().all(|byte| !byte.is_ascii_alphanumeric()) {
            let message = format!("`{name}` has no letter or digit for an identifier");
            return Err(on_line(ChoiceError::new(message)));
        }
        if names.insert(at, name).is_some() {
            return Err(on_line(ChoiceError::new(format!("`{}` is defined twice", key.get_ref()))));
        }
    }
    Ok(names)
}

/// `2000=NAME` or `2000-2FFF=NAME`.
impl FromStr for StorageGroup {
    type Err = ChoiceError;

    fn from_str(text: &str) -> Result<Self, ChoiceError> {
        let no_group = || ChoiceError::new(format!("`{text}` is not a group; write it as `2000-2FFF=NAME`"));
        let (objects, name) = text.split_once('=').ok_or_else(no_group)?;
        let (first, last) = objects.split_once('-').unwrap_or((objects, objects));
        let index = |text: &str| match text.parse() {
            Ok(Address { index, sub: None }) => Ok(index),
            _ => Err(no_group()),
        };
        let (first, last) = (index(first)?, index(last)?);
        Self::new(first..=last, name.trim()).map_err(|_| no_group())
    }
}

impl StorageGroup {
    /// Creates a group of this name for a range of objects. A name is a letter followed by letters, digits
    /// and `_`.
    ///
    /// # Errors
    /// If the range is empty or the name is not valid.
    pub fn new(objects: RangeInclusive<u16>, name: &str) -> Result<Self, ChoiceError> {
        let is_word = name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
        if objects.is_empty() {
            let (first, last) = (objects.start(), objects.end());
            return Err(ChoiceError::new(format!("no object is in {first:X}h to {last:X}h")));
        }
        if !is_word || !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            let message =
                format!("`{name}` is not a group name: write a letter, then letters, digits and `_`");
            return Err(ChoiceError::new(message));
        }
        Ok(Self { objects, name: name.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(feature = "toml")]
    fn a_file_of_names() {
        let names = renames("2000 = \"speed\"\n\"2001sub1\" = \"left\"\n").unwrap();
        assert_eq!(names[&Address { index: 0x2000, sub: None }], "speed");
        assert_eq!(names[&Address { index: 0x2001, sub: Some(1) }], "left");
        for (text, line) in [
            ("2000 = \"a\"\nspeed = \"b\"", 2),
            ("2000 = 1", 1),
            ("\n2000 = \"a\"\n2000 = \"b\"", 3),
            ("2000 = \"-\"", 1),
            ("2000 = \"a\"\n\"2000h\" = \"b\"", 2),
        ] {
            assert_eq!(renames(text).unwrap_err().line, Some(line), "{text}");
        }
    }

    #[test]
    fn groups_are_ranges() {
        let group = |text: &str| text.parse::<StorageGroup>();
        assert_eq!(group("2000=RAM"), Ok(StorageGroup { objects: 0x2000..=0x2000, name: "RAM".to_owned() }));
        assert_eq!(group("2000-2FFF=PERSIST_APP").map(|group| group.objects).ok(), Some(0x2000..=0x2FFF));
        for text in ["2000", "=RAM", "2FFF-2000=RAM", "2000=", "2000=a b", "2000sub1=RAM"] {
            assert!(group(text).is_err(), "{text}");
        }
    }
}
