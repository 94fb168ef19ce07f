//! The standard output.
//!
//! Text is made harmless where it is printed, not where it is created: names and texts of files could otherwise
//! steer a terminal or a CI service. A name must be one line (`one_line`, `name_of`).

use std::borrow::Cow;
use std::fmt::Display;
use std::io::{self, BufWriter, ErrorKind, Stdout, Write};

use serde::Serialize;

use super::ending::Failure;
use super::terminal::{Color, is_quiet};
use objdict_model::diagnostic::printable;
use objdict_model::json;

/// The standard output, buffered. What is written to it is text for users: each line is made [`printable`], whatever names and
/// texts it quotes. Results that other programs read go to [`raw`](Self::raw). When the reader goes away, as `head` does, what is
/// written later is dropped, and that is no error.
pub(super) struct Output {
    stdout: BufWriter<Stdout>,
    /// The start of a line that is not complete.
    line: Vec<u8>,
    is_closed: bool,
    colour: bool,
}

/// The standard output for bytes as they are.
pub(super) struct Raw<'a>(&'a mut Output);

impl Output {
    pub(super) fn stdout(color: Color) -> Self {
        Self {
            stdout: BufWriter::with_capacity(1 << 16, io::stdout()),
            line: Vec::new(),
            is_closed: false,
            colour: color.is_on(),
        }
    }

    /// Whether colours are wanted.
    pub(super) fn colour(&self) -> bool {
        self.colour
    }

    /// A line about what became of files, unless `--quiet` is given.
    ///
    /// # Errors
    /// When it cannot be written.
    pub(super) fn summary(&mut self, line: impl Display) -> io::Result<()> {
        if is_quiet() { Ok(()) } else { writeln!(self, "{line}") }
    }

    /// The same for a result that is data: a file, JSON, or text with escapes of its own.
    ///
    /// # Errors
    /// When the text before it cannot be written.
    pub(super) fn raw(&mut self) -> io::Result<Raw<'_>> {
        self.end_line()?;
        Ok(Raw(self))
    }

    /// Writes a document in one line.
    ///
    /// # Errors
    /// When it cannot be written.
    pub(super) fn json(&mut self, document: &impl Serialize) -> io::Result<()> {
        json::write(&mut self.raw()?, document)?;
        writeln!(self)
    }

    /// Writes a document in lines.
    ///
    /// # Errors
    /// When it cannot be written.
    pub(super) fn pretty_json(&mut self, document: &impl Serialize) -> io::Result<()> {
        json::write_pretty(&mut self.raw()?, document)?;
        writeln!(self)
    }

    /// Writes what is still in the buffer.
    pub(super) fn finish(&mut self) -> Result<(), Failure> {
        Ok(self.flush()?)
    }

    /// Writes the start of a line that is not complete.
    fn end_line(&mut self) -> io::Result<()> {
        let line = std::mem::take(&mut self.line);
        if line.is_empty() { Ok(()) } else { self.put_line(&line) }
    }

    /// Writes a line, or the start of one, as it may be printed.
    fn put_line(&mut self, line: &[u8]) -> io::Result<()> {
        // the lossy conversion is slower for text that is UTF-8
        let text = str::from_utf8(line).map_or_else(|_| String::from_utf8_lossy(line), Cow::Borrowed);
        let (text, end) = text.strip_suffix('\n').map_or((&*text, ""), |text| (text, "\n"));
        let shown = if self.colour { coloured(text) } else { printable(text) };
        self.put(shown.as_bytes())?;
        self.put(end.as_bytes())
    }

    fn put(&mut self, bytes: &[u8]) -> io::Result<()> {
        if self.is_closed {
            return Ok(());
        }
        let result = self.stdout.write_all(bytes);
        self.guard(result, ())
    }

    fn guard<T>(&mut self, result: io::Result<T>, otherwise: T) -> io::Result<T> {
        match result {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                self.is_closed = true;
                Ok(otherwise)
            }
            result => result,
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for part in bytes.split_inclusive(|byte| *byte == b'\n') {
            match (self.line.is_empty(), part.ends_with(b"\n")) {
                (true, true) => self.put_line(part)?,
                (false, true) => {
                    self.line.extend(part);
                    self.end_line()?;
                }
                (_, false) => self.line.extend(part),
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.end_line()?;
        if self.is_closed {
            return Ok(());
        }
        let result = self.stdout.flush();
        self.guard(result, ())
    }
}

impl Write for Raw<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.put(bytes).map(|()| bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// A line as it may be printed, with the colours of reports, whose texts are made printable before.
fn coloured(line: &str) -> Cow<'_, str> {
    let mut shown = String::new();
    let mut rest = line;
    while let Some((before, behind)) = rest.split_once("\u{1B}[") {
        let digits = behind.bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b';').count();
        let Some(after) = behind[digits..].strip_prefix('m') else { break };
        shown += &printable(before);
        shown.push_str("\u{1B}[");
        shown += &behind[..=digits];
        rest = after;
    }
    if shown.is_empty() { printable(rest) } else { Cow::Owned(shown + &printable(rest)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_colours_steer_the_terminal() {
        assert_eq!(coloured("\u{1B}[31;1ma\u{1B}[0m b"), "\u{1B}[31;1ma\u{1B}[0m b");
        assert_eq!(coloured("\u{1B}[1ma\u{1B}[2J\u{1B}]0;x"), "\u{1B}[1ma\u{FFFD}[2J\u{FFFD}]0;x");
        assert_eq!(coloured("::error::\u{1B}[0m"), "\u{FFFD}:error::\u{1B}[0m");
    }
}
