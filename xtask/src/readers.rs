//! Which tools read the EDS and DCF of a folder as they are, and after `check --fix`.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use objdict::diagnostic::{Applicability, Tool};
use objdict::format::{self, Format};
use objdict::lint::Options;
use objdict::source::SourceOptions;
use serde_json::Value;

/// The tools that `readings.py` and, last, `readings.js` read with.
const TOOLS: [Tool; 3] = [Tool::PythonCanopen, Tool::DcfTools, Tool::NodeCanopen];

/// By the name of a file, whether each tool reads it.
type Readings = BTreeMap<String, [bool; 3]>;

/// The columns of the table: what becomes of a file before a tool reads it.
const COLUMNS: [&str; 3] = ["as it is", "`--fix`", "`--fix --compat TOOL`"];

/// Prints how many files below `folder` each tool reads. `python` is an interpreter with canopen and dcf-tools, `modules` a
/// folder with the package canopen of npm, such as those of the test `interop`.
pub(crate) fn run(folder: &Path, python: &Path, modules: Option<&Path>) -> Result<(), String> {
    let place = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut files = Vec::new();
    crate::corpus::collect(folder, &mut files).map_err(|error| error.to_string())?;
    let mut paths = Vec::new();
    let mut count = 0;
    for file in &files {
        let Ok(description) = format::open(file, &SourceOptions::default()) else { continue };
        if !matches!(description.format(), Format::Eds | Format::Dcf) {
            continue;
        }
        let choices = std::iter::once(Vec::new()).chain(TOOLS.map(|tool| vec![tool]));
        for (number, text) in choices.map(|tools| fixed(file, tools)).enumerate() {
            let path = place.path().join(format!("{count}-{number}.eds"));
            fs::write(&path, text?).map_err(|error| error.to_string())?;
            paths.push(path.display().to_string());
        }
        let path = place.path().join(format!("{count}.eds"));
        fs::write(&path, description.print()).map_err(|error| error.to_string())?;
        paths.push(path.display().to_string());
        count += 1;
    }
    let script =
        |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/library/interop").join(name);
    let mut readings = Readings::new();
    read_with(Command::new(python).arg(script("readings.py")), &paths, &mut readings)?;
    if let Some(modules) = modules {
        let mut node = Command::new("node");
        read_with(node.env("NODE_PATH", modules).arg(script("readings.js")), &paths, &mut readings)?;
    }
    let tools = TOOLS.len() - usize::from(modules.is_none());
    print!("{}", table(&readings, count, &TOOLS[..tools]));
    Ok(())
}

/// A file after its safe fixes.
fn fixed(file: &Path, tools: Vec<Tool>) -> Result<Vec<u8>, String> {
    let description = format::open(file, &SourceOptions::default()).map_err(|error| error.to_string())?;
    let options = Options { tools, ..Options::default() };
    Ok(objdict::fix_for_readers(description, Applicability::Safe, &options).bytes())
}

/// Adds what the tools of a script read.
fn read_with(command: &mut Command, paths: &[String], readings: &mut Readings) -> Result<(), String> {
    let name = command.get_program().display().to_string();
    let child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let mut child = child.map_err(|error| format!("cannot run {name}: {error}"))?;
    // all of it is read before the first answer
    let mut input = child.stdin.take().ok_or("no standard input")?;
    input.write_all(paths.join("\n").as_bytes()).map_err(|error| error.to_string())?;
    drop(input);
    let output = child.wait_with_output().map_err(|error| error.to_string())?;
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let reading: Value = serde_json::from_str(line).map_err(|error| error.to_string())?;
        let name = Path::new(reading["path"].as_str().unwrap_or_default()).file_name().unwrap_or_default();
        let is_read = readings.entry(name.to_string_lossy().into_owned()).or_default();
        for (is_read, tool) in is_read.iter_mut().zip(TOOLS) {
            *is_read |= reading[tool.name()].is_object();
        }
    }
    Ok(())
}

fn table(readings: &Readings, count: usize, tools: &[Tool]) -> String {
    let mut text = format!("| {count} EDS and DCF read by | {} |\n|---|---|---|---|\n", COLUMNS.join(" | "));
    for (place, tool) in tools.iter().enumerate() {
        let read = |suffix: &str| {
            let is_read = |number: &usize| {
                readings.get(&format!("{number}{suffix}.eds")).is_some_and(|tools| tools[place])
            };
            (0..count).filter(is_read).count()
        };
        let chosen = format!("-{}", place + 1);
        text += &format!("| {} | {} | {} | {} |\n", tool.name(), read(""), read("-0"), read(&chosen));
    }
    text
}
