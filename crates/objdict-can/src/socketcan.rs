//! `SocketCAN`, the interfaces of Linux, with error frames, filters, and the time stamps of the kernel.

use std::io;
use std::time::{Duration, Instant, SystemTime};

use objdict_bus::BusFrame;
use objdict_traffic::log::{LogTime, LoggedFrame};
use socketcan::{
    CanDataFrame, CanFilter, CanFrame, CanRemoteFrame, CanSocket, EmbeddedFrame, Frame, Socket,
    SocketOptions, StandardId,
};

use crate::transport::{Transport, TransportError};

const HELP: &str =
    "`ip link show type can` lists the interfaces; `ip link set can0 up type can bitrate 500000` starts one";

/// An interface such as `can0`.
pub(crate) struct SocketCanInterface {
    socket: CanSocket,
    opened: Instant,
    /// The same on the clock of the kernel's time stamps.
    opened_at: SystemTime,
}

/// What is left of the standard CAN-IDs without PDOs and TIME, as values and masks: NMT and LSS, SYNC and EMCY, SDO, heartbeats.
const SERVICES: [(u32, u32); 5] =
    [(0, 0x780), (0x080, 0x780), (0x580, 0x780), (0x600, 0x780), (0x700, 0x700)];

impl SocketCanInterface {
    /// Opens an interface.
    ///
    /// # Errors
    /// When there is no such interface.
    pub(crate) fn open(name: &str) -> Result<Self, TransportError> {
        let socket = CanSocket::open(name).and_then(|socket| {
            // errors of the bus are seen, such as bus off
            socket.set_error_filter_accept_all()?;
            socket.set_recv_timestamp(true)?;
            Ok(socket)
        });
        let socket = socket.map_err(|error| TransportError::closed(name, error, HELP))?;
        Ok(Self { socket, opened: Instant::now(), opened_at: SystemTime::now() })
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
        let lost = |error: io::Error| TransportError::Lost(error.to_string());
        self.socket.set_read_timeout(wait).map_err(lost)?;
        match self.socket.read_frame_with_timestamps() {
            Ok((frame, times)) => {
                let now = self.now();
                // a clock that was set meanwhile does not say when
                let stamp = times.socket.and_then(|time| time.duration_since(self.opened_at).ok());
                let time = stamp.and_then(|time| u64::try_from(time.as_micros()).ok());
                Ok(Some(logged(&frame, time.filter(|time| *time <= now).unwrap_or(now))))
            }
            Err(error) if matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock) => {
                Ok(None)
            }
            Err(error) => Err(lost(error)),
        }
    }

    fn drop_pdos(&mut self) -> Result<(), TransportError> {
        let filters = SERVICES.map(|(id, mask)| CanFilter::new(id, mask));
        self.socket.set_filters(&filters).map_err(|error| TransportError::Lost(error.to_string()))
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

#[cfg(test)]
mod tests {
    use super::SERVICES;

    #[test]
    fn filters_leave_all_but_pdos_and_time() {
        let passes = |id: u32| SERVICES.iter().any(|(value, mask)| id & mask == value & mask);
        for id in [0, 0x080, 0x081, 0x0FF, 0x581, 0x5FF, 0x601, 0x67F, 0x701, 0x77F, 0x7E4, 0x7E5] {
            assert!(passes(id), "{id:X}");
        }
        for id in [0x100, 0x181, 0x2FF, 0x301, 0x4FF, 0x501, 0x57F, 0x680, 0x6FF] {
            assert!(!passes(id), "{id:X}");
        }
    }
}
