//! Another reader of INI files, rust-ini, finds the same sections, keys and values in every healthy description as our
//! scanner does.

use std::fs;
use std::path::{Path, PathBuf};

use ini::{Ini, ParseOption};
use objdict::source::{SourceFile, SourceOptions};
use objdict_eds::ini::Document;

/// Section, key, value.
type Item = (String, String, String);

fn ours(source: SourceFile) -> Vec<Item> {
    let document = Document::new(source);
    let text = document.text();
    let mut items = Vec::new();
    document.visit(
        |section| {
            let name = section.header.map_or("", |header| header.name.of(text));
            for entry in &section.entries {
                items.push((name.to_owned(), entry.key.of(text).to_owned(), entry.value.of(text).to_owned()));
            }
        },
        |_| {},
    );
    items
}

/// With everything switched off that changes values: an EDS knows neither quotes nor escapes.
fn theirs(text: &str) -> Vec<Item> {
    let options = ParseOption { enabled_quote: false, enabled_escape: false, ..ParseOption::default() };
    let ini = Ini::load_from_str_opt(text, options).unwrap();
    let mut items = Vec::new();
    for (section, properties) in &ini {
        for (key, value) in properties {
            items.push((section.unwrap_or_default().to_owned(), key.to_owned(), value.to_owned()));
        }
    }
    items
}

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(folder);
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> = entries
        .filter(|path| {
            path.extension().is_some_and(|ending| ["eds", "dcf"].iter().any(|known| ending == *known))
        })
        .collect();
    files.sort();
    files
}

#[test]
fn every_healthy_file_reads_the_same() {
    let files = [files("eds"), files("dcf")].concat();
    assert!(files.len() > 10, "{files:?}");
    for path in files {
        let name = path.file_name().unwrap().to_str().unwrap();
        let source = SourceFile::open(&path, &SourceOptions::default()).unwrap();
        let theirs = theirs(source.text());
        let ours = ours(source);
        assert!(!ours.is_empty(), "{name}");
        for (ours, theirs) in ours.iter().zip(&theirs) {
            assert_eq!(ours, theirs, "{name}");
        }
        assert_eq!(ours.len(), theirs.len(), "{name}");
    }
}

/// Why an EDS never passes through rust-ini itself. When this fails, rust-ini has changed, and with it what node lists
/// may rely on.
#[test]
fn what_rust_ini_reads_differently() {
    let source = |text: &str| SourceFile::from_text("x", text);
    let backslash = "[A]\nPath=C:\\eds\\\nNext=1\n";
    assert_eq!(ours(source(backslash)).len(), 2);
    assert_eq!(theirs(backslash).len(), 1, "a backslash before LF joins two lines");
    let indented = "[A]\n  ; remark\nk=1\n";
    assert_eq!(ours(source(indented))[0].1, "k");
    assert_ne!(theirs(indented)[0].1, "k", "a remark behind blanks becomes a part of the next key");
    let colon = "[A]\nHost:port=1\n";
    assert_eq!(ours(source(colon))[0].1, "Host:port");
    assert_eq!(theirs(colon)[0].1, "Host", "a colon separates too");
}
