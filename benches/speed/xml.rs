//! Building the tree, reading and checking, on a synthetic XDD of about 1 and 4 MB: what an EDS becomes when it is converted.
//! Beside it the bare events of quick-xml, and roxmltree, on the same text.
//!
//! `cargo bench xml`: the ratio of two rows of one run is the figure; absolute ones depend on the machine.

use divan::Bencher;
use divan::counter::BytesCount;
use objdict::diagnostic::Findings;
use objdict::format::{self, Format, WriteOptions};
use objdict::source::SourceFile;
use objdict_xdd::xml::Tree;
use quick_xml::Reader;
use quick_xml::events::Event;

use crate::large;

const MEGABYTES: [usize; 2] = [1, 4];

/// An XDD of about `megabytes`.
fn xdd(megabytes: usize) -> String {
    // an XDD takes three times the text of its EDS
    let text = large::of_size(megabytes * (1 << 20) / 3, "");
    let eds = format::read(SourceFile::from_text("bench.eds", text), Format::Eds);
    let written = format::write(eds.device(), Format::Xdd, &WriteOptions::default()).expect("a valid XDD");
    String::from_utf8(written.bytes).expect("an XDD is UTF-8")
}

fn source(text: &str) -> SourceFile {
    SourceFile::from_text("bench.xdd", text)
}

#[divan::bench(args = MEGABYTES)]
fn quick_xml_events(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = xdd(megabytes);
    bencher.counter(BytesCount::of_str(&text)).bench(|| {
        let mut reader = Reader::from_str(&text);
        let mut starts = 0;
        loop {
            match reader.read_event() {
                Ok(Event::Eof) | Err(_) => break starts,
                Ok(Event::Start(_) | Event::Empty(_)) => starts += 1,
                Ok(_) => {}
            }
        }
    });
}

#[divan::bench(args = MEGABYTES)]
fn roxmltree(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = xdd(megabytes);
    let options =
        || ::roxmltree::ParsingOptions { nodes_limit: u32::MAX, ..::roxmltree::ParsingOptions::default() };
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| ::roxmltree::Document::parse_with_options(&text, options()).is_ok());
}

#[divan::bench(args = MEGABYTES)]
fn tree(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = xdd(megabytes);
    bencher
        .counter(BytesCount::of_str(&text))
        .with_inputs(|| source(&text))
        .bench_values(|source| Tree::new(source, &mut Findings::new()));
}

#[divan::bench(args = MEGABYTES)]
fn read_model(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = xdd(megabytes);
    bencher
        .counter(BytesCount::of_str(&text))
        .with_inputs(|| source(&text))
        .bench_values(|source| format::read(source, Format::Xdd));
}

#[divan::bench(args = MEGABYTES)]
fn read_and_check(bencher: Bencher<'_, '_>, megabytes: usize) {
    let text = xdd(megabytes);
    bencher
        .counter(BytesCount::of_str(&text))
        .with_inputs(|| source(&text))
        .bench_values(|source| objdict::check(&format::read(source, Format::Xdd)).len());
}
