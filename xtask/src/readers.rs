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

/// The tools that `readings.py` reads with.
const TOOLS: [Tool; 2] = [Tool::PythonCanopen, Tool::DcfTools];

/// The columns of the table: what becomes of a file before a tool reads it.
const COLUMNS: [&str; 3] = ["as it is", "`--fix`", "`--fix --compat TOOL`"];

/// Prints how many files below `folder` each tool reads. `python` is an interpreter with canopen and dcf-tools, such as that
/// of the test `interop`.
pub(crate) fn run(folder: &Path, python: &Path) -> Result<(), String> {
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
        for (number, text) in
            [vec![], vec![TOOLS[0]], vec![TOOLS[1]]].into_iter().map(|tools| fixed(file, tools)).enumerate()
        {
            let path = place.path().join(format!("{count}-{number}.eds"));
            fs::write(&path, text?).map_err(|error| error.to_string())?;
            paths.push(path.display().to_string());
        }
        let path = place.path().join(format!("{count}.eds"));
        fs::write(&path, description.print()).map_err(|error| error.to_string())?;
        paths.push(path.display().to_string());
        count += 1;
    }
    print!("{}", table(&readings(python, &paths)?, count));
    Ok(())
}

/// A file after its safe fixes.
fn fixed(file: &Path, tools: Vec<Tool>) -> Result<Vec<u8>, String> {
    let description = format::open(file, &SourceOptions::default()).map_err(|error| error.to_string())?;
    let options = Options { tools, ..Options::default() };
    Ok(objdict::fix(description, Applicability::Safe, |description| {
        objdict::check_with(description, &options)
    })
    .bytes())
}

/// For each file, by its name, whether each tool reads it.
fn readings(python: &Path, paths: &[String]) -> Result<BTreeMap<String, [bool; 2]>, String> {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/library/interop/readings.py");
    let mut child = Command::new(python)
        .arg(script)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| format!("cannot run {}: {error}", python.display()))?;
    // all of it is read before the first answer
    let mut input = child.stdin.take().ok_or("no standard input")?;
    input.write_all(paths.join("\n").as_bytes()).map_err(|error| error.to_string())?;
    drop(input);
    let output = child.wait_with_output().map_err(|error| error.to_string())?;
    let lines = String::from_utf8_lossy(&output.stdout);
    let reading = |line: &str| {
        let reading: Value = serde_json::from_str(line).map_err(|error| error.to_string())?;
        let name = Path::new(reading["path"].as_str().unwrap_or_default()).file_name().unwrap_or_default();
        Ok((name.to_string_lossy().into_owned(), TOOLS.map(|tool| reading[tool.name()].is_object())))
    };
    lines.lines().map(reading).collect()
}

fn table(readings: &BTreeMap<String, [bool; 2]>, count: usize) -> String {
    let mut text = format!("| {count} EDS and DCF read by | {} |\n|---|---|---|---|\n", COLUMNS.join(" | "));
    for (place, tool) in TOOLS.iter().enumerate() {
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
