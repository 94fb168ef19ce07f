//! `objdict fmt`.

use std::io::Write;
use std::path::Path;

use super::args::FmtArgs;
use super::diff;
use super::ending::{Failure, Outcome, note};
use super::files::{InputFile, gather, note_outside};
use super::input::{CheckedInput, name_of};
use super::parallel::in_order;
use super::progress::give_way;
use super::settings::{CommandSettings, SettingsArgs};
use super::stdout::Output;
use super::written_files::{Saved, save_in_place};
use objdict_model::diagnostic::plural;
use objdict_model::source::SourceFile;
use objdict_project::compat;

pub(super) fn run(args: &FmtArgs, out: &mut Output) -> Result<Outcome, Failure> {
    // what a configuration excludes from folders is left alone
    let settings = SettingsArgs::from(&args.config);
    let (mut files, failures) = gather(&args.files, &mut CommandSettings::new(&settings)?)?;
    note_outside(&files);
    args.input.patch.none_with("`fmt`")?;
    files.retain(|file| !file.is_outside);
    failures.iter().for_each(Failure::print);
    let mut done = Done { has_failed: !failures.is_empty(), changed: 0, same: 0 };
    in_order(
        &files,
        None,
        "formatting",
        |file| arrange(args, file),
        |arranged| done.take(args, arranged, out),
    )?;
    done.summarise(args);
    Ok(match done {
        Done { has_failed: true, .. } => Outcome::Failed,
        Done { changed: 1.., .. } if args.is_dry() => Outcome::Findings,
        _ => Outcome::Clean,
    })
}

impl FmtArgs {
    /// Whether nothing is written.
    fn is_dry(&self) -> bool {
        self.check || self.diff
    }
}

/// A file before and after.
struct FormattedFile {
    file: std::path::PathBuf,
    before: SourceFile,
    after: SourceFile,
    bytes: Vec<u8>,
}

/// Puts one file in order; `None` for one of a folder that is not a description.
fn arrange(args: &FmtArgs, file: &InputFile) -> Result<Option<FormattedFile>, Failure> {
    let description = match args.input.candidate(&file.path, args.input.size.bytes(&file.path)?, &[])? {
        CheckedInput::Description(description) => *description,
        CheckedInput::Foreign(..) if !file.is_named => return Ok(None),
        CheckedInput::Foreign(_, failure) => return Err(failure),
    };
    let source = description.source();
    let before = source.with_bytes(source.to_bytes()).map_err(Failure::new)?;
    let readers = args.dialect.tools();
    let is_adapted = !readers.is_empty() && description.document().is_some();
    let description = if is_adapted { compat::adapt(description, readers) } else { description };
    let bytes = description.arranged().map_err(Failure::new)?;
    let after = description.source().with_bytes(bytes.clone()).map_err(Failure::new)?;
    Ok(Some(FormattedFile { file: file.path.clone(), before, after, bytes }))
}

/// What became of the files.
struct Done {
    has_failed: bool,
    changed: usize,
    same: usize,
}

impl Done {
    fn take(
        &mut self,
        args: &FmtArgs,
        arranged: Result<Option<FormattedFile>, Failure>,
        out: &mut Output,
    ) -> Result<(), Failure> {
        let arranged = match arranged {
            Ok(Some(arranged)) => arranged,
            Ok(None) => return Ok(()),
            Err(failure) => {
                failure.print();
                self.has_failed = true;
                return Ok(());
            }
        };
        let is_changed = arranged.before.text() != arranged.after.text();
        let written = write(args, &arranged, is_changed, out);
        match written {
            Ok(()) if is_changed => self.changed += 1,
            Ok(()) => self.same += 1,
            Err(failure) => {
                failure.print();
                self.has_failed = true;
            }
        }
        Ok(())
    }

    fn summarise(&self, args: &FmtArgs) {
        if args.files.iter().any(|file| file == Path::new("-")) && !args.is_dry() {
            return;
        }
        let verb = if args.is_dry() { "would format" } else { "formatted" };
        let same = match self.same {
            0 => String::new(),
            count => format!(", {} already formatted", plural(count, "file")),
        };
        note(&format!("{verb} {}{same}\n", plural(self.changed, "file")));
    }
}

/// Writes a file, or what is asked for instead. The standard input goes to the standard output.
fn write(
    args: &FmtArgs,
    arranged: &FormattedFile,
    is_changed: bool,
    out: &mut Output,
) -> Result<(), Failure> {
    let is_stdin = arranged.file == Path::new("-");
    if is_stdin || args.is_dry() {
        give_way();
    }
    if args.diff {
        if is_changed {
            diff::print(&arranged.before, &arranged.after, out)?;
        }
    } else if args.check {
        if is_changed {
            writeln!(out, "{}", name_of(&arranged.file))?;
        }
    } else if is_stdin {
        out.raw()?.write_all(&arranged.bytes)?;
    } else if is_changed {
        let _: Saved = save_in_place(&arranged.file, &arranged.bytes)?;
    }
    Ok(())
}
