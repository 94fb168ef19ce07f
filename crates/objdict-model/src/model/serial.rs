//! The JSON representation of values that JSON has no type for: indexes and sub-indexes in hex, bytes as hex
//! digits, REAL numbers with exact bits, maps with unique keys.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::marker::PhantomData;

use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Whether a value is the default and can be omitted.
pub(crate) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// A number with a fixed number of hex digits after `0x`.
pub trait Hex: Copy + Ord + fmt::UpperHex + TryFrom<u32> {
    /// The name in error messages.
    const WHAT: &'static str;
    const DIGITS: usize;
}

impl Hex for u16 {
    const WHAT: &'static str = "index such as `0x1018`";
    const DIGITS: usize = 4;
}

impl Hex for u8 {
    const WHAT: &'static str = "sub-index such as `0x0A`";
    const DIGITS: usize = 2;
}

/// An index (`u16`) or sub-index (`u8`) as a string.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct HexText<T>(pub T);

impl<T: Hex> HexText<T> {
    /// Parses a string such as `0x1018`.
    pub(crate) fn parse(text: &str) -> Option<T> {
        let digits = text.strip_prefix("0x")?;
        let number =
            digits.bytes().all(|byte| byte.is_ascii_hexdigit()).then(|| u32::from_str_radix(digits, 16));
        T::try_from(number?.ok()?).ok()
    }
}

impl<T: Hex> fmt::Display for HexText<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "0x{:0digits$X}", self.0, digits = T::DIGITS)
    }
}

impl<T: Hex> Serialize for HexText<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de, T: Hex> Deserialize<'de> for HexText<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let number = Self::parse(&text).map(Self);
        number.ok_or_else(|| D::Error::custom(format!("`{text}` is not a valid {}", T::WHAT)))
    }
}

/// One index or sub-index.
pub mod hex_number {
    use super::{Deserialize, Deserializer, Hex, HexText, Serialize, Serializer};

    /// Writes `0x1018` or `0x0A`.
    pub fn serialize<T: Hex, S: Serializer>(number: &T, serializer: S) -> Result<S::Ok, S::Error> {
        HexText(*number).serialize(serializer)
    }

    /// Reads the output of [`serialize`].
    pub fn deserialize<'de, T: Hex, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
        HexText::deserialize(deserializer).map(|HexText(number)| number)
    }
}

/// A list of indexes, optional or not, or the two limits of a range.
pub(crate) mod index_list {
    use super::{Deserialize, Deserializer, HexText, Serializer};

    /// Types that are a list of indexes in JSON.
    pub(crate) trait List: Sized {
        fn indexes(&self) -> Option<impl Iterator<Item = u16>>;
        fn from_indexes(indexes: Option<Vec<u16>>) -> Result<Self, &'static str>;
    }

    impl List for Vec<u16> {
        fn indexes(&self) -> Option<impl Iterator<Item = u16>> {
            Some(self.iter().copied())
        }

        fn from_indexes(indexes: Option<Vec<u16>>) -> Result<Self, &'static str> {
            Ok(indexes.unwrap_or_default())
        }
    }

    impl List for Option<Vec<u16>> {
        fn indexes(&self) -> Option<impl Iterator<Item = u16>> {
            self.as_ref().map(|indexes| indexes.iter().copied())
        }

        fn from_indexes(indexes: Option<Vec<u16>>) -> Result<Self, &'static str> {
            Ok(indexes)
        }
    }

    impl List for Option<(u16, u16)> {
        fn indexes(&self) -> Option<impl Iterator<Item = u16>> {
            self.map(|(first, last)| [first, last].into_iter())
        }

        fn from_indexes(indexes: Option<Vec<u16>>) -> Result<Self, &'static str> {
            match indexes.as_deref() {
                None => Ok(None),
                Some(&[first, last]) => Ok(Some((first, last))),
                Some(_) => Err("a range has a first and a last index"),
            }
        }
    }

    /// Writes a list of strings such as `0x1018`.
    pub(crate) fn serialize<T: List, S: Serializer>(list: &T, serializer: S) -> Result<S::Ok, S::Error> {
        match list.indexes() {
            Some(indexes) => serializer.collect_seq(indexes.map(HexText)),
            None => serializer.serialize_none(),
        }
    }

    /// Reads the output of [`serialize`].
    pub(crate) fn deserialize<'de, T: List, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
        let indexes = Option::<Vec<HexText<u16>>>::deserialize(deserializer)?;
        let indexes = indexes.map(|indexes| indexes.into_iter().map(|HexText(index)| index).collect());
        T::from_indexes(indexes).map_err(serde::de::Error::custom)
    }
}

/// Objects by index: unique keys such as `0x1018`.
pub(crate) mod index_keys {
    use super::{Deserialize, Deserializer, HexText, Serialize, Serializer};

    /// Writes an object with keys of four upper-case hex digits after `0x`.
    pub(crate) fn serialize<'a, T: Serialize + 'a, S: Serializer>(
        map: impl IntoIterator<Item = (&'a u16, &'a T)>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_map(map.into_iter().map(|(&index, item)| (HexText(index), item)))
    }

    /// Reads the output of [`serialize`].
    pub(crate) fn deserialize<'de, T: Deserialize<'de>, D: Deserializer<'de>, M: FromIterator<(u16, T)>>(
        deserializer: D,
    ) -> Result<M, D::Error> {
        let items = super::unique_keys::pairs::<HexText<u16>, T, D>(deserializer)?;
        Ok(items.into_iter().map(|(HexText(index), item)| (index, item)).collect())
    }
}

/// Maps with unique keys: otherwise the second value would silently win.
pub mod unique_keys {
    use super::{
        BTreeMap, BTreeSet, Deserialize, Deserializer, Error, MapAccess, PhantomData, Serialize, Serializer,
        Visitor, fmt,
    };

    /// Writes a map unchanged.
    pub fn serialize<K: Serialize, T: Serialize, S: Serializer>(
        map: &BTreeMap<K, T>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_map(map)
    }

    /// Reads a map; a repeated key is an error.
    pub fn deserialize<'de, K, T, D>(deserializer: D) -> Result<BTreeMap<K, T>, D::Error>
    where
        K: Deserialize<'de> + Ord + Clone + fmt::Display,
        T: Deserialize<'de>,
        D: Deserializer<'de>,
    {
        pairs(deserializer).map(BTreeMap::from_iter)
    }

    /// Reads the keys and values of a map in the order of the file; a repeated key is an error.
    pub fn pairs<'de, K, T, D>(deserializer: D) -> Result<Vec<(K, T)>, D::Error>
    where
        K: Deserialize<'de> + Ord + Clone + fmt::Display,
        T: Deserialize<'de>,
        D: Deserializer<'de>,
    {
        deserializer.deserialize_map(Unique(PhantomData))
    }

    struct Unique<K, T>(PhantomData<(K, T)>);

    impl<'de, K: Deserialize<'de> + Ord + Clone + fmt::Display, T: Deserialize<'de>> Visitor<'de>
        for Unique<K, T>
    {
        type Value = Vec<(K, T)>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a map")
        }

        fn visit_map<A: MapAccess<'de>>(self, mut access: A) -> Result<Self::Value, A::Error> {
            let (mut seen, mut pairs) = (BTreeSet::new(), Vec::new());
            while let Some(key) = access.next_key::<K>()? {
                if !seen.insert(key.clone()) {
                    return Err(A::Error::custom(format!("the key `{key}` is defined twice")));
                }
                pairs.push((key, access.next_value()?));
            }
            Ok(pairs)
        }
    }
}

/// Items of single sub-indexes in the order of the file: unique keys such as `0x0A`.
pub(crate) mod sub_list {
    use super::{Deserialize, Deserializer, HexText, Serialize, Serializer};

    /// Writes an object with keys of two upper-case hex digits after `0x`.
    pub(crate) fn serialize<T: Serialize, S: Serializer>(
        list: &[(u8, T)],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_map(list.iter().map(|(sub, item)| (HexText(*sub), item)))
    }

    /// Reads the output of [`serialize`].
    pub(crate) fn deserialize<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<(u8, T)>, D::Error> {
        let items = super::unique_keys::pairs::<HexText<u8>, T, D>(deserializer)?;
        Ok(items.into_iter().map(|(HexText(sub), item)| (sub, item)).collect())
    }
}

/// REAL numbers: the shortest decimal string with the same bits, or the bits themselves if not finite.
pub(crate) mod real_text {
    use std::fmt::Debug;
    use std::str::FromStr;

    use super::{Deserialize, Deserializer, Error, Serializer};

    /// Writes `1.5`, or the bits as `0x7FC00000`.
    pub(crate) fn serialize<T: Real, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&value.to_text())
    }

    /// Reads the output of [`serialize`].
    pub(crate) fn deserialize<'de, T: Real, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
        let text = String::deserialize(deserializer)?;
        T::from_text(&text).ok_or_else(|| D::Error::custom(format!("`{text}` is not a REAL number")))
    }

    /// A REAL type whose conversion to a string and back preserves the bits.
    pub(crate) trait Real: Debug + FromStr + Copy {
        fn to_text(self) -> String;
        fn from_text(text: &str) -> Option<Self>;
    }

    macro_rules! real {
        ($type:ty, $bits:ty) => {
            impl Real for $type {
                fn to_text(self) -> String {
                    if self.is_finite() { format!("{self:?}") } else { format!("0x{:X}", self.to_bits()) }
                }

                fn from_text(text: &str) -> Option<Self> {
                    match text.strip_prefix("0x") {
                        Some(hex) => <$bits>::from_str_radix(hex, 16).ok().map(Self::from_bits),
                        // a number too large for the type would become infinite
                        None => text.parse().ok().filter(|value: &$type| value.is_finite()),
                    }
                }
            }
        };
    }
    real!(f32, u32);
    real!(f64, u64);
}

/// Bytes as hex digits.
pub mod hex_text {

    use super::super::hex;
    use super::{Deserialize, Deserializer, Error, Serializer};

    /// Writes two upper-case digits per byte.
    pub fn serialize<S: Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&hex::print(bytes))
    }

    /// Reads the output of [`serialize`].
    pub fn deserialize<'de, T: From<Box<[u8]>>, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<T, D::Error> {
        let text = String::deserialize(deserializer)?;
        let bytes = hex::parse(&text);
        let bytes =
            bytes.ok_or_else(|| D::Error::custom(format!("`{text}` is not a sequence of hex digit pairs")));
        bytes.map(T::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_index(text: &str) -> Result<u16, String> {
        let mut json = serde_json::Deserializer::from_str(text);
        hex_number::deserialize(&mut json).map_err(|error| error.to_string())
    }

    #[test]
    fn indexes_are_hex_texts() {
        assert_eq!(read_index("\"0x1018\""), Ok(0x1018));
        assert_eq!(read_index("\"0xa0\""), Ok(0xA0));
        for text in ["\"1018\"", "\"0x\"", "\"0x+10\"", "\"0x10000\"", "\"0x \"", "\"-0x1\""] {
            let error = read_index(text).unwrap_err();
            assert!(
                error.starts_with(&text.replace('"', "`")) && error.contains("is not a valid index"),
                "{error}"
            );
        }
    }

    #[test]
    fn a_repeated_key_is_an_error_in_any_spelling() {
        let mut json = serde_json::Deserializer::from_str("{\"0x00A0\": 1, \"0xa0\": 2}");
        let map: Result<BTreeMap<u16, u8>, _> = index_keys::deserialize(&mut json);
        assert!(map.unwrap_err().to_string().starts_with("the key `0x00A0` is defined twice"));
    }
}
