//! Scanning, reading and checking, on a synthetic EDS of 1, 2, 4 and 8 MB, and rust-ini on the same text.
//!
//! `cargo bench read`: the ratio of two rows of one run is the figure; absolute ones depend on the machine.

use divan::Bencher;
use divan::counter::BytesCount;
use objdict::format::{self, Format};
use objdict::lint::Options;
use objdict::profile;
use objdict::source::SourceFile;
use objdict_eds::ini::{LineKind, Lines};

use crate::large;

const MEGABYTES: [usize; 4] = [1, 2, 4, 8];

fn eds(megabytes: usize) -> String {
    let padding = "x".repeat(12 * megabytes.saturating_sub(2));
    large::of_size(megabytes << 20, &padding)
}

#[divan::bench(args = MEGABYTES)]
fn line_break_scan(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = eds(megabytes);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| memchr::memchr2_iter(b'\n', b'\r', text.as_bytes()).count());
}

#[divan::bench(args = MEGABYTES)]
fn scan(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = eds(megabytes);
    bencher.counter(BytesCount::of_str(&text)).bench(|| {
        let is_entry = |kind| matches!(kind, LineKind::Entry { .. });
        Lines::new(&text).filter(|line| is_entry(line.kind)).count()
    });
}

#[divan::bench(args = MEGABYTES)]
fn read_model(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = eds(megabytes);
    bencher
        .counter(BytesCount::of_str(&text))
        .with_inputs(|| SourceFile::from_text("bench.eds", text.clone()))
        .bench_values(|source| format::read(source, Format::Eds));
}

#[divan::bench(args = MEGABYTES)]
fn read_and_check(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = eds(megabytes);
    bencher
        .counter(BytesCount::of_str(&text))
        .with_inputs(|| SourceFile::from_text("bench.eds", text.clone()))
        .bench_values(|source| objdict::check(&format::read(source, Format::Eds)).len());
}

/// All rules with all profiles, on what was read before: those about the text and those about the device.
#[divan::bench(args = MEGABYTES)]
fn check_with_all_profiles(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = eds(megabytes);
    let description = format::read(SourceFile::from_text("bench.eds", text.clone()), Format::Eds);
    let mut options = Options::default();
    options.profiles.extend(profile::standard().cloned().map(std::sync::Arc::new));
    bencher.counter(BytesCount::of_str(&text)).bench(|| objdict::check_with(&description, &options).len());
}

#[divan::bench(args = [1, 2])]
fn rust_ini(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = eds(megabytes);
    let options =
        || ini::ParseOption { enabled_quote: false, enabled_escape: false, ..ini::ParseOption::default() };
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| ini::Ini::load_from_str_opt(&text, options()).is_ok());
}
