//! Logs of CAN buses: the frames that tools recorded, in the forms of several of them, and their times as the log has them.
//!
//! A log is read frame by frame in constant memory, so it may be a pipe that never ends; only MDF4 is read whole. Its form is recognised by its content.

mod asc;
mod blf;
mod busmaster;
mod candump;
mod csv;
mod frame;
mod mdf;
mod pasted;
mod pcap;
mod text;
mod time;
mod trc;
mod words;

use std::borrow::Cow;
use std::io::{self, BufRead};

use memchr::memchr;

use self::blf::Blf;
pub use self::frame::LoggedFrame;
use self::mdf::Mdf;
use self::pcap::Capture;
use self::text::TextLog;
pub use self::time::LogTime;

/// The most bad lines that are kept; more are counted.
pub const MAX_BAD_LINES: usize = 20;

/// The longest line: a frame of 64 bytes takes 300 bytes in the longest form.
const MAX_LINE: usize = 4096;

/// The most names of channels.
const MAX_CHANNELS: usize = 256;

objdict_model::named! {
    /// The form of a log.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum LogForm {
        /// candump of can-utils, as it prints or as it logs (`-l`, `-L`).
        Candump = "candump log",
        /// ASC of Vector.
        Asc = "ASC",
        /// TRC of PEAK, 1.0 to 2.1.
        Trc = "TRC",
        /// CSV of python-can.
        Csv = "CSV of python-can",
        /// CSV of SavvyCAN.
        Savvy = "CSV of SavvyCAN",
        /// Messages as python-can prints them.
        Message = "messages of python-can",
        /// Time, CAN-ID and bytes.
        Words = "pasted frames",
        /// Logs of BUSMASTER.
        Busmaster = "log of BUSMASTER",
        /// BLF of Vector.
        Blf = "BLF",
        /// MDF 4 of ASAM.
        Mdf = "MDF4",
        /// pcap with frames of SocketCAN.
        Pcap = "pcap",
        /// pcapng with frames of SocketCAN.
        Pcapng = "pcapng",
    }
}

/// How a log is read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LogOptions {
    /// Whether the times of a candump log are distances from the frame before (`-td`). Without it the first lines decide.
    pub has_distances: Option<bool>,
}

/// A line, or a record of a capture, that is not understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadLine {
    /// The number of the line or record, from 1.
    pub line: u64,
    /// Why it is not understood.
    pub reason: Cow<'static, str>,
}

/// What a line is.
enum LogLine {
    Frame(LoggedFrame),
    /// A comment or an event that is not a frame.
    Other,
    Bad(&'static str),
}

/// Reads the frames of a log in its order.
#[derive(Debug)]
pub struct LogReader<R> {
    source: R,
    content: LogContent,
    state: LogState,
    /// The start of a line that is not complete.
    partial: Vec<u8>,
    /// The line of the last frame; empty in a capture.
    line_of_frame: Vec<u8>,
}

#[derive(Debug)]
enum LogContent {
    /// Nothing was read yet.
    Unknown,
    Text(TextLog),
    Capture(Capture),
    Blf(Blf),
    Mdf(Mdf),
}

/// What is known of a log.
#[derive(Debug, Default)]
struct LogState {
    options: LogOptions,
    channels: ChannelNames,
    line: u64,
    frames: u64,
    bad: Vec<BadLine>,
    bad_count: u64,
}

/// The names of channels by number.
#[derive(Debug, Default)]
struct ChannelNames {
    names: Vec<String>,
    last: usize,
}

impl ChannelNames {
    /// The number of a channel; of too many all others are one.
    fn number(&mut self, name: &[u8]) -> u16 {
        let is_it = |at: usize| self.names.get(at).is_some_and(|known| known.as_bytes() == name);
        if !is_it(self.last) {
            let found = (0..self.names.len()).find(|&at| is_it(at));
            self.last = found.unwrap_or_else(|| {
                let is_full = self.names.len() >= MAX_CHANNELS;
                if !is_full {
                    self.names.push(String::from_utf8_lossy(name).into_owned());
                }
                self.names.len() - 1
            });
        }
        self.last as u16
    }
}

impl LogState {
    fn bad(&mut self, reason: impl Into<Cow<'static, str>>) {
        self.bad_count += 1;
        if self.bad.len() < MAX_BAD_LINES {
            self.bad.push(BadLine { line: self.line, reason: reason.into() });
        }
    }
}

impl<R: BufRead> LogReader<R> {
    /// A reader of a log.
    pub fn new(source: R, options: LogOptions) -> Self {
        let state = LogState { options, ..LogState::default() };
        Self { source, content: LogContent::Unknown, state, partial: Vec::new(), line_of_frame: Vec::new() }
    }

    /// The next frame; `None` at the end. Lines that are not understood are passed over and [counted](Self::bad_count).
    ///
    /// # Errors
    /// When the log cannot be read.
    pub fn next_frame(&mut self) -> io::Result<Option<LoggedFrame>> {
        let frame = self.next_known()?;
        self.state.frames += u64::from(frame.is_some());
        Ok(frame)
    }

    fn next_known(&mut self) -> io::Result<Option<LoggedFrame>> {
        loop {
            match &mut self.content {
                LogContent::Unknown => {
                    let start = self.source.fill_buf()?;
                    self.content = match Capture::of(start) {
                        Some(capture) => LogContent::Capture(capture),
                        None if blf::begins(start) => LogContent::Blf(Blf::default()),
                        None if mdf::begins(start) => LogContent::Mdf(Mdf::default()),
                        None => LogContent::Text(TextLog::default()),
                    };
                }
                LogContent::Capture(capture) => {
                    return capture.next_frame(&mut self.source, &mut self.state);
                }
                LogContent::Blf(blf) => return blf.next_frame(&mut self.source, &mut self.state),
                LogContent::Mdf(mdf) => return mdf.next_frame(&mut self.source, &mut self.state),
                LogContent::Text(_) => match self.next_line()? {
                    Some(LogLine::Frame(frame)) => return Ok(Some(frame)),
                    Some(LogLine::Bad(reason)) => self.state.bad(reason),
                    Some(LogLine::Other) => {}
                    None => return Ok(None),
                },
            }
        }
    }

    /// Reads a line where it is in the buffer, or puts its parts together.
    fn next_line(&mut self) -> io::Result<Option<LogLine>> {
        let LogContent::Text(log) = &mut self.content else { return Ok(None) };
        loop {
            let buffer = self.source.fill_buf()?;
            if buffer.is_empty() {
                let rest = std::mem::take(&mut self.partial);
                if rest.is_empty() {
                    return Ok(None);
                }
                self.state.line += 1;
                let line = log.line(&rest, &[], &mut self.state);
                self.line_of_frame = rest;
                return Ok(Some(line));
            }
            let Some(end) = memchr(b'\n', buffer) else {
                let count = buffer.len();
                // a byte more than the longest line marks it as too long
                let wanted = (MAX_LINE + 1).saturating_sub(self.partial.len());
                self.partial.extend(&buffer[..count.min(wanted)]);
                self.source.consume(count);
                continue;
            };
            self.state.line += 1;
            self.line_of_frame.clear();
            let line = if self.partial.is_empty() {
                self.line_of_frame.extend(&buffer[..end]);
                log.line(&buffer[..end], &buffer[end + 1..], &mut self.state)
            } else {
                let wanted = (MAX_LINE + 1).saturating_sub(self.partial.len());
                self.partial.extend(&buffer[..end.min(wanted)]);
                std::mem::swap(&mut self.line_of_frame, &mut self.partial);
                log.line(&self.line_of_frame, &buffer[end + 1..], &mut self.state)
            };
            self.source.consume(end + 1);
            return Ok(Some(line));
        }
    }

    /// The form; `None` until the first frame.
    pub fn form(&self) -> Option<LogForm> {
        match &self.content {
            LogContent::Unknown => None,
            LogContent::Text(log) => log.form(),
            LogContent::Capture(capture) => Some(capture.form()),
            LogContent::Blf(_) => Some(LogForm::Blf),
            LogContent::Mdf(_) => Some(LogForm::Mdf),
        }
    }

    /// The name of a channel.
    pub fn channel(&self, number: u16) -> &str {
        self.state.channels.names.get(usize::from(number)).map_or("", String::as_str)
    }

    /// The first lines that are not understood, at most [`MAX_BAD_LINES`].
    pub fn bad_lines(&self) -> &[BadLine] {
        &self.state.bad
    }

    /// The number of lines that are not understood.
    pub fn bad_count(&self) -> u64 {
        self.state.bad_count
    }

    /// The number of frames that were read.
    pub fn frame_count(&self) -> u64 {
        self.state.frames
    }

    /// The number of the last line or record, from 1.
    pub fn line(&self) -> u64 {
        self.state.line
    }

    /// The line of the last frame, without its end; empty in a capture, which has no lines.
    pub fn line_of_frame(&self) -> &[u8] {
        self.line_of_frame.trim_ascii_end()
    }
}

impl<R: BufRead> Iterator for LogReader<R> {
    type Item = io::Result<LoggedFrame>;

    fn next(&mut self) -> Option<Self::Item> {
        self.next_frame().transpose()
    }
}

#[cfg(test)]
mod tests;
