//! `objdict network build`.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::super::args::{NetworkBuildArgs, NetworkTarget};
use super::super::ending::{Failure, Outcome, note, tell};
use super::super::input::name_of;
use super::super::lock;
use super::super::settings::{CommandSettings, SettingsArgs};
use super::super::stdout::Output;
use super::super::written_files::SaveFolder;
use super::{findings, names_of, open_one};
use objdict_build::pipeline::report_lines;
use objdict_generate::{Options, Target, generate};
use objdict_model::diagnostic::plural;
use objdict_model::diagnostic::{Diagnostic, Severity, one_line};
use objdict_network::{DcfgenMode, LelyOptions};
use objdict_network_file::{Build, BuiltFile};
use objdict_project::report::{Subject, Tally, grouped, listed};

pub(super) fn run(args: &NetworkBuildArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let (input, lock) = (&args.input, args.input.paths.lock.as_deref());
    let is_locked = lock.is_some_and(Path::exists);
    let file = match is_locked {
        true => open_one(&args.files, input)?,
        false => open_one(&args.files, &input.without_lock())?,
    };
    let settings = SettingsArgs::from(&input.config);
    let findings = findings(&file, &args.files[0], &mut CommandSettings::new(&settings)?)?;
    // as `network check` shows and counts them
    let reported: Vec<_> = Subject::of_network(&file, findings.clone())
        .into_iter()
        .map(|(subject, findings)| (subject, grouped(subject, findings)))
        .collect();
    let mut tally = Tally::default();
    reported.iter().for_each(|(_, findings)| tally.add(findings));
    // what dcfgen has no word about, it builds
    let is_clear = findings.iter().all(|finding| finding.severity < Severity::Error || finding.is_understood);
    // the full report is that of `network check`
    let is_error = |finding: &Diagnostic| finding.severity == Severity::Error;
    for (subject, findings) in &reported {
        let errors = findings.clone().filter_map(|finding| is_error(&finding).then_some(finding));
        if !errors.is_empty() {
            tell(&listed(*subject, &errors)?);
        }
    }
    // what is not read as its author means it is not built; dcfgen reads some of it
    let is_misread = file.text_errors().any(|error| !(args.strict_dcfgen && error.is_understood));
    if tally.errors > 0 && (!args.force || is_misread) && !(args.strict_dcfgen && is_clear) {
        let failure = Failure::new(format_args!("{tally}, so nothing is built"));
        let help = match is_misread {
            true => {
                "correct them; `--force` does not apply to keys, values and descriptions that cannot be read"
            }
            false => "correct them; `--force` builds anyway",
        };
        failure.help(help).print();
        return Ok(Outcome::Findings);
    }
    let mut others = Tally::default();
    for (_, findings) in reported {
        others.add(&findings.filter_map(|finding| (!is_error(&finding)).then_some(finding)));
    }
    if others.files_with_findings > 0 {
        note(&format!("{others}: `objdict network check {}` lists them\n", names_of(&args.files)));
    }
    let mode = if args.strict_dcfgen { DcfgenMode::Exact } else { DcfgenMode::Corrected };
    let mut build = file.build(mode).map_err(Failure::new)?;
    if let Some(time) = args.configured_at {
        build = build.configured_at(time);
    }
    let files = files(args, &build, mode)?;
    let is_verified = !args.verify || is_verified(args, &build, &files)?;
    if !is_verified && !args.force {
        return Ok(Outcome::Findings);
    }
    let folder = SaveFolder::open(&args.output, &origin(args), &args.overwrite)?;
    let contents: Vec<_> = files.iter().map(|file| (file.name.as_str(), file.bytes.as_slice())).collect();
    for name in folder.replace(&contents)? {
        let path = args.output.join(name);
        note(&format!("note: `{}` is from an earlier build\n", name_of(&path)));
    }
    if let Some(path) = lock {
        let old = file.network().map(|network| &network.lock).filter(|_| is_locked);
        lock::update(path, old, &build.lock())?;
    }
    out.summary(format_args!("{}: {}", name_of(&args.output), plural(files.len(), "file")))?;
    Ok(if is_verified { Outcome::Clean } else { Outcome::Findings })
}

/// Whether nothing is against the files that are built.
fn is_verified(args: &NetworkBuildArgs, build: &Build<'_>, files: &[BuiltFile]) -> Result<bool, Failure> {
    let objections = match args.target {
        // these have no configurations of nodes: what other programs send for them is replayed
        NetworkTarget::Busyml | NetworkTarget::C | NetworkTarget::Rust => {
            build.verify(&build.concise().map_err(Failure::new)?)
        }
        _ => build.verify(files),
    };
    let objections = objections.map_err(Failure::new)?;
    for objection in &objections {
        tell(&format!("error: {}\n", one_line(&objection.to_string())));
    }
    if !objections.is_empty() && !args.force {
        let count = plural(objections.len(), "objection");
        let failure = Failure::new(format_args!("{count}, so nothing is built"));
        failure.help("correct the descriptions or the settings; `--force` builds anyway").print();
    }
    Ok(objections.is_empty())
}

/// What builds the files: a build of the same network for the same target replaces all of them.
fn origin(args: &NetworkBuildArgs) -> String {
    let name =
        |path: &PathBuf| path.file_name().map(|name| one_line(&name.to_string_lossy())).unwrap_or_default();
    let names: Vec<String> = args.files.iter().map(name).collect();
    let target = args.target.to_possible_value();
    let target = target.as_ref().map_or("", |value| value.get_name());
    format!("network build --target {target} {}", names.join(" "))
}

fn files(args: &NetworkBuildArgs, build: &Build<'_>, mode: DcfgenMode) -> Result<Vec<BuiltFile>, Failure> {
    let files = match args.target {
        NetworkTarget::Lely => build.lely(&LelyOptions { mode, remote_pdos: args.remote_pdo }),
        NetworkTarget::Concise => build.concise(),
        NetworkTarget::Dcf => build.dcfs(),
        NetworkTarget::Manager => build.manager().map(|file| vec![file]),
        NetworkTarget::Busyml => build.bus_yml(),
        NetworkTarget::Cpj => build.node_list(),
        NetworkTarget::C => return tables(build, "c"),
        NetworkTarget::Rust => return tables(build, "rust"),
    };
    files.map_err(Failure::new)
}

/// The tables of the manager for its own firmware.
fn tables(build: &Build<'_>, target: &str) -> Result<Vec<BuiltFile>, Failure> {
    let device = build.manager_device().map_err(Failure::new)?;
    let target = Target::named(target).map_err(Failure::new)?;
    let options = Options { node_id: device.node_id(), ..Options::default() };
    let generated = generate(&device, target, &options).map_err(Failure::new)?;
    for item in generated.notes {
        note(&report_lines(target.name(), &item));
    }
    Ok(generated.files.into_iter().map(|file| BuiltFile { name: file.path, bytes: file.contents }).collect())
}
