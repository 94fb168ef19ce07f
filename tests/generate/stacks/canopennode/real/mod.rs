//! The real stack, if `OBJDICT_CANOPENNODE_DIR` names a checkout: it compiles with the tables, starts, and
//! its SDO server answers as described.

mod client;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::{Note, Options};
use objdict::model::{PdoKind, TypeKind};

use super::output::shapes;
use super::{NODE_ID, expected, generate_into};
use crate::compile::{c_compiler, succeed};
use crate::devices::{devices, for_all};
use crate::oracle::hex;
use crate::stacks::truth::Row;
use crate::stacks::{beside, checkout, startup};

/// The files of the stack besides `CANopen.c`, which do not depend on the tables.
const SOURCES: [&str; 12] = [
    "301/CO_Emergency",
    "301/CO_HBconsumer",
    "301/CO_NMT_Heartbeat",
    "301/CO_ODinterface",
    "301/CO_PDO",
    "301/CO_SDOclient",
    "301/CO_SDOserver",
    "301/CO_SYNC",
    "301/CO_TIME",
    "303/CO_LEDs",
    "305/CO_LSSslave",
    "storage/CO_storage",
];

fn sources(stack: &Path) -> impl Iterator<Item = PathBuf> {
    SOURCES.iter().map(|source| stack.join(source).with_extension("c"))
}

/// Compiles the tables with the headers of the real stack, and the stack with the tables: this fails exactly
/// if a note says so.
pub(super) fn compiles(compiler: &str, folder: &Path, stack: &Path, notes: &[Note]) -> Result<(), String> {
    let cc = |flags: &[&str]| {
        let mut cc = Command::new(compiler);
        cc.current_dir(folder).args(["-std=c99", "-fsyntax-only", "-I."]).arg("-I").arg(stack);
        cc.arg("-I").arg(stack.join("example")).args(flags);
        cc
    };
    succeed(&mut cc(&["-Wall", "-Wextra", "-Werror", "OD.c"]), "")?;
    succeed(cc(&["-DCO_MULTIPLE_OD", "-include", "OD.h"]).arg(stack.join("CANopen.c")), "")?;
    let refused: Vec<&Note> = notes.iter().filter(|note| note.message.contains("not compile")).collect();
    match (succeed(cc(&[]).arg(stack.join("CANopen.c")), ""), refused.as_slice()) {
        (Ok(_), []) | (Err(_), [_, ..]) => Ok(()),
        (Err(error), []) => Err(format!("no note says why\n{error}")),
        (Ok(_), [note, ..]) if note.message.contains("takes other objects") => Ok(()),
        (Ok(_), [note, ..]) => Err(format!("the stack compiles, although {note}")),
    }
}

/// A compiler command for the stack with the project's port.
fn with_port(compiler: &str, folder: &Path, stack: &Path) -> Command {
    let mut cc = Command::new(compiler);
    cc.current_dir(folder).args(["-std=c99", "-I."]).arg("-I").arg(beside("canopennode", "real"));
    cc.arg("-I").arg(stack);
    cc
}

/// The expected answer to an upload of an entry; `None` if the stack decides it.
fn answer(row: &Row) -> Option<String> {
    let is_unicode = row.kind == Some(TypeKind::UnicodeString); // truncated at the first zero
    // errors found by the stack, such as missing nodes and mappings that it rejects
    let lives = matches!(row.index, 0x1001 | 0x1003);
    let default = row.default.as_ref().filter(|default| !default.is_empty());
    let text = match default {
        // without `CO_CONFIG_EM_PROD_CONFIGURABLE`, whatever CAN-ID the tables have
        Some(default) if row.index == 0x1014 && default.len() == 4 => {
            hex(&[0x80 + NODE_ID, 0, 0, default[3] & 0x80])
        }
        _ if !row.read => "abort 06010001".to_owned(),
        Some(default) if !is_unicode && !lives => hex(default),
        _ => return None,
    };
    Some(format!("{:04X} {:02X} {text}", row.index, row.sub))
}

#[test]
fn the_sdo_server_of_the_real_stack_answers_what_the_description_says() {
    let (Some(stack), Some(compiler)) = (checkout("OBJDICT_CANOPENNODE_DIR"), c_compiler()) else { return };
    let objects = tempfile::tempdir().unwrap();
    succeed(with_port(&compiler, objects.path(), &stack).arg("-c").args(sources(&stack)), "").unwrap();
    let objects: Vec<PathBuf> =
        objects.path().read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    let (started, found) = (AtomicUsize::new(0), AtomicUsize::new(0));
    for_all(&devices(), |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        let fail = |error: String| format!("{name}: {error}");
        let notes = generate_into(folder, device, &Options::default());
        let stops = ["not compile", "does not start", "uses other objects"];
        if startup::is_undefined(&notes)
            || notes.iter().any(|note| stops.iter().any(|text| note.message.contains(text)))
        {
            return Ok(()); // which a note reports
        }
        let mut cc = with_port(&compiler, folder, &stack);
        cc.args(["-Wall", "-Wextra", "-o", "node", "OD.c"]).arg(stack.join("CANopen.c"));
        succeed(cc.arg(beside("canopennode", "real/node.c")).args(&objects), "").map_err(fail)?;
        let mut node = Command::new(folder.join("node"));
        let output = succeed(node.arg(NODE_ID.to_string()), "").map_err(fail)?;
        let lines: Vec<&str> = output.lines().collect();
        if let Some(line) = lines.iter().find(|line| line.starts_with("CO_")) {
            return Err(fail(format!("no note says why `{line}`")));
        }
        found.fetch_add(startup::compare(device, &notes, &output).map_err(fail)?, Ordering::Relaxed);
        let disabled = startup::predicted(device, &notes);
        let is_disabled = |row: &Row| {
            let pdo = PdoKind::of_communication(row.index).filter(|_| row.sub == 1); // its COB-ID has bit 31 set
            pdo.is_some_and(|(kind, number)| disabled.contains(&format!("{kind} {number} disabled")))
        };
        let expected = expected(device).into_iter().filter(|row| !is_disabled(row));
        let expected: Vec<String> = expected.filter_map(|row| answer(&row)).collect();
        let missing: Vec<&String> = expected.iter().filter(|line| !lines.contains(&line.as_str())).collect();
        if let Some(missing) = missing.first() {
            let address = missing.get(..7).unwrap_or_default();
            let answered = lines.iter().find(|line| line.starts_with(address));
            return Err(fail(format!("`{missing}` expected, {answered:?}; {} in all", expected.len())));
        }
        started.fetch_add(1, Ordering::Relaxed);
        Ok(())
    });
    let started = started.into_inner();
    eprintln!("CANopenNode 4: {started} nodes started, {found:?} predictions");
    assert!(started > 3, "only {started} nodes started");
}

/// What the notes predict of entries with other types, on the stack itself.
#[test]
fn the_real_stack_does_not_start_with_other_shapes() {
    let (Some(stack), Some(compiler)) = (checkout("OBJDICT_CANOPENNODE_DIR"), c_compiler()) else { return };
    for_all(&shapes(), |(name, device, stops)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        generate_into(folder, device, &Options::default());
        let mut cc = with_port(&compiler, folder, &stack);
        cc.args(["-o", "node", "OD.c"]).arg(stack.join("CANopen.c")).args(sources(&stack));
        succeed(cc.arg(beside("canopennode", "real/node.c")), "")
            .map_err(|error| format!("{name}: {error}"))?;
        let output = Command::new(folder.join("node")).arg(NODE_ID.to_string()).output();
        let printed =
            String::from_utf8_lossy(&output.map_err(|error| error.to_string())?.stdout).into_owned();
        let line = printed.lines().find(|line| line.starts_with("CO_"));
        if line.is_some() == *stops { Ok(()) } else { Err(format!("{name}: {line:?}")) }
    });
}
