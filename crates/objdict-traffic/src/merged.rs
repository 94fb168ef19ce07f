//! Several logs in the order of their times.

use std::io::{self, BufRead};

use crate::log::{LogForm, LogOptions, LogReader, LoggedFrame};
use objdict_model::diagnostic::plural;

/// A log with its name.
#[derive(Debug)]
pub struct NamedLog<R> {
    /// The name, for messages.
    pub name: String,
    /// Reads the frames.
    pub reader: LogReader<R>,
    /// The frame that is next, where there are other logs.
    next: Option<LoggedFrame>,
    is_over: bool,
}

impl<R: BufRead> NamedLog<R> {
    /// A log with its name.
    pub fn new(name: String, source: R, options: LogOptions) -> Self {
        Self { name, reader: LogReader::new(source, options), next: None, is_over: false }
    }

    /// Why a file that was read to its end is no log; `None` of one with frames, and of an empty one.
    pub fn problem(&self) -> Option<String> {
        let is_log = self.reader.frame_count() > 0 || self.reader.bad_count() == 0;
        (!is_log).then(|| {
            let (name, bad) = (&self.name, self.reader.bad_lines().first());
            let is_capture = matches!(self.reader.form(), Some(LogForm::Pcap | LogForm::Pcapng | LogForm::Blf));
            let reason = bad.filter(|_| is_capture).map_or_else(String::new, |bad| format!(": {}", bad.reason));
            format!(
                "`{name}` is not a log of a CAN bus{reason}\n  help: candump, ASC, BLF, MDF4, TRC, BUSMASTER, CSV of python-can and SavvyCAN, pcap and pcapng are read"
            )
        })
    }

    /// The lines that are not understood.
    pub fn warnings(&self) -> impl Iterator<Item = String> {
        let (name, known) = (&self.name, self.reader.bad_lines());
        let further = self.reader.bad_count() - known.len() as u64;
        let further = (further > 0).then(|| {
            let further = plural(usize::try_from(further).unwrap_or(usize::MAX), "further line");
            format!("{name}: {further} not understood")
        });
        known.iter().map(move |bad| format!("{name}:{}: {}", bad.line, bad.reason)).chain(further)
    }

    fn peek(&mut self) -> io::Result<Option<&LoggedFrame>> {
        if self.next.is_none() && !self.is_over {
            self.next = self.reader.next_frame()?;
            self.is_over = self.next.is_none();
        }
        Ok(self.next.as_ref())
    }
}

/// Where a frame is.
#[derive(Clone, Copy, Debug)]
pub struct Origin<'l> {
    /// The position of the log.
    pub log: usize,
    /// The number of its line, or of its packet in a capture, from 1.
    pub line: u64,
    /// The line; empty in a capture.
    pub text: &'l [u8],
}

/// Logs whose frames are taken in the order of their times; of two at one time that of the first log is first.
#[derive(Debug)]
pub struct MergedLogs<R>(pub Vec<NamedLog<R>>);

impl<R: BufRead> MergedLogs<R> {
    /// The next frame, and the position of its log.
    pub fn next_frame(&mut self) -> io::Result<Option<(usize, LoggedFrame)>> {
        // one log is not read ahead, so a frame of a live bus is there at once
        if let [log] = self.0.as_mut_slice() {
            return Ok(log.reader.next_frame()?.map(|frame| (0, frame)));
        }
        let mut first = None;
        for (at, log) in self.0.iter_mut().enumerate() {
            let Some(frame) = log.peek()? else { continue };
            if first.is_none_or(|(_, time)| frame.time < time) {
                first = Some((at, frame.time));
            }
        }
        Ok(first.and_then(|(at, _)| Some((at, self.0[at].next.take()?))))
    }

    /// Where the last frame of a log is in it.
    pub fn origin(&self, log: usize) -> Origin<'_> {
        let reader = &self.0[log].reader;
        Origin { log, line: reader.line(), text: reader.line_of_frame() }
    }

    /// The name of a channel of a log.
    pub fn channel(&self, log: usize, number: u16) -> &str {
        self.0[log].reader.channel(number)
    }
}
