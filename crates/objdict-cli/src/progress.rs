//! How far a command is: one line on the terminal, which goes away.

use std::io::{self, IsTerminal, Write, stderr, stdout};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use super::terminal::is_quiet;

/// What takes less shows nothing.
const PATIENCE: Duration = Duration::from_secs(1);

/// The line changes no more often.
const PACE: Duration = Duration::from_millis(100);

/// Counts files, and shows their number on the standard error when it takes long and a terminal is there. A thread writes
/// the line, so that one large file shows it too.
pub(super) struct Progress {
    count: Arc<FileCount>,
    /// The thread, which ends when the channel closes.
    ticker: Option<(Sender<()>, JoinHandle<()>)>,
}

struct FileCount {
    /// What is done with the files: `checking`.
    verb: &'static str,
    total: usize,
    done: AtomicUsize,
}

impl Progress {
    pub(super) fn new(verb: &'static str, total: usize) -> Self {
        let is_dumb = std::env::var_os("TERM").is_none_or(|term| term == "dumb");
        let is_wanted = total > 0 && stderr().is_terminal() && !is_dumb && !is_quiet();
        let count = Arc::new(FileCount { verb, total, done: AtomicUsize::new(0) });
        let ticker = is_wanted.then(|| {
            let (sender, end) = channel();
            let count = count.clone();
            (sender, thread::spawn(move || count.show_until(&end)))
        });
        line().is_wanted = is_wanted;
        Self { count, ticker }
    }

    /// One more file is done.
    pub(super) fn step(&self) {
        self.count.done.fetch_add(1, Ordering::Relaxed);
    }

    /// One more file is done, and the output says so: a terminal shows this at once, instead of the number.
    pub(super) fn step_with(&self, out: &mut dyn Write) -> io::Result<()> {
        self.step();
        if stdout().is_terminal() {
            give_way();
            out.flush()?;
        }
        Ok(())
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.ticker.take() {
            drop(sender);
            let _ = thread.join(); // it fails only by a panic, and then there is no line
        }
        hide().is_wanted = false;
    }
}

impl FileCount {
    fn show_until(&self, end: &Receiver<()>) {
        let mut pause = PATIENCE;
        while end.recv_timeout(pause) == Err(RecvTimeoutError::Timeout) {
            line().show(&self.text());
            pause = PACE;
        }
    }

    fn text(&self) -> String {
        match self.total {
            1 => format!("{} …", self.verb),
            total => format!("{}: {} of {total} files", self.verb, self.done.load(Ordering::Relaxed)),
        }
    }
}

/// The last line of the terminal, of which there is one.
pub(super) struct ProgressLine {
    is_wanted: bool,
    is_shown: bool,
}

static LINE: Mutex<ProgressLine> = Mutex::new(ProgressLine { is_wanted: false, is_shown: false });

fn line() -> MutexGuard<'static, ProgressLine> {
    LINE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the line as long as the result lives, because the standard error gets something else.
pub(super) fn hide() -> MutexGuard<'static, ProgressLine> {
    let mut line = line();
    if std::mem::take(&mut line.is_shown) {
        write("\r\x1B[K");
    }
    line
}

/// The standard output gets results: on a terminal they show the progress themselves, and a line among them would garble them.
pub(super) fn give_way() {
    if stdout().is_terminal() {
        hide().is_wanted = false;
    }
}

impl ProgressLine {
    fn show(&mut self, text: &str) {
        if self.is_wanted {
            self.is_shown = true;
            write(&format!("\r\x1B[K{text}"));
        }
    }
}

fn write(text: &str) {
    // there is no other place to report an error of this
    let _ = stderr().write_all(text.as_bytes());
}

#[test]
fn one_file_is_not_counted() {
    let text = |total| FileCount { verb: "checking", total, done: AtomicUsize::new(3) }.text();
    assert_eq!((text(1).as_str(), text(40).as_str()), ("checking …", "checking: 3 of 40 files"));
}
