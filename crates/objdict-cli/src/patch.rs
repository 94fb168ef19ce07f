//! `objdict patch`: descriptions with patches, patches of two descriptions, and patches held against descriptions.

use std::io::Write;
use std::path::Path;
use std::sync::Arc;

use super::args::{PatchApplyArgs, PatchCheckArgs, PatchCommand, PatchMakeArgs};
use super::ending::{Failure, Outcome, note, tell};
use super::files::gather;
use super::input::{CheckedInput, Input, InputArgs, name_of, source_name};
use super::settings::CommandSettings;
use super::stdout::Output;
use super::table::TextTable;
use super::written_files::{is_stdout, save};
use objdict_format::Description;
use objdict_format::patch;
use objdict_format::patch::{Patch, Patched};
use objdict_model::diagnostic::{Findings, Severity};

pub(super) fn run(command: &PatchCommand, out: &mut Output) -> Result<Outcome, Failure> {
    match command {
        PatchCommand::Apply(args) => apply(args, out),
        PatchCommand::Make(args) => make(args, out),
        PatchCommand::Check(args) => check(args, out),
    }
}

fn description(input: &InputArgs, path: &Path) -> Result<Description, Failure> {
    // a patch is made for the file as it is
    match input.reading().read_one(&source_name(path), input.size.read(path)?)? {
        (_, Input::Description(description)) => Ok(*description),
        (kind, _) => {
            let message = format!(
                "`{}` is read as {}, but patches apply only to descriptions",
                name_of(path),
                kind.name()
            );
            Err(Failure::new(message).help("name an EDS, DCF, XDD or XDC"))
        }
    }
}

fn apply(args: &PatchApplyArgs, out: &mut Output) -> Result<Outcome, Failure> {
    if args.input.patch.patches.is_empty() {
        return Err(Failure::new("no patch specified").help("name one with `--patch`"));
    }
    let description = description(&args.input, &args.file)?;
    let Some(patched) = description.patched().filter(|patched| !patched.patches.is_empty()) else {
        let message = format!("none of the patches applies to `{}`", name_of(&args.file));
        let help = "compare the patch's `vendor-id`, `product-code` and `revision` with the file";
        return Err(Failure::new(message).help(help));
    };
    patched.lines().iter().for_each(|line| tell(&format!("{line}\n")));
    let bytes = description.realised()?.map_or_else(|| description.print(), |realised| realised.print());
    write(&args.output, &bytes, out)
}

fn make(args: &PatchMakeArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let original = description(&args.input, &args.original)?;
    let edited = description(&args.input, &args.edited)?;
    let text = patch::make(original.described(), edited.described());
    if !text.contains("[[") {
        note("note: both descriptions are equivalent\n");
    }
    write(&args.output, text.as_bytes(), out)
}

fn write(path: &Path, bytes: &[u8], out: &mut Output) -> Result<Outcome, Failure> {
    match is_stdout(path) {
        true => out.raw()?.write_all(bytes)?,
        false => save(path, bytes).map(|_| ())?,
    }
    Ok(Outcome::Clean)
}

fn check(args: &PatchCheckArgs, out: &mut Output) -> Result<Outcome, Failure> {
    const WIDTH: usize = 60;
    let mut settings = CommandSettings::new(&args.settings)?;
    let (files, failures) = gather(&args.files, &mut settings)?;
    if let Some(failure) = settings.unusable().next() {
        return Err(failure);
    }
    failures.iter().for_each(Failure::print);
    let mut known: Vec<Arc<Patch>> = args.input.patch.patches.clone();
    let mut table = TextTable::new(["Patch", "File", "Result"], WIDTH);
    let mut lines = Vec::new();
    let (mut has_failed, mut is_refused) = (!failures.is_empty(), false);
    for file in &files {
        let of_project = file.project.as_ref().map(|project| &project.patches[..]).unwrap_or_default();
        for patch in of_project
            .iter()
            .filter(|patch| !known.iter().any(|known| Arc::ptr_eq(known, patch)))
            .collect::<Vec<_>>()
        {
            known.push(Arc::clone(patch));
        }
        let bytes = args.input.size.bytes(&file.path)?;
        let description = match args.input.candidate(&file.path, bytes, of_project) {
            Ok(CheckedInput::Description(description)) => description,
            Ok(CheckedInput::Foreign(..)) if !file.is_named => continue,
            Ok(CheckedInput::Foreign(_, failure)) | Err(failure) => {
                failure.print();
                has_failed = true;
                continue;
            }
        };
        let patched: Vec<Patched> =
            description.map_devices(|device| device.patched().cloned()).into_iter().flatten().collect();
        for patched in &patched {
            for (patch, findings) in patched.by_patch() {
                let name = patch.source().name().to_owned();
                table.row([name, name_of(&file.path), result(patch, findings)]);
                is_refused |= findings.worst() == Some(Severity::Error);
            }
            lines.extend(patched.lines());
        }
    }
    if known.is_empty() {
        return Err(Failure::new("no patch specified")
            .help("name one with `--patch`, or name them as `patches` in `objdict.toml`"));
    }
    for patch in known.iter().filter(|patch| !patch.is_used()) {
        table.row([
            patch.source().name().to_owned(),
            "-".to_owned(),
            "applies to none of the files".to_owned(),
        ]);
        is_refused = true;
    }
    table.write(out)?;
    if !lines.is_empty() {
        writeln!(out)?;
        for line in lines {
            writeln!(out, "{line}")?;
        }
    }
    Ok(match () {
        () if has_failed => Outcome::Failed,
        () if is_refused => Outcome::Findings,
        () => Outcome::Clean,
    })
}

/// What became of a patch of a file, in words.
fn result(patch: &Patch, findings: &Findings) -> String {
    let count = |severity| findings.iter().filter(|finding| finding.severity == severity).count();
    let (errors, warnings) = (count(Severity::Error), count(Severity::Warning));
    match (errors, warnings) {
        (0, 0) => "applies".to_owned(),
        (0, warnings) if warnings >= patch.len() => "no longer needed".to_owned(),
        (0, warnings) => format!("applies, {warnings} of {} changes no longer needed", patch.len()),
        // errors in the keys of the patch are no changes
        (errors, _) if errors > patch.len() => "does not apply".to_owned(),
        (errors, _) => format!("does not apply: {errors} of {} changes", patch.len()),
    }
}
