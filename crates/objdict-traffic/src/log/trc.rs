//! TRC of PEAK: `1)  1059.9  Rx  0300  7  00 00 00 00 04 00 00`, in the versions 1.0 to 1.3, 2.0 and 2.1.

use super::words::{BAD_ID, Words, bytes, decimal, fd_length, fits, hex};
use super::{LogLine, LogState, LogTime, LoggedFrame};

/// The columns, with the letters of version 2: number, offset in ms, type, bus, CAN-ID, direction, reserved, length or DLC, data.
#[derive(Debug)]
pub(super) struct Trc {
    columns: Vec<u8>,
}

impl Default for Trc {
    fn default() -> Self {
        Self { columns: b"NOIlD".to_vec() }
    }
}

/// Whether a line may be the first of such a log.
pub(super) fn begins(line: &[u8]) -> bool {
    line.starts_with(b";")
}

/// The cells of a line.
#[derive(Default)]
struct Cells<'a> {
    time: &'a [u8],
    kind: &'a [u8],
    bus: &'a [u8],
    id: &'a [u8],
    direction: &'a [u8],
    length: &'a [u8],
    is_dlc: bool,
}

impl Trc {
    pub(super) fn line(&mut self, line: &[u8], state: &mut LogState) -> LogLine {
        match line.trim_ascii() {
            [] => LogLine::Other,
            [b';', header @ ..] => {
                self.header(header.trim_ascii());
                LogLine::Other
            }
            line => self.row(line, state),
        }
    }

    fn header(&mut self, header: &[u8]) {
        if let Some(columns) = header.strip_prefix(b"$COLUMNS=") {
            self.columns = columns.iter().copied().filter(u8::is_ascii_alphabetic).take(16).collect();
        }
        let columns: &[u8] = match header.strip_prefix(b"$FILEVERSION=").map(<[u8]>::trim_ascii) {
            Some(b"1.1") => b"NOdIlD",
            Some(b"1.2") => b"NOBdIlD",
            Some(b"1.3") => b"NOBdIRlD",
            Some(b"2.0") => b"NOTIdlD",
            Some(b"2.1") => b"NOTBIdRLD",
            _ => return,
        };
        self.columns = columns.to_vec();
    }

    fn row(&self, line: &[u8], state: &mut LogState) -> LogLine {
        let mut words = Words(line);
        let mut cells = Cells::default();
        for column in self.columns.iter().filter(|column| **column != b'D') {
            let cell = words.next().unwrap_or_default();
            match column {
                b'O' => cells.time = cell,
                b'T' => cells.kind = cell,
                b'B' => cells.bus = cell,
                b'I' => cells.id = cell,
                b'd' => cells.direction = cell,
                b'l' | b'L' => (cells.length, cells.is_dlc) = (cell, *column == b'L'),
                _ => {}
            }
        }
        // statuses, warnings and events are not frames
        if matches!(cells.kind, b"ST" | b"EC" | b"EV")
            || matches!(cells.direction, b"Warng" | b"Event" | b"Status")
        {
            return LogLine::Other;
        }
        frame(&cells, words, state).into()
    }
}

fn frame(cells: &Cells<'_>, mut words: Words<'_>, state: &mut LogState) -> Result<LoggedFrame, &'static str> {
    let time = LogTime::parse(cells.time, true).ok_or("the time is not a number")?;
    // version 1.0 writes error frames and statuses under this CAN-ID
    let is_error = cells.kind == b"ER" || cells.direction == b"Error" || cells.id == b"FFFFFFFF";
    let is_extended = !is_error && cells.id.len() > 4;
    let can_id = if is_error { Some(0) } else { hex(cells.id).filter(|id| fits(*id, is_extended)) };
    let length = decimal(cells.length).ok_or("the length is not a number");
    let length = if is_error { 0 } else { length? };
    let start = words;
    let frame = LoggedFrame {
        is_error,
        is_remote: cells.kind == b"RR" || words.next() == Some(b"RTR"),
        is_fd: matches!(cells.kind, b"FD" | b"FB" | b"FE" | b"BI"),
        is_sent: match cells.direction {
            b"Rx" => Some(false),
            b"Tx" => Some(true),
            _ => None,
        },
        ..LoggedFrame::new(time, 0, can_id.ok_or(BAD_ID)?, is_extended)
    };
    let mut frame = LoggedFrame { channel: state.channels.number(cells.bus), ..frame };
    let length = match length {
        code if cells.is_dlc && frame.is_fd => fd_length(code),
        _ if frame.is_remote => 0,
        length => length,
    };
    bytes(&mut frame, &mut { start }, length)?;
    Ok(frame)
}
