//! The services of a node as the dictionary sees them.

use crate::Dictionary;

/// 1010h and 1011h, whose sub-indexes from 1 on take a signature.
pub(crate) const STORE: u16 = 0x1010;
pub(crate) const RESTORE: u16 = 0x1011;

/// What a node does after a communication error.
pub(crate) const ERROR_BEHAVIOUR: u16 = 0x1029;

/// Whether the node starts by itself.
pub(crate) const STARTUP: u16 = 0x1F80;

/// The services that follow what is written to the dictionary, and what they can do.
pub trait Services {
    /// Whether they can send SYNC.
    const PRODUCES_SYNC: bool = false;
    /// As many heartbeats can be monitored; `None` if the application does that.
    const CONSUMERS: Option<usize> = None;
    /// As many SDO channels are served; `None` if the application does that.
    const CHANNELS: Option<usize> = None;

    /// Follows a write.
    fn follow<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, index: u16, sub: u8);
}
