//! Instructions for Cargo: a line each on the standard output of the build script.

use std::io::{self, Write};
use std::path::Path;

use objdict_model::diagnostic::one_line;

/// Lines for Cargo.
pub(super) struct Cargo<W> {
    out: W,
}

impl<W: Write> Cargo<W> {
    pub(super) fn new(out: W) -> Self {
        Self { out }
    }

    /// Cargo runs the script again when this file changes. A path with a line break cannot be registered.
    pub(super) fn depends_on(&mut self, path: &Path) -> io::Result<()> {
        let path = path.display().to_string();
        if path.contains(['\n', '\r']) {
            let shown = one_line(&path);
            return self.line(
                "warning",
                &format!("`{shown}` is not registered with Cargo because its name contains a line break"),
            );
        }
        self.line("rerun-if-changed", &path)
    }

    /// Writes warnings of one kind, up to the limit, and the number of the rest.
    pub(super) fn warn(
        &mut self,
        most: usize,
        lines: impl IntoIterator<Item = String>,
        rest: impl FnOnce(usize) -> String,
    ) -> io::Result<()> {
        let mut lines = lines.into_iter();
        for line in lines.by_ref().take(most) {
            self.line("warning", &one_line(&line))?;
        }
        let omitted = lines.count();
        if omitted > 0 { self.line("warning", &one_line(&rest(omitted))) } else { Ok(()) }
    }

    fn line(&mut self, key: &str, value: &str) -> io::Result<()> {
        writeln!(self.out, "cargo:{key}={value}")
    }
}
