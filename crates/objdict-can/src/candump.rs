//! A log as a transport: it is replayed at once.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use objdict_bus::BusFrame;
use objdict_traffic::log::{LogOptions, LogReader, LoggedFrame};

use crate::transport::{Transport, TransportError};

/// A log of candump, or of another tool that `objdict decode` reads.
pub struct ReplayedLog {
    log: LogReader<BufReader<File>>,
    /// The time of the first frame in nanoseconds.
    start: Option<i64>,
    now: u64,
    /// A frame that is later than what was asked for.
    next: Option<(u64, LoggedFrame)>,
}

impl ReplayedLog {
    /// Opens a log.
    ///
    /// # Errors
    /// When it cannot be opened.
    pub fn open(path: &Path) -> Result<Self, TransportError> {
        let name = path.to_string_lossy();
        let file = File::open(path).map_err(|error| {
            TransportError::closed(&name, error, "name a log, as `candump -L can0` writes it")
        })?;
        let log = LogReader::new(BufReader::new(file), LogOptions::default());
        Ok(Self { log, start: None, now: 0, next: None })
    }
}

impl Transport for ReplayedLog {
    fn send(&mut self, _: &BusFrame) -> Result<(), TransportError> {
        Err(TransportError::Replay)
    }

    fn receive(&mut self, until: u64) -> Result<Option<LoggedFrame>, TransportError> {
        if self.next.is_none() {
            let frame = self.log.next_frame().map_err(|error| TransportError::Lost(error.to_string()))?;
            self.next = frame.map(|frame| {
                let time = frame.time.nanoseconds();
                let since = time.saturating_sub(*self.start.get_or_insert(time));
                (u64::try_from(since).unwrap_or_default() / 1000, frame)
            });
        }
        let due = self.next.take_if(|(time, _)| *time <= until);
        self.now = self.now.max(due.as_ref().map_or(until, |(time, _)| *time));
        Ok(due.map(|(_, frame)| frame))
    }

    fn now(&self) -> u64 {
        self.now
    }

    fn is_replay(&self) -> bool {
        true
    }
}
