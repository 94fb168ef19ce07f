//! Corrupted copies of real files, the same in every run: what they break is broken for everyone.

mod targets;

use std::ffi::OsStr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use std::{fs, thread};

use objdict::format::{self, Format, json};
use objdict::source::SourceOptions;

use self::targets::{FUZZED, Fuzzed};
use crate::mutate::Mutator;

/// A file that is corrupted, and the format that it is read as.
struct Seed {
    format: Format,
    ending: String,
    bytes: Vec<u8>,
}

/// How many mutants each part of the library gets.
#[derive(Clone, Copy)]
pub(crate) enum Budget {
    Count(usize),
    Time(Duration),
}

impl Budget {
    /// The budget of a word such as `10000` or `20s`.
    pub(crate) fn parse(word: &str) -> Option<Self> {
        match word.strip_suffix('s') {
            Some(seconds) => seconds.parse().ok().map(|seconds| Self::Time(Duration::from_secs(seconds))),
            None => word.parse().ok().map(Self::Count),
        }
    }

    fn allows(self, number: usize, start: Instant) -> bool {
        match self {
            Self::Count(count) => number < count,
            Self::Time(time) => start.elapsed() < time,
        }
    }
}

/// Gives every part of the library corrupted copies of the files below `folder` that have at most `size` bytes, by turns;
/// fails when one of them panics or breaks a promise.
pub(crate) fn run(folder: &Path, size: usize, budget: Budget, only: Option<&str>) -> Result<(), String> {
    let seeds = seeds(folder, size).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    let mut failures = Vec::new();
    for fuzzed in FUZZED.iter().filter(|fuzzed| only.is_none_or(|only| only == fuzzed.name)) {
        let seeds: Vec<&Seed> =
            seeds.iter().filter(|seed| fuzzed.endings.contains(&seed.ending.as_str())).collect();
        if seeds.is_empty() {
            println!("{}: no file to start from", fuzzed.name);
            continue;
        }
        let (count, broken) = broken(fuzzed, &seeds, budget);
        println!("{}: {count} mutants of {} files, {} failures", fuzzed.name, seeds.len(), broken.len());
        failures.extend(broken.iter().map(|number| format!("{} {number}", fuzzed.name)));
    }
    if failures.is_empty() { Ok(()) } else { Err(format!("mutants fail: {}", failures.join(", "))) }
}

/// How many mutants a part of the library got, and those that it fails on.
fn broken(fuzzed: &Fuzzed, seeds: &[&Seed], budget: Budget) -> (usize, Vec<usize>) {
    let (next, failures) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let (done, start) = (AtomicUsize::new(0), Instant::now());
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if !budget.allows(number, start) {
                        break;
                    }
                    done.fetch_add(1, Ordering::Relaxed);
                    let (format, bytes) = mutant(seeds, number);
                    if catch_unwind(AssertUnwindSafe(|| (fuzzed.run)(format, &bytes))).is_err()
                        && let Ok(mut failures) = failures.lock()
                    {
                        failures.push(number);
                        keep(fuzzed, number, &bytes);
                    }
                }
            });
        }
    });
    let mut failures = failures.into_inner().unwrap_or_default();
    failures.sort_unstable();
    (done.into_inner(), failures)
}

/// Writes what fails where the variable `OBJDICT_FUZZ_KEEP` says.
fn keep(fuzzed: &Fuzzed, number: usize, bytes: &[u8]) {
    if let Some(folder) = std::env::var_os("OBJDICT_FUZZ_KEEP") {
        let file = PathBuf::from(folder).join(format!("{}-{number}", fuzzed.name));
        if let Err(error) = fs::write(&file, bytes) {
            eprintln!("cannot write {}: {error}", file.display());
        }
    }
}

/// A mutant is made of its number alone, so that one that fails can be made again.
fn mutant(seeds: &[&Seed], number: usize) -> (Format, Vec<u8>) {
    let mut mutator = Mutator::new(number as u64 + 1);
    let seed = seeds[mutator.below(seeds.len())];
    let other = mutator.below(seeds.len());
    (seed.format, mutator.mutate(&seed.bytes, &seeds[other].bytes))
}

/// The files below a folder, and each description as JSON too.
fn seeds(folder: &Path, size: usize) -> std::io::Result<Vec<Seed>> {
    let mut files = Vec::new();
    collect(folder, &mut files)?;
    files.sort();
    let mut seeds = Vec::new();
    for file in files {
        let bytes = fs::read(&file)?;
        if bytes.len() > size {
            continue;
        }
        let ending = file.extension().and_then(OsStr::to_str).unwrap_or_default().to_ascii_lowercase();
        let format = Format::from_name(&ending).unwrap_or(Format::Eds);
        if Format::from_name(&ending).is_some()
            && let Ok(description) = format::open(&file, &SourceOptions::default())
        {
            let bytes = json::write_device(description.device()).into_bytes();
            seeds.push(Seed { format, ending: "json".to_owned(), bytes });
        }
        seeds.push(Seed { format, ending, bytes });
    }
    Ok(seeds)
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() { collect(&path, files)? } else { files.push(path) }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn libfuzzer_has_every_part() {
        let manifest = include_str!("../../../fuzz/Cargo.toml").parse::<toml::Table>().unwrap();
        let bins = manifest["bin"].as_array().unwrap().iter();
        let names: Vec<&str> = bins.filter_map(|bin| bin["name"].as_str()).collect();
        assert_eq!(names, FUZZED.each_ref().map(|fuzzed| fuzzed.name));
    }

    /// A few of many: the gate has the time for more.
    #[test]
    fn corrupted_fixtures_break_nothing() {
        let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures");
        assert_eq!(run(&fixtures, 6 << 10, Budget::Count(50), None), Ok(()));
    }
}
