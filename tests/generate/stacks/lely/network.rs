//! The files of Lely's master for a network, loaded by the library itself (`OBJDICT_LELY_DIR`).

use std::path::Path;

use objdict::download::ConciseDcf;
use objdict::format::network::{BuiltFile, NetworkFile};
use objdict::network::{DcfgenMode, LelyOptions, Node};

use super::LACKS;
use super::real::Library;
use crate::devices::device;
use crate::stacks::truth::{Row, compare, truth, without};
use crate::support::fixtures;

/// The entries of a description in the library: it takes the name of a file for the value, and the serial number of the
/// node for that of the identity.
fn described(description: &Path, node_id: u8) -> Vec<Row> {
    let device = device(description);
    let mut rows = without(&LACKS, truth(&device, node_id));
    let serial_number = device.commissioning.as_ref().and_then(|node| node.lss_serial_number);
    let history =
        device.object(0x1003).and_then(|object| object.compact.as_ref()).map(|compact| compact.count);
    for row in &mut rows {
        let configured = device.entry(row.index, row.sub).and_then(|entry| entry.configured.clone());
        if let Some(file) = configured.and_then(|configured| configured.upload_file) {
            row.default = Some([file.as_bytes(), b"\0"].concat());
        } else if let (0x1018, 4, Some(number)) = (row.index, row.sub, serial_number) {
            row.default = Some(number.to_le_bytes().to_vec());
        } else if let (0x1003, 0, Some(count)) = (row.index, row.sub, history) {
            (row.write, row.default) = (false, Some(vec![count])); // compact storage, as CiA 306 has it
        }
    }
    rows
}

/// Loads a description and its configuration, if it has one: what is downloaded last counts, all else stays as described.
/// Returns what the library has then.
fn load(library: &Library, folder: &Path, description: &Path, node_id: u8, configuration: &str) -> String {
    let (mut rows, node_id_text) = (described(description, node_id), node_id.to_string());
    let mut arguments = vec![node_id_text.as_str(), description.to_str().unwrap()];
    let path = folder.join(configuration);
    if let Ok(bytes) = std::fs::read(&path) {
        arguments.push(path.to_str().unwrap());
        for download in ConciseDcf::parse(&bytes).unwrap().0 {
            let at = |row: &&mut Row| (row.index, row.sub) == (download.index, download.sub);
            let row = rows.iter_mut().find(at);
            row.unwrap_or_else(|| panic!("{configuration}: {download:?}")).default =
                Some(download.data.clone());
        }
    }
    let printed = library.print(folder, "loaded.c", &[], &arguments).unwrap();
    compare(configuration, &rows, &printed).unwrap();
    printed
}

/// What the networks say of the first consumer heartbeat time, the first RPDO, and a node: assignment, identity.
const STATED: [(&str, u8, &[&str]); 2] = [
    (
        "worked.yml",
        1,
        &[
            "1016 01 07 4 rw-- 58020500",
            "1400 01 07 4 rw-- 85010040",
            "1600 01 07 4 rw-- 10010020",
            "1F81 05 07 4 rw-- 0D036400",
            "1F87 05 07 4 rw-- 02000100",
            "1F88 05 07 4 rw-- 4D000000",
        ],
    ),
    (
        "cell.yml",
        127,
        &[
            "1016 01 07 4 rw-- F4010B00",
            "1400 01 07 4 rw-- 8B010000",
            "1600 01 07 4 rw-- 10010020",
            "1F81 03 07 4 rw-- 15026400",
            "1F81 0B 07 4 rw-- 0D030000",
            "1F87 0C 07 4 rw-- 02000100",
        ],
    ),
];

#[test]
fn the_library_loads_the_master_and_the_nodes() {
    let Some(library) = Library::build() else { return };
    for (name, node_id, stated) in STATED {
        for (mode, remote_pdos) in [(DcfgenMode::Corrected, false), (DcfgenMode::Exact, true)] {
            let folder = tempfile::tempdir().unwrap();
            let folder = folder.path();
            let file =
                NetworkFile::open(&fixtures().join("network").join(name), &Default::default()).unwrap();
            let options = LelyOptions { mode, remote_pdos };
            for BuiltFile { name, bytes } in file.build(mode).unwrap().lely(&options).unwrap() {
                std::fs::write(folder.join(name), bytes).unwrap();
            }
            let master = load(&library, folder, &folder.join("master.dcf"), node_id, "master.bin");
            for row in stated {
                assert!(master.lines().any(|line| line == *row), "{name}: no `{row}` in\n{master}");
            }
            for Node { name, file, node_id, .. } in &file.network().unwrap().nodes {
                let description =
                    fixtures().join("network").join(Path::new(&file.value).file_name().unwrap());
                let configuration = format!("{}.bin", name.value);
                assert!(folder.join(&configuration).is_file(), "no {configuration}");
                load(&library, folder, &description, node_id.as_ref().unwrap().value, &configuration);
            }
        }
    }
}
