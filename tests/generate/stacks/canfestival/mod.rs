//! The target `canfestival`.

mod objdictgen;
mod real;

use std::collections::HashSet;
use std::path::Path;

use objdict::generate::{Note, Options, Target, generate};
use objdict::model::{DataType, Device, TypeKind, Value};

use crate::compile::{c_compiler, cc, generate_with};
use crate::devices::{arbitrary_devices, device, devices, for_all};
use crate::oracle::{facts_of, hex};
use crate::processors::build;
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{Harness, beside, for_node};
use crate::verdicts::accepts;

/// What the rows lack.
const LACKS: [Lack; 5] = [
    Lack { what: "sub-index FFh", of: |row| row.sub == 0xFF, instead: |_| None },
    Lack {
        what: "PDO mapping",
        of: |row| row.tpdo || row.rpdo,
        instead: |row| Some(Row { tpdo: false, rpdo: false, ..row }),
    },
    Lack {
        what: "types of the device",
        of: |row| row.kind.is_none(),
        instead: |row| Some(Row { data_type: Some(DataType::OCTET_STRING.0), ..row }),
    },
    Lack {
        what: "texts with a zero",
        of: |row| row.kind == Some(TypeKind::VisibleString),
        instead: |row| {
            let default = row.default.iter().flatten().take_while(|byte| **byte != 0).copied().collect();
            Some(Row { default: Some(default), ..row })
        },
    },
    Lack {
        what: "lengths of other bytes",
        of: |row| row.kind != Some(TypeKind::VisibleString),
        instead: |mut row| {
            if let (Some(default), Some(size)) = (&mut row.default, row.size) {
                default.resize(size, 0);
            }
            Some(row)
        },
    },
];

fn write(folder: &Path, device: &Device, options: &Options) -> Vec<Note> {
    generate_with(folder, device, "canfestival", options).notes
}

/// The harness with these flags.
fn with_flags(compiler: &str, folder: &Path, (device, node_id): (&Device, u8), flags: &[&str]) -> Harness {
    let notes = write(folder, device, &for_node(node_id));
    let mut cc = cc(compiler, folder);
    cc.arg("-I.").arg(format!("-I{}", beside("canfestival", "include").display())).args(flags);
    cc.args(["-o", "harness", "device_od.c"]);
    let programs = build(cc.arg(beside("canfestival", "harness.c")));
    Harness { programs, arguments: Vec::new(), notes }
}

pub(crate) fn harness(compiler: &str, folder: &Path, device: &Device, node_id: u8) -> Harness {
    with_flags(compiler, folder, (device, node_id), &[])
}

/// The expected rows; an entry with a range has no type.
fn expected(device: &Device, node_id: u8, dump: &str) -> Vec<Row> {
    with_ranges(without(&LACKS, truth(device, node_id)), dump)
}

fn with_ranges(mut rows: Vec<Row>, dump: &str) -> Vec<Row> {
    let has_range = |line: &&str| line.split(' ').nth(2) == Some("-");
    let ranges: HashSet<(u16, u8)> = dump.lines().filter(has_range).filter_map(address).collect();
    for row in rows.iter_mut().filter(|row| ranges.contains(&(row.index, row.sub))) {
        row.data_type = None;
    }
    rows
}

/// Index and sub-index of a line.
pub(crate) fn address(line: &str) -> Option<(u16, u8)> {
    let mut words = line.split(' ').map(|word| u16::from_str_radix(word, 16));
    Some((words.next()?.ok()?, u8::try_from(words.next()?.ok()?).ok()?))
}

#[test]
fn the_stack_reads_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        for (node_id, flags) in [(5, [].as_slice()), (127, &["-DOD_CALLBACK_IN_ROW"])] {
            let fail = |error: String| format!("{name}, node {node_id}: {error}");
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let rows = without(&LACKS, truth(device, node_id));
            let harness = with_flags(&compiler, folder.path(), (device, node_id), flags);
            let compare = |dump: &str| compare(name, &with_ranges(rows.clone(), dump), dump);
            harness.check(&rows, compare).map_err(fail)?;
        }
        Ok(())
    });
}

/// Writes of the integers at and beyond their limits, with the answers of CiA 301.
fn writes(device: &Device, node_id: u8) -> Vec<(String, u32)> {
    let mut writes = Vec::new();
    for ((index, sub), facts) in facts_of(device) {
        let Some((lowest, highest)) = facts.data_type.integer_range().filter(|_| facts.access.is_writable())
        else {
            continue;
        };
        if sub == 0xFF || facts.kind.is_none() || index == 0x1003 {
            continue;
        }
        let limit = |limit: &Option<Value>| limit.as_ref()?.resolve(facts.data_type, node_id)?.as_integer();
        let (low, high) = (limit(&facts.low), limit(&facts.high));
        let (from, to) = (low.unwrap_or(lowest), high.unwrap_or(highest));
        for (value, answer) in [(from, 0), (to, 0), (from - 1, 0x0609_0032), (to + 1, 0x0609_0031)] {
            let typed =
                Value::from_integer(value, facts.data_type).filter(|_| (lowest..=highest).contains(&value));
            if let Some(bytes) = typed.and_then(|value| value.to_bytes(facts.data_type)) {
                writes.push((format!("{index:X} {sub:X} {}\n", hex(&bytes)), answer));
            }
        }
    }
    writes
}

#[test]
fn limits_are_checked() {
    let Some(compiler) = c_compiler() else { return };
    let devices: Vec<_> = devices().into_iter().filter(|(name, _)| name != "words").collect();
    for_all(&devices, |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let writes = writes(device, 5);
        let input: String = writes.iter().map(|(line, _)| line.as_str()).collect();
        let compare = |answers: &str| {
            for (answer, (line, expected)) in answers.lines().zip(&writes) {
                if answer != format!("{expected:08X}") {
                    return Err(format!("{name}: {answer}, not {expected:08X}, for {line}"));
                }
            }
            match answers.lines().count() == writes.len() {
                true => Ok(()),
                false => Err(format!("{name}: answers are missing")),
            }
        };
        harness(&compiler, folder.path(), device, 5).programs.check(&["write"], &input, &writes, compare)
    });
}

#[test]
fn the_files_of_a_small_device() {
    let device = crate::devices::device(&crate::support::fixtures().join("eds/minimal.eds"));
    for file in generate(&device, Target::CANFESTIVAL, &for_node(5)).unwrap().files {
        let text = String::from_utf8(file.contents).unwrap().replace(env!("CARGO_PKG_VERSION"), "[version]");
        insta::assert_snapshot!(file.path, text);
    }
}

/// The stack counts from the first object of a family: each PDO is where its mapping is.
#[test]
fn pdos_are_where_their_mappings_are() {
    let device = crate::odd::device();
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &device, &for_node(5));
    let source = std::fs::read_to_string(folder.path().join("device_od.c")).unwrap();
    let first = source.lines().find(|line| line.contains("od_firstIndex")).unwrap();
    let is_server_alone = !first.contains("{0u") && first.ends_with("u, 0u, 0u, 0u, 0u, 0u};");
    assert!(is_server_alone, "{first}");
    let folder = tempfile::tempdir().unwrap();
    let fixture = crate::support::fixtures().join("eds/io-401.eds");
    let mut device = crate::devices::device(&fixture);
    device.objects.remove(&0x1A01);
    device.objects.remove(&0x1800);
    device.objects.retain(|index, _| *index >= 0x1400);
    write(folder.path(), &device, &for_node(5));
    let source = std::fs::read_to_string(folder.path().join("device_od.c")).unwrap();
    let start = source.find("const indextable od_objdict").unwrap();
    insta::assert_snapshot!("positions", &source[start..source.find("/* The TPDOs.").unwrap()]);
    let Some(compiler) = c_compiler() else { return };
    let mut cc = cc(&compiler, folder.path());
    cc.arg("-I.").arg(format!("-I{}", beside("canfestival", "include").display()));
    accepts(cc.args(["-c", "device_od.c"])).unwrap();
}

#[test]
fn lists_may_be_full() {
    let mut device = device(&crate::support::fixtures().join("eds/io-401.eds"));
    for (count, fits) in [(2, true), (3, false)] {
        device.objects.get_mut(&0x1016).unwrap().subs.get_mut(0).unwrap().default =
            Some(Value::Unsigned(count));
        let notes = generate(&device, Target::named("canfestival").unwrap(), &for_node(5)).unwrap().notes;
        let refused =
            notes.iter().any(|note| note.to_string().contains("a count and UNSIGNED32 entries without gaps"));
        assert_eq!(refused, !fits, "{count}");
    }
}
