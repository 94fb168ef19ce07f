//! Times with units.

use crate::Language;

/// A time in milliseconds.
pub(crate) fn of_milliseconds(time: u32, _: Language) -> String {
    format!("{time} ms")
}

/// A time in multiples of 100 µs: `10.5 ms`.
pub(crate) fn of_tenths(time: u32, language: Language) -> String {
    decimal(time, 1, language) + " ms"
}

/// A time in microseconds; in milliseconds if it is 1 ms or longer.
pub(crate) fn of_microseconds(time: u32, language: Language) -> String {
    if time < 1000 { format!("{time} µs") } else { decimal(time, 3, language) + " ms" }
}

/// A number with this many decimal places, without trailing zeros.
pub(crate) fn decimal(number: u32, digits: u32, language: Language) -> String {
    let scale = 10_u32.pow(digits);
    let (whole, rest) = (number / scale, number % scale);
    if rest == 0 {
        return whole.to_string();
    }
    let width = usize::try_from(digits).unwrap_or_default();
    let rest = format!("{rest:0width$}");
    format!("{whole}{}{}", language.pick(".", ","), rest.trim_end_matches('0'))
}

/// Milliseconds since midnight as a time of day; `None` if longer than a day.
pub(crate) fn of_day(milliseconds: u32) -> Option<String> {
    let seconds = milliseconds / 1000;
    let (hours, minutes) = (seconds / 3600, seconds / 60 % 60);
    (hours < 24).then(|| format!("{hours:02}:{minutes:02}:{:02}.{:03}", seconds % 60, milliseconds % 1000))
}

/// The date this many days after 1984-01-01, as `2026-05-03`; `None` if the year has five digits.
pub(crate) fn date(days: u32) -> Option<String> {
    // Years start in March here, so a leap day is the last day of its year. March 1st, 1600 was 140_193 days
    // before 1984-01-01, and 400 years have 146_097 days.
    let days = u64::from(days) + 140_193;
    let (era, day) = (days / 146_097, days % 146_097);
    let year_of_era = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * day + 2) / 153;
    let day = day - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = 1600 + 400 * era + year_of_era + u64::from(month <= 2);
    (year < 10_000).then(|| format!("{year}-{month:02}-{day:02}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_behind_the_point() {
        let tenths = [0, 7, 100, 105].map(|time| of_tenths(time, Language::English));
        assert_eq!(tenths, ["0 ms", "0.7 ms", "10 ms", "10.5 ms"]);
        let microseconds = [999, 1000, 1050, u32::MAX].map(|time| of_microseconds(time, Language::German));
        assert_eq!(microseconds, ["999 µs", "1 ms", "1,05 ms", "4294967,295 ms"]);
    }

    #[test]
    fn dates_are_those_of_the_calendar() {
        let dates = [0, 59, 60, 366, 5903, 15_341, 42_431].map(|days| date(days).unwrap_or_default());
        let expected = [
            "1984-01-01",
            "1984-02-29",
            "1984-03-01",
            "1985-01-01",
            "2000-02-29",
            "2026-01-01",
            "2100-03-04",
        ];
        assert_eq!(dates, expected);
        assert_eq!(date(u32::MAX), None);
        assert_eq!(of_day(86_399_999).as_deref(), Some("23:59:59.999"));
        assert_eq!(of_day(86_400_000), None);
    }
}
