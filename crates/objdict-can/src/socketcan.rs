//! `SocketCAN`, the interfaces of Linux. Error frames are received; time stamps are those of the program, when it reads a frame.

use std::io;
use std::time::{Duration, Instant};

use objdict_bus::BusFrame;
use objdict_traffic::log::{LogTime, LoggedFrame};
use socketcan::{
    CanDataFrame, CanFrame, CanRemoteFrame, CanSocket, EmbeddedFrame, Frame, Socket, SocketOptions,
    StandardId,
};

use crate::transport::{Transport, TransportError};

const HELP: &str =
    "`ip link show type can` lists the interfaces; `ip link set can0 up type can bitrate 500000` starts one";

/// An interface such as `can0`.
pub(crate) struct SocketCanInterface {
    socket: CanSocket,
    opened: Instant,
}

impl SocketCanInterface {
    /// Opens an interface.
    ///
    /// # Errors
    /// When there is no such interface.
    pub(crate) fn open(name: &str) -> Result<Self, TransportError> {
        let socket = CanSocket::open(name).and_then(|socket| {
            // errors of the bus are seen, such as bus off
            socket.set_error_filter_accept_all()?;
            Ok(socket)
        });
        let socket = socket.map_err(|error| TransportError::closed(name, error, HELP))?;
        Ok(Self { socket, opened: Instant::now() })
    }
}

impl Transport for SocketCanInterface {
    fn send(&mut self, frame: &BusFrame) -> Result<(), TransportError> {
        let id = StandardId::new(frame.id())
            .ok_or_else(|| TransportError::Refused("invalid CAN-ID".to_owned()))?;
        let frame = match frame.is_remote() {
            true => CanRemoteFrame::new_remote(id, 0).map(CanFrame::from),
            false => CanDataFrame::new(id, frame.data()).map(CanFrame::from),
        };
        let frame = frame.ok_or_else(|| TransportError::Refused("invalid frame".to_owned()))?;
        self.socket.write_frame(&frame).map_err(|error| match error.raw_os_error() {
            // no buffer space: no other node acknowledges the frames that wait
            Some(105) => TransportError::Refused(error.to_string()),
            _ => TransportError::Lost(error.to_string()),
        })
    }

    fn receive(&mut self, until: u64) -> Result<Option<LoggedFrame>, TransportError> {
        // at least a moment: a wait of 0 is one without an end
        let wait = Duration::from_micros(until.saturating_sub(self.now()).max(1000));
        match self.socket.read_frame_timeout(wait) {
            Ok(frame) => Ok(Some(logged(&frame, self.now()))),
            Err(error) if matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock) => {
                Ok(None)
            }
            Err(error) => Err(TransportError::Lost(error.to_string())),
        }
    }

    fn now(&self) -> u64 {
        u64::try_from(self.opened.elapsed().as_micros()).unwrap_or(u64::MAX)
    }
}

fn logged(frame: &CanFrame, now: u64) -> LoggedFrame {
    let time = LogTime::new(i64::try_from(now.saturating_mul(1000)).unwrap_or(i64::MAX), 6);
    let is_error = matches!(frame, CanFrame::Error(_));
    let id = if let CanFrame::Error(error) = frame { error.error_bits() } else { frame.raw_id() };
    let mut logged = LoggedFrame::new(time, 0, id, frame.is_extended() && !is_error);
    (logged.is_remote, logged.is_error) = (frame.is_remote_frame(), is_error);
    if logged.is_remote { logged } else { logged.with_data(frame.data()) }
}
