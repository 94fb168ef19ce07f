//! Values in JSON: the exact notation, an object with the kind as key, and next to it the plain notation.
//!
//! Devices are compared by the exact notation. Documents for users contain both, so that a program can use `value`
//! without a table of kinds. Reading uses the exact notation and checks the plain one against it.

use std::borrow::Cow;
use std::cell::Cell;
use std::fmt;

use serde::de::{Error, MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Time, Value, hex, hex_text, real_text};

/// The key of the plain notation.
const PLAIN: &str = "value";

/// A value without its kind: finite numbers and BOOLEAN as such, all others as the string shown in tables.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Plain<'a> {
    /// BOOLEAN.
    Boolean(bool),
    /// INTEGERn.
    Signed(i64),
    /// UNSIGNEDn.
    Unsigned(u64),
    /// A finite REAL; a REAL32 is printed with its own digits, not with those of the nearest REAL64.
    Real(f64),
    /// Any other value as a string: strings, bytes in hex, times, formulas such as `$NODEID+0x180`.
    Text(Cow<'a, str>),
}

impl Value {
    /// The value without its kind.
    pub fn plain(&self) -> Plain<'_> {
        match self {
            Self::Boolean(value) => Plain::Boolean(*value),
            Self::Signed(value) => Plain::Signed(*value),
            Self::Unsigned(value) => Plain::Unsigned(*value),
            Self::Real32(value) if value.is_finite() => {
                Plain::Real(value.to_string().parse().unwrap_or(f64::from(*value)))
            }
            Self::Real64(value) if value.is_finite() => Plain::Real(*value),
            Self::Text(text) | Self::Raw(text) => Plain::Text(Cow::Borrowed(text)),
            _ => Plain::Text(Cow::Owned(self.to_string())),
        }
    }

    /// The key of the exact notation.
    const fn kind(&self) -> PlainKind {
        match self {
            Self::Boolean(_) => PlainKind::Boolean,
            Self::Signed(_) => PlainKind::Signed,
            Self::Unsigned(_) => PlainKind::Unsigned,
            Self::Real32(_) => PlainKind::Real32,
            Self::Real64(_) => PlainKind::Real64,
            Self::Text(_) => PlainKind::Text,
            Self::Bytes(_) => PlainKind::Bytes,
            Self::Time(_) => PlainKind::Time,
            Self::NodeId(_) => PlainKind::NodeIdPlus,
            Self::Raw(_) => PlainKind::Raw,
        }
    }
}

impl Plain<'_> {
    /// The same value without its borrowed source.
    pub fn into_owned(self) -> Plain<'static> {
        match self {
            Self::Boolean(value) => Plain::Boolean(value),
            Self::Signed(number) => Plain::Signed(number),
            Self::Unsigned(number) => Plain::Unsigned(number),
            Self::Real(number) => Plain::Real(number),
            Self::Text(text) => Plain::Text(Cow::Owned(text.into_owned())),
        }
    }

    /// Whether both are equal; tools may write numbers in different spellings and with the digits of a
    /// REAL64.
    fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Boolean(one), Self::Boolean(other)) => one == other,
            (Self::Text(one), Self::Text(other)) => one == other,
            _ => match (self.integer(), other.integer()) {
                (Some(one), Some(other)) => one == other,
                _ => self.real().zip(other.real()).is_some_and(|(one, other)| {
                    // a reader of decimal digits may be one bit off
                    one == other || (one - other).abs() <= 2.0 * f64::EPSILON * other.abs()
                }),
            },
        }
    }

    fn integer(&self) -> Option<i128> {
        match self {
            Self::Signed(number) => Some(i128::from(*number)),
            Self::Unsigned(number) => Some(i128::from(*number)),
            _ => None,
        }
    }

    fn real(&self) -> Option<f64> {
        match self {
            Self::Real(number) => Some(*number),
            _ => self.integer().map(|number| number as f64),
        }
    }
}

// As in JSON, but for escapes in texts.
crate::messages! { Plain<'_>: {
    Self::Boolean(value) => "{value}";
    Self::Signed(value) => "{value}";
    Self::Unsigned(value) => "{value}";
    Self::Real(value) => "{value:?}";
    Self::Text(text) => "{text}";
} }

thread_local! {
    static HAS_PLAIN: Cell<bool> = const { Cell::new(false) };
}

/// A part of the model for users: its JSON also contains the plain notation of each value, as `value`.
#[derive(Clone, Copy, Debug)]
pub struct WithPlainValues<'a, T>(pub &'a T);

impl<T: Serialize> Serialize for WithPlainValues<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        /// Restores the flag, even after a panic.
        struct Before(bool);
        impl Drop for Before {
            fn drop(&mut self) {
                HAS_PLAIN.set(self.0);
            }
        }
        let _before = Before(HAS_PLAIN.replace(true));
        self.0.serialize(serializer)
    }
}

/// The key of an exact notation, or of the plain one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum PlainKind {
    Boolean,
    Signed,
    Unsigned,
    Real32,
    Real64,
    Text,
    Bytes,
    Time,
    NodeIdPlus,
    Raw,
    /// The plain notation.
    Value,
}

impl fmt::Display for PlainKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

/// REAL as the string of its exact notation.
#[derive(Serialize, Deserialize)]
#[serde(transparent, bound = "")]
struct RealText<T: real_text::Real>(#[serde(with = "real_text")] T);

/// Bytes as the string of their exact notation.
#[derive(Deserialize)]
#[serde(transparent)]
struct PlainBytes(#[serde(deserialize_with = "hex_text::deserialize")] Box<[u8]>);

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let has_plain = HAS_PLAIN.get();
        let mut map = serializer.serialize_map(Some(1 + usize::from(has_plain)))?;
        let kind = &self.kind();
        match self {
            Self::Boolean(value) => map.serialize_entry(kind, value)?,
            Self::Signed(value) => map.serialize_entry(kind, value)?,
            Self::Unsigned(value) | Self::NodeId(value) => map.serialize_entry(kind, value)?,
            Self::Real32(value) => map.serialize_entry(kind, &RealText(*value))?,
            Self::Real64(value) => map.serialize_entry(kind, &RealText(*value))?,
            Self::Text(text) | Self::Raw(text) => map.serialize_entry(kind, text)?,
            Self::Bytes(bytes) => map.serialize_entry(kind, &hex::print(bytes))?,
            Self::Time(time) => map.serialize_entry(kind, time)?,
        }
        if has_plain {
            map.serialize_entry(PLAIN, &self.plain())?;
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(ValueVisitor)
    }
}

struct ValueVisitor;

impl<'de> Visitor<'de> for ValueVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value such as `{\"unsigned\": 5}`")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut access: A) -> Result<Value, A::Error> {
        let (mut exact, mut plain): (Option<Value>, Option<Plain<'static>>) = (None, None);
        while let Some(kind) = access.next_key::<PlainKind>()? {
            if kind == PlainKind::Value {
                if plain.replace(access.next_value()?).is_some() {
                    return Err(A::Error::custom("the key `value` is defined twice"));
                }
                continue;
            }
            if let Some(first) = &exact {
                let first = first.kind();
                let message = match first == kind {
                    true => format!("the key `{kind}` is defined twice"),
                    false => format!("a value has one kind, not both `{first}` and `{kind}`"),
                };
                return Err(A::Error::custom(message));
            }
            exact = Some(match kind {
                PlainKind::Boolean => Value::Boolean(access.next_value()?),
                PlainKind::Signed => Value::Signed(access.next_value()?),
                PlainKind::Unsigned => Value::Unsigned(access.next_value()?),
                PlainKind::Real32 => Value::Real32(access.next_value::<RealText<_>>()?.0),
                PlainKind::Real64 => Value::Real64(access.next_value::<RealText<_>>()?.0),
                PlainKind::Text => Value::Text(access.next_value()?),
                PlainKind::Bytes => Value::Bytes(access.next_value::<PlainBytes>()?.0),
                PlainKind::Time => Value::Time(access.next_value::<Time>()?),
                PlainKind::NodeIdPlus => Value::NodeId(access.next_value()?),
                PlainKind::Raw | PlainKind::Value => Value::Raw(access.next_value()?),
            });
        }
        let Some(value) = exact else {
            return Err(A::Error::custom("the kind of the value is missing, such as `unsigned`"));
        };
        match plain {
            Some(plain) if !plain.is(&value.plain()) => Err(A::Error::custom(format!(
                "`value` is `{plain}`, but `{}` is `{}`: change both, or remove `value`",
                value.kind(),
                value.plain()
            ))),
            _ => Ok(value),
        }
    }
}

impl<'de> Deserialize<'de> for Plain<'static> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PlainVisitor)
    }
}

struct PlainVisitor;

impl Visitor<'_> for PlainVisitor {
    type Value = Plain<'static>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a string, `true` or `false`")
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Self::Value, E> {
        Ok(Plain::Boolean(value))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Self::Value, E> {
        Ok(Plain::Signed(number))
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Self::Value, E> {
        Ok(Plain::Unsigned(number))
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Self::Value, E> {
        Ok(Plain::Real(number))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        Ok(Plain::Text(Cow::Owned(text.to_owned())))
    }
}

#[cfg(feature = "schema")]
mod schema {
    use std::borrow::Cow;

    use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

    use super::{PLAIN, PlainKind, Time, Value};

    impl JsonSchema for Value {
        fn schema_name() -> Cow<'static, str> {
            "Value".into()
        }

        fn json_schema(generator: &mut SchemaGenerator) -> Schema {
            let text = || json_schema!({ "type": "string" });
            let real = || json_schema!({ "type": ["number", "string"] });
            let bits = |digits: u8| {
                let pattern = format!("^(-?[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?|0x[0-9A-F]{{1,{digits}}})$");
                json_schema!({ "type": "string", "pattern": pattern })
            };
            let integer = |signed: bool| match signed {
                true => json_schema!({ "type": "integer", "minimum": i64::MIN, "maximum": i64::MAX }),
                false => json_schema!({ "type": "integer", "minimum": 0, "maximum": u64::MAX }),
            };
            let bytes = || json_schema!({ "type": "string", "pattern": "^([0-9A-F]{2})*$" });
            let boolean = || json_schema!({ "type": "boolean" });
            let time = generator.subschema_for::<Time>();
            let kind = |kind: PlainKind, about: &str, exact: Schema, plain: Schema| {
                let kind = kind.to_string();
                json_schema!({
                    "description": about,
                    "type": "object",
                    "properties": { kind.as_str(): exact, PLAIN: plain },
                    "required": [kind, PLAIN],
                    "additionalProperties": false,
                })
            };
            let kinds = [
                kind(PlainKind::Boolean, "BOOLEAN.", boolean(), boolean()),
                kind(PlainKind::Signed, "INTEGERn.", integer(true), integer(true)),
                kind(PlainKind::Unsigned, "UNSIGNEDn.", integer(false), integer(false)),
                kind(
                    PlainKind::Real32,
                    "REAL32, as a text with every bit; infinity and NaN as bits after `0x`.",
                    bits(8),
                    real(),
                ),
                kind(
                    PlainKind::Real64,
                    "REAL64, as a text with every bit; infinity and NaN as bits after `0x`.",
                    bits(16),
                    real(),
                ),
                kind(PlainKind::Text, "VISIBLE_STRING and UNICODE_STRING.", text(), text()),
                kind(PlainKind::Bytes, "OCTET_STRING and DOMAIN, in hex.", bytes(), bytes()),
                kind(PlainKind::Time, "TIME_OF_DAY and TIME_DIFFERENCE.", time, text()),
                kind(
                    PlainKind::NodeIdPlus,
                    "The node-ID plus this number (`$NODEID+n`), for integer types.",
                    integer(false),
                    text(),
                ),
                kind(PlainKind::Raw, "A text with a non-static data type, as written.", text(), text()),
            ];
            json_schema!({
                "description": "A value of an entry: its exact form, with its kind as key, and `value`, the plain form: a number, `true`, `false` or a text.",
                "oneOf": kinds,
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(value: &Value) -> String {
        serde_json::to_string(value).unwrap()
    }

    fn both(value: &Value) -> String {
        serde_json::to_string(&WithPlainValues(value)).unwrap()
    }

    fn read(text: &str) -> Result<Value, String> {
        serde_json::from_str(text).map_err(|error| error.to_string())
    }

    #[test]
    fn the_plain_form_is_beside_the_exact_one_where_it_is_asked_for() {
        let time = Time { days: 2, milliseconds: 1000 };
        for (value, text) in [
            (Value::Boolean(true), "{\"boolean\":true,\"value\":true}"),
            (Value::Signed(-2), "{\"signed\":-2,\"value\":-2}"),
            (Value::Unsigned(u64::MAX), "{\"unsigned\":18446744073709551615,\"value\":18446744073709551615}"),
            (Value::Real32(0.1), "{\"real32\":\"0.1\",\"value\":0.1}"),
            (Value::Real64(-1.0), "{\"real64\":\"-1.0\",\"value\":-1.0}"),
            (Value::Real32(f32::INFINITY), "{\"real32\":\"0x7F800000\",\"value\":\"inf\"}"),
            (Value::Text("a\"b".into()), "{\"text\":\"a\\\"b\",\"value\":\"a\\\"b\"}"),
            (Value::Bytes([1, 0xA1].into()), "{\"bytes\":\"01A1\",\"value\":\"01A1\"}"),
            (Value::Time(time), "{\"time\":{\"days\":2,\"milliseconds\":1000},\"value\":\"2 d 1000 ms\"}"),
            (Value::NodeId(0x180), "{\"node_id_plus\":384,\"value\":\"$NODEID+0x180\"}"),
            (Value::Raw("5".into()), "{\"raw\":\"5\",\"value\":\"5\"}"),
        ] {
            assert_eq!(both(&value), text);
            assert_eq!(read(text).as_ref(), Ok(&value));
            let only = exact(&value);
            assert!(!only.contains("\"value\""), "{only}");
            assert_eq!(read(&only), Ok(value));
        }
    }

    #[test]
    fn other_spellings_of_the_same_number_are_the_same() {
        assert_eq!(read("{\"value\":1,\"real32\":\"1.0\"}"), Ok(Value::Real32(1.0)));
        assert_eq!(
            read("{\"value\":0.10000000149011612,\"real64\":\"0.10000000149011612\"}"),
            Ok(Value::Real64(f64::from(0.1f32)))
        );
        assert_eq!(read("{\"unsigned\":5,\"value\":5.0}"), Ok(Value::Unsigned(5)));
    }

    #[test]
    fn two_truths_are_an_error() {
        for (text, message) in [
            (
                "{\"unsigned\":5,\"value\":6}",
                "`value` is `6`, but `unsigned` is `5`: change both, or remove `value`",
            ),
            (
                "{\"value\":true,\"text\":\"true\"}",
                "`value` is `true`, but `text` is `true`: change both, or remove `value`",
            ),
            ("{\"value\":6}", "the kind of the value is missing, such as `unsigned`"),
            ("{\"unsigned\":5,\"signed\":5}", "a value has one kind, not both `unsigned` and `signed`"),
            ("{\"unsigned\":5,\"unsigned\":5}", "the key `unsigned` is defined twice"),
            ("{\"value\":5,\"value\":5}", "the key `value` is defined twice"),
            ("{\"value\":[5]}", "invalid type: sequence, expected a number, a string, `true` or `false`"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
    }
}
