//! `print(parse(bytes)) == bytes` for every byte string, and reading never panics on any bytes.

use std::fs;

use objdict::format::{self, Format};
use objdict::source::{Encoding, SourceFile, SourceOptions};
use proptest::prelude::*;
use proptest::sample::Index;

use crate::support;

/// Reads and checks `bytes` as both formats and gives what the document prints.
fn print(bytes: &[u8]) -> Vec<u8> {
    let options = SourceOptions::default();
    let source = |bytes: &[u8]| SourceFile::from_bytes("test.eds", bytes.to_vec(), &options).unwrap();
    objdict::check(&format::read(source(bytes), Format::Dcf));
    let description = format::read(source(bytes), Format::Eds);
    for finding in &objdict::check(&description) {
        for label in &finding.labels {
            let span = description.span_of(&label.at);
            assert!(
                span.start <= span.end && span.end as usize <= description.source().text().len(),
                "{finding:?}"
            );
        }
    }
    description.print()
}

#[test]
fn every_fixture_prints_back() {
    for file in support::files("", &["eds", "dcf"]) {
        let bytes = fs::read(&file).unwrap();
        assert!(print(&bytes) == bytes, "{}", file.display());
    }
}

#[test]
fn every_encoding_prints_back() {
    let bytes: Vec<u8> = (0..=255).cycle().take(1024).collect();
    for name in Encoding::NAMES {
        let mut options = SourceOptions::default();
        options.encoding = Some(name.parse().unwrap());
        let source = SourceFile::from_bytes("test.eds", bytes.clone(), &options).unwrap();
        assert!(format::read(source, Format::Eds).print() == bytes, "{name}");
    }
}

/// A change of one fixture's bytes.
#[derive(Clone, Debug)]
enum Mutation {
    Replace(Index, u8),
    Remove(Index, u8),
    Insert(Index, Vec<u8>),
    Repeat(Index, u8, Index),
    Truncate(Index),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let words = prop::sample::select(vec![
        "[", "]", "=", ";", "#", "\r", "\n", "\0", "\u{1A}", "$NODEID", "0x", "-", "sub", "Name", "65536",
        "\u{FEFF}",
    ]);
    let bytes = prop_oneof![
        words.prop_map(|word| word.as_bytes().to_vec()),
        prop::collection::vec(any::<u8>(), 1..8)
    ];
    prop_oneof![
        (any::<Index>(), any::<u8>()).prop_map(|(at, byte)| Mutation::Replace(at, byte)),
        (any::<Index>(), 1u8..200).prop_map(|(at, count)| Mutation::Remove(at, count)),
        (any::<Index>(), bytes).prop_map(|(at, bytes)| Mutation::Insert(at, bytes)),
        (any::<Index>(), 1u8..200, any::<Index>())
            .prop_map(|(from, count, to)| Mutation::Repeat(from, count, to)),
        any::<Index>().prop_map(Mutation::Truncate),
    ]
}

fn mutate(bytes: &mut Vec<u8>, mutation: &Mutation) {
    if bytes.is_empty() {
        return;
    }
    let length = bytes.len();
    let range = |at: &Index, count: u8| {
        let start = at.index(length);
        start..(start + usize::from(count)).min(length)
    };
    match mutation {
        Mutation::Replace(at, byte) => bytes[at.index(length)] = *byte,
        Mutation::Remove(at, count) => drop(bytes.drain(range(at, *count))),
        Mutation::Insert(at, new) => drop(bytes.splice(range(at, 0), new.iter().copied())),
        Mutation::Repeat(from, count, to) => {
            let copy = bytes[range(from, *count)].to_vec();
            bytes.splice(range(to, 0), copy);
        }
        Mutation::Truncate(at) => bytes.truncate(at.index(length)),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_bytes_print_back(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        prop_assert_eq!(print(&bytes), bytes);
    }

    #[test]
    fn any_lines_print_back(text in r"(?:\[[ 0-9A-Fa-fxsub]{0,9}\]?|[A-Za-z0-9_ ]{0,9}=?[ -~]{0,9}|[;#\t\x00°])*(?:[\r\n]{0,3})") {
        prop_assert_eq!(print(text.as_bytes()), text.as_bytes());
    }

    #[test]
    fn any_damage_to_a_fixture_prints_back(file in any::<Index>(), mutations in prop::collection::vec(mutation(), 1..12)) {
        let files = support::files("", &["eds", "dcf"]);
        let mut bytes = fs::read(&files[file.index(files.len())]).unwrap();
        for mutation in &mutations {
            mutate(&mut bytes, mutation);
        }
        prop_assert!(print(&bytes) == bytes);
    }
}
