//! protobuf of PyPI reads the projects of CANopenEditor that are written, and writes what is read as the same device.

use std::fs;
use std::path::Path;
use std::process::Command;

use objdict::format::canopeneditor;

use super::{devices, environment, text_of};

#[test]
fn protobuf_reads_the_projects_that_we_write() {
    let Some(programs) = environment() else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("canopeneditor-json");
    fs::remove_dir_all(&folder).ok();
    fs::create_dir_all(&folder).unwrap();
    let devices = devices();
    let mut expected = Vec::new();
    for (name, description) in &devices {
        let device = description.described().expanded();
        let written = canopeneditor::write(&device, 100_000).unwrap();
        fs::write(folder.join(format!("{name}.json")), written.bytes).unwrap();
        let subs: usize = device.objects.values().map(|object| object.stated().count()).sum();
        expected.push(format!("{name}.json {} {subs}", device.objects.len()));
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/interop/canopeneditor.py");
    let output = Command::new(programs.join("python")).arg(script).arg(&folder).output().unwrap();
    let text = text_of(&output);
    assert!(output.status.success(), "{text}");
    expected.sort();
    let mut lines: Vec<&str> = text.lines().collect();
    lines.sort_unstable();
    assert_eq!(lines, expected);
    for (name, _) in &devices {
        let read = |ending: &str| {
            let text = fs::read_to_string(folder.join(format!("{name}{ending}"))).unwrap();
            canopeneditor::read(&text).unwrap()
        };
        assert_eq!(read(".json"), read(".again.json"), "{name}");
    }
}
