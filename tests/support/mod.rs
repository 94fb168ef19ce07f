//! What several tests need: the fixtures.

#![allow(dead_code, reason = "each test binary uses a part of it")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

pub(crate) mod devices;
mod patches;
pub(crate) mod skips;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// Where the pages of rules are, the only addresses outside of a page; no address begins so until there are pages.
pub(crate) const RULE_PAGES: &str = match objdict_model::diagnostic::HOME {
    Some(home) => home,
    None => "nowhere",
};

/// The folder with all fixtures as files, which each test program writes anew.
pub(crate) fn fixtures() -> PathBuf {
    static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
        let project = Path::new(env!("CARGO_TARGET_TMPDIR"));
        // files below may name each other
        fs::create_dir_all(project.join(".git")).unwrap();
        let folder = project.join(env!("CARGO_CRATE_NAME"));
        fs::remove_dir_all(&folder).ok();
        let folder = folder.join("fixtures");
        patches::expand(&Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures"), &folder);
        folder
    });
    FOLDER.clone()
}

/// All files below a folder of the fixtures with one of the endings, in order.
pub(crate) fn files(folder: &str, endings: &[&str]) -> Vec<PathBuf> {
    let found = files_below(&fixtures().join(folder), endings);
    assert!(!found.is_empty(), "no files with the endings {endings:?} in fixtures/{folder}");
    found
}

/// Every EDS and DCF of CANopen, healthy or not.
pub(crate) fn devices_of_all_folders() -> Vec<PathBuf> {
    let foreign = fixtures().join("foreign");
    files("", &["eds", "dcf"]).into_iter().filter(|path| !path.starts_with(&foreign)).collect()
}

/// The healthy devices: every rule is silent on them.
pub(crate) fn good_devices() -> Vec<PathBuf> {
    [files("eds", &["eds"]), files("dcf", &["dcf"])].concat()
}

/// A Python environment below `target` with these packages: the folder of its programs, or why it cannot be made.
pub(crate) fn python(name: &str, packages: &[&str]) -> Result<PathBuf, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let programs = folder.join(if cfg!(windows) { "Scripts" } else { "bin" });
    let (made, packages_text) = (folder.join("packages"), packages.join("\n"));
    if fs::read_to_string(&made).is_ok_and(|before| before == packages_text) {
        return Ok(programs);
    }
    run(Command::new("python3").args(["-m", "venv"]).arg(&folder))?;
    run(Command::new(programs.join("pip")).args(["install", "--quiet"]).args(packages))?;
    fs::write(&made, packages_text).map_err(|error| error.to_string())?;
    Ok(programs)
}

/// Runs a command, or returns what it wrote when it failed.
pub(crate) fn run(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|error| error.to_string())?;
    let text = [&*output.stdout, &*output.stderr].concat();
    if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&text).into_owned()) }
}

/// What a test needs from the network. Without it the test is skipped, or fails with `CI=true`.
#[track_caller]
pub(crate) fn unless_offline<T>(needed: Result<T, String>) -> Option<T> {
    match needed {
        Ok(needed) => Some(needed),
        Err(reason) => {
            skips::skip_unless_ci(reason);
            None
        }
    }
}

/// All files below a folder with one of the endings, in order.
pub(crate) fn files_below(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    collect(folder, endings, &mut found);
    found.sort();
    found
}

fn collect(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, endings, found);
        } else if path.extension().is_some_and(|ending| endings.iter().any(|wanted| ending == *wanted)) {
            found.push(path);
        }
    }
}
