//! What only Windows has: drives, separators, names of devices, and patterns that the shell leaves to programs. Elsewhere these tests need a
//! command for Windows (`OBJDICT_PROGRAM`).

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::support::skips::skip;

const SOURCE: &str = "fixtures/eds/minimal.eds";

fn objdict(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(crate::program()).args(arguments).current_dir(folder).output().unwrap()
}

/// What a command prints that ends with a code.
fn said(folder: &Path, arguments: &[&str], code: i32) -> String {
    let output = objdict(folder, arguments);
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap()).concat();
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {text}");
    text
}

/// A folder with a blank and letters of several alphabets in its name, if the command is one for Windows.
fn folder() -> Option<(tempfile::TempDir, PathBuf)> {
    if !crate::is_for_windows() {
        skip("the command is not for Windows");
        return None;
    }
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path().join("Geräte 電源 №5");
    fs::create_dir(&folder).unwrap();
    Some((temporary, folder))
}

/// A path from its drive. For wine, the root of Linux is drive Z.
fn with_drive(path: &Path) -> String {
    let path = path.display().to_string();
    if cfg!(windows) { path } else { format!("Z:{}", path.replace('/', r"\")) }
}

#[test]
fn names_of_files_are_unicode() {
    let Some((_temporary, folder)) = folder() else { return };
    for name in ["a b.eds", "Antrieb ü€.eds", "電源.eds", "(1) & ^%PATH%!.eds", "😀.eds", "-x.eds"] {
        fs::copy(SOURCE, folder.join(name)).unwrap();
        let path = format!(".\\{name}");
        let findings =
            said(&folder, &["check", "--select", "cia306/file-name", "--format", "concise", &path], 0);
        assert!(findings.lines().next().is_some_and(|line| line.starts_with(&path)), "{findings}");
        said(&folder, &["convert", &path, "--to", "eds", "-o", "out\\"], 0);
        assert_eq!(fs::read(folder.join("out").join(name)).unwrap(), fs::read(SOURCE).unwrap(), "{name}");
    }
}

/// A path may be long, begin at a drive, at the root of one, or with `\\?\`, and have both separators.
#[test]
fn paths_have_drives() {
    let Some((_temporary, folder)) = folder() else { return };
    let mut deep = folder.clone();
    deep.extend(std::iter::repeat_n("a folder with a name of forty letters - x", 8));
    fs::create_dir_all(&deep).unwrap();
    assert!(deep.as_os_str().len() > 260);
    let source = with_drive(&fs::canonicalize(SOURCE).unwrap());
    for path in [&folder, &deep, &folder.join("new")] {
        let shown = with_drive(path);
        let verbatim = format!(r"\\?\{shown}");
        for root in [&shown, &shown.replacen('\\', "/", 2), &shown[2..], &verbatim] {
            let [eds, out] = [format!(r"{root}\a.eds"), format!(r"{root}\out")];
            said(&folder, &["convert", &source, "-o", &eds], 0);
            said(&folder, &["check", "--severity", "cia306/file-name=off", &eds], 0);
            said(&folder, &["generate", &eds, "--target", "c", "--target", "canopennode", "-o", &out], 0);
            assert!(path.join("out/canopennode/OD.h").is_file(), "{root}");
            said(&folder, &["show", &eds, "1017"], 0);
            assert!(said(&folder, &["check", &format!(r"{root}\*.eds")], 0).contains("1 file"));
            let none = said(&folder, &["check", &format!(r"{root}\none.eds")], 2);
            assert!(none.starts_with("error: cannot read `"), "{none}");
            fs::remove_dir_all(path.join("out")).unwrap();
        }
    }
}

/// SARIF names files by their addresses, others from the current folder.
#[test]
fn addresses_of_files_have_drives() {
    let Some((_temporary, folder)) = folder() else { return };
    fs::copy("fixtures/broken/octal.eds", folder.join("a.eds")).unwrap();
    let path = with_drive(&folder.join("a.eds"));
    for path in [path.clone(), format!(r"\\?\{path}")] {
        let inside = said(&folder, &["check", "--format", "github", &path], 1);
        assert!(inside.contains("::error file=a.eds,"), "{inside}");
        fs::create_dir_all(folder.join("other")).unwrap();
        let log = said(&folder.join("other"), &["check", "--format", "sarif", &path], 1);
        let start = format!("\"uri\":\"file:///{}/", &path.trim_start_matches(r"\\?\")[..2]);
        assert!(log.contains(&start) && log.contains("/Ger%C3%A4te%20%E9%9B%BB"), "{log}");
    }
}

/// `cmd` gives patterns to programs as they are.
#[test]
fn patterns_are_expanded() {
    let Some((_temporary, folder)) = folder() else { return };
    fs::create_dir_all(folder.join("sub/below")).unwrap();
    for name in ["a.eds", "B.EDS", "sub/c.eds", "sub/below/d e.eds", "sub/e.dcf"] {
        fs::copy(SOURCE, folder.join(name)).unwrap();
    }
    for (pattern, count) in [
        ("*.eds", 2),
        ("*.EDS", 2),
        (r"sub\*.eds", 1),
        ("sub/*.eds", 1),
        (r"**\*.eds", 4),
        ("**/*.eds", 4),
        (r"*\**\?*.[ed]*", 3),
        ("SUB", 3),
    ] {
        let checked = said(&folder, &["check", "--severity", "cia306=off", pattern], 0);
        assert!(checked.starts_with(&format!("no findings in {count} file")), "{pattern}: {checked}");
    }
    said(&folder, &["fmt", r"**\*.eds"], 0);
    assert!(said(&folder, &["check", "*.xdd"], 2).contains("no file matches `*.xdd`"));
}

/// Where a path is printed, it has one kind of separator, however it was given.
#[test]
fn separators_are_those_of_the_system() {
    let Some((_temporary, folder)) = folder() else { return };
    fs::create_dir(folder.join("sub")).unwrap();
    fs::copy("fixtures/eds/io-401.eds", folder.join("sub/a.eds")).unwrap();
    fs::copy("fixtures/broken/octal.eds", folder.join("sub/bad.eds")).unwrap();
    let network = "[manager]\nid = 1\n[node.io]\nfile = \"sub/a.eds\"\nid = 2\n";
    fs::write(folder.join("network.toml"), network).unwrap();
    for (line, code, path) in [
        ("generate sub/a.eds --target c --target canopennode -o out/one", 0, r"out\one\canopennode\OD.h"),
        (
            "generate sub/a.eds --target c --target canopennode -o out/one --list",
            0,
            r"out\one\canopennode\OD.h",
        ),
        ("convert sub/a.eds sub/bad.eds -o out/two --to json --verbose", 0, r"out\two\a.json"),
        ("docs sub/a.eds -o out/three/ --verbose", 0, r"sub\a.eds"),
        ("network build network.toml --target dcf -o out/four", 0, r"out\four: "),
        ("network verify out/four", 0, r"out\four: "),
        ("check sub/bad.eds --format concise", 1, r"sub\bad.eds:"),
        ("check sub/bad.eds", 1, r"sub\bad.eds:"),
        ("check sub/*.eds --format concise", 1, r"sub\bad.eds:"),
        ("check sub/none.eds", 2, r"`sub\none.eds`"),
        ("convert sub/a.eds -o sub/bad.eds/a.json", 2, r"`sub\bad.eds\a.json`"),
        ("identify sub/bad.eds", 0, r"sub\bad.eds"),
    ] {
        let text = said(&folder, &line.split(' ').collect::<Vec<_>>(), code);
        assert!(text.contains(path), "{line}: {text}");
        for folder in ["sub/", "out/", "one/", "canopennode/", "two/", "three/", "four/", "bad.eds/"] {
            assert!(!text.contains(folder), "{line}: {text}");
        }
    }
    // what is read elsewhere has the separators of everywhere
    let list = fs::read_to_string(folder.join("out/four/objdict.sha256")).unwrap();
    assert!(list.contains("  io.dcf\n") && list.contains("network.toml"), "{list}");
    said(&folder, &["check", "sub", "--write-baseline", "known.json"], 0);
    let known = fs::read_to_string(folder.join("known.json")).unwrap();
    assert!(known.contains("\"sub/bad.eds\"") && !known.contains('\\'), "{known}");
    said(&folder, &["check", r".\sub", "--baseline", "known.json"], 0);
}

/// `con` and `nul.eds` are devices in every folder.
#[test]
fn names_of_devices_are_no_files() {
    let Some((_temporary, folder)) = folder() else { return };
    fs::copy(SOURCE, folder.join("a.eds")).unwrap();
    let before = fs::read(folder.join("a.eds")).unwrap();
    for output in ["con.xdd", "nul.json", r"sub\Aux.xdd", "com1.eds", r"\\?\C:\prn.xdd"] {
        let text = said(&folder, &["convert", "a.eds", "-o", output], 2);
        assert!(text.contains("Windows reserves it for a device"), "{output}: {text}");
    }
    for (line, file) in [
        ("convert a.eds --to xdd -o nul", "nul"),
        ("docs a.eds --to html -o NUL", "NUL"),
        ("check a.eds --write-baseline nul", "nul"),
    ] {
        said(&folder, &line.split(' ').collect::<Vec<_>>(), 0);
        let names = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name());
        assert_eq!(names.collect::<Vec<_>>(), ["a.eds"], "{file}");
    }
    for input in ["nul", "nul.eds", r"sub\nul.eds"] {
        let text = said(&folder, &["check", input], 2);
        assert!(
            text.starts_with("error: cannot read `") || text.contains("is a pipe or a device"),
            "{input}: {text}"
        );
    }
    assert_eq!(fs::read(folder.join("a.eds")).unwrap(), before);
}

/// Names that differ in case are one file, and so are two names of it.
#[test]
fn no_other_name_of_an_input_is_an_output() {
    let Some((_temporary, folder)) = folder() else { return };
    let path = folder.join("Drive.eds");
    fs::copy(SOURCE, &path).unwrap();
    let verbatim = format!(r"\\?\{}", with_drive(&path));
    let before = fs::read(&path).unwrap();
    fs::hard_link(&path, folder.join("link.eds")).unwrap();
    for output in ["drive.EDS", r".\Drive.eds", &verbatim, r"x\..\DRIVE.eds", "link.eds"] {
        let text = said(&folder, &["convert", "Drive.eds", "--to", "xdd", "-o", output], 2);
        assert!(text.contains("is already an input or output of this run"), "{output}: {text}");
        assert_eq!(fs::read(&path).unwrap(), before, "{output}");
    }
    // a file keeps its other names
    let text = String::from_utf8(before).unwrap().replace("AccessType=ro", "AccessType=RO");
    fs::write(&path, &text).unwrap();
    said(&folder, &["fmt", "Drive.eds"], 0);
    assert_eq!(fs::read(&path).unwrap(), fs::read(folder.join("link.eds")).unwrap());
}

/// Line breaks stay as they are, in files that are changed and in those of pipes.
#[test]
fn line_breaks_stay() {
    let Some((_temporary, folder)) = folder() else { return };
    let text = fs::read_to_string("fixtures/broken/octal.eds").unwrap().replace("\r\n", "\n");
    for (name, text) in [("lf.eds", text.clone()), ("crlf.eds", text.replace('\n', "\r\n"))] {
        fs::write(folder.join(name), &text).unwrap();
        said(&folder, &["check", "--fix", "--unsafe-fixes", name], 0);
        let fixed = fs::read_to_string(folder.join(name)).unwrap();
        assert!(fixed != text, "{name}");
        assert_eq!(fixed.contains('\r'), name == "crlf.eds");
        assert_eq!(fixed.matches('\n').count(), fixed.lines().count());
        assert!(name != "crlf.eds" || fixed.matches('\r').count() == fixed.matches('\n').count());
        let file = fs::File::open(folder.join(name)).unwrap();
        let mut through = Command::new(crate::program());
        let through = through.args(["convert", "-", "--to", "eds"]).stdin(file).output().unwrap();
        assert_eq!(String::from_utf8(through.stdout).unwrap(), fixed, "{name}");
    }
}

/// A read-only file is left alone, and so is one that another program holds open.
#[test]
fn files_of_others_are_left_alone() {
    let Some((_temporary, folder)) = folder() else { return };
    let path = folder.join("a.eds");
    fs::copy("fixtures/broken/octal.eds", &path).unwrap();
    let before = fs::read(&path).unwrap();
    let writable = fs::metadata(&path).unwrap().permissions();
    let mut permissions = writable.clone();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    assert!(said(&folder, &["check", "--fix", "a.eds"], 2).contains("cannot write `a.eds`: it is read-only"));
    fs::set_permissions(&path, writable).unwrap();
    // a lock of Windows is one for programs of Windows alone
    #[cfg(windows)]
    {
        use std::os::windows::fs::OpenOptionsExt;
        // readers may come, writers not
        let _open = fs::OpenOptions::new().read(true).share_mode(1).open(&path).unwrap();
        assert!(said(&folder, &["check", "--fix", "a.eds"], 2).contains("cannot write `a.eds`: "));
    }
    assert_eq!(fs::read(&path).unwrap(), before);
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "nothing is left");
    said(&folder, &["check", "--fix", "a.eds"], 0);
    assert!(fs::read(&path).unwrap() != before);
}
