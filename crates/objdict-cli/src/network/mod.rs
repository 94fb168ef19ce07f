//! `objdict network`: several nodes and their manager.

mod boot;
mod build;
mod check;
mod diff;
mod graph;
mod show;
mod timing;
mod verify;

use std::io::Write;
use std::path::{Path, PathBuf};

#[cfg(feature = "schema")]
pub(super) use self::boot::BootJson as BootDocument;
#[cfg(feature = "schema")]
pub(super) use self::show::NetworkJson as ShowDocument;
#[cfg(feature = "schema")]
pub(super) use self::timing::TimingJson as TimingDocument;
use super::args::{NetworkCommand, NetworkFormat, NetworkInitArgs, NetworkInputArgs, NetworkSchemaArgs};
use super::ending::{Failure, Outcome, tell};
use super::input::{name_of, source_name};
use super::settings::CommandSettings;
use super::stdout::Output;
use super::written_files::keep;
use objdict_format::ReadError;
use objdict_format::identify::ContentKind;
use objdict_model::diagnostic::{Diagnostic, Findings, Severity};
use objdict_model::diagnostic::{one_line, plural};
use objdict_network::{Overview, Resolved};
use objdict_network_file::{NetworkFile, init, schema};
use objdict_project::report::Subject;

pub(super) fn run(command: &NetworkCommand, out: &mut Output) -> Result<Outcome, Failure> {
    match command {
        NetworkCommand::Check(args) => check::run(args, out),
        NetworkCommand::Build(args) => build::run(args, out),
        NetworkCommand::Verify(args) => verify::run(args, out),
        NetworkCommand::Boot(args) => boot::run(args, out),
        NetworkCommand::Timing(args) => timing::run(args, out),
        NetworkCommand::Show(args) => show::run(args, out),
        NetworkCommand::Graph(args) => graph::run(args, out),
        NetworkCommand::Diff(args) => diff::run(args, out),
        NetworkCommand::Init(args) => print_start(args, out),
        NetworkCommand::Schema(args) => print_schema(args, out),
    }
}

/// Reads a network; none of its files is written to.
pub(super) fn open(path: &Path, input: &NetworkInputArgs) -> Result<NetworkFile, Failure> {
    keep(path);
    Ok(kept(NetworkFile::open(path, &input.options(path)?).map_err(Failure::new)?))
}

fn kept(file: NetworkFile) -> NetworkFile {
    file.files.iter().for_each(|path| keep(path));
    file
}

/// The network of the nodes that files describe.
fn of_descriptions(paths: &[PathBuf], input: &NetworkInputArgs) -> Result<NetworkFile, Failure> {
    let options = input.options(paths.first().map_or(Path::new(""), PathBuf::as_path))?;
    Ok(kept(NetworkFile::of_descriptions(paths, &options)?))
}

/// The findings of a network with the severities of its configuration.
fn findings(file: &NetworkFile, path: &Path, settings: &mut CommandSettings) -> Result<Findings, Failure> {
    let project = settings.project_of(path)?;
    Ok(settings.options(path, project.as_deref()).severities.apply(file.check()))
}

/// The networks among files, and the descriptions of nodes. One that cannot be opened is found out when it is read.
fn parted(paths: &[PathBuf]) -> (Vec<PathBuf>, Vec<PathBuf>) {
    paths.iter().cloned().partition(|path| NetworkFile::is_network(path).unwrap_or(true))
}

/// Reads the network of one file, or of the nodes that several files describe.
fn open_one(paths: &[PathBuf], input: &NetworkInputArgs) -> Result<NetworkFile, Failure> {
    let (networks, descriptions) = parted(paths);
    match (networks.as_slice(), descriptions.as_slice()) {
        ([], descriptions) => of_descriptions(descriptions, input),
        ([network], []) => open(network, input),
        ([network, ..], _) => {
            let message = format!("`{}` is a network, so no other file can be named", name_of(network));
            Err(Failure::new(message).help("name one network, or the descriptions of its nodes"))
        }
    }
}

/// The names of files, as a command takes them.
fn names_of(paths: &[PathBuf]) -> String {
    paths.iter().map(|path| name_of(path)).collect::<Vec<_>>().join(" ")
}

/// The same as JSON has them.
fn source_names_of(paths: &[PathBuf]) -> String {
    paths.iter().map(|path| source_name(path)).collect::<Vec<_>>().join(" ")
}

/// Reads a network that something is made of. One whose text has errors is refused; the errors of the network itself are left to
/// `network check`.
pub(super) fn open_to_use(paths: &[PathBuf], input: &NetworkInputArgs) -> Result<NetworkFile, Failure> {
    let file = open_one(paths, input)?;
    refuse_misread(&file, paths)?;
    let errors = file.check().iter().filter(|finding| finding.severity == Severity::Error).count();
    if errors > 0 {
        let warning = format!("the network has {}, so its behaviour may differ", plural(errors, "error"));
        tell(&format!(
            "warning: {warning}\n  help: `objdict network check {}` lists them\n",
            names_of(paths)
        ));
    }
    Ok(file)
}

/// Refuses a network whose text has errors.
pub(super) fn refuse_misread(file: &NetworkFile, paths: &[PathBuf]) -> Result<(), Failure> {
    let name = file.source.name();
    let subject = Subject::from(file);
    let lines: Vec<String> =
        file.text_errors().map(|error| error.line(&file.source, |at| subject.span_of(at))).collect();
    let message = match (lines.is_empty(), file.network()) {
        (true, Some(_)) => return Ok(()),
        (true, None) => format!("`{name}` is not a network"),
        _ => format!("`{name}` has errors, so no output is created\n{}", lines.join("\n")),
    };
    // descriptions that cannot be read have one remedy, such as `--allow-path`
    let is_unread = |error: &&Diagnostic| error.rule.id == "network/unreadable-node";
    let mut helps: Vec<_> =
        file.text_errors().map(|error| Some(error).filter(is_unread)?.help.as_ref()).collect();
    helps.dedup();
    let help = match helps.as_slice() {
        [Some(help)] => one_line(&help.shown()),
        _ => format!("`objdict network check {}` shows them in the text", names_of(paths)),
    };
    Err(Failure::of_lines(message.lines()).help(help))
}

/// The same with the configuration of its nodes.
fn resolved(paths: &[PathBuf], input: &NetworkInputArgs) -> Result<Resolved, Failure> {
    Ok(open_to_use(paths, input)?.into_resolved().unwrap_or_default())
}

fn overview(paths: &[PathBuf], input: &NetworkInputArgs) -> Result<Overview, Failure> {
    let resolved = resolved(paths, input)?;
    Ok(Overview::new(resolved.network(), resolved.compiled()))
}

fn print_start(args: &NetworkInitArgs, out: &mut Output) -> Result<Outcome, Failure> {
    args.files.iter().for_each(|path| keep(path));
    let text = init(&args.files, &args.paths.options()).map_err(|error| match error {
        ReadError::Foreign { ref found, .. } if found.kind == ContentKind::Unknown => {
            Failure::new(error).help("name descriptions or node lists")
        }
        error => error.into(),
    })?;
    out.raw()?.write_all(text.as_bytes())?;
    Ok(Outcome::Clean)
}

fn print_schema(args: &NetworkSchemaArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let schema = match args.format {
        NetworkFormat::Bus => schema::bus_yml(),
        NetworkFormat::Network => schema::network_toml(),
    };
    out.pretty_json(&schema)?;
    Ok(Outcome::Clean)
}
