//! How much of the bus is used.

use super::frames::TimedFrame;
use super::{Schedule, TimingOptions, TrafficKind};
use crate::traffic::Traffic;

/// How many bits are sent, in thousandths of a bit each second.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Load {
    /// Without stuff bits, and with PDOs at their event timer rate, otherwise at their maximum rate.
    pub average: u64,
    /// With maximum bit stuffing, and with PDOs at their maximum rate.
    pub worst: u64,
}

impl Load {
    pub(crate) fn of<'f>(frames: impl IntoIterator<Item = &'f TimedFrame>) -> Self {
        let loads = frames.into_iter().map(TimedFrame::load);
        loads.fold(Self::default(), |sum, load| Self {
            average: sum.average + load.average,
            worst: sum.worst + load.worst,
        })
    }

    /// The average share of a bit rate in kbit/s, in thousandths of a percent.
    pub fn average_percent(&self, bit_rate: u16) -> u64 {
        percent(self.average, bit_rate)
    }

    /// The share in the worst case.
    pub fn worst_percent(&self, bit_rate: u16) -> u64 {
        percent(self.worst, bit_rate)
    }
}

fn percent(load: u64, bit_rate: u16) -> u64 {
    let rate = u64::from(bit_rate.max(1)) * 1000;
    (load * 100 + rate / 2) / rate
}

impl TimedFrame {
    /// The load of the message. Errors, commands and requests are not included.
    fn load(&self) -> Load {
        // thousandths of a bit each second
        let load = |bits: u64, period: Option<u64>| {
            period.map_or(0, |period| bits * 1_000_000_000_000 / period.max(1))
        };
        if self.kind == TrafficKind::Emcy {
            return Load::default();
        }
        Load {
            average: load(self.least_bits(), self.usual),
            worst: load(self.most_bits(), self.rhythm.distance().or(self.usual)),
        }
    }
}

impl Schedule {
    /// The share of a bit rate in kbit/s that is used all the time, in thousandths.
    pub(crate) fn load_at(&self, bit_rate: u16) -> u64 {
        Load::of(&self.frames).worst / (u64::from(bit_rate) * 1000).max(1)
    }
}

impl Traffic<'_> {
    /// The permanently used share of the bit rate in thousandths; `None` without a bit rate.
    pub(crate) fn load(self) -> Option<u64> {
        let rate = self.network.bit_rate?.value;
        Some(Schedule::new(self, TimingOptions::default()).load_at(rate))
    }
}
