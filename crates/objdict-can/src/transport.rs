//! What every adapter does.

use objdict_bus::BusFrame;
use objdict_traffic::log::LoggedFrame;

/// An adapter. Frames wait in the queue of the operating system or of the adapter, which is bounded: if it overflows, frames are lost.
/// Times are in microseconds since the transport was opened.
pub trait Transport {
    /// Sends a frame.
    ///
    /// # Errors
    /// When the adapter is lost or refuses the frame.
    fn send(&mut self, frame: &BusFrame) -> Result<(), TransportError>;

    /// The next frame of another node, or `None` if none came until a time.
    ///
    /// # Errors
    /// When the adapter is lost.
    fn receive(&mut self, until: u64) -> Result<Option<LoggedFrame>, TransportError>;

    /// Lets the adapter drop PDOs, so that they do not fill its queue. Adapters without filters receive them nevertheless.
    ///
    /// # Errors
    /// When the adapter is lost.
    fn drop_pdos(&mut self) -> Result<(), TransportError> {
        Ok(())
    }

    /// The time.
    fn now(&self) -> u64;

    /// Whether it replays a log, so that nothing can be sent.
    fn is_replay(&self) -> bool {
        false
    }

    /// The bit rate in kbit/s, where the adapter knows it.
    fn bit_rate(&self) -> Option<u16> {
        None
    }

    /// Whether it can change its bit rate.
    fn has_bit_rates(&self) -> bool {
        false
    }

    /// Changes to another bit rate in kbit/s, if it can.
    ///
    /// # Errors
    /// When the adapter is lost.
    fn set_bit_rate(&mut self, _: u16) -> Result<(), TransportError> {
        Ok(())
    }
}

/// Why a bus cannot be used. Each message includes the remedy.
#[derive(Debug)]
#[non_exhaustive]
pub enum TransportError {
    /// The adapter cannot be opened.
    Closed {
        /// The port, interface or file.
        name: String,
        /// The reason.
        reason: String,
        /// What to do.
        help: &'static str,
    },
    /// The adapter is gone.
    Lost(String),
    /// The adapter does not take a frame.
    Refused(String),
    /// A log is replayed.
    Replay,
}

objdict_model::error_messages! { TransportError: {
    Self::Closed { name, reason, .. } => "cannot open `{name}`: {reason}";
    Self::Lost(reason) => "the adapter is lost: {reason}";
    Self::Refused(reason) => "the adapter does not take a frame: {reason}";
    Self::Replay => "a log is replayed, so nothing can be sent";
} }

impl TransportError {
    pub(crate) fn closed(name: &str, reason: impl std::fmt::Display, help: &'static str) -> Self {
        Self::Closed { name: name.to_owned(), reason: reason.to_string(), help }
    }

    /// What to do about it.
    pub const fn help(&self) -> &'static str {
        match self {
            Self::Closed { help, .. } => help,
            Self::Lost(_) => {
                "plug it in again, and check its supply and driver; the devices keep what was written"
            }
            Self::Refused(_) => "check bit rate, wiring and termination: no other node acknowledges frames",
            Self::Replay => "name an adapter or a simulated network with `--bus`",
        }
    }
}
