//! What the command writes is valid by the schemas that it prints; a validator of others says so.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{environment, text_of};
use crate::support;

/// Documents, and the commands that write them: `FIXTURES` is their folder, and what is not printed is written to `OUT`.
const DOCUMENTS: &[(&str, &str)] = &[
    ("findings", "check FIXTURES --no-config --format json --statistics --all"),
    ("findings", "check FIXTURES/broken FIXTURES/rules/portability --no-config --format json"),
    ("findings", "check FIXTURES/eds --no-config --format json --statistics=only"),
    ("findings", "check FIXTURES/eds/minimal.eds --no-config --format json"),
    ("findings", "network check FIXTURES/network/cell.yml --format json"),
    ("findings", "network check FIXTURES/rules/network/link-mismatch/bad.toml --format json"),
    (
        "findings",
        "probe FIXTURES/eds/drive-402.eds --node-id 5 --answers FIXTURES/probe/drive-402.csv --format json",
    ),
    ("baseline", "check FIXTURES/broken --no-config --quiet --write-baseline OUT"),
    ("identify", "identify IDENTIFIED --format json"),
    ("conformance", "conformance FIXTURES/eds/io-401.eds --format json"),
    ("conformance", "conformance FIXTURES/eds/bootloader.eds --format json"),
    (
        "frame",
        "decode FIXTURES/logs/chapter4.log --with FIXTURES/network/chapter4.toml --kind time --format json",
    ),
    (
        "frame",
        "decode FIXTURES/logs/chapter4.log --kind sdo --object 6200:10 --to 1436509052.77 --format json",
    ),
    (
        "frame",
        "decode FIXTURES/logs/chapter4.log --with FIXTURES/network/chapter4.toml --object 5410:1 --format json",
    ),
    (
        "traffic",
        "decode FIXTURES/logs/chapter4.log --with FIXTURES/network/chapter4.toml --summary --format json",
    ),
    ("traffic", "decode FIXTURES/logs/drive.asc --summary --format json"),
    ("changes", "diff FIXTURES/bases/drive.eds FIXTURES/diff/drive-2.eds --format json"),
    ("changes", "diff FIXTURES/eds/drive-402.eds FIXTURES/xdd/valve.xdd --format json"),
    ("changes", "diff FIXTURES/eds/minimal.eds FIXTURES/eds/minimal.eds --format json"),
    ("entries", "show FIXTURES/eds/all-types.eds --format json"),
    ("entries", "show FIXTURES/torture/22_default_overflow.eds --format json"),
    ("entries", "show FIXTURES/dcf/encoder-406-node3.dcf --format json"),
    ("entries", "show FIXTURES/xdd/drive-402.xdd --node-id 3 --format json"),
    ("entries", "show DOWNLOADS --format json"),
    ("node-list", "show FIXTURES/nodelist/line.cpj --format json"),
    ("concise-dcf", "convert FIXTURES/concise/careless.cdcf --to json"),
    ("concise-dcf", "show FIXTURES/concise/careless.cdcf --format json"),
    ("modules", "modules FIXTURES/eds/coupler-modular.eds --format json"),
    ("modules", "modules FIXTURES/dcf/coupler-modular-node10.dcf --format json"),
    ("losses", "convert FIXTURES/xdd/press-402.xdd -o WRITTEN.eds --no-embed --loss-report OUT"),
    ("losses", "convert FIXTURES/dcf/coupler-modular-node10.dcf -o WRITTEN.xdd --loss-report OUT"),
    ("losses", "convert FIXTURES/dcf/encoder-406-node3.dcf -o WRITTEN.dbc --loss-report OUT"),
    (
        "sizes",
        "generate FIXTURES/eds/all-types.eds --target rust,c,canopennode,lely,concise --node-id 5 --force -o WRITTEN --report size --format json",
    ),
    (
        "tables",
        "generate FIXTURES/eds/minimal.eds --target canopennode --compare FIXTURES/canopennode --format json",
    ),
    ("variants", "variants FIXTURES/toml/family.toml --format json"),
    ("network", "network show FIXTURES/network/cell.yml --format json"),
    ("network", "network show FIXTURES/network/line.toml --format json"),
    (
        "network",
        "network show FIXTURES/dcf/io-401-node5.dcf FIXTURES/dcf/encoder-406-node3.dcf --format json",
    ),
    ("boot", "network boot FIXTURES/network/line.toml --format json"),
    ("boot", "network boot FIXTURES/network/cell.yml --format json --summary"),
    ("timing", "network timing FIXTURES/network/chapter4.toml --format json"),
    ("timing", "network timing FIXTURES/rules/network/late-message/bad.yml --format json"),
    (
        "verify",
        "dcf verify FIXTURES/concise/careless.cdcf --eds FIXTURES/eds/io-401.eds --node-id 5 --format json",
    ),
    ("verify", "dcf verify FIXTURES/concise/careless.cdcf --eds FIXTURES/eds/io-401.eds --format json"),
    ("profiles", "profile list --format json"),
    ("profile", "profile show 301 --format json"),
    ("profile", "profile show 401 --format json"),
    ("profile", "profile show 402 --format json"),
    ("profile", "profile show FIXTURES/profiles/project-drives.toml --format json"),
    ("rules", "rules --format json"),
    ("bus-scan", "bus scan --bus sim:FIXTURES/bus/cell.toml --with FIXTURES/eds/drive-402.eds --format json"),
    (
        "bus-values",
        "bus read 5 1017 1018 --bus sim:FIXTURES/bus/cell.toml --with FIXTURES/eds/drive-402.eds --format json",
    ),
    (
        "bus-writes",
        "bus write 5 1017=250 --yes --bus sim:FIXTURES/bus/cell.toml --with FIXTURES/eds/drive-402.eds --format json",
    ),
    ("bus-comparison", "bus compare FIXTURES/bus/cell.toml --bus sim:FIXTURES/bus/cell.toml --format json"),
    ("bus-command", "bus restore 5 --yes --bus sim:FIXTURES/bus/cell.toml --format json"),
    ("bus-command", "bus nmt stop 5 --yes --bus sim:FIXTURES/bus/cell.toml --format json"),
    (
        "bus-command",
        "bus lss assign 9 --bit-rate 250 --yes --alone --bus sim:FIXTURES/bus/cell.toml,new=5 --format json",
    ),
    (
        "bus-writes",
        "bus replace 5 FIXTURES/bus/cell.toml --yes --alone --bus sim:FIXTURES/bus/cell.toml,new=5 --format json",
    ),
    ("bus-lss", "bus lss scan --bus sim:FIXTURES/bus/cell.toml,new=5 --alone --format json"),
    ("bus-lss-plan", "bus lss plan FIXTURES/bus/cell.toml --format json"),
];

/// Ordered downloads in a DCF.
const DOWNLOADS: &str = "; objdict-embed: /downloads=[{\"when\":\"before\",\"index\":\"0x1017\",\"sub\":\"0x00\",\"value\":{\"unsigned\":5}}]\r\n";

fn objdict() -> Command {
    Command::new(env!("CARGO_BIN_EXE_objdict"))
}

#[test]
fn documents_are_valid_by_their_schemas() {
    let Some(programs) = environment() else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-schemas");
    fs::remove_dir_all(&folder).ok();
    fs::create_dir_all(folder.join("device-json")).unwrap();
    let fixtures = support::fixtures();
    let list = objdict().arg("schema").output().unwrap();
    let list = String::from_utf8(list.stdout).unwrap();
    let names = list.lines().skip(1).filter_map(|line| line.split_whitespace().next());
    // people and benches write them; other tests look at those
    let names: Vec<&str> = names.filter(|name| !["device", "patch", "answers"].contains(name)).collect();
    for name in &names {
        let schema = objdict().args(["schema", name]).output().unwrap();
        assert!(schema.status.success(), "{}", text_of(&schema));
        fs::write(folder.join(format!("{name}.schema.json")), schema.stdout).unwrap();
    }
    write_devices(&folder);
    let downloads = folder.join("inputs/downloads.dcf");
    let identified = support::files("", &["eds", "dcf", "xdd", "xdc", "yml", "toml", "cdcf", "cpj", "txt"]);
    for (number, (name, line)) in DOCUMENTS.iter().enumerate() {
        assert!(names.contains(name), "{name}");
        let path = folder.join(format!("{name}.{number}.json"));
        let mut command = objdict();
        for word in line.split_whitespace() {
            match word {
                "OUT" => command.arg(&path),
                "IDENTIFIED" => command.args(&identified),
                "DOWNLOADS" => command.arg(&downloads),
                word => command.arg(
                    word.replace("FIXTURES", &fixtures.display().to_string())
                        .replace("WRITTEN", &folder.join("written").display().to_string()),
                ),
            };
        }
        let output = command.output().unwrap();
        assert_ne!(output.status.code(), Some(2), "{line}: {}", text_of(&output));
        if !path.exists() {
            fs::write(path, output.stdout).unwrap();
        }
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/documents.py");
    let output = Command::new(programs.join("python")).arg(script).arg(&folder).output().unwrap();
    assert!(output.status.success() && output.stdout.is_empty(), "{}", text_of(&output));
}

/// All descriptions that the command converts, by one call: under names of their own in one folder.
fn write_devices(folder: &Path) {
    let inputs = folder.join("inputs");
    fs::create_dir_all(&inputs).unwrap();
    let mut copies: Vec<PathBuf> = Vec::new();
    for (number, path) in support::files("", &["eds", "dcf", "xdd", "xdc"]).iter().enumerate() {
        let name = path.file_name().unwrap().to_string_lossy();
        copies.push(inputs.join(format!("{number}-{name}")));
        fs::copy(path, copies.last().unwrap()).unwrap();
    }
    let node = fs::read_to_string(support::fixtures().join("dcf/encoder-406-node3.dcf")).unwrap();
    copies.push(inputs.join("downloads.dcf"));
    fs::write(&copies[copies.len() - 1], node + DOWNLOADS).unwrap();
    let output = objdict()
        .args(["convert", "--quiet", "--to", "json", "-o"])
        .arg(folder.join("device-json"))
        .args(&copies)
        .output()
        .unwrap();
    let written = fs::read_dir(folder.join("device-json")).unwrap().count();
    // some fixtures are of other technologies, or are refused
    assert!(written > copies.len() * 9 / 10, "{written} of {}: {}", copies.len(), text_of(&output));
}

/// The sources that are written by hand, and those that a sample of the fixtures becomes: the reader, which is as strict as the
/// schema about keys, reads that of every healthy device in `device_toml`.
#[test]
fn sources_of_devices_are_valid_by_their_schema() {
    let Some(programs) = environment() else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-sources");
    fs::remove_dir_all(&folder).ok();
    fs::create_dir_all(&folder).unwrap();
    let schema = folder.join("device.json");
    fs::write(&schema, objdict::format::device_schema().to_string()).unwrap();
    let mut files = support::files("toml", &["toml"]);
    let fixtures = support::skips::sample(support::files("", &["eds", "dcf", "xdd", "xdc"]));
    for (number, file) in fixtures.into_iter().enumerate() {
        let Ok(description) = objdict::format::open(&file, &Default::default()) else { continue };
        let options = objdict::format::WriteOptions::default();
        let written = objdict::format::write(description.device(), objdict::format::Format::Toml, &options);
        let path = folder.join(format!("{number}.toml"));
        fs::write(&path, written.unwrap().bytes).unwrap();
        files.push(path);
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/validate.py");
    let output = Command::new(programs.join("python"))
        .arg(script)
        .args([&schema, &schema, &schema])
        .args(&files)
        .output()
        .unwrap();
    assert!(output.status.success() && output.stdout.is_empty(), "{}", text_of(&output));
}
