//! All targets agree: compares the dumps of all targets that compile on this machine.

use objdict::generate::{Generated, Note, Options, Target, generate};
use objdict::model::Device;
use tempfile::TempDir;

use crate::batch::{Batch, Part};
use crate::compile::{DRIVER, c_compiler, cc, driver, generate_into, rustc};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::processors::{Programs, host};
use crate::stacks::columns::{Aspect, Column, agree};
use crate::stacks::truth::truth;
use crate::stacks::{
    Harness, c_structs, canfestival, canopen_stack, canopennode, canopennode_v1, lely, microcanopen,
    objdict_macros,
};
use crate::verdicts::Key;

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

/// A device with the programs of all targets in C, compiled when they run.
struct Case<'a> {
    name: &'a str,
    device: &'a Device,
    /// Must be there until then.
    folder: TempDir,
    c: (Programs, Vec<Note>),
    /// In the order of [`columns`].
    harnesses: [Harness; 8],
}

impl<'a> Case<'a> {
    fn new(compiler: &str, name: &'a str, device: &'a Device) -> Self {
        let all = tempfile::tempdir().unwrap();
        let folder = |name: &str| {
            let folder = all.path().join(name);
            std::fs::create_dir(&folder).unwrap();
            folder
        };
        let at = folder("c");
        let notes = generate_into(&at, device, "c").notes;
        let c = host(cc(compiler, &at).args(["-I.", "-o", "driver", "od.c"]).arg(driver("driver.c")));
        let options = canopen_stack::options(NODE_ID, false);
        let harnesses = [
            c_structs::harness(compiler, &folder("structs"), device, (NODE_ID, true)),
            canopennode::harness(compiler, &folder("canopennode"), device, &Options::default()),
            canopen_stack::harness(compiler, &folder("canopen-stack"), device, &options),
            microcanopen::harness(compiler, &folder("microcanopen"), device, NODE_ID),
            objdict_macros::harness(compiler, &folder("objdict-macros"), device, NODE_ID),
            canfestival::harness(compiler, &folder("canfestival"), device, NODE_ID),
            canopennode_v1::harness(compiler, &folder("canopennode-v1"), device),
            lely::harness(compiler, &folder("lely"), device, NODE_ID),
        ];
        Self { name, device, folder: all, c: (c, notes), harnesses }
    }

    /// What decides about the comparison.
    fn key(&self, in_rust: &Generated) -> Key {
        let mut key = Key::new();
        key.add(include_str!("columns.rs"));
        key.tool(&rustc(self.folder.path()));
        key.debug(&(in_rust, DRIVER, truth(self.device, NODE_ID)));
        key.key(self.c.0.key());
        key.debug(&self.c.1);
        for harness in &self.harnesses {
            key.key(harness.programs.key());
            key.debug(&(&harness.arguments, &harness.notes));
        }
        key
    }
}

fn columns(case: &Case<'_>, in_rust: Column) -> Result<Vec<Column>, String> {
    let truth = truth(case.device, NODE_ID);
    let mut columns = vec![Column::of_rows("the description", &truth, Vec::new()), in_rust];
    let (c, notes) = &case.c;
    let column = plain("c", &c.run(&[], &table())?, notes.clone())?;
    columns.push(Column { excuses: OF_PLAIN, ..column });

    let targets = [
        "c --table structs",
        "canopennode",
        "canopen-stack",
        "microcanopen",
        "objdict-macros",
        "canfestival",
        "canopennode-v1",
        "lely",
    ];
    let mut dumps = targets.into_iter().zip(&case.harnesses).map(|(target, harness)| {
        let dump = harness.dump()?;
        let dump = if target == "canopennode-v1" { canopennode_v1::without_count(&dump) } else { dump };
        Ok::<_, String>(Column::of_dump(target, &dump, harness.notes.clone()))
    });
    let mut next = || dumps.next().unwrap();
    columns.push(Column { excuses: OF_PLAIN, ..next()? });
    columns.push(Column { untold: &[Aspect::Type], excuses: OF_CANOPENNODE, ..next()? });

    let mut column = next()?;
    for (_, cell) in column.cells.iter_mut().filter(|((index, sub), _)| *index == 0x1003 && *sub > 0) {
        if cell[4] == "-" {
            cell[4] = "00000000".to_owned(); // an error history of zeros contains no errors and cannot be read
        }
    }
    columns.push(Column { untold: &[Aspect::Type], excuses: OF_CANOPEN_STACK, ..column });

    columns.push(Column { untold: &[Aspect::Type, Aspect::Mapping], excuses: OF_MICROCANOPEN, ..next()? });
    columns.push(Column { untold: &[Aspect::Type], excuses: OF_OBJDICT_MACROS, ..next()? });
    columns.push(Column { untold: &[Aspect::Type, Aspect::Mapping], excuses: OF_CANFESTIVAL, ..next()? });
    columns.push(Column { untold: &[Aspect::Type], excuses: OF_CANOPENNODE_V1, ..next()? });
    columns.push(Column { untold: &[Aspect::Size], excuses: OF_LELY, ..next()? });
    Ok(columns)
}

const OF_PLAIN: &[(Aspect, &str)] = &[(Aspect::Access, "SDOs cannot write PDO mappings")];

const OF_CANOPENNODE: &[(Aspect, &str)] = &[
    (Aspect::Entry, "an object of the stack has at most 255 entries"),
    (Aspect::Size, "of the stack has a fixed length"),
    (Aspect::Size, "without a default has no memory in the tables"),
    (Aspect::Default, "truncates a UNICODE_STRING at its first zero byte"),
    (Aspect::Default, "truncates a string at its first zero"),
    (Aspect::Default, "the stack adds the node-ID to"),
    (Aspect::Default, "the stack sets it to"),
    (Aspect::Default, "a NaN becomes"),
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
    (Aspect::Default, "the stack truncates a string at its first zero byte"),
    (Aspect::Default, "a row has a fixed length"),
];

const OF_CANOPENNODE_V1: &[(Aspect, &str)] = &[
    (Aspect::Entry, "the stack responds with the number of errors"),
    (Aspect::Default, "a row has a fixed length"),
    (Aspect::Default, "the stack adds the node-ID to"),
    (Aspect::Default, "the stack sets it to"),
];

const OF_LELY: &[(Aspect, &str)] = &[
    (Aspect::Entry, "an object of the stack has at most 255 entries"),
    (Aspect::Type, "the stack does not support device-specific types"),
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
    let entries: usize = devices.iter().map(|(_, device)| truth(device, NODE_ID).len()).sum();
    assert!(entries > 1_000, "only {entries} entries are compared");
    let in_rust = |device: &Device| generate(device, Target::RUST, &Options::default()).unwrap();
    let mut batch = Batch::new(&[]);
    let cases: Vec<Case<'_>> =
        devices.iter().map(|(name, device)| Case::new(&compiler, name, device)).collect();
    for case in &cases {
        let generated = in_rust(case.device);
        batch.add_parts(&generated, vec![Part::with(case.name, DRIVER, case.key(&generated))]);
    }
    batch.build();
    for_all(&cases, |case| {
        let name = case.name;
        batch.check(name, &table(), |printed| {
            let rust = plain("rust", printed, in_rust(case.device).notes)?;
            let rust = Column { excuses: OF_PLAIN, ..rust };
            let columns = columns(case, rust).map_err(|error| format!("{name}: {error}"))?;
            agree(name, &columns).map(drop)
        })
    });
}
