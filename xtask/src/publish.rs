//! The crates as crates.io gets them: what their manifests must say, the order, and whether each compiles from its package.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use objdict_model::diagnostic::PUBLISHED;
use serde_json::Value;

use crate::dist::{root, run_program, write};

/// Packages all crates that are published, and compiles the root crate from the packages alone; with `upload` publishes them.
pub(crate) fn run(upload: bool) -> Result<(), String> {
    if upload && !PUBLISHED {
        return Err("`PUBLISHED` in crates/objdict-model/src/diagnostic/rule.rs is false: set it in the commit of the release".to_owned());
    }
    let root = root();
    let crates = published(&root)?;
    let mut problems: Vec<String> = crates.iter().flat_map(problems).collect();
    // `cargo binstall`, npm and PyPI compare it with the place that uploads
    if upload && crates.iter().any(|package| name(package) == "objdict" && package["repository"].is_null()) {
        problems.push("objdict: no `repository`: set it in the commit of the release".to_owned());
    }
    if !problems.is_empty() {
        return Err(problems.join("\n"));
    }
    let order = in_order(&crates)?;
    println!("in this order: {}", order.join(", "));
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(&root).arg(if upload { "publish" } else { "package" });
    if !upload {
        cargo.args(["--no-verify", "--offline", "--allow-dirty", "--quiet"]);
    }
    run_program(cargo.args(order.iter().flat_map(|name| ["--package", name])))?;
    if upload { Ok(()) } else { compile(&root, &crates) }
}

/// The members of the workspace that may be published, as `cargo metadata` describes them.
fn published(root: &Path) -> Result<Vec<Value>, String> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root).args(["metadata", "--no-deps", "--offline", "--format-version", "1"]);
    let output = cargo.output().map_err(|error| format!("cargo: {error}"))?;
    let metadata: Value =
        serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo: {error}"))?;
    let packages = metadata["packages"].as_array().cloned().unwrap_or_default();
    // `publish = false` is an empty list of registries
    Ok(packages.into_iter().filter(|package| package["publish"].is_null()).collect())
}

fn name(package: &Value) -> &str {
    package["name"].as_str().unwrap_or_default()
}

/// The dependencies of a package on others of the workspace, those of tests left out.
fn own(package: &Value) -> impl Iterator<Item = &Value> {
    let dependencies = package["dependencies"].as_array().into_iter().flatten();
    dependencies.filter(|dependency| dependency["kind"] != "dev" && !dependency["path"].is_null())
}

/// What crates.io would refuse, or a reader of its page miss.
fn problems(package: &Value) -> Vec<String> {
    let is_text = |value: &Value| value.as_str().is_some_and(|text| !text.is_empty());
    let facts = ["description", "license", "documentation", "homepage", "readme", "rust_version", "authors"];
    let missing = facts.into_iter().filter(|key| !is_text(&package[key]) && !is_text(&package[key][0]));
    let mut problems: Vec<String> = missing.map(|key| format!("{}: no `{key}`", name(package))).collect();
    for dependency in own(package).filter(|dependency| dependency["req"] == "*") {
        problems.push(format!("{}: `{}` has a path and no version", name(package), name(dependency)));
    }
    problems
}

/// The names so that each comes after all that it depends on.
fn in_order(crates: &[Value]) -> Result<Vec<&str>, String> {
    let mut waiting: BTreeMap<&str, Vec<&str>> =
        crates.iter().map(|package| (name(package), own(package).map(name).collect())).collect();
    let mut order: Vec<&str> = Vec::new();
    while !waiting.is_empty() {
        let ready = waiting.iter().find(|(_, needs)| needs.iter().all(|need| order.contains(need)));
        let Some((&name, _)) = ready else {
            let left: Vec<&str> = waiting.keys().copied().collect();
            return Err(format!(
                "these depend on each other, or on a crate that is not published: {}",
                left.join(", ")
            ));
        };
        waiting.remove(name);
        order.push(name);
    }
    Ok(order)
}

/// Compiles the packages as a user does, who has none of the other files: templates and tables must be in them.
fn compile(root: &Path, crates: &[Value]) -> Result<(), String> {
    let folder = root.join("target/package/unpacked");
    fs::remove_dir_all(&folder).ok();
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut patch = String::new();
    for package in crates {
        let name = name(package);
        let archive = format!("{name}-{}.crate", package["version"].as_str().unwrap_or_default());
        let archive: PathBuf = root.join("target/package").join(archive);
        run_program(Command::new("tar").arg("-xzf").arg(&archive).arg("-C").arg(&folder))?;
        let unpacked = folder.join(archive.file_stem().unwrap_or_default());
        patch += &format!("{name} = {{ path = \"{}\" }}\n", unpacked.display());
    }
    let user = folder.join("user");
    let version = crates.iter().find(|package| name(package) == "objdict").map(|package| &package["version"]);
    let version = version.and_then(Value::as_str).unwrap_or_default();
    let manifest = format!(
        "[package]\nname = \"user\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\nobjdict = \"{version}\"\n\n\
         [patch.crates-io]\n{patch}"
    );
    let files = [("Cargo.toml", manifest), ("src/lib.rs", "pub use objdict;\n".to_owned())];
    for (file, text) in files {
        write(&user.join(file), text.as_bytes())?;
    }
    let lock = user.join("Cargo.lock");
    fs::copy(root.join("Cargo.lock"), &lock).map_err(|error| format!("{}: {error}", lock.display()))?;
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(&user).args(["check", "--quiet", "--offline", "--target-dir"]).arg(root.join("target"));
    run_program(&mut cargo)?;
    println!("objdict compiles from the packages");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package(name: &str, needs: &[&str]) -> Value {
        let needs: Vec<Value> = needs
            .iter()
            .map(|need| serde_json::json!({ "name": need, "kind": null, "path": "x", "req": "=1.0.0" }))
            .collect();
        serde_json::json!({
            "name": name, "description": "d", "license": "MIT", "documentation": "u", "homepage": "u", "readme": "README.md",
            "rust_version": "1.88", "authors": ["a"], "dependencies": needs,
        })
    }

    #[test]
    fn a_crate_comes_after_what_it_needs() {
        let crates = [package("a", &["c"]), package("b", &[]), package("c", &["b"])];
        assert_eq!(in_order(&crates).unwrap(), ["b", "c", "a"]);
        assert!(in_order(&[package("a", &["b"]), package("b", &["a"])]).is_err());
        assert!(in_order(&[package("a", &["not-published"])]).is_err());
    }

    #[test]
    fn what_a_registry_refuses_is_a_problem() {
        let mut wrong = package("a", &["b"]);
        assert_eq!(problems(&wrong), [""; 0]);
        wrong["license"] = Value::Null;
        wrong["dependencies"][0]["req"] = "*".into();
        assert_eq!(problems(&wrong), ["a: no `license`", "a: `b` has a path and no version"]);
    }

    #[test]
    fn each_published_crate_has_the_texts_of_its_licences() {
        for package in published(&root()).unwrap() {
            let mut command = Command::new(env!("CARGO"));
            command.args(["package", "--list", "--allow-dirty", "-p", name(&package)]);
            let listed = String::from_utf8(command.output().unwrap().stdout).unwrap();
            for text in ["LICENSE-APACHE", "LICENSE-MIT"] {
                assert!(
                    listed.lines().any(|line| line == text),
                    "{} has no {text}: {listed}",
                    name(&package)
                );
            }
        }
    }

    #[test]
    fn the_crates_of_the_workspace_are_complete() {
        let crates = published(&root()).unwrap();
        let problems: Vec<String> = crates.iter().flat_map(problems).collect();
        assert_eq!(problems, [""; 0]);
        assert_eq!(in_order(&crates).unwrap().last(), Some(&"objdict"));
    }
}
