//! The extension of VS Code, with the command as its server.

use std::env::consts::{ARCH, EXE_SUFFIX, OS};
use std::process::Command;

use super::{Built, DISTRIBUTION, copy, run_program};

/// `canopen-objdict-VERSION-SYSTEM.vsix`, for the system of the command in it.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let extension = built.root.join("editors/vscode");
    copy(&built.program, &extension.join("server").join(format!("objdict{EXE_SUFFIX}")))?;
    let package = built.dist.join(format!("{DISTRIBUTION}-{}-{OS}-{ARCH}.vsix", built.version));
    let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let install = ["ci", "--ignore-scripts", "--no-audit", "--no-fund"];
    run_program(Command::new(npm).current_dir(&extension).args(install))?;
    let mut pack = Command::new(npm);
    run_program(pack.current_dir(&extension).args(["run", "package", "--", "--out"]).arg(package))
}
