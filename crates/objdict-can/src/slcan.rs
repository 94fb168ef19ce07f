//! Serial adapters with the protocol of Lawicel (SLCAN), such as CANable. They have no filters, no time stamps and no error frames.

use std::io::{self, Read, Write};
use std::time::{Duration, Instant};

use objdict_bus::BusFrame;
use objdict_traffic::log::{LogTime, LoggedFrame};

use crate::address::SLCAN_RATES;
use crate::transport::{Transport, TransportError};

/// How long a read waits.
const PATIENCE: Duration = Duration::from_millis(10);

/// The bytes of the longest line: an extended frame with a time stamp.
const LINE: usize = 1 + 8 + 1 + 16 + 4;

/// The bit rates in kbit/s in the order in which they are looked for, and how long each is listened to, in microseconds.
const LIKELY_RATES: [u16; 9] = [500, 250, 125, 1000, 800, 50, 100, 20, 10];
const RATE_TIME: u64 = 1_100_000;

/// The serial baud rate. Adapters with USB ignore it.
const BAUD: u32 = 115_200;

const HELP: &str = "check the name of the port, and that you may open it (Linux: group `dialout`) and no other program has it open";

/// A serial adapter on an open port.
pub struct SlcanAdapter<P: Read + Write> {
    port: P,
    opened: Instant,
    bit_rate: u16,
    /// The bytes of lines that are not complete. A line that is too long is dropped.
    line: Vec<u8>,
    /// Bytes that were read and not used.
    rest: std::collections::VecDeque<u8>,
}

impl SlcanAdapter<Box<dyn serialport::SerialPort>> {
    /// Opens a port and the bus behind it; without a bit rate at the one of the bus.
    ///
    /// # Errors
    /// When the port cannot be opened, the adapter does not take the bit rate, or no frame shows it.
    pub fn open(port: &str, bit_rate: Option<u16>) -> Result<Self, TransportError> {
        let opened = serialport::new(port, BAUD).timeout(PATIENCE).open();
        let opened = opened.map_err(|error| TransportError::closed(port, error, HELP))?;
        match bit_rate {
            Some(bit_rate) => {
                Self::new(opened, bit_rate).map_err(|error| TransportError::closed(port, error, HELP))
            }
            None => Self::listening(opened, RATE_TIME)?.ok_or_else(|| {
                let reason = "no frame is heard at any bit rate, so the bit rate is unknown";
                TransportError::closed(port, reason, "name it, as in `@500`; a silent bus does not show it")
            }),
        }
    }
}

impl<P: Read + Write> SlcanAdapter<P> {
    /// Opens the bus behind an open port, whose reads wait only a short time.
    ///
    /// # Errors
    /// When the port is lost.
    pub fn new(port: P, bit_rate: u16) -> Result<Self, TransportError> {
        let mut adapter = Self::closed(port)?;
        adapter.set_bit_rate(bit_rate)?;
        Ok(adapter)
    }

    fn closed(port: P) -> Result<Self, TransportError> {
        let (line, rest) = Default::default();
        let mut adapter = Self { port, opened: Instant::now(), bit_rate: 0, line, rest };
        // it ends a half line of an earlier program
        adapter.write(b"\r")?;
        Ok(adapter)
    }

    /// The same at the bit rate at which a frame is heard in so many microseconds, the frequent ones first; `None` if none is. The
    /// adapter only listens meanwhile, so it disturbs no node.
    ///
    /// # Errors
    /// When the port is lost.
    pub fn listening(port: P, time: u64) -> Result<Option<Self>, TransportError> {
        let mut adapter = Self::closed(port)?;
        adapter.write(b"C\r")?;
        // frames that an earlier program has left
        while adapter.read()? {
            adapter.rest.clear();
        }
        for bit_rate in LIKELY_RATES {
            adapter.change(bit_rate, 'L')?;
            if adapter.receive(adapter.now().saturating_add(time))?.is_some() {
                adapter.set_bit_rate(bit_rate)?;
                return Ok(Some(adapter));
            }
        }
        Ok(None)
    }

    /// Closes the bus, and opens it with another bit rate: with `O`, or with `L` to listen only.
    fn change(&mut self, bit_rate: u16, open: char) -> Result<(), TransportError> {
        let rate = SLCAN_RATES.iter().position(|rate| *rate == bit_rate).unwrap_or(6);
        self.bit_rate = bit_rate;
        self.write(format!("C\rS{rate}\r{open}\r").as_bytes())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), TransportError> {
        let written = self.port.write_all(bytes).and_then(|()| self.port.flush());
        written.map_err(|error| TransportError::Lost(error.to_string()))
    }

    /// Reads what is there; whether there was something.
    fn read(&mut self) -> Result<bool, TransportError> {
        let mut buffer = [0; 256];
        match self.port.read(&mut buffer) {
            Ok(0) => Err(TransportError::Lost("the serial port is closed".to_owned())),
            Ok(count) => {
                self.rest.extend(&buffer[..count.min(buffer.len())]);
                Ok(true)
            }
            Err(error) if matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::Interrupted) => {
                Ok(false)
            }
            Err(error) => Err(TransportError::Lost(error.to_string())),
        }
    }

    /// The next frame among the bytes that were read.
    fn parsed(&mut self) -> Option<LoggedFrame> {
        while let Some(byte) = self.rest.pop_front() {
            match byte {
                b'\r' => {
                    let frame = frame(&self.line, self.now());
                    self.line.clear();
                    if frame.is_some() {
                        return frame;
                    }
                }
                // the bell: the adapter refuses a command
                7 => self.line.clear(),
                _ if self.line.len() <= LINE => self.line.push(byte),
                _ => {}
            }
        }
        None
    }
}

/// The frame of a line such as `t1852FF00`; `None` for answers of the adapter and malformed lines.
fn frame(line: &[u8], now: u64) -> Option<LoggedFrame> {
    let (&kind, rest) = line.split_first()?;
    let (is_extended, is_remote) = match kind {
        b't' => (false, false),
        b'r' => (false, true),
        b'T' => (true, false),
        b'R' => (true, true),
        _ => return None,
    };
    let text =
        std::str::from_utf8(rest).ok().filter(|text| text.bytes().all(|byte| byte.is_ascii_hexdigit()))?;
    let (id, text) = text.split_at_checked(if is_extended { 8 } else { 3 })?;
    let id =
        u32::from_str_radix(id, 16).ok().filter(|id| *id <= if is_extended { 0x1FFF_FFFF } else { 0x7FF })?;
    let (length, text) = text.split_at_checked(1)?;
    let length = length.parse::<usize>().ok().filter(|length| *length <= 8)?;
    let length = if is_remote { 0 } else { length };
    let byte = |at: usize| u8::from_str_radix(text.get(2 * at..2 * at + 2)?, 16).ok();
    let data = (0..length).map(byte).collect::<Option<Vec<u8>>>()?;
    let time = LogTime::new(i64::try_from(now.saturating_mul(1000)).unwrap_or(i64::MAX), 6);
    let mut frame = LoggedFrame::new(time, 0, id, is_extended).with_data(&data);
    frame.is_remote = is_remote;
    Some(frame)
}

impl<P: Read + Write> Transport for SlcanAdapter<P> {
    fn send(&mut self, frame: &BusFrame) -> Result<(), TransportError> {
        let (kind, data) = if frame.is_remote() { ('r', &[][..]) } else { ('t', frame.data()) };
        let digits: String = data.iter().map(|byte| format!("{byte:02X}")).collect();
        self.write(format!("{kind}{:03X}{}{digits}\r", frame.id(), data.len()).as_bytes())
    }

    fn receive(&mut self, until: u64) -> Result<Option<LoggedFrame>, TransportError> {
        loop {
            if let Some(frame) = self.parsed() {
                return Ok(Some(frame));
            }
            if !self.read()? && self.now() >= until {
                return Ok(None);
            }
        }
    }

    fn now(&self) -> u64 {
        u64::try_from(self.opened.elapsed().as_micros()).unwrap_or(u64::MAX)
    }

    fn bit_rate(&self) -> Option<u16> {
        Some(self.bit_rate)
    }

    fn has_bit_rates(&self) -> bool {
        true
    }

    fn set_bit_rate(&mut self, bit_rate: u16) -> Result<(), TransportError> {
        self.change(bit_rate, 'O')
    }
}

impl<P: Read + Write> Drop for SlcanAdapter<P> {
    /// Takes the adapter off the bus.
    fn drop(&mut self) {
        let _ = self.write(b"C\r");
    }
}
