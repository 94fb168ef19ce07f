//! The devices that everything is tried on.

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::format;
use objdict::generate::{Options, Target, generate};
use objdict::model::Device;
use objdict::source::SourceOptions;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

use crate::{odd, support};

/// The device of a file.
pub(crate) fn device(path: &Path) -> Device {
    format::open(path, &SourceOptions::default()).unwrap().into_device()
}

/// Every healthy fixture, the hostile ones, and a device with everything that no fixture has.
pub(crate) fn devices() -> Vec<(String, Device)> {
    let mut paths = support::good_devices();
    paths.push(support::fixtures().join("broken/hostile-unicode.eds"));
    paths.push(support::fixtures().join("xdd/valve.xdd"));
    let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
    let mut devices: Vec<(String, Device)> = paths.iter().map(|path| (name(path), device(path))).collect();
    devices.push(("odd".to_owned(), odd::device()));
    devices.push(("constant".to_owned(), odd::constant()));
    devices
}

/// Calls `check` for each item on as many threads as there are cores; fails with all messages.
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

/// Arbitrary devices from which something can be generated; always the same ones.
pub(crate) fn arbitrary_devices(count: usize) -> Vec<(String, Device)> {
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
