//! How values that JSON has no word for are written in it.

/// REAL numbers: as JSON numbers, and as the text of their bits where they are not finite.
pub(crate) mod real_text {
    use std::fmt::Display;
    use std::str::FromStr;

    use serde::{Deserialize, Deserializer, Serializer};

    /// Writes the shortest text that reads back to the same bits; a NaN with its payload as `0x…`.
    pub(crate) fn serialize<T: Real, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&value.to_text())
    }

    /// Reads what [`serialize`] wrote.
    pub(crate) fn deserialize<'de, T: Real, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
        let text = String::deserialize(deserializer)?;
        T::from_text(&text).ok_or_else(|| serde::de::Error::custom(format!("`{text}` is no REAL number")))
    }

    /// A REAL type that goes through text without a change of its bits.
    pub(crate) trait Real: Display + FromStr + Copy {
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
                        None => text.parse().ok(),
                    }
                }
            }
        };
    }
    real!(f32, u32);
    real!(f64, u64);
}

/// Bytes: as hex digits.
pub(crate) mod hex_text {
    use std::fmt::Write;

    use serde::{Deserialize, Deserializer, Serializer};

    /// Writes two upper-case digits a byte.
    pub(crate) fn serialize<S: Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
        let mut text = String::with_capacity(2 * bytes.len());
        for byte in bytes {
            let _ = write!(text, "{byte:02X}"); // a String takes every text
        }
        serializer.serialize_str(&text)
    }

    /// Reads what [`serialize`] wrote.
    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Box<[u8]>, D::Error> {
        let text = String::deserialize(deserializer)?;
        parse(&text)
            .ok_or_else(|| serde::de::Error::custom(format!("`{text}` is not made of pairs of hex digits")))
    }

    /// The bytes of a text of hex digits, two a byte.
    pub(crate) fn parse(text: &str) -> Option<Box<[u8]>> {
        let digit = |byte: u8| char::from(byte).to_digit(16);
        let pairs = text.as_bytes().chunks(2);
        pairs.map(|pair| u8::try_from(digit(pair[0])? << 4 | digit(*pair.get(1)?)?).ok()).collect()
    }
}

/// Objects by index: the indexes as `0x1018`.
pub(crate) mod index_keys {
    use std::collections::BTreeMap;

    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    /// Writes keys of four upper-case hex digits behind `0x`.
    pub(crate) fn serialize<T: Serialize, S: Serializer>(
        map: &BTreeMap<u16, T>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_map(map.iter().map(|(index, item)| (format!("0x{index:04X}"), item)))
    }

    /// Reads what [`serialize`] wrote.
    pub(crate) fn deserialize<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<BTreeMap<u16, T>, D::Error> {
        let index = |text: &str| u16::from_str_radix(text.strip_prefix("0x")?, 16).ok();
        let items = BTreeMap::<String, T>::deserialize(deserializer)?;
        items
            .into_iter()
            .map(|(key, item)| {
                let index = index(&key).ok_or_else(|| {
                    serde::de::Error::custom(format!("`{key}` is no index such as `0x1018`"))
                })?;
                Ok((index, item))
            })
            .collect()
    }
}
