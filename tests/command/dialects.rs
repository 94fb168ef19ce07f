//! Files for other readers: dialects, nodes without node-ID, and what only objdict reads.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)
}

fn objdict(folder: &Path, line: &str) -> Output {
    let mut command = Command::new(crate::program());
    command.args(line.split_whitespace()).current_dir(folder).output().unwrap()
}

/// What a successful command prints.
fn done(folder: &Path, line: &str) -> String {
    let output = objdict(folder, line);
    assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// A DCF whose `[DeviceComissioning]` has neither node-ID nor bit rate.
const UNNUMBERED: &str = "[DeviceComissioning]\r\nNodeName=Pump\r\n";

#[test]
fn a_dcf_without_node_id_is_written() {
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path();
    let eds = fs::read_to_string(fixture("eds/minimal.eds")).unwrap();
    fs::write(folder.join("a.dcf"), format!("{eds}\r\n{UNNUMBERED}")).unwrap();
    assert_eq!(objdict(folder, "convert a.dcf -o a.xdc").status.code(), Some(2), "an XDC states a node-ID");
    done(folder, "convert a.dcf -o a.json");
    done(folder, "convert a.json -o c.dcf");
    done(folder, "convert a.dcf --canonical -o d.dcf");
    for name in ["c.dcf", "d.dcf"] {
        let text = read(folder, name);
        assert!(text.contains("NodeName=Pump") && !text.contains("NodeID="), "{name}: {text}");
        assert!(!text.contains("Baudrate="), "{name}: {text}");
    }
    let refused = objdict(folder, "convert c.dcf -o b.eds");
    assert!(refused.status.success());
    assert_eq!(objdict(folder, "convert b.eds -o e.dcf").status.code(), Some(2), "an EDS has no node");
}

/// Commands about a node on a bus of CANopen refuse a device that has none.
#[test]
fn a_device_of_ethercat_is_no_node() {
    let temporary = tempfile::tempdir().unwrap();
    let esi = fixture("esi/press.xml");
    for rest in
        ["configure ESI --node-id 3 -o a.dcf", "conformance ESI", "convert ESI -o a.dcf", "probe ESI -o p.py"]
    {
        let line = format!("{} --device 1", rest.replace("ESI", &esi.display().to_string()));
        let refused = objdict(temporary.path(), &line);
        let said = String::from_utf8_lossy(&refused.stderr);
        assert!(said.contains("an EtherCAT device, not a CANopen node"), "{rest}: {said}");
        assert_eq!(refused.status.code(), Some(2), "{rest}");
    }
    assert_eq!(fs::read_dir(temporary.path()).unwrap().count(), 0);
}

#[test]
fn dialects_are_judged_like_other_files() {
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path();
    for name in ["xdd/press-402.xdd", "xdd/all-types.xdd", "eds/coupler-modular.eds", "eds/manager-302.eds"] {
        let source = fixture(name);
        let line = |rest: &str| format!("{} {rest}", source.display());
        for (dialect, tool) in [("lely", "dcf-tools"), ("python-canopen", "python-canopen")] {
            done(
                folder,
                &format!("convert {}", line(&format!("-o a.eds --keep-disabled --dialect {dialect}"))),
            );
            let report = objdict(folder, &format!("check a.eds --compat {tool} --format concise"));
            let report = String::from_utf8(report.stdout).unwrap();
            let refused = report.lines().filter(|line| line.contains("the file is rejected"));
            assert_eq!(refused.collect::<Vec<_>>(), [""; 0], "{name} {dialect}");
            // nothing is lost for objdict
            done(folder, &format!("convert {}", line("-o before.json")));
            done(folder, "convert a.eds -o after.json");
            let without_name =
                |text: String| text.lines().filter(|line| !line.contains("file_name")).collect::<String>();
            assert_eq!(
                without_name(read(folder, "after.json")),
                without_name(read(folder, "before.json")),
                "{name} {dialect}"
            );
        }
    }
}

#[test]
fn fixes_and_formatting_take_a_dialect() {
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path();
    let eds = fs::read_to_string(fixture("eds/minimal.eds")).unwrap();
    let bad =
        format!("{eds}\r\n; objdict-embed: /identity/instance_name=\"x\"\r\n").replace("Dummy0001=0\r\n", "");
    for command in ["fmt a.eds --dialect python-canopen", "check a.eds --fix --dialect python-canopen"] {
        fs::write(folder.join("a.eds"), &bad).unwrap();
        objdict(folder, command);
        let text = read(folder, "a.eds");
        assert!(text.contains("Dummy0001=0"), "{command}: {text}");
        assert!(text.contains("; objdict-embed: /identity"), "{command}: {text}");
    }
    fs::write(folder.join("a.eds"), &eds).unwrap();
    done(folder, "configure a.eds --node-id 5 --bit-rate 125 --dialect lely -o a.dcf");
    assert!(read(folder, "a.dcf").contains("NodeID=5\r\n"));
}

#[test]
fn the_direction_of_a_mapping_is_in_the_access_type() {
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path();
    done(folder, &format!("convert {} -o a.json", fixture("eds/minimal.eds").display()));
    let json = read(folder, "a.json").replacen(
        "\"access\": \"rw\"",
        "\"access\": \"rw\", \"pdo_mapping\": \"tpdo\"",
        1,
    );
    let at = json.find("\"pdo_mapping\": \"tpdo\"").unwrap() + 30;
    let rest = json[at..].replacen("\"pdo_mapping\": \"no\",", "", 1);
    fs::write(folder.join("a.json"), format!("{}{rest}", &json[..at])).unwrap();
    done(folder, "convert a.json -o a.eds");
    let text = read(folder, "a.eds");
    assert!(text.contains("AccessType=rwr"), "{text}");
    assert!(done(folder, "show a.eds --format json").contains("\"pdo_mapping\":\"tpdo\""));
}

#[test]
fn invalid_texts_are_shown_as_json() {
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path();
    let eds = fs::read_to_string(fixture("eds/minimal.eds")).unwrap();
    fs::write(folder.join("a.eds"), eds.replace("DefaultValue=0x00000000", "DefaultValue=zero")).unwrap();
    let shown = done(folder, "show a.eds --format json");
    assert!(shown.contains("\"invalid_values\":{\"DefaultValue\":\"zero\"}"), "{shown}");
}
