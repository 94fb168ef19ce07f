//! Logs that python-can writes are read as python-can reads them.

use std::fs;
use std::io::BufReader;
use std::path::Path;
use std::process::Command;

use objdict::format::log::{LogForm, LogOptions, LogReader};
use serde_json::{Value, json};

use super::text_of;
use crate::support;

/// The frames of a log as the script has them, with times from the first frame on.
fn frames(path: &Path, form: LogForm) -> Vec<Value> {
    let source = BufReader::new(fs::File::open(path).unwrap());
    let mut reader = LogReader::new(source, LogOptions::default());
    let mut start = None;
    let mut rows = Vec::new();
    while let Some(frame) = reader.next_frame().unwrap() {
        let start = *start.get_or_insert(frame.time.nanoseconds());
        let time = ((frame.time.nanoseconds() - start) as f64 / 1e3).round() as i64;
        let data = if frame.is_error { &[] } else { frame.data() };
        let digits: String = data.iter().map(|byte| format!("{byte:02X}")).collect();
        let can_id = if frame.is_error { 0 } else { frame.can_id };
        rows.push(json!([time, can_id, frame.is_extended, frame.is_remote, frame.is_error, digits]));
    }
    assert_eq!((reader.form(), reader.bad_lines()), (Some(form), &[][..]), "{}", path.display());
    rows
}

#[test]
fn python_can_writes_what_is_read() {
    // apart from the others, because asammdf warns of the canmatrix that it uses
    let programs = support::python("logs-venv", &["asammdf==8.8.28", "python-can==4.6.1"]);
    let Some(programs) = support::unless_offline(programs) else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-logs");
    fs::create_dir_all(&folder).unwrap();
    let out = folder.join("read.json");
    let mut script = Command::new(programs.join("python"));
    script.args(["tests/library/interop/logs.py", "fixtures/logs/chapter4.log"]).arg(&out).arg(&folder);
    let output = script.output().unwrap();
    assert!(output.status.success(), "{}", text_of(&output));
    let expected: Value = serde_json::from_slice(&fs::read(out).unwrap()).unwrap();
    let forms = [
        ("log.asc", LogForm::Asc),
        ("log.blf", LogForm::Blf),
        ("log.mf4", LogForm::Mdf),
        ("log.trc", LogForm::Trc),
        ("log.csv", LogForm::Csv),
        ("log.log", LogForm::Candump),
    ];
    for (name, form) in forms {
        let (read, expected) = (frames(&folder.join(name), form), expected[name].as_array().unwrap());
        for (number, (read, expected)) in read.iter().zip(expected).enumerate() {
            assert_eq!(read, expected, "{name}, frame {number}");
        }
        assert_eq!((read.len(), read.len() > 300), (expected.len(), true), "{name}");
    }
}
