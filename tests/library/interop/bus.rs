//! `objdict bus` and a node of python-canopen, with a serial adapter (SLCAN) on a pseudo-terminal between them.

use std::path::Path;
use std::process::Command;

use super::{environment, text_of};

#[test]
fn a_node_of_python_canopen_is_read_and_configured() {
    let Some(programs) = environment() else { return };
    let (root, folder) = (Path::new(env!("CARGO_MANIFEST_DIR")), tempfile::tempdir().unwrap());
    let mut python = Command::new(programs.join("python"));
    python.arg(root.join("tests/library/interop/bus.py")).arg(env!("CARGO_BIN_EXE_objdict"));
    let output = python.arg(root.join("fixtures/eds/drive-402.eds")).arg(folder.path()).output().unwrap();
    assert!(output.status.success(), "{}", text_of(&output));
    assert_eq!(String::from_utf8_lossy(&output.stdout), "ok\n");
}
