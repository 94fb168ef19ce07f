//! dcfgen builds the same of a network, python-canopen's device takes what is built, and jsonschema validates with the schemas.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::format::network::{BuiltFile, NetworkFile, schema};
use objdict::network::{LelyOptions, Manner};

use super::{environment, text_of};
use crate::network::{lely, new_folder, open, path};
use crate::support;

const NETWORKS: [&str; 2] = ["worked.yml", "cell.yml"];

fn write(folder: &Path, files: Vec<BuiltFile>) {
    for BuiltFile { name, bytes } in files {
        fs::write(folder.join(name), bytes).unwrap();
    }
}

#[test]
fn dcfgen_builds_the_same() {
    let Some(programs) = environment() else { return };
    for name in NETWORKS {
        let folder = new_folder(&format!("dcfgen-{name}"));
        let mut dcfgen = Command::new(programs.join("dcfgen"));
        // without -S it checks the descriptions too
        dcfgen.args(["-r", "-d"]).arg(&folder).arg(path(name)).current_dir(path(""));
        let output = dcfgen.output().unwrap();
        assert!(output.status.success(), "{name}: {}", text_of(&output));
        let built = lely(name, &LelyOptions { manner: Manner::Strict, remote_pdos: true });
        let mut names: Vec<String> = fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        let mut ours: Vec<&str> = built.iter().map(|file| file.name.as_str()).collect();
        names.sort_unstable();
        ours.sort_unstable();
        assert_eq!(ours, names, "{name}");
        for file in &built {
            let other = fs::read(folder.join(&file.name)).unwrap();
            let [ours, other] = [&file.bytes, &other].map(|bytes| String::from_utf8_lossy(bytes));
            assert_eq!(ours, other, "{name}: {}", file.name);
        }
    }
}

/// Each node on a virtual bus takes its configuration, and has the values of its DCF in the end.
#[test]
fn nodes_take_their_configurations() {
    let Some(programs) = environment() else { return };
    for name in NETWORKS.into_iter().chain(["chapter4.toml"]) {
        let folder = new_folder(&format!("nodes-{name}"));
        let network = open(name);
        let build = network.build(Manner::Repaired).unwrap();
        write(&folder, build.concise().unwrap());
        write(&folder, build.dcfs().unwrap());
        let nodes: Vec<_> = network.network.as_ref().unwrap().slaves().map(|(_, node)| node).collect();
        for node in &nodes {
            fs::copy(path(&node.file.value), folder.join(format!("{}.eds", node.name.value))).unwrap();
        }
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/configure.py");
        let names = nodes.iter().map(|node| &node.name.value);
        let output =
            Command::new(programs.join("python")).arg(script).arg(&folder).args(names).output().unwrap();
        assert!(output.status.success(), "{name}: {}", text_of(&output));
    }
}

/// The rules about what a schema says too.
const OF_SCHEMAS: [&str; 4] = ["missing-key", "out-of-range", "unknown-key", "wrong-type"];

/// A file that is rejected has a finding of these rules, and each example of them is rejected.
#[test]
fn the_schemas_say_what_the_reader_says() {
    let Some(programs) = environment() else { return };
    let folder = new_folder("schemas");
    let schemas = [("bus.json", schema::bus_yml()), ("network.json", schema::network_toml())];
    let schemas = schemas.map(|(name, schema)| {
        fs::write(folder.join(name), schema.to_string()).unwrap();
        folder.join(name)
    });
    let rules = fs::read_dir(support::fixtures().join("rules/network")).unwrap();
    let mut files: Vec<PathBuf> = rules
        .flat_map(|rule| fs::read_dir(rule.unwrap().path()).unwrap())
        .map(|file| file.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml" || ending == "yml"))
        .filter(|path| !path.ends_with("invalid-toml/bad.toml") && !path.ends_with("invalid-yaml/bad.yml"))
        .filter(|path| !path.ends_with("key-defined-twice/bad.toml"))
        .collect();
    files.extend(["worked.yml", "cell.yml", "chapter4.toml"].map(path));
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/validate.py");
    let output =
        Command::new(programs.join("python")).arg(script).args(schemas).args(&files).output().unwrap();
    assert!(output.status.success(), "{}", text_of(&output));
    let rejected: Vec<PathBuf> = String::from_utf8_lossy(&output.stdout).lines().map(PathBuf::from).collect();
    let mut differing = Vec::new();
    for file in &files {
        let findings = NetworkFile::open(file, &BTreeMap::new()).unwrap().check();
        let is_found = findings.iter().any(|finding| OF_SCHEMAS.contains(&finding.rule.name()));
        if rejected.contains(file) != is_found {
            differing.push(file);
        }
    }
    assert!(differing.is_empty(), "{differing:?}");
    assert!(rejected.len() >= OF_SCHEMAS.len());
}
