//! All targets agree: compares the dumps of all targets that compile on this machine.

use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::{Note, Options, Target, generate};
use objdict::model::Device;

use crate::batch::Batch;
use crate::compile::{DRIVER, c_compiler, cc, driver, generate_into, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::stacks::columns::{Aspect, Column, agree};
use crate::stacks::truth::truth;
use crate::stacks::{
    c_structs, canfestival, canopen_stack, canopennode, canopennode_v1, lely, microcanopen, objdict_macros,
};

/// The node-ID of all tests.
const NODE_ID: u8 = 5;

/// The most different devices; each target is tested with all devices separately.
const DEVICES: [&str; 9] = [
    "all-types.eds",
    "constant",
    "drive-402.eds",
    "hostile-unicode.eds",
    "hostile.eds",
    "io-401-node5.dcf",
    "manager-302-node1.dcf",
    "microcanopen.eds",
    "odd",
];

/// Converts a line of the plain drivers to a dump line; formulas in their tables are without the node-ID.
fn dumped(line: &str) -> Option<String> {
    let words: Vec<&str> = line.split(' ').collect();
    let [index, sub, data_type, flags, size, default, ..] = words[..] else { return None };
    let flags: Vec<bool> = flags.bytes().map(|flag| flag == b'1').collect();
    let [read, write, tpdo, rpdo, formula] = flags[..] else { return None };
    let access: String = [(read, 'r'), (write, 'w'), (tpdo, 't'), (rpdo, 'p')]
        .map(|(has, letter)| if has { letter } else { '-' })
        .iter()
        .collect();
    let default = if formula {
        let digits: Vec<&str> =
            (0..default.len()).step_by(2).filter_map(|at| default.get(at..at + 2)).rev().collect();
        let value = u64::from_str_radix(&digits.concat(), 16).ok()? + u64::from(NODE_ID);
        value.to_le_bytes()[..digits.len()].iter().map(|byte| format!("{byte:02X}")).collect()
    } else {
        default.to_owned()
    };
    Some(format!("{index} {sub} {data_type} {size} {access} {default}\n"))
}

/// The input of a plain driver.
fn table() -> String {
    format!("i {NODE_ID:02X}\nt\n")
}

/// Parses its output.
fn plain(target: &'static str, printed: &str, notes: Vec<Note>) -> Result<Column, String> {
    let dump: Option<String> = printed.lines().map(dumped).collect();
    Ok(Column::of_dump(target, &dump.ok_or("the driver prints no table")?, notes))
}

fn columns(compiler: &str, folder: &Path, device: &Device, in_rust: Column) -> Result<Vec<Column>, String> {
    let folder = |name: &str| {
        let folder = folder.join(name);
        std::fs::create_dir(&folder).map_err(|error| error.to_string()).map(|()| folder)
    };
    let mut columns = vec![Column::of_rows("the description", &truth(device, NODE_ID), Vec::new()), in_rust];

    let at = folder("c")?;
    let notes = generate_into(&at, device, "c").notes;
    succeed(cc(compiler, &at).args(["-I.", "-o", "driver", "od.c"]).arg(driver("driver.c")), "")?;
    let column = plain("c", &succeed(&mut Command::new(at.join("driver")), &table())?, notes)?;
    columns.push(Column { excuses: OF_PLAIN, ..column });

    let (dump, notes) = c_structs::dump(compiler, &folder("structs")?, device, (NODE_ID, true))?;
    columns.push(Column { excuses: OF_PLAIN, ..Column::of_dump("c --table structs", &dump, notes) });

    let (dump, notes) = canopennode::dump(compiler, &folder("canopennode")?, device, &Options::default())?;
    let column = Column::of_dump("canopennode", &dump, notes);
    columns.push(Column { untold: &[Aspect::Type], excuses: OF_CANOPENNODE, ..column });

    let options = canopen_stack::options(NODE_ID, false);
    let (dump, notes) = canopen_stack::dump(compiler, &folder("canopen-stack")?, device, &options)?;
    let mut column = Column::of_dump("canopen-stack", &dump, notes);
    for (_, cell) in column.cells.iter_mut().filter(|((index, sub), _)| *index == 0x1003 && *sub > 0) {
        if cell[4] == "-" {
            cell[4] = "00000000".to_owned(); // an error history of zeros contains no errors and cannot be read
        }
    }
    columns.push(Column { untold: &[Aspect::Type], excuses: OF_CANOPEN_STACK, ..column });

    let (dump, notes) = microcanopen::dump(compiler, &folder("microcanopen")?, device, NODE_ID)?;
    let column = Column::of_dump("microcanopen", &dump, notes);
    columns.push(Column { untold: &[Aspect::Type, Aspect::Mapping], excuses: OF_MICROCANOPEN, ..column });

    let (dump, notes) = objdict_macros::dump(compiler, &folder("objdict-macros")?, device, NODE_ID)?;
    let column = Column::of_dump("objdict-macros", &dump, notes);
    columns.push(Column { untold: &[Aspect::Type], excuses: OF_OBJDICT_MACROS, ..column });

    let (dump, notes) = canfestival::dump(compiler, &folder("canfestival")?, device, NODE_ID)?;
    let column = Column::of_dump("canfestival", &dump, notes);
    columns.push(Column { untold: &[Aspect::Type, Aspect::Mapping], excuses: OF_CANFESTIVAL, ..column });

    let (dump, notes) = canopennode_v1::dump(compiler, &folder("canopennode-v1")?, device)?;
    let column = Column::of_dump("canopennode-v1", &dump, notes);
    columns.push(Column { untold: &[Aspect::Type], excuses: OF_CANOPENNODE_V1, ..column });

    let (dump, notes) = lely::dump(compiler, &folder("lely")?, device, NODE_ID)?;
    let column = Column::of_dump("lely", &dump, notes);
    columns.push(Column { untold: &[Aspect::Size], excuses: OF_LELY, ..column });
    Ok(columns)
}

const OF_PLAIN: &[(Aspect, &str)] = &[(Aspect::Access, "SDOs cannot write PDO mappings")];

const OF_CANOPENNODE: &[(Aspect, &str)] = &[
    (Aspect::Entry, "an object of the stack has at most 255 entries"),
    (Aspect::Size, "of the stack has a fixed length"),
    (Aspect::Size, "without a default has no memory in the tables"),
    (Aspect::Default, "truncates a UNICODE_STRING at its first zero byte"),
    (Aspect::Default, "truncates a text at its first zero"),
    (Aspect::Default, "the stack adds the node-ID to"),
    (Aspect::Default, "the stack sets it to"),
    (Aspect::Default, "a NaN comes out as"),
];

const OF_CANOPEN_STACK: &[(Aspect, &str)] = &[
    (Aspect::Entry, "without 1200h the stack has no SDO server; it is added"),
    (Aspect::Mapping, "its row has one flag for both directions"),
    (Aspect::Default, "the error history is empty when the stack starts"),
    (Aspect::Default, "bit 0 of its value is clear, so no SDO"),
    (Aspect::Default, "the stack answers only 1 or 0"),
    (Aspect::Default, "the stack does not add the node-ID here"),
    (Aspect::Default, "the stack drops bits 24 to 31"),
];

const OF_MICROCANOPEN: &[(Aspect, &str)] = &[
    (Aspect::Entry, "the entry is omitted"),
    (Aspect::Entry, "the stack serves the entry itself"),
    (Aspect::Access, "entries outside of the process image cannot be written"),
    (Aspect::Size, "entries outside of the process image cannot be written"),
];

const OF_CANFESTIVAL: &[(Aspect, &str)] = &[
    (Aspect::Entry, "an object of the stack has at most 255 rows"),
    (Aspect::Default, "the stack truncates a text at its first zero byte"),
    (Aspect::Default, "a row has a fixed length"),
];

const OF_CANOPENNODE_V1: &[(Aspect, &str)] = &[
    (Aspect::Entry, "the stack answers with the number of errors"),
    (Aspect::Default, "a row has a fixed length"),
    (Aspect::Default, "the stack adds the node-ID to"),
    (Aspect::Default, "the stack sets it to"),
];

const OF_LELY: &[(Aspect, &str)] = &[
    (Aspect::Entry, "an object of the stack has at most 255 entries"),
    (Aspect::Type, "the stack has no types of the device"),
    (Aspect::Access, "in place of a value"),
    (Aspect::Default, "in place of a value"),
    (Aspect::Default, "truncates a UNICODE_STRING at its first zero"),
];

const OF_OBJDICT_MACROS: &[(Aspect, &str)] = &[
    (Aspect::Mapping, "a row is mapped in one direction only"),
    (Aspect::Default, "a row has a fixed length"),
];

#[test]
fn every_target_has_what_every_other_has() {
    let Some(compiler) = c_compiler() else { return };
    let chosen = devices().into_iter().filter(|(name, _)| DEVICES.contains(&name.as_str()));
    let devices: Vec<(String, Device)> = chosen.chain(arbitrary_devices(4)).collect();
    assert_eq!(devices.len(), DEVICES.len() + 4);
    let cells = AtomicUsize::new(0);
    let in_rust = |device: &Device| generate(device, Target::RUST, &Options::default()).unwrap();
    let mut batch = Batch::new();
    for (name, device) in &devices {
        batch.add(name, &in_rust(device), DRIVER);
    }
    batch.build(&[]);
    for_all(&devices, |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let rust = plain("rust", &batch.run(name, &table())?, in_rust(device).notes)?;
        let rust = Column { excuses: OF_PLAIN, ..rust };
        let columns =
            columns(&compiler, folder.path(), device, rust).map_err(|error| format!("{name}: {error}"))?;
        cells.fetch_add(agree(name, &columns)?, Ordering::Relaxed);
        Ok(())
    });
    let cells = cells.into_inner();
    assert!(cells > 10_000, "only {cells} pairs of cells were compared");
}
