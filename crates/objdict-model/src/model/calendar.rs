//! Days and times of day, as descriptions state them.

use std::fmt;

/// A day of the Gregorian calendar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Date {
    /// Year.
    pub year: u16,
    /// Month, 1 to 12.
    pub month: u8,
    /// Day, 1 to 31.
    pub day: u8,
}

impl Date {
    /// A day; `None` if the calendar does not have it.
    pub fn new(year: u16, month: u8, day: u8) -> Option<Self> {
        let date = Self { year, month, day };
        ((1..=12).contains(&month) && (1..=date.days_of_month()).contains(&day)).then_some(date)
    }

    /// The number of days of the month.
    const fn days_of_month(self) -> u8 {
        let year = self.year;
        let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
        match self.month {
            4 | 6 | 9 | 11 => 30,
            2 => 28 + leap as u8,
            _ => 31,
        }
    }

    /// The day that is this number of days after 1970-01-01; `None` beyond the year 9999.
    pub fn after_1970(days: u64) -> Option<Self> {
        let mut rest = u32::try_from(days).ok()?;
        let mut first = Self { year: 1970, month: 1, day: 1 };
        loop {
            let length = first.days_of_month();
            if rest < u32::from(length) {
                let day = u8::try_from(rest).ok()? + 1;
                return Some(Self { day, ..first });
            }
            rest -= u32::from(length);
            first = match first.month {
                12 if first.year == 9999 => return None,
                12 => Self { year: first.year + 1, month: 1, day: 1 },
                month => Self { month: month + 1, ..first },
            };
        }
    }

    /// The number of days after 1984-01-01, as CiA 301 and CiA 302-3 count them; `None` for an earlier day.
    pub fn days_after_1984(self) -> Option<u32> {
        let months = (1984..=self.year).flat_map(|year| (1..=12).map(move |month| (year, month)));
        let before = months.take_while(|&(year, month)| (year, month) < (self.year, self.month));
        let days =
            before.map(|(year, month)| u32::from(Self { year, month, day: 1 }.days_of_month())).sum::<u32>();
        (self.year >= 1984).then(|| days + u32::from(self.day) - 1)
    }

    /// Parses a date of ISO 8601 such as `2024-03-04`.
    pub fn from_iso(text: &str) -> Option<Self> {
        let mut parts = text.splitn(3, '-');
        let (year, month, day) = (parts.next()?, parts.next()?, parts.next()?);
        let is_year = year.len() == 4 && year.bytes().all(|byte| byte.is_ascii_digit());
        if is_year { Self::new(year.parse().ok()?, two_digits(month)?, two_digits(day)?) } else { None }
    }

    /// Formats the date as in ISO 8601: `2024-03-04`.
    pub fn to_iso(self) -> String {
        let Self { year, month, day } = self;
        format!("{year:04}-{month:02}-{day:02}")
    }
}

// The format of an EDS: `mm-dd-yyyy`.
crate::messages! { Date: { Self { month, day, year, .. } => "{month:02}-{day:02}-{year:04}"; } }

/// A time of day: to the minute in an EDS, to fractions of a second in CiA 311.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ClockTime {
    /// Hour, 0 to 23.
    pub hour: u8,
    /// Minute, 0 to 59.
    pub minute: u8,
    /// Second, 0 to 59.
    pub second: u8,
    /// Fraction of the second in ns.
    pub nanosecond: u32,
    /// The offset from Coordinated Universal Time in minutes, positive east of Greenwich; `None` if not
    /// stated.
    pub utc_offset: Option<i16>,
}

impl ClockTime {
    /// A time to the minute; `None` if out of range.
    pub fn new(hour: u8, minute: u8) -> Option<Self> {
        let time = Self { hour, minute, second: 0, nanosecond: 0, utc_offset: None };
        (hour < 24 && minute < 60).then_some(time)
    }

    /// Parses a time of ISO 8601 such as `14:40`, `14:40:59` or `14:40:59.25+01:00`.
    pub fn from_iso(text: &str) -> Option<Self> {
        let (clock, utc_offset) = match text.find(['Z', '+', '-']) {
            Some(at) => (&text[..at], Some(utc_offset(&text[at..])?)),
            None => (text, None),
        };
        let mut parts = clock.splitn(3, ':');
        let mut time = Self::new(two_digits(parts.next()?)?, two_digits(parts.next()?)?)?;
        if let Some(seconds) = parts.next() {
            let (second, fraction) = seconds.split_once('.').unwrap_or((seconds, "0"));
            time.second = two_digits(second).filter(|second| *second < 60)?;
            time.nanosecond = nanoseconds(fraction)?;
        }
        Some(Self { utc_offset, ..time })
    }

    /// Formats the time as in ISO 8601: `14:40:59.25+01:00`, without parts that are not needed. With
    /// `seconds`, the seconds are always written, for formats that require them.
    pub fn to_iso(self, seconds: bool) -> String {
        let Self { hour, minute, second, nanosecond, utc_offset } = self;
        let mut text = format!("{hour:02}:{minute:02}");
        if seconds || second != 0 || nanosecond != 0 || utc_offset.is_some() {
            text.push_str(&format!(":{second:02}"));
        }
        if nanosecond != 0 {
            text.push_str(format!(".{nanosecond:09}").trim_end_matches('0'));
        }
        match utc_offset {
            None => {}
            Some(0) => text.push('Z'),
            Some(offset) => {
                let (sign, minutes) = (if offset < 0 { '-' } else { '+' }, offset.unsigned_abs());
                text.push_str(&format!("{sign}{:02}:{:02}", minutes / 60, minutes % 60));
            }
        }
        text
    }
}

/// The minutes of `Z`, `+01:00` or `-03:30`; ISO 8601 allows offsets up to 14 hours.
fn utc_offset(text: &str) -> Option<i16> {
    if text == "Z" {
        return Some(0);
    }
    let (hours, minutes) = text.get(1..)?.split_once(':')?;
    let (hours, minutes) = (i16::from(two_digits(hours)?), i16::from(two_digits(minutes)?));
    let offset = hours * 60 + minutes;
    (minutes < 60 && offset <= 14 * 60).then_some(if text.starts_with('-') { -offset } else { offset })
}

/// The digits after the decimal point of a second; digits beyond the ninth must be zeros.
fn nanoseconds(digits: &str) -> Option<u32> {
    let kept = digits.trim_end_matches('0');
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()) && kept.len() <= 9;
    if is_number { format!("{kept:0<9}").parse().ok() } else { None }
}

fn two_digits(text: &str) -> Option<u8> {
    let is_number = text.len() == 2 && text.bytes().all(|byte| byte.is_ascii_digit());
    if is_number { text.parse().ok() } else { None }
}

/// The format of an EDS: `hh:mmAM` or `hh:mmPM`, 12-hour clock.
impl fmt::Display for ClockTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let hour = match self.hour % 12 {
            0 => 12,
            hour => hour,
        };
        write!(f, "{hour:02}:{:02}{}", self.minute, if self.hour < 12 { "AM" } else { "PM" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_iso_8601_are_kept() {
        for text in
            ["00:00", "14:40", "23:59:59", "18:55:18.25", "18:55:18.25+02:00", "07:01:00Z", "07:01:30-03:30"]
        {
            let time = ClockTime::from_iso(text).map(|time| time.to_iso(false));
            assert_eq!(time.as_deref(), Some(text));
        }
        let zeros = ClockTime::from_iso("18:55:18.0000000000+02:00").map(|time| time.to_iso(false));
        assert_eq!(zeros.as_deref(), Some("18:55:18+02:00"));
        for text in [
            "",
            "24:00",
            "12:60",
            "1:00",
            "12",
            "12:00:60",
            "12:00:00.",
            "12:00+15:00",
            "12:00:00+1",
            "+1:00",
        ] {
            assert_eq!(ClockTime::from_iso(text), None, "{text}");
        }
    }
}
