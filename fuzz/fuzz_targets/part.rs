//! Any bytes for the part of the library that the program is named after: `cargo +nightly fuzz run fix`.

#![no_main]

#[path = "../../xtask/src/fuzz/targets.rs"]
mod targets;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;

static PART: LazyLock<targets::Fuzzed> = LazyLock::new(|| {
    let name = env!("CARGO_BIN_NAME");
    let part = targets::FUZZED.into_iter().find(|fuzzed| fuzzed.name == name);
    part.unwrap_or_else(|| panic!("there is no part `{name}`"))
});

fuzz_target!(|bytes: &[u8]| PART.run_input(bytes));
