//! A frame of a log.

use std::fmt;

use super::LogTime;

/// Marks error frames in the CAN-IDs of SocketCAN.
pub(super) const ERROR_FLAG: u32 = 0x2000_0000;

/// A frame that was seen on a bus.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoggedFrame {
    /// When it was seen.
    pub time: LogTime,
    /// The number of its channel; [`LogReader::channel`](super::LogReader::channel) has the name.
    pub channel: u16,
    /// The CAN-ID, without flags.
    pub can_id: u32,
    /// Whether the CAN-ID has 29 bits.
    pub is_extended: bool,
    /// Whether it is a remote frame.
    pub is_remote: bool,
    /// Whether it is an error frame; its CAN-ID and data say which, as SocketCAN codes them.
    pub is_error: bool,
    /// Whether it is a frame of CAN FD.
    pub is_fd: bool,
    /// Whether the machine that wrote the log sent it; `None` if the log does not say so.
    pub is_sent: Option<bool>,
    pub(super) length: u8,
    pub(super) data: [u8; 64],
}

impl LoggedFrame {
    /// A data frame without data.
    pub fn new(time: LogTime, channel: u16, can_id: u32, is_extended: bool) -> Self {
        Self {
            time,
            channel,
            can_id,
            is_extended,
            is_remote: false,
            is_error: false,
            is_fd: false,
            is_sent: None,
            length: 0,
            data: [0; 64],
        }
    }

    /// The data: at most 8 bytes, or 64 in a frame of CAN FD; none in a remote frame.
    pub fn data(&self) -> &[u8] {
        &self.data[..usize::from(self.length)]
    }

    /// The same frame with these data.
    ///
    /// Data longer than 64 bytes are cut.
    #[must_use]
    pub fn with_data(mut self, data: &[u8]) -> Self {
        let length = data.len().min(64);
        self.data[..length].copy_from_slice(&data[..length]);
        self.length = length as u8;
        self
    }

    /// Adds a byte; whether there is place for it.
    pub(super) fn push(&mut self, byte: u8) -> bool {
        let place = self.data.get_mut(usize::from(self.length)).map(|place| *place = byte);
        self.length += u8::from(place.is_some());
        place.is_some()
    }
}

/// As `candump -L` writes it: `185#3702`, `18EBFF05#R`.
impl fmt::Display for LoggedFrame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { can_id, is_extended, is_remote, is_fd, .. } = *self;
        if self.is_error {
            write!(f, "{:08X}", can_id | ERROR_FLAG)?;
        } else {
            let width = if is_extended { 8 } else { 3 };
            write!(f, "{can_id:0width$X}")?;
        }
        let separator = if is_fd { "##0" } else { "#" };
        write!(f, "{separator}{}", if is_remote { "R" } else { "" })?;
        self.data().iter().try_for_each(|byte| write!(f, "{byte:02X}"))
    }
}
