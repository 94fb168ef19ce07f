//! The wheel: the module, and the command as a script of it, so that the command starts without Python.

use std::env::consts::EXE_SUFFIX;
use std::path::PathBuf;
use std::process::Command;

use super::{Built, copy, python, run_program};

/// The version that the wheel was tried with.
const MATURIN: &str = "maturin==1.16.*";

/// A wheel for this machine.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let scripts = built.root.join("crates/objdict-python/canopen_objdict.data/scripts");
    copy(&built.program, &scripts.join(format!("objdict{EXE_SUFFIX}")))?;
    let mut build = Command::new(maturin(built)?);
    build.current_dir(&built.root).args(["build", "--out", "target/dist"]);
    build.args(["--profile", built.profile.as_deref().unwrap_or("wheel")]);
    run_program(build.args(["--manifest-path", "crates/objdict-python/Cargo.toml"]))
}

/// The program maturin, in an environment of its own, which is made once.
fn maturin(built: &Built) -> Result<PathBuf, String> {
    let environment = built.dist.join("venv");
    let programs = environment.join(if cfg!(windows) { "Scripts" } else { "bin" });
    let maturin = programs.join(format!("maturin{EXE_SUFFIX}"));
    if !maturin.exists() {
        run_program(Command::new(python()).args(["-m", "venv"]).arg(&environment))?;
        let python = programs.join(format!("python{EXE_SUFFIX}"));
        run_program(Command::new(python).args(["-m", "pip", "install", "--quiet", MATURIN]))?;
    }
    Ok(maturin)
}
