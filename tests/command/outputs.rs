//! What a command may write over, and what it leaves alone.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const SOURCE: &str = "fixtures/eds/io-401.eds";

/// A folder with the description `a.eds`.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(SOURCE, folder.path().join("a.eds")).unwrap();
    folder
}

fn objdict(folder: &Path, line: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_objdict"));
    command.args(line.split_whitespace()).current_dir(folder).output().unwrap()
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn no_output_replaces_an_input() {
    let folder = folder();
    let (source, path) = (fs::read(SOURCE).unwrap(), folder.path().join("a.eds"));
    fs::hard_link(&path, folder.path().join("same.eds")).unwrap();
    fs::create_dir(folder.path().join("out")).unwrap();
    fs::hard_link(&path, folder.path().join("out/a.html")).unwrap();
    fs::write(folder.path().join("node.toml"), "node-id = 7\nbit-rate = 125\n").unwrap();
    for line in [
        "convert a.eds -o a.eds",
        "convert a.eds --to xdd -o same.eds",
        "convert a.eds -o b.xdd --loss-report same.eds",
        "convert a.eds -o b.json --loss-report b.json",
        "check a.eds --write-baseline ./a.eds",
        "configure a.eds --node-id 3 --bit-rate 125 -o a.eds",
        "configure a.eds --node-id 3 --bit-rate 125 --in-place",
        "configure a.eds --settings node.toml -o node.toml",
        "docs a.eds --to csv -o same.eds",
        "docs a.eds -o out/",
        "generate a.eds --target c -o c --stamp a.eds",
        "generate a.eds --target c -o c --stamp stamp --depfile same.eds",
        "generate a.eds --target template --template od.h.j2 -o c --stamp od.h.j2",
        "dcf pack a.eds --node-id 1 --all -o a.eds",
    ] {
        fs::write(folder.path().join("od.h.j2"), "a text\n").unwrap();
        let output = objdict(folder.path(), line);
        assert_eq!(output.status.code(), Some(2), "{line}: {}", errors(&output));
        let is_refused =
            |text: &str| text.contains("is another input or output of this run") || text.contains("in place");
        assert!(is_refused(&errors(&output)), "{line}: {}", errors(&output));
        assert_eq!(fs::read(&path).unwrap(), source, "{line}");
    }
    assert!(!folder.path().join("c").exists(), "nothing is generated beside a stamp that is refused");
}

#[test]
fn a_dcf_is_changed_in_place_on_request() {
    let folder = folder();
    for (line, code) in [
        ("configure a.eds --node-id 3 --bit-rate 125 -o n.dcf", 0),
        ("configure n.dcf --node-id 4 -o n.dcf", 2),
        ("configure n.dcf --node-id 5 --in-place", 0),
    ] {
        let output = objdict(folder.path(), line);
        assert_eq!(output.status.code(), Some(code), "{line}: {}", errors(&output));
    }
    let text = fs::read_to_string(folder.path().join("n.dcf")).unwrap();
    assert!(text.contains("NodeID=5"), "{text}");
}

#[test]
fn generated_files_replace_only_generated_files() {
    let folder = folder();
    let own = folder.path().join("gen/od.h");
    fs::create_dir(folder.path().join("gen")).unwrap();
    fs::write(&own, "/* by hand */\n").unwrap();
    let generate = "generate a.eds --target c -o gen";
    let output = objdict(folder.path(), generate);
    assert_eq!(output.status.code(), Some(2));
    assert!(errors(&output).contains("`gen/od.h` was not made by objdict"), "{}", errors(&output));
    assert_eq!(fs::read_to_string(&own).unwrap(), "/* by hand */\n");
    assert_eq!(fs::read_dir(folder.path().join("gen")).unwrap().count(), 1, "nothing else is written");
    for line in [&format!("{generate} --force"), generate, "generate a.eds --target concise -o gen"] {
        assert_eq!(objdict(folder.path(), line).status.code(), Some(0), "{line}");
    }
    // changed tables are written over the former ones
    fs::write(folder.path().join("gen/a.cdcf"), [1, 0, 0, 0, 0x17, 0x10, 0, 1, 0, 0, 0, 5]).unwrap();
    let text = fs::read_to_string(folder.path().join("a.eds")).unwrap();
    fs::write(folder.path().join("a.eds"), text.replace("Producer heartbeat", "Heartbeat")).unwrap();
    for line in [generate, "generate a.eds --target concise -o gen"] {
        assert_eq!(objdict(folder.path(), line).status.code(), Some(0), "{line}");
    }
}

#[cfg(unix)]
#[test]
fn pipes_and_devices_are_written_to() {
    use std::os::unix::fs::FileTypeExt;
    let folder = folder();
    assert!(Command::new("mkfifo").arg(folder.path().join("pipe")).status().unwrap().success());
    let line = "convert a.eds --to json -o pipe";
    let writer = {
        let folder = folder.path().to_owned();
        std::thread::spawn(move || objdict(&folder, line))
    };
    let text = fs::read_to_string(folder.path().join("pipe")).unwrap();
    assert_eq!(writer.join().unwrap().status.code(), Some(0));
    assert!(fs::metadata(folder.path().join("pipe")).unwrap().file_type().is_fifo());
    let stdout = objdict(folder.path(), "convert a.eds --to json -o /dev/stdout").stdout;
    assert_eq!(String::from_utf8(stdout).unwrap(), text);
}

#[cfg(unix)]
#[test]
fn pipes_are_read_only_where_they_are_named() {
    let folder = folder();
    assert!(Command::new("mkfifo").arg(folder.path().join("p.j2")).status().unwrap().success());
    for line in [
        "check p*",
        "check a.eds --config p.j2",
        "check a.eds --profile ./p.j2",
        "check a.eds --baseline p.j2",
        "configure a.eds --node-id 3 --settings p.j2",
        "generate a.eds --target template --template p.j2 -o gen",
        "generate a.eds --target c --rename p.j2 -o gen",
    ] {
        let output = objdict(folder.path(), line);
        assert_eq!(output.status.code(), Some(2), "{line}: {}", errors(&output));
        assert!(errors(&output).contains("is a pipe or a device, not a file"), "{line}: {}", errors(&output));
    }
    let text = fs::read(SOURCE).unwrap();
    let path = folder.path().join("p.j2");
    let writer = std::thread::spawn(move || fs::write(path, text));
    assert_eq!(objdict(folder.path(), "check p.j2").status.code(), Some(0));
    writer.join().unwrap().unwrap();
}

#[test]
fn what_cannot_be_fixed_is_still_reported() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.eds");
    let text = fs::read_to_string(SOURCE).unwrap().replace("AccessType=ro", "AccessType=read-only");
    fs::write(&path, &text).unwrap();
    let before = objdict(folder.path(), "check a.eds --format json");
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    let after = objdict(folder.path(), "check a.eds --fix --unsafe-fixes --format json");
    assert_eq!(after.status.code(), Some(2), "{}", errors(&after));
    assert!(errors(&after).contains("cannot write `a.eds`: it is read-only"), "{}", errors(&after));
    let findings = |output: &Output| {
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        document["findings"].clone()
    };
    assert!(findings(&before).as_array().is_some_and(|findings| !findings.is_empty()));
    assert_eq!(findings(&after), findings(&before));
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
}

#[test]
fn what_an_edit_keeps_is_said_to_be_invalid() {
    let folder = folder();
    fs::copy("fixtures/broken/odd-spellings.xdd", folder.path().join("odd.xdd")).unwrap();
    let kept = objdict(folder.path(), "convert odd.xdd -o copy.xdd");
    assert!(kept.status.success());
    assert!(errors(&kept).starts_with("warning: `odd.xdd` violates CiA 311 in "), "{}", errors(&kept));
    let written = objdict(folder.path(), "convert odd.xdd -o valid.xdd --canonical");
    assert!(written.status.success());
    let again = objdict(folder.path(), "convert valid.xdd -o copy.xdd");
    assert_eq!(
        (again.status.code(), errors(&written), errors(&again)),
        (Some(0), String::new(), String::new())
    );
}

/// A network is built with the severities of its configuration.
#[test]
fn a_configuration_may_allow_what_stops_a_build() {
    let folder = folder();
    let network = std::env::current_dir().unwrap().join("fixtures/rules/network/pdo-length/bad.yml");
    let line = format!("network build {} --target concise -o built", network.display());
    assert_eq!(objdict(folder.path(), &line).status.code(), Some(1));
    assert!(!folder.path().join("built").exists());
    fs::write(folder.path().join("plant.toml"), "[rules]\n\"network/pdo-length\" = \"off\"\n").unwrap();
    let output = objdict(folder.path(), &(line + " --config plant.toml"));
    assert!(output.status.success(), "{}", errors(&output));
    assert_eq!(fs::read_dir(folder.path().join("built")).unwrap().count(), 2);
}

/// In a network each node has the page of the DCF that is built for it.
#[test]
fn pages_of_nodes_are_those_of_their_dcfs() {
    let folder = tempfile::tempdir().unwrap();
    let network = std::env::current_dir().unwrap().join("fixtures/network/chapter4.toml");
    let network = network.to_str().unwrap();
    for line in [
        format!("network build {network} --target dcf -o built"),
        format!("docs {network} -o site"),
        "docs built/left.dcf -o left.html".to_owned(),
        "docs built/plc.dcf -o plc.html".to_owned(),
    ] {
        let output = objdict(folder.path(), &line);
        assert_eq!(output.status.code(), Some(0), "{line}: {}", errors(&output));
    }
    for page in ["left.html", "plc.html"] {
        let read = |path: String| fs::read_to_string(folder.path().join(path)).unwrap();
        let back = "<li><a href=\"index.html\">Overview</a></li>\n";
        let of_site = read(format!("site/{page}"));
        assert_eq!(of_site.matches(back).count(), 1, "{page}");
        assert!(of_site.replace(back, "") == read(page.to_owned()), "{page} differs");
    }
}

/// The name of a node leads to no other folder.
#[test]
fn nodes_are_built_into_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy("fixtures/network/island.eds", folder.path().join("island.eds")).unwrap();
    for name in ["../evil", "a/b", "/tmp/evil"] {
        let text = format!(
            "[manager]\nid = 1\n[node.\"{name}\"]\nfile = \"island.eds\"\nid = 2\nheartbeat = \"100ms\"\n"
        );
        fs::write(folder.path().join("network.toml"), text).unwrap();
        for target in ["dcf", "concise", "lely"] {
            let output =
                objdict(folder.path(), &format!("network build network.toml --target {target} -o a/built"));
            assert_eq!(output.status.code(), Some(2), "{name}, {target}");
            assert!(errors(&output).contains("is not a valid name of a file"), "{}", errors(&output));
        }
        let output = objdict(folder.path(), "docs network.toml -o a/site");
        assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
        let page = Path::new(name).with_extension("html");
        assert!(folder.path().join("a/site").join(page.file_name().unwrap()).exists(), "{name}");
    }
    let mut left: Vec<_> =
        fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    left.sort();
    assert_eq!(left, ["a", "island.eds", "network.toml"]);
}
