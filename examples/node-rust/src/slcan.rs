//! Frames as text.

use std::io::{self, ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

use objdict_device::Frame;

/// A connection to the bus.
pub struct Bus {
    stream: TcpStream,
    /// The start of a line.
    text: Vec<u8>,
}

impl Bus {
    pub fn new(stream: TcpStream) -> io::Result<Self> {
        stream.set_nodelay(true)?;
        // the clock of the node
        stream.set_read_timeout(Some(Duration::from_millis(1)))?;
        Ok(Self { stream, text: Vec::new() })
    }

    /// The frames that came within a millisecond.
    pub fn receive(&mut self) -> io::Result<Vec<Frame>> {
        let mut bytes = [0; 4096];
        match self.stream.read(&mut bytes) {
            Ok(0) => return Err(ErrorKind::UnexpectedEof.into()),
            Ok(length) => self.text.extend_from_slice(&bytes[..length]),
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {}
            Err(error) => return Err(error),
        }
        let complete = self.text.iter().rposition(|&byte| byte == b'\r').map_or(0, |end| end + 1);
        let lines: Vec<u8> = self.text.drain(..complete).collect();
        Ok(lines.split(|&byte| byte == b'\r').filter_map(parse).collect())
    }

    pub fn send(&mut self, frame: &Frame) -> io::Result<()> {
        let mut line = format!("t{:03X}{}", frame.id(), frame.data().len());
        line.extend(frame.data().iter().map(|byte| format!("{byte:02X}")));
        line.push('\r');
        self.stream.write_all(line.as_bytes())
    }
}

/// A data frame with 11 bits; commands to the adapter are ignored.
fn parse(line: &[u8]) -> Option<Frame> {
    let digits = std::str::from_utf8(line.strip_prefix(b"t")?).ok()?;
    let id = u16::from_str_radix(digits.get(..3)?, 16).ok()?;
    let data: Vec<u8> = (4..digits.len())
        .step_by(2)
        .map(|at| digits.get(at..at + 2).and_then(|byte| u8::from_str_radix(byte, 16).ok()))
        .collect::<Option<_>>()?;
    Frame::new(id, &data)
}
