//! What a description says and the model has no field for, so that nothing is lost.

use super::Field;

/// Keys and values that the model does not know, in the order of the file.
///
/// One text holds them all (a line each), so that a file full of unknown keys takes no more memory than its text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[allow(
    clippy::box_collection,
    reason = "every entry has one, mostly empty: a pointer instead of three words"
)]
pub struct Extra(Option<Box<String>>);

impl Extra {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// Adds a key with its value. No line of an INI file gives a key with `=` or a line feed, or a value with a line
    /// feed; from elsewhere they become blanks.
    pub fn push(&mut self, key: &str, value: &str) {
        let text = self.0.get_or_insert_default();
        let length = key.len() + value.len() + 2;
        // most parts have one such key, if any; only more of them need room to grow
        if text.is_empty() {
            text.reserve_exact(length);
        } else {
            text.reserve(length);
        }
        text.extend(key.chars().map(|c| if matches!(c, '\n' | '=') { ' ' } else { c }));
        text.push('=');
        text.extend(value.chars().map(|c| if c == '\n' { ' ' } else { c }));
        text.push('\n');
    }

    /// All keys with their values.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        entries(self.text())
    }

    /// The value of a key, whatever the case of its letters.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.iter().find(|(name, _)| name.eq_ignore_ascii_case(key)).map(|(_, value)| value)
    }

    fn text(&self) -> &str {
        self.0.as_ref().map_or("", |text| text.as_str())
    }
}

fn entries(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split_terminator('\n').filter_map(|line| line.split_once('='))
}

impl<'a> FromIterator<(&'a str, &'a str)> for Extra {
    fn from_iter<I: IntoIterator<Item = (&'a str, &'a str)>>(entries: I) -> Self {
        let mut extra = Self::default();
        entries.into_iter().for_each(|(key, value)| extra.push(key, value));
        extra
    }
}

/// A section that the model does not know. Name and keys are one text, for a file may have a million such sections.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "super::flat::SectionForm", into = "super::flat::SectionForm"))]
pub struct ExtraSection {
    text: Box<str>,
    /// The length of the name, with which the text starts.
    name: usize,
}

impl ExtraSection {
    /// A section of a name without brackets.
    pub fn new(name: &str, entries: &Extra) -> Self {
        Self { text: [name, entries.text()].concat().into(), name: name.len() }
    }

    /// The name, without brackets.
    pub fn name(&self) -> &str {
        &self.text[..self.name]
    }

    /// Its keys with their values.
    pub fn entries(&self) -> impl Iterator<Item = (&str, &str)> {
        entries(&self.text[self.name..])
    }
}

/// Why a text is no value of its field.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Reason {
    /// Not a number in any spelling.
    NotANumber,
    /// A number with a leading zero, so octal, with a digit 8 or 9.
    NotOctal,
    /// A number outside the range of its type or field.
    OutOfRange {
        /// The smallest number that fits.
        low: i64,
        /// The largest number that fits.
        high: u64,
    },
    /// Not a REAL number, or one that is too large for the type.
    NotReal,
    /// Not pairs of hex digits.
    NotHexBytes,
    /// Not a TIME_OF_DAY or TIME_DIFFERENCE.
    NotATime,
    /// `$NODEID` with something else than `+` and a number.
    NotAFormula,
    /// A formula where the type is no integer.
    FormulaForType,
    /// None of the words that the field knows.
    UnknownWord,
    /// Not a date `mm-dd-yyyy`.
    NotADate,
    /// Not a time `hh:mmAM`.
    NotAClockTime,
    /// Not of the form that the field asks for.
    Malformed,
}

/// A text that stands in a known field and is no value of it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct InvalidValue {
    /// The field.
    pub field: Field,
    /// The text as it was written.
    pub text: Box<str>,
    /// What is wrong with it.
    pub reason: Reason,
}

/// The invalid_values of one part of the model. The typed fields hold no value for them.
#[derive(Clone, Debug, Default, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[allow(
    clippy::box_collection,
    reason = "every entry has them, mostly none: a pointer instead of three words"
)]
#[cfg_attr(feature = "serde", serde(transparent))]
pub struct InvalidValues(Option<Box<Vec<InvalidValue>>>);

/// In whatever order they stand.
impl FromIterator<InvalidValue> for InvalidValues {
    fn from_iter<I: IntoIterator<Item = InvalidValue>>(invalid_values: I) -> Self {
        let invalid_values: Vec<InvalidValue> = invalid_values.into_iter().collect();
        Self((!invalid_values.is_empty()).then(|| Box::new(invalid_values)))
    }
}

impl PartialEq for InvalidValues {
    fn eq(&self, other: &Self) -> bool {
        self.iter().len() == other.iter().len()
            && self.iter().all(|invalid| other.iter().any(|other| other == invalid))
    }
}

impl InvalidValues {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// Adds one.
    pub fn push(&mut self, field: Field, text: &str, reason: Reason) {
        let invalid_values = self.0.get_or_insert_default();
        // most parts have one, if any; a vector would make room for four
        if invalid_values.is_empty() {
            invalid_values.reserve_exact(1);
        }
        invalid_values.push(InvalidValue { field, text: text.into(), reason });
    }

    /// Keeps those that `keep` says so of.
    pub fn retain(&mut self, keep: impl FnMut(&InvalidValue) -> bool) {
        if let Some(invalid_values) = &mut self.0 {
            invalid_values.retain(keep);
        }
        self.0.take_if(|invalid_values| invalid_values.is_empty());
    }

    /// All of them, in the order of the file.
    pub fn iter(&self) -> std::slice::Iter<'_, InvalidValue> {
        self.0.as_ref().map_or(&[][..], |invalid_values| invalid_values.as_slice()).iter()
    }

    /// The invalid value of a field.
    pub fn get(&self, field: &Field) -> Option<&InvalidValue> {
        self.iter().find(|invalid| invalid.field == *field)
    }
}
