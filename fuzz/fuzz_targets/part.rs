//! Any bytes for the part of the library that the program is named after: `cargo +nightly fuzz run fix`.

#![no_main]

#[path = "../../xtask/src/fuzz/targets.rs"]
mod targets;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use objdict::format::Format;

static PART: LazyLock<targets::Fuzzed> = LazyLock::new(|| {
    let name = env!("CARGO_BIN_NAME");
    let part = targets::FUZZED.into_iter().find(|fuzzed| fuzzed.name == name);
    part.unwrap_or_else(|| panic!("there is no part `{name}`"))
});

// the first byte is the format, as the name of a file would be
fuzz_target!(|bytes: &[u8]| {
    let Some((first, bytes)) = bytes.split_first() else { return };
    let ending = PART.endings[usize::from(*first) % PART.endings.len()];
    (PART.run)(Format::from_name(ending).unwrap_or(Format::Eds), bytes);
});
