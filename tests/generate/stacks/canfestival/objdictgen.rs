//! objdictgen of PyPI and this target make the same table of a project. The node is called as the harness expects.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use objdict::format::input::{Input, Reading};

use crate::compile::{c_compiler, generate_with};
use crate::processors::build;
use crate::stacks::beside;
use crate::support::{fixtures, python, run, unless_offline};

/// The variables that a header declares with their types; of a text without its length.
fn declared(header: &str) -> BTreeMap<String, String> {
    let lines = header.lines().filter_map(|line| line.strip_prefix("extern ")?.split_once(';'));
    let variables = lines.filter_map(|(declaration, _)| {
        let (base, rest) = declaration.split_once(' ')?;
        let (name, dimensions) = rest.split_at(rest.find('[').unwrap_or(rest.len()));
        let is_text = ["Axis_1_Access", "Label", "Words"].contains(&name);
        let dimensions = if is_text { dimensions.rsplit_once('[')?.0 } else { dimensions };
        Some((name.to_owned(), format!("{base}{dimensions}")))
    });
    variables.collect()
}

/// What the harness reads of the table in a folder.
fn rows(compiler: &str, folder: &Path, flags: &[&str]) -> String {
    let mut cc = Command::new(compiler);
    cc.current_dir(folder).args(["-w", "-I.", "-o", "harness", "device.c"]).args(flags);
    cc.arg(format!("-I{}", beside("canfestival", "include").display()))
        .arg(beside("canfestival", "harness.c"));
    let printed = build(&cc).run(&[], "").unwrap_or_else(|error| panic!("{error}"));
    // objdictgen gives a text of 20 characters a row of the default size
    let lines = printed.lines().filter(|line| !line.starts_with("2002 03 09 "));
    lines.map(|line| format!("{line}\n")).collect()
}

#[test]
fn objdictgen_makes_the_same_table() {
    let Some(compiler) = c_compiler() else { return };
    let Some(programs) = unless_offline(python("objdictgen", &["objdictgen==3.5.5"])) else { return };
    let project = std::fs::read_to_string(fixtures().join("objdictgen/pump.od")).unwrap();
    let project = project.replace("value=\"Pump\"", "value=\"od\"");
    let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    let [theirs, ours] = folders.each_ref().map(tempfile::TempDir::path);
    std::fs::write(theirs.join("device.od"), &project).unwrap();
    run(Command::new(programs.join("odg")).args(["gen", "device.od", "device.c"]).current_dir(theirs))
        .unwrap();

    let (_, input) = Reading::default().read("device.od", project.into_bytes()).unwrap();
    let Input::Description(description) = input else { panic!("no description") };
    let mut options = objdict::generate::Options::default();
    options.file_stem = "device".to_owned();
    generate_with(ours, description.device(), "canfestival", &options);

    let header = |folder: &Path| declared(&std::fs::read_to_string(folder.join("device.h")).unwrap());
    let (declared, expected) = (header(ours), header(theirs));
    let missing: Vec<_> = expected.iter().filter(|(name, base)| declared.get(*name) != Some(base)).collect();
    assert!(expected.len() > 15 && missing.is_empty(), "{missing:?}");

    // what the header of the stack has beside what a dictionary needs
    let codes = ["-DOD_VALUE_RANGE_EXCEEDED=1", "-DOD_VALUE_TOO_LOW=2", "-DOD_VALUE_TOO_HIGH=3"];
    let of_fork = [&codes[..], &["-DOD_CALLBACK_IN_ROW"]].concat();
    let expected = rows(&compiler, theirs, &of_fork);
    assert_eq!(rows(&compiler, ours, &of_fork), expected);
    assert_eq!(rows(&compiler, ours, &codes), expected, "without callbacks in rows");
    assert!(expected.lines().count() > 80, "{expected}");
}
