//! The command as its users see it: the sessions in `tests/cli/*.md` and on the pages of the documentation are run, and
//! what they print is compared.
#![cfg(feature = "cli")]

use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn sessions() {
    trycmd::TestCases::new().env("NO_COLOR", "1").case("tests/cli/*.md").case("docs/json.md");
}

fn objdict() -> Command {
    Command::new(env!("CARGO_BIN_EXE_objdict"))
}

/// A reader that goes away, as `head` does, is no error.
#[test]
fn a_closed_pipe_is_no_failure() {
    let files: Vec<&str> = std::iter::repeat_n("fixtures/broken/octal.eds", 200).collect();
    let mut child = objdict()
        .arg("check")
        .args(files)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    let mut first = [0; 10];
    child.stdout.take().expect("a pipe").read_exact(&mut first).expect("ten bytes");
    // the pipe is closed here: `take` moved its end into a temporary that is gone
    let output = child.wait_with_output().expect("the command ends");
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Findings are data for JSON readers whatever the file: the document parses, and has the same findings as the text.
#[test]
fn json_of_every_broken_file_parses() {
    for entry in std::fs::read_dir("fixtures/broken").expect("the fixtures") {
        let path = entry.expect("a file").path();
        if path.extension().is_none_or(|ending| ending == "md") {
            continue;
        }
        let output = objdict().args(["check", "--format", "json"]).arg(&path).output().expect("it runs");
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let findings = document["findings"].as_array().expect("a list");
        let denied = findings.iter().any(|finding| finding["severity"] != "note");
        assert_eq!(output.status.code(), Some(i32::from(denied)), "{}", path.display());
        for finding in findings {
            for field in ["file", "rule", "message"] {
                assert!(finding[field].as_str().is_some_and(|text| !text.is_empty()), "{field}: {finding}");
            }
            let position = |line, column| (finding[line].as_u64(), finding[column].as_u64());
            assert!(position("line", "column") <= position("end_line", "end_column"), "{finding}");
        }
    }
}
