//! Due times. Times are in microseconds from an arbitrary start.

/// A periodic transmission. It keeps its phase, and skips the periods in which it was not polled.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Periodic {
    /// In microseconds; 0 while nothing is sent.
    period: u64,
    /// `None` before the first transmission, which is due at once.
    due: Option<u64>,
}

impl Periodic {
    /// Never due. A function instead of a constant, which would become data to copy.
    pub(crate) const fn never() -> Self {
        Self { period: 0, due: None }
    }

    /// Changes the period; the first transmission is due at once.
    pub(crate) fn restart(&mut self, period: u64) {
        *self = Self { period, due: None };
    }

    /// Schedules the first transmission a period from now.
    pub(crate) const fn wait(&mut self, now: u64) {
        self.due = Some(now.saturating_add(self.period));
    }

    /// Whether a transmission is due; if so, the next period begins.
    pub(crate) fn take(&mut self, now: u64) -> bool {
        let due = self.due.unwrap_or(now);
        if self.period == 0 || due > now {
            return false;
        }
        // a division of 64 bits would link 500 bytes
        let mut late = now - due;
        for shift in (0..=self.period.leading_zeros()).rev() {
            late = late.checked_sub(self.period << shift).unwrap_or(late);
        }
        self.due = Some((now - late).saturating_add(self.period));
        true
    }

    /// The due time; `None` for never.
    pub(crate) fn next(&self, now: u64) -> Option<u64> {
        (self.period != 0).then(|| self.due.unwrap_or(now))
    }
}

/// Microseconds of milliseconds.
pub(crate) const fn milliseconds(number: u16) -> u64 {
    number as u64 * 1000
}

/// The earlier of two times.
pub(crate) fn earlier(one: Option<u64>, other: Option<u64>) -> Option<u64> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one.min(other)),
        _ => one.or(other),
    }
}
