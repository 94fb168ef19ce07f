//! The test devices.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{LazyLock, Mutex};

use objdict::format::{self, Format};
use objdict::generate::{Options, Target, generate};
use objdict::model::Device;
use objdict::source::SourceOptions;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

use crate::{odd, support, words};

/// The device of a file.
pub(crate) fn device(path: &Path) -> Device {
    format::open(path, &SourceOptions::default()).unwrap().into_device()
}

/// Every valid fixture, the hostile ones, and a device with everything that no fixture has. If
/// `OBJDICT_CORPUS_DIR` names a folder, also every description below it that has no error which stops the generation.
pub(crate) fn devices() -> Vec<(String, Device)> {
    static READ: LazyLock<Vec<(String, Device)>> = LazyLock::new(read);
    READ.clone()
}

fn read() -> Vec<(String, Device)> {
    let mut paths = support::good_devices();
    paths.push(support::fixtures().join("broken/hostile-unicode.eds"));
    paths.push(support::fixtures().join("xdd/valve.xdd"));
    let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
    let mut devices: Vec<(String, Device)> = paths.iter().map(|path| (name(path), device(path))).collect();
    devices.push(("odd".to_owned(), odd::device()));
    devices.push(("constant".to_owned(), odd::constant()));
    devices.push(("words".to_owned(), words::device()));
    if let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") {
        further(Path::new(&folder), &mut devices);
    }
    devices
}

/// Adds every description below a folder whose tables are not wrong.
fn further(folder: &Path, devices: &mut Vec<(String, Device)>) {
    let mut paths: Vec<PathBuf> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            further(&path, devices);
            continue;
        }
        let is_known =
            path.file_name().is_some_and(|name| Format::from_name(&name.to_string_lossy()).is_some());
        let Some(Ok(description)) = is_known.then(|| format::open(&path, &SourceOptions::default())) else {
            continue;
        };
        let is_empty = description.device().objects.values().all(|object| object.entries().next().is_none());
        if !is_empty && !objdict::check(&description).iter().any(|finding| finding.stops("c")) {
            devices.push((path.display().to_string(), description.into_device()));
        }
    }
}

/// Calls `check` for each item on one thread per core; fails with all messages.
pub(crate) fn for_all<T: Sync>(items: &[T], check: impl Fn(&T) -> Result<(), String> + Sync) {
    let next = AtomicUsize::new(0);
    let failures = Mutex::new(Vec::new());
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(8);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(item) = items.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if let Err(failure) = check(item) {
                        failures.lock().unwrap().push(failure);
                    }
                }
            });
        }
    });
    let failures = failures.into_inner().unwrap();
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}

/// Arbitrary but reproducible devices that can be generated.
pub(crate) fn arbitrary_devices(count: usize) -> Vec<(String, Device)> {
    static DEVICES: LazyLock<Vec<(String, Device)>> = LazyLock::new(|| arbitrary(60));
    DEVICES[..count].to_vec()
}

fn arbitrary(count: usize) -> Vec<(String, Device)> {
    let mut runner = TestRunner::deterministic();
    let strategy = support::devices::device(support::devices::Texts::Any);
    let rust = Target::named("rust").unwrap();
    let mut devices = Vec::new();
    for number in 0..1000 {
        let device = strategy.new_tree(&mut runner).unwrap().current();
        match generate(&device, rust, &Options::default()) {
            Ok(_) => devices.push((format!("arbitrary {number}"), device)),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
        if devices.len() == count {
            return devices;
        }
    }
    panic!("only {} of 1000 devices could be generated", devices.len());
}
