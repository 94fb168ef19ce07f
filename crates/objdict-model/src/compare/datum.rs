//! A datum as JSON.

use std::io::{self, Write};

use serde::de::IgnoredAny;
use serde::{Serialize, Serializer};
use serde_json::Value;

/// So many bytes make a tree of megabytes.
const LARGE: usize = 1 << 16;

/// The JSON of a datum as its text: as a tree, a short datum takes twenty times the memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Datum(Box<str>);

impl Datum {
    /// The JSON of a part of the model, which always has one: its keys are texts.
    pub(super) fn of(part: &impl Serialize) -> Self {
        Self(serde_json::to_string(part).unwrap_or_default().into_boxed_str())
    }

    /// The text of a value as it is; `None` when it does not begin with one. With it comes what is behind.
    pub fn prefix(text: &str) -> Option<(Self, &str)> {
        let mut values = serde_json::Deserializer::from_str(text).into_iter::<IgnoredAny>();
        values.next()?.ok()?;
        let (value, rest) = text.split_at(values.byte_offset());
        // in one spelling, where that takes no memory
        let value = Self(value.into());
        Some((if value.0.len() < LARGE { Self::from(value.value()) } else { value }, rest))
    }

    /// Whether a tree of it would take much memory.
    pub(super) fn is_large(&self) -> bool {
        self.0.len() >= LARGE
    }

    /// The datum as a tree.
    pub fn value(&self) -> Value {
        serde_json::from_str(&self.0).unwrap_or_default()
    }

    /// The text, without blanks between its parts.
    pub fn text(&self) -> &str {
        &self.0
    }

    /// A number that distinguishes values: the 32-bit FNV-1a hash of the text.
    pub fn fingerprint(&self) -> u32 {
        self.0.bytes().fold(0x811C_9DC5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
    }
}

impl From<&Value> for Datum {
    fn from(value: &Value) -> Self {
        Self(value.to_string().into())
    }
}

impl From<Value> for Datum {
    fn from(value: Value) -> Self {
        Self::from(&value)
    }
}

messages! { Datum: { Self(text) => "{text}"; } }

impl Serialize for Datum {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value().serialize(serializer)
    }
}

#[cfg(feature = "schema")]
crate::inline_schemas! {
    // any part of a device
    Datum: |_| schemars::json_schema!({});
}

/// How many values the JSON of a datum has, counted without making it.
pub(super) fn count(datum: &impl Serialize) -> usize {
    struct Counter(usize);
    impl Write for Counter {
        fn write(&mut self, token: &[u8]) -> io::Result<usize> {
            // what begins a value; the first one of a list or object follows its bracket
            self.0 += usize::from(matches!(token, b"," | b"[" | b"{"));
            Ok(token.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    let mut counter = Counter(1);
    // the counter has no errors, and the keys of the model are texts
    let _ = serde_json::to_writer(&mut counter, datum);
    counter.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_are_counted_as_they_are_in_the_text() {
        assert_eq!(count(&json!(1)), 1);
        assert_eq!(count(&json!([1, 2])), 3);
        assert_eq!(count(&json!({ "a": [1, { "b": "c, [d" }], "e": 1 })), 6);
    }
}
