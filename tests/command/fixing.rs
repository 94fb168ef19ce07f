//! `--fix`, `--diff`, and what reports offer to fix.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

use crate::support;

fn objdict(folder: &Path, arguments: &str, input: &[u8]) -> Output {
    let mut command = Command::new(crate::program());
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

/// What is found through a link out of the folder is checked, but not changed; a file that is named is.
#[cfg(unix)]
#[test]
fn links_out_of_the_folder_are_not_changed() {
    use std::os::unix::fs::symlink;

    let folder = tempfile::tempdir().unwrap();
    let [project, outside] = ["project", "outside"].map(|name| folder.path().join(name));
    fs::create_dir_all(project.join("below")).unwrap();
    fs::create_dir(&outside).unwrap();
    let bytes = fs::read(support::fixtures().join("torture/15_octal.eds")).unwrap();
    let victims = ["file.eds", "folder.eds"].map(|name| outside.join(name));
    victims.iter().for_each(|path| fs::write(path, &bytes).unwrap());
    symlink(&victims[0], project.join("link.eds")).unwrap();
    symlink(&outside, project.join("linked")).unwrap();
    fs::write(project.join("below/own.eds"), &bytes).unwrap();
    symlink(project.join("below/own.eds"), project.join("inside.eds")).unwrap();
    for arguments in
        ["check --fix .", "check --fix */*.eds *.eds", "check --fix */", "fmt . */", "fmt *.eds */*.eds"]
    {
        let output = objdict(&project, arguments, b"");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(
            said.contains(" is unchanged because a link points outside the folder"),
            "{arguments}: {said}"
        );
        for victim in &victims {
            assert_eq!(fs::read(victim).unwrap(), bytes, "{arguments} wrote {}", victim.display());
        }
    }
    assert_ne!(fs::read(project.join("below/own.eds")).unwrap(), bytes, "a file in the folder is fixed");
    objdict(&project, "check --fix link.eds", b"");
    assert_ne!(fs::read(&victims[0]).unwrap(), bytes, "a file that is named is fixed");
    assert!(project.join("link.eds").is_symlink());
}

/// A network, a node list and a DCF name files of their project only, and none on another computer.
#[test]
fn named_files_are_those_of_the_project() {
    let folder = tempfile::tempdir().unwrap();
    let project = folder.path().join("project");
    let lists = project.join("lists");
    fs::create_dir_all(&lists).unwrap();
    let dcf = fs::read(support::fixtures().join("dcf/io-401-node5.dcf")).unwrap();
    fs::write(folder.path().join("secret.dcf"), &dcf).unwrap();
    fs::write(project.join("node.dcf"), &dcf).unwrap();
    let run = |arguments: &str| {
        let output = objdict(&lists, arguments, b"");
        let said = [output.stdout, output.stderr].concat();
        (output.status.code(), String::from_utf8(said).unwrap())
    };
    let write = |path: &str| {
        let toml = format!("[bus]\nbit-rate = 125\n[node.a]\nid = 5\nfile = '{path}'\n");
        fs::write(lists.join("network.toml"), toml).unwrap();
        let yml = format!("master:\n  node_id: 1\na:\n  node_id: 5\n  dcf: '{path}'\n");
        fs::write(lists.join("bus.yml"), yml).unwrap();
        let cpj = format!("[TOPOLOGY]\nNodes=1\nNode5Present=1\nNode5Name=a\nNode5DCFName={path}\n");
        fs::write(lists.join("line.cpj"), cpj).unwrap();
    };
    let commands = [
        "network check network.toml",
        "network check bus.yml",
        "network check line.cpj",
        "network init line.cpj",
        "convert line.cpj -o ../../out.dbc",
    ];
    let expect = |path: &str, options: &str, verdict: Option<&str>| {
        write(path);
        for command in commands {
            let (code, said) = run(&format!("{command} {options}"));
            match verdict {
                Some(verdict) => assert!(
                    said.replace("\n  │ ", " ").contains(verdict),
                    "{command} {options} of {path}: {said}"
                ),
                None => assert_ne!(code, Some(2), "{command} {options} of {path}: {said}"),
            }
        }
    };
    let outside = Some("is outside the project");
    expect("../node.dcf", "", outside);
    expect("../none.dcf", "", outside);
    expect("../node.dcf", "--allow-path ..", None);
    expect(r"\\server\share\node.dcf", "--allow-path /", Some("is on a different computer"));
    fs::write(project.join("objdict.toml"), "").unwrap();
    expect("../node.dcf", "", None);
    expect(r"..\node.dcf", "", None);
    expect("../../secret.dcf", "", outside);
    expect(folder.path().join("secret.dcf").to_str().unwrap(), "", outside);
    write("$PLACE/secret.dcf");
    let (_, said) = run(&format!("network check network.toml -D PLACE={}", folder.path().display()));
    assert!(!said.contains("outside"), "{said}");
}

/// Keys of a device.toml are changed, added and removed where they are; what has no place there is not offered.
#[test]
fn the_short_source_of_a_device_is_fixed() {
    const BEFORE: &str = r#"format = "objdict-device/1"

[device]
vendor-name = "V" # ours

[object]
# three fixes in two lines
2000 = { name = "  A", type = "u8", access = "ro", flags = 0x10 }
2001 = { object-type = "record", name = "B", unstated = ["sub0"], sub.1 = { name = "b", type = "u8" } }

[object.2002]
name = "C"
flags = 0x30 # away with it
type = "string"
map = "optional"
"#;
    const AFTER: [(&str, &str); 4] = [
        (
            r#"name = "  A", type = "u8", access = "ro", flags = 0x10 }"#,
            r#"name = "A", type = "u8", access = "ro" }"#,
        ),
        (r#"type = "u8" } }"#, r#"type = "u8" }, sub.0 = { name = "Highest sub-index supported", "#),
        ("flags = 0x30 # away with it\n", ""),
        (r#"map = "optional""#, r#"map = "no""#),
    ];
    const RULES: &str = "naming,cia306/invalid-object-flags,cia306/missing-sub-0,cia306/mapping-not-possible,cia306/missing-section";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("device.toml");
    fs::write(&file, BEFORE).unwrap();
    let fixed =
        objdict(folder.path(), &format!("check --fix --unsafe-fixes device.toml --select {RULES}"), b"");
    let (stdout, stderr) =
        (String::from_utf8(fixed.stdout).unwrap(), String::from_utf8(fixed.stderr).unwrap());
    assert!(stderr.contains("fixed 5 findings in 1 file"), "{stderr}");
    let after = fs::read_to_string(&file).unwrap();
    for (old, new) in AFTER {
        assert!(!after.contains(old) && after.contains(new), "{old}: {after}");
    }
    for kept in ["vendor-name = \"V\" # ours\n", "# three fixes in two lines\n", "type = \"string\"\n"] {
        assert!(after.contains(kept), "{after}");
    }
    // a section that is missing in an EDS is none of a device.toml
    assert!(stdout.contains("missing-section") && !stdout.contains("can be fixed"), "{stdout}");
    let again =
        objdict(folder.path(), &format!("check --fix --unsafe-fixes device.toml --select {RULES}"), b"");
    assert!(String::from_utf8_lossy(&again.stderr).contains("fixed 0 findings"));
    assert_eq!(fs::read_to_string(&file).unwrap(), after);
}

#[test]
fn a_file_with_several_names_is_fixed_once() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::copy("fixtures/broken/octal.eds", folder.join("a.eds")).unwrap();
    let fixed = objdict(folder, "check --fix a.eds ./a.eds . a.eds *.eds", b"");
    let errors = String::from_utf8_lossy(&fixed.stderr).into_owned();
    assert!(errors.contains(" in 1 file\n"), "{errors}");
}
