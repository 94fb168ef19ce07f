use super::{Entry, INTEGER64, Table, UNSIGNED64, number};

/// The type of an entry in the program: `u16`, `bool`, [`Time`], `[u8]` for a string, octet string or DOMAIN,
/// `[u8; N]` for a device-specific type.
pub trait Typed {
    /// A value.
    type Value<'a>: Copy;

    /// Whether the current length of a value precedes it.
    const HAS_LENGTH: bool = false;

    /// The value of these bytes, as transferred by an SDO. Numbers use the lowest bytes; shorter data is
    /// extended.
    fn load(bytes: &[u8]) -> Self::Value<'_>;

    /// The value of an entry in flash.
    fn load_constant<'a, D: Table>(entry: &'a Entry<D>, node_id: u8) -> Self::Value<'a>;

    /// Passes on the bytes of a value, of a number the lowest `size`.
    fn with_bytes<R>(value: Self::Value<'_>, size: usize, then: impl FnOnce(&[u8]) -> R) -> R;

    /// Whether the lowest `size` bytes can represent the value: an UNSIGNED24 is shorter than its `u32`.
    #[must_use]
    fn fits(value: Self::Value<'_>, size: usize) -> bool {
        let _ = (value, size);
        true
    }
}

macro_rules! numbers {
    ($($longest:ident: $($number:ty)*;)*) => {
        $($(impl Typed for $number {
            type Value<'a> = Self;

            fn load(bytes: &[u8]) -> Self {
                let extended = || number($longest, bytes) as Self;
                bytes.first_chunk().map_or_else(extended, |bytes| Self::from_le_bytes(*bytes))
            }

            fn load_constant<D: Table>(entry: &Entry<D>, node_id: u8) -> Self {
                Self::load(&entry.default_number(node_id).to_le_bytes())
            }

            #[inline]
            fn with_bytes<R>(value: Self, size: usize, then: impl FnOnce(&[u8]) -> R) -> R {
                let bytes = value.to_le_bytes();
                then(bytes.get(..size).unwrap_or(&bytes))
            }

            fn fits(value: Self, size: usize) -> bool {
                Self::with_bytes(value, size, |bytes| Self::load(bytes).to_le_bytes() == value.to_le_bytes())
            }
        })*)*
    };
}

numbers! {
    INTEGER64: i8 i16 i32 i64;
    UNSIGNED64: u8 u16 u32 u64 f32 f64;
}

impl Typed for bool {
    type Value<'a> = Self;

    fn load(bytes: &[u8]) -> Self {
        bytes.first().is_some_and(|&byte| byte != 0)
    }

    fn load_constant<D: Table>(entry: &Entry<D>, _: u8) -> Self {
        Self::load(entry.default_bytes())
    }

    #[inline]
    fn with_bytes<R>(value: Self, _: usize, then: impl FnOnce(&[u8]) -> R) -> R {
        then(&[u8::from(value)])
    }
}

/// A time of day since 1984-01-01, or a time difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Time {
    /// Milliseconds after midnight, 28 bits.
    pub milliseconds: u32,
    /// Days.
    pub days: u16,
}

impl Time {
    /// The used bits of the byte with the highest bits of the milliseconds.
    pub(super) const USED: u8 = 0x0F;

    /// The time of six bytes.
    pub(super) const fn from_number(number: u64) -> Self {
        Self { milliseconds: number as u32 & 0x0FFF_FFFF, days: (number >> 32) as u16 }
    }
}

impl Typed for Time {
    type Value<'a> = Self;

    fn load(bytes: &[u8]) -> Self {
        Self::from_number(number(UNSIGNED64, bytes))
    }

    fn load_constant<D: Table>(entry: &Entry<D>, _: u8) -> Self {
        Self::load(entry.default_bytes())
    }

    #[inline]
    fn with_bytes<R>(value: Self, _: usize, then: impl FnOnce(&[u8]) -> R) -> R {
        let [a, b, c, d] = value.milliseconds.to_le_bytes();
        let [e, f] = value.days.to_le_bytes();
        then(&[a, b, c, d & Self::USED, e, f])
    }
}

impl Typed for [u8] {
    type Value<'a> = &'a Self;

    const HAS_LENGTH: bool = true;

    fn load(bytes: &[u8]) -> &[u8] {
        bytes
    }

    fn load_constant<D: Table>(entry: &Entry<D>, _: u8) -> &Self {
        entry.default_bytes()
    }

    #[inline]
    fn with_bytes<R>(value: &Self, _: usize, then: impl FnOnce(&[u8]) -> R) -> R {
        then(value)
    }
}

impl<const N: usize> Typed for [u8; N] {
    type Value<'a> = Self;

    fn load(bytes: &[u8]) -> Self {
        bytes.first_chunk().copied().unwrap_or([0; N])
    }

    fn load_constant<D: Table>(entry: &Entry<D>, _: u8) -> Self {
        Self::load(entry.default_bytes())
    }

    #[inline]
    fn with_bytes<R>(value: Self, _: usize, then: impl FnOnce(&[u8]) -> R) -> R {
        then(&value)
    }
}
