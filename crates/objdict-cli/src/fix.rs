//! Findings fixed by `check`: what is written, what is only shown, and what is said about it.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::canonical::DialectArgs;
use super::diff;
use super::ending::{Failure, note};
use super::stdout::Output;
use super::written_files::save_in_place;
use objdict_format as format;
use objdict_format::{Description, Format};
use objdict_model::diagnostic::Applicability;
use objdict_model::diagnostic::plural;
use objdict_model::source::SourceFile;
use objdict_project::{AppliedFix, Fixed};

// Whether findings are fixed.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Fixes")]
pub(super) struct FixArgs {
    /// Apply safe fixes, which keep the meaning of the description, and report the remaining findings
    #[arg(long)]
    pub fix: bool,
    /// Also apply fixes that need review, with --fix or --diff
    #[arg(long)]
    pub unsafe_fixes: bool,
    /// Print the changes without writing them; exit with 1 if there are any
    #[arg(long)]
    pub diff: bool,
    #[command(flatten)]
    pub dialect: DialectArgs,
}

impl FixArgs {
    /// How safe a fix must be to be made; `None` where nothing is fixed.
    pub(super) fn safety(&self) -> Option<Applicability> {
        let safety = if self.unsafe_fixes { Applicability::Unsafe } else { Applicability::Safe };
        (self.fix || self.diff).then_some(safety)
    }
}

/// A file with its findings fixed, not written yet.
pub(super) struct Amended {
    path: PathBuf,
    format: Format,
    before: SourceFile,
    after: SourceFile,
    bytes: Vec<u8>,
    applied: usize,
    skipped: Vec<AppliedFix>,
    is_unfinished: bool,
}

/// Fixes the devices of a file with these numbers. The description of the first one comes back, and the change where there is one.
pub(super) fn amend(
    path: &Path,
    description: Description,
    numbers: Range<usize>,
    fix: impl Fn(Description) -> Fixed,
) -> Option<(Description, Option<Amended>)> {
    let (format, before) = (description.format(), description.source().with_bytes(description.print()).ok()?);
    let mut next = description;
    let (mut applied, mut skipped, mut is_unfinished) = (0, Vec::new(), false);
    for number in numbers.clone() {
        let fixed = fix(next.select(number)?);
        applied += fixed.applied.len();
        skipped.extend(fixed.skipped);
        is_unfinished |= fixed.is_unfinished;
        next = fixed.description;
    }
    let bytes = next.print();
    let after = next.source().with_bytes(bytes.clone()).ok()?;
    let amended =
        Amended { path: path.to_owned(), format, before, after, bytes, applied, skipped, is_unfinished };
    let is_changed = amended.applied > 0 || is_unfinished || !amended.skipped.is_empty();
    Some((next.select(numbers.start)?, is_changed.then_some(amended)))
}

impl Amended {
    /// Writes the file.
    pub(super) fn write(&self) -> Result<(), Failure> {
        if self.applied > 0 {
            save_in_place(&self.path, &self.bytes)?;
        }
        Ok(())
    }

    /// The description as it is without the fixes.
    pub(super) fn original(self) -> Description {
        format::read(self.before, self.format)
    }
}

/// What was fixed in all files.
#[derive(Default)]
pub(super) struct Fixing {
    fixed: usize,
    files: usize,
    skipped: usize,
    unfinished: usize,
}

impl Fixing {
    /// Shows what would be written.
    pub(super) fn show(&mut self, amended: &Amended, out: &mut Output) -> Result<(), Failure> {
        if amended.applied > 0 {
            diff::print(&amended.before, &amended.after, out)?;
        }
        self.count(amended);
        Ok(())
    }

    /// Counts what was fixed in a file.
    pub(super) fn count(&mut self, amended: &Amended) {
        self.fixed += amended.applied;
        self.files += usize::from(amended.applied > 0);
        self.skipped += amended.skipped.len();
        self.unfinished += usize::from(amended.is_unfinished);
    }

    /// Whether a file was changed, or would be.
    pub(super) fn is_needed(&self) -> bool {
        self.fixed > 0
    }

    /// Reports the result.
    pub(super) fn finish(&self, is_dry: bool) {
        let verb = if is_dry { "would fix" } else { "fixed" };
        let (findings, files) = (plural(self.fixed, "finding"), plural(self.files, "file"));
        note(&format!("{verb} {findings} in {files}\n"));
        if self.skipped > 0 {
            let are = if self.skipped == 1 { "is" } else { "are" };
            let fixes = match self.skipped {
                1 => "1 fix".to_owned(),
                count => format!("{count} fixes"),
            };
            note(&format!("note: {fixes} {are} not applied because other findings would result\n"));
        }
        if self.unfinished > 0 {
            let files = plural(self.unfinished, "file");
            note(&format!(
                "note: {files} would take too long to fix at once; run `objdict check --fix` again\n"
            ));
        }
    }
}
