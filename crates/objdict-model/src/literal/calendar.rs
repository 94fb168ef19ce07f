//! Dates and times of day, in the spellings of real files.

use crate::model::{ClockTime, Date};

/// A date in any order and with month names: `01-31-2026`, `2026-01-31`, `31.01.2026`, `31/1/26`, `31-Jan-2026`. The
/// second value is whether the date is unambiguous. An ambiguous date is read in the order of an EDS, month first.
pub fn date(text: &str) -> Option<(Date, bool)> {
    if let Some(date) = text.get(..10).and_then(Date::from_iso).filter(|_| is_zone(&text[10..])) {
        return Some((date, true));
    }
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let [first, second, third] = words.collect::<Vec<_>>()[..] else { return None };
    let (year, front, back) = match first.len() {
        4 => (first, second, third),
        _ => (third, first, second),
    };
    let is_short = year.len() == 2;
    let year = year_of(year)?;
    if let Some(named) = month(front).zip(number(back)).or_else(|| month(back).zip(number(front))) {
        return Some((Date::new(year, named.0, named.1)?, !is_short));
    }
    let (front, back) = (number(front)?, number(back)?);
    let (month_first, day_first) = (Date::new(year, front, back), Date::new(year, back, front));
    match () {
        () if first.len() == 4 => Some((month_first?, true)),
        () if text.contains('.') => Some((day_first?, !is_short)),
        // the order of the standard, or an equivalent one
        () if month_first.is_none() || day_first.is_none() || front == back || text.contains('-') => {
            Some((month_first.or(day_first)?, !is_short))
        }
        () => Some((month_first?, false)),
    }
}

/// A time of day in 12-hour or 24-hour notation, with or without seconds: `09:45AM`, `9:45 pm`, `21:45`, `21:45:10`,
/// or ISO 8601.
pub fn clock_time(text: &str) -> Option<ClockTime> {
    if let Some(time) = ClockTime::from_iso(text) {
        return Some(time);
    }
    let lower = text.to_ascii_lowercase();
    let (clock, half) = match (lower.strip_suffix("am"), lower.strip_suffix("pm")) {
        (Some(clock), _) => (clock, Some(0)),
        (_, Some(clock)) => (clock, Some(12)),
        _ => (lower.as_str(), None),
    };
    let mut parts = clock.trim().split(':').map(number);
    let (hour, minute) = (parts.next()??, parts.next()??);
    let second = parts.next().map_or(Some(0), |second| second.filter(|second| *second < 60))?;
    let hour = match half {
        Some(half) if (1..=12).contains(&hour) => hour % 12 + half,
        // `13:05PM` and `00:05AM` are not valid 12-hour times, but unambiguous
        Some(12) if hour > 12 => hour,
        Some(0) if hour == 0 => hour,
        Some(_) => return None,
        None => hour,
    };
    let time = ClockTime { second, ..ClockTime::new(hour, minute)? };
    parts.next().is_none().then_some(time)
}

/// Whether the text after a date is empty or an XML Schema time zone, which does not affect the day.
fn is_zone(text: &str) -> bool {
    let is_offset = text.len() == 6 && text.starts_with(['+', '-']) && text.as_bytes()[3] == b':';
    matches!(text, "" | "Z") || is_offset
}

/// A number of one or two digits.
fn number(text: &str) -> Option<u8> {
    let is_number = (1..=2).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    if is_number { text.parse().ok() } else { None }
}

/// A year of four digits, or of two: CANopen dates from the 1990s.
fn year_of(text: &str) -> Option<u16> {
    match (text.len(), text.bytes().all(|byte| byte.is_ascii_digit())) {
        (4, true) => text.parse().ok(),
        (2, true) => number(text).map(|year| if year < 90 { 2000 } else { 1900 } + u16::from(year)),
        _ => None,
    }
}

/// The number of a month from its English name or the first three letters.
fn month(text: &str) -> Option<u8> {
    const NAMES: [&str; 12] = [
        "january",
        "february",
        "march",
        "april",
        "may",
        "june",
        "july",
        "august",
        "september",
        "october",
        "november",
        "december",
    ];
    let lower = text.to_ascii_lowercase();
    let is_it = |name: &&str| lower.len() >= 3 && name.starts_with(&lower);
    (1..).zip(NAMES).find(|(_, name)| is_it(name)).map(|(number, _)| number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_in_the_spellings_of_real_files() {
        for (text, expected) in [
            ("01-31-2020", Some(("2020-01-31", true))),
            ("03-04-2020", Some(("2020-03-04", true))),
            ("1-5-2020", Some(("2020-01-05", true))),
            ("31-01-2020", Some(("2020-01-31", true))),
            ("2020-01-31", Some(("2020-01-31", true))),
            ("2020-01-31+01:00", Some(("2020-01-31", true))),
            ("2020/1/31", Some(("2020-01-31", true))),
            ("31.01.2020", Some(("2020-01-31", true))),
            ("1.2.2020", Some(("2020-02-01", true))),
            ("1/31/2020", Some(("2020-01-31", true))),
            ("17/07/2024", Some(("2024-07-17", true))),
            ("1/2/2020", Some(("2020-01-02", false))),
            ("07-Feb-2016", Some(("2016-02-07", true))),
            ("February 7, 2016", Some(("2016-02-07", true))),
            ("04-19-20", Some(("2020-04-19", false))),
            ("04-19-98", Some(("1998-04-19", false))),
            ("31-31-2020", None),
            ("02-30-2020", None),
            ("2020-01", None),
            ("yesterday", None),
            ("01-ma-2020", None),
            ("1-5-2020-1", None),
            ("2020-01-31 old", None),
        ] {
            let found = date(text).map(|(date, is_clear)| (date.to_iso(), is_clear));
            assert_eq!(found, expected.map(|(date, is_clear)| (date.to_owned(), is_clear)), "{text}");
        }
    }

    #[test]
    fn times_in_the_spellings_of_real_files() {
        for (text, expected) in [
            ("09:45AM", Some("09:45")),
            ("2:07AM", Some("02:07")),
            ("12:10AM", Some("00:10")),
            ("12:10PM", Some("12:10")),
            ("08:55 PM", Some("20:55")),
            ("03:46pm", Some("15:46")),
            ("15:23", Some("15:23")),
            ("13:23:28", Some("13:23:28")),
            ("1:23:28 PM", Some("13:23:28")),
            ("21:37PM", Some("21:37")),
            ("00:00AM", Some("00:00")),
            ("14:40:59.25+01:00", Some("14:40:59.25+01:00")),
            ("13:05AM", None),
            ("00:05PM", None),
            ("9.45", None),
            ("25:00", None),
            ("12:60", None),
            ("12:00:60", None),
            ("12:00:00:00", None),
            ("noon", None),
        ] {
            assert_eq!(clock_time(text).map(|time| time.to_iso(false)).as_deref(), expected, "{text}");
        }
    }
}
