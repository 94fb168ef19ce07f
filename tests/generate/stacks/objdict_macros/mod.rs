//! The target `objdict-macros`.

use std::path::Path;

use objdict::model::{Device, PdoKind};

use crate::compile::{c_compiler, cc, generate_with};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::processors::build;
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{Harness, beside, for_node};

/// Data missing in the rows.
const LACKS: [Lack; 3] = [
    Lack { what: "no data types", of: |_| true, instead: |row| Some(Row { data_type: None, ..row }) },
    Lack {
        what: "mapping in one direction",
        of: |row| row.tpdo && row.rpdo,
        instead: |row| Some(Row { tpdo: false, ..row }),
    },
    Lack {
        what: "one length",
        of: |_| true,
        instead: |mut row| {
            if let (Some(default), Some(size)) = (&mut row.default, row.size) {
                default.resize(size, 0);
            }
            Some(row)
        },
    },
];

/// The mapping as the harness prints it.
fn mapping(device: &Device) -> String {
    let mut text = String::new();
    for kind in PdoKind::ALL {
        let last = device.pdos().filter(|pdo| pdo.kind == kind).map(|pdo| pdo.number).max().unwrap_or(0);
        for number in 1..=last {
            let pdo = device.pdo(kind, number);
            let mapped = pdo.iter().flat_map(|pdo| pdo.mapped().take(8).collect::<Vec<_>>());
            let mapped = mapped.map(|to| format!(" {:04X}.{:02X}.{}", to.index, to.sub, to.bits));
            text.push_str(&format!("{kind} {number}:{}\n", mapped.collect::<String>()));
        }
    }
    text
}

/// The rows.
pub(crate) fn harness(compiler: &str, folder: &Path, device: &Device, node_id: u8) -> Harness {
    let generated = generate_with(folder, device, "objdict-macros", &for_node(node_id));
    let mut cc = cc(compiler, folder);
    let cc = cc.args(["-I.", "-o", "harness", "objdict.c", "mapping.c"]);
    let programs = build(cc.arg(beside("objdict_macros", "harness.c")));
    Harness { programs, arguments: Vec::new(), notes: generated.notes }
}

#[test]
fn the_rows_have_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        for node_id in [5, 127] {
            let fail = |error: String| format!("{name}, node {node_id}: {error}");
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let rows = without(&LACKS, truth(device, node_id));
            let harness = harness(&compiler, folder.path(), device, node_id);
            harness.check(&rows, |dump| compare(name, &rows, dump)).map_err(fail)?;
            harness.programs.expect(&["mapping"], &mapping(device)).map_err(fail)?;
        }
        Ok(())
    });
}
