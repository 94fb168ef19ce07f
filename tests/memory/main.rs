//! The promise of docs/reference/limits.md: reading, `check` and `convert` take at most 20 times the file and 50 MB, in time in proportion to the
//! file. The files here are made to break it. Each runs in a process of its own, whose allocator counts.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "what a process says is shown when it fails")]

mod bombs;
#[cfg(feature = "full")]
mod editing;
#[cfg(feature = "full")]
mod logs;
#[path = "../support/skips.rs"]
mod skips;

use std::alloc::System;
use std::env;
use std::fs;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use cap::Cap;
use objdict::check;
use objdict::format::input::{Input, Reading};
use objdict::format::network::{NetworkFile, PathOptions};
use objdict::format::{self, Description, Format, WriteOptions, json};
use objdict::model::Device;

use self::bombs::Kind;
use self::skips::{sample, samples_all};

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// What is repeated in a file, in bytes. Of four times as much, quadratic growth makes 16 times the allocations, where 6 times are
/// allowed, so small files show it; `OBJDICT_SAMPLE=all` doubles them.
fn sizes() -> [usize; 2] {
    if samples_all() { [100_000, 400_000] } else { [50_000, 200_000] }
}

/// What a process takes beside its allocations: the program, its stack, and the gaps between allocations.
const PROCESS: usize = 14_000_000;

/// What a process is asked to do, as `NAME SIZE`.
const TASK: &str = "OBJDICT_MEMORY_TASK";

/// What a bomb takes.
#[derive(Clone, Copy, Debug)]
struct Usage {
    /// The bytes of its text.
    text: usize,
    /// The most bytes that were allocated at once.
    peak: usize,
    /// The bytes that were allocated in all, which grow as the time does.
    total: usize,
}

/// In a sample of the files; `benches/instructions` holds time and memory of each command, on healthy files, against a table.
#[test]
fn memory_and_time_are_in_proportion_to_the_file() {
    let names: Vec<&str> = sample(bombs::all().iter().map(|bomb| bomb.name));
    let next = AtomicUsize::new(0);
    let failures = Mutex::new(Vec::new());
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(name) = names.get(next.fetch_add(1, Ordering::Relaxed)) {
                    failures.lock().unwrap().extend(failure(name));
                }
            });
        }
    });
    let failures = failures.into_inner().unwrap();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// How a bomb breaks the promise.
fn failure(name: &str) -> Option<String> {
    let sizes = sizes();
    let [one, two] = sizes.map(|size| usage(name, size));
    println!("{name:24} {one:?} {two:?}");
    let is_small = |usage: Usage| usage.peak + PROCESS <= 20 * usage.text + 50_000_000;
    let growth = sizes[1] as f64 / sizes[0] as f64;
    // a vector that grows is copied, so steps are uneven
    let is_linear = two.total as f64 <= 1.5 * growth * one.total as f64 + 20e6;
    (!(is_small(one) && is_small(two) && is_linear)).then(|| format!("{name}: {one:?}, {two:?}"))
}

/// Runs a bomb in a process of its own.
fn usage(name: &str, size: usize) -> Usage {
    let mut command = Command::new(env::current_exe().unwrap());
    command.args(["--exact", "task", "--nocapture", "--test-threads=1"]).env(TASK, format!("{name} {size}"));
    let output = command.output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{name}: {text}{}", String::from_utf8_lossy(&output.stderr));
    let numbers = text.lines().find_map(|line| line.split_once("usage: ")).unwrap().1;
    let mut numbers = numbers.split(' ').map(|number| number.parse().unwrap());
    let mut next = || numbers.next().unwrap();
    Usage { text: next(), peak: next(), total: next() }
}

/// What the processes do; without a task nothing.
#[test]
fn task() {
    let Ok(task) = env::var(TASK) else { return };
    let (name, size) = task.split_once(' ').unwrap();
    #[cfg(feature = "full")]
    if name == logs::TASK {
        return logs::run(size.parse().unwrap());
    }
    let bombs = bombs::all();
    let bomb = bombs.iter().find(|bomb| bomb.name == name).unwrap();
    let text = (bomb.text)(size.parse().unwrap());
    let length = text.len();
    let before = (ALLOCATOR.allocated(), ALLOCATOR.total_allocated());
    match bomb.kind {
        Kind::File => of_file(bomb.name, &text),
        Kind::Network => of_network(bomb.name, &text),
    }
    // the text is the command's too
    let peak = ALLOCATOR.max_allocated().saturating_sub(before.0) + length;
    println!("usage: {length} {peak} {}", ALLOCATOR.total_allocated() - before.1);
}

/// What `check` and `convert` do with a file.
fn of_file(name: &str, text: &str) {
    let reading = Reading::default();
    if let Ok((kind, source)) = reading.recognised(name, text.as_bytes().to_vec())
        && let Some(format) = kind.format()
    {
        let description = format::read(source, format);
        let findings = check(&description);
        println!("{name}: {} findings", findings.len());
    }
    match reading.read(name, text.as_bytes().to_vec()) {
        Ok((_, Input::Description(description))) => {
            let max_losses = WriteOptions::max_losses_of(text.len(), reading.max_entries);
            of_device(name, description.device(), max_losses);
            edited(&description);
        }
        Ok((_, Input::Device(device))) => {
            of_device(name, &device, WriteOptions::max_losses_of(0, reading.max_entries));
        }
        Ok((kind, Input::Concise(configuration))) => {
            println!("{name}: a {}, {} downloads", kind.name(), configuration.0.len());
            println!("{}", configuration.differences(&configuration).is_empty());
        }
        Ok((_, Input::NodeList(list))) => println!("{name}: {} networks", list.networks.len()),
        Err(error) => println!("{name}: {}", error.to_string().chars().take(200).collect::<String>()),
    }
}

fn of_device(name: &str, device: &Device, max_losses: usize) {
    println!("{name}: {} bytes of JSON", json::write_device(device).len());
    // a DCF and an XDC are written by the same code
    for format in [Format::Eds, Format::Xdd] {
        let mut options = WriteOptions::default();
        (options.embed, options.max_losses) = (true, max_losses);
        match format::write(device, format, &options) {
            Ok(written) => println!("{name}: {} bytes, {} losses", written.bytes.len(), written.losses.len()),
            Err(error) => println!("{name}: {error}"),
        }
    }
}

/// A conversion that stays in its syntax.
fn edited(description: &Description) {
    let to_type = description.to_type("a");
    println!("{:?}", to_type.map(|bytes| bytes.len()).map_err(|error| error.to_string()));
}

/// What `network check` does, with descriptions beside the file.
fn of_network(name: &str, text: &str) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    fs::copy(bombs::fixtures().join("eds/minimal.eds"), folder.path().join("m.eds")).unwrap();
    let options = PathOptions::default();
    let file = match NetworkFile::is_network(&path).unwrap() {
        true => NetworkFile::open(&path, &options).ok(),
        false => NetworkFile::of_descriptions(&[path], &options).ok(),
    };
    if let Some(file) = file {
        println!("{name}: {} findings", file.check().len());
        println!("{name}: {}", file.compiled().is_some());
    }
}
