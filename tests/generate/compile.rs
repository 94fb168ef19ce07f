//! The compilers.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use objdict::generate::{Generated, Options, Target, generate};
use objdict::model::Device;

use crate::support::skips::has;

/// Generated C must compile without warnings with these flags.
const C_FLAGS: [&str; 6] = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];

/// The path of a driver.
pub(crate) fn driver(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/generate/drivers").join(name)
}

/// The driver of Rust tables.
pub(crate) const DRIVER: &str = include_str!("drivers/driver.rs");

/// The C compiler; without it the test, or its half in C, is skipped, or fails with `CI=true`.
#[track_caller]
pub(crate) fn c_compiler() -> Option<String> {
    let name = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
    has(&name, "gcc").then_some(name)
}

/// Generates into a folder.
pub(crate) fn generate_into(folder: &Path, device: &Device, target: &str) -> Generated {
    generate_with(folder, device, target, &Options::default())
}

/// Generates into a folder with options.
pub(crate) fn generate_with(folder: &Path, device: &Device, target: &str, options: &Options) -> Generated {
    let target = Target::named(target).unwrap();
    let generated = generate(device, target, options).unwrap_or_else(|error| panic!("{error}"));
    for file in &generated.files {
        std::fs::write(folder.join(&file.path), &file.contents).unwrap();
    }
    generated
}

/// A command of the Rust compiler in a folder.
pub(crate) fn rustc(folder: &Path) -> Command {
    let mut command = Command::new(std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned()));
    command.args(["--edition=2021", "-Dwarnings", "-Copt-level=0", "-Cdebuginfo=0"]);
    command.current_dir(folder);
    command
}

/// A command of the C compiler with all warnings as errors, in a folder.
pub(crate) fn cc(compiler: &str, folder: &Path) -> Command {
    let mut command = Command::new(compiler);
    command.args(C_FLAGS).current_dir(folder);
    command
}

/// Runs a command that must succeed; returns its output.
pub(crate) fn succeed(command: &mut Command, input: &str) -> Result<String, String> {
    let command = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|error| format!("{command:?}: {error}"))?;
    let mut stdin = child.stdin.take().unwrap();
    let output = std::thread::scope(|scope| {
        scope.spawn(move || stdin.write_all(input.as_bytes()));
        child.wait_with_output()
    });
    let output = output.map_err(|error| error.to_string())?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(format!("{command:?}: {}\n{}", output.status, errors.chars().take(4000).collect::<String>()))
}
