//! CSV of python-can: `1436509052.249713,0x18b,0,0,0,5,AQIECBE=`.

use super::words::{BAD_ID, TOO_LONG, fits, hex};
use super::{LogLine, LogState, LogTime, LoggedFrame};

const HEADING: &[u8] = b"timestamp,arbitration_id,extended,remote,error,dlc,data";

/// A CSV log.
#[derive(Debug)]
pub(super) struct Csv;

impl Csv {
    /// The log that begins with this line.
    pub(super) fn of(line: &[u8]) -> Option<Self> {
        (line == HEADING || line.split(|byte| *byte == b',').count() == 7).then_some(Self)
    }

    pub(super) fn line(&self, line: &[u8], state: &mut LogState) -> LogLine {
        match line.trim_ascii() {
            HEADING | [] => LogLine::Other,
            line => frame(line, state).into(),
        }
    }
}

fn frame(line: &[u8], state: &mut LogState) -> Result<LoggedFrame, &'static str> {
    let mut cells = line.split(|byte| *byte == b',');
    let mut cell = || cells.next().unwrap_or_default();
    let time = LogTime::parse(cell(), false).ok_or("the time is not a number")?;
    let id = cell();
    let can_id = id.strip_prefix(b"0x").or_else(|| id.strip_prefix(b"0X")).and_then(hex).ok_or(BAD_ID)?;
    let [is_extended, is_remote, is_error] = [cell(), cell(), cell()].map(|cell| cell == b"1");
    let (_length, text) = (cell(), cell());
    if !fits(can_id, is_extended) {
        return Err(BAD_ID);
    }
    let frame = LoggedFrame::new(time, state.channels.number(b""), can_id, is_extended);
    let mut frame = LoggedFrame { is_remote, is_error, ..frame };
    base64(&mut frame, text)?;
    frame.is_fd = frame.data().len() > 8;
    Ok(frame)
}

/// The bytes of a text in base 64.
fn base64(frame: &mut LoggedFrame, text: &[u8]) -> Result<(), &'static str> {
    let (mut bits, mut count) = (0_u32, 0);
    let end = text.iter().position(|byte| *byte == b'=').unwrap_or(text.len());
    for &byte in &text[..end] {
        let six = match byte {
            b'A'..=b'Z' => byte - b'A',
            b'a'..=b'z' => byte - b'a' + 26,
            b'0'..=b'9' => byte - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return Err("the data are not base 64"),
        };
        bits = bits << 6 | u32::from(six);
        count += 6;
        if count >= 8 {
            count -= 8;
            if !frame.push((bits >> count) as u8) {
                return Err(TOO_LONG);
            }
        }
    }
    Ok(())
}
