//! The script of a plan against a LocalNode of python-canopen, on its virtual bus, and on one of the kernel where there is one.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::model::Device;
use objdict::probe::{Exchange, Judgement, judge, read_answers};

use super::planted::{self, Difference};
use super::{NODE, device, found, plan};
use crate::interop::environment;
use crate::support;

fn judged(python: &Path, name: &str, write: bool, how: &[&str]) -> Judgement {
    let (device, exchanges) = asked(python, name, write, how);
    judge(&device, NODE, &exchanges)
}

/// The answers that the script wrote as CSV, which are those of its JSON and, but for a scan, of the recorded log.
fn asked(python: &Path, name: &str, write: bool, how: &[&str]) -> (Device, Vec<Exchange>) {
    let device = device(name);
    let folder = folder();
    let output = folder.join(format!("{}-{write}-{}", name.replace('/', "-"), how.concat().len()));
    let script = output.with_extension("py");
    fs::write(&script, plan(&device, write).script()).unwrap();
    let node = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/probe/local_node.py");
    let mut command = Command::new(python.join("python"));
    command
        .arg("-W")
        .arg("error")
        .arg(node)
        .arg(&script)
        .arg(support::fixtures().join(name))
        .arg(&output)
        .args(how);
    let run = command.output().unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let read = |ending| fs::read_to_string(format!("{}.{ending}", output.display())).unwrap();
    let exchanges = read_answers(&read("csv")).unwrap();
    assert_eq!(read_answers(&read("json")).unwrap(), exchanges);
    if !how.contains(&"--scan") {
        super::assert_recorded(&read("log"), &exchanges);
    }
    (device, exchanges)
}

fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("probe");
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn a_local_node_of_python_canopen_is_as_described() {
    let Some(python) = environment() else { return };
    // python-canopen does not know all types of all-types.eds
    for name in [
        "eds/drive-402.eds",
        "eds/io-401.eds",
        "eds/encoder-406.eds",
        "eds/cs5525-404.eds",
        "eds/bootloader.eds",
        "eds/dspic-sensors.eds",
    ] {
        let judgement = judged(python, name, false, &[]);
        assert_eq!(found(&judgement), BTreeSet::new(), "{name}");
        assert!(judgement.unasked.is_empty());
    }
    for name in ["eds/drive-402.eds", "eds/encoder-406.eds"] {
        let judgement = judged(python, name, true, &["--checked"]);
        assert_eq!(found(&judgement), BTreeSet::new(), "{name}");
    }
}

#[test]
fn planted_differences_of_a_local_node_are_found_and_nothing_else() {
    let Some(python) = environment() else { return };
    let planted = planted::all();
    let differences = folder().join("differences.json");
    let rows: Vec<_> = planted.iter().map(Difference::json).collect();
    fs::write(&differences, serde_json::to_string(&rows).unwrap()).unwrap();
    let judgement = judged(python, planted::FIXTURE, true, &[differences.to_str().unwrap()]);
    assert_eq!(found(&judgement), planted.iter().flat_map(Difference::expected).collect());
}

/// The dictionary of a device that is not known: its description is that of its answers.
#[test]
fn an_unknown_local_node_is_scanned() {
    let Some(python) = environment() else { return };
    let (_, exchanges) = asked(python, "eds/encoder-406.eds", false, &["--checked", "--scan"]);
    let learned = super::learned(&exchanges);
    let known = device("eds/encoder-406.eds");
    let indexes =
        |device: &Device| device.objects.keys().copied().filter(|index| *index >= 0x1000).collect::<Vec<_>>();
    assert_eq!(indexes(learned.device()), indexes(&known));
    assert_eq!(found(&judge(&known, NODE, &exchanges)), BTreeSet::new());
}

/// The same on a virtual bus of the kernel: `ip link add dev vcan0 type vcan && ip link set up vcan0`.
#[test]
fn a_local_node_on_socketcan_is_as_described() {
    let Some(python) = environment() else { return };
    if !Path::new("/sys/class/net/vcan0").exists() {
        support::skips::skip("there is no vcan0: the script does not run on SocketCAN");
        return;
    }
    let judgement = judged(python, planted::FIXTURE, true, &["--checked", "--socketcan"]);
    assert_eq!(found(&judgement), BTreeSet::new());
}
