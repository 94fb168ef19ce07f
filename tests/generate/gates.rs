//! Names, and optional parts: every combination compiles without warnings, and the included parts work.

use std::collections::BTreeMap;
use std::path::Path;

use objdict::generate::{Derive, Options, Target, generate};
use objdict::model::Device;

use crate::batch::Batch;
use crate::compile::{c_compiler, cc};
use crate::processors::{Programs, host};
use crate::support::skips::sample;
use crate::verdicts::Key;
use crate::{device, for_all, odd, support};

/// The optional parts: Rust feature and C macro.
const GATES: [(&str, &str); 3] =
    [("od-names", "OD_NO_NAMES"), ("od-pdo", "OD_NO_PDO"), ("od-limits", "OD_NO_LIMITS")];

fn devices() -> Vec<(String, Device)> {
    let fixture = |name: &str| (name.to_owned(), device(&support::fixtures().join(name)));
    let mut devices: Vec<_> =
        ["eds/minimal.eds", "eds/drive-402.eds", "eds/hostile.eds", "xdd/valve.xdd"].map(fixture).into();
    devices.push(("odd".to_owned(), odd::device()));
    devices
}

fn generate_with(
    folder: &Path,
    device: &Device,
    target: Target,
    choose: impl Fn(&mut Options),
) -> Vec<String> {
    let mut options = Options::default();
    choose(&mut options);
    let generated = generate(device, target, &options).unwrap();
    for file in &generated.files {
        std::fs::write(folder.join(&file.path), &file.contents).unwrap();
    }
    generated.files.into_iter().map(|file| String::from_utf8(file.contents).unwrap()).collect()
}

/// Whether a text is a name with unsafe characters replaced, on one line.
fn is_name_of(shown: &str, name: &str) -> bool {
    let is_plain = |c: char| c == ' ' || c.is_ascii_graphic() || c.is_alphanumeric();
    match name.chars().all(is_plain) && name.chars().count() <= 100 {
        true => shown == name.trim(),
        false => shown.chars().all(is_plain) && shown.chars().count() <= 1200,
    }
}

/// The names of the entries in a table, by index and sub-index.
type Names = BTreeMap<(u16, u8), String>;

fn names_of(device: &Device) -> Names {
    let names = crate::oracle::facts_of(device).map(|((index, sub), _)| {
        ((index, sub), device.entry(index, sub).map(|entry| entry.name.to_string()).unwrap_or_default())
    });
    names.collect()
}

/// Checks the names of all entries, one per line.
fn check_names(output: &str, names: &Names) -> Result<(), String> {
    let mut lines = 0;
    for line in output.lines() {
        let mut words = line.splitn(3, ' ');
        let mut number = || words.next().and_then(|word| word.parse::<u16>().ok()).ok_or("no number");
        let (index, sub) = (number()?, number()?);
        let shown = words.next().unwrap_or_default();
        let name = names.get(&(index, sub as u8)).ok_or("no such entry")?;
        if !is_name_of(shown, name) {
            return Err(format!("{index:04X}h:{sub:02X} is called `{shown}` instead of `{name}`"));
        }
        lines += 1;
    }
    if lines == names.len() { Ok(()) } else { Err(format!("{lines} names")) }
}

const RUST: &str = r#"
mod od { include!("od.rs"); }
fn main() {
    let mut data = od::Data::new(5);
    let _ = data.write(0x1000, 0, &[0; 4]);
    #[cfg(feature = "od-names")]
    for entry in &od::ENTRIES {
        println!("{} {} {}", entry.index(), entry.sub(), entry.name());
    }
    #[cfg(feature = "od-limits")]
    assert!(od::ENTRIES.iter().all(|entry| entry.low_limit(1) <= entry.low_limit(1)));
}
"#;

const C: &str = r#"
#include <stdio.h>
#include "od.h"
static od_data_t data;
int main(void)
{
    const uint8_t bytes[4] = {0u, 0u, 0u, 0u};
    od_init(&data, 5);
    (void)od_write(&data, 0x1000u, 0u, bytes, sizeof bytes);
#ifndef OD_NO_NAMES
    size_t at;
    for (at = 0u; at < OD_ENTRY_COUNT; at++) {
        printf("%u %u %s\n", (unsigned)od_index(&od_entries[at]), (unsigned)od_entries[at].sub, od_name(&od_entries[at]));
    }
#endif
    return 0;
}
"#;

/// The optional parts of a combination, one bit each.
fn chosen(combination: usize) -> impl Iterator<Item = (bool, &'static str, &'static str)> {
    GATES.iter().enumerate().map(move |(bit, &(feature, name))| (combination >> bit & 1 == 1, feature, name))
}

/// Without `OBJDICT_SAMPLE=all`, all gates and two other combinations. The test of C below has all eight every time; a
/// fault that only Rust has in one of the others is found by the nightly gate.
#[test]
fn every_combination_of_gates_compiles_and_names_are_those_of_the_description() {
    let mut options = Options::default();
    options.feature_gates = true;
    for combination in sample(0..7).into_iter().chain([7]) {
        let mut flags =
            vec!["--check-cfg=cfg(feature, values(\"od-names\", \"od-pdo\", \"od-limits\"))".to_owned()];
        let features = chosen(combination).filter(|(is_chosen, ..)| *is_chosen);
        flags.extend(features.map(|(_, feature, _)| format!("--cfg=feature=\"{feature}\"")));
        let mut batch = Batch::new(&flags.iter().map(String::as_str).collect::<Vec<_>>());
        for (name, device) in devices() {
            batch.add(&name, &generate(&device, Target::RUST, &options).unwrap(), RUST, &names_of(&device));
        }
        batch.build();
        for (name, device) in devices() {
            let checked = batch.check(&name, "", |output| match combination & 1 {
                1 => check_names(output, &names_of(&device)),
                _ => Ok(()),
            });
            checked.unwrap_or_else(|error| panic!("{name}, {combination:03b}: {error}"));
        }
    }
}

#[test]
fn every_combination_of_macros_compiles_and_names_are_those_of_the_description() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&devices(), |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        let files = generate_with(folder, device, Target::C, |_| ()).len();
        std::fs::write(folder.join("gates.c"), C).map_err(|error| error.to_string())?;
        let names = names_of(device);
        let programs: Vec<Programs> = (0..8)
            .map(|combination| {
                let mut cc = cc(&compiler, folder);
                let macros = chosen(combination).filter(|(is_chosen, ..)| !is_chosen);
                cc.args(macros.map(|(.., name)| format!("-D{name}")));
                cc.args(["-I.", "-o", &format!("in-c-{combination}"), "od.c", "gates.c"]);
                host(cc.args((files > 2).then_some("od_pdo.c")))
            })
            .collect();
        let mut key = Key::new();
        programs.iter().for_each(|programs| key.key(programs.key()));
        key.debug(&names);
        key.or_try(|| {
            programs.iter().enumerate().try_for_each(|(combination, programs)| {
                let fail = |error: String| format!("{name}, {combination:03b}: {error}");
                let output = programs.run(&[], "").map_err(fail)?;
                if combination & 1 == 1 { check_names(&output, &names).map_err(fail) } else { Ok(()) }
            })
        })
    });
}

#[test]
fn without_names_no_name_is_in_the_code() {
    let device = device(&support::fixtures().join("eds/minimal.eds"));
    let folder = tempfile::tempdir().unwrap();
    for target in [Target::RUST, Target::C] {
        let with = generate_with(folder.path(), &device, target, |_| ()).concat();
        let without =
            generate_with(folder.path(), &device, target, |options| options.entry_names = false).concat();
        assert!(with.contains("\"Producer heartbeat time\""));
        assert!(!without.contains("\"Producer heartbeat time\"") && !without.contains("od_name"));
    }
}

#[test]
fn derives_stand_at_every_type() {
    let device = device(&support::fixtures().join("eds/drive-402.eds"));
    let folder = tempfile::tempdir().unwrap();
    let derived = generate_with(folder.path(), &device, Target::RUST, |options| {
        options.derives = vec![Derive::Defmt, Derive::Serde];
    });
    let text = derived.concat();
    let lines: Vec<&str> = text.lines().collect();
    let derives = ["#[derive(defmt::Format)]", "#[derive(serde::Serialize, serde::Deserialize)]"];
    let types = lines.iter().enumerate().filter(|(_, line)| line.contains("#[derive(Clone"));
    for (at, line) in types {
        let next = &lines[at + 1..at + 3];
        // types without values, and those that have the traits by other means
        let others = [
            "pub struct Od;",
            "pub struct Entry",
            "pub struct Data",
            "pub enum Ro",
            "pub enum Wo",
            "pub enum Rw",
            "pub enum Const",
            "pub enum NodeConst",
            "pub enum Elsewhere",
        ];
        let is_other = others.iter().any(|other| next[0].contains(other));
        assert!(is_other || next.iter().map(|line| line.trim()).eq(derives), "{line}\n{next:?}");
    }
    assert!(derives.iter().all(|derive| text.matches(derive).count() > 6));
}
