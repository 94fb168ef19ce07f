//! What several tests need: the fixtures.

#![allow(dead_code, reason = "each test binary uses a part of it")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

pub(crate) mod devices;
mod patches;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// Where the pages of rules are, the only addresses outside of a page.
pub(crate) const RULE_PAGES: &str = "https://docs.rs/objdict/";

/// The folder with all fixtures as files, which each test program writes anew.
pub(crate) fn fixtures() -> PathBuf {
    static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(env!("CARGO_CRATE_NAME"));
        fs::remove_dir_all(&folder).ok();
        let folder = folder.join("fixtures");
        patches::expand(&Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures"), &folder);
        folder
    });
    FOLDER.clone()
}

/// All files below a folder of the fixtures with one of the endings, in order.
pub(crate) fn files(folder: &str, endings: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    collect(&fixtures().join(folder), endings, &mut found);
    found.sort();
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
