//! `objdict generate`.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::args::GenerateArgs;
use super::input::{Input, name_of};
use super::output::Output;
use super::save::{Saved, save};
use super::table::Table;
use super::{Failure, Outcome, tell};
use crate::diagnostic::{At, Diagnostic, Findings, Severity};
use crate::generate::{GenerateError, Generated, Note, Options, Target, generate, renames};
use crate::lint;
use crate::model::{Address, Device, Place};
use crate::report::{Report, Tally, Text};
use crate::source::hash;

pub(super) fn run(args: &GenerateArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let (kind, input) = args.input.read_one(&args.file)?;
    let (device, findings) = match &input {
        Input::Description(description) => (description.device(), crate::check(description)),
        Input::Device(device) => (device.as_ref(), lint::check(device, &lint::Options::default())),
        Input::Configuration(_) | Input::NodeList(_) => {
            let (file, kind) = (name_of(&args.file), kind.name());
            let message = format!("`{file}` is read as {kind} and describes no device");
            return Err(Failure::new(message).help("name an EDS or DCF"));
        }
    };
    if findings.has_errors() && !args.force {
        report_errors(&input, findings)?;
        Failure::new("nothing was generated, for a tool or a device would do wrong with this file")
            .help("mend the errors, or use `--force`")
            .print();
        return Ok(Outcome::Findings);
    }
    let device = args.expand.device(device);
    let source_hash = match &input {
        Input::Description(description) => Some(hash(description.source().text().as_bytes())),
        _ => None,
    };
    let outputs = outputs(args, &device, source_hash)?;
    let mut table = Table::new(["", "", "", ""], usize::MAX);
    for (target, generated) in &outputs {
        for file in &generated.files {
            let path = args.out.join(&file.path);
            let saved = match save(&path, &file.contents)? {
                Saved::Written => "",
                Saved::Unchanged => "unchanged",
            };
            let size = format!("{} bytes", file.contents.len());
            table.row([format!("  {}", target.name()), path.display().to_string(), size, saved.to_owned()]);
        }
    }
    writeln!(out, "{}: {}", name_of(&args.file), facts(&device, &findings))?;
    table.write(out)?;
    out.flush()?;
    for (target, generated) in &outputs {
        print_notes(*target, &generated.notes);
    }
    Ok(Outcome::Clean)
}

/// Everything that is to be written, before anything is.
fn outputs(
    args: &GenerateArgs,
    device: &Device,
    source_hash: Option<u64>,
) -> Result<Vec<(Target, Generated)>, Failure> {
    let options = options(args, source_hash)?;
    let mut outputs = Vec::new();
    let mut paths: BTreeMap<String, Target> = BTreeMap::new();
    for (position, name) in args.targets.iter().enumerate() {
        if args.targets[..position].contains(name) {
            continue;
        }
        let target = Target::named(name).map_err(Failure::new)?;
        let generated = generate(device, target, &options).map_err(|error| refusal(target, &error))?;
        for file in &generated.files {
            if let Some(other) = paths.insert(file.path.clone(), target) {
                let (first, second) = (other.name(), target.name());
                let message = format!("the targets `{first}` and `{second}` both write `{}`", file.path);
                return Err(Failure::new(message).help("generate them into two folders"));
            }
        }
        outputs.push((target, generated));
    }
    Ok(outputs)
}

fn options(args: &GenerateArgs, source_hash: Option<u64>) -> Result<Options, Failure> {
    let default = Options::default();
    Ok(Options {
        node_id: args.node_id,
        file_stem: stem(&args.file),
        string_capacity: args.string_capacity.unwrap_or(default.string_capacity),
        domain_capacity: args.domain_capacity.unwrap_or(default.domain_capacity),
        names: args.names.into(),
        renamed: args.rename.as_deref().map(names_in).transpose()?.unwrap_or_default(),
        prefix: args.prefix.clone(),
        module: args.module.clone(),
        groups: args.groups.clone(),
        source_hash,
    })
}

/// The names that a file gives to objects and entries.
fn names_in(path: &Path) -> Result<BTreeMap<Address, String>, Failure> {
    let name = name_of(path);
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::new(format_args!("cannot read `{name}`: {error}")))?;
    renames(&text).map_err(|error| {
        let line = error.line.map(|line| format!(":{line}")).unwrap_or_default();
        Failure::new(format_args!("{name}{line}: {error}"))
            .help("write a line as `\"2000sub1\" = \"target speed\"` for each name")
    })
}

fn refusal(target: Target, error: &GenerateError) -> Failure {
    if let GenerateError::NoEntries { notes } = error {
        print_notes(target, notes);
    }
    Failure::new(format_args!("target `{}`: {error}", target.name()))
}

fn print_notes(target: Target, notes: &[Note]) {
    let mut text = String::new();
    for note in notes {
        let what = if note.place == Place::device() { note.message.clone() } else { note.to_string() };
        text.push_str(&format!("note: {}: {what}\n", target.name()));
        if let Some(help) = &note.help {
            text.push_str(&format!("  help: {help}\n"));
        }
    }
    tell(&text);
}

/// The findings that stop the work, on the standard error.
fn report_errors(input: &Input, findings: Findings) -> Result<(), Failure> {
    let mut errors = Findings::new();
    for finding in findings.into_vec() {
        if finding.severity == Severity::Error {
            errors.push(finding);
        }
    }
    let mut text = Vec::new();
    if let Input::Description(description) = input {
        let mut report = Text::new(&mut text, false);
        report.file((&**description).into(), &errors)?;
        report.finish()?;
    } else {
        for error in &errors {
            writeln!(text, "{}: {}: {}", error.rule.id, place(error), error.message)?;
        }
    }
    tell(&String::from_utf8_lossy(&text));
    Ok(())
}

/// Where a finding about a device without a text is.
fn place(finding: &Diagnostic) -> String {
    match finding.labels.first().map(|label| &label.at) {
        Some(At::Place(place)) => place.to_string(),
        _ => Place::device().to_string(),
    }
}

fn facts(device: &Device, findings: &Findings) -> String {
    let entries: usize = device.objects.values().map(|object| object.entries().count()).sum();
    let mut tally = Tally::default();
    tally.add(findings);
    let found = match (tally.errors, tally.warnings) {
        (0, 0) => "no errors".to_owned(),
        (0, warnings) => format!("no errors, {warnings} warnings (`objdict check` tells them)"),
        (errors, _) => format!("{errors} errors, generated all the same"),
    };
    format!("{} objects, {entries} entries, {found}", device.objects.len())
}

/// The file's name without its last ending.
fn stem(file: &Path) -> String {
    let name = if file == Path::new("-") { PathBuf::from("device") } else { file.to_owned() };
    name.file_stem().map_or_else(|| "device".to_owned(), |stem| stem.to_string_lossy().into_owned())
}
