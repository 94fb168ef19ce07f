//! The services of a node, as used by the dictionary.

use crate::Dictionary;

/// 1010h and 1011h, whose sub-indexes from 1 on expect a signature.
pub(crate) const STORE: u16 = 0x1010;
pub(crate) const RESTORE: u16 = 0x1011;

/// The behaviour of a node after a communication error.
pub(crate) const ERROR_BEHAVIOUR: u16 = 0x1029;

/// Whether the node starts automatically.
pub(crate) const STARTUP: u16 = 0x1F80;

/// The services that apply writes to the dictionary, and their capabilities.
pub trait Services {
    /// Whether they can send SYNC.
    const PRODUCES_SYNC: bool = false;
    /// The maximum number of monitored heartbeats; `None` if the application monitors them.
    const CONSUMERS: Option<usize> = None;
    /// The maximum number of SDO channels; `None` if the application serves them.
    const CHANNELS: Option<usize> = None;

    /// Applies a write.
    fn follow<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, index: u16, sub: u8);
}
