//! Logs of BUSMASTER: `10:48:41:6660 Rx 1 0x701 s 1 05`.

use super::pasted::{BAD_LENGTH, BAD_TIME};
use super::words::{BAD_ID, Words, bytes, decimal, fits, hex};
use super::{LogLine, LogState, LogTime, LoggedFrame};

/// How such a log begins.
const HEADING: &[u8] = b"***BUSMASTER";

/// What the lines with asterisks say.
#[derive(Debug, Default)]
pub(super) struct Busmaster {
    is_decimal: bool,
    /// Whether times are distances.
    is_relative: bool,
    now: LogTime,
}

/// Whether a line is the first of such a log.
pub(super) fn begins(line: &[u8]) -> bool {
    line.starts_with(HEADING)
}

impl Busmaster {
    pub(super) fn line(&mut self, line: &[u8], state: &mut LogState) -> LogLine {
        match line.trim_ascii() {
            b"***DEC***" => self.is_decimal = true,
            b"***RELATIVE MODE***" => self.is_relative = true,
            [] | [b'*', ..] => {}
            line => return self.frame(line, state).into(),
        }
        LogLine::Other
    }

    fn frame(&mut self, line: &[u8], state: &mut LogState) -> Result<LoggedFrame, &'static str> {
        let mut words = Words(line);
        let time = words.next().and_then(of_day).ok_or(BAD_TIME)?;
        self.now = if self.is_relative { self.now.after(time) } else { time };
        let direction = words.next();
        let channel = state.channels.number(words.next().unwrap_or_default());
        let id = words.next().unwrap_or_default();
        let number = |text: &[u8]| if self.is_decimal { decimal(text) } else { hex(text) };
        let id = number(id.strip_prefix(b"0x").unwrap_or(id)).ok_or(BAD_ID)?;
        let kind = words.next().unwrap_or_default();
        let (is_extended, is_remote) = (kind.starts_with(b"x"), kind.ends_with(b"r"));
        if !fits(id, is_extended) {
            return Err(BAD_ID);
        }
        let length = words.next().and_then(decimal).ok_or(BAD_LENGTH)?;
        let mut frame = LoggedFrame::new(self.now, channel, id, is_extended);
        (frame.is_remote, frame.is_sent) = (is_remote, Some(direction == Some(b"Tx")));
        if is_remote {
            return Ok(frame);
        }
        if self.is_decimal {
            for _ in 0..length.min(8) {
                let byte = words.next().and_then(|word| u8::try_from(decimal(word)?).ok());
                frame.push(byte.ok_or("a byte of the data is missing or not a number")?);
            }
        } else {
            bytes(&mut frame, &mut words, length)?;
        }
        Ok(frame)
    }
}

/// Hours, minutes, seconds and tenths of milliseconds.
fn of_day(text: &[u8]) -> Option<LogTime> {
    let mut parts = text.split(|byte| *byte == b':').map(decimal);
    let mut part = || parts.next()?.map(i64::from);
    let [hours, minutes, seconds, fraction] = [part()?, part()?, part()?, part()?];
    Some(LogTime::new((((hours * 60 + minutes) * 60 + seconds) * 10_000 + fraction) * 100_000, 4))
}
