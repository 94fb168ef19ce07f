//! The devices for the build script and for the tests.

use std::path::Path;

use objdict::format;
use objdict::model::Device;
use objdict::source::SourceOptions;

#[path = "odd.rs"] // a symbolic link, because the build script also includes this module
pub(crate) mod odd;

/// Fixtures by file stem, which becomes a Rust identifier if `-` is replaced by `_`.
const FIXTURES: [&str; 11] = [
    "broken/hostile-unicode.eds",
    "dcf/io-401-node5.dcf",
    "dcf/manager-302-node1.dcf",
    "eds/all-types.eds",
    "eds/compact.eds",
    "eds/drive-402.eds",
    "eds/dspic-sensors.eds",
    "eds/encoder-406.eds",
    "eds/hostile.eds",
    "eds/io-401.eds",
    "eds/minimal.eds",
];

/// The folder of the fixtures.
pub(crate) fn fixtures() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures")
}

/// Names, which are valid identifiers, and devices.
pub(crate) fn devices() -> Vec<(String, Device)> {
    let read = |file: &str| {
        let path = fixtures().join(file);
        let opened = format::open(&path, &SourceOptions::default());
        let device = opened.unwrap_or_else(|error| panic!("{}: {error}", path.display())).into_device();
        let stem = file.rsplit('/').next().and_then(|name| name.split('.').next()).unwrap_or(file);
        (stem.replace('-', "_"), device)
    };
    let mut devices: Vec<_> = FIXTURES.into_iter().map(read).collect();
    devices.push(("odd".to_owned(), odd::device()));
    devices.push(("constant".to_owned(), odd::constant()));
    devices
}
