//! What the page on MISRA C says of the C files is what a checker finds.

use std::collections::BTreeSet;
use std::process::Command;

use objdict::generate::{CTable, Options, Target, generate};

use tempfile::TempDir;

use crate::support::skips::has;
use crate::verdicts::Key;
use crate::{device, odd, support};

/// The rules that the page names for a layout.
fn documented(table: CTable) -> BTreeSet<String> {
    let page = include_str!("../../docs/reference/misra.md");
    let rows = page.lines().filter_map(|line| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, rule, kind, layout, ..] = *cells else { return None };
        let is_rule = matches!(kind, "advisory" | "required");
        (is_rule && (layout.is_empty() || table == CTable::Structs)).then(|| rule.to_owned())
    });
    rows.collect()
}

/// The checker for the files of some devices.
fn checkers(options: &Options) -> Vec<(TempDir, Command)> {
    let mut devices: Vec<_> =
        ["eds/dspic-sensors.eds", "xdd/valve.xdd"].map(|name| device(&support::fixtures().join(name))).into();
    devices.push(odd::device());
    let mut commands = Vec::new();
    for device in devices {
        let folder = tempfile::tempdir().unwrap();
        let mut command = Command::new("cppcheck");
        command.current_dir(folder.path()).args(["--addon=misra", "--std=c99", "--quiet"]);
        for file in generate(&device, Target::named("c").unwrap(), options).unwrap().files {
            std::fs::write(folder.path().join(&file.path), &file.contents).unwrap();
            if file.path.ends_with(".c") {
                command.arg(&file.path);
            }
        }
        commands.push((folder, command));
    }
    commands
}

/// The rules that a checker finds violated.
fn found(command: &mut Command) -> BTreeSet<String> {
    let text = String::from_utf8_lossy(&command.output().unwrap().stderr).into_owned();
    let findings = text.split("[misra-c2012-").skip(1).filter_map(|rest| rest.split_once(']'));
    findings.map(|(rule, _)| rule.to_owned()).collect()
}

#[test]
fn the_deviations_are_those_of_the_page() {
    if !has("cppcheck", "cppcheck") {
        return;
    }
    for table in [CTable::Compact, CTable::Structs] {
        let mut options = Options::default();
        options.table = table;
        options.groups = vec!["2000-2FFF=APP".parse().unwrap()];
        options.hooks = ["2000".parse().unwrap()].into();
        let documented = documented(table);
        let mut checkers = checkers(&options);
        let mut key = Key::new();
        checkers.iter().for_each(|(_, command)| key.command(command));
        key.debug(&documented);
        key.or_try(|| {
            let found: BTreeSet<_> = checkers.iter_mut().flat_map(|(_, command)| found(command)).collect();
            let untold: Vec<_> = found.difference(&documented).collect();
            match found.is_empty() || !untold.is_empty() {
                true => Err(format!("{table:?}: {untold:?} are not in docs/reference/misra.md")),
                false => Ok(()),
            }
        })
        .unwrap();
    }
}
