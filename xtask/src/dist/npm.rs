//! The packages for npm: one with a program for each system, and one that starts the program of the system it is on.

use std::env::consts::{ARCH, EXE_SUFFIX, OS};
use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};

use super::{Built, DISTRIBUTION, copy, run_program, write};

/// Starts the program of the package for this system.
const START: &str = include_str!("start.js");

/// The systems that packages are made for, as `process.platform` and `process.arch` of Node name them.
const SYSTEMS: [(&str, &str); 5] =
    [("darwin", "arm64"), ("darwin", "x64"), ("linux", "arm64"), ("linux", "x64"), ("win32", "x64")];

/// `canopen-objdict-VERSION.tgz`, and that of this system.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let system = match OS {
        "macos" => "darwin",
        "windows" => "win32",
        other => other,
    };
    let processor = match ARCH {
        "x86_64" => "x64",
        "aarch64" => "arm64",
        other => other,
    };
    let name = format!("{DISTRIBUTION}-{system}-{processor}");
    let folder = built.stage(&name)?;
    copy(&built.program, &folder.join(format!("objdict{EXE_SUFFIX}")))?;
    let mut manifest = manifest(built, &name);
    manifest["os"] = json!([system]);
    manifest["cpu"] = json!([processor]);
    pack(built, &folder, &manifest)?;

    let folder = built.stage(DISTRIBUTION)?;
    write(&folder.join("objdict.js"), START.as_bytes())?;
    let mut manifest = self::manifest(built, DISTRIBUTION);
    manifest["bin"] = json!({ "objdict": "objdict.js" });
    manifest["engines"] = json!({ "node": ">=18" });
    // npm leaves out those whose `os` and `cpu` are others
    let programs = SYSTEMS.iter().map(|(system, processor)| {
        (format!("{DISTRIBUTION}-{system}-{processor}"), Value::from(built.version.as_str()))
    });
    manifest["optionalDependencies"] = programs.collect::<serde_json::Map<_, _>>().into();
    pack(built, &folder, &manifest)
}

/// What the manifests of all packages say.
fn manifest(built: &Built, name: &str) -> Value {
    json!({
        "name": name,
        "version": built.version,
        "description": "CANopen object-dictionary toolchain: the command objdict",
        "license": "MIT OR Apache-2.0",
    })
}

fn pack(built: &Built, folder: &Path, manifest: &Value) -> Result<(), String> {
    built.licences(folder)?;
    write(&folder.join("package.json"), format!("{manifest:#}\n").as_bytes())?;
    let mut npm = Command::new("npm");
    npm.current_dir(folder).args(["pack", "--silent", "--pack-destination"]).arg(&built.dist);
    run_program(&mut npm)
}
