//! Every target for each description below a folder: what is generated compiles, or it is said why nothing is generated.

mod compile;
mod crates;
mod hostile;
mod table;

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, thread};

use objdict::diagnostic::Severity;
use objdict::format;
use objdict::generate::{CTable, GenerateError, Options, Target, generate};
use objdict::model::Device;
use objdict::source::SourceOptions;

use compile::{Call, Tools};
use table::Column;

/// Which descriptions are tried, and how.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Selection<'a> {
    /// Those with an error finding too.
    pub(crate) damaged: bool,
    /// With names that are an attack on the generated code.
    pub(crate) hostile: bool,
    /// One trial only.
    pub(crate) only: Option<&'a str>,
}

/// A target with its options, and what becomes of the files.
struct Trial {
    name: &'static str,
    target: &'static str,
    table: CTable,
    limits: bool,
    /// How the files are compiled.
    calls: fn(&Tools) -> Vec<Call>,
}

/// Everything that is tried. What the crates of others read is compiled in one go, see [`crates`].
const TRIALS: &[Trial] = &[
    Trial { name: "rust", target: "rust", calls: compile::rust, ..PLAIN },
    Trial { name: "c", target: "c", calls: compile::c, ..PLAIN },
    Trial { name: "c --table structs", target: "c", table: CTable::Structs, calls: compile::c, ..PLAIN },
    Trial { name: "canopennode", target: "canopennode", calls: compile::canopennode, ..PLAIN },
    Trial {
        name: "canopennode --limits",
        target: "canopennode",
        limits: true,
        calls: compile::canopennode,
        ..PLAIN
    },
    Trial { name: "canopen-stack", target: "canopen-stack", calls: compile::canopen_stack, ..PLAIN },
    Trial { name: "microcanopen", target: "microcanopen", calls: compile::microcanopen, ..PLAIN },
    Trial { name: "objdict-macros", target: "objdict-macros", calls: compile::c, ..PLAIN },
    Trial { name: "canfestival", target: "canfestival", calls: compile::canfestival, ..PLAIN },
    Trial { name: "canopennode-v1", target: "canopennode-v1", calls: compile::canopennode_v1, ..PLAIN },
    Trial { name: "lely", target: "lely", calls: compile::lely, ..PLAIN },
    Trial { name: "canopen-rs", target: "canopen-rs", calls: compile::canopen_rs, ..PLAIN },
    Trial { name: "zencan", target: "zencan", ..PLAIN },
    Trial { name: "concise", target: "concise", ..PLAIN },
];

const PLAIN: Trial =
    Trial { name: "", target: "", table: CTable::Compact, limits: false, calls: |_| Vec::new() };

/// Tries all targets, prints the table, and fails when something does not compile.
pub(crate) fn run(folder: &Path, selection: Selection<'_>) -> Result<(), String> {
    let mut files = Vec::new();
    crate::corpus::collect(folder, &mut files).map_err(|error| format!("{}: {error}", folder.display()))?;
    files.sort();
    files.retain(|file| is_meant(file, selection.damaged));
    let files: Vec<&Path> = files.iter().map(PathBuf::as_path).collect();
    let (text, failures) = table(&files, selection)?;
    print!("{text}");
    if failures.is_empty() { Ok(()) } else { Err(failures.join("\n")) }
}

/// Whether a file is a description of CANopen, and one without an error finding unless those are meant too.
fn is_meant(file: &Path, damaged: bool) -> bool {
    let Ok(description) = format::open(file, &SourceOptions::default()) else { return false };
    damaged || objdict::check(&description).iter().all(|finding| finding.severity != Severity::Error)
}

/// The table, and what failed.
pub(crate) fn table(files: &[&Path], selection: Selection<'_>) -> Result<(String, Vec<String>), String> {
    let trials = TRIALS.iter().filter(|trial| selection.only.is_none_or(|only| only == trial.name));
    let columns: Vec<Mutex<Column>> = trials.map(|trial| Mutex::new(Column::new(trial.name))).collect();
    let trials: Vec<&Trial> =
        TRIALS.iter().filter(|trial| selection.only.is_none_or(|only| only == trial.name)).collect();
    if trials.is_empty() {
        let names: Vec<&str> = TRIALS.iter().map(|trial| trial.name).collect();
        return Err(format!("known are {}", names.join(", ")));
    }
    let tools = Tools::find(trials.iter().any(|trial| matches!(trial.target, "canopen-rs" | "zencan")))?;
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        let workers = thread::available_parallelism().map_or(1, usize::from);
        for _ in 0..workers {
            scope.spawn(|| {
                loop {
                    let at = next.fetch_add(1, Ordering::Relaxed);
                    let Some(file) = files.get(at) else { break };
                    of_file(at, file, selection, (&trials, &columns), &tools);
                }
            });
        }
    });
    let mut columns: Vec<Column> = columns
        .into_iter()
        .map(|column| column.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner))
        .collect();
    if let Some(column) = columns.iter_mut().find(|column| column.name == "zencan") {
        crates::zencan(files, &tools, column)?;
    }
    let failures = columns.iter().flat_map(Column::failures).collect();
    Ok((table::print(files.len(), &columns), failures))
}

fn of_file(
    at: usize,
    file: &Path,
    selection: Selection<'_>,
    (trials, columns): (&[&Trial], &[Mutex<Column>]),
    tools: &Tools,
) {
    let Ok(description) = format::open(file, &SourceOptions::default()) else { return };
    let mut device = description.into_device();
    if selection.hostile {
        hostile::rename(&mut device);
    }
    for (trial, column) in trials.iter().zip(columns) {
        let outcome = try_target(at, &device, trial, tools);
        if let Ok(mut column) = column.lock() {
            column.add(&file.display().to_string(), outcome);
        }
    }
}

/// What came of a target for a description.
enum Outcome {
    /// Nothing is generated, for this reason.
    Refused(String),
    /// It compiles, or is kept for later; with the number of notes.
    Generated(usize),
    /// It does not compile.
    Failed(String),
}

fn try_target(at: usize, device: &Device, trial: &Trial, tools: &Tools) -> Outcome {
    let mut options = Options::default();
    options.table = trial.table;
    options.limits = trial.limits;
    let generated = match Target::named(trial.target).and_then(|target| generate(device, target, &options)) {
        Ok(generated) => generated,
        Err(GenerateError::NoEntries { .. }) => return Outcome::Refused("no entries".to_owned()),
        Err(GenerateError::Inexpressible(notes)) => {
            let first = notes.first().map(ToString::to_string).unwrap_or_default();
            return Outcome::Refused(format!("{first} ({} in all)", notes.len()));
        }
        Err(error) => return Outcome::Refused(error.to_string()),
    };
    let compiled = tempfile::tempdir().map_err(|error| error.to_string()).and_then(|folder| {
        for output in &generated.files {
            let path = match trial.target {
                "zencan" => tools.zencan_file(at),
                _ => folder.path().join(&output.path),
            };
            fs::write(path, &output.contents).map_err(|error| error.to_string())?;
        }
        let written: Vec<&str> = generated.files.iter().map(|output| output.path.as_str()).collect();
        let mut calls = (trial.calls)(tools).into_iter();
        calls.try_for_each(|call| call.run(folder.path(), &written, &generated.notes))
    });
    match compiled {
        Ok(()) => Outcome::Generated(generated.notes.len()),
        Err(problem) => Outcome::Failed(problem),
    }
}
