//! Facts about the description file (CiA 306-1 §4.4).

use std::fmt;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Extra, Misfits};

/// Who made the description, when, and of which version.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct FileInfo {
    /// `FileName`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file_name: Option<String>,
    /// `FileVersion`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file_version: Option<u8>,
    /// `FileRevision`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file_revision: Option<u8>,
    /// `EDSVersion`, such as `4.0`; missing means 3.0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub eds_version: Option<String>,
    /// `Description`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// `CreationTime`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub creation_time: Option<ClockTime>,
    /// `CreationDate`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub creation_date: Option<Date>,
    /// `CreatedBy`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub created_by: Option<String>,
    /// `ModificationTime`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub modification_time: Option<ClockTime>,
    /// `ModificationDate`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub modification_date: Option<Date>,
    /// `ModifiedBy`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub modified_by: Option<String>,
    /// `LastEDS` of a DCF: the EDS that it was made from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub last_eds: Option<String>,
    /// Keys that the model does not know.
    #[serde(skip_serializing_if = "Extra::is_empty")]
    pub extra: Extra,
    /// Texts that are no values of their fields.
    #[serde(skip_serializing_if = "Misfits::is_empty")]
    pub misfits: Misfits,
}

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
    /// A day; `None` when the calendar does not have it.
    pub fn new(year: u16, month: u8, day: u8) -> Option<Self> {
        let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
        let days = match month {
            4 | 6 | 9 | 11 => 30,
            2 => 28 + u8::from(leap),
            1..=12 => 31,
            _ => return None,
        };
        (1..=days).contains(&day).then_some(Self { year, month, day })
    }
}

/// As in an EDS: `mm-dd-yyyy`.
impl fmt::Display for Date {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:02}-{:02}-{:04}", self.month, self.day, self.year)
    }
}

/// A time of day to the minute.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ClockTime {
    /// Hour, 0 to 23.
    pub hour: u8,
    /// Minute, 0 to 59.
    pub minute: u8,
}

impl ClockTime {
    /// A time; `None` when a day does not have it.
    pub fn new(hour: u8, minute: u8) -> Option<Self> {
        (hour < 24 && minute < 60).then_some(Self { hour, minute })
    }
}

/// As in an EDS: `hh:mmAM` or `hh:mmPM`, twelve hours.
impl fmt::Display for ClockTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let hour = match self.hour % 12 {
            0 => 12,
            hour => hour,
        };
        write!(f, "{hour:02}:{:02}{}", self.minute, if self.hour < 12 { "AM" } else { "PM" })
    }
}

/// In JSON as in ISO 8601: `2024-03-04`.
impl Serialize for Date {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&format_args!("{:04}-{:02}-{:02}", self.year, self.month, self.day))
    }
}

impl<'de> Deserialize<'de> for Date {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let date = || {
            let mut parts = text.splitn(3, '-').map(number);
            let (year, month, day) = (parts.next()??, parts.next()??, parts.next()??);
            Self::new(year, u8::try_from(month).ok()?, u8::try_from(day).ok()?)
        };
        date().ok_or_else(|| D::Error::custom(format!("`{text}` is no date such as `2024-03-04`")))
    }
}

/// In JSON as in ISO 8601: `14:40`.
impl Serialize for ClockTime {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&format_args!("{:02}:{:02}", self.hour, self.minute))
    }
}

impl<'de> Deserialize<'de> for ClockTime {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let time = || {
            let (hour, minute) = text.split_once(':')?;
            Self::new(u8::try_from(number(hour)?).ok()?, u8::try_from(number(minute)?).ok()?)
        };
        time().ok_or_else(|| D::Error::custom(format!("`{text}` is no time such as `14:40`")))
    }
}

fn number(text: &str) -> Option<u16> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit());
    if digits { text.parse().ok() } else { None }
}
