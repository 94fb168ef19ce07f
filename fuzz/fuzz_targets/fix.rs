//! Any bytes are fixed and put in order: `cargo +nightly fuzz run fix`.

#![no_main]

use libfuzzer_sys::fuzz_target;
use objdict::diagnostic::Applicability;
use objdict::format::{self, Format};
use objdict::source::{SourceFile, SourceOptions};

fuzz_target!(|bytes: &[u8]| {
    for format in [Format::Eds, Format::Dcf, Format::Xdd] {
        let Ok(source) = SourceFile::from_bytes("fuzz", bytes.to_vec(), &SourceOptions::default()) else { return };
        let description = format::read(source, format);
        let _ = description.arranged();
        objdict::fix(description, Applicability::Unsafe, objdict::check);
    }
});
