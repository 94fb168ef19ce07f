//! The target `canopennode-v1`.

use std::path::Path;

use objdict::generate::{Note, Options, Target, generate};
use objdict::model::Device;

use crate::compile::{c_compiler, cc, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::processors::build;
use crate::stacks::canopennode::{NODE_ID, predefined};
use crate::stacks::truth::{Lack, Row, compare, truth, without};
use crate::stacks::{beside, checkout};

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
        of: |row| predefined(row).is_some(),
        instead: |row| Some(Row { default: predefined(&row), ..row }),
    },
    Lack {
        what: "the stack counts errors itself",
        of: |row| (row.index, row.sub) == (0x1003, 0),
        instead: |_| None,
    },
];

fn write(folder: &Path, device: &Device, options: &Options) -> Vec<Note> {
    let generated =
        generate(device, Target::CANOPENNODE_V1, options).unwrap_or_else(|error| panic!("{error}"));
    for file in &generated.files {
        std::fs::write(folder.join(&file.path), &file.contents).unwrap();
    }
    generated.notes
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
        compare(name, &without(LACKS, truth(device, NODE_ID)), &dump).map_err(fail)
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

/// `OBJDICT_CANOPENNODE_V1_DIR` names a checkout of the stack 1.3: all of its sources compile with the tables.
#[test]
fn the_real_stack_compiles_with_the_tables() {
    let (Some(stack), Some(compiler)) = (checkout("OBJDICT_CANOPENNODE_V1_DIR"), c_compiler()) else {
        return;
    };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        write(folder.path(), device, &Options::default());
        let with_stack = |flags: &[&str], file: &Path| {
            let mut command = std::process::Command::new(&compiler);
            command.current_dir(folder.path()).args(["-std=gnu99", "-fsyntax-only", "-I."]).args(flags);
            for include in ["stack/drvTemplate", "stack", ""] {
                command.arg("-isystem").arg(stack.join(include));
            }
            succeed(command.arg(file), "").map(drop).map_err(|error| format!("{name}: {error}"))
        };
        with_stack(&["-Wall", "-Wextra", "-Werror"], Path::new("CO_OD.c"))?;
        with_stack(&[], &stack.join("CANopen.c"))
    });
}
