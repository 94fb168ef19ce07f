//! Times with units.

/// The units of a time with their lengths in nanoseconds; longer words first.
const UNITS: [(&str, u64); 5] =
    [("ms", 1_000_000), ("µs", 1000), ("μs", 1000), ("us", 1000), ("s", 1_000_000_000)];

/// Decimal places of a second in nanoseconds.
const PLACES: usize = 9;

/// A time such as `33ms`, `1.5 s` or `250us`, in nanoseconds; `None` for any other text.
pub fn nanoseconds(text: &str) -> Option<u64> {
    let text = text.trim();
    let (number, unit) =
        UNITS.iter().find_map(|&(word, length)| Some((text.strip_suffix(word)?.trim_end(), length)))?;
    let (whole, fraction) = number.split_once('.').unwrap_or((number, "0"));
    let are_digits = [whole, fraction]
        .iter()
        .all(|digits| !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit()));
    if !are_digits || fraction.len() > PLACES {
        return None;
    }
    let fraction: u64 = format!("{fraction:0<PLACES$}").parse().ok()?;
    let scaled = u128::from(fraction) * u128::from(unit);
    let scale = 10_u128.pow(9);
    if !scaled.is_multiple_of(scale) {
        return None;
    }
    whole.parse::<u64>().ok()?.checked_mul(unit)?.checked_add(u64::try_from(scaled / scale).ok()?)
}
