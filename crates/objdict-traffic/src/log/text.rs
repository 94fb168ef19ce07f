//! Logs in lines of text: which form they have.

use super::pasted::Pasted;
use super::{LogForm, LogLine, LogState, LoggedFrame, MAX_LINE};
use super::{asc, candump, csv, trc};

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
}

impl TextLog {
    pub(super) fn form(&self) -> Option<LogForm> {
        match self {
            Self::Unknown => None,
            Self::Candump(_) => Some(LogForm::Candump),
            Self::Asc(_) => Some(LogForm::Asc),
            Self::Trc(_) => Some(LogForm::Trc),
            Self::Csv(_) => Some(LogForm::Csv),
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
            Self::Unknown => self.first(line, next, state),
        }
    }

    /// A line before the form is known.
    fn first(&mut self, line: &[u8], next: &[u8], state: &mut LogState) -> LogLine {
        let text = line.trim_ascii();
        if text.is_empty() {
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
        } else if let Some(log) = Pasted::of(text) {
            Self::Pasted(log)
        } else {
            return LogLine::Bad("the form of the log is not known");
        };
        self.line(line, next, state)
    }
}

impl From<Result<LoggedFrame, &'static str>> for LogLine {
    fn from(result: Result<LoggedFrame, &'static str>) -> Self {
        match result {
            Ok(frame) => Self::Frame(frame),
            Err(reason) => Self::Bad(reason),
        }
    }
}
