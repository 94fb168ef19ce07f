//! Any bytes for the part of the library that the variable `OBJDICT_FUZZ` names: `OBJDICT_FUZZ=fix cargo +nightly fuzz run any`.

#![no_main]

#[path = "../../xtask/src/fuzz/targets.rs"]
mod targets;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use objdict::format::Format;

static RUN: LazyLock<fn(Format, &[u8])> = LazyLock::new(|| {
    let name = std::env::var("OBJDICT_FUZZ").unwrap_or_else(|_| "check".to_owned());
    let fuzzed = targets::FUZZED.into_iter().find(|fuzzed| fuzzed.name == name);
    fuzzed.unwrap_or_else(|| panic!("there is no part `{name}`")).run
});

fuzz_target!(|bytes: &[u8]| {
    let Some((first, bytes)) = bytes.split_first() else { return };
    let formats = [Format::Eds, Format::Dcf, Format::Xdd, Format::Xdc];
    RUN(formats[usize::from(first % 4)], bytes);
});
