//! The packages of the lock file are held against `deny.toml`: sources and repeated versions of all platforms, licences of this one.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value as Json;
use toml::{Table, Value};

/// Reports every package that `deny.toml` does not allow, and every exception that is for none.
pub(crate) fn run() -> Result<(), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let rules = table(&root.join("deny.toml"))?;
    let mut problems = of_lock_file(&table(&root.join("Cargo.lock"))?, &rules);
    problems.extend(of_licences(&metadata(&root)?, &rules));
    if problems.is_empty() { Ok(()) } else { Err(problems.join("\n")) }
}

fn table(path: &Path) -> Result<Table, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    text.parse().map_err(|error| format!("{}: {error}", path.display()))
}

/// The tables of an array in a section.
fn rows<'a>(table: &'a Table, path: &[&str]) -> impl Iterator<Item = &'a Value> {
    let (first, rest) = path.split_first().unwrap_or((&"", &[]));
    let found = rest.iter().try_fold(table.get(*first), |at, key| Some(at?.get(*key))).flatten();
    found.and_then(Value::as_array).into_iter().flatten()
}

fn text<'a>(row: &'a Value, key: &str) -> &'a str {
    row.get(key).and_then(Value::as_str).unwrap_or_default()
}

const CRATES_IO: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// Packages from elsewhere, and second versions that are not excused.
fn of_lock_file(lock: &Table, rules: &Table) -> Vec<String> {
    let mut problems = Vec::new();
    let mut versions: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for package in rows(lock, &["package"]) {
        let (name, source) = (text(package, "name"), package.get("source").and_then(Value::as_str));
        if let Some(source) = source.filter(|source| *source != CRATES_IO) {
            problems.push(format!("{name} is from {source}, not from crates.io"));
        }
        // without what is behind `+`, which says nothing about the version
        let version = text(package, "version").split('+').next().unwrap_or_default();
        versions.entry(name).or_default().insert(version);
    }
    for skipped in rows(rules, &["bans", "skip"]) {
        let skipped = text(skipped, "crate");
        let known =
            skipped.split_once('@').and_then(|(name, version)| Some((versions.get_mut(name)?, version)));
        if !known.is_some_and(|(versions, version)| versions.len() > 1 && versions.remove(version)) {
            problems.push(format!(
                "`skip` of deny.toml has {skipped}, which is not there beside another version"
            ));
        }
    }
    for (name, versions) in versions.iter().filter(|(_, versions)| versions.len() > 1) {
        problems.push(format!("{name} has several versions: {versions:?}"));
    }
    problems
}

/// Packages of others whose licence is not allowed.
fn of_licences(metadata: &Json, rules: &Table) -> Vec<String> {
    let allowed: BTreeSet<&str> = rows(rules, &["licenses", "allow"]).filter_map(Value::as_str).collect();
    let exceptions: BTreeMap<&str, Vec<&str>> = rows(rules, &["licenses", "exceptions"])
        .map(|row| {
            let licences = row.get("allow").and_then(Value::as_array).into_iter().flatten();
            (text(row, "crate"), licences.filter_map(Value::as_str).collect())
        })
        .collect();
    let mut problems = Vec::new();
    for package in metadata["packages"].as_array().into_iter().flatten() {
        let (name, licence) = (package["name"].as_str().unwrap_or_default(), package["license"].as_str());
        let is_allowed =
            |one: &str| allowed.contains(one) || exceptions.get(name).is_some_and(|of| of.contains(&one));
        if !package["source"].is_null() && !licence.is_some_and(|licence| allows(licence, is_allowed)) {
            problems.push(format!("{name} has the licence {licence:?}, which deny.toml does not allow"));
        }
    }
    problems
}

/// Whether an SPDX expression can be met: one of each list of alternatives, which `AND` joins. Another nesting asks for more than
/// it needs.
fn allows(expression: &str, is_allowed: impl Fn(&str) -> bool) -> bool {
    let expression = expression.replace('/', " OR ");
    expression.split(" AND ").all(|alternatives| {
        alternatives.split(" OR ").any(|one| is_allowed(one.trim_matches(|c| matches!(c, ' ' | '(' | ')'))))
    })
}

/// The packages that are built on this platform.
fn metadata(root: &Path) -> Result<Json, String> {
    let version = output(Command::new("rustc").arg("-vV"))?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc names no host")?;
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["metadata", "--format-version=1", "--locked", "--all-features", "--filter-platform", host]);
    serde_json::from_str(&output(cargo.current_dir(root))?).map_err(|error| error.to_string())
}

fn output(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
        false => Err(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    const RULES: &str = "\
        [licenses]\nallow = [\"MIT\", \"Unicode-3.0\"]\n[[licenses.exceptions]]\ncrate = \"c\"\nallow = [\"MPL-2.0\"]\n\
        [bans]\nskip = [{ crate = \"a@1.0.0\" }, { crate = \"b@1.0.0\" }]";

    #[test]
    fn every_package_is_allowed() {
        assert_eq!(run(), Ok(()));
    }

    #[test]
    fn each_published_crate_has_the_texts_of_its_licences() {
        let metadata = metadata(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..")).unwrap();
        let packages = metadata["packages"].as_array().unwrap().iter();
        let published: Vec<&str> = packages
            .filter(|package| package["source"].is_null() && package["publish"].is_null())
            .map(|package| package["name"].as_str().unwrap())
            .collect();
        assert!(published.contains(&"objdict-model"));
        for name in published {
            let mut command = Command::new(env!("CARGO"));
            let output = command.args(["package", "--list", "--allow-dirty", "-p", name]).output().unwrap();
            let listed = String::from_utf8(output.stdout).unwrap();
            for text in ["LICENSE-APACHE", "LICENSE-MIT"] {
                assert!(listed.lines().any(|line| line == text), "{name} has no {text}: {listed}");
            }
        }
    }

    #[test]
    fn licences_are_alternatives_or_joined() {
        let problems = |name: &str, licence: &str| {
            let package = json!({ "name": name, "license": licence, "source": "x" });
            of_licences(&json!({ "packages": [package] }), &RULES.parse().unwrap()).len()
        };
        for licence in ["MIT", "MIT/Apache-2.0", "Apache-2.0 OR MIT", "(MIT OR Apache-2.0) AND Unicode-3.0"] {
            assert_eq!(problems("a", licence), 0, "{licence}");
        }
        for licence in ["", "MPL-2.0", "MIT AND GPL-3.0", "Apache-2.0 OR GPL-3.0"] {
            assert_eq!(problems("a", licence), 1, "{licence}");
        }
        assert_eq!(problems("c", "MPL-2.0"), 0);
    }

    #[test]
    fn sources_and_second_versions_are_found() {
        let package = |name: &str, version: &str, source: &str| {
            format!("[[package]]\nname = \"{name}\"\nversion = \"{version}\"\nsource = \"{source}\"\n")
        };
        let lock = [
            package("a", "1.0.0", CRATES_IO),
            package("a", "2.0.0+x", CRATES_IO),
            package("b", "1.0.0", CRATES_IO),
            package("c", "1.0.0", CRATES_IO),
            package("c", "1.1.0", "git+https://example.com/c"),
        ];
        let problems = of_lock_file(&lock.concat().parse().unwrap(), &RULES.parse().unwrap());
        assert_eq!(
            problems,
            [
                "c is from git+https://example.com/c, not from crates.io",
                "`skip` of deny.toml has b@1.0.0, which is not there beside another version",
                "c has several versions: {\"1.0.0\", \"1.1.0\"}",
            ]
        );
    }
}
