//! A public type is called like no other public type of the workspace. `objdict-device` is not asked: it runs on the device,
//! where the others do not.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// What formats and steps have alike, and what code names with the module that it is of: `lint::Options`.
const OF_MODULES: [&str; 7] = ["BitField", "Editor", "Entry", "Locator", "Options", "Part", "Subject"];

#[test]
fn public_types_have_names_of_their_own() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path().join("src"));
    let crates = crates.filter(|folder| !folder.ends_with("objdict-device/src"));
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for path in crates.chain([root.join("src")]).flat_map(|folder| sources(&folder)) {
        let text = fs::read_to_string(&path).unwrap();
        let path = path.strip_prefix(root).unwrap().display().to_string();
        for name in text.lines().filter_map(public_type) {
            places.entry(name.to_owned()).or_default().push(path.clone());
        }
    }
    places.retain(|_, places| places.len() > 1);
    let names: Vec<&str> = places.keys().map(String::as_str).collect();
    assert_eq!(names, OF_MODULES, "{places:#?}");
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    files
}

/// The name of the public type that a line declares; none where a macro does.
fn public_type(line: &str) -> Option<&str> {
    let declared = line.trim_start().strip_prefix("pub ")?;
    let name = ["struct ", "enum ", "trait ", "type "].iter().find_map(|word| declared.strip_prefix(word))?;
    name.split(|c: char| !c.is_alphanumeric()).next().filter(|name| !name.is_empty())
}
