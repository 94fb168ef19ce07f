//! TOML values of the keys in profiles.

use std::fmt;
use std::ops::RangeInclusive;

use serde::Deserialize;
use serde::de::{self, Deserializer, MapAccess, SeqAccess, Visitor};

use crate::model::{Access, DataType, ObjectType};
use crate::{Condition, Confidence, Mapping};

/// A decimal number, or a hexadecimal one after `0x`.
pub(super) fn number(text: &str) -> Option<u64> {
    match text.strip_prefix("0x") {
        Some(digits) => u64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}

/// One item or a list of them.
struct OneOrMany<T>(Vec<T>);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for OneOrMany<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ItemsVisitor<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for ItemsVisitor<T> {
            type Value = OneOrMany<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a name or a list of names")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                T::deserialize(de::value::StrDeserializer::new(text)).map(|item| OneOrMany(vec![item]))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Self::Value, A::Error> {
                let mut all = Vec::new();
                while let Some(item) = items.next_element()? {
                    all.push(item);
                }
                Ok(OneOrMany(all))
            }
        }
        deserializer.deserialize_any(ItemsVisitor(std::marker::PhantomData))
    }
}

/// A keyword for a value.
struct Named<T>(T);

/// Types with keywords in profiles.
pub(super) trait Word: Sized {
    const EXPECTED: &'static str;
    fn of(word: &str) -> Option<Self>;
}

/// Types with the expected keywords, and their values.
macro_rules! keywords {
    ($($Type:ty, $expected:literal: |$word:ident| $meaning:expr;)+) => {$(
        impl Word for $Type {
            const EXPECTED: &'static str = $expected;
            fn of($word: &str) -> Option<Self> {
                $meaning
            }
        }
    )+};
}

keywords! {
    ObjectType, "`VAR`, `ARRAY`, `RECORD` or `DOMAIN`": |word| {
        let types = [Self::Var, Self::Array, Self::Record, Self::Domain, Self::DefType, Self::DefStruct];
        types.into_iter().find(|object_type| object_type.name() == word)
    };
    DataType, "a data type of CiA 301 such as `UNSIGNED8`": |word| Self::from_name(word);
    Access, "`ro`, `wo`, `rw`, `rwr`, `rww` or `const`": |word| Self::from_name(word);
    Mapping, "`no`, `tpdo`, `rpdo` or `any`":
        |word| [Self::No, Self::Tpdo, Self::Rpdo, Self::Any].into_iter().find(|mapping| mapping.name() == word);
    Confidence, "`high` or `medium`": |word| match word {
        "high" => Some(Self::High),
        "medium" => Some(Self::Medium),
        _ => None,
    };
}

impl<'de, T: Word> Deserialize<'de> for Named<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let word = String::deserialize(deserializer)?;
        let unknown = || de::Error::custom(format_args!("`{word}` is unknown, expected {}", T::EXPECTED));
        T::of(&word).map(Self).ok_or_else(unknown)
    }
}

/// One keyword or a list of them.
pub(super) fn words<'de, D: Deserializer<'de>, T: Word>(deserializer: D) -> Result<Vec<T>, D::Error> {
    let words = OneOrMany::<Named<T>>::deserialize(deserializer)?;
    Ok(words.0.into_iter().map(|word| word.0).collect())
}

/// A keyword.
pub(super) fn word<'de, D: Deserializer<'de>, T: Word>(deserializer: D) -> Result<Option<T>, D::Error> {
    Named::deserialize(deserializer).map(|word| Some(word.0))
}

/// `"mandatory"`, `"optional"`, or the condition under which it is mandatory.
pub(super) enum NeedText {
    Optional,
    Mandatory,
    When(Condition),
}

impl<'de> Deserialize<'de> for NeedText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Ok(match text.as_str() {
            "mandatory" => Self::Mandatory,
            "optional" => Self::Optional,
            condition => match condition.strip_prefix("if ") {
                Some(condition) => Self::When(condition.parse().map_err(de::Error::custom)?),
                None => {
                    return Err(de::Error::custom(format_args!(
                        "`{condition}` is unknown, expected `mandatory`, `optional` or `if` with a condition"
                    )));
                }
            },
        })
    }
}

/// A condition.
pub(super) struct ConditionText(pub Condition);

impl<'de> Deserialize<'de> for ConditionText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.strip_prefix("if ").unwrap_or(&text).parse().map(Self).map_err(de::Error::custom)
    }
}

/// Numbers, and pairs of a minimum and a maximum.
pub(super) fn ranges<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Vec<RangeInclusive<i128>>, D::Error> {
    let ranges: Vec<NumberOrPair> = Vec::deserialize(deserializer)?;
    Ok(ranges.into_iter().map(|range| range.0).collect())
}

/// A range of bits, lowest first.
pub(super) struct BitRange(pub RangeInclusive<u8>);

impl<'de> Deserialize<'de> for BitRange {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let range = NumberOrPair::deserialize(deserializer)?.0;
        let bit = |number: &i128| u8::try_from(*number).ok().filter(|bit| *bit < 64);
        match (bit(range.start()), bit(range.end())) {
            (Some(first), Some(last)) => Ok(Self(first..=last)),
            _ => Err(de::Error::custom("bits must be from 0 to 63")),
        }
    }
}

/// `5` or `[1, 5]`.
pub(super) struct NumberOrPair(pub RangeInclusive<i128>);

impl<'de> Deserialize<'de> for NumberOrPair {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Numbers;
        impl<'de> Visitor<'de> for Numbers {
            type Value = NumberOrPair;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or a minimum and a maximum such as `[1, 5]`")
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Self::Value, E> {
                let number = i128::from(number);
                Ok(NumberOrPair(number..=number))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Self::Value, A::Error> {
                let first: Option<i64> = items.next_element()?;
                let last: Option<i64> = items.next_element()?;
                match (first, last, items.next_element::<i64>()?) {
                    (Some(first), Some(last), None) if first <= last => {
                        Ok(NumberOrPair(i128::from(first)..=i128::from(last)))
                    }
                    _ => Err(de::Error::custom("expected a minimum and a maximum such as `[1, 5]`")),
                }
            }
        }
        deserializer.deserialize_any(Numbers)
    }
}

/// Meanings of a bit field's values: `{ 0 = "…", "1..3" = "…" }`.
#[derive(Default)]
pub(super) struct ValueMeanings(pub Vec<(RangeInclusive<u64>, String)>);

impl<'de> Deserialize<'de> for ValueMeanings {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct TableVisitor;
        impl<'de> Visitor<'de> for TableVisitor {
            type Value = ValueMeanings;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a table of values and their meanings such as `{ 0 = \"off\", 1 = \"on\" }`")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut items: A) -> Result<Self::Value, A::Error> {
                let mut all = Vec::new();
                while let Some((key, meaning)) = items.next_entry::<String, String>()? {
                    let (first, last) = key.split_once("..").unwrap_or((&key, &key));
                    match (number(first), number(last)) {
                        (Some(first), Some(last)) => all.push((first..=last, meaning)),
                        _ => return Err(de::Error::custom(format_args!("`{key}` is not a number"))),
                    }
                }
                all.sort_by_key(|(range, _)| *range.start());
                Ok(ValueMeanings(all))
            }
        }
        deserializer.deserialize_map(TableVisitor)
    }
}
