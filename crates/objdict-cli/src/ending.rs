//! How a command ends, and what it says on the standard error.

use std::io::Write;
use std::process::ExitCode;

use super::progress;
use super::terminal::{is_quiet, is_verbose};
use objdict_model::diagnostic::{one_line, printable_lines};

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Outcome {
    /// Success.
    Clean,
    /// The work was done and something was found.
    Findings,
    /// The work could not be done, or not for every file.
    Failed,
}

impl Outcome {
    /// The exit code.
    pub(super) const fn code(self) -> u8 {
        match self {
            Self::Clean => 0,
            Self::Findings => 1,
            Self::Failed => 2,
        }
    }
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(outcome.code())
    }
}

/// Why a command could not do its work.
#[derive(Debug)]
pub(super) struct Failure {
    pub(super) message: String,
    pub(super) help: Option<String>,
    /// The lines of a text that it is about, with the message: shown instead of message and help.
    excerpt: Option<String>,
}

impl Failure {
    /// A message of one line.
    pub(super) fn new(message: impl std::fmt::Display) -> Self {
        Self { message: one_line(&message.to_string()), help: None, excerpt: None }
    }

    /// A message of several lines.
    pub(super) fn of_lines(lines: impl IntoIterator<Item = impl AsRef<str>>) -> Self {
        let lines: Vec<String> = lines.into_iter().map(|line| one_line(line.as_ref())).collect();
        Self { message: lines.join("\n"), help: None, excerpt: None }
    }

    pub(super) fn help(mut self, help: impl AsRef<str>) -> Self {
        self.help = Some(one_line(help.as_ref()));
        self
    }

    pub(super) fn maybe_help(self, help: Option<impl AsRef<str>>) -> Self {
        help.into_iter().fold(self, Self::help)
    }

    pub(super) fn excerpt(mut self, excerpt: String) -> Self {
        self.excerpt = Some(excerpt);
        self
    }

    /// Prints it on the standard error.
    pub(super) fn print(&self) {
        if let Some(excerpt) = &self.excerpt {
            return tell(excerpt);
        }
        let mut text = format!("error: {}\n", self.message);
        if let Some(help) = &self.help {
            text.push_str(&format!("  help: {help}\n"));
        }
        tell(&text);
    }
}

/// Writes a note or a summary to the standard error, unless `--quiet` is given.
pub(super) fn note(text: &str) {
    if !is_quiet() {
        tell(text);
    }
}

/// Writes lines to the standard error; they may quote anything from a file.
pub(super) fn tell(text: &str) {
    let _line = progress::hide();
    // there is no other place to report an error of this
    let _ = std::io::stderr().write_all(printable_lines(text).as_bytes());
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::new(format_args!("cannot write the output: {error}"))
    }
}

/// Names a file that is read, with `--verbose`.
pub(super) fn detail(name: &str) {
    if is_verbose() {
        tell(&format!("reading {}\n", one_line(name)));
    }
}
