//! With the stack: `OBJDICT_CANFESTIVAL_DIR` names a checkout. It is linked with the tables, starts, and reads them.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::model::Device;

use super::{address, expected, write};
use crate::compile::{c_compiler, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::stacks::truth::compare;
use crate::stacks::{beside, checkout, for_node, startup};

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

    /// What a program of the tests prints that starts with a table for node 5.
    fn print(
        &self,
        folder: &Path,
        device: &Device,
        (program, node_id): (&str, u8),
    ) -> Result<String, String> {
        write(folder, device, &for_node(5));
        let mut cc = self.cc(folder);
        cc.args(["-o", "node", "device_od.c"]).arg(beside("canfestival", program));
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
            let printed = stack.print(folder.path(), device, ("node.c", node_id)).map_err(fail)?;
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

/// PDOs that the stack serves and others, by CAN-ID, transmission type and mapping.
fn served_or_not() -> Device {
    let bytes = [0x2001_0008; 9];
    startup::device(&[
        (0x1400, 255, 0x0200, &[0x2000_0010]),
        (0x1401, 1, 0x0600, &[0x2000_0010]),
        (0x1402, 255, 0x0200, &[0x2001_0008]),
        (0x1403, 255, 0x0400, &[0x2000_0008]),
        (0x1404, 255, 0x0500, &[0x2001_0008, 0x2003_0008]),
        (0x1405, 255, 0x0300, &bytes),
        (0x1406, 255, 0x0401, &[0x0005_0008]),
        (0x1800, 255, 0x4000_0180, &[0x2000_0010]),
        (0x1801, 250, 0x4000_0280, &[0x2000_0010]),
        (0x1802, 253, 0x4000_0380, &[0x2000_0010]),
        (0x1803, 253, 0x0000_0480, &[0x2000_0010]),
        (0x1804, 240, 0x4000_0181, &[0x2001_0010]),
        (0x1805, 0, 0x4000_0281, &[0x2000_0008]),
        (0x1806, 1, 0x4000_0381, &[0x2003_0008]),
        (0x1807, 255, 0x4000_0182, &[]),
        (0x1808, 255, 0x4000_0183, &[0x2001_0004, 0x2001_0001]),
    ])
}

#[test]
fn notes_predict_which_pdos_are_not_served() {
    let device = served_or_not();
    let folder = tempfile::tempdir().unwrap();
    let predicted = startup::predicted(&device, &write(folder.path(), &device, &for_node(5)));
    let expected = [
        "RPDO 2 without effect",
        "RPDO 3 without effect",
        "RPDO 4 rejected",
        "RPDO 5 rejected",
        "RPDO 7 rejected",
        "TPDO 2 silent",
        "TPDO 3 silent",
        "TPDO 6 silent",
        "TPDO 7 silent",
    ];
    assert_eq!(predicted.into_iter().collect::<Vec<_>>(), expected);
}

/// What PDOs and heartbeat consumers do is what the notes predict.
#[test]
fn the_stack_serves_the_pdos_as_the_notes_predict() {
    let Some(stack) = Stack::build() else { return };
    let [started, found] = [const { AtomicUsize::new(0) }; 2];
    let devices = [devices(), vec![("served or not".to_owned(), served_or_not())]].concat();
    for_all(&devices, |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let notes = write(folder.path(), device, &for_node(5));
        if startup::is_undefined(&notes) {
            return Ok(());
        }
        let printed = stack.print(folder.path(), device, ("pdos.c", 5)).map_err(fail)?;
        found.fetch_add(startup::compare(device, &notes, &printed).map_err(fail)?, Ordering::Relaxed);
        started.fetch_add(1, Ordering::Relaxed);
        Ok(())
    });
    eprintln!("CanFestival: {started:?} nodes started, {found:?} predictions");
}
