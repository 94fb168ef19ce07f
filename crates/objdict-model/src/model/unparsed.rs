//! Content of a description without a field in the model, kept so that nothing is lost.

use super::Field;

/// Unknown keys and values, in the order of the file.
///
/// A single string with one line per key, so that a file full of unknown keys needs no more memory than
/// its text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[allow(
    clippy::box_collection,
    reason = "every entry has one, mostly empty: a pointer instead of three words"
)]
pub struct Extra(Option<Box<String>>);

impl Extra {
    /// Whether there are no keys.
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// Adds a key with its value. `=` and line feeds in a key and line feeds in a value become spaces; no
    /// line of an INI file can contain them.
    pub fn push(&mut self, key: &str, value: &str) {
        let text = self.0.get_or_insert_default();
        let length = key.len() + value.len() + 2;
        // most parts have at most one such key; only more keys need spare capacity
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

    /// The value of a key, ignoring case.
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

/// An unknown section. Name and keys are one string, because a file may have a million such sections: the name, then a
/// line end and the keys, if any.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(from = "super::flat::SectionForm", into = "super::flat::SectionForm"))]
pub struct ExtraSection(Box<str>);

impl ExtraSection {
    /// A section; the name has no brackets, and line feeds in it become spaces.
    pub fn new(name: &str, entries: &Extra) -> Self {
        let name = name.replace('\n', " ");
        let end = if entries.is_empty() { "" } else { "\n" };
        Self([&name, end, entries.text()].concat().into())
    }

    /// The name, without brackets.
    pub fn name(&self) -> &str {
        self.0.split('\n').next().unwrap_or_default()
    }

    /// The keys with their values.
    pub fn entries(&self) -> impl Iterator<Item = (&str, &str)> {
        entries(self.0.split_once('\n').map_or("", |(_, entries)| entries))
    }
}

/// Why a text is not valid in its field.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Reason {
    /// Not a number in any spelling.
    NotANumber,
    /// A number with a leading zero, thus octal, with a digit 8 or 9.
    NotOctal,
    /// A number outside the range of its type or field.
    OutOfRange {
        /// The minimum.
        low: i64,
        /// The maximum.
        high: u64,
    },
    /// Not a REAL number, or outside the range of the type.
    NotReal,
    /// Not pairs of hex digits.
    NotHexBytes,
    /// Not a TIME_OF_DAY or TIME_DIFFERENCE.
    NotATime,
    /// `$NODEID` followed by something other than `+` and a number.
    NotAFormula,
    /// A formula for a type that is not an integer.
    FormulaForType,
    /// Not a keyword of the field.
    UnknownWord,
    /// Not a date `mm-dd-yyyy`.
    NotADate,
    /// Not a time `hh:mmAM`.
    NotAClockTime,
    /// Not in the notation that the field requires.
    Malformed,
}

/// A text in a known field that is not valid there.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InvalidValue {
    /// The field.
    pub field: Field,
    /// The text as written.
    pub text: Box<str>,
    /// Why the text is not valid.
    pub reason: Reason,
}

/// The invalid values of one part of the model. The typed fields have no value for them.
#[derive(Clone, Debug, Default, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[allow(
    clippy::box_collection,
    reason = "every entry has them, mostly none: a pointer instead of three words"
)]
#[cfg_attr(feature = "serde", serde(transparent))]
pub struct InvalidValues(
    #[cfg_attr(feature = "schema", schemars(with = "Vec<InvalidValue>"))] Option<Box<Vec<InvalidValue>>>,
);

/// Accepts any order.
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
    /// Whether there are no invalid values.
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// Adds an invalid value.
    pub fn push(&mut self, field: Field, text: &str, reason: Reason) {
        let invalid_values = self.0.get_or_insert_default();
        // most parts have at most one; a vector would reserve room for four
        if invalid_values.is_empty() {
            invalid_values.reserve_exact(1);
        }
        invalid_values.push(InvalidValue { field, text: text.into(), reason });
    }

    /// Keeps the invalid values for which `keep` returns `true`.
    pub fn retain(&mut self, keep: impl FnMut(&InvalidValue) -> bool) {
        if let Some(invalid_values) = &mut self.0 {
            invalid_values.retain(keep);
        }
        self.0.take_if(|invalid_values| invalid_values.is_empty());
    }

    /// All invalid values, in the order of the file.
    pub fn iter(&self) -> std::slice::Iter<'_, InvalidValue> {
        self.0.as_ref().map_or(&[][..], |invalid_values| invalid_values.as_slice()).iter()
    }

    /// The invalid value of a field.
    pub fn get(&self, field: &Field) -> Option<&InvalidValue> {
        self.iter().find(|invalid| invalid.field == *field)
    }
}
