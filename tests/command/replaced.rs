//! `network build` replaces all files or none, and `network verify` says what became of them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Instant;

use crate::support::skips::skip_unless_ci;

/// A folder with a network and its descriptions.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for file in fs::read_dir("fixtures/network").unwrap().map(|entry| entry.unwrap().path()) {
        fs::copy(&file, folder.path().join(file.file_name().unwrap())).unwrap();
    }
    folder
}

fn command(folder: &Path, line: &str) -> Command {
    let mut command = Command::new(crate::program());
    command.args(line.split_whitespace()).current_dir(folder);
    command
}

fn objdict(folder: &Path, line: &str) -> Output {
    command(folder, line).output().unwrap()
}

/// Runs a command that must end with a code; what it writes.
fn run(folder: &Path, line: &str, code: i32) -> String {
    let output = objdict(folder, line);
    let text = [output.stdout, output.stderr].map(|bytes| crate::printed(&bytes)).concat();
    assert_eq!(output.status.code(), Some(code), "{line}: {text}");
    text
}

const BUILD: &str = "network build chapter4.toml --target dcf -o built";

/// Gives the nodes another heartbeat time, so that each file of [`BUILD`] changes.
fn change(folder: &Path) {
    let path = folder.join("chapter4.toml");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(path, text.replace("125", "250").replace("300ms", "400ms")).unwrap();
}

fn built(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder.join("built")).unwrap().map(|entry| entry.unwrap().path());
    let dcfs = entries.filter(|path| path.extension().is_some_and(|ending| ending == "dcf"));
    dcfs.map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read(&path).unwrap()))
        .collect()
}

/// What is in a folder besides [`built`], hidden files included.
fn others(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> = names.filter(|name| !name.ends_with(".dcf")).collect();
    names.sort();
    names
}

#[test]
fn a_file_that_cannot_be_written_leaves_all_of_them() {
    for foreign in [None, Some("README")] {
        let folder = folder();
        run(folder.path(), BUILD, 0);
        foreign.iter().for_each(|name| fs::write(folder.path().join("built").join(name), "").unwrap());
        let before = built(folder.path());
        change(folder.path());
        let path = folder.path().join("built/tool.dcf");
        fs::remove_file(&path).unwrap();
        fs::create_dir(&path).unwrap();
        let text = run(folder.path(), BUILD, 2);
        assert!(text.contains("cannot write `built/tool.dcf`: it is not a file"), "{text}");
        fs::remove_dir(&path).unwrap();
        fs::write(&path, &before["tool.dcf"]).unwrap();
        assert!(built(folder.path()) == before);
        run(folder.path(), BUILD, 0);
        assert!(built(folder.path()).iter().all(|(name, bytes)| before[name] != *bytes), "each file is new");
        let list = others(&folder.path().join("built"));
        assert_eq!(
            list,
            foreign.into_iter().chain(["objdict.sha256"]).collect::<Vec<_>>(),
            "nothing is left"
        );
    }
}

/// Whenever the command is killed, the files are all old or all new; beside files of others some may be missing, but none is
/// beside one of another build.
#[test]
fn a_killed_run_leaves_no_mixture() {
    const KILLS: u32 = 10;
    let folder = folder();
    run(folder.path(), BUILD, 0);
    let old = built(folder.path());
    let list = fs::read(folder.path().join("built/objdict.sha256")).unwrap();
    change(folder.path());
    let start = Instant::now();
    run(folder.path(), BUILD, 0);
    let time = start.elapsed();
    let new = built(folder.path());
    for kill in 0..KILLS {
        let has_others = kill % 2 == 0;
        fs::remove_dir_all(folder.path().join("built")).unwrap();
        fs::create_dir(folder.path().join("built")).unwrap();
        let write =
            |name: &str, bytes: &[u8]| fs::write(folder.path().join("built").join(name), bytes).unwrap();
        old.iter().for_each(|(name, bytes)| write(name, bytes));
        write("objdict.sha256", &list);
        if has_others {
            write("README", b"");
        }
        let mut child =
            command(folder.path(), BUILD).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        std::thread::sleep(time * kill / (KILLS - 1));
        child.kill().unwrap();
        child.wait().unwrap();
        let left = built(folder.path());
        let is_of =
            |build: &BTreeMap<String, Vec<u8>>| left.iter().all(|(name, bytes)| build[name] == *bytes);
        assert!(is_of(&old) || is_of(&new), "{:?}", left.keys());
        assert!(has_others || left.len() == new.len(), "{:?}", left.keys());
        run(folder.path(), BUILD, 0);
        assert!(built(folder.path()) == new);
        run(folder.path(), "network verify built", 0);
        assert!(others(folder.path()).iter().all(|name| !name.starts_with(".built")), "nothing is left");
    }
}

/// What a folder gets is there as a whole, or as it was, also where the disk is full; here no file may be larger than 24 KB.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_all_files_as_they_were() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    for (from, to) in [("eds/minimal.eds", "small.eds"), ("eds/drive-402.eds", "large.eds")] {
        fs::copy(Path::new("fixtures").join(from), path.join(to)).unwrap();
    }
    let all = || -> BTreeMap<PathBuf, Vec<u8>> {
        let paths = fs::read_dir(path.join("built")).unwrap().map(|entry| entry.unwrap().path());
        paths.map(|path| (path.clone(), fs::read(path).unwrap())).collect()
    };
    for line in ["generate DEVICE --target c,rust -o built/", "docs small.eds DEVICE -o built/"] {
        let _ = fs::remove_dir_all(path.join("built"));
        run(path, &line.replace("small.eds DEVICE", "small.eds").replace("DEVICE", "small.eds"), 0);
        let before = all();
        let line = line.replace("DEVICE", "large.eds");
        let script = format!("ulimit -f 24 && exec \"$0\" {line} --overwrite");
        let mut command = Command::new("sh");
        let output = command.args(["-c", &script, crate::program()]).current_dir(path).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{line}: {}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(all(), before, "{line}");
    }
}

#[test]
fn built_files_are_verified() {
    let folder = folder();
    run(folder.path(), BUILD, 0);
    run(folder.path(), "network build chapter4.toml --target concise -o built", 0);
    assert_eq!(run(folder.path(), "network verify built", 0), "built: 9 files as written\n");
    // another program reads the list
    if let Ok(checked) = Command::new("sha256sum")
        .args(["-c", "--strict", "objdict.sha256"])
        .current_dir(folder.path().join("built"))
        .output()
    {
        assert!(checked.status.success(), "{checked:?}");
        assert_eq!(String::from_utf8(checked.stdout).unwrap().lines().count(), 9);
    } else {
        skip_unless_ci("no `sha256sum`: install the package `coreutils`");
    }
    let path = |name: &str| folder.path().join("built").join(name);
    let left = fs::read(path("left.dcf")).unwrap();
    fs::write(path("left.dcf"), [left.as_slice(), b" "].concat()).unwrap();
    fs::remove_file(path("tool.cdcf")).unwrap();
    fs::write(path("notes.txt"), "").unwrap();
    let text = "built/left.dcf: changed\nbuilt/tool.cdcf: missing\nbuilt: 2 of 9 files not as written\nnote: `built/notes.txt` is not in the list\n";
    assert_eq!(run(folder.path(), "network verify built", 1), text);
    assert!(run(folder.path(), BUILD, 2).contains("`built/left.dcf` was changed after objdict wrote it"));
    run(folder.path(), &format!("{BUILD} --overwrite"), 0);
    run(folder.path(), "network build chapter4.toml --target concise -o built", 0);
    run(folder.path(), "network verify built", 0);
    // as a run leaves it that is killed between two files
    let list = fs::read_to_string(path("objdict.sha256")).unwrap();
    let line = list.lines().find(|line| line.ends_with("left.dcf")).unwrap();
    fs::write(path("objdict.sha256"), format!("{list}{}\n", line.replace(&line[..8], "00000000"))).unwrap();
    let text = run(folder.path(), "network verify built", 1);
    assert!(text.contains("was interrupted; build them again"), "{text}");
    run(folder.path(), BUILD, 0);
    run(folder.path(), "network verify built", 0);
    assert!(run(folder.path(), "network verify .", 2).contains("`.` has no `objdict.sha256`"));
    fs::write(folder.path().join("objdict.sha256"), "of another program\n").unwrap();
    assert!(run(folder.path(), "network verify .", 2).contains("objdict did not write this list"));
    // a list cannot be about other folders
    let head = list.lines().next().unwrap();
    fs::write(folder.path().join("objdict.sha256"), format!("{head}\n{}  ../x\n", &line[..64])).unwrap();
    assert_eq!(run(folder.path(), "network verify . -q", 0), ".: 0 files as written\n");
}

/// A node that is gone leaves a file, of which the build says so.
#[test]
fn files_of_earlier_builds_stay_and_are_named() {
    let folder = folder();
    let network = |name: &str| {
        let text = format!("[manager]\nid = 1\n[node.{name}]\nfile = \"island.eds\"\nid = 2\n");
        fs::write(folder.path().join("network.toml"), text).unwrap();
    };
    let build = "network build network.toml --target concise -o built";
    network("left");
    run(folder.path(), build, 0);
    network("right");
    let text = run(folder.path(), build, 0);
    assert!(text.contains("note: `built/left.cdcf` is from an earlier build\n"), "{text}");
    assert_eq!(others(&folder.path().join("built")), ["left.cdcf", "objdict.sha256", "right.cdcf"]);
}

/// `PLC` and `plc` are one file on many systems.
#[test]
fn nodes_whose_names_differ_in_case_get_two_files() {
    let folder = folder();
    let node = |name: &str, id: u8| {
        format!("[node.{name}]\nfile = \"island.eds\"\nid = {id}\nheartbeat = \"{id}00ms\"\n")
    };
    let text = format!("[manager]\nid = 1\n{}{}", node("PLC", 2), node("plc", 3));
    fs::write(folder.path().join("network.toml"), text).unwrap();
    for (target, first, second) in [
        ("dcf", "PLC.dcf", "plc-3.dcf"),
        ("concise", "PLC.cdcf", "plc-3.cdcf"),
        ("lely", "PLC.bin", "plc-3.bin"),
        ("cpj", "PLC.dcf", "plc-3.dcf"),
    ] {
        run(folder.path(), &format!("network build network.toml --target {target} -o {target}"), 0);
        let read = |name: &str| fs::read(folder.path().join(target).join(name)).unwrap();
        assert!(read(first) != read(second), "{target}");
    }
    let text = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    assert!(text("lely/master.dcf").contains("UploadFile=plc-3.bin"), "the manager looks for this name");
    assert!(text("cpj/nodelist.cpj").contains("Node3DCFName=plc-3.dcf"));
    let read = "network check cpj/nodelist.cpj --severity network=off --severity cia306=off";
    run(folder.path(), read, 0);
}
