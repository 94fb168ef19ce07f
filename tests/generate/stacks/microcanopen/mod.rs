//! The target `microcanopen`.

use std::path::Path;

use objdict::generate::Generated;
use objdict::model::{Device, TypeKind, Value};

use crate::compile::{c_compiler, cc, generate_with};
use crate::devices::{arbitrary_devices, device, devices, for_all};
use crate::processors::{Programs, build};
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{Harness, beside, for_node};
use crate::support::fixtures;

/// Whether the stored length is the actual length of a value.
fn is_text(row: &Row) -> bool {
    use TypeKind::{Domain, OctetString, UnicodeString, VisibleString};
    matches!(row.kind, Some(VisibleString | OctetString | UnicodeString | Domain))
}

/// Whether the entry is not in the process image and therefore not writable.
fn is_reply(row: &Row) -> bool {
    row.index < 0x2000 || is_text(row)
}

/// Data missing in the tables.
const LACKS: [Lack; 5] = [
    Lack { what: "no data types", of: |_| true, instead: |row| Some(Row { data_type: None, ..row }) },
    Lack {
        what: "no flags for mapping",
        of: |_| true,
        instead: |row| Some(Row { tpdo: false, rpdo: false, ..row }),
    },
    Lack {
        what: "error register and heartbeat time are in the stack",
        of: |row| matches!((row.index, row.sub), (0x1001 | 0x1017, 0)),
        instead: |_| None,
    },
    Lack {
        what: "nothing is written outside of the process image",
        of: is_reply,
        instead: |row| {
            let size = row.default.as_ref().map(Vec::len);
            row.read.then_some(Row { write: false, size, ..row })
        },
    },
    Lack {
        what: "values of 1 to 4 bytes",
        of: |row| !(1..=4).contains(&row.size.unwrap_or(0)),
        instead: |_| None,
    },
];

fn write(folder: &Path, device: &Device, node_id: u8) -> Generated {
    generate_with(folder, device, "microcanopen", &for_node(node_id))
}

fn built(compiler: &str, folder: &Path) -> Programs {
    let mut cc = cc(compiler, folder);
    cc.arg("-I.").arg(format!("-I{}", beside("microcanopen", "include").display()));
    cc.args(["-o", "harness", "device_mco.c"]).arg(beside("microcanopen", "harness.c"));
    build(&cc)
}

/// The entries found by the stack.
pub(crate) fn harness(compiler: &str, folder: &Path, device: &Device, node_id: u8) -> Harness {
    let notes = write(folder, device, node_id).notes;
    Harness { programs: built(compiler, folder), arguments: Vec::new(), notes }
}

#[test]
fn a_client_reads_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        for node_id in [5, 127] {
            let fail = |error: String| format!("{name}, node {node_id}: {error}");
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let rows = without(&LACKS, truth(device, node_id));
            let harness = harness(&compiler, folder.path(), device, node_id);
            harness.check(&rows, |dump| compare(name, &rows, dump)).map_err(fail)?;
        }
        Ok(())
    });
}

#[test]
fn pdos_are_initialised_with_what_lies_in_the_image() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let generated = write(folder.path(), &device(&fixtures().join("eds/io-401.eds")), 5);
    let calls = built(&compiler, folder.path()).run(&["pdos"], "").unwrap();
    insta::assert_snapshot!("calls", calls);
    let notes: String = generated.notes.iter().map(|note| format!("{note}\n")).collect();
    insta::assert_snapshot!("notes", notes);
}

#[test]
fn inhibit_times_are_rounded_up() {
    let mut device = device(&fixtures().join("eds/io-401.eds"));
    for (tenths, milliseconds) in [(11, 2), (20, 2)] {
        let communication = device.objects.get_mut(&0x1800).unwrap();
        communication.subs.get_mut(3).unwrap().default = Some(Value::Unsigned(tenths));
        let files = write(tempfile::tempdir().unwrap().path(), &device, 5).files;
        let call = format!("MCO_InitTPDO(1, 0, 0, {milliseconds}, 2, 0);");
        assert!(files.iter().any(|file| String::from_utf8_lossy(&file.contents).contains(&call)), "{call}");
    }
}
