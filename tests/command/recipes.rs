//! The lines for jq and the Python script of docs/reference/json.md, run as they are on the page.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::skips::has;

/// The first block of docs/reference/json.md with this fence.
fn block(fence: &str) -> String {
    let page = fs::read_to_string("docs/reference/json.md").unwrap();
    let rest = page.split_once(&format!("```{fence}\n")).unwrap().1;
    rest.split_once("```\n").unwrap().0.to_owned()
}

/// A folder with the files that the page names.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::copy("fixtures/dcf/encoder-406-node3.dcf", folder.path().join("node3.dcf")).unwrap();
    fs::copy("fixtures/broken/octal.eds", folder.path().join("octal.eds")).unwrap();
    for file in fs::read_dir("fixtures/network").unwrap().map(|file| file.unwrap().path()) {
        fs::copy(&file, folder.path().join(file.file_name().unwrap())).unwrap();
    }
    folder
}

/// What a program prints in the folder, with `objdict` in its path; `None` without the program.
fn run(program: &str, arguments: &[&str], folder: &Path) -> Option<String> {
    if !has(program, program) {
        return None;
    }
    let mut paths = vec![Path::new(crate::program()).parent().unwrap().to_owned()];
    paths.extend(env::split_paths(&env::var_os("PATH").unwrap_or_default()));
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).env("PATH", env::join_paths(paths).unwrap());
    // a console of Windows has another encoding
    let output = command.env("PYTHONUTF8", "1").output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    // the networks of the folder are left to another command
    let has_failed = errors.lines().any(|line| !line.starts_with("note: ") && !line.starts_with("  help: "));
    assert!(output.status.success() && !has_failed, "{arguments:?}: {errors}");
    Some(String::from_utf8(output.stdout).unwrap().replace("\r\n", "\n"))
}

#[cfg(unix)]
#[test]
fn lines_for_jq() {
    const PRINTED: [&str; 5] = [
        "0x1000\tVAR\tDevice type\n",
        "0x1014\t$NODEID+0x80\n",
        "TPDO 1 communication parameter\t387\n",
        "0x18D\tservo\tplc\n",
        "octal.eds:",
    ];
    let folder = folder();
    if run("jq", &["-n", "1"], folder.path()).is_none() {
        return;
    }
    let lines = block("sh");
    assert_eq!(lines.lines().count(), PRINTED.len());
    for (line, expected) in lines.lines().zip(PRINTED) {
        let printed = run("bash", &["-c", line], folder.path()).unwrap();
        assert!(printed.contains(expected), "{line}:\n{printed}");
    }
}

/// A line `…` of the page is for any lines.
#[test]
fn the_python_script() {
    let folder = folder();
    fs::write(folder.path().join("list.py"), block("python")).unwrap();
    let Some(printed) = run("python3", &["list.py", "node3.dcf"], folder.path()) else { return };
    let expected = block("text");
    let mut rest = printed.as_str();
    for piece in expected.split("…\n") {
        let (_, behind) = rest.split_once(piece).unwrap_or_else(|| panic!("no\n{piece}in\n{printed}"));
        rest = behind;
    }
    let findings = run("python3", &["list.py", "octal.eds"], folder.path()).unwrap();
    assert!(findings.contains("\terror\tcia306/invalid-value\t"), "{findings}");
}
