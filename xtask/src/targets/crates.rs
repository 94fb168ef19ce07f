//! What is generated for the crates of others, compiled with them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::Outcome;
use super::compile::Tools;
use super::table::Column;

/// The crates as Cargo built them for tests/crates.
pub(super) struct Crates {
    /// The libraries, by name.
    libraries: BTreeMap<String, PathBuf>,
    /// The program that calls zencan-build.
    zencan_code: PathBuf,
}

impl Crates {
    /// Builds the crates, or finds them built.
    pub(super) fn build() -> Result<Self, String> {
        let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
        let mut command = Command::new(cargo);
        command.args(["build", "--quiet", "--package=objdict-crates", "--example=zencan_code"]);
        command.arg("--message-format=json").stderr(Stdio::inherit());
        let output = command.output().map_err(|error| format!("cargo: {error}"))?;
        let text = String::from_utf8_lossy(&output.stdout);
        let mut libraries = BTreeMap::new();
        let mut zencan_code = None;
        for line in text.lines() {
            let Ok(message) = serde_json::from_str::<serde_json::Value>(line) else { continue };
            let (Some(name), Some(files)) =
                (message["target"]["name"].as_str(), message["filenames"].as_array())
            else {
                continue;
            };
            let mut files = files.iter().filter_map(|file| file.as_str());
            if let Some(file) = files.find(|file| file.ends_with(".rlib")) {
                libraries.insert(name.to_owned(), PathBuf::from(file));
            } else if let ("zencan_code", Some(file)) = (name, message["executable"].as_str()) {
                zencan_code = Some(PathBuf::from(file));
            }
        }
        let zencan_code = zencan_code.ok_or("cargo does not build the crates of tests/crates")?;
        Ok(Self { libraries, zencan_code })
    }

    /// What makes the compiler find a library and what it needs itself.
    pub(super) fn arguments(&self, name: &str) -> Vec<String> {
        let Some(file) = self.libraries.get(name) else { return Vec::new() };
        let folder = file.parent().unwrap_or(Path::new(""));
        vec![format!("--extern={name}={}", file.display()), format!("-Ldependency={}", folder.display())]
    }
}

/// Has zencan-build make nodes of the configurations that wait, and compiles these.
pub(super) fn zencan(files: &[&Path], tools: &Tools, column: &mut Column) -> Result<(), String> {
    let Some(crates) = &tools.crates else { return Ok(()) };
    let output = Command::new(&crates.zencan_code).arg(tools.waiting.path()).output();
    let output = output.map_err(|error| format!("zencan-build: {error}"))?;
    if !output.status.success() {
        return Err(format!("zencan-build: {}", String::from_utf8_lossy(&output.stderr)));
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let refused: BTreeMap<&str, &str> = text.lines().filter_map(|line| line.split_once('\t')).collect();
    for (number, file) in files.iter().enumerate() {
        if !tools.zencan_file(number).exists() {
            continue;
        }
        let problem = match refused.get(format!("node{number}").as_str()) {
            Some(problem) => Err(format!("zencan-build: {problem}")),
            None => compiled(number, crates, tools),
        };
        if let Err(problem) = problem {
            column.replace(&file.display().to_string(), Outcome::Failed(problem));
        }
    }
    Ok(())
}

fn compiled(number: usize, crates: &Crates, tools: &Tools) -> Result<(), String> {
    let mut command = Command::new(&tools.rustc);
    command.args(["--edition=2024", "--crate-type=lib", "--emit=metadata", "--cap-lints=allow"]);
    command.args(crates.arguments("zencan_node")).arg(format!("node{number}.rs"));
    let output = command.current_dir(tools.waiting.path()).output();
    let output = output.map_err(|error| format!("rustc: {error}"))?;
    if output.status.success() {
        return Ok(());
    }
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(format!("rustc: {}", text.lines().find(|line| line.contains("error")).unwrap_or("failed")))
}
