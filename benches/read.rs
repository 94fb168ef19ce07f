//! Scanning, reading and checking, on a synthetic EDS of 1, 2, 4 and 8 MB, and rust-ini on the same text.
//!
//! `cargo bench --bench read`: the ratio of two rows of one run is the figure; absolute ones depend on the machine.

use std::fmt::Write;

use divan::Bencher;
use divan::counter::BytesCount;
use objdict::format::ini::{LineKind, Lines};
use objdict::format::{self, Format};
use objdict::source::SourceFile;

fn main() {
    divan::main();
}

const MEGABYTES: [usize; 4] = [1, 2, 4, 8];

/// A healthy EDS of about `megabytes`: records of a drive with limits and defaults, as a vendor's tool writes them. The
/// indexes of the profile area run out at 4 MB, so larger ones take longer names.
fn eds(megabytes: usize) -> String {
    let size = megabytes << 20;
    let mut text = String::from(include_str!("../fixtures/eds/minimal.eds")).replace("\r\n", "\n");
    let padding = "x".repeat(12 * megabytes.saturating_sub(2));
    let mut list = String::new();
    let mut count = 0;
    'all: for index in 0x2000..0x6000 {
        count += 1;
        let _ = writeln!(list, "{count}=0x{index:04X}");
        let _ = write!(
            text,
            "\n[{index:X}]\nParameterName=Axis parameters {index:04X} {padding}\nObjectType=0x9\nSubNumber=9\n"
        );
        for sub in 0..9 {
            let (data_type, access, high, value) =
                if sub == 0 { ("0x0005", "const", "0x7F", 8) } else { ("0x0007", "rw", "0x7FFFFFFF", sub) };
            let _ = write!(
                text,
                "\n[{index:X}sub{sub:X}]\nParameterName=Position control gain {sub} {padding}\nObjectType=0x7\nDataType={data_type}\n\
                 LowLimit=0x00000000\nHighLimit={high}\nAccessType={access}\nDefaultValue={value}\nPDOMapping=0\n"
            );
        }
        if text.len() + list.len() >= size {
            break 'all;
        }
    }
    text.replace(
        "[ManufacturerObjects]\nSupportedObjects=0\n",
        &format!("[ManufacturerObjects]\nSupportedObjects={count}\n{list}"),
    )
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

#[divan::bench(args = [1, 2])]
fn rust_ini(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = eds(megabytes);
    let options =
        || ini::ParseOption { enabled_quote: false, enabled_escape: false, ..ini::ParseOption::default() };
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| ini::Ini::load_from_str_opt(&text, options()).is_ok());
}
