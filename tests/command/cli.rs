//! The command as its users see it: the sessions in `tests/cli/*.md` and on the pages of the documentation are run, and
//! what they print is compared.

use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::page::{from_trycmd, parts, to_trycmd};

#[test]
fn sessions() {
    cases().case("tests/cli/*.md");
}

fn cases() -> trycmd::TestCases {
    let cases = trycmd::TestCases::new();
    cases.env("NO_COLOR", "1").register_bin("objdict", PathBuf::from(crate::program()));
    cases
}

/// The sessions on the pages of the documentation run in a folder of their own that has the fixtures, for they write files.
/// With `TRYCMD=overwrite` what they print goes into the pages.
#[test]
fn pages() {
    let mut has_failed = false;
    for page in markdown_pages() {
        let text = fs::read_to_string(&page).unwrap();
        if !text.contains("```console\n") {
            continue;
        }
        let folder = tempfile::tempdir().unwrap();
        let case = folder.path().join("page.md");
        let input = folder.path().join("page.in");
        prepare(&input);
        let mut printed = String::new();
        for part in parts(&text) {
            part.append(&input);
            fs::write(&case, to_trycmd(part.text)).unwrap();
            // the other pages are compared too
            has_failed |= std::panic::catch_unwind(|| cases().case(&case).run()).is_err();
            printed.push_str(&from_trycmd(&fs::read_to_string(&case).unwrap()));
        }
        if std::env::var("TRYCMD").is_ok_and(|mode| mode == "overwrite") {
            fs::write(page, printed).unwrap();
        }
    }
    assert!(!has_failed, "a page shows something else");
}

/// The files that the sessions on pages name.
fn prepare(input: &Path) {
    for fixtures in [
        "eds",
        "dcf",
        "xdd",
        "canopennode",
        "cnxml",
        "nxdd",
        "broken",
        "torture",
        "nodelist",
        "foreign",
        "profiles",
        "patches",
        "errata",
        "concise",
        "diff",
        "logs",
        "bases",
        "toml",
        "network",
        "bus",
        "probe",
        "rules/patch/expect-not-met",
        "rules/network/link-mismatch",
        "rules/network/link-type",
    ] {
        copy_folder(&Path::new("fixtures").join(fixtures), &input.join("fixtures").join(fixtures));
    }
    fs::create_dir(input.join(".git")).unwrap();
    copy_folder(Path::new("examples"), &input.join("examples"));
}

/// The pages for users, which may have sessions.
fn markdown_pages() -> Vec<PathBuf> {
    let folders = [
        "docs",
        "docs/tutorials",
        "docs/guides",
        "docs/reference",
        "docs/reference/commands",
        "docs/explanation",
        "docs/targets",
        "tests/cli/pages",
    ];
    let files = folders.into_iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    let docs = files.map(|entry| entry.unwrap().path());
    let mut pages: Vec<PathBuf> = docs.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    pages.push(PathBuf::from("README.md"));
    pages.sort();
    pages
}

/// The example on the page about profiles is the file that its sessions use.
#[test]
fn the_profile_on_the_page() {
    let page = fs::read_to_string("docs/reference/profile.md").unwrap();
    let example = page.split_once("```toml\n").unwrap().1.split_once("```").unwrap().0;
    assert_eq!(example, fs::read_to_string("fixtures/profiles/project-drives.toml").unwrap());
}

/// Copies the files of a folder, not those in folders below.
fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for file in fs::read_dir(from).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file()) {
        fs::copy(&file, to.join(file.file_name().unwrap())).unwrap();
    }
}

fn objdict() -> Command {
    Command::new(crate::program())
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

/// The number of threads changes nothing but the time.
#[test]
fn any_number_of_jobs_gives_the_same_output() {
    let run = |jobs: &str| {
        let arguments = ["check", "fixtures", "--no-config", "--format", "json", "--jobs", jobs];
        let output = objdict().args(arguments).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
        assert!(output.stdout.len() > 100_000, "{} bytes", output.stdout.len());
        (output.stdout, output.stderr)
    };
    let one = run("1");
    for jobs in ["2", "8"] {
        assert!(run(jobs) == one, "with {jobs} jobs the output is another");
    }
}

/// `-` is the standard input, for reading, and the standard output, for writing.
#[test]
fn a_pipe_through_the_command() {
    let through = |arguments: &[&str], input: &[u8]| {
        let mut child = objdict()
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(input).unwrap();
        child.wait_with_output().unwrap()
    };
    let eds = fs::read("fixtures/eds/minimal.eds").unwrap();
    let checked = through(&["check", "-"], &eds);
    assert_eq!(String::from_utf8_lossy(&checked.stdout), "no findings in 1 file\n");
    let same = through(&["convert", "-", "--to", "eds"], &eds);
    assert_eq!(same.stdout, eds);
    let json = through(&["convert", "-", "--to", "json"], &eds).stdout;
    let shown = through(&["show", "-", "--from", "json", "1017"], &json);
    assert!(String::from_utf8_lossy(&shown.stdout).starts_with("0x1017sub0  Producer heartbeat time\n"));
    let broken = through(&["check", "-"], b"[2000]\nDefaultValue=x\x1B[31m\n");
    assert!(String::from_utf8_lossy(&broken.stdout).contains("<stdin>:2:15"));
    assert!(!broken.stdout.contains(&0x1B), "nothing in a file steers the terminal");
}

#[test]
fn colours_are_for_terminals() {
    let check = |arguments: &[&str]| {
        let output =
            objdict().arg("check").args(arguments).arg("fixtures/broken/octal.eds").output().unwrap();
        output.stdout.contains(&0x1B)
    };
    assert!(!check(&[]), "a pipe is no terminal");
    assert!(check(&["--color", "always"]));
    assert!(!check(&["--color", "never"]));
}

/// Findings of every file are data for JSON readers: the document parses, and has the same findings as the text.
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
        let denied = findings.iter().any(|finding| finding["severity"] == "error");
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
