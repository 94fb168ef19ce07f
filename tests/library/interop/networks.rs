//! dcfgen builds the same of a network, python-canopen's device takes what is built, and jsonschema-rs validates with the schemas.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::diagnostic::Tool;
use objdict::format::network::{BuiltFile, NetworkFile, schema};
use objdict::format::patch::{self, Patch};
use objdict::format::{self, Format, WriteOptions};
use objdict::model::{Device, Value};
use objdict::network::{DcfgenMode, LelyOptions, Slave};
use objdict::source::SourceOptions;
use serde_json::json;

use super::{environment, expected_entries, readings, text_of, upload};
use crate::network::{lely, new_folder, of_formats, open, path, verified};
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
        let built = lely(name, &LelyOptions { mode: DcfgenMode::Exact, remote_pdos: true });
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
    for name in NETWORKS.into_iter().chain(["chapter4.toml", "line.toml"]) {
        let folder = new_folder(&format!("nodes-{name}"));
        let network = open(name);
        let build = network.build(DcfgenMode::Corrected).unwrap();
        write(&folder, verified(&build, build.concise().unwrap()));
        write(&folder, verified(&build, build.dcfs().unwrap()));
        let nodes: Vec<_> = network.network().unwrap().slaves().map(|(_, node)| node).collect();
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

/// What a device says of the nodes in objects of a manager, by index and sub-index.
fn of_nodes(device: &Device) -> BTreeMap<String, Value> {
    let objects =
        device.objects.iter().filter(|(index, _)| matches!(index, 0x1016 | 0x1028 | 0x1F20..=0x1F9F));
    let entries = objects.flat_map(|(index, object)| {
        object.entries().map(move |(sub, entry)| (format!("{index:04X}sub{sub:X}"), entry.value().cloned()))
    });
    entries.filter_map(|(name, value)| Some((name, value?))).collect()
}

/// Managers whose descriptions lack objects, have compact ones, are XDD, or are missing: each file of theirs, in each format that
/// it is converted to, says of the nodes what was compiled, to this reader and to others.
#[test]
fn the_file_of_a_manager_has_its_boot_data() {
    let folder = new_folder("managers");
    for file in fs::read_dir(path("")).unwrap() {
        let file = file.unwrap();
        fs::copy(file.path(), folder.join(file.file_name())).unwrap();
    }
    let plc = format::open(&path("plc.eds"), &SourceOptions::default()).unwrap();
    let xdd = format::write(plc.device(), Format::Xdd, &WriteOptions::default()).unwrap();
    fs::write(folder.join("plc.xdd"), xdd.bytes).unwrap();
    let chapter = fs::read_to_string(path("chapter4.toml")).unwrap();
    fs::write(folder.join("xml.toml"), chapter.replace("plc.eds", "plc.xdd")).unwrap();
    let plain = WriteOptions::default();
    let mut compact = WriteOptions::default();
    compact.eds.compact = true;
    let mut files: Vec<(PathBuf, BTreeMap<String, Value>)> = Vec::new();
    for name in ["chapter4.toml", "xml.toml", "cell.yml", "line.toml"] {
        let network = NetworkFile::open(&folder.join(name), &Default::default()).unwrap();
        let build = network.build(DcfgenMode::Corrected).unwrap();
        let compiled = of_nodes(&build.manager_device().unwrap());
        assert!(compiled.keys().any(|name| name.starts_with("1F81sub")), "{name}: {compiled:?}");
        let [BuiltFile { name: built, bytes }] =
            verified(&build, vec![build.manager().unwrap()]).try_into().unwrap();
        let built = folder.join(format!("{name}-{built}"));
        fs::write(&built, bytes).unwrap();
        let read = format::open(&built, &SourceOptions::default()).unwrap();
        let device = read.device();
        let other = match read.format() {
            Format::Xdc => ("plain.dcf", Format::Dcf, &plain),
            _ => ("plain.xdc", Format::Xdc, &plain),
        };
        for (ending, format, options) in [("compact.dcf", Format::Dcf, &compact), other] {
            let path = built.with_extension(ending);
            fs::write(&path, format::write(device, format, options).unwrap().bytes).unwrap();
            files.push((path, compiled.clone()));
        }
        let json = format::json::read_device(&format::json::write_device(device)).unwrap();
        assert_eq!(of_nodes(&json), compiled, "{name} as JSON");
        files.push((built, compiled));
    }
    let programs = environment();
    let paths: Vec<&Path> = files.iter().map(|(path, _)| path.as_path()).collect();
    let mut answers = programs.map(|programs| readings(programs, &paths)).into_iter().flatten();
    for (path, compiled) in &files {
        let shown = path.display();
        let read = format::open(path, &SourceOptions::default()).unwrap();
        assert_eq!(&of_nodes(read.device()), compiled, "{shown}");
        let answer = answers.next();
        if read.format() == Format::Xdc {
            assert_eq!(of_xdc(&fs::read_to_string(path).unwrap()), numbers(compiled), "{shown}");
            continue;
        }
        // python-canopen makes up the entries of compact storage, and refuses it in records
        let is_compact = |name: &str| {
            let index = u16::from_str_radix(&name[..4], 16).unwrap();
            path.to_string_lossy().ends_with("compact.dcf")
                || read.device().object(index).is_some_and(|object| object.compact.is_some())
        };
        for (name, number) in numbers(compiled) {
            for tool in [Tool::DcfTools, Tool::PythonCanopen] {
                let Some(answer) = answer.as_ref().map(|answer| &answer[tool.name()]) else { continue };
                if tool == Tool::DcfTools || !is_compact(&name) {
                    assert_eq!(answer[&name][5].as_i64(), Some(number), "{shown}: {tool}: {name}");
                }
            }
        }
    }
}

/// The values that are numbers, for node-ID 5.
fn numbers(values: &BTreeMap<String, Value>) -> BTreeMap<String, i64> {
    let number = |value: &Value| i64::try_from(value.integer_for(5)?).ok();
    values.iter().filter_map(|(name, value)| Some((name.clone(), number(value)?))).collect()
}

/// The numbers of [`of_nodes`] in the attributes of an XDC.
fn of_xdc(text: &str) -> BTreeMap<String, i64> {
    let document = roxmltree::Document::parse(text).unwrap();
    let mut values = BTreeMap::new();
    for object in document.descendants().filter(|node| node.has_tag_name("CANopenObject")) {
        let index = object.attribute("index").unwrap();
        for entry in object.children().filter(|node| node.has_tag_name("CANopenSubObject")).chain([object]) {
            let value = ["actualValue", "defaultValue"].iter().find_map(|name| entry.attribute(*name));
            let sub = entry.attribute("subIndex").map_or(0, |sub| u8::from_str_radix(sub, 16).unwrap());
            let number = value.map(|value| {
                value.strip_prefix("0x").map_or(value.parse(), |hex| i64::from_str_radix(hex, 16))
            });
            if let Some(Ok(number)) = number {
                values.insert(format!("{index}sub{sub:X}"), number);
            }
        }
    }
    // the streams in 1F22h are bytes
    let is_of_nodes = |name: &str| ["1016", "1028", "1F"].iter().any(|index| name.starts_with(index));
    values.retain(|name, _| is_of_nodes(name) && !name.starts_with("1F22sub") || name == "1F22sub0");
    values
}

/// python-canopen reads the effective values of every node, the manager among them, in the DCFs.
#[test]
fn dcfs_have_the_effective_values() {
    let Some(programs) = environment() else { return };
    let files = NETWORKS.into_iter().chain(["chapter4.toml", "line.toml"]).map(|name| (name, open(name)));
    for (name, file) in files.chain([("formats", of_formats())]) {
        let folder = new_folder(&format!("effective-{name}"));
        let network = file.network().unwrap();
        let build = file.build(DcfgenMode::Corrected).unwrap();
        write(&folder, verified(&build, build.dcfs().unwrap()));
        let compiled = file.compiled().unwrap();
        let described = |slave: &Slave| {
            let mut device = slave.device.clone();
            // python-canopen reads no values of compact storage
            device.objects.retain(|_, object| object.compact.is_none());
            let file = format!("{}.dcf", network.nodes[slave.node].name.value);
            let entries = expected_entries(&device, slave.node_id);
            json!({ "file": file, "node_id": slave.node_id, "entries": entries })
        };
        let expected: Vec<_> = compiled.nodes().map(described).collect();
        upload(programs, &folder, &expected);
    }
}

/// The rules about what a schema says too.
/// Patches that a schema rejects: no format, an unknown key, a wrong type, a number out of range, a word that there is not.
const WRONG_PATCHES: [&str; 6] = [
    "vendor-id = 1\n",
    "format = \"objdict-patch/1\"\nvendor = 1\n",
    "format = \"objdict-patch/1\"\nvendor-id = \"one\"\n",
    "format = \"objdict-patch/1\"\nvendor-id = 0x100000000\n",
    "format = \"objdict-patch/2\"\n",
    "format = \"objdict-patch/1\"\n[[change]]\nat = \"2001\"\nset = { typ = \"u8\" }\n",
];

const OF_SCHEMAS: [&str; 5] = ["invalid-change", "missing-key", "out-of-range", "unknown-key", "wrong-type"];

/// A file that is rejected has a finding of these rules, and each example of them is rejected.
#[test]
fn the_schemas_say_what_the_reader_says() {
    let Some(programs) = environment() else { return };
    let folder = new_folder("schemas");
    let schemas = [
        ("bus.json", schema::bus_yml()),
        ("network.json", schema::network_toml()),
        ("patch.json", patch::schema::patch()),
    ];
    let schemas = schemas.map(|(name, schema)| {
        fs::write(folder.join(name), schema.to_string()).unwrap();
        folder.join(name)
    });
    let groups = ["keys", "network", "patch"].map(|group| support::fixtures().join("rules").join(group));
    let rules = groups.iter().flat_map(|group| fs::read_dir(group).unwrap());
    let mut files: Vec<PathBuf> = rules
        .flat_map(|rule| fs::read_dir(rule.unwrap().path()).unwrap())
        .map(|file| file.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml" || ending == "yml"))
        .filter(|path| !path.ends_with("invalid-toml/bad.toml") && !path.ends_with("invalid-yaml/bad.yml"))
        .filter(|path| !path.ends_with("key-defined-twice/bad.toml"))
        // for a schema each key is the name of a node
        .filter(|path| !path.ends_with("unknown-key/bad-options.yml"))
        .collect();
    files.extend(["worked.yml", "cell.yml", "chapter4.toml", "line.toml"].map(path));
    files.push(support::fixtures().join("patches/io-401.patch.toml"));
    for (number, keys) in WRONG_PATCHES.iter().enumerate() {
        files.push(folder.join(format!("{number}.patch.toml")));
        fs::write(files.last().unwrap(), keys).unwrap();
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/validate.py");
    let output =
        Command::new(programs.join("python")).arg(script).args(schemas).args(&files).output().unwrap();
    assert!(output.status.success(), "{}", text_of(&output));
    let rejected: Vec<PathBuf> = String::from_utf8_lossy(&output.stdout).lines().map(PathBuf::from).collect();
    let mut differing = Vec::new();
    for file in &files {
        let is_patch = ["patches", "patch"]
            .iter()
            .any(|folder| file.components().any(|part| part.as_os_str() == *folder));
        let findings = match is_patch || file.to_string_lossy().ends_with(".patch.toml") {
            true => Patch::open(file).unwrap().findings().clone(),
            false => NetworkFile::open(file, &Default::default()).unwrap().check(),
        };
        let is_found = findings.iter().any(|finding| OF_SCHEMAS.contains(&finding.rule.name()));
        if rejected.contains(file) != is_found {
            differing.push(file);
        }
    }
    assert!(differing.is_empty(), "{differing:?}");
    assert!(rejected.len() >= OF_SCHEMAS.len());
}
