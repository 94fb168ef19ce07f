//! The command, the language server, a build script and the pages say the same about a file.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use objdict::build_script::{Builder, Error};
use objdict::diagnostic::Severity;
use objdict::generate::Target;
use serde_json::Value;

use crate::lsp::client::Client;
use crate::support::fixtures;

/// What is found, by rule and severity.
type Found = BTreeSet<(String, Severity)>;

const CONFIG: &str = "\
node-id = 9
deny = \"warning\"
[rules]
\"cia306/file-name\" = \"error\"
naming = \"off\"
";

const LAMP: &str = "\
format = \"objdict-device/1\"
profile = \"301@1\"

[device]
vendor-name = \"Acme\"
vendor-number = 1
product-name = \"Lamp\"

[object.2000]
name = \"Brightness\"
type = \"u8\"
default = 5

[variant.bright.object.2000]
default = 300
";

/// A folder with a file of each kind, each with an error that only one mechanism shows: the EDS beside a DCF, a variant, the
/// configuration, the reader.
fn write_all(client: &Client) -> Vec<&'static str> {
    let eds = fs::read_to_string(fixtures().join("eds/io-401.eds")).unwrap().replace("\r\n", "\n");
    let xdd = fs::read_to_string(fixtures().join("xdd/io-401.xdd")).unwrap();
    let of_node = eds.replace("[FileInfo]", "[FileInfo]\nLastEDS=io-401.eds");
    let commissioned = of_node
        + "\n[DeviceComissioning]\nNodeID=5\nNodeName=door\nBaudrate=250\nNetNumber=0\nNetworkName=\nCANopenManager=0\n";
    let of_other_type = commissioned.replacen("DataType=0x0007", "DataType=0x0006", 1);
    assert_ne!(of_other_type, commissioned, "the fixture has no UNSIGNED32");
    client.write("objdict.toml", CONFIG);
    client.write("io-401.eds", &eds);
    client.write("other-name.eds", eds.replacen("DataType=0x0005", "DataType=0x0099", 1));
    client.write("node.dcf", of_other_type);
    client.write("io-401.xdd", xdd.replacen("uniqueIDRef=\"UID_OBJ_1000\"", "uniqueIDRef=\"UID_NONE\"", 1));
    client.write("lamp.toml", LAMP);
    vec!["io-401.eds", "other-name.eds", "node.dcf", "io-401.xdd", "lamp.toml"]
}

fn severity(word: &str) -> Severity {
    match word {
        "error" => Severity::Error,
        "warning" => Severity::Warning,
        _ => Severity::Note,
    }
}

fn command(folder: &Path, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_objdict"));
    let output = command.args(arguments).current_dir(folder).output().unwrap();
    assert!(output.status.code().is_some_and(|code| code < 2), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn of_command(folder: &Path, file: &str) -> Found {
    let report: Value = serde_json::from_str(&command(folder, &["check", "--format", "json", file])).unwrap();
    assert_eq!(report["summary"]["files"], 1, "{file}");
    let findings = report["findings"].as_array().unwrap().iter();
    findings
        .map(|found| {
            (found["rule"].as_str().unwrap().to_owned(), severity(found["severity"].as_str().unwrap()))
        })
        .collect()
}

fn of_editor(client: &mut Client, file: &str) -> Found {
    let text = fs::read_to_string(client.path(file)).unwrap();
    let published = client.open(file, &text);
    let found = published.as_array().unwrap().iter();
    found
        .map(|found| {
            let severity = match found["severity"].as_u64() {
                Some(1) => Severity::Error,
                Some(2) => Severity::Warning,
                _ => Severity::Note,
            };
            (found["code"].as_str().unwrap().to_owned(), severity)
        })
        .collect()
}

/// What stops a build script that accepts no warning, without notes.
fn of_build_script(path: &Path) -> Found {
    let out = tempfile::tempdir().unwrap();
    let builder = Builder::new(path).target(Target::C).out_dir(out.path()).deny(Severity::Note);
    match builder.generate_to(&mut Vec::new()) {
        Err(Error::Findings { findings, .. }) => {
            findings.iter().map(|finding| (finding.rule.id.to_owned(), finding.severity)).collect()
        }
        Err(error) => panic!("{}: {error}", path.display()),
        Ok(_) => Found::new(),
    }
}

fn of_page(folder: &Path, file: &str, found: &Found) -> Found {
    let page = command(folder, &["docs", file, "-o", "-", "--to", "markdown"]);
    found.iter().filter(|(rule, _)| page.contains(&format!("`{rule}`"))).cloned().collect()
}

#[test]
fn a_build_script_runs_again_when_the_eds_of_a_node_changes() {
    let client = Client::start();
    write_all(&client);
    let out = tempfile::tempdir().unwrap();
    let mut cargo = Vec::new();
    let builder = Builder::new(client.path("node.dcf")).target(Target::C).out_dir(out.path()).force(true);
    builder.generate_to(&mut cargo).unwrap();
    let line = format!("cargo:rerun-if-changed={}\n", client.path("io-401.eds").display());
    let cargo = String::from_utf8(cargo).unwrap();
    assert!(cargo.contains(&line), "{cargo}");
}

/// Another variant's errors are not those of the product that is made.
#[test]
fn a_selected_variant_is_checked_alone() {
    let client = Client::start();
    client.write(
        "lamp.toml",
        LAMP.replace("variant.bright", "variant.dim.object.2000]\ndefault = 1\n\n[variant.bright"),
    );
    let found = |variant: &str| {
        let out = tempfile::tempdir().unwrap();
        let builder = Builder::new(client.path("lamp.toml")).variant(variant).deny(Severity::Error);
        match builder.target(Target::C).out_dir(out.path()).generate_to(&mut Vec::new()) {
            Err(Error::Findings { findings, .. }) => findings.iter().map(|finding| finding.rule.id).collect(),
            Err(error) => panic!("{error}"),
            Ok(_) => Vec::new(),
        }
    };
    assert_eq!(found("dim"), Vec::<&str>::new());
    assert_eq!(found("bright"), ["keys/wrong-type"]);
}

#[test]
fn every_door_leads_to_the_same_findings() {
    let mut client = Client::start();
    let files = write_all(&client);
    let folder = client.path("");
    for file in files {
        let found = of_command(&folder, file);
        let has_error = found.iter().any(|(_, severity)| *severity == Severity::Error);
        assert_eq!(has_error, file != "io-401.eds", "{file}: {found:?}");
        assert_eq!(of_editor(&mut client, file), found, "{file} in an editor");
        assert_eq!(of_build_script(&folder.join(file)), found, "{file} in a build script");
        // a page is about one device: the variant has one of its own
        let of_device: Found = found.iter().filter(|(rule, _)| !rule.starts_with("keys/")).cloned().collect();
        if file.ends_with(".toml") {
            // its author corrects it before there is a page
            let mut docs = Command::new(env!("CARGO_BIN_EXE_objdict"));
            let output = docs.args(["docs", file, "-o", "-"]).current_dir(&folder).output().unwrap();
            let told = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(output.status.code(), Some(2), "{told}");
            let errors = found.iter().filter(|(_, severity)| *severity == Severity::Error);
            assert!(
                errors.clone().count() > 0 && errors.clone().all(|(rule, _)| told.contains(rule)),
                "{told}"
            );
            continue;
        }
        assert_eq!(of_page(&folder, file, &of_device), of_device, "{file} on a page");
    }
}
