//! The extension of VS Code, with the command as its server.

use std::env::consts::EXE_SUFFIX;

use super::npm::system;
use super::{Built, DISTRIBUTION, copy, npm, run_program};

/// `canopen-objdict-VERSION-TARGET.vsix`, for the system of the command in it.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let extension = built.root.join("editors/vscode");
    copy(&built.program, &extension.join("server").join(format!("objdict{EXE_SUFFIX}")))?;
    // as the marketplace calls the systems of packages
    let (system, processor) = system();
    let target = format!("{system}-{processor}");
    let package = built.dist.join(format!("{DISTRIBUTION}-{}-{target}.vsix", built.version));
    run_program(npm().current_dir(&extension).args(["ci", "--ignore-scripts", "--no-audit", "--no-fund"]))?;
    let mut pack = npm();
    pack.current_dir(&extension).args(["run", "package", "--", "--target", &target, "--out"]);
    run_program(pack.arg(package))
}
