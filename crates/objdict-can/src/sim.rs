//! Simulated nodes as a transport.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::Path;

use objdict_bus::{BusFrame, Frame, LiveBus};
use objdict_traffic::log::{LogOptions, LogReader, LogTime, LoggedFrame};

use crate::transport::{Transport, TransportError};

/// The time between the last frame of a command and the beginning of the next one, in nanoseconds.
const PAUSE: u64 = 100_000_000;

/// A simulated bus. Nothing waits: its time is simulated.
pub struct SimulatedBus {
    bus: LiveBus,
    /// When this command began, in nanoseconds.
    start: u64,
    /// Where sent frames are written.
    memory: Option<File>,
}

impl SimulatedBus {
    /// A bus with these nodes.
    pub const fn new(bus: LiveBus) -> Self {
        Self { bus, start: 0, memory: None }
    }

    /// The nodes as the commands before left them: the frames of a log are sent again, and those of this command are added to it.
    ///
    /// # Errors
    /// When the file cannot be read or written.
    pub fn with_memory(mut self, path: &Path) -> Result<Self, TransportError> {
        const HELP: &str = "name a file that the simulation may create and append to";
        let failed = |error: io::Error| TransportError::closed(&path.to_string_lossy(), error, HELP);
        if path.exists() {
            let log =
                LogReader::new(BufReader::new(File::open(path).map_err(failed)?), LogOptions::default());
            for frame in log {
                let frame = frame.map_err(failed)?;
                let time = u64::try_from(frame.time.nanoseconds()).unwrap_or_default();
                while self.bus.run(time).is_some() {}
                if let Some(frame) = bus_frame(&frame) {
                    self.bus.send(frame);
                }
            }
            let end = self.bus.now() + PAUSE;
            while self.bus.run(end).is_some() {}
            self.start = self.bus.now();
        }
        self.memory = Some(File::options().create(true).append(true).open(path).map_err(failed)?);
        Ok(self)
    }
}

/// A logged frame as nodes take it; `None` for other frames than those of CANopen.
fn bus_frame(frame: &LoggedFrame) -> Option<BusFrame> {
    if frame.is_remote {
        BusFrame::remote(standard_id(frame)?)
    } else {
        data_frame(frame).map(BusFrame::from)
    }
}

/// The same without remote frames.
pub(crate) fn data_frame(frame: &LoggedFrame) -> Option<Frame> {
    Frame::new(standard_id(frame).filter(|_| !frame.is_remote)?, frame.data())
}

fn standard_id(frame: &LoggedFrame) -> Option<u16> {
    u16::try_from(frame.can_id).ok().filter(|_| !frame.is_extended && !frame.is_error)
}

/// A frame with a time in microseconds.
pub(crate) fn logged(frame: &BusFrame, time: u64) -> LoggedFrame {
    let time = LogTime::new(i64::try_from(time.saturating_mul(1000)).unwrap_or(i64::MAX), 6);
    let mut logged = LoggedFrame::new(time, 0, frame.id().into(), false).with_data(frame.data());
    logged.is_remote = frame.is_remote();
    logged
}

impl Transport for SimulatedBus {
    fn send(&mut self, frame: &BusFrame) -> Result<(), TransportError> {
        if let Some(memory) = &mut self.memory {
            let (seconds, rest) = (self.bus.now() / 1_000_000_000, self.bus.now() % 1_000_000_000);
            writeln!(memory, "({seconds}.{rest:09}) sim {}", logged(frame, 0))
                .map_err(|error| TransportError::Lost(error.to_string()))?;
        }
        self.bus.send(*frame);
        Ok(())
    }

    fn receive(&mut self, until: u64) -> Result<Option<LoggedFrame>, TransportError> {
        let until = self.start.saturating_add(until.saturating_mul(1000));
        let found = self.bus.run(until);
        Ok(found.map(|(time, frame)| logged(&frame, time.saturating_sub(self.start) / 1000)))
    }

    fn now(&self) -> u64 {
        // rounded up, so that what is due at a time is due when it is reached
        (self.bus.now() - self.start).div_ceil(1000)
    }

    fn bit_rate(&self) -> Option<u16> {
        Some(self.bus.bit_rate())
    }

    fn has_bit_rates(&self) -> bool {
        true
    }

    fn set_bit_rate(&mut self, bit_rate: u16) -> Result<(), TransportError> {
        self.bus.set_bit_rate(bit_rate);
        Ok(())
    }
}
