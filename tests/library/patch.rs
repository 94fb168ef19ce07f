//! Patches: what is made of two descriptions makes the second of the first, in the model and in the text.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use objdict::format::patch::{Patch, apply, make};
use objdict::format::{self, Description};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn open(path: &Path) -> Description {
    format::open(path, &SourceOptions::default()).unwrap()
}

fn files(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(support::fixtures().join(folder)).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending != "bin"));
    files.sort();
    files
}

fn patch(text: &str) -> Arc<Patch> {
    Arc::new(Patch::read(SourceFile::from_text("test.patch.toml", text)))
}

/// Asserts that the patch of two descriptions makes the second of the first; says whether the text was edited.
fn assert_makes(one: &Path, other: &Path, in_text: bool) {
    let (original, edited) = (open(one), open(other));
    let text = make(original.device(), edited.device());
    let patch = patch(&text);
    let name = format!("{} → {}", one.display(), other.display());
    assert!(patch.findings().is_empty(), "{name}: {:?}\n{text}", patch.findings());
    let patched = apply(original, &[Arc::clone(&patch)]);
    let findings = |description: &Description| {
        let patched = description.patched();
        patched.map(|patched| format!("{:?}", patched.findings)).unwrap_or_default()
    };
    assert!(patched.patched().is_none_or(|patched| !patched.has_errors()), "{name}: {}", findings(&patched));
    assert!(same(&patched, &edited), "{name}\n{text}\n{}", findings(&patched));
    if in_text {
        let realised = patched.realised().unwrap().unwrap();
        assert!(same(&realised, &edited), "{name}: the text");
    }
}

fn same(one: &Description, other: &Description) -> bool {
    objdict::compare::differences(one.device(), other.device()).is_empty()
}

#[test]
fn what_is_made_of_two_fixtures_makes_the_second_of_the_first() {
    for folder in ["eds", "dcf", "xdd", "xdc"] {
        let files = files(folder);
        for (position, one) in files.iter().enumerate() {
            for (other_position, other) in files.iter().enumerate() {
                // the text of each with its successor, which takes longer
                let in_text = (position + 1) % files.len() == other_position;
                if position != other_position {
                    assert_makes(one, other, in_text);
                }
            }
        }
    }
}
