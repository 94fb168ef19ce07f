//! Logs in lines of text: which form they have.

use super::pasted::Pasted;
use super::words::is_comment;
use super::{LogForm, LogLine, LogState, LoggedFrame, MAX_LINE};
use super::{asc, busmaster, candump, csv, trc};

/// A log whose form its first lines say.
#[derive(Debug, Default)]
pub(super) enum TextLog {
    #[default]
    Unknown,
    Candump(candump::Candump),
    Asc(asc::Asc),
    Trc(trc::Trc),
    Csv(csv::Csv),
    Pasted(Pasted),
    Busmaster(busmaster::Busmaster),
}

impl TextLog {
    pub(super) fn form(&self) -> Option<LogForm> {
        match self {
            Self::Unknown => None,
            Self::Candump(_) => Some(LogForm::Candump),
            Self::Asc(_) => Some(LogForm::Asc),
            Self::Trc(_) => Some(LogForm::Trc),
            Self::Csv(_) => Some(LogForm::Csv),
            Self::Busmaster(_) => Some(LogForm::Busmaster),
            Self::Pasted(Pasted::Frames) => Some(LogForm::Candump),
            Self::Pasted(Pasted::Message) => Some(LogForm::Message),
            Self::Pasted(Pasted::Words) => Some(LogForm::Words),
            Self::Pasted(Pasted::Savvy(_)) => Some(LogForm::Savvy),
        }
    }

    /// What a line is. `next` is what is read of the lines behind it.
    pub(super) fn line(&mut self, line: &[u8], next: &[u8], state: &mut LogState) -> LogLine {
        if line.len() > MAX_LINE {
            return LogLine::Bad("the line is too long");
        }
        let line = line.strip_prefix(b"\xEF\xBB\xBF").filter(|_| state.line == 1).unwrap_or(line);
        match self {
            Self::Candump(log) => log.line(line, state),
            Self::Asc(log) => log.line(line, state),
            Self::Trc(log) => log.line(line, state),
            Self::Csv(log) => log.line(line, state),
            Self::Pasted(log) => log.line(line, state),
            Self::Busmaster(log) => log.line(line, state),
            Self::Unknown => self.first(line, next, state),
        }
    }

    /// A line before the form is known.
    fn first(&mut self, line: &[u8], next: &[u8], state: &mut LogState) -> LogLine {
        let text = line.trim_ascii();
        if text.is_empty() || text.starts_with(b"#") || is_comment(text) && is_before_frames(next) {
            return LogLine::Other;
        }
        *self = if let Some(log) = csv::Csv::of(text) {
            Self::Csv(log)
        } else if trc::begins(text) {
            Self::Trc(trc::Trc::default())
        } else if asc::begins(text) {
            Self::Asc(asc::Asc::default())
        } else if candump::begins(text) {
            Self::Candump(candump::Candump::new(text, next, state.options.has_distances))
        } else if busmaster::begins(text) {
            Self::Busmaster(busmaster::Busmaster::default())
        } else if let Some(log) = Pasted::of(text) {
            Self::Pasted(log)
        } else {
            return LogLine::Bad("the form of the log is not known");
        };
        self.line(line, next, state)
    }
}

/// Whether the first line that is no comment has a frame: heads of TRC (`;`) and ASC (`//`) look like comments.
fn is_before_frames(lines: &[u8]) -> bool {
    let mut lines = lines.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !line.is_empty() && !is_comment(line));
    first.is_some_and(|line| {
        candump::begins(line) || csv::Csv::of(line).is_some() || Pasted::of(line).is_some()
    })
}

impl From<Result<LoggedFrame, &'static str>> for LogLine {
    fn from(result: Result<LoggedFrame, &'static str>) -> Self {
        match result {
            Ok(frame) => Self::Frame(frame),
            Err(reason) => Self::Bad(reason),
        }
    }
}
