//! What is built on Linux for other systems: by mingw for Windows, else by zig, which PyPI has as a package. Debian's compiler has
//! the sources of the standard library.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::{Built, wheel};

/// The versions that were tried.
const ZIG: [&str; 2] = ["cargo-zigbuild==0.24.*", "ziglang==0.17.*"];
const STANDARD_LIBRARY: &str = "-Zbuild-std=std,panic_abort";

/// The command for another system. On Linux it is linked statically, for any system with this processor.
pub(super) fn program(built: &Built, target: &str) -> Result<PathBuf, String> {
    let of_any_linux = target.replace("-linux-gnu", "-linux-musl");
    let target = if of_any_linux == target { target } else { &of_any_linux };
    let mut cargo = match is_windows(target) {
        true => {
            let mut cargo = mingw(&built.root)?;
            cargo.args(["cargo", "build"]);
            cargo
        }
        false => {
            let mut cargo = zig(built, "cargo-zigbuild")?;
            if target.contains("-linux-") {
                // the files that a program starts with are those of zig
                cargo.env("RUSTFLAGS", "-Clink-self-contained=no");
            }
            cargo.args(["zigbuild", STANDARD_LIBRARY, "--target", target]);
            cargo
        }
    };
    super::run_program(built.with_options(&mut cargo))?;
    let name = if is_windows(target) { "objdict.exe" } else { "objdict" };
    Ok(built.root.join("target").join(target).join(built.folder()).join(name))
}

/// A command of maturin for another system, before its arguments.
pub(super) fn maturin(built: &Built, maturin: &Path, target: &str) -> Result<Command, String> {
    let mut command;
    if is_windows(target) {
        command = mingw(&built.root)?;
        command.arg("with").arg(maturin).arg("build");
    } else {
        command = zig(built, "maturin")?;
        command.args(["build", "--zig"]);
    }
    // a panic is an exception of Python, so the standard library unwinds
    command.args(["-Zbuild-std=std", "--target", target]);
    Ok(command)
}

fn is_windows(target: &str) -> bool {
    target.contains("-windows-")
}

/// A program that links with zig, which is beside it.
fn zig(built: &Built, name: &str) -> Result<Command, String> {
    let beside = wheel::program_of_pypi(built, "cargo-zigbuild", &ZIG)?;
    let folder = beside.parent().unwrap_or(Path::new(""));
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(std::iter::once(folder.to_owned()).chain(std::env::split_paths(&path)));
    let mut command = Command::new(folder.join(name));
    command.env("PATH", path.map_err(|error| error.to_string())?);
    command.envs([("RUSTC", "/usr/bin/rustc"), ("RUSTC_BOOTSTRAP", "1")]);
    Ok(command)
}

/// The script that has mingw for the linker.
fn mingw(root: &Path) -> Result<Command, String> {
    let script = root.join(".ci/windows");
    let missing = Command::new(&script).arg("missing").output();
    let missing = missing.map_err(|error| format!("{}: {error}", script.display()))?;
    // running it is for tests alone
    match String::from_utf8_lossy(&missing.stdout).trim() {
        "" | "wine" => Ok(Command::new(script)),
        program => Err(format!("for Windows this machine lacks {program}")),
    }
}
