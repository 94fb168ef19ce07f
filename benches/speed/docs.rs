//! From the text of an EDS to its page: reading, checking with all rules, writing HTML.
//!
//! `cargo bench docs`: the page of 1 MB must take at most 50 ms, and its time beside reading and checking is the
//! ratio of two rows of one run.

use divan::Bencher;
use divan::counter::BytesCount;
use objdict::document::{self, Finding, Form, Options, Subject};
use objdict::format::{self, Description, Format};
use objdict::report::Location;
use objdict::source::SourceFile;

use crate::large;

const MEGABYTES: [usize; 3] = [1, 2, 4];

fn read(text: &str) -> (Description, Vec<Finding>) {
    let description = format::read(SourceFile::from_text("bench.eds", text), Format::Eds);
    let findings = objdict::check(&description);
    let line = |finding| Location::line_of((&description).into(), finding);
    let findings = findings.iter().map(|finding| Finding::new(finding, line(finding))).collect();
    (description, findings)
}

fn page_of((description, findings): &(Description, Vec<Finding>), form: Form) -> String {
    let (device, findings) = (description.device(), Some(findings.as_slice()));
    let subject =
        Subject { device, file: "bench.eds", format: "EDS", findings, identifiers: &Default::default() };
    document::write(&subject, form, &Options::default())
}

#[divan::bench(args = MEGABYTES)]
fn read_and_check(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = large::of_size(megabytes << 20, "");
    bencher.counter(BytesCount::of_str(&text)).bench(|| read(&text));
}

#[divan::bench(args = MEGABYTES)]
fn read_check_and_write_html(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = large::of_size(megabytes << 20, "");
    bencher.counter(BytesCount::of_str(&text)).bench(|| page_of(&read(&text), Form::Html));
}

#[divan::bench(args = MEGABYTES)]
fn write_html(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = large::of_size(megabytes << 20, "");
    let read = read(&text);
    bencher.counter(BytesCount::of_str(&text)).bench(|| page_of(&read, Form::Html));
}
