//! The target `canopennode-v1`.

use std::collections::HashSet;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::{Note, Options, Target, generate};
use objdict::model::{Device, Value};

use crate::compile::{c_compiler, cc, generate_with, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::processors::build;
use crate::stacks::canfestival::address;
use crate::stacks::canopennode::{NODE_ID, predefined};
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{beside, checkout, startup};

/// What the rows lack.
const LACKS: &[Lack] = &[
    Lack { what: "no data types", of: |_| true, instead: |row| Some(Row { data_type: None, ..row }) },
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
    Lack {
        what: "COB-IDs without a node-ID are those of the pre-defined connection set",
        of: |row| row.index != 0x1014 && predefined(row).is_some(),
        instead: |row| Some(Row { default: predefined(&row), ..row }),
    },
    Lack {
        what: "the stack counts errors itself",
        of: |row| (row.index, row.sub) == (0x1003, 0),
        instead: |_| None,
    },
];

/// The expected entries. The stack adds the node-ID to a fixed number in 1014h, too; that of this node is stored without it.
fn expected(device: &Device) -> Vec<Row> {
    let mut rows = without(LACKS, truth(device, NODE_ID));
    let value = device.entry(0x1014, 0).and_then(|entry| entry.value().cloned());
    for row in rows.iter_mut().filter(|row| (row.index, row.sub, row.size) == (0x1014, 0, Some(4))) {
        let bytes = row.default.as_deref().and_then(|bytes| bytes.try_into().ok());
        let added = bytes.map(|bytes| u32::from_le_bytes(bytes).wrapping_add(u32::from(NODE_ID)));
        let is_of_node = added.is_some_and(|added| added & 0x7FF == 0x80 + 2 * u32::from(NODE_ID));
        if let (Some(added), false) = (added, is_of_node || matches!(value, Some(Value::NodeId(_)))) {
            row.default = Some(added.to_le_bytes().to_vec());
        }
    }
    rows
}

fn write(folder: &Path, device: &Device, options: &Options) -> Vec<Note> {
    generate_with(folder, device, "canopennode-v1", options).notes
}

/// The entries, one per line, without the number of errors, and the notes.
pub(crate) fn dump(compiler: &str, folder: &Path, device: &Device) -> Result<(String, Vec<Note>), String> {
    let mut options = Options::default();
    options.node_id = Some(NODE_ID);
    let notes = write(folder, device, &options);
    let mut cc = cc(compiler, folder);
    cc.arg("-I.").arg(format!("-I{}", beside("canopennode_v1", "include").display()));
    cc.args(["-o", "harness", "CO_OD.c"]).arg(beside("canopennode_v1", "harness.c"));
    let printed = build(&cc)?.run(&[&NODE_ID.to_string()], "")?;
    let lines = printed.lines().filter(|line| !line.starts_with("1003 00 "));
    Ok((lines.map(|line| format!("{line}\n")).collect(), notes))
}

#[test]
fn the_tables_have_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let (dump, _) = dump(&compiler, folder.path(), device).map_err(fail)?;
        compare(name, &expected(device), &dump).map_err(fail)
    });
}

#[test]
fn the_files_of_a_small_device() {
    let device = crate::devices::device(&crate::support::fixtures().join("eds/minimal.eds"));
    for file in generate(&device, Target::CANOPENNODE_V1, &Options::default()).unwrap().files {
        let text = String::from_utf8(file.contents).unwrap().replace(env!("CARGO_PKG_VERSION"), "[version]");
        insta::assert_snapshot!(file.path, text);
    }
}

/// The sources of the stack without a bus.
const SOURCES: [&str; 14] = [
    "stack/drvTemplate/CO_driver.c",
    "stack/crc16-ccitt.c",
    "stack/CO_SDO.c",
    "stack/CO_Emergency.c",
    "stack/CO_NMT_Heartbeat.c",
    "stack/CO_SYNC.c",
    "stack/CO_TIME.c",
    "stack/CO_PDO.c",
    "stack/CO_HBconsumer.c",
    "stack/CO_SDOmaster.c",
    "stack/CO_LSSmaster.c",
    "stack/CO_LSSslave.c",
    "stack/CO_trace.c",
    "CANopen.c",
];

/// What the stack answers otherwise than its tables say: states, entries that it does not know, empty values and long ones.
fn is_answered_by_the_stack(row: &Row) -> bool {
    let is_long = row.size.is_none_or(|size| size == 0 || size > 889);
    !row.read
        || is_long
        || matches!(row.index, 0x1001 | 0x1003 | 0x2100)
        || row.index == 0x1200 && row.sub > 2 // the node-ID is added there, too
        || (0x1800..=0x19FF).contains(&row.index) && row.sub == 4
        || matches!(row.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF) && row.sub == 0 // 0 without a mapping that is valid
        || (0x1280..=0x12FF).contains(&row.index) && row.sub > 0 // an SDO client begins without a server
}

/// The COB-ID of a PDO without the bit that the stack sets when it cannot use the PDO.
fn without_state(mut row: Row) -> Row {
    let is_id = row.sub == 1 && matches!(row.index, 0x1400..=0x15FF | 0x1800..=0x19FF);
    if let (true, Some([.., high])) = (is_id, row.default.as_deref_mut()) {
        *high |= 0x80;
    }
    row
}

/// `OBJDICT_CANOPENNODE_V1_DIR` names a checkout of the stack 1.3: it compiles and starts with the tables, and its SDO server
/// reads them.
#[test]
fn the_sdo_server_of_the_real_stack_reads_the_tables() {
    let (Some(stack), Some(compiler)) = (checkout("OBJDICT_CANOPENNODE_V1_DIR"), c_compiler()) else {
        return;
    };
    let found = AtomicUsize::new(0);
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let mut options = Options::default();
        options.node_id = Some(NODE_ID);
        let notes = write(folder.path(), device, &options);
        if startup::is_undefined(&notes) {
            return Ok(());
        }
        let cc = || {
            let mut command = std::process::Command::new(&compiler);
            command.current_dir(folder.path()).args(["-std=gnu99", "-I.", "-DCO_SDO_BUFFER_SIZE=889"]);
            for include in ["stack/drvTemplate", "stack", ""] {
                command.arg("-isystem").arg(stack.join(include));
            }
            command
        };
        let warnings = ["-Wall", "-Wextra", "-Werror", "-c", "CO_OD.c"];
        succeed(cc().args(warnings), "").map_err(fail)?;
        let mut build = cc();
        build.args(["-w", "-o", "node", "CO_OD.o"]).args(SOURCES.map(|source| stack.join(source)));
        succeed(build.arg(beside("canopennode_v1", "node.c")), "").map_err(fail)?;
        let mut node = std::process::Command::new(folder.path().join("node"));
        let printed = succeed(node.arg(NODE_ID.to_string()), "").map_err(fail)?;
        found.fetch_add(startup::compare(device, &notes, &printed).map_err(fail)?, Ordering::Relaxed);
        let rows = expected(device).into_iter().filter(|row| !is_answered_by_the_stack(row));
        let rows: Vec<Row> = rows.map(without_state).collect();
        let known: HashSet<(u16, u8)> = rows.iter().map(|row| (row.index, row.sub)).collect();
        let lines = printed.lines().filter(|line| address(line).is_some_and(|at| known.contains(&at)));
        let lines: String = lines.map(|line| format!("{}\n", line_without_state(line))).collect();
        compare(name, &rows, &lines).map_err(fail)
    });
    eprintln!("CANopenNode 1.3: {found:?} predictions");
}

/// The same for a line.
fn line_without_state(line: &str) -> String {
    let is_id = address(line)
        .is_some_and(|(index, sub)| sub == 1 && matches!(index, 0x1400..=0x15FF | 0x1800..=0x19FF));
    let (start, high) = line.split_at(line.len().saturating_sub(2));
    match u8::from_str_radix(high, 16) {
        Ok(high) if is_id => format!("{start}{:02X}", high | 0x80),
        _ => line.to_owned(),
    }
}
