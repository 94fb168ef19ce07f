//! Corrupted descriptions: with lines and bytes lost or added, reading, checking, fixing and arranging them does
//! not panic. The mutations are the same in every run.

#[path = "../../xtask/src/mutate.rs"]
mod mutate;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, thread};

use objdict::diagnostic::{Applicability, Tool};
use objdict::format::{self, Format};
use objdict::lint::Options;
use objdict::source::{SourceFile, SourceOptions};

use self::mutate::Mutator;
use crate::support;

/// Corrupted descriptions; `cargo xtask mutants fixtures 10000` has the time for more.
const MUTANTS: usize = 1_000;

/// Larger fixtures take long and show nothing else.
const MAX_SIZE: u64 = 6 << 10;

/// Every so-many-th mutant is fixed and put in order too, which reads and checks it several times.
const FIXED: usize = 20;

fn texts() -> Vec<(Format, Vec<u8>)> {
    let mut files = Vec::new();
    collect(&support::fixtures(), &mut files);
    files.sort();
    let small = files.into_iter().filter(|file| fs::metadata(file).unwrap().len() <= MAX_SIZE);
    small.filter_map(|file| Some((Format::from_name(file.to_str()?)?, fs::read(file).unwrap()))).collect()
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { collect(&path, files) } else { files.push(path) }
    }
}

fn examine(format: Format, bytes: Vec<u8>, options: &Options, fixes: bool) {
    let printed = bytes.clone();
    let source = SourceFile::from_bytes("mutant", bytes, &SourceOptions::default()).unwrap();
    let description = format::read(source, format);
    assert_eq!(description.print(), printed);
    let findings = objdict::check_with(&description, options);
    for finding in &findings {
        for label in &finding.labels {
            let span = description.span_of(&label.at);
            assert!(description.source().text().get(span.start as usize..span.end as usize).is_some());
        }
    }
    if fixes {
        let _ = description.arranged();
        objdict::fix(description, Applicability::Unsafe, objdict::check);
    }
}

#[test]
fn no_damage_makes_it_panic() {
    let texts = texts();
    assert!(texts.len() > 100, "the fixtures are there");
    let mut options = Options::default();
    options.profiles = objdict::profile::standard().cloned().map(Arc::new).collect();
    options.tools = Tool::ALL.to_vec();
    let next = AtomicUsize::new(0);
    // a mutant is made of its number alone, so that one that fails can be made again
    let work = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= MUTANTS {
                break;
            }
            let mut mutator = Mutator::new(number as u64 + 1);
            let (format, text) = &texts[number % texts.len()];
            let other = &texts[mutator.below(texts.len())].1;
            let bytes = mutator.mutate(text, other);
            let result =
                std::panic::catch_unwind(|| examine(*format, bytes, &options, number.is_multiple_of(FIXED)));
            assert!(result.is_ok(), "mutant {number} panics");
        }
    };
    thread::scope(|scope| {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let threads: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        for thread in threads {
            thread.join().unwrap();
        }
    });
}
