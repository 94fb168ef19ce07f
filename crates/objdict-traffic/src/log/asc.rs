//! ASC of Vector: `0.015991 1  18B  Rx  d 5 01 02 04 08 11`.

use super::words::{BAD_ID, TOO_LONG, Words, decimal, fits, hex};
use super::{LogLine, LogState, LogTime, LoggedFrame};

/// First words of lines that are not frames.
const HEADERS: [&[u8]; 8] = [b"date", b"base", b"internal", b"no", b"begin", b"end", b"//", b"previous"];

/// Words behind the time of events that are not frames.
const EVENTS: [&[u8]; 12] = [
    b"start",
    b"statistic:",
    b"can",
    b"log",
    b"canfd-statistic",
    b"sv:",
    b"lin",
    b"j1939tp",
    b"trigger",
    b"gps",
    b"//",
    b"%",
];

/// What the first lines say.
#[derive(Debug, Default)]
pub(super) struct Asc {
    is_decimal: bool,
    /// Whether times are distances.
    is_relative: bool,
    now: LogTime,
}

/// Whether a line may be the first of such a log.
pub(super) fn begins(line: &[u8]) -> bool {
    let first = Words(line).next().unwrap_or_default();
    let is_header =
        HEADERS[..2].iter().any(|word| first.eq_ignore_ascii_case(word)) || line.starts_with(b"//");
    // the head of a log may be cut off
    is_header || matches!(Asc::default().line(line, &mut LogState::default()), LogLine::Frame(_))
}

impl Asc {
    pub(super) fn line(&mut self, line: &[u8], state: &mut LogState) -> LogLine {
        let mut words = Words(line);
        let Some(first) = words.next() else { return LogLine::Other };
        if first.starts_with(b"//") || HEADERS.iter().any(|word| first.eq_ignore_ascii_case(word)) {
            self.header(first, words);
            return LogLine::Other;
        }
        let Some(time) = LogTime::parse(first, false) else {
            return LogLine::Bad("the time is not a number");
        };
        self.now = if self.is_relative { self.now.after(time) } else { time };
        self.event(words, state)
    }

    fn header(&mut self, first: &[u8], mut words: Words<'_>) {
        if first.eq_ignore_ascii_case(b"base") {
            self.is_decimal = words.next().is_some_and(|base| base.eq_ignore_ascii_case(b"dec"));
            self.is_relative = words.nth(1).is_some_and(|word| word.eq_ignore_ascii_case(b"relative"));
        }
    }

    fn event(&self, mut words: Words<'_>, state: &mut LogState) -> LogLine {
        let Some(channel) = words.next() else { return LogLine::Bad("the channel is missing") };
        if channel.eq_ignore_ascii_case(b"CANFD") {
            return self.fd_frame(words, state).into();
        }
        let is_event = |word: &[u8]| EVENTS.iter().any(|event| word.eq_ignore_ascii_case(event));
        let mut next = words;
        let second = next.next().unwrap_or_default();
        if is_event(channel) || is_event(second) {
            return LogLine::Other;
        }
        if decimal(channel).is_none() {
            return LogLine::Bad("the channel is not a number");
        }
        self.frame(channel, words, state).into()
    }

    /// `18B  Rx  d 5 01 02 04 08 11`, `18B Rx r` or `ErrorFrame`.
    fn frame(
        &self,
        channel: &[u8],
        mut words: Words<'_>,
        state: &mut LogState,
    ) -> Result<LoggedFrame, &'static str> {
        let id = words.next().unwrap_or_default();
        if id.eq_ignore_ascii_case(b"ErrorFrame") {
            let frame = LoggedFrame::new(self.now, state.channels.number(channel), 0, false);
            return Ok(LoggedFrame { is_error: true, ..frame });
        }
        let mut frame = self.id(id)?;
        frame.is_sent = direction(words.next())?;
        match words.next() {
            Some(b"r" | b"R") => frame.is_remote = true,
            Some(b"d" | b"D") => {
                let length =
                    words.next().and_then(|word| self.number(word)).ok_or("the length is missing")?;
                self.data(&mut frame, &mut words, length.min(8))?;
            }
            _ => return Err("there is neither `d` nor `r` behind the direction"),
        }
        frame.channel = state.channels.number(channel);
        Ok(frame)
    }

    /// `3 Tx 50005x [NAME] 0 0 5 5 01 02 04 08 11`, or `3 Tx ErrorFrame`.
    fn fd_frame(&self, mut words: Words<'_>, state: &mut LogState) -> Result<LoggedFrame, &'static str> {
        let channel =
            words.next().filter(|channel| decimal(channel).is_some()).ok_or("the channel is missing")?;
        let is_sent = direction(words.next())?;
        let id = words.next().unwrap_or_default();
        if id.eq_ignore_ascii_case(b"ErrorFrame") {
            let frame = LoggedFrame::new(self.now, state.channels.number(channel), 0, false);
            return Ok(LoggedFrame { is_error: true, is_sent, ..frame });
        }
        let mut frame = LoggedFrame { is_sent, ..self.id(id)? };
        // bit rate switch and error state are behind a name, if there is one
        let flag = words.next().unwrap_or_default();
        words.nth(usize::from(!matches!(flag, b"0" | b"1")));
        let dlc = words.next().and_then(hex).ok_or("the DLC is missing")?;
        let length = words.next().and_then(decimal).ok_or("the length is missing")?;
        self.data(&mut frame, &mut words, length)?;
        frame.is_remote = length == 0 && dlc != 0;
        // bit 12 of the flags, which are behind duration and length, says that it is one of CAN FD
        let flags = words.nth(2).and_then(hex);
        frame.is_fd = flags.is_none_or(|flags| flags >> 12 & 1 == 1 || length > 8);
        frame.channel = state.channels.number(channel);
        Ok(frame)
    }

    fn id(&self, text: &[u8]) -> Result<LoggedFrame, &'static str> {
        let (digits, is_extended) = match text {
            [digits @ .., b'x' | b'X'] => (digits, true),
            _ => (text, false),
        };
        let can_id = self.number(digits).filter(|can_id| fits(*can_id, is_extended)).ok_or(BAD_ID)?;
        Ok(LoggedFrame::new(self.now, 0, can_id, is_extended))
    }

    fn number(&self, text: &[u8]) -> Option<u32> {
        if self.is_decimal { decimal(text) } else { hex(text) }
    }

    fn data(&self, frame: &mut LoggedFrame, words: &mut Words<'_>, length: u32) -> Result<(), &'static str> {
        for _ in 0..length {
            let byte = words.next().and_then(|word| u8::try_from(self.number(word)?).ok());
            if !frame.push(byte.ok_or("a byte of the data is missing or not a number")?) {
                return Err(TOO_LONG);
            }
        }
        Ok(())
    }
}

/// `Rx` or `Tx`; a request to send is `TxRq`.
fn direction(word: Option<&[u8]>) -> Result<Option<bool>, &'static str> {
    match word {
        Some(b"Rx") => Ok(Some(false)),
        Some(b"Tx" | b"TxRq") => Ok(Some(true)),
        _ => Err("there is neither `Rx` nor `Tx` behind the CAN-ID"),
    }
}
