//! Texts that are not valid values of their field, but whose intended value is clear.

use crate::diagnostic::{Fix, say};
use crate::model::{Access, ClockTime, DataType, Date, Field, InvalidValue, ObjectType, Place, Reason};

/// The fix of an invalid value at `place`, if the intended value is clear.
pub(crate) fn respell(invalid: &InvalidValue, data_type: Option<DataType>, place: Place) -> Option<Fix> {
    let text = invalid.text.trim();
    let safe = |value: String| (Fix::safe(say!("write `{}`", value)), value);
    let risky = |value: String| (Fix::risky(say!("write `{}`", value)), value);
    let (fix, value) = match (&invalid.field, &invalid.reason) {
        (Field::AccessType, _) => {
            let letters: String = text.chars().filter(char::is_ascii_alphabetic).collect();
            match Access::from_name(&letters) {
                Some(access) => safe(access.name().to_owned()),
                None => risky(nearest_access(text)?.name().to_owned()),
            }
        }
        (Field::ObjectType, _) => safe(format!("0x{:X}", object_type(text)?.code())),
        (Field::PdoMapping, _) => safe(flag(text)?.to_owned()),
        (_, Reason::NotADate) => safe(date(text)?.to_string()),
        (_, Reason::NotAClockTime) => safe(clock_time(text)?.to_string()),
        // a number with a digit 8 or 9 cannot be octal, so it is decimal
        (_, Reason::NotOctal) => safe(without_zeros(text)?),
        (_, Reason::NotANumber) if is_hex(text) && data_type.is_none() => risky(format!("0x{text}")),
        _ => return None,
    };
    Some(fix.set(place, value))
}

/// The probable access type of a text that is not a valid one.
pub(crate) fn nearest_access(text: &str) -> Option<Access> {
    let letters: String = text.chars().filter(char::is_ascii_alphabetic).collect();
    Access::from_name(&letters).or(match letters.to_ascii_lowercase().as_str() {
        "r" | "read" | "readonly" => Some(Access::Ro),
        "w" | "write" | "writeonly" => Some(Access::Wo),
        "readwrite" | "wr" => Some(Access::Rw),
        "c" | "cons" | "constant" => Some(Access::Const),
        _ => None,
    })
}

fn object_type(text: &str) -> Option<ObjectType> {
    let code = (0..=9).filter_map(ObjectType::from_code);
    code.into_iter().find(|object_type| object_type.name().eq_ignore_ascii_case(text))
}

fn flag(text: &str) -> Option<&'static str> {
    match text.to_ascii_lowercase().as_str() {
        "true" | "yes" => Some("1"),
        "false" | "no" => Some("0"),
        _ => None,
    }
}

/// A date in another form whose day and month are unambiguous: in the order of the standard, with dots and
/// the day first, with the year first, or with a day above 12.
fn date(text: &str) -> Option<Date> {
    let separator = ['-', '/', '.'].into_iter().find(|separator| text.contains(*separator))?;
    let parts: Vec<&str> = text.split(separator).map(str::trim).collect();
    let [first, second, third] = parts[..] else { return None };
    let number = |text: &str| text.parse::<u16>().ok().filter(|_| (1..=2).contains(&text.len()));
    let of = |year: &str, month: u16, day: u16| {
        let year = year.parse().ok().filter(|_| year.len() == 4)?;
        Date::new(year, u8::try_from(month).ok()?, u8::try_from(day).ok()?)
    };
    if first.len() == 4 {
        return of(first, number(second)?, number(third)?);
    }
    let (first, second) = (number(first)?, number(second)?);
    match separator {
        '.' => of(third, second, first),
        '-' if first <= 12 => of(third, first, second),
        _ if first > 12 => of(third, second, first),
        _ if second > 12 => of(third, first, second),
        _ => None,
    }
}

/// A time with single digits, blanks or lower-case letters, or in 24-hour form.
fn clock_time(text: &str) -> Option<ClockTime> {
    let lower = text.to_ascii_lowercase();
    let (digits, half) = match (lower.strip_suffix("am"), lower.strip_suffix("pm")) {
        (Some(digits), _) => (digits, Some(0)),
        (_, Some(digits)) => (digits, Some(12)),
        _ => (lower.as_str(), None),
    };
    let (hour, minute) = digits.trim().split_once(':')?;
    let (hour, minute): (u8, u8) = (hour.parse().ok()?, minute.parse().ok()?);
    match half {
        Some(half) if (1..=12).contains(&hour) => ClockTime::new(hour % 12 + half, minute),
        // 13:05PM is not a 12-hour time, but its meaning is unambiguous
        Some(12) if hour > 12 => ClockTime::new(hour, minute),
        None => ClockTime::new(hour, minute),
        Some(_) => None,
    }
}

fn without_zeros(text: &str) -> Option<String> {
    let (sign, digits) = text.strip_prefix('-').map_or(("", text), |digits| ("-", digits));
    let is_decimal = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_decimal.then(|| format!("{sign}{}", digits.trim_start_matches('0')))
}

/// Whether a text is a hexadecimal number without `0x`.
fn is_hex(text: &str) -> bool {
    (1..=8).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_that_can_only_be_one_day() {
        let read = |text| date(text).map(|date| date.to_string());
        for (text, expected) in [
            ("1-5-2020", Some("01-05-2020")),
            ("31-01-2020", Some("01-31-2020")),
            ("2020-01-31", Some("01-31-2020")),
            ("31.01.2020", Some("01-31-2020")),
            ("1.2.2020", Some("02-01-2020")),
            ("1/31/2020", Some("01-31-2020")),
            ("31/1/2020", Some("01-31-2020")),
            ("1/2/2020", None),
            ("01-31-20", None),
            ("31-31-2020", None),
            ("yesterday", None),
        ] {
            assert_eq!(read(text).as_deref(), expected, "{text}");
        }
    }

    #[test]
    fn times_in_other_forms() {
        let read = |text| clock_time(text).map(|time| time.to_string());
        for (text, expected) in [
            ("9:45AM", Some("09:45AM")),
            ("09:45 pm", Some("09:45PM")),
            ("14:30", Some("02:30PM")),
            ("00:10", Some("12:10AM")),
            ("13:05PM", Some("01:05PM")),
            ("13:05AM", None),
            ("9.45", None),
            ("09:45:10AM", None),
        ] {
            assert_eq!(read(text).as_deref(), expected, "{text}");
        }
    }
}
