//! What Cargo compiles for the commands of README. Features that one command turns on and another does not would make Cargo compile most
//! crates again, so whoever has run `cargo run` waits half as long for `cargo test`, and the gate compiles everything once.
//!
//! Therefore all commands use the default members of the workspace, and `xtask` and `tests/crates` depend on some
//! crates only to enable the features that dependencies of tests enable.

#![cfg(test)]

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// A compiler run: crate, features, profile and target, and the runs that it needs. Equal runs of two commands are made once.
type Unit = (String, Vec<usize>);

/// The numbers of all units that were seen.
type Known = BTreeMap<Unit, usize>;

/// The units of a command that `--unit-graph` shows, with their packages.
fn units(arguments: &[&str], known: &mut Known) -> BTreeMap<usize, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut command = Command::new(env!("CARGO"));
    // a stable compiler shows it too
    command.args(arguments).args(["-Z", "unstable-options", "--unit-graph"]).env("RUSTC_BOOTSTRAP", "1");
    let output = command.current_dir(root).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let graph: Value = serde_json::from_slice(&output.stdout).expect("the graph is JSON");
    let graph = graph["units"].as_array().expect("it has units").as_slice();
    let mut numbers = vec![None; graph.len()];
    (0..graph.len()).map(|index| (number(graph, index, &mut numbers, known), name(&graph[index]))).collect()
}

fn number(graph: &[Value], index: usize, numbers: &mut [Option<usize>], known: &mut Known) -> usize {
    if let Some(number) = numbers[index] {
        return number;
    }
    let unit = &graph[index];
    let needed = unit["dependencies"].as_array().into_iter().flatten();
    let needed = needed.filter_map(|dependency| dependency["index"].as_u64());
    let mut needed: Vec<_> = needed.map(|index| number(graph, index as usize, numbers, known)).collect();
    needed.sort_unstable();
    let profile =
        ["opt_level", "debuginfo", "debug_assertions", "panic", "lto"].map(|key| &unit["profile"][key]);
    let what = [
        &unit["pkg_id"],
        &unit["target"]["name"],
        &unit["target"]["kind"],
        &unit["mode"],
        &unit["platform"],
        &unit["features"],
    ];
    let next = known.len();
    let number = *known.entry((format!("{what:?}{profile:?}"), needed)).or_insert(next);
    numbers[index] = Some(number);
    number
}

/// Package, target and mode, for messages.
fn name(unit: &Value) -> String {
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let package = text(&unit["pkg_id"]);
    let package = package.rsplit('/').next().unwrap_or_default();
    format!("{package} {} {} {}", text(&unit["target"]["name"]), unit["target"]["kind"], text(&unit["mode"]))
}

#[test]
fn tests_compile_again_nothing_that_run_has_compiled() {
    let mut known = Known::new();
    let run = units(&["build", "--bin", "objdict"], &mut known);
    let test = units(&["test"], &mut known);
    let again: Vec<_> =
        run.iter().filter(|(unit, _)| !test.contains_key(unit)).map(|(_, name)| name).collect();
    assert!(again.is_empty(), "`cargo test` compiles these with other features than `cargo run`: {again:#?}");
    assert!(run.len() > 100 && test.len() > run.len(), "{} and {} units", run.len(), test.len());

    let mut libraries = BTreeMap::new();
    for name in test.values().filter(|name| name.ends_with("build") && name.contains("lib")) {
        *libraries.entry(name).or_insert(0) += 1;
    }
    let twice: Vec<_> = libraries.into_iter().filter(|(_, count)| *count > 1).collect();
    assert!(twice.is_empty(), "`cargo test` compiles these more than once: {twice:#?}");
}

/// The gate and the workflows call these commands, so that they share what is compiled too.
#[test]
fn the_gate_has_the_commands_of_the_readme() {
    let read = |path: &str| {
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).unwrap()
    };
    let (readme, gate) = (read("README.md"), read(".ci/run"));
    assert!(readme.contains("\ncargo run -- check ") && readme.contains("\ncargo test "));
    assert!(
        gate.contains("\ntests() { cargo test --no-fail-fast; }\n")
            && gate.contains("\n  cargo test --no-run\n")
    );
}
