//! The parts of the model that are a single text, or a special map or list, in JSON.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::serial::{HexText, unique_keys};
use super::{ClockTime, DataType, Date, Entry, Extra, Field, InvalidValue, InvalidValues, Subs};

/// Keys such as `0x0A`, as texts because JSON has no other keys.
impl Serialize for Subs {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter().map(|(sub, entry)| (HexText(sub), entry)))
    }
}

impl<'de> Deserialize<'de> for Subs {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let entries = unique_keys::deserialize::<HexText<u8>, Entry, D>(deserializer)?;
        Ok(entries.into_iter().map(|(HexText(sub), entry)| (sub, entry)).collect())
    }
}

impl Serialize for Field {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

impl<'de> Deserialize<'de> for Field {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer).map(|name| Self::from_name(&name))
    }
}

/// The name or, without one, the index as `0x0060`.
impl Serialize for DataType {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.name() {
            Some(name) => serializer.serialize_str(name),
            None => HexText(self.0).serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for DataType {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let data_type = Self::from_name(&text).or_else(|| HexText::parse(&text).map(Self));
        let error = || format!("`{text}` is not a data type such as `UNSIGNED8` or `0x0040`");
        data_type.ok_or_else(|| D::Error::custom(error()))
    }
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

/// The format of ISO 8601: `2024-03-04`.
impl Serialize for Date {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.to_iso())
    }
}

impl<'de> Deserialize<'de> for Date {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let date = Self::from_iso(&text);
        date.ok_or_else(|| D::Error::custom(format!("`{text}` is not a date such as `2024-03-04`")))
    }
}

/// The format of ISO 8601: `14:40`.
impl Serialize for ClockTime {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.to_iso(false))
    }
}

impl<'de> Deserialize<'de> for ClockTime {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let time = Self::from_iso(&text);
        time.ok_or_else(|| D::Error::custom(format!("`{text}` is not a time such as `14:40`")))
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
