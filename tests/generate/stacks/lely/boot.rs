//! The master of the library boots the files that are written for it, as `network boot` says (`OBJDICT_LELY_DIR`).

use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::bus::{Conditions, Milestone, NmtState, NodeRun, PlantNode, Run, boot};
use objdict::diagnostic::Severity;
use objdict::format::network::{BootFiles, NetworkFile};
use objdict::format::{Format, WriteOptions, write};
use objdict::model::{Access, DataType, Device, DeviceKind, Entry, Object, ObjectLists, Value};
use objdict::network::{DcfgenMode, LelyOptions};

use super::real::Library;
use crate::compile::succeed;
use crate::support::fixtures;

/// Nanoseconds of a millisecond.
const MILLISECOND: u64 = 1_000_000;

/// How long a booted network runs, in nanoseconds.
const AFTER: u64 = 5000 * MILLISECOND;

/// What the master finds out about a node, and the state that the node has.
type Outcome = (u8, char, u8);

/// What the library does: the outcome of each node, the requests to each, and the commands.
struct Theirs {
    outcomes: Vec<Outcome>,
    frames: Vec<(u16, String)>,
}

/// The description of a slave for the library, which becomes operational by itself unless 1F80h forbids it.
fn description(node: &PlantNode) -> Device {
    let mut device = node.switched_on();
    device.kind = DeviceKind::Type;
    device.commissioning = None;
    let main = Entry {
        name: "NMT startup".into(),
        data_type: Some(DataType::UNSIGNED32),
        access: Some(Access::Const),
        default: Some(Value::Unsigned(4)),
        ..Entry::default()
    };
    device.objects.insert(0x1F80, Object { main, ..Object::default() });
    device.lists = ObjectLists::naming(device.objects.keys().copied());
    // an EDS has no configured values
    for object in device.objects.values_mut() {
        for entry in object.subs.iter_mut().map(|(_, entry)| entry).chain([&mut object.main]) {
            if let Some(value) = entry.configured.take().and_then(|configured| configured.value) {
                entry.default = Some(value);
            }
        }
    }
    device
}

fn theirs(
    library: &Library,
    folder: &Path,
    file: &NetworkFile,
    nodes: &[PlantNode],
    time: u64,
) -> Result<Theirs, String> {
    let build = file.build(DcfgenMode::Corrected).map_err(|error| error.to_string())?;
    let mut configuration = "-";
    for built in build.lely(&LelyOptions::default()).map_err(|error| error.to_string())? {
        let mut bytes = built.bytes;
        if built.name == "master.dcf" {
            // the folder of the run time is this one
            let local = |line: &str| match line.strip_prefix("UploadFile=") {
                Some(path) => format!("UploadFile={}\n", path.rsplit('/').next().unwrap_or(path)),
                None => format!("{line}\n"),
            };
            bytes = String::from_utf8(bytes).unwrap().lines().map(local).collect::<String>().into_bytes();
        }
        if built.name == "master.bin" {
            configuration = "master.bin";
        }
        std::fs::write(folder.join(built.name), bytes).unwrap();
    }
    let mut arguments = [&time.to_string(), "master.dcf", configuration].map(str::to_owned).to_vec();
    for node in nodes {
        let name = format!("node{}.eds", node.node_id);
        let written = write(&description(node), Format::Eds, &WriteOptions::default());
        std::fs::write(folder.join(&name), written.map_err(|error| error.to_string())?.bytes).unwrap();
        arguments.extend([node.node_id.to_string(), name]);
    }
    let mut program = Command::new(library.program(folder, "boot.c", &[])?);
    let printed = succeed(program.current_dir(folder).args(&arguments), "")?;
    let mut theirs = Theirs { outcomes: Vec::new(), frames: Vec::new() };
    for line in printed.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        match words.as_slice() {
            ["node", id, state, status] => {
                let state = state.parse::<u8>().unwrap() & 0x7F;
                theirs.outcomes.push((id.parse().unwrap(), status.chars().next().unwrap(), state));
            }
            [id, data] => theirs.frames.push((u16::from_str_radix(id, 16).unwrap(), (*data).to_owned())),
            _ => return Err(format!("unexpected line: {line}")),
        }
    }
    Ok(theirs)
}

/// The outcome of a node as the library prints it.
fn outcome(node: &NodeRun) -> Outcome {
    let status = match &node.milestone {
        _ if node.is_manager => '?',
        None => '?',
        Some(Milestone::Failed(failure)) => failure.status(),
        Some(Milestone::Running) => 'L',
        Some(_) => '-',
    };
    (node.node_id, status, node.state.map_or(0, NmtState::code))
}

/// The SDO requests of the manager to a node.
fn requests(frames: &[(u16, String)], node_id: u8) -> Vec<&str> {
    let is_request = |frame: &&(u16, String)| frame.0 == 0x600 + u16::from(node_id);
    frames.iter().filter(is_request).map(|(_, data)| data.as_str()).collect()
}

fn ours(run: &Run) -> Vec<(u16, String)> {
    let hex = |data: &[u8]| data.iter().map(|byte| format!("{byte:02X}")).collect::<String>();
    run.frames().map(|(_, _, frame)| (frame.id(), hex(frame.data()))).collect()
}

/// Boots a network both ways; where they differ.
fn differences(library: &Library, path: &Path) -> Result<Vec<String>, String> {
    let file = NetworkFile::open(path, &Default::default()).map_err(|error| error.to_string())?;
    if file.check().iter().any(|finding| finding.severity == Severity::Error) {
        return Ok(Vec::new());
    }
    let Ok(installation) = file.install(BootFiles::Lely) else { return Ok(Vec::new()) };
    // the library has a bus without bits
    let mut plant = installation.plant;
    plant.bit_rate = u16::MAX;
    let conditions = Conditions { response: 0, after: AFTER, ..Conditions::default() };
    let run = boot(&plant, &conditions);
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let time = (run.end + AFTER) / MILLISECOND;
    let theirs = theirs(library, folder.path(), &file, &plant.nodes, time)?;
    let frames = ours(&run);
    let mut differences = Vec::new();
    for node in &run.nodes {
        let (ours, id) = (outcome(node), node.node_id);
        let found = theirs.outcomes.iter().find(|outcome| outcome.0 == id);
        // the library resets such nodes, and takes their boot-up message before the process that waits for it
        let assigned = |bits| node.assignment.is_some_and(|assignment| assignment & bits == bits);
        let is_lost =
            |status| (assigned(0x11) && matches!(status, 'E' | 'F')) || (assigned(0x81) && status == 'J');
        if ours.1 == '-' && found.is_some_and(|theirs| is_lost(theirs.1)) {
            continue;
        }
        if found.is_some_and(|theirs| *theirs != ours) {
            differences.push(format!("node {id}: {ours:?}, and {found:?} of the library"));
        }
        let (ours, theirs) = (requests(&frames, id), requests(&theirs.frames, id));
        if ours != theirs {
            let first = ours.iter().zip(&theirs).position(|(ours, theirs)| ours != theirs);
            differences.push(format!(
                "node {id}: {} requests, and {} of the library; the first other one is {first:?}",
                ours.len(),
                theirs.len()
            ));
        }
    }
    Ok(differences)
}

/// The networks of the fixtures, and with `OBJDICT_CORPUS_DIR` those below this folder.
fn networks() -> Vec<PathBuf> {
    let names = ["worked.yml", "wider.yml", "cell.yml", "chapter4.toml"];
    let mut networks: Vec<PathBuf> = names.map(|name| fixtures().join("network").join(name)).to_vec();
    let mut folders: Vec<PathBuf> =
        std::env::var_os("OBJDICT_CORPUS_DIR").map(PathBuf::from).into_iter().collect();
    while let Some(folder) = folders.pop() {
        for path in std::fs::read_dir(folder).into_iter().flatten().map(|entry| entry.unwrap().path()) {
            let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
            match ending.as_str() {
                _ if path.is_dir() => folders.push(path),
                "yml" | "yaml" => networks.push(path),
                _ => {}
            }
        }
    }
    networks.sort();
    networks
}

#[test]
fn the_master_boots_as_network_boot_says() {
    let Some(library) = Library::build() else { return };
    let mut found = Vec::new();
    for path in networks() {
        let differences = differences(&library, &path).unwrap_or_else(|error| vec![error]);
        found.extend(differences.iter().map(|difference| format!("{}: {difference}", path.display())));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
