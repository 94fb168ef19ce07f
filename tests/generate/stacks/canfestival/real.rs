//! With the stack: `OBJDICT_CANFESTIVAL_DIR` names a checkout. It is linked with the tables, starts, and reads them.

use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::model::Device;

use super::{address, expected, write};
use crate::compile::{c_compiler, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::stacks::truth::compare;
use crate::stacks::{beside, checkout, for_node};

/// The stack, compiled for Linux.
struct Stack {
    compiler: String,
    checkout: PathBuf,
    folder: tempfile::TempDir,
}

impl Stack {
    fn build() -> Option<Self> {
        let (checkout, compiler) = (checkout("OBJDICT_CANFESTIVAL_DIR")?, c_compiler()?);
        let stack = Self { compiler, checkout, folder: tempfile::tempdir().unwrap() };
        let files = std::fs::read_dir(stack.checkout.join("src")).unwrap().map(|file| file.unwrap().path());
        // symbols of a kernel module, and an optional service with a driver of its own
        let files = files.filter(|path| !path.ends_with("symbols.c") && !path.ends_with("lss.c"));
        let files = files.filter(|path| path.extension().is_some_and(|extension| extension == "c"));
        succeed(stack.cc(stack.folder.path()).args(["-w", "-c"]).args(files), "").unwrap();
        let objects = std::fs::read_dir(stack.folder.path()).unwrap().map(|file| file.unwrap().path());
        let objects: Vec<PathBuf> = objects.collect();
        succeed(Command::new("ar").arg("rcs").arg(stack.folder.path().join("stack.a")).args(objects), "")
            .unwrap();
        Some(stack)
    }

    fn cc(&self, folder: &Path) -> Command {
        let mut command = Command::new(&self.compiler);
        command.current_dir(folder).args([
            "-std=gnu99",
            "-fgnu89-inline",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-I.",
        ]);
        for include in ["include", "include/unix", "include/timers_unix"] {
            command.arg("-isystem").arg(self.checkout.join(include));
        }
        command.arg("-isystem").arg(beside("canfestival", "")); // its configuration
        command
    }

    /// The entries of a node that starts with a table for node 5.
    fn print(&self, folder: &Path, device: &Device, node_id: u8) -> Result<String, String> {
        write(folder, device, &for_node(5));
        let mut cc = self.cc(folder);
        cc.args(["-o", "node", "device_od.c"]).arg(beside("canfestival", "node.c"));
        succeed(cc.arg(self.folder.path().join("stack.a")), "")?;
        succeed(Command::new(folder.join("node")).arg(node_id.to_string()), "")
    }
}

/// What the stack sets itself when it starts, or with a new node-ID: the number of errors, and COB-IDs of CiA 301.
fn is_set((index, sub): (u16, u8), node_id: u8) -> bool {
    let is_cob_id = index == 0x1014
        || (sub == 1 || sub == 2) && matches!(index, 0x1200 | 0x1400..=0x15FF | 0x1800..=0x19FF);
    (index, sub) == (0x1003, 0) || node_id != 5 && is_cob_id
}

#[test]
fn the_real_stack_reads_what_the_description_says() {
    let Some(stack) = Stack::build() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        for node_id in [5, 127] {
            let fail = |error: String| format!("{name}, node {node_id}: {error}");
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let printed = stack.print(folder.path(), device, node_id).map_err(fail)?;
            let kept = |at: Option<(u16, u8)>| at.is_some_and(|at| !is_set(at, node_id));
            let mut rows = expected(device, node_id, &printed);
            rows.retain(|row| kept(Some((row.index, row.sub))));
            let lines = printed.lines().filter(|line| kept(address(line)));
            let lines: String = lines.map(|line| format!("{line}\n")).collect();
            compare(name, &rows, &lines).map_err(fail)?;
        }
        Ok(())
    });
}
