//! Times of entries, and their units.

use super::Wrong;
use crate::model::Device;
use crate::profile;
use objdict_model::literal::{nanoseconds, written_number};

/// A time in milliseconds: with a unit, or a plain number of milliseconds.
pub(super) fn milliseconds(text: &str) -> Option<u16> {
    let number = match nanoseconds(text) {
        Some(time) if time.is_multiple_of(1_000_000) => time / 1_000_000,
        Some(_) => return None,
        None => written_number(text.trim(), u16::MAX.into())?,
    };
    u16::try_from(number).ok()
}

/// Converts a time to the number in an entry, in the unit that the CiA documents of the device state
/// (1006h: 1 µs, 1017h: 1 ms, inhibit times: 100 µs).
pub(super) fn in_unit_of(
    device: &Device,
    (index, sub): (u16, u8),
    text: &str,
    time: u64,
) -> Result<u64, Wrong> {
    let unit = unit_of(device, index, sub);
    let length = unit.and_then(|unit| {
        let is_counted = unit.starts_with(|first: char| first.is_ascii_digit());
        nanoseconds(&if is_counted { unit.to_owned() } else { format!("1{unit}") })
    });
    match (length, unit) {
        (Some(length), _) if time.is_multiple_of(length) => Ok(time / length),
        (Some(_), Some(unit)) => {
            let wrong = Wrong::new(format!("`{text}` is not a multiple of the entry's unit, {unit}"));
            Err(wrong.help(format!("write a multiple, or a number in the unit {unit}")))
        }
        _ => {
            let wrong =
                Wrong::new(format!("`{text}` is a time, but no CiA document defines a time unit here"));
            Err(wrong.help("write a number in the unit of the device"))
        }
    }
}

/// The unit of an entry by the profile of the device or by the documents for all devices.
fn unit_of(device: &Device, index: u16, sub: u8) -> Option<&'static str> {
    profile::of_object(device, index).find_map(|(_, facts)| facts.entry(sub)?.unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_units() {
        let read = [("33ms", 33_000_000), ("1.5 s", 1_500_000_000), ("250us", 250_000), ("0.0005ms", 500)];
        for (text, time) in read {
            assert_eq!(nanoseconds(text), Some(time), "{text}");
        }
        for text in ["33", "ms", "-1ms", "+1ms", "1.ms", ".5s", "1e3ms", "0x10ms", "0.0000001us", "5 min"] {
            assert_eq!(nanoseconds(text), None, "{text}");
        }
        assert_eq!(["9", "1.5s", "0.5ms", "66s"].map(milliseconds), [Some(9), Some(1500), None, None]);
    }
}
