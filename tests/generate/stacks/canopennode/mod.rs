//! The target `canopennode`: `OD.h` and `OD.c` of CANopenNode 4.

mod existing;
mod output;
mod real;

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::{Note, Options};
use objdict::model::{Device, TypeKind};

use crate::compile::{c_compiler, cc, generate_with, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::oracle::{Answer, Dictionary, Facts, STRING_ROOM, facts_of, hex};
use crate::processors::build;
use crate::script::edges;
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{Harness, beside, checkout};
use crate::support::skips::has;

/// The node-ID of all tests.
pub(crate) const NODE_ID: u8 = 5;

/// Features that the stack does not support.
const LACKS: &[Lack] = &[
    Lack {
        what: "the tables do not tell data types",
        of: |_| true,
        instead: |row| Some(Row { data_type: None, ..row }),
    },
    Lack {
        what: "blocks of bytes have no room to grow, unless the description states their length",
        of: |row| matches!(row.kind, Some(TypeKind::OctetString | TypeKind::Domain)),
        instead: |row| {
            let mut bytes = row.default.clone().unwrap_or_default();
            let stated =
                row.size.filter(|&size| size != STRING_ROOM && row.kind == Some(TypeKind::OctetString));
            bytes.resize(stated.unwrap_or(bytes.len()).max(bytes.len()), 0);
            Some(Row { size: Some(bytes.len()), default: Some(bytes), ..row })
        },
    },
    Lack {
        what: "texts end at a zero",
        of: |row| matches!(row.kind, Some(TypeKind::VisibleString | TypeKind::UnicodeString)),
        instead: |row| Some(Row { default: row.default.clone().map(up_to_zeros), ..row }),
    },
    Lack {
        what: "COB-IDs without a node-ID are those of the pre-defined connection set",
        of: |row| predefined(row).is_some(),
        instead: |row| Some(Row { default: predefined(&row), ..row }),
    },
];

fn up_to_zeros(mut bytes: Vec<u8>) -> Vec<u8> {
    while bytes.last() == Some(&0) {
        bytes.pop();
    }
    bytes
}

/// The value that the stack uses for a COB-ID.
pub(crate) fn predefined(row: &Row) -> Option<Vec<u8>> {
    let bytes: [u8; 4] = row.default.as_deref()?.try_into().ok()?;
    let value = u32::from_le_bytes(bytes);
    let function = match (row.index, row.sub) {
        (0x1200, 1) => return Some((0x600 + u32::from(NODE_ID)).to_le_bytes().to_vec()),
        (0x1200, 2) => return Some((0x580 + u32::from(NODE_ID)).to_le_bytes().to_vec()),
        (0x1014, 0) => 0x80,
        (0x1400..=0x1403, 1) => 0x200 + 0x100 * u32::from(row.index - 0x1400),
        (0x1800..=0x1803, 1) => 0x180 + 0x100 * u32::from(row.index - 0x1800),
        _ => return None,
    };
    (value & 0x7FF == function).then(|| (value + u32::from(NODE_ID)).to_le_bytes().to_vec())
}

/// The entries in the stack: at most 255 per object.
fn expected(device: &Device) -> Vec<Row> {
    let mut rows = truth(device, NODE_ID);
    let mut counts: BTreeMap<u16, usize> = BTreeMap::new();
    rows.iter().for_each(|row| *counts.entry(row.index).or_default() += 1);
    rows.retain(|row| row.sub != 0xFF || counts[&row.index] < 256);
    without(LACKS, rows)
}

fn generate_into(folder: &Path, device: &Device, options: &Options) -> Vec<Note> {
    generate_with(folder, device, "canopennode", options).notes
}

/// A compiler command with the project's declarations and the generated files.
fn with_declarations(compiler: &str, folder: &Path) -> Command {
    let mut command = cc(compiler, folder);
    command.arg("-I").arg(beside("canopennode", "include")).arg("-I.");
    command
}

/// The entries found by the stack.
pub(crate) fn harness(compiler: &str, folder: &Path, device: &Device, options: &Options) -> Harness {
    let notes = generate_into(folder, device, options);
    let mut cc = with_declarations(compiler, folder);
    cc.args(["-o", "harness", "OD.c"]).arg(beside("canopennode", "harness.c"));
    Harness { programs: build(&cc), arguments: vec!["dump".to_owned(), NODE_ID.to_string()], notes }
}

#[test]
fn the_tables_hold_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    let entries = AtomicUsize::new(0);
    let stack = checkout("OBJDICT_CANOPENNODE_DIR");
    let devices = [devices(), arbitrary_devices(8)].concat();
    for_all(&devices, |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        let fail = |error: String| format!("{name}: {error}");
        let harness = harness(&compiler, folder, device, &Options::default());
        let expected = expected(device);
        entries.fetch_add(expected.len(), Ordering::Relaxed);
        harness.check(&expected, |dump| compare(name, &expected, dump)).map_err(fail)?;
        match &stack {
            Some(stack) => real::compiles(&compiler, folder, stack, &harness.notes).map_err(fail),
            None => Ok(()),
        }
    });
    let entries = entries.into_inner();
    assert!(entries > 5_000, "only {entries} entries were compared");
}

fn with_limits() -> Options {
    let mut options = Options::default();
    options.limits = true;
    options
}

/// Whether limits of an entry are enforced: the stack writes communication parameters itself.
fn is_kept(index: u16, facts: &Facts) -> bool {
    index >= 0x2000 && facts.access.is_writable() && (facts.low.is_some() || facts.high.is_some())
}

#[test]
fn limits_are_kept_where_it_is_asked_for() {
    let Some(compiler) = c_compiler() else { return };
    let writes = AtomicUsize::new(0);
    let options = with_limits();
    for_all(&devices(), |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        let fail = |error: String| format!("{name}: {error}");
        generate_into(folder, device, &options);
        let mut cc = with_declarations(&compiler, folder);
        cc.args(["-DWITH_LIMITS", "-o", "harness", "OD.c"]).arg(beside("canopennode", "harness.c"));
        let programs = build(&cc);
        let mut dictionary = Dictionary::new(device, NODE_ID);
        let (mut input, mut expected) = (String::new(), Vec::new());
        for ((index, sub), facts) in facts_of(device).filter(|((index, _), facts)| is_kept(*index, facts)) {
            for bytes in edges(&facts).into_iter().filter(|bytes| !is_no_truth(&facts, bytes)) {
                input.push_str(&format!("{index:04X} {sub:02X} {}\n", hex(&bytes)));
                let answer: Answer = dictionary.write(index, sub, &bytes);
                let answer = answer.err().unwrap_or(0);
                expected.push(format!("{index:04X} {sub:02X} {}: {answer:08X}", hex(&bytes)));
            }
        }
        writes.fetch_add(expected.len(), Ordering::Relaxed);
        let compare = |output: &str| {
            let answers: Vec<String> =
                input.lines().zip(output.lines()).map(|(line, answer)| format!("{line}: {answer}")).collect();
            if answers == expected {
                return Ok(());
            }
            let wrong = answers.iter().zip(&expected).find(|(answer, expected)| answer != expected);
            Err(format!("{wrong:?}"))
        };
        programs.check(&["write", &NODE_ID.to_string()], &input, &expected, compare).map_err(fail)
    });
    let writes = writes.into_inner();
    assert!(writes > 400, "only {writes} writes were compared");
}

/// A BOOLEAN that is neither true nor false, which the stack accepts.
fn is_no_truth(facts: &Facts, bytes: &[u8]) -> bool {
    facts.kind == Some(TypeKind::Boolean) && bytes.iter().any(|&byte| byte > 1)
}

#[test]
fn several_dictionaries_go_into_one_program_and_into_cpp() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let healthy = |ending: &str| {
        let all = devices();
        all.into_iter().find(|(name, _)| name == ending).map(|(_, device)| device).unwrap()
    };
    let mut motor = with_limits();
    motor.prefix = Some("motor".to_owned());
    generate_into(folder, &healthy("drive-402.eds"), &motor);
    generate_into(folder, &crate::odd::device(), &with_limits());
    let mut cc = with_declarations(&compiler, folder);
    cc.args(["-DCO_MULTIPLE_OD", "-o", "several", "OD.c", "motor.c"]);
    build(cc.arg(beside("canopennode", "several.c"))).succeed().unwrap();

    let cpp = std::env::var("CXX").unwrap_or_else(|_| "c++".to_owned());
    if !has(&cpp, "g++") {
        return;
    }
    std::fs::write(folder.join("headers.cpp"), "#include \"OD.h\"\n#include \"motor.h\"\n").unwrap();
    let mut command = Command::new(cpp);
    command.current_dir(folder).args([
        "-std=c++11",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Werror",
        "-fsyntax-only",
    ]);
    command.arg("-I").arg(beside("canopennode", "include")).args(["-I.", "headers.cpp"]);
    succeed(&mut command, "").unwrap();
}
