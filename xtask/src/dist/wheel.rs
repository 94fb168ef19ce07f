//! The wheel: the module, and the command as a script of it, so that the command starts without Python.
//!
//! As an entry point of the module, the command would start an interpreter first; a second distribution would
//! need a second release.

use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use super::{Built, copy, cross, make_folder, python, run_program};

/// The version that the wheel was tried with.
const MATURIN: &str = "maturin==1.16.*";

/// A wheel for this machine, or for the system that was asked for.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let scripts = built.root.join("crates/objdict-python/canopen_objdict.data/scripts");
    // one of another system would be packed too
    fs::remove_dir_all(&scripts).ok();
    make_folder(&scripts)?;
    copy(&built.program, &scripts.join(built.program.file_name().unwrap_or_default()))?;
    let maturin = program_of_pypi(built, "maturin", &[MATURIN])?;
    let mut build = match &built.options.target {
        Some(target) => cross::maturin(built, &maturin, target)?,
        None => {
            let mut build = Command::new(maturin);
            build.arg("build");
            build
        }
    };
    build.current_dir(&built.root).args(["--out", "target/dist"]);
    build.args(["--profile", built.options.profile.as_deref().unwrap_or("wheel")]);
    if let Some(features) = &built.options.features {
        build.args(["--features", features]);
    }
    run_program(build.args(["--manifest-path", "crates/objdict-python/Cargo.toml"]))
}

/// A program of packages from PyPI, in an environment of its own, which is made once.
pub(super) fn program_of_pypi(built: &Built, name: &str, packages: &[&str]) -> Result<PathBuf, String> {
    let environment = built.dist.join("venv");
    let programs = environment.join(if cfg!(windows) { "Scripts" } else { "bin" });
    let program = programs.join(format!("{name}{EXE_SUFFIX}"));
    if !program.exists() {
        run_program(Command::new(python()).args(["-m", "venv"]).arg(&environment))?;
        let python = programs.join(format!("python{EXE_SUFFIX}"));
        run_program(Command::new(python).args(["-m", "pip", "install", "--quiet"]).args(packages))?;
    }
    Ok(program)
}
