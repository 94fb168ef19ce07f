//! What a command would change, as a unified diff.

use std::io::Write;
use std::ops::Range;

use super::ending::Failure;
use super::stdout::Output;
use objdict_model::diagnostic::{one_line, printable};
use objdict_model::source::SourceFile;
use objdict_project::line_diff::{LineChange, changes};

/// Lines that are shown around each change.
const AROUND: usize = 3;

/// Prints the difference of two versions of a file with three lines around each change. Lines end as they do in the file, so
/// that the difference can be applied.
pub(super) fn print(before: &SourceFile, after: &SourceFile, out: &mut Output) -> Result<(), Failure> {
    let name = one_line(before.name());
    writeln!(out, "--- {name}\n+++ {name}")?;
    if before.encoding() != after.encoding() {
        writeln!(out, "# the encoding {} becomes {}", before.encoding(), after.encoding())?;
    }
    let (old, new) = (lines_of(before.text()), lines_of(after.text()));
    let all = changes(&old, &new);
    // changes with so few lines between them that these are shown whole stand together
    for hunk in all.chunk_by(|one, next| next.old.start - one.old.end <= 2 * AROUND) {
        print_hunk(hunk, &old, &new, out)?;
    }
    Ok(())
}

fn print_hunk(hunk: &[LineChange], old: &[&str], new: &[&str], out: &mut Output) -> Result<(), Failure> {
    let (Some(first), Some(last)) = (hunk.first(), hunk.last()) else { return Ok(()) };
    let before = first.old.start.min(AROUND);
    let behind = (old.len() - last.old.end).min(AROUND);
    let shown_old = first.old.start - before..last.old.end + behind;
    let shown_new = first.new.start - before..last.new.end + behind;
    writeln!(out, "@@ -{} +{} @@", place(&shown_old), place(&shown_new))?;
    let mut at = shown_old.start;
    for change in hunk {
        print_lines(" ", &old[at..change.old.start], out)?;
        print_lines("-", &old[change.old.clone()], out)?;
        print_lines("+", &new[change.new.clone()], out)?;
        at = change.old.end;
    }
    print_lines(" ", &old[at..shown_old.end], out)
}

/// The first line and the number of lines, which is left out where it is 1; of no lines, the line before them.
fn place(lines: &Range<usize>) -> String {
    match lines.len() {
        0 => format!("{},0", lines.start),
        1 => (lines.start + 1).to_string(),
        count => format!("{},{count}", lines.start + 1),
    }
}

fn print_lines(mark: &str, lines: &[&str], out: &mut Output) -> Result<(), Failure> {
    for value in lines {
        let line = value.trim_end_matches(['\n', '\r']);
        let shown = format!("{mark}{line}");
        let end = match &value[line.len()..] {
            "" => "\n\\ No newline at end of file\n",
            "\r" => "\r\n",
            end => end,
        };
        write!(out.raw()?, "{}{end}", printable(&shown))?;
    }
    Ok(())
}

/// The lines of a text with their ends: LF, CR LF or CR.
fn lines_of(text: &str) -> Vec<&str> {
    let mut lines = Vec::new();
    let mut rest = text;
    while let Some(at) = memchr::memchr2(b'\n', b'\r', rest.as_bytes()) {
        let length = if rest[at..].starts_with("\r\n") { 2 } else { 1 };
        let (line, behind) = rest.split_at(at + length);
        lines.push(line);
        rest = behind;
    }
    lines.extend(Some(rest).filter(|rest| !rest.is_empty()));
    lines
}
