//! Prints values in the spelling that most readers accept, and times with units.

use std::fmt::Display;

use crate::model::{Value, hex};

/// The spelling of REAL numbers. No spelling suits all readers: CiA 306-1 does not define one, some readers
/// interpret a hex number as bits, others accept only decimals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RealSpelling {
    /// `1.5`: accepted by most readers, such as python-canopen. Non-finite numbers are written as their bits.
    #[default]
    Decimal,
    /// `0x3FC00000`: the bits of IEEE 754, as the tools of lely-core read it.
    Hex,
}

/// The spelling of values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spelling {
    /// REAL numbers.
    pub real: RealSpelling,
    /// Whether all strings are quoted; otherwise only those that would be misread without quotes.
    pub quote_strings: bool,
    /// Whether UNSIGNED32 is written in hex, as in communication objects; otherwise in decimal, like all
    /// other integers.
    pub hex: bool,
}

/// The text of a value, which [`value`](super::value) parses back to an equal value.
pub fn print(value: &Value, spelling: Spelling) -> String {
    match value {
        Value::Boolean(value) => u8::from(*value).to_string(),
        Value::Signed(value) => value.to_string(),
        Value::Unsigned(value) if spelling.hex => format!("0x{value:08X}"),
        Value::Unsigned(value) => value.to_string(),
        Value::Real32(value) => {
            let bits = format_args!("0x{:08X}", value.to_bits()).to_string();
            real(spelling, value.is_finite(), format_args!("{value:?}"), bits)
        }
        Value::Real64(value) => {
            let bits = format_args!("0x{:016X}", value.to_bits()).to_string();
            real(spelling, value.is_finite(), format_args!("{value:?}"), bits)
        }
        Value::Text(text) if spelling.quote_strings || needs_quotes(text) => format!("\"{text}\""),
        Value::Text(text) | Value::Raw(text) => text.to_string(),
        // an empty string would mean a missing value
        Value::Bytes(bytes) if bytes.is_empty() => "0x".to_owned(),
        Value::Bytes(bytes) => hex::print(bytes),
        Value::Time(time) => format!("{} {}", time.days, time.milliseconds),
        // also for 0: python-canopen cannot read a plain `$NODEID`
        Value::NodeId(offset) => format!("$NODEID+0x{offset:X}"),
    }
}

fn real(spelling: Spelling, is_finite: bool, decimal: impl Display, bits: String) -> String {
    match spelling.real {
        RealSpelling::Decimal if is_finite => decimal.to_string(),
        _ => bits,
    }
}

/// Whether a reader would ignore the text, trim its spaces, or remove quotes that belong to it.
fn needs_quotes(text: &str) -> bool {
    let quoted = text.len() > 1 && text.starts_with('"') && text.ends_with('"');
    text.is_empty() || text.trim_matches([' ', '\t']) != text || quoted
}

/// The units of a time with their lengths in nanoseconds; longer names first.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::literal::{Quirks, value};
    use crate::model::{DataType, Time};

    const HEX: Spelling = Spelling { real: RealSpelling::Hex, quote_strings: false, hex: true };

    #[test]
    fn the_canonical_spelling() {
        let plain = |value: Value| print(&value, Spelling::default());
        assert_eq!(plain(Value::Unsigned(10)), "10");
        assert_eq!(print(&Value::Unsigned(0x80), HEX), "0x00000080");
        assert_eq!(plain(Value::Signed(-2)), "-2");
        assert_eq!(plain(Value::Boolean(true)), "1");
        assert_eq!(plain(Value::Real32(0.1)), "0.1");
        assert_eq!(plain(Value::Real64(-0.0)), "-0.0");
        assert_eq!(plain(Value::Real32(f32::NAN)), "0x7FC00000");
        assert_eq!(print(&Value::Real64(1.0), HEX), "0x3FF0000000000000");
        assert_eq!(plain(Value::Bytes([1, 0xA1].into())), "01A1");
        assert_eq!(plain(Value::Time(Time { days: 2, milliseconds: 1000 })), "2 1000");
        assert_eq!(plain(Value::NodeId(0x180)), "$NODEID+0x180");
        assert_eq!(plain(Value::NodeId(0)), "$NODEID+0x0");
    }

    #[test]
    fn strings_stand_in_quotes_where_they_must() {
        let quoting = Spelling { quote_strings: true, ..Spelling::default() };
        for (text, plain) in [
            ("a b", "a b"),
            ("", "\"\""),
            (" a", "\" a\""),
            ("\"a\"", "\"\"a\"\""),
            ("\"", "\""),
            ("\"a", "\"a"),
            ("a;b #c", "a;b #c"),
        ] {
            let text = Value::Text(text.into());
            assert_eq!(print(&text, Spelling::default()), plain);
            for spelling in [Spelling::default(), quoting] {
                let read =
                    value(&print(&text, spelling), Some(DataType::VISIBLE_STRING), &mut Quirks::default());
                assert_eq!(read, Ok(text.clone()));
            }
        }
    }
}
