//! Corrupted descriptions: with lines and bytes lost or added, reading, checking, fixing and arranging them does
//! not panic. The mutations are the same in every run.

#[path = "../../xtask/src/mutate.rs"]
mod mutate;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, thread};

use objdict::diagnostic::{Applicability, Fix, Tool};
use objdict::format::{self, Format};
use objdict::lint::Options;
use objdict::source::{SourceFile, SourceOptions};

use self::mutate::Mutator;
use crate::support;

/// Corrupted descriptions; `cargo xtask fuzz fixtures 10000` has the time for more.
const MUTANTS: usize = 1_000;

/// So many of them are fixed twice.
const MUTANTS_FIXED: usize = 500;

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
            assert!(
                description.source().text().get(span.start as usize..span.end as usize).is_some(),
                "{} at {span:?}: {}",
                finding.rule.id,
                finding.message
            );
        }
    }
    if fixes {
        let _ = description.arranged();
        objdict::fix(description, Applicability::Unsafe, objdict::check);
    }
}

/// Does `work` with mutants on all processors. A mutant is made of its number alone, so that one that fails can be made again.
fn each_mutant(count: usize, work: impl Fn(usize, Format, Vec<u8>) + Sync) {
    let texts = texts();
    assert!(texts.len() > 100, "the fixtures are there");
    let next = AtomicUsize::new(0);
    let (work, texts) = (&work, &texts);
    let turn = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= count {
                break;
            }
            let mut mutator = Mutator::new(number as u64 + 1);
            let (format, text) = &texts[number % texts.len()];
            let other = &texts[mutator.below(texts.len())].1;
            let bytes = mutator.mutate(text, other);
            let result = catch_unwind(AssertUnwindSafe(|| work(number, *format, bytes)));
            assert!(result.is_ok(), "mutant {number} panics");
        }
    };
    thread::scope(|scope| {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let threads: Vec<_> = (0..threads).map(|_| scope.spawn(turn)).collect();
        for thread in threads {
            thread.join().unwrap();
        }
    });
}

#[test]
fn no_damage_makes_it_panic() {
    let mut options = Options::default();
    options.profiles = objdict::profile::standard().cloned().map(Arc::new).collect();
    options.tools = Tool::ALL.to_vec();
    each_mutant(MUTANTS, |number, format, bytes| {
        examine(format, bytes, &options, number.is_multiple_of(FIXED));
    });
}

/// What is fixed has nothing more to fix, and reports offer nothing in it, also when its bytes are read anew.
#[test]
fn one_run_fixes_all_that_can_be_fixed() {
    each_mutant(MUTANTS_FIXED, |_, format, bytes| {
        let read = |bytes| {
            format::read(SourceFile::from_bytes("mutant", bytes, &SourceOptions::default()).unwrap(), format)
        };
        for safety in [Applicability::Safe, Applicability::Unsafe] {
            let fixed = objdict::fix(read(bytes.clone()), safety, objdict::check);
            assert!(!fixed.is_unfinished);
            let again = objdict::fix(read(fixed.bytes()), safety, objdict::check);
            assert_eq!(again.applied, [], "{safety}");
            assert_eq!(again.bytes(), fixed.bytes(), "{safety}");
            let findings = objdict::check(&again.description);
            let offers = objdict::with_sound_fixes(&again.description, findings, objdict::check);
            let is_offer = |fix: &Fix| fix.is_offered && fix.safety <= safety;
            assert!(!offers.iter().filter_map(|finding| finding.fix.as_ref()).any(is_offer), "{safety}");
        }
    });
}
