//! Any bytes are read as each format and checked with all profiles and tools: `cargo +nightly fuzz run check`.

#![no_main]

use std::sync::{Arc, LazyLock};

use libfuzzer_sys::fuzz_target;
use objdict::diagnostic::Tool;
use objdict::format::{self, Format};
use objdict::lint::Options;
use objdict::source::{SourceFile, SourceOptions};

static OPTIONS: LazyLock<Options> = LazyLock::new(|| {
    let mut options = Options::default();
    options.profiles = objdict::profile::standard().cloned().map(Arc::new).collect();
    options.tools = Tool::ALL.to_vec();
    options
});

fuzz_target!(|bytes: &[u8]| {
    for format in [Format::Eds, Format::Dcf, Format::Xdd, Format::Xdc] {
        let Ok(source) = SourceFile::from_bytes("fuzz", bytes.to_vec(), &SourceOptions::default()) else { return };
        let description = format::read(source, format);
        assert_eq!(description.print(), bytes);
        for finding in &objdict::check_with(&description, &OPTIONS) {
            for label in &finding.labels {
                description.span_of(&label.at);
            }
        }
    }
});
