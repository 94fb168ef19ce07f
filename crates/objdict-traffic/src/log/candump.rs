//! Logs of candump: `(1436509052.249713) can0 18B#0102040811`, and `  can0  18B   [5]  01 02 04 08 11` as it prints them.

use memchr::memchr;

use super::frame::ERROR_FLAG;
use super::words::{BAD_ID, TOO_LONG, Words, bytes, decimal, digit, fits, hex, is_comment};
use super::{LogLine, LogState, LogTime, LoggedFrame};

/// A line that has no CAN-ID where one is expected.
const NO_FRAME: &str = "there is no frame in the line";

/// How times are meant.
#[derive(Debug)]
pub(super) struct Candump {
    has_distances: bool,
    now: LogTime,
}

/// Whether a line may be one of candump.
pub(super) fn begins(line: &[u8]) -> bool {
    matches!(
        Candump { has_distances: false, now: LogTime::default() }.line(line, &mut LogState::default()),
        LogLine::Frame(_)
    )
}

impl Candump {
    /// A log that begins with this line. Times that are small and go backwards in the lines behind it are distances.
    pub(super) fn new(line: &[u8], next: &[u8], has_distances: Option<bool>) -> Self {
        let lines = std::iter::once(line).chain(next.split(|byte| *byte == b'\n'));
        let times = || lines.clone().map_while(|line| Some(time(line)?.0));
        let is_short = line.get(4) == Some(&b'.');
        let goes_back = || times().zip(times().skip(1)).any(|(before, after)| after < before);
        Self {
            has_distances: has_distances.unwrap_or_else(|| is_short && goes_back()),
            now: LogTime::default(),
        }
    }

    pub(super) fn line(&mut self, line: &[u8], state: &mut LogState) -> LogLine {
        let text = line.trim_ascii();
        // what `-e` prints behind an error frame begins with a tab
        let is_other = || line.starts_with(b"\t") || text.is_empty() || is_comment(text);
        if !line.starts_with(b"(") && is_other() {
            return LogLine::Other;
        }
        self.frame(text, state).into()
    }

    fn frame(&mut self, line: &[u8], state: &mut LogState) -> Result<LoggedFrame, &'static str> {
        let (time, rest) = match line.first() {
            Some(b'(') => time(line).ok_or("the time is not a number")?,
            _ => (LogTime::default(), line),
        };
        self.now = if self.has_distances { self.now.after(time) } else { time };
        let mut words = Words(rest);
        let channel = words.next().ok_or(NO_FRAME)?;
        let id = words.next().ok_or(NO_FRAME)?;
        let frame = match id.iter().position(|byte| *byte == b'#') {
            Some(at) => logged(id_of(self.now, &id[..at])?, &id[at + 1..], words)?,
            None => printed(self.now, id, words)?,
        };
        // a word that is not a frame must not become a channel
        Ok(LoggedFrame { channel: state.channels.number(channel), ..frame })
    }
}

/// A frame without time and channel, as `cansend` takes it: `60C#40026500`.
pub(super) fn alone(line: &[u8]) -> Result<LoggedFrame, &'static str> {
    let mut words = Words(line);
    let word = words.next().ok_or(NO_FRAME)?;
    let at = memchr(b'#', word).ok_or(NO_FRAME)?;
    logged(id_of(LogTime::default(), &word[..at])?, &word[at + 1..], words)
}

/// The time at the start of a line, and what is behind it.
fn time(line: &[u8]) -> Option<(LogTime, &[u8])> {
    let line = line.trim_ascii_start().strip_prefix(b"(")?;
    let end = memchr(b')', &line[..line.len().min(40)])?;
    let text = line[..end].trim_ascii();
    let date = || {
        let at = memchr(b' ', text)?;
        LogTime::parse_date(&text[..at], text[at + 1..].trim_ascii())
    };
    Some((LogTime::parse(text, false).or_else(date)?, &line[end + 1..]))
}

/// A frame without data: 3 digits are 11 bits.
fn id_of(time: LogTime, text: &[u8]) -> Result<LoggedFrame, &'static str> {
    let is_extended = text.len() == 8;
    let number = hex(text).filter(|_| is_extended || text.len() == 3).ok_or(BAD_ID)?;
    let is_error = is_extended && number & ERROR_FLAG != 0;
    let can_id = if is_error { number & !ERROR_FLAG } else { number };
    if !fits(can_id, is_extended) {
        return Err(BAD_ID);
    }
    Ok(LoggedFrame { is_error, ..LoggedFrame::new(time, 0, can_id, is_extended && !is_error) })
}

/// What is behind the `#` of a log.
fn logged(mut frame: LoggedFrame, content: &[u8], mut words: Words<'_>) -> Result<LoggedFrame, &'static str> {
    frame.is_sent = words.next().and_then(direction);
    let digits = match content {
        // the flags are one digit
        [b'#', _, digits @ ..] => {
            frame.is_fd = true;
            digits
        }
        [b'#'] => return Err("the flags of the frame are missing"),
        [b'R', length @ ..] => {
            frame.is_remote = true;
            return match length {
                [] | [b'0'..=b'8', ..] => Ok(frame),
                _ => Err("the length of the remote frame is not a number"),
            };
        }
        _ => content,
    };
    let most = if frame.is_fd { 64 } else { 8 };
    let mut digits = digits.iter().copied();
    let mut count = 0;
    while let Some(first) = digits.next() {
        let high = match (digit(first), first) {
            (None, b'.') => continue,
            // the DLC of a frame of 8 bytes
            (None, b'_') => break,
            (high, _) => high,
        };
        let byte = high.zip(digits.next().and_then(digit));
        let (high, low) = byte.ok_or("the data are not pairs of hexadecimal digits")?;
        count += 1;
        if count > most || !frame.push(high << 4 | low) {
            return Err(TOO_LONG);
        }
    }
    Ok(frame)
}

/// A frame as candump prints it, with `-x` its direction before the CAN-ID.
fn printed(time: LogTime, first: &[u8], mut words: Words<'_>) -> Result<LoggedFrame, &'static str> {
    let is_sent = direction(first).filter(|_| first.len() == 2);
    let mut id = first;
    if is_sent.is_some() {
        // `- -` or `B E`: bit rate switch and error state
        id = words.nth(2).ok_or(NO_FRAME)?;
    }
    let mut frame = LoggedFrame { is_sent, ..id_of(time, id)? };
    let length = words.next().ok_or(NO_FRAME)?;
    let (length, digits) = match length {
        [b'[', digits @ .., b']'] | [b'{', digits @ .., b'}'] => (decimal(digits), digits.len()),
        _ => (None, 0),
    };
    let length = length.filter(|length| *length <= 64).ok_or("the length in brackets is missing")?;
    frame.is_fd = digits == 2;
    let start = words;
    if words.next() == Some(b"remote") {
        frame.is_remote = true;
        return Ok(frame);
    }
    bytes(&mut frame, &mut { start }, length)?;
    Ok(frame)
}

/// `R` or `RX` is received, `T` or `TX` is sent.
fn direction(word: &[u8]) -> Option<bool> {
    match word {
        b"R" | b"RX" => Some(false),
        b"T" | b"TX" => Some(true),
        _ => None,
    }
}
