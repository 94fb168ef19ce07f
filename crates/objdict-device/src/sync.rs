//! SYNC as the node sends it.

use crate::clock::Periodic;
use crate::dictionary::word;
use crate::frame::EXTENDED;
use crate::{Dictionary, Frame};

/// The COB-ID of SYNC.
pub(crate) const COB_ID: u16 = 0x1005;
/// The period of SYNC in microseconds.
pub(crate) const PERIOD: u16 = 0x1006;
/// The maximum value of the SYNC counter; 0 without a counter.
pub(crate) const OVERFLOW: u16 = 0x1019;

/// The bit of 1005h that makes the node send SYNC.
pub(crate) const PRODUCES: u32 = 1 << 30;

/// The COB-ID of SYNC; a device without 1005h has 80h.
pub(crate) fn cob_id<D: Dictionary + ?Sized>(dictionary: &mut D) -> u32 {
    word(dictionary, COB_ID, 0, 0x80)
}

/// Sends SYNC according to 1005h, 1006h and 1019h, while the node is pre-operational or operational (CiA 301
/// §7.2.5).
#[derive(Clone, Debug)]
pub struct SyncProducer {
    cob_id: u32,
    overflow: u8,
    counter: u8,
    sync: Periodic,
}

impl SyncProducer {
    /// It does not send before [`SyncProducer::boot`].
    #[must_use]
    pub const fn new() -> Self {
        Self { cob_id: 0, overflow: 0, counter: 0, sync: Periodic::never() }
    }

    /// Reads the objects after a reset. The first SYNC is due after one period.
    pub fn boot<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, now: u64) {
        self.load(dictionary);
        self.sync.wait(now);
    }

    /// Reads the objects after a write to one of them. The first SYNC is due at once.
    pub fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) {
        self.cob_id = cob_id(dictionary);
        let mut number = |index| word(dictionary, index, 0, 0);
        self.overflow = number(OVERFLOW) as u8;
        let period =
            if self.cob_id & (PRODUCES | EXTENDED) != PRODUCES { 0 } else { u64::from(number(PERIOD)) };
        self.sync.restart(period);
        self.restart();
    }

    /// Restarts the counter at 1, because the node was stopped.
    pub const fn restart(&mut self) {
        self.counter = 0;
    }

    /// SYNC if it is due at `now`, in microseconds. The node's own PDOs also react to it.
    pub fn poll(&mut self, now: u64) -> Option<Frame> {
        if !self.sync.take(now) {
            return None;
        }
        if self.overflow < 2 {
            return Some(Frame::full(self.cob_id, [0; 8]).shortened(0));
        }
        self.counter = if self.counter < self.overflow { self.counter + 1 } else { 1 };
        Some(Frame::full(self.cob_id, [self.counter, 0, 0, 0, 0, 0, 0, 0]).shortened(1))
    }

    /// The time at which the next SYNC is due.
    #[must_use]
    pub fn next(&self, now: u64) -> Option<u64> {
        self.sync.next(now)
    }
}

impl Default for SyncProducer {
    fn default() -> Self {
        Self::new()
    }
}
