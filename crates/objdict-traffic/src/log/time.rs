//! Times of frames, with the digits that the log has.

use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

/// Nanoseconds of a second.
const SECOND: u64 = 1_000_000_000;

/// A time in nanoseconds, from the beginning that the log has: 1970, or the start of the measurement.
#[derive(Clone, Copy, Debug, Default)]
pub struct LogTime {
    nanoseconds: i64,
    /// Digits behind the decimal point of the seconds.
    decimals: u8,
}

impl LogTime {
    /// A time in nanoseconds, shown with so many digits behind the decimal point of the seconds, at most 9.
    pub fn new(nanoseconds: i64, decimals: u8) -> Self {
        Self { nanoseconds, decimals: decimals.min(9) }
    }

    /// The time in nanoseconds.
    pub const fn nanoseconds(self) -> i64 {
        self.nanoseconds
    }

    /// The same number of digits for a time later by that of `distance`.
    pub(super) fn after(self, distance: Self) -> Self {
        let nanoseconds = self.nanoseconds.saturating_add(distance.nanoseconds);
        Self { nanoseconds, decimals: self.decimals.max(distance.decimals) }
    }

    /// A decimal number of seconds, or with `thousandths` of milliseconds. Digits beyond nanoseconds are left out.
    pub(super) fn parse(text: &[u8], thousandths: bool) -> Option<Self> {
        let (is_negative, text) = match text {
            [b'-', rest @ ..] => (true, rest),
            _ => (false, text),
        };
        let places = if thousandths { 6 } else { 9 };
        let mut number = 0;
        let significant = text.iter().position(|byte| *byte != b'0').unwrap_or(text.len());
        // of 19 digits a number has place; more are too many nanoseconds
        let behind = take_digits(&text[significant..], 19 - places, &mut number);
        let fraction = behind.strip_prefix(b".").or_else(|| behind.strip_prefix(b",")).unwrap_or(behind);
        let rest = take_digits(fraction, places, &mut number);
        let decimals = fraction.len() - rest.len();
        let has_digits = text.len() > behind.len() || decimals > 0;
        if behind.first().is_some_and(u8::is_ascii_digit) {
            return None;
        }
        if !rest.is_empty() && (decimals < places || !rest.iter().all(u8::is_ascii_digit)) {
            return exponent(text).filter(|_| has_digits);
        }
        let scale = 10_u64.pow((places - decimals) as u32);
        let nanoseconds = i64::try_from(number.checked_mul(scale)?).ok().filter(|_| has_digits)?;
        let decimals = decimals as u8 + if thousandths { 3 } else { 0 };
        Some(Self { nanoseconds: if is_negative { -nanoseconds } else { nanoseconds }, decimals })
    }

    /// A date as candump prints it with `-tA`: `2024-05-07` and `10:31:00.123456`.
    pub(super) fn parse_date(date: &[u8], time: &[u8]) -> Option<Self> {
        let number = |text: &[u8]| std::str::from_utf8(text).ok()?.parse::<u32>().ok();
        let (&[y1, y2, y3, y4, b'-', m1, m2, b'-', d1, d2], &[h1, h2, b':', n1, n2, b':', ref seconds @ ..]) =
            (date, time)
        else {
            return None;
        };
        let (year, month) = (number(&[y1, y2, y3, y4])?, number(&[m1, m2])?);
        let (day, hours, minutes) = (number(&[d1, d2])?, number(&[h1, h2])?, number(&[n1, n2])?);
        let is_valid = (1970..2262).contains(&year)
            && (1..=12).contains(&month)
            && (1..=31).contains(&day)
            && hours < 24
            && minutes < 60;
        let start = is_valid.then(|| (days(year, month, day) * 24 + hours) * 60 + minutes)?;
        let seconds = Self::parse(seconds, false)?;
        let nanoseconds = i64::from(start).checked_mul(60 * SECOND as i64)?;
        Some(Self { nanoseconds: nanoseconds.checked_add(seconds.nanoseconds)?, decimals: seconds.decimals })
    }
}

/// Adds at most so many digits at the start of a text to a number; what is behind them.
fn take_digits<'t>(text: &'t [u8], most: usize, number: &mut u64) -> &'t [u8] {
    let (most, mut sum, mut count) = (most.min(text.len()), *number, 0);
    while count < most && text[count].is_ascii_digit() {
        sum = sum * 10 + u64::from(text[count] - b'0');
        count += 1;
    }
    *number = sum;
    &text[count..]
}

/// Days from 1970-01-01 on in the Gregorian calendar, by counting years from March.
fn days(year: u32, month: u32, day: u32) -> u32 {
    let year = if month <= 2 { year - 1 } else { year };
    let from_march = (month + 9) % 12;
    let leap_days = year / 4 - year / 100 + year / 400;
    365 * year + leap_days + (153 * from_march + 2) / 5 + day - 1 - 719_468
}

/// Seconds as Python prints small numbers: `5e-05`.
fn exponent(text: &[u8]) -> Option<LogTime> {
    let text = std::str::from_utf8(text).ok()?;
    let seconds = text.parse::<f64>().ok().filter(|seconds| text.contains('e') && seconds.abs() < 1e9)?;
    Some(LogTime { nanoseconds: (seconds * 1e9).round() as i64, decimals: 9 })
}

/// Seconds, as in a log.
impl FromStr for LogTime {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, &'static str> {
        Self::parse(text.as_bytes(), false).ok_or("write seconds, as in `1436509052.249713`")
    }
}

impl PartialEq for LogTime {
    fn eq(&self, other: &Self) -> bool {
        self.nanoseconds == other.nanoseconds
    }
}

impl Eq for LogTime {}

impl PartialOrd for LogTime {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for LogTime {
    fn cmp(&self, other: &Self) -> Ordering {
        self.nanoseconds.cmp(&other.nanoseconds)
    }
}

/// As a text, because a number of JSON would not keep the digits.
impl serde::Serialize for LogTime {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// Seconds with the digits of the log: `1436509052.249713`.
impl fmt::Display for LogTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.nanoseconds < 0 { "-" } else { "" };
        let number = self.nanoseconds.unsigned_abs();
        let decimals = usize::from(self.decimals);
        if decimals == 0 {
            return f.pad(&format!("{sign}{}", number / SECOND));
        }
        let fraction = number % SECOND / 10_u64.pow(9 - u32::from(self.decimals));
        f.pad(&format!("{sign}{}.{fraction:0decimals$}", number / SECOND))
    }
}
