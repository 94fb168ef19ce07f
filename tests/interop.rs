//! Other tools read what we write: python-canopen 2.4.1 uploads every entry, dcf-tools 2.4.2 accepts what is within its
//! range.
//!
//! The test makes a Python environment below `target` and installs both packages. Without Python or network it says so
//! and passes, except when `CI=true`.

mod support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use objdict::format::{self, Description};
use objdict::model::{DataType, Device, TypeKind};
use objdict::source::SourceOptions;
use serde_json::json;

const PACKAGES: [&str; 2] = ["canopen==2.4.1", "dcf-tools==2.4.2"];

/// The folder with the programs of the environment; `None` when it cannot be made here.
fn environment() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-venv");
    let programs = folder.join(if cfg!(windows) { "Scripts" } else { "bin" });
    if programs.join("dcfchk").exists() {
        return Some(programs);
    }
    let made = run(Command::new("python3").args(["-m", "venv"]).arg(&folder))
        .and_then(|()| run(Command::new(programs.join("pip")).args(["install", "--quiet"]).args(PACKAGES)));
    match made {
        Ok(()) => Some(programs),
        Err(reason) if std::env::var("CI").is_ok_and(|ci| ci == "true") => {
            panic!("no Python environment: {reason}")
        }
        Err(reason) => {
            println!("skipped: no Python environment: {reason}");
            None
        }
    }
}

fn run(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|error| error.to_string())?;
    if output.status.success() { Ok(()) } else { Err(text_of(&output)) }
}

fn text_of(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}
