//! What a new description states for what its author leaves open.

use std::time::{SystemTime, UNIX_EPOCH};

use super::{Features, Wanted};
use objdict_model::model::{ClockTime, Date};

/// The vendor-ID of a device whose vendor is not said: one that CiA never assigns.
pub const NO_VENDOR: u32 = 0xFFFF_FFFF;

/// The start of a day.
pub const MIDNIGHT: ClockTime = ClockTime { hour: 0, minute: 0, second: 0, nanosecond: 0, utc_offset: None };

impl Wanted {
    /// A device of a profile, made now, with a name for all that its author fills in.
    pub fn to_fill_in(profile: u16, file_name: &str) -> Option<Self> {
        let (date, time) = now()?;
        Some(Self {
            profile,
            features: Features::default(),
            file_name: file_name.to_owned(),
            vendor_name: "Vendor".to_owned(),
            vendor_id: NO_VENDOR,
            product_name: "Device".to_owned(),
            product_code: 1,
            revision: 0x0001_0000,
            author: "Vendor".to_owned(),
            date,
            time,
        })
    }
}

/// Date and time of `SOURCE_DATE_EPOCH`, else of now, in Coordinated Universal Time; `None` if the clock has no valid date.
pub fn now() -> Option<(Date, ClockTime)> {
    let epoch = std::env::var("SOURCE_DATE_EPOCH").ok().and_then(|text| text.parse().ok());
    let now = || SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let seconds: u64 = epoch.unwrap_or_else(now);
    let minutes = seconds / 60 % (24 * 60);
    let time = u8::try_from(minutes / 60).ok().zip(u8::try_from(minutes % 60).ok());
    let time = time.and_then(|(hour, minute)| ClockTime::new(hour, minute)).unwrap_or(MIDNIGHT);
    Date::after_1970(seconds / (24 * 60 * 60)).map(|date| (date, time))
}
