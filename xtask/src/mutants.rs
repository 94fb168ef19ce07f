//! Corrupted copies of real files: checks, fixes and formatting must not panic.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::{fs, thread};

use objdict::diagnostic::{Applicability, Tool};
use objdict::format::{self, Format};
use objdict::lint::Options;
use objdict::source::{SourceFile, SourceOptions};

use crate::mutate::Mutator;

/// Larger files are skipped: they would only repeat the same cases.
const MAX_SIZE: u64 = 256 << 10;

/// Makes `count` mutants of the files below `folder`, by turns, and reads, checks, fixes and arranges each; fails when one
/// of them panics.
pub(crate) fn run(folder: &Path, count: usize) -> Result<(), String> {
    let mut files = Vec::new();
    crate::corpus::collect(folder, &mut files)
        .map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    files.sort();
    files.retain(|file| fs::metadata(file).is_ok_and(|data| data.len() <= MAX_SIZE));
    let texts: Vec<(Format, Vec<u8>)> = files
        .iter()
        .filter_map(|file| Some((Format::from_name(&file.to_string_lossy())?, fs::read(file).ok()?)))
        .collect();
    if texts.is_empty() {
        return Err(format!("{} has no descriptions", folder.display()));
    }
    let options = everything();
    let (next, failures) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= count {
                        break;
                    }
                    let (format, bytes) = mutant(&texts, number);
                    let attempt = AssertUnwindSafe(|| examine(format, bytes, &options, number % 16 == 0));
                    if catch_unwind(attempt).is_err()
                        && let Ok(mut failures) = failures.lock()
                    {
                        failures.push(number);
                    }
                }
            });
        }
    });
    let failures = failures.into_inner().unwrap_or_default();
    println!("{count} mutants of {} files, {} panics", texts.len(), failures.len());
    if failures.is_empty() { Ok(()) } else { Err(format!("mutants {failures:?} panic")) }
}

/// A mutant is made of its number alone, so that one that fails can be made again.
fn mutant(texts: &[(Format, Vec<u8>)], number: usize) -> (Format, Vec<u8>) {
    let mut mutator = Mutator::new(number as u64 + 1);
    let (format, text) = &texts[number % texts.len()];
    let other = mutator.below(texts.len());
    (*format, mutator.mutate(text, &texts[other].1))
}

/// All profiles and all tools.
fn everything() -> Options {
    let mut options = Options::default();
    options.profiles = objdict::profile::standard().cloned().map(Arc::new).collect();
    options.tools = Tool::ALL.to_vec();
    options
}

fn examine(format: Format, bytes: Vec<u8>, options: &Options, fixes: bool) {
    let Ok(source) = SourceFile::from_bytes("mutant", bytes, &SourceOptions::default()) else { return };
    let description = format::read(source, format);
    let findings = objdict::check_with(&description, options);
    for finding in &findings {
        for label in &finding.labels {
            description.span_of(&label.at);
        }
    }
    if fixes {
        let _ = description.arranged();
        objdict::fix(description, Applicability::Unsafe, objdict::check);
    }
}
