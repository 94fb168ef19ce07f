//! The promise of docs/reference/limits.md for every command and every option of `check`: memory and time grow with the file, whatever repeats in it.
//! tests/memory has more files, for what the library does with them.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::skips::{has, sample};

/// What a file repeats, behind a small device.
const REPEATED: [(&str, &[u8]); 17] = [
    ("cr", b"\r"),
    ("nel", b"\x85"),
    ("latin", b"\xE9"),
    ("nul", b"\0"),
    ("equals", b"="),
    ("opening", b"["),
    ("semicolon", b";"),
    ("digit", b"1"),
    ("control", b"\x01a"),
    ("brackets", b"[]\n"),
    ("section", b"[2000]\n"),
    ("junk", b"a\n"),
    ("key", b"a=\n"),
    ("blank", b"[a] \n"),
    ("comment", b";\n"),
    ("paragraph", b"a\n\n"),
    ("sub", b"[2000sub1]\nDataType=x\n"),
];

/// A text that has its number.
type NumberedText = fn(usize) -> String;

/// What a file has after a small device, with its number, and how many bytes of it: nearly as many objects and sections as commands
/// process in so short a file.
const NUMBERED: [(&str, NumberedText, usize); 4] = [
    ("objects", |number| format!("[{:X}]\n", 0x2000 + number), 44_000),
    ("orphans", |number| format!("[{:X}sub0]\n", 0x2000 + number), 70_000),
    (
        "variables",
        |number| format!("[{:X}]\nParameterName=a\nDataType=5\nAccessType=rw\n", 0x2000 + number),
        350_000,
    ),
    (
        "entries",
        |number| format!("[{:X}sub{:X}]\nDataType=5\n", 0x2000 + number / 255, number % 255),
        300_000,
    ),
];

/// What is run with a file `F`.
const LINES: [&str; 34] = [
    "check F",
    "check F --all --jobs 2 --eds minimal.eds --node-id 5 --statistics --deny note --severity naming=off --compat lely --compat codesys",
    "check F --format concise --dialect canopeneditor --ignore naming --select cia306 --no-config",
    "check F --format json",
    "check F --format sarif",
    "check F --format github",
    "check F --format gitlab",
    "check F --format junit",
    "check F --write-baseline new.json",
    "check F --baseline baseline.json --profile 401 --config objdict.toml",
    "check F --cache cache.txt --encoding windows-1252",
    "fmt F --check",
    "show F",
    "convert F -o new.xdd",
    "convert F -o new.json",
    "convert F -o new.toml",
    "docs F -o new.html",
    "docs F -o new.md",
    "diff minimal.eds F",
    "patch make minimal.eds F -o new.patch.toml",
    "generate F --target c,rust --force -o generated",
    "conformance F",
    "probe F --overwrite -o probed",
    "configure F --node-id 5 --bit-rate 125 -o new.dcf",
    "identify F",
    "release minimal.eds F --diff",
    "show F --format json",
    "diff F minimal.eds --format json",
    "diff minimal.eds F --format html",
    "generate F --target canopennode,lely --force -o generated",
    "network check F minimal.eds",
    "network show F",
    "network diff minimal.eds F",
    "network build F --target concise -o built",
];

/// What tries fixes: several texts are in memory, and a difference has each line of two.
const FIXING: [&str; 3] =
    ["check F --diff --unsafe-fixes", "check F --fix --unsafe-fixes", "check F --vendor-report new.md"];

/// What a process takes for nothing but as many findings as are kept, and the fixes that are offered.
const PROCESS: usize = 26 << 20;

/// What docs/reference/limits.md allows it for parts that are shorter than what is made of them.
const ALLOWANCE: usize = 50_000_000;

fn write(folder: &Path, rest: impl IntoIterator<Item = u8>) -> usize {
    let mut text = fs::read("fixtures/eds/minimal.eds").unwrap();
    text.extend(rest);
    fs::write(folder.join("F.eds"), &text).unwrap();
    text.len()
}

fn repeat(folder: &Path, repeated: &[u8], bytes: usize) -> usize {
    write(folder, repeated.iter().copied().cycle().take(bytes))
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::copy("fixtures/eds/minimal.eds", folder.path().join("minimal.eds")).unwrap();
    fs::write(folder.path().join("objdict.toml"), "").unwrap();
    let line = ["check", "minimal.eds", "--write-baseline", "baseline.json"];
    Command::new(crate::program()).args(line).current_dir(&folder).output().unwrap();
    folder
}

/// Whether a line runs with so much memory.
#[cfg(target_os = "linux")]
fn runs(folder: &Path, line: &str, bytes: usize) -> bool {
    let line = line.replace('F', "F.eds");
    let script = format!("ulimit -d {} && exec \"$0\" {line}", bytes / 1024);
    let mut command = Command::new("sh");
    let output = command.args(["-c", &script, crate::program()]).current_dir(folder).output().unwrap();
    output.status.code().is_some_and(|code| code < 3)
}

#[cfg(target_os = "linux")]
#[test]
fn memory_is_in_proportion_to_the_file() {
    let folder = folder();
    let sizes = [50_000, 200_000].into_iter().cycle();
    let lines = LINES.iter().zip(sizes).map(|(line, bytes)| (line, bytes, PROCESS, 20));
    // each text is tried many times
    let lines = lines.chain(FIXING.iter().map(|line| (line, 20_000, ALLOWANCE, 20)));
    let runs_of = |(name, repeated)| {
        lines.clone().map(move |(line, bytes, least, factor)| (name, repeated, line, bytes, (least, factor)))
    };
    for (name, repeated, line, bytes, (least, factor)) in sample(REPEATED.into_iter().flat_map(runs_of)) {
        let size = repeat(folder.path(), repeated, bytes);
        assert!(runs(folder.path(), line, least + factor * size), "{line}: {size} bytes of {name}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn many_small_parts_take_no_more_than_is_promised() {
    let folder = folder();
    let lines = || LINES.into_iter().chain(FIXING);
    let runs_of = |(name, part, bytes)| lines().map(move |line| (name, part, bytes, line));
    // each takes a second
    for (name, part, bytes, line) in sample(NUMBERED.into_iter().flat_map(runs_of)).into_iter().step_by(4) {
        let size = write(folder.path(), (0..).flat_map(|number| part(number).into_bytes()).take(bytes));
        assert!(runs(folder.path(), line, ALLOWANCE + 20 * size), "{line}: {size} bytes of {name}");
    }
}

/// How many instructions a line executes.
fn instructions(folder: &Path, line: &str) -> u64 {
    let line = line.replace('F', "F.eds");
    let mut command = Command::new("valgrind");
    command.args([
        "--tool=cachegrind",
        "--cache-sim=no",
        "--cachegrind-out-file=/dev/null",
        crate::program(),
    ]);
    let output = command.args(line.split(' ')).current_dir(folder).output().unwrap();
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    let count = told.lines().find_map(|line| line.split_once("I refs:").or(line.split_once("I   refs:")));
    let digits: String =
        count.unwrap_or_else(|| panic!("{told}")).1.chars().filter(char::is_ascii_digit).collect();
    digits.parse().unwrap()
}

#[test]
fn time_is_in_proportion_to_the_file() {
    if !has("valgrind", "valgrind") {
        return;
    }
    let folder = folder();
    let all = REPEATED.into_iter().flat_map(|(name, repeated)| LINES.map(|line| (name, repeated, line)));
    // each takes seconds
    for (name, repeated, line) in sample(all).into_iter().step_by(20) {
        let [one, two] = [4_000, 32_000].map(|bytes| {
            repeat(folder.path(), repeated, bytes);
            instructions(folder.path(), line)
        });
        // quadratic growth is 64 times as much
        assert!(two < 12 * one + 20_000_000, "{line}: {name}: {one}, {two}");
    }
}

/// Each option of `check` is above, but for those that give other inputs or only change words.
#[test]
fn every_option_of_check_is_run() {
    const OTHERS: [&str; 11] = [
        "color",
        "device",
        "from",
        "help",
        "max-entries",
        "max-size",
        "patch",
        "quiet",
        "since",
        "variant",
        "verbose",
    ];
    let output = Command::new(crate::program()).args(["check", "--help"]).output().unwrap();
    let help = String::from_utf8(output.stdout).unwrap();
    let options = help
        .lines()
        .filter_map(|line| line.trim_start().split_once("--").filter(|(before, _)| before.len() <= 4));
    let names = options.map(|(_, rest)| rest.split([' ', '=', '[']).next().unwrap());
    let is_run = |name: &&str| {
        OTHERS.contains(name) || LINES.iter().chain(&FIXING).any(|line| line.contains(&format!("--{name}")))
    };
    let missing: Vec<&str> = names.filter(|name| !is_run(name)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
