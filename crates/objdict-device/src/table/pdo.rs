use super::{Typed, UNSIGNED64, number};

/// Shifts a value to its position in a frame: its lowest `bits` bits, 1 to 64, from bit `first` on.
#[must_use]
pub fn pack<T: Typed>(value: T::Value<'_>, first: u32, bits: u32) -> u64 {
    let number = T::with_bytes(value, 8, |bytes| number(UNSIGNED64, bytes));
    (number & (u64::MAX >> (64 - bits))) << first
}

/// Extracts a value from a frame, with sign extension.
#[must_use]
pub fn unpack<T: Typed + for<'a> Typed<Value<'a> = T>>(frame: u64, first: u32, bits: u32, signed: bool) -> T {
    let lowest = u64::MAX >> (64 - bits);
    let number = (frame >> first) & lowest;
    let negative = signed && number > lowest >> 1;
    T::load(&(if negative { number | !lowest } else { number }).to_le_bytes())
}

/// The first `N` bytes, padded with zeros.
#[must_use]
pub fn first<const N: usize>(bytes: &[u8]) -> [u8; N] {
    core::array::from_fn(|at| bytes.get(at).copied().unwrap_or(0))
}
