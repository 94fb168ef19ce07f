//! Skipped and sampled tests, listed when their program ends: cargo hides what a passing test prints.
//!
//! `OBJDICT_SKIPS` names a file to which each line is also appended, so that the gate lists those of all programs.

#![allow(dead_code, reason = "each test binary uses a part of it")]

use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fmt::Display;
use std::fs::OpenOptions;
use std::io::{Write, stderr};
use std::panic::Location;
use std::process::Command;
use std::sync::{Mutex, Once};
use std::thread;

/// One of so many items is used by default.
const STEP: usize = 4;

/// The tests by verdict and reason.
static RECORDS: Mutex<BTreeMap<String, BTreeSet<String>>> = Mutex::new(BTreeMap::new());

/// Says something of a long test at once: what is written to the stream itself is not kept until its end.
pub(crate) fn say(text: impl Display) {
    let name = thread::current().name().unwrap_or_default().to_owned();
    stderr().write_all(format!("{name}: {text}\n").as_bytes()).unwrap();
}

/// Skips the current test, or a part of it, for lack of something that no registry offers, such as a checkout that a
/// variable names. The caller returns.
#[track_caller]
pub(crate) fn skip(reason: impl Display) {
    record("skipped", &reason.to_string());
}

/// Skips the current test, or a part of it, for lack of something that can be installed; with `CI=true`, fails.
/// Returns false: the thing is not there.
#[track_caller]
pub(crate) fn skip_unless_ci(reason: impl Display) -> bool {
    assert!(env::var("CI").as_deref() != Ok("true"), "{reason}");
    skip(reason);
    false
}

/// Whether `PROGRAM --version` succeeds; if not, the current test is skipped, or fails with `CI=true`.
#[track_caller]
pub(crate) fn has(program: &str, package: &str) -> bool {
    let output = Command::new(program).arg("--version").output();
    output.is_ok_and(|output| output.status.success())
        || skip_unless_ci(format_args!("no `{program}`: install the package `{package}`"))
}

/// One item of each four, or all with `OBJDICT_SAMPLE=all`. A number in the variable selects which one of the four, so
/// any four successive numbers use every item.
#[track_caller]
pub(crate) fn sample<T>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    let items: Vec<T> = items.into_iter().collect();
    if samples_all() {
        return items;
    }
    let seed = env::var("OBJDICT_SAMPLE")
        .map_or(0, |text| text.parse().expect("OBJDICT_SAMPLE is `all` or a number"));
    let all = items.len();
    let numbered = items.into_iter().enumerate();
    let used: Vec<T> =
        numbered.filter(|(number, _)| is_used(*number, all, seed)).map(|(_, item)| item).collect();
    if used.len() < all {
        record("sampled", &format!("{} of {all}, all with `OBJDICT_SAMPLE=all`", used.len()));
    }
    used
}

/// Whether a seed selects the item with a number; the last group may have fewer than four.
pub(crate) fn is_used(number: usize, all: usize, seed: usize) -> bool {
    let group = number / STEP;
    number % STEP == (group + seed) % STEP.min(all - group * STEP)
}

/// Whether nothing is sampled.
pub(crate) fn samples_all() -> bool {
    env::var("OBJDICT_SAMPLE").as_deref() == Ok("all")
}

#[track_caller]
fn record(verdict: &str, text: &str) {
    static AT_EXIT: Once = Once::new();
    AT_EXIT.call_once(|| {
        shutdown_hooks::add_shutdown_hook(list);
    });
    let thread = thread::current();
    // the test's name, unless it runs on the main thread or is in one of its own
    let test = thread.name().filter(|name| *name != "main").unwrap_or(Location::caller().file());
    let reason = format!("{verdict}: {text}");
    let is_new = RECORDS.lock().unwrap().entry(reason.clone()).or_default().insert(test.to_owned());
    if let Some(path) = env::var_os("OBJDICT_SKIPS").filter(|_| is_new) {
        let mut file = OpenOptions::new().create(true).append(true).open(path).unwrap();
        // in one call, because other programs append to the file too
        file.write_all(format!("{reason} ({}: {test})\n", env!("CARGO_CRATE_NAME")).as_bytes()).unwrap();
    }
}

extern "C" fn list() {
    // a panic must not reach the caller, which is C
    let Ok(records) = RECORDS.lock() else { return };
    for (reason, tests) in &*records {
        let tests: Vec<&str> = tests.iter().map(String::as_str).collect();
        writeln!(stderr(), "{reason} ({}: {})", env!("CARGO_CRATE_NAME"), tests.join(", ")).ok();
    }
}
