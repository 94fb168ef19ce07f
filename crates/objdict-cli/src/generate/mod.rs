//! `objdict generate`.

mod compare;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

#[cfg(feature = "schema")]
pub(super) use self::compare::TableDifferences;
use super::args::{GenerateArgs, SizeFormat};
use super::ending::{Failure, Outcome, note, tell};
use super::input::{name_of, source_name};
use super::progress::Progress;
use super::sizes;
use super::stdout::Output;
use super::table::TextTable;
use super::terminal::is_quiet;
use super::written_files::{SaveFolder, Saved, keep, require_other, save, save_in_place};
use objdict_build::pipeline::{
    CheckedDescription, Error, Generation, MemoryLimits, Request, depfile, report_lines,
};
use objdict_format::input::Input;
use objdict_format::scaffold;
use objdict_generate::Target;
use objdict_model::diagnostic::plural;
use objdict_model::diagnostic::{Severity, one_line};
use objdict_project::report::Tally;

pub(super) fn run(args: &GenerateArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let request = request(args)?;
    #[cfg(target_os = "linux")]
    if request.targets.iter().any(|target| target.name() == "template") {
        limit_memory();
    }
    let mut bytes = args.input.size.read(&args.file)?;
    if args.add_missing {
        bytes = supply(args, &request, bytes)?;
    }
    // make cannot wait for the standard input
    let mut files: Vec<PathBuf> =
        Some(args.file.clone()).into_iter().filter(|file| file != Path::new("-")).collect();
    let progress = Progress::new("generating", 1);
    let produced = request.check(&source_name(&args.file), bytes, &mut files).and_then(|checked| {
        let generation = request.produce(&checked, &mut files)?;
        Ok((checked, generation))
    });
    drop(progress);
    let (checked, generation) = match produced {
        Ok(produced) => produced,
        Err(error) => return refused(error),
    };
    if let Some(existing) = &args.compare {
        let produce = |layout| {
            let mut request = self::request(args).ok()?;
            request.options.layout = layout;
            request.produce(&checked, &mut Vec::new()).ok()
        };
        return compare::run(args, existing, &generation, produce, out);
    }
    if args.list {
        list(args, &generation, out)?;
    } else {
        let folder = admit(args, &generation, &files)?;
        write(args, &checked, &generation, folder, out)?;
        stamp(args, &files)?;
    }
    for (target, generated) in &generation.outputs {
        // warnings come last, where they are seen
        let (warnings, notes): (Vec<_>, Vec<_>) =
            generated.notes.iter().partition(|note| note.severity >= Severity::Warning);
        let lines = |notes: Vec<_>| {
            notes.into_iter().map(|note| report_lines(target.name(), note)).collect::<String>()
        };
        note(&lines(notes));
        tell(&lines(warnings));
    }
    let mut notes = generation.outputs.iter().flat_map(|(_, generated)| &generated.notes);
    let is_failed = !args.force && notes.any(|note| note.severity == Severity::Error);
    Ok(if is_failed { Outcome::Findings } else { Outcome::Clean })
}

/// Adds the objects to the file that CANopenNode does not compile or start without.
fn supply(args: &GenerateArgs, request: &Request, bytes: Vec<u8>) -> Result<Vec<u8>, Failure> {
    let name = source_name(&args.file);
    let refuse = |help: &str| Failure::new(format_args!("no objects can be added to `{name}`")).help(help);
    args.input.patch.none_with("`--add-missing`")?;
    if !request.targets.iter().any(|target| target.name() == "canopennode") {
        return Err(refuse("`--add-missing` is for the target `canopennode`"));
    }
    let (_, Input::Description(description)) = request.reading.read_one(&name, bytes.clone())? else {
        return Err(refuse("name an EDS, DCF, XDD or XDC"));
    };
    let device = description.described();
    let mut missing: Vec<u16> = objdict_model::canopennode::unmet(description.device())
        .into_iter()
        .filter_map(|unmet| unmet.missing)
        .collect();
    missing.retain(|index| !device.objects.contains_key(index)); // it is disabled
    missing.sort_unstable();
    if missing.is_empty() {
        return Ok(bytes);
    }
    let mut complete = device.clone();
    scaffold::add_objects(&mut complete, 301, &missing);
    let added = missing.iter().map(|index| format!("{index:04X}h")).collect::<Vec<_>>().join(", ");
    let bytes = description.with_objects(&complete).ok_or_else(|| refuse(&format!("describe {added}")))?;
    save_in_place(&args.file, &bytes)?;
    note(&format!("note: added {added} to `{}`\n", one_line(&name)));
    Ok(bytes)
}

fn write(
    args: &GenerateArgs,
    checked: &CheckedDescription,
    generation: &Generation,
    mut folder: SaveFolder,
    out: &mut Output,
) -> Result<(), Failure> {
    let mut table = TextTable::new(["", "", "", ""], usize::MAX);
    for (target, generated) in &generation.outputs {
        for file in &generated.files {
            let path = args.folder().join(&file.path);
            let saved = match folder.save(&file.path, &file.contents)? {
                Saved::Written => "",
                Saved::Unchanged => "unchanged",
            };
            let size = format!("{} bytes", file.contents.len());
            table.row([format!("  {}", target.name()), name_of(&path), size, saved.to_owned()]);
        }
    }
    folder.finish()?;
    if args.report.is_some() && args.format == SizeFormat::Json {
        sizes::write_json(&generation.sizes, out)?;
    } else {
        out.summary(format_args!("{}: {}", name_of(&args.file), facts(checked, generation)))?;
        if !is_quiet() {
            table.write(out)?;
        }
        if args.report.is_some() {
            sizes::write_tables(&generation.sizes, out)?;
        }
    }
    Ok(out.flush()?)
}

/// Refuses to write over what is read, and over what objdict did not write. Nothing is written before all is admitted.
fn admit(args: &GenerateArgs, generation: &Generation, read: &[PathBuf]) -> Result<SaveFolder, Failure> {
    read.iter().for_each(|file| keep(file));
    args.stamp.iter().chain(&args.depfile).try_for_each(|path| require_other(path))?;
    let folder = SaveFolder::open(args.folder(), "generate", &args.overwrite)?;
    let mut files = generation.outputs.iter().flat_map(|(_, generated)| &generated.files);
    files.try_for_each(|file| folder.admit(&file.path, &file.contents))?;
    Ok(folder)
}

fn list(args: &GenerateArgs, generation: &Generation, out: &mut Output) -> Result<(), Failure> {
    for file in generation.outputs.iter().flat_map(|(_, generated)| &generated.files) {
        writeln!(out, "{}", name_of(&args.folder().join(&file.path)))?;
    }
    Ok(())
}

/// What make looks at: when all was done, and of which files.
fn stamp(args: &GenerateArgs, files: &[PathBuf]) -> Result<(), Failure> {
    let Some(stamp) = &args.stamp else { return Ok(()) };
    if let Some(path) = &args.depfile {
        let rule = depfile(stamp, files).ok_or_else(|| {
            Failure::new("a make rule cannot contain a file name with a line break")
                .help("rename it, or omit `--depfile`")
        })?;
        save(path, rule.as_bytes())?;
    }
    let folder = stamp.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(folder)
        .and_then(|()| fs::write(stamp, "done\n"))
        .map_err(|error| Failure::new(format_args!("cannot write `{}`: {error}", name_of(stamp))))
}

/// What the arguments ask for.
/// A template can ask for any amount of memory. Then the command ends, and no other program.
#[cfg(target_os = "linux")]
fn limit_memory() {
    use nix::sys::resource::{Resource, getrlimit, setrlimit};
    const MOST: u64 = 4 << 30;
    if let Ok((soft, hard)) = getrlimit(Resource::RLIMIT_AS) {
        // a lower limit is that of the user
        let _ = setrlimit(Resource::RLIMIT_AS, soft.min(MOST), hard);
    }
}

fn request(args: &GenerateArgs) -> Result<Request, Failure> {
    let targets: Result<Vec<Target>, _> = args.targets.iter().map(|name| Target::named(name)).collect();
    Ok(Request {
        file: args.file.clone(),
        reading: args.input.reading(),
        patches: Vec::new(),
        check: args.config.check(&args.profiles),
        deny: args.deny,
        baseline: args.baseline.clone(),
        implicit_pdos: args.expand.implicit_pdos,
        force: args.force,
        targets: targets.map_err(Failure::new)?,
        conversions: Vec::new(),
        options: args.options.given(),
        sizes: args.report.is_some(),
        room: MemoryLimits { flash: args.max_flash, ram: args.max_ram },
    })
}

/// Errors in the description are findings, everything else is a failure.
fn refused(error: Error) -> Result<Outcome, Failure> {
    match error {
        Error::Findings { ref report, .. } => {
            tell(report);
            Failure::new(error).help("fix them, lower the severity of a rule with `--severity`, or generate anyway with `--force`").print();
            Ok(Outcome::Findings)
        }
        Error::Input(error) => Err(error.into()),
        Error::Profile(error) => Err(error.into()),
        error @ Error::TooLarge { .. } => {
            Failure::new(&error).maybe_help(error.help()).print();
            Ok(Outcome::Findings)
        }
        error => {
            if let Some(report) = error.report() {
                tell(&report);
            }
            Err(Failure::new(&error).maybe_help(error.help()))
        }
    }
}

fn facts(checked: &CheckedDescription, generation: &Generation) -> String {
    let mut tally = Tally::default();
    tally.add(&checked.findings);
    let warnings = tally.warnings + checked.of_config.len();
    let found = match (tally.errors, warnings) {
        (0, 0) => "no errors".to_owned(),
        (0, _) => format!("no errors, {} (run `objdict check`)", plural(warnings, "warning")),
        (errors, _) => {
            let (errors, warnings) = (plural(errors, "error"), plural(warnings, "warning"));
            format!("{errors} and {warnings} in the description (run `objdict check`)")
        }
    };
    format!("{} objects, {} entries, {found}", generation.objects, generation.entries)
}
