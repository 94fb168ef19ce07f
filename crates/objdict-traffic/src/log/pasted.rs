//! Frames as other programs show them: messages of python-can, `132.000074  60C  40 02 65 00` of many, also of `objdict decode`,
//! `60C#40026500`, and CSV of SavvyCAN.

use super::candump;
use super::words::{BAD_ID, TOO_LONG, Words, bytes, decimal, digit, fits, hex, is_comment};
use super::{LogLine, LogState, LogTime, LoggedFrame};

const HEADING: &[u8] = b"Time Stamp,ID,Extended,";
const TIMESTAMP: &[u8] = b"Timestamp:";

pub(super) const BAD_TIME: &str = "the time is not a number";
pub(super) const BAD_LENGTH: &str = "the length is not a number";

/// What the lines are.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pasted {
    Message,
    Words,
    /// Frames alone, as `cansend` takes them.
    Frames,
    /// Whether the direction is a column.
    Savvy(bool),
}

impl Pasted {
    /// The log that begins with this line.
    pub(super) fn of(line: &[u8]) -> Option<Self> {
        if let Some(columns) = line.strip_prefix(HEADING) {
            return Some(Self::Savvy(columns.starts_with(b"Dir,")));
        }
        if line.starts_with(TIMESTAMP) {
            return Some(Self::Message);
        }
        if candump::alone(line).is_ok() {
            return Some(Self::Frames);
        }
        words(line, &mut LogState::default()).is_ok().then_some(Self::Words)
    }

    pub(super) fn line(self, line: &[u8], state: &mut LogState) -> LogLine {
        let line = line.trim_ascii();
        match self {
            _ if line.is_empty() || is_comment(line) || line.starts_with(HEADING) => LogLine::Other,
            Self::Frames => candump::alone(line).into(),
            Self::Message => message(line, state).into(),
            Self::Words => words(line, state).into(),
            Self::Savvy(has_direction) => row(line, has_direction, state).into(),
        }
    }
}

/// `Timestamp: 1699584944.440580    ID: 0701    S Rx                DL:  1    00    Channel: can0`
fn message(line: &[u8], state: &mut LogState) -> Result<LoggedFrame, &'static str> {
    let mut words = Words(line);
    let time = words.nth(1).and_then(|word| LogTime::parse(word, false)).ok_or(BAD_TIME)?;
    let can_id = words.nth(1).and_then(hex).ok_or(BAD_ID)?;
    let flags: Vec<&[u8]> = words.by_ref().take_while(|word| *word != b"DL:").collect();
    let has = |flag: &[u8]| flags.contains(&flag);
    let is_extended = has(b"X");
    if !fits(can_id, is_extended) {
        return Err(BAD_ID);
    }
    let mut frame = LoggedFrame::new(time, 0, can_id, is_extended);
    (frame.is_error, frame.is_remote, frame.is_fd) = (has(b"E"), has(b"R"), has(b"F"));
    frame.is_sent = (has(b"Rx") || has(b"Tx")).then(|| has(b"Tx"));
    let length = words.next().and_then(decimal).ok_or(BAD_LENGTH)?;
    if !frame.is_remote {
        bytes(&mut frame, &mut words, length)?;
    }
    let channel = words.skip_while(|word| *word != b"Channel:").nth(1);
    Ok(LoggedFrame { channel: state.channels.number(channel.unwrap_or_default()), ..frame })
}

/// Time, perhaps the channel, CAN-ID and bytes with single blanks between them; what is behind two blanks is a text.
fn words(line: &[u8], state: &mut LogState) -> Result<LoggedFrame, &'static str> {
    let mut words = Words(line);
    let time = words.next().filter(|word| word.contains(&b'.')).and_then(|word| LogTime::parse(word, false));
    let time = time.ok_or(BAD_TIME)?;
    let is_id = |word: &&[u8]| matches!(word.len(), 3 | 8) && hex(word).is_some();
    let first = words.next().ok_or(BAD_ID)?;
    let (channel, id) = match Some(first).filter(is_id) {
        Some(id) => (&[][..], id),
        None => (first, words.next().filter(is_id).ok_or(BAD_ID)?),
    };
    let is_extended = id.len() == 8;
    let can_id = hex(id).filter(|id| fits(*id, is_extended)).ok_or(BAD_ID)?;
    let mut frame = LoggedFrame::new(time, state.channels.number(channel), can_id, is_extended);
    let mut rest = words.0.trim_ascii_start();
    // as `objdict decode` prints it
    (frame.is_remote, frame.is_error) = (rest.starts_with(b"remote"), rest.starts_with(b"error frame"));
    while !rest.is_empty() {
        let end = rest.iter().position(|byte| *byte == b' ').unwrap_or(rest.len());
        let byte = if let [high, low] = rest[..end] { digit(high).zip(digit(low)) } else { None };
        let Some((high, low)) = byte else {
            // without data the text follows
            let has_none = frame.data().is_empty();
            return has_none.then_some(frame).ok_or("the data are not bytes in hexadecimal digits");
        };
        if frame.data().len() == 8 || !frame.push(high << 4 | low) {
            return Err(TOO_LONG);
        }
        rest = rest.get(end + 1..).filter(|rest| !rest.starts_with(b" ")).unwrap_or_default();
    }
    Ok(frame)
}

/// `166064000,00000701,false,Rx,0,1,00,,,,,,,`: the time in microseconds.
fn row(line: &[u8], has_direction: bool, state: &mut LogState) -> Result<LoggedFrame, &'static str> {
    let mut cells = line.split(|byte| *byte == b',').map(<[u8]>::trim_ascii);
    let mut cell = || cells.next().unwrap_or_default();
    let time = std::str::from_utf8(cell()).ok().and_then(|time| time.parse::<i64>().ok());
    let time = time.and_then(|time| time.checked_mul(1000)).ok_or(BAD_TIME)?;
    let id = hex(cell()).ok_or(BAD_ID)?;
    let is_extended = cell() == b"true";
    if !fits(id, is_extended) {
        return Err(BAD_ID);
    }
    let is_sent = has_direction.then(|| cell() == b"Tx");
    let channel = state.channels.number(cell());
    let mut frame =
        LoggedFrame { is_sent, ..LoggedFrame::new(LogTime::new(time, 6), channel, id, is_extended) };
    let length = decimal(cell()).ok_or(BAD_LENGTH)?;
    let row: Vec<&[u8]> = cells.collect();
    let data = row.join(&b' ');
    bytes(&mut frame, &mut Words(&data), length)?;
    frame.is_fd = frame.data().len() > 8;
    Ok(frame)
}
