//! Corrupted copies of real files, the same in every run: what they break is broken for everyone.

mod corpus;
mod dictionary;
#[path = "../../../tests/support/patches.rs"]
#[allow(clippy::unwrap_used, reason = "the fixtures are there")]
mod patches;
mod seeds;
mod targets;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use std::{fs, thread};

pub(crate) use self::corpus::write as write_corpus;
use self::seeds::Seed;
use self::targets::{FUZZED, Fuzzed};
use crate::mutate::Mutator;

/// The size of the largest files that are fuzzed.
pub(crate) const SIZE: usize = 256 << 10;

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

/// Gives every part of the library what it once failed on, and corrupted copies of the files below `folder` that have at
/// most `size` bytes, by turns; fails when one of them panics or breaks a promise.
pub(crate) fn run(folder: &Path, size: usize, budget: Budget, only: Option<&str>) -> Result<(), String> {
    let seeds =
        seeds::seeds(folder, size).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    let words = dictionary::words(&seeds);
    let mut failures = Vec::new();
    for fuzzed in FUZZED.iter().filter(|fuzzed| only.is_none_or(|only| only == fuzzed.name)) {
        failures.extend(again(fuzzed).map_err(|error| format!("cannot read what failed before: {error}"))?);
        let seeds: Vec<&Seed> =
            seeds.iter().filter(|seed| fuzzed.endings.contains(&seed.ending.as_str())).collect();
        let sources = Sources { seeds, words: &words };
        if sources.seeds.is_empty() {
            println!("{}: no file to start from", fuzzed.name);
            continue;
        }
        let (count, broken) = broken(fuzzed, &sources, budget);
        println!(
            "{}: {count} mutants of {} files, {} failures",
            fuzzed.name,
            sources.seeds.len(),
            broken.len()
        );
        failures.extend(broken.iter().map(|number| format!("{} {number}", fuzzed.name)));
    }
    if failures.is_empty() { Ok(()) } else { Err(format!("inputs fail: {}", failures.join(", "))) }
}

/// The inputs in `fixtures/fuzz` that a part fails on.
fn again(fuzzed: &Fuzzed) -> std::io::Result<Vec<String>> {
    let mut failures = Vec::new();
    for file in corpus::kept(fuzzed)? {
        let input = fs::read(&file)?;
        if catch_unwind(AssertUnwindSafe(|| fuzzed.run_input(&input))).is_err() {
            failures.push(file.display().to_string());
        }
    }
    Ok(failures)
}

/// How many mutants a part of the library got, and those that it fails on.
fn broken(fuzzed: &Fuzzed, sources: &Sources<'_>, budget: Budget) -> (usize, Vec<usize>) {
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
                    let (ending, bytes) = sources.mutant(number);
                    if catch_unwind(AssertUnwindSafe(|| fuzzed.run(ending, &bytes))).is_err()
                        && let Ok(mut failures) = failures.lock()
                    {
                        failures.push(number);
                        keep(fuzzed, number, corpus::input(fuzzed, ending, &bytes));
                    }
                }
            });
        }
    });
    let mut failures = failures.into_inner().unwrap_or_default();
    failures.sort_unstable();
    (done.into_inner(), failures)
}

/// Writes what fails where the variable `OBJDICT_FUZZ_KEEP` says, as `fixtures/fuzz` has it.
fn keep(fuzzed: &Fuzzed, number: usize, input: Option<Vec<u8>>) {
    let (Some(folder), Some(input)) = (std::env::var_os("OBJDICT_FUZZ_KEEP"), input) else { return };
    let folder = Path::new(&folder).join(fuzzed.name);
    let written =
        fs::create_dir_all(&folder).and_then(|()| fs::write(folder.join(number.to_string()), input));
    if let Err(error) = written {
        eprintln!("cannot write to {}: {error}", folder.display());
    }
}

/// What mutants are made of.
struct Sources<'a> {
    seeds: Vec<&'a Seed>,
    words: &'a [String],
}

impl Sources<'_> {
    /// A mutant is made of its number alone, so that one that fails can be made again.
    fn mutant(&self, number: usize) -> (&str, Vec<u8>) {
        let mut mutator = Mutator::new(number as u64 + 1, self.words);
        let seed = self.seeds[mutator.below(self.seeds.len())];
        let other = mutator.below(self.seeds.len());
        (&seed.ending, mutator.mutate(&seed.bytes, &self.seeds[other].bytes))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

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
        assert_eq!(run(&corpus::fixtures(), 6 << 10, Budget::Count(50), None), Ok(()));
    }

    #[test]
    fn inputs_have_the_endings_of_their_seeds() {
        let seeds = seeds::seeds(&corpus::fixtures(), SIZE).unwrap();
        for fuzzed in &FUZZED {
            let mut endings: Vec<&str> = Vec::new();
            for seed in &seeds {
                let input = corpus::of_seed(fuzzed, seed);
                assert_eq!(input.is_some(), fuzzed.endings.contains(&&*seed.ending), "{}", seed.name);
                let Some(input) = input else { continue };
                assert_eq!(
                    (fuzzed.ending(input[0]), &input[1..]),
                    (&*seed.ending, &*seed.bytes),
                    "{}",
                    seed.name
                );
                endings.push(&seed.ending);
            }
            let unused = fuzzed.endings.iter().find(|ending| !endings.contains(ending));
            assert_eq!(unused, None, "{} has a seed for each ending", fuzzed.name);
        }
    }

    #[test]
    fn seeds_have_names_of_their_own() {
        let seeds = seeds::seeds(&corpus::fixtures(), SIZE).unwrap();
        let names: BTreeSet<&str> = seeds.iter().map(|seed| &*seed.name).collect();
        assert_eq!(names.len(), seeds.len());
    }

    #[test]
    fn the_dictionary_gives_libfuzzer_each_word_once() {
        let seeds = seeds::seeds(&corpus::fixtures(), SIZE).unwrap();
        let words = dictionary::words(&seeds);
        let lines: BTreeSet<String> = words.iter().map(|word| dictionary::line(word)).collect();
        assert_eq!(lines.len(), words.len());
        for word in &words {
            assert_eq!(read_line(&dictionary::line(word)).as_ref(), Some(word));
            assert!(word.len() <= 64, "libFuzzer leaves out longer words");
        }
        for word in [
            "\n[DeviceComissioning]\n",
            "\nPDOMapping=",
            "UNSIGNED8",
            "CANopenSubObject",
            "heartbeat_producer",
            "bit-rate",
            "access",
        ] {
            assert!(words.iter().any(|other| other == word), "{word}");
        }
    }

    /// A line as `ParseOneDictionaryEntry` of libFuzzer reads it.
    fn read_line(line: &str) -> Option<String> {
        let mut rest = line.trim().strip_prefix('"')?.strip_suffix('"')?;
        let mut word = Vec::new();
        while let Some(c) = rest.chars().next() {
            let length = match c {
                '\\' if rest[1..].starts_with(['\\', '"']) => {
                    word.push(rest.as_bytes()[1]);
                    2
                }
                '\\' => {
                    word.push(u8::from_str_radix(rest.strip_prefix("\\x")?.get(..2)?, 16).ok()?);
                    4
                }
                ' '..='~' => {
                    word.push(u8::try_from(c).ok()?);
                    1
                }
                _ => return None,
            };
            rest = &rest[length..];
        }
        String::from_utf8(word).ok().filter(|word| !word.is_empty())
    }
}
