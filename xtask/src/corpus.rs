//! A run over a folder of real files: nothing may panic, every file prints back byte-identical, converts there and back
//! without a loss, is fixed and put in order without harm, and the table shows which rules fire how often.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fs, io};

use objdict::diagnostic::{Severity, Tool};
use objdict::format::{self, Format, ReadError};
use objdict::lint::Options;
use objdict::source::SourceOptions;

/// What one file gave.
struct Outcome {
    bytes: usize,
    round_trip: bool,
    errors: usize,
    /// What does not come back of a conversion there and back.
    lost: Vec<String>,
    /// Findings per rule, with those about every tool.
    rules: BTreeMap<&'static str, usize>,
    time: Duration,
}

/// Runs over `folder` and prints the table; fails when a file panics or does not print back. The number of files that each
/// rule fires on goes into the file `shares`.
pub(crate) fn run(folder: &Path, generate: bool, shares: Option<&Path>) -> Result<(), String> {
    let mut files = Vec::new();
    collect(folder, &mut files).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    files.sort();
    let mut outcomes = Vec::new();
    let mut failures = Vec::new();
    let mut foreign = 0;
    for file in &files {
        match catch_unwind(|| read(file)) {
            Ok(Ok(None)) => foreign += 1,
            Ok(Ok(Some(outcome))) if outcome.round_trip => {
                failures.extend(outcome.lost.iter().map(|lost| format!("{}: {lost}", file.display())));
                outcomes.push((file, outcome));
            }
            Ok(Ok(Some(_))) => failures.push(format!("{}: not printed back byte-identical", file.display())),
            Ok(Err(error)) => failures.push(format!("{}: {error}", file.display())),
            Err(_) => failures.push(format!("{}: panic", file.display())),
        }
    }
    print!("{}", table(&outcomes));
    if let Some(file) = shares {
        let fired = outcomes.iter().flat_map(|(_, outcome)| outcome.rules.keys().copied());
        crate::shares::write(file, fired, outcomes.len())?;
    }
    if generate {
        let sound: Vec<&Path> = outcomes
            .iter()
            .filter(|(_, outcome)| outcome.errors == 0)
            .map(|(file, _)| file.as_path())
            .collect();
        let (table, mut failed) = crate::targets::table(&sound, crate::targets::Selection::default())?;
        println!("{table}");
        failures.append(&mut failed);
    }
    let whole = |sound: bool| {
        let is_meant = |outcome: &Outcome| !sound || outcome.errors == 0;
        let all = outcomes.iter().filter(|(_, outcome)| is_meant(outcome));
        let (whole, lossy): (Vec<_>, Vec<_>) = all.partition(|(_, outcome)| outcome.lost.is_empty());
        format!("{} of {}", whole.len(), whole.len() + lossy.len())
    };
    println!(
        "{} files come back whole from the other syntax, {} of those without an error",
        whole(false),
        whole(true)
    );
    println!("{} files, {foreign} of other technologies, {} failures", files.len(), failures.len());
    if failures.is_empty() { Ok(()) } else { Err(failures.join("\n")) }
}

pub(crate) fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.file_name().and_then(|name| Format::from_name(&name.to_string_lossy())).is_some() {
            files.push(path);
        }
    }
    Ok(())
}

/// Reads, checks and converts a file; nothing comes of one that is something else.
fn read(file: &Path) -> Result<Option<Outcome>, String> {
    let bytes = fs::read(file).map_err(|error| error.to_string())?;
    let start = Instant::now();
    let description = match format::open(file, &SourceOptions::default()) {
        Ok(description) => description,
        Err(ReadError::Foreign { .. }) => return Ok(None),
        Err(error) => return Err(error.to_string()),
    };
    let findings = objdict::check(&description);
    let time = start.elapsed();
    let mut rules = BTreeMap::new();
    // what is bound to a tool is found only when the tool is asked about
    let options = Options { tools: Tool::ALL.to_vec(), ..Options::default() };
    for finding in &objdict::check_with(&description, &options) {
        *rules.entry(finding.rule.id).or_default() += 1;
    }
    let errors = findings.iter().filter(|finding| finding.severity == Severity::Error).count();
    let round_trip = description.print() == bytes;
    let mut lost = crate::round_trip::problems(description.device(), description.format());
    lost.extend(crate::changes::problems(description, &findings));
    Ok(Some(Outcome { bytes: bytes.len(), round_trip, errors, lost, rules, time }))
}

fn table(outcomes: &[(&PathBuf, Outcome)]) -> String {
    let mut rules: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for (_, outcome) in outcomes {
        for (rule, count) in &outcome.rules {
            let row = rules.entry(rule).or_default();
            row.0 += 1;
            row.1 += count;
        }
    }
    let mut rows: Vec<_> = rules.into_iter().collect();
    rows.sort_by_key(|&(rule, (files, _))| (std::cmp::Reverse(files), rule));
    let total = outcomes.len().max(1);
    let mut text = String::from("| rule | severity | files | share | findings |\n|---|---|---|---|---|\n");
    for (rule, (files, findings)) in rows {
        let severity = objdict::registry::rule(rule).map_or(String::new(), |rule| rule.severity.to_string());
        let share = 100.0 * files as f64 / total as f64;
        let _ = writeln!(text, "| {rule} | {severity} | {files} | {share:.1} % | {findings} |");
    }
    let bytes: usize = outcomes.iter().map(|(_, outcome)| outcome.bytes).sum();
    let time: Duration = outcomes.iter().map(|(_, outcome)| outcome.time).sum();
    let clean = outcomes.iter().filter(|(_, outcome)| outcome.rules.is_empty()).count();
    let sound = outcomes.iter().filter(|(_, outcome)| outcome.errors == 0).count();
    let _ = writeln!(
        text,
        "\n{} files read, {clean} without any finding, {sound} without an error; {:.1} MB in {:.0} ms",
        outcomes.len(),
        bytes as f64 / 1e6,
        time.as_secs_f64() * 1e3
    );
    text
}
