//! Packages of the command and of the Python module, into `target/dist`.

use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The version that the wheel was tried with.
const MATURIN: &str = "maturin==1.16.*";

/// A wheel for this machine: the module, and the command as a script of it, so that the command starts without Python.
/// Programs of the profile `dev` are made sooner, for tests.
pub(crate) fn wheel(profile: Option<&str>) -> Result<(), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (of_command, of_module) = match profile {
        None => ("release", "wheel"),
        Some(profile) => (profile, profile),
    };
    run(Command::new(env!("CARGO")).current_dir(&root).args([
        "build",
        "--bin",
        "objdict",
        "--profile",
        of_command,
    ]))?;
    let folder = if of_command == "dev" { "debug" } else { of_command };
    let command = format!("objdict{EXE_SUFFIX}");
    let scripts = root.join("crates/objdict-python/canopen_objdict.data/scripts");
    let built = root.join("target").join(folder).join(&command);
    let copied = fs::create_dir_all(&scripts).and_then(|()| fs::copy(&built, scripts.join(&command)));
    copied.map_err(|error| format!("{}: {error}", built.display()))?;
    let mut build = Command::new(maturin(&root)?);
    build.current_dir(&root).args(["build", "--profile", of_module, "--out", "target/dist"]);
    run(build.args(["--manifest-path", "crates/objdict-python/Cargo.toml"]))
}

/// The program maturin, in an environment of its own, which is made once.
fn maturin(root: &Path) -> Result<PathBuf, String> {
    let environment = root.join("target/dist/venv");
    let programs = environment.join(if cfg!(windows) { "Scripts" } else { "bin" });
    let maturin = programs.join(format!("maturin{EXE_SUFFIX}"));
    if !maturin.exists() {
        run(Command::new("python3").args(["-m", "venv"]).arg(&environment))?;
        let python = programs.join(format!("python{EXE_SUFFIX}"));
        run(Command::new(python).args(["-m", "pip", "install", "--quiet", MATURIN]))?;
    }
    Ok(maturin)
}

fn run(command: &mut Command) -> Result<(), String> {
    let program = command.get_program().to_owned();
    let status = command.status().map_err(|error| format!("{}: {error}", program.display()))?;
    if status.success() { Ok(()) } else { Err(format!("{} failed: {status}", program.display())) }
}
