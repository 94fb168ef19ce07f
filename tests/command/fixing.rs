//! `--fix`, `--diff`, and what reports offer to fix.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

use crate::support;

fn objdict(folder: &Path, arguments: &str, input: &[u8]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_objdict"));
    command.args(arguments.split_whitespace()).current_dir(folder);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(input).unwrap();
    child.wait_with_output().unwrap()
}

#[test]
fn diff_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let fixtures =
        ["torture/15_octal.eds", "broken/orphan-sub.eds", "broken/mixed-eol.eds", "eds/minimal.eds"];
    let before = fixtures.map(|name| {
        let (bytes, file) =
            (fs::read(support::fixtures().join(name)).unwrap(), name.rsplit('/').next().unwrap());
        fs::write(folder.path().join(file), &bytes).unwrap();
        (file, bytes)
    });
    fs::copy(support::fixtures().join("foreign/powerlink.xdd"), folder.path().join("foreign.xdd")).unwrap();
    let octal = &before[0].1;
    for (arguments, code, headers) in [
        ("--fix --diff 15_octal.eds", 1, 1),
        ("--fix --diff minimal.eds", 0, 0),
        ("--fix --diff --jobs 2 15_octal.eds orphan-sub.eds mixed-eol.eds", 1, 1),
        ("--fix --unsafe-fixes --diff 15_octal.eds orphan-sub.eds mixed-eol.eds", 1, 3),
        ("--fix --diff 15_octal.eds no-such.eds", 2, 1),
        ("--fix --diff foreign.xdd 15_octal.eds", 2, 1),
        ("--fix --diff -", 1, 1),
        ("--fix -", 2, 0),
    ] {
        let output = objdict(folder.path(), &format!("check {arguments}"), octal);
        assert_eq!(output.status.code(), Some(code), "{arguments}");
        let shown = String::from_utf8(output.stdout).unwrap();
        assert_eq!(shown.lines().filter(|line| line.starts_with("+++ ")).count(), headers, "{shown}");
        for (file, bytes) in &before {
            assert_eq!(&fs::read(folder.path().join(file)).unwrap(), bytes, "{arguments} wrote {file}");
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), before.len() + 1, "{arguments}");
    }
    let fixed = objdict(folder.path(), "check --fix --unsafe-fixes 15_octal.eds orphan-sub.eds", b"");
    assert_eq!(fixed.status.code(), Some(0));
    let again = objdict(folder.path(), "check --fix --unsafe-fixes --diff 15_octal.eds orphan-sub.eds", b"");
    assert_eq!((again.status.code(), again.stdout.as_slice()), (Some(0), &b""[..]), "one run is enough");
}

/// All edits that JSON offers for a file can be made together.
#[test]
fn offers_do_not_overlap() {
    let output = objdict(&support::fixtures(), "check --all --format json .", b"");
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let mut edits = Vec::new();
    for finding in report["findings"].as_array().unwrap() {
        let (file, fix) = (finding["file"].as_str().unwrap(), &finding["fix"]);
        for edit in fix["edits"].as_array().into_iter().flatten() {
            let number = |name: &str| edit[name].as_u64().unwrap();
            let (start, end) =
                ((number("line"), number("column")), (number("end_line"), number("end_column")));
            assert!(start != end || edit["text"] != "", "an edit without effect: {finding}");
            edits.push((file, start, end));
        }
        // a plain `--fix` leaves it alone
        assert!(finding["rule"] != "cia306/file-name" || fix.is_null() || fix["safety"] == "unsafe", "{fix}");
    }
    edits.sort_unstable();
    assert!(edits.len() > 500, "{} edits", edits.len());
    for pair in edits.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        assert!(pair[0].2 <= pair[1].1 && pair[0] != pair[1], "{pair:?}");
    }
}
