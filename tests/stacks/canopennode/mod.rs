//! The target `canopennode`: `OD.h` and `OD.c` of CANopenNode 4.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::{Options, Target, generate};
use objdict::model::{Device, TypeKind};

use crate::compile::{c_compiler, cc, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::truth::{Lack, Row, compare, truth, without};
use crate::{beside, checkout};

/// The node that everything runs on.
const NODE_ID: u8 = 5;

/// What the stack does not have.
const LACKS: &[Lack] = &[
    Lack {
        what: "the tables do not tell data types",
        of: |_| true,
        instead: |row| Some(Row { data_type: None, ..row }),
    },
    Lack {
        what: "blocks of bytes have no room to grow",
        of: |row| matches!(row.kind, Some(TypeKind::OctetString | TypeKind::Domain)),
        instead: |row| Some(Row { size: row.default.as_ref().map(Vec::len), ..row }),
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

/// What the stack puts in the place of a COB-ID.
fn predefined(row: &Row) -> Option<Vec<u8>> {
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

/// The entries as the stack has them: objects have 255 at most.
fn expected(device: &Device) -> Vec<Row> {
    let mut rows = truth(device, NODE_ID);
    let mut counts: BTreeMap<u16, usize> = BTreeMap::new();
    rows.iter().for_each(|row| *counts.entry(row.index).or_default() += 1);
    rows.retain(|row| row.sub != 0xFF || counts[&row.index] < 256);
    without(LACKS, rows)
}

fn generate_into(folder: &Path, device: &Device, options: &Options) {
    let target = Target::named("canopennode").unwrap();
    let generated = generate(device, target, options).unwrap_or_else(|error| panic!("{error}"));
    for file in &generated.files {
        std::fs::write(folder.join(&file.path), &file.contents).unwrap();
    }
}

/// A compiler's command that finds our declarations and the generated files.
fn with_declarations(compiler: &str, folder: &Path) -> Command {
    let mut command = cc(compiler, folder);
    command.arg("-I").arg(beside("canopennode", "include")).arg("-I.");
    command
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
        generate_into(folder, device, &Options::default());
        let mut cc = with_declarations(&compiler, folder);
        cc.args(["-o", "harness", "OD.c"]).arg(beside("canopennode", "harness.c"));
        succeed(&mut cc, "").map_err(fail)?;
        let mut harness = Command::new(folder.join("harness"));
        let output = succeed(harness.args(["dump", &NODE_ID.to_string()]), "").map_err(fail)?;
        let expected = expected(device);
        entries.fetch_add(expected.len(), Ordering::Relaxed);
        compare(name, &expected, &output)?;
        if let Some(stack) = &stack {
            let mut cc = Command::new(&compiler);
            cc.current_dir(folder).args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I"]);
            cc.arg(stack).arg("-I").arg(stack.join("example")).args(["-I.", "OD.c"]);
            succeed(&mut cc, "").map_err(fail)?;
        }
        Ok(())
    });
    let entries = entries.into_inner();
    assert!(entries > 5_000, "only {entries} entries were compared");
}
