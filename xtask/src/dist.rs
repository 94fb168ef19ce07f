//! Packages of the command, of the Python module and of the extension of VS Code, into `target/dist`.

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
    let built = build_command(&root, of_command)?;
    let scripts = root.join("crates/objdict-python/canopen_objdict.data/scripts");
    copy_into(&built, &scripts)?;
    let mut build = Command::new(maturin(&root)?);
    build.current_dir(&root).args(["build", "--profile", of_module, "--out", "target/dist"]);
    run(build.args(["--manifest-path", "crates/objdict-python/Cargo.toml"]))
}

/// The extension of VS Code for this machine, which bundles the command as its server.
pub(crate) fn vsix(profile: &str) -> Result<(), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let extension = root.join("editors/vscode");
    copy_into(&build_command(&root, profile)?, &extension.join("server"))?;
    let package = root.join("target/dist/objdict.vsix");
    fs::create_dir_all(root.join("target/dist")).map_err(|error| format!("target/dist: {error}"))?;
    let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
    run(Command::new(npm).current_dir(&extension).args([
        "ci",
        "--ignore-scripts",
        "--no-audit",
        "--no-fund",
    ]))?;
    let mut build = Command::new(npm);
    run(build.current_dir(&extension).args(["run", "package", "--", "--out"]).arg(package))
}

/// Builds the command, and returns its path.
fn build_command(root: &Path, profile: &str) -> Result<PathBuf, String> {
    let mut build = Command::new(env!("CARGO"));
    run(build.current_dir(root).args(["build", "--bin", "objdict", "--profile", profile]))?;
    let folder = if profile == "dev" { "debug" } else { profile };
    Ok(root.join("target").join(folder).join(format!("objdict{EXE_SUFFIX}")))
}

/// Copies the command into a folder, which is made if it is missing.
fn copy_into(built: &Path, folder: &Path) -> Result<(), String> {
    let copied = fs::create_dir_all(folder)
        .and_then(|()| fs::copy(built, folder.join(format!("objdict{EXE_SUFFIX}"))));
    copied.map(|_| ()).map_err(|error| format!("{}: {error}", built.display()))
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
