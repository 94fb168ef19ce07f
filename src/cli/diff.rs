//! What a command would change, as a unified diff.

use std::io::Write;
use std::time::Duration;

use similar::{Algorithm, TextDiff};

use super::Failure;
use super::output::Output;
use crate::diagnostic::visible;
use crate::source::SourceFile;

/// So long the shortest difference is looked for; then a longer one will do.
const PATIENCE: Duration = Duration::from_secs(2);

/// Prints the difference of two versions of a file with three lines around each change. Lines end as they do in the file, so
/// that the difference can be applied.
pub(super) fn print(before: &SourceFile, after: &SourceFile, out: &mut Output) -> Result<(), Failure> {
    let name: String = before.name().chars().map(visible).collect();
    writeln!(out, "--- {name}\n+++ {name}")?;
    if before.encoding() != after.encoding() {
        writeln!(out, "# the encoding {} becomes {}", before.encoding(), after.encoding())?;
    }
    let mut settings = TextDiff::configure();
    let diff = settings.algorithm(Algorithm::Patience).timeout(PATIENCE);
    for hunk in diff.diff_lines(before.text(), after.text()).unified_diff().iter_hunks() {
        writeln!(out, "{}", hunk.header())?;
        for change in hunk.iter_changes() {
            let value = change.value();
            let line = value.trim_end_matches(['\n', '\r']);
            let shown: String = line.chars().map(visible).collect();
            let end = match &value[line.len()..] {
                "" => "\n\\ No newline at end of file\n",
                "\r" => "\r\n",
                end => end,
            };
            write!(out, "{}{shown}{end}", change.tag())?;
        }
    }
    Ok(())
}
