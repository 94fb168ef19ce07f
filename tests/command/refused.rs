//! A source that its author writes for objdict and that has an error is refused by every command that uses it, with the error that
//! `check` reports first, and nothing is written.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use tempfile::TempDir;

use crate::support;

/// What uses a device; `SOURCE` is its file, `NETWORK` a network of it.
const OF_DEVICE: [&str; 18] = [
    "convert SOURCE -o out.eds",
    "convert SOURCE -o out.xdd",
    "convert SOURCE -o out.json",
    "convert SOURCE -o out.dbc --node-id 5",
    "generate SOURCE --target c -o out",
    "generate SOURCE --target rust -o out",
    "docs SOURCE -o out",
    "show SOURCE",
    "dcf pack SOURCE -o out.cdcf --node-id 5",
    "configure SOURCE -o out.dcf --node-id 5",
    "diff SOURCE good.toml",
    "diff good.toml SOURCE",
    "release good.toml SOURCE",
    "conformance SOURCE",
    "probe SOURCE --answers node.log",
    "decode node.log --with 5=SOURCE",
    "network show NETWORK",
    "network build NETWORK --target dcf -o out --force",
];

/// What uses a network.
const OF_NETWORK: [&str; 11] = [
    "network show SOURCE",
    "network graph SOURCE",
    "network timing SOURCE",
    "network boot SOURCE",
    "network build SOURCE --target lely -o out",
    "network build SOURCE --target dcf -o out --force",
    "diff servo.eds servo.eds --against SOURCE",
    "network diff SOURCE good.toml",
    "network diff good.toml SOURCE",
    "convert SOURCE -o out.dbc",
    "docs SOURCE -o out",
];

fn run(folder: &Path, line: &str) -> Output {
    Command::new(crate::program()).args(line.split_whitespace()).current_dir(folder).output().unwrap()
}

/// The rule of the first error of a check, in the order of the report.
fn first_error(report: &Output) -> Option<String> {
    let text = String::from_utf8_lossy(&report.stdout).into_owned();
    let line = text.lines().find(|line| line.contains(": error "))?;
    Some(line.split(": error ").nth(1)?.split(':').next()?.to_owned())
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// The commands that do something with a source in which `rule` finds an error, or do not say so.
fn lenient(folder: &Path, commands: &[&str], rule: &str) -> Vec<String> {
    let before = names(folder);
    let mut lenient = Vec::new();
    for command in commands {
        let line = command.replace("SOURCE", "bad.toml").replace("NETWORK", "of-bad.toml");
        let output = run(folder, &line);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        let is_refused = matches!(output.status.code(), Some(1 | 2));
        let is_named = told.contains(rule) || command.contains("NETWORK") || command.contains("decode");
        if !is_refused || !is_named || names(folder) != before {
            lenient.push(format!("`{line}` exits with {:?}: {told}", output.status.code()));
        }
    }
    lenient
}

/// A folder with a device, a network of it, and a log.
fn folder(good: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("good.toml"), good).unwrap();
    let network = "[bus]\nbit-rate = 250\nmanager = \"plc\"\n\n[manager]\nid = 1\n\n[node.a]\nfile = \"bad.toml\"\nid = 5\n";
    fs::write(folder.path().join("of-bad.toml"), network).unwrap();
    fs::write(
        folder.path().join("node.log"),
        "(1.0) can0 605#4000100000000000\n(1.1) can0 585#4300100092010200\n",
    )
    .unwrap();
    folder
}

/// The text with each of its keys misspelled, and with each of its values as another kind of value.
fn faults(text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    for (at, _) in text.match_indices(" = ") {
        faults.push(format!("{}xq{}", &text[..at], &text[at..]));
        let rest = &text[at + 3..];
        let end = rest.find(['\n', ',', '}']).unwrap_or(rest.len());
        if !rest[..end].contains(['[', '{', '(']) {
            faults.push(format!("{}{{ a = 1 }}{}", &text[..at + 3], &rest[end..]));
        }
    }
    faults
}

/// Tries each fault of the text; those that `check` accepts are none.
fn refuses(good: &str, check: &str, commands: &[&str]) {
    let folder = folder(good);
    for name in ["island.eds", "servo.eds"] {
        fs::copy(Path::new("fixtures/network").join(name), folder.path().join(name)).unwrap();
    }
    let mut tried = 0;
    for fault in support::skips::sample(faults(good)) {
        fs::write(folder.path().join("bad.toml"), &fault).unwrap();
        let report = run(folder.path(), check);
        let Some(rule) = first_error(&report) else { continue };
        assert_eq!(report.status.code(), Some(1), "{fault}");
        let lenient = lenient(folder.path(), commands, &rule);
        assert!(lenient.is_empty(), "{rule}: {lenient:#?}\n{fault}");
        tried += 1;
    }
    assert!(tried > 8, "{tried} faults");
}

#[test]
fn a_device_with_an_error_is_refused_by_every_command() {
    let good = fs::read_to_string("fixtures/toml/io.toml").unwrap();
    refuses(&good, "check bad.toml --format concise", &OF_DEVICE);
}

/// Its author can correct it, or accept it in `objdict.toml`.
#[test]
fn a_device_in_which_a_rule_finds_an_error_is_refused_too() {
    let good = fs::read_to_string("fixtures/toml/io.toml").unwrap();
    let folder = folder(&good);
    let object = "\n[object.5F00]\nname = \"Level\"\ntype = \"u8\"\ndefault = 9\nmax = 5\n";
    fs::write(folder.path().join("bad.toml"), good + object).unwrap();
    let report = run(folder.path(), "check bad.toml --format concise");
    let rule = first_error(&report).unwrap();
    assert!(!rule.starts_with("keys/"), "{rule}");
    let makes = OF_DEVICE.into_iter().filter(|command| *command != "show SOURCE");
    assert_eq!(lenient(folder.path(), &makes.collect::<Vec<_>>(), &rule), [""; 0]);
    assert!(run(folder.path(), "show bad.toml").status.success());
    fs::write(folder.path().join("objdict.toml"), format!("[rules]\n{rule:?} = \"warning\"\n")).unwrap();
    for accepted in ["convert bad.toml -o out.eds", "conformance bad.toml", "network show of-bad.toml"] {
        assert!(run(folder.path(), accepted).status.success(), "{accepted}");
        let output = run(folder.path(), &format!("{accepted} --no-config"));
        assert!(accepted.starts_with("conf") || !output.status.success(), "{accepted} --no-config");
    }
}

#[test]
fn a_network_with_an_error_in_its_text_is_refused_by_every_command() {
    let good = fs::read_to_string("fixtures/network/line.toml").unwrap();
    refuses(&good, "network check bad.toml --format concise", &OF_NETWORK);
}

/// What `check` finds in a folder are the sources too; what another command checks is counted, and files of others are passed over.
#[test]
fn a_folder_is_checked_with_its_sources() {
    let folder = folder(&fs::read_to_string("fixtures/toml/io.toml").unwrap());
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    fs::copy("fixtures/eds/minimal.eds", folder.path().join("minimal.eds")).unwrap();
    fs::copy("fixtures/network/cell.yml", folder.path().join("bus.yml")).unwrap();
    fs::copy("fixtures/patches/io-401.patch.toml", folder.path().join("io-401.patch.toml")).unwrap();
    write("Cargo.toml", "[package]\nname = \"firmware\"\n");
    write("compose.yml", "services:\n  web:\n    image: a\n");
    let clean = run(folder.path(), "check");
    let told = String::from_utf8_lossy(&clean.stdout).into_owned();
    assert_eq!((clean.status.code(), told.trim()), (Some(0), "no findings in 2 files"));
    let told = String::from_utf8_lossy(&clean.stderr).into_owned();
    assert!(told.contains("note: 3 files describe no CANopen device and were not checked"), "{told}");
    assert!(told.contains("`objdict network check`") && told.contains("`objdict patch check`"), "{told}");
    // projects are known by their content
    write("build.xml", "<project><target/></project>\n");
    fs::copy("fixtures/xdd/press-402.xdd", folder.path().join("press.xpd")).unwrap();
    for node in ["a", "b"] {
        let line = format!("convert minimal.eds -o {node}.dcf --node-id 3 --bit-rate 125");
        assert_eq!(run(folder.path(), &line).status.code(), Some(0));
    }
    let more = run(folder.path(), "check");
    let files = String::from_utf8_lossy(&more.stdout).into_owned();
    assert!(files.contains("of 5 files"), "{files}");
    let told = String::from_utf8_lossy(&more.stderr).into_owned();
    assert!(told.contains("2 DCFs are checked one by one") && told.contains("network check *.dcf"), "{told}");
    write("bad.toml", "format = \"objdict-device/1\"\nprofil = \"301@1\"\n");
    let report = run(folder.path(), "check --format concise");
    assert_eq!((report.status.code(), first_error(&report).as_deref()), (Some(1), Some("keys/unknown-key")));
    let network = run(folder.path(), "check of-bad.toml");
    assert_eq!(network.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&network.stderr).contains("`objdict network check` checks it"));
}

/// A configuration that cannot be used, or a profile that it names: every command refuses it with the reason, and writes nothing.
#[test]
fn a_configuration_is_refused_with_its_cause() {
    let folder = folder(&fs::read_to_string("fixtures/toml/io.toml").unwrap());
    fs::copy("fixtures/eds/minimal.eds", folder.path().join("minimal.eds")).unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("profile.toml", "format = \"objdict-profile/1\"\nfoo = 1\n");
    let of_config = [
        ("compat = [\"foo\"]\n", "unknown tool `foo`"),
        ("profiles = [\"profile.toml\"]\n", "unknown field `foo`"),
        ("deny = \"warning\n", "invalid basic string"),
    ];
    for (text, cause) in of_config {
        write("objdict.toml", text);
        for line in [
            "show minimal.eds",
            "docs minimal.eds -o out.html",
            "convert minimal.eds -o out.xdd",
            "patch check",
        ] {
            let output = run(folder.path(), line);
            let told = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(output.status.code() == Some(2) && told.contains(cause), "{line}: {told}");
        }
        assert!(!names(folder.path()).iter().any(|name| name.starts_with("out.")), "{text}");
    }
}
