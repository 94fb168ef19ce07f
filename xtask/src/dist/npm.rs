//! The packages for npm: one with a program for each system, and one that starts the program of the system it is on.

use std::env::consts::{ARCH, EXE_SUFFIX, OS};
use std::path::Path;

use serde_json::{Value, json};

use super::{Built, DISTRIBUTION, copy, npm, run_program, write};

/// Starts the program of the package for this system.
const START: &str = include_str!("start.js");

/// The page of each package in the registry.
const README: &str = include_str!("npm.md");

/// The systems that packages are made for, as `process.platform` and `process.arch` of Node name them.
const SYSTEMS: [(&str, &str); 5] =
    [("darwin", "arm64"), ("darwin", "x64"), ("linux", "arm64"), ("linux", "x64"), ("win32", "x64")];

/// `canopen-objdict-VERSION.tgz`, and that of this system.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let (system, processor) = system();
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

/// This system and its processor, as Node and the editors that are built on it name them.
pub(super) fn system() -> (&'static str, &'static str) {
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
    (system, processor)
}

/// What the manifests of all packages say.
fn manifest(built: &Built, name: &str) -> Value {
    let mut manifest = json!({
        "name": name,
        "version": built.version,
        "description": built.fact("description"),
        "author": built.fact("authors")[0],
        "license": built.fact("license"),
        "homepage": built.fact("homepage"),
        "keywords": built.fact("keywords"),
    });
    // npm compares it with the repository that uploads the package
    if let Some(repository) = built.fact("repository").as_str() {
        manifest["repository"] = json!({ "type": "git", "url": format!("git+{repository}.git") });
    }
    manifest
}

fn pack(built: &Built, folder: &Path, manifest: &Value) -> Result<(), String> {
    built.licences(folder)?;
    write(&folder.join("README.md"), README.as_bytes())?;
    write(&folder.join("package.json"), format!("{manifest:#}\n").as_bytes())?;
    let mut npm = npm();
    npm.current_dir(folder).args(["pack", "--silent", "--pack-destination"]).arg(&built.dist);
    run_program(&mut npm)
}
