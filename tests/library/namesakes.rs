//! A type is called like no other type of the workspace: a name in a search, a message or a review has one meaning. Associated types
//! and types of tests are not asked.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::files_below;

/// Names with two meanings, and why both stay.
const TWO_MEANINGS: [(&str, &str); 23] = [
    ("Change", "firmware calls a write so, which never meets a change of a description"),
    ("Configuration", "the word of SARIF"),
    ("Configured", "firmware calls a table with a node-ID so, which never meets an entry of a DCF"),
    ("Dictionary", "the word of CiA 311 for texts of a language, and of CiA 301 for the objects of a device"),
    ("Entry", "the word of CiA 301, in a description and in firmware"),
    ("Fix", "the word of SARIF"),
    ("Heartbeat", "the word of CiA 301, in a network file and in firmware"),
    ("HeartbeatConsumer", "the word of CiA 301, in a description and in firmware"),
    ("Location", "the word of SARIF"),
    ("Message", "the word of SARIF"),
    ("Node", "the word of CiA 301, in a network file and in firmware"),
    ("Options", "code names it with its module: `lint::Options`, `generate::Options`"),
    ("Pdo", "the word of CiA 301, in a description and in firmware"),
    ("Place", "firmware finds an entry of its table by it, which never meets a place of a finding"),
    ("Region", "the word of SARIF, and of flash memories"),
    ("Rule", "the word of SARIF"),
    ("Run", "the word of SARIF"),
    ("Scope", "firmware calls the entries that 1011h restores so, which never meets the scope of a download"),
    ("Services", "the word of CiA 301, in a description and in firmware"),
    ("Shape", "two tables, of keys and of CiA 311 elements, name a shape in every row"),
    ("Stored", "firmware calls a device with storage so, which never meets the file of a manager"),
    ("Subject", "code names it with its module: `document::Subject`, `report::Subject`"),
    ("Time", "the word of CiA 301, in a description and in firmware"),
];

/// More exceptions would make the rule worthless.
const AT_MOST: usize = 60;

#[test]
fn types_have_names_of_their_own() {
    let mut files: BTreeMap<String, BTreeSet<PathBuf>> = BTreeMap::new();
    for path in sources() {
        for name in types(&fs::read_to_string(&path).unwrap()) {
            files.entry(name.to_owned()).or_default().insert(path.clone());
        }
    }
    files.retain(|_, files| files.len() > 1);
    let expected: BTreeSet<&str> = TWO_MEANINGS.iter().map(|&(name, _)| name).collect();
    let found: BTreeSet<&str> = files.keys().map(String::as_str).collect();
    let added: BTreeMap<_, _> = files.iter().filter(|(name, _)| !expected.contains(name.as_str())).collect();
    assert!(added.is_empty(), "rename all but one of these, or add a reason to `TWO_MEANINGS`: {added:#?}");
    let gone: Vec<_> = expected.difference(&found).collect();
    assert!(gone.is_empty(), "remove these from `TWO_MEANINGS`, they have one meaning: {gone:?}");
    assert!(TWO_MEANINGS.len() <= AT_MOST && expected.len() == TWO_MEANINGS.len());
}

/// The files of all crates without their tests.
pub(crate) fn sources() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path().join("src"));
    let files = crates.chain([root.join("src")]).flat_map(|folder| files_below(&folder, &["rs"]));
    let of_tests = |path: &PathBuf| {
        path.components().any(|part| part.as_os_str() == "tests" || part.as_os_str() == "tests.rs")
    };
    files.filter(|path| !of_tests(path)).collect()
}

/// The part of a file in front of its tests.
pub(crate) fn without_tests(text: &str) -> impl Iterator<Item = &str> {
    let mut lines = text.lines().peekable();
    std::iter::from_fn(move || {
        let line = lines.next()?;
        let tests = line == "#[cfg(test)]" && lines.peek().is_some_and(|next| next.ends_with('{'));
        (!tests).then_some(line)
    })
}

/// The names of the types that a file declares. An indented `type` is an associated one, and the name of a macro's type is not known.
fn types(text: &str) -> impl Iterator<Item = &str> {
    without_tests(text).filter_map(|line| {
        let words = ["struct ", "enum ", "trait ", "union ", "type "];
        let words = if line.starts_with(' ') { &words[..4] } else { &words[..] };
        let (declared, _) = declaration(line);
        let name = words.iter().find_map(|word| declared.strip_prefix(word))?;
        name.split(|c: char| !c.is_alphanumeric()).next().filter(|name| !name.is_empty())
    })
}

/// What a line declares, and whether it is visible outside of its module.
pub(crate) fn declaration(line: &str) -> (&str, bool) {
    let line = line.trim_start();
    match line.strip_prefix("pub") {
        Some(rest) if rest.starts_with(' ') => (rest.trim_start(), true),
        Some(rest) if rest.starts_with('(') => {
            (rest.split_once(") ").map_or("", |(_, declared)| declared), true)
        }
        _ => (line, false),
    }
}
