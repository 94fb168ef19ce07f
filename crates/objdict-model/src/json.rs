//! JSON output: control characters of a terminal or of the text direction are escaped, and so are strings that a CI
//! service would interpret as commands.

use std::fmt;
use std::io::{self, Write};

use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::diagnostic::visible;

/// The version of a document; only this number is accepted. It changes when a field is removed or its meaning changes,
/// not when a field is added.
#[derive(Clone, Copy, Debug)]
pub struct Version<const NUMBER: u32>;

impl<const NUMBER: u32> Serialize for Version<NUMBER> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u32(NUMBER)
    }
}

impl<'de, const NUMBER: u32> Deserialize<'de> for Version<NUMBER> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Self)
    }
}

impl<const NUMBER: u32> Visitor<'_> for Version<NUMBER> {
    type Value = Self;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the version {NUMBER}")
    }

    fn visit_u64<E: de::Error>(self, version: u64) -> Result<Self, E> {
        match version {
            version if version == u64::from(NUMBER) => Ok(Self),
            _ => Err(E::custom(format!("unknown version `{version}`, this tool supports {NUMBER}"))),
        }
    }
}

#[cfg(feature = "schema")]
impl<const NUMBER: u32> schemars::JsonSchema for Version<NUMBER> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Version".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "const": NUMBER })
    }
}

/// Writes a value in one line.
pub fn write(out: &mut dyn Write, value: &(impl Serialize + ?Sized)) -> io::Result<()> {
    out.write_all(text(value)?.as_bytes())
}

/// Writes a value on several lines, without a final line end.
pub fn write_pretty(out: &mut dyn Write, value: &(impl Serialize + ?Sized)) -> io::Result<()> {
    out.write_all(pretty(value)?.as_bytes())
}

/// A value in one line.
pub fn text(value: &(impl Serialize + ?Sized)) -> serde_json::Result<String> {
    serde_json::to_string(value).map(escaped)
}

/// A quoted string that is valid in JSON, TOML and YAML.
pub fn quoted(text: &str) -> String {
    self::text(text).unwrap_or_default()
}

/// A value in lines.
pub fn pretty(value: &(impl Serialize + ?Sized)) -> serde_json::Result<String> {
    serde_json::to_string_pretty(value).map(escaped)
}

/// Escapes control characters except line ends; the meaning is unchanged. They occur only inside strings.
fn escaped(json: String) -> String {
    let is_plain = |byte: u8| matches!(byte, b'\n' | b' '..=b'~');
    if json.bytes().all(is_plain) && !json.contains("##") {
        return json;
    }
    let mut escaped = String::with_capacity(json.len());
    let mut rest = &*json;
    while let Some(at) = rest.bytes().position(|byte| byte == b'#' || !is_plain(byte)) {
        let (plain, special) = rest.split_at(at);
        let mut characters = special.chars();
        let character = characters.next().unwrap_or_default();
        escaped.push_str(plain);
        if special.starts_with("##") || visible(character) != character {
            // all of these are in the basic plane
            escaped.push_str(&format!("\\u{:04x}", u32::from(character)));
        } else {
            escaped.push(character);
        }
        rest = characters.as_str();
    }
    escaped + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_read_back() {
        let hostile = "a\u{1B}\u{7F}\u{85}\u{9B}\u{202E}\u{2066}\u{FEFF}##[error]#[b] \u{FFFD} größer\n";
        for json in [text(&hostile).unwrap(), pretty(&vec![hostile]).unwrap()] {
            assert!(json.chars().all(|c| c == '\n' || visible(c) == c), "{json}");
            assert!(!json.contains("##") && json.contains("größer"), "{json}");
            assert!(json.contains("\\u202e") && json.contains("\\u009b"), "{json}");
        }
        assert_eq!(serde_json::from_str::<String>(&text(&hostile).unwrap()).unwrap(), hostile);
    }
}
