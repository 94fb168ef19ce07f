//! The target `c` with `--table structs`: has no limitations.

use std::path::Path;

use objdict::generate::{CTable, Options};
use objdict::model::{DataType, Device, Value};

use crate::compile::{c_compiler, cc, generate_with};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::oracle::{facts_of, hex};
use crate::processors::build;
use crate::stacks::truth::{Row, compare, truth};
use crate::stacks::{Harness, beside};

/// A limit for a node, as the harness prints it.
fn limit(limit: Option<&Value>, data_type: DataType, node_id: u8) -> String {
    let Some(limit) = limit else { return "-".to_owned() };
    let on_node = limit.integer_for(node_id).and_then(|number| Value::from_integer(number, data_type));
    hex(&on_node.as_ref().unwrap_or(limit).to_bytes(data_type).unwrap())
}

/// The expected rows: neither SDOs nor RPDOs can write PDO mappings.
fn rows(device: &Device, node_id: u8) -> Vec<Row> {
    let mut rows = truth(device, node_id);
    for row in
        rows.iter_mut().filter(|row| row.write && matches!(row.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF))
    {
        (row.read, row.write, row.rpdo) = (true, false, false);
    }
    rows
}

fn with_limits(device: &Device, node_id: u8) -> Vec<String> {
    let rows = rows(device, node_id);
    let facts: Vec<_> = facts_of(device).map(|(_, facts)| facts).collect();
    let lines = rows.iter().zip(&facts).map(|(row, facts)| {
        let [low, high] =
            [&facts.low, &facts.high].map(|value| limit(value.as_ref(), facts.data_type, node_id));
        format!("{row} {low} {high}")
    });
    lines.collect()
}

/// The rows for a node, with or without names.
pub(crate) fn harness(
    compiler: &str,
    folder: &Path,
    device: &Device,
    (node_id, names): (u8, bool),
) -> Harness {
    let mut options = Options::default();
    options.table = CTable::Structs;
    options.entry_names = names;
    let generated = generate_with(folder, device, "c", &options);
    let mut cc = cc(compiler, folder);
    let sources = generated.files.iter().map(|file| &file.path).filter(|path| path.ends_with(".c"));
    cc.args(["-I.", "-o", "harness"]).args(sources).arg(beside("c_structs", "harness.c"));
    Harness { programs: build(&cc), arguments: vec![node_id.to_string()], notes: generated.notes }
}

#[test]
fn the_array_of_structures_has_what_the_description_says() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        for names in [true, false] {
            let fail = |error: String| format!("{name}: {error}");
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let node_id = if names { 5 } else { 127 };
            let harness = harness(&compiler, folder.path(), device, (node_id, names));
            let rows = rows(device, node_id);
            harness.check(&rows, |dump| compare(name, &rows, dump)).map_err(fail)?;
            let expected = with_limits(device, node_id);
            let compare = |dump: &str| {
                let mut lines = expected.iter().zip(dump.lines());
                lines.find(|(expected, line)| expected != line).map_or(Ok(()), |(expected, line)| {
                    Err(format!("`{line}` where `{expected}` was expected"))
                })
            };
            let arguments = [&node_id.to_string(), "limits"];
            harness.programs.check(&arguments, "", &expected, compare).map_err(fail)?;
        }
        Ok(())
    });
}
