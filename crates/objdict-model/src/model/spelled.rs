//! The parts of the model that are a single string, or a special map or list, in JSON.

use std::borrow::Cow;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::serial::{HexText, unique_keys};
use super::{ClockTime, DataType, Date, Entry, Extra, Field, InvalidValue, InvalidValues, Subs};

/// Keys such as `0x0A`, because JSON keys are strings.
impl Serialize for Subs {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter().map(|(sub, entry)| (HexText(sub), entry)))
    }
}

impl<'de> Deserialize<'de> for Subs {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let entries = unique_keys::pairs::<HexText<u8>, Entry, D>(deserializer)?;
        Ok(entries.into_iter().map(|(HexText(sub), entry)| (sub, entry)).collect())
    }
}

/// Types that are a string in JSON, with the conversions in both directions.
macro_rules! texts {
    ($($(#[$about:meta])* $Type:ty, $what:literal: |$this:ident| $text:expr, |$read:ident| $parsed:expr;)*) => {$(
        $(#[$about])*
        impl Serialize for $Type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let $this = self;
                serializer.serialize_str(&$text)
            }
        }

        impl<'de> Deserialize<'de> for $Type {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let text = String::deserialize(deserializer)?;
                let $read = text.as_str();
                $parsed.ok_or_else(|| D::Error::custom(format!("`{text}` is not {}", $what)))
            }
        }
    )*};
}

texts! {
    Field, "a field": |field| field.name(), |name| Some(Self::from_name(name));
    /// The name or, without one, the index as `0x0060`.
    DataType, "a data type such as `UNSIGNED8` or `0x0040`":
        |of| of.name().map_or_else(|| HexText(of.0).to_string().into(), Cow::Borrowed),
        |text| Self::from_name(text).or_else(|| HexText::parse(text).map(Self));
    /// The format of ISO 8601: `2024-03-04`.
    Date, "a date such as `2024-03-04`": |date| date.to_iso(), |text| Self::from_iso(text);
    /// The format of ISO 8601: `14:40`.
    ClockTime, "a time such as `14:40`": |time| time.to_iso(false), |text| Self::from_iso(text);
}

impl Serialize for Extra {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

impl<'de> Deserialize<'de> for Extra {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut extra = Self::default();
        for (key, value) in Vec::<(String, String)>::deserialize(deserializer)? {
            extra.push(&key, &value);
        }
        Ok(extra)
    }
}

impl<'de> Deserialize<'de> for InvalidValues {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let invalid_values = Vec::<InvalidValue>::deserialize(deserializer)?;
        Ok(invalid_values.into_iter().collect())
    }
}

/// The number of entries of a compactly stored object.
pub(super) mod compact_count {
    use super::{Deserialize, Deserializer, Error};

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u8, D::Error> {
        let count = u8::deserialize(deserializer)?;
        if (1..=254).contains(&count) {
            return Ok(count);
        }
        Err(D::Error::custom(format!(
            "`{count}` is not a valid number of compactly stored entries: 1 to 254 are allowed"
        )))
    }
}
