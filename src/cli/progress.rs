//! How far a check is: one line on the terminal, which goes away.

use std::io::{IsTerminal, Write, stderr, stdout};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Nobody waits for less.
const PATIENCE: Duration = Duration::from_secs(1);

/// The line changes no more often.
const PACE: Duration = Duration::from_millis(100);

/// Counts files, and says so on the standard error when it takes long and somebody looks.
pub(super) struct Progress {
    total: usize,
    done: AtomicUsize,
    start: Instant,
    line: Mutex<Line>,
}

/// What stands on the terminal.
pub(super) struct Line {
    is_wanted: bool,
    shown: Option<Instant>,
}

impl Progress {
    pub(super) fn new(total: usize) -> Self {
        let is_dumb = std::env::var_os("TERM").is_none_or(|term| term == "dumb");
        let is_wanted = total > 1 && stderr().is_terminal() && !is_dumb;
        let line = Mutex::new(Line { is_wanted, shown: None });
        Self { total, done: AtomicUsize::new(0), start: Instant::now(), line }
    }

    /// One more file is done. No thread waits for another because of it.
    pub(super) fn step(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        if let Ok(mut line) = self.line.try_lock()
            && line.is_wanted
            && self.start.elapsed() > PATIENCE
            && line.shown.is_none_or(|shown| shown.elapsed() > PACE)
        {
            line.shown = Some(Instant::now());
            line.write(&format!("\r\x1B[Kchecked {done} of {} files", self.total));
        }
    }

    /// Takes the line away and keeps it away as long as the answer lives, for something else is written.
    pub(super) fn hide(&self) -> MutexGuard<'_, Line> {
        let mut line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
        if line.shown.take().is_some() {
            line.write("\r\x1B[K");
        }
        line
    }
}

impl Line {
    /// Results are written: on a terminal they show the progress themselves, and a line among them would damage them.
    pub(super) fn give_way(&mut self) {
        self.is_wanted &= !stdout().is_terminal();
    }

    fn write(&self, text: &str) {
        // nobody is left to read it when this fails
        let _ = stderr().write_all(text.as_bytes());
    }
}
