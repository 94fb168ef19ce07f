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
    let mut command = Command::new(crate::program());
    command.args(line.split_whitespace()).current_dir(folder).output().unwrap()
}

fn errors(output: &Output) -> String {
    crate::printed(&output.stderr)
}

#[test]
fn no_output_replaces_an_input() {
    let folder = folder();
    let (source, path) = (fs::read(SOURCE).unwrap(), folder.path().join("a.eds"));
    fs::hard_link(&path, folder.path().join("same.eds")).unwrap();
    fs::create_dir(folder.path().join("out")).unwrap();
    fs::hard_link(&path, folder.path().join("out/a.html")).unwrap();
    fs::write(folder.path().join("node.txt"), "node-id = 7\nbit-rate = 125\n").unwrap();
    for line in [
        "convert a.eds -o a.eds",
        "convert a.eds --to xdd -o same.eds",
        "convert a.eds -o b.xdd --loss-report same.eds",
        "convert a.eds -o b.json --loss-report b.json",
        "check a.eds --write-baseline ./a.eds",
        "configure a.eds --node-id 3 --bit-rate 125 -o a.eds",
        "configure a.eds --node-id 3 --bit-rate 125 --in-place",
        "configure a.eds --settings node.txt -o node.txt",
        "decode a.eds --html same.eds",
        "decode node.txt --with 7=a.eds --html a.eds",
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
        let is_refused = |text: &str| {
            text.contains("is already an input or output of this run") || text.contains("in place")
        };
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

/// A second path is one more input, wherever it is.
#[test]
fn only_an_option_names_an_output() {
    let folder = folder();
    let other = fs::read("fixtures/eds/minimal.eds").unwrap();
    fs::write(folder.path().join("b.eds"), &other).unwrap();
    for (line, message) in [
        ("convert a.eds b.eds", "missing output"),
        ("convert a.eds b.xdd", "missing output"),
        ("convert a.eds b.eds --to xdd", "2 files cannot go to the standard output"),
        ("convert a.eds b.eds --to xdd -o -", "2 files cannot go to the standard output"),
        ("convert a.eds b.eds -o b.eds --to xdd", "cannot write `b.eds/"),
    ] {
        let output = objdict(folder.path(), line);
        assert_eq!(output.status.code(), Some(2), "{line}: {}", errors(&output));
        assert!(errors(&output).contains(message), "{line}: {}", errors(&output));
        assert_eq!(fs::read(folder.path().join("a.eds")).unwrap(), fs::read(SOURCE).unwrap(), "{line}");
        assert_eq!(fs::read(folder.path().join("b.eds")).unwrap(), other, "{line}");
        assert_eq!(names(folder.path()), ["a.eds", "b.eds"], "{line}");
    }
    assert_eq!(objdict(folder.path(), "convert a.eds b.eds -o out --to xdd").status.code(), Some(0));
    assert_eq!(names(&folder.path().join("out")), ["a.xdd", "b.xdd", "objdict.sha256"]);
}

/// A file that an option names is replaced, as compilers do.
#[test]
fn a_named_output_replaces_what_is_there() {
    let folder = folder();
    for (line, name) in [
        ("convert a.eds -o x.xdd", "x.xdd"),
        ("configure a.eds --node-id 3 --bit-rate 125 -o x.dcf", "x.dcf"),
        ("docs a.eds -o x.html", "x.html"),
        ("dcf pack a.eds --node-id 1 --all -o x.cdcf", "x.cdcf"),
        ("check a.eds --write-baseline x.json", "x.json"),
    ] {
        fs::write(folder.path().join(name), "of another program").unwrap();
        let output = objdict(folder.path(), line);
        assert_eq!(output.status.code(), Some(0), "{line}: {}", errors(&output));
        assert!(fs::read(folder.path().join(name)).unwrap() != b"of another program", "{line}");
    }
    // what it writes is edited by hand
    let new = "new --digital-inputs 8 --date 2026-11-21 -o x.eds";
    let codes =
        [new, new, &format!("{new} --overwrite")].map(|line| objdict(folder.path(), line).status.code());
    assert_eq!(codes, [Some(0), Some(2), Some(0)]);
}

/// The commands that write into a folder, each with a file that it writes there and a change of the input that changes the file.
fn folder_commands() -> [(&'static str, &'static str); 7] {
    [
        ("generate a.eds --target c -o out", "od.h"),
        ("generate a.eds --target concise --node-id 3 -o out", "a.cdcf"),
        ("generate a.eds --target template --template od.txt.j2 -o out", "od.txt"),
        ("convert a.eds -o out/ --to json", "a.json"),
        ("docs a.eds -o out/", "a.html"),
        ("docs a.eds network.toml -o out --to markdown", "index.md"),
        ("network build network.toml --target dcf -o out", "io.dcf"),
    ]
}

/// In folders, only what objdict wrote is replaced.
#[test]
fn files_of_others_stay() {
    let source = fs::read_to_string(SOURCE).unwrap();
    for (line, name) in folder_commands() {
        let folder = folder();
        let path = folder.path().join("out").join(name);
        let run = |line: &str, code: i32, message: &str| {
            let output = objdict(folder.path(), line);
            assert_eq!(output.status.code(), Some(code), "{line}: {}", errors(&output));
            assert!(errors(&output).contains(message), "{line}: {}", errors(&output));
        };
        fs::create_dir(folder.path().join("out")).unwrap();
        let network = "[manager]\nid = 1\n[node.io]\nfile = \"a.eds\"\nid = 2\n";
        fs::write(folder.path().join("network.toml"), network).unwrap();
        fs::write(folder.path().join("od.txt.j2"), "{{ device.file_info.description }}\n").unwrap();
        fs::write(&path, "by hand\n").unwrap();
        run(line, 2, &format!("`out/{name}` was not written by objdict\n"));
        run(&line.replace(" -o", " --force -o"), 2, "");
        assert_eq!(fs::read(&path).unwrap(), b"by hand\n", "{line}");
        assert_eq!(names(&folder.path().join("out")), [name], "{line}");
        run(&format!("{line} --overwrite"), 0, "");
        let first = fs::read(&path).unwrap();
        run(line, 0, "");
        // changed input, changed output
        let changed =
            source.replace("ProductName=", "ProductName=New ").replace("Description=", "Description=New ");
        fs::write(folder.path().join("a.eds"), changed.replace("Producer heartbeat", "Heartbeat")).unwrap();
        run(line, 0, "");
        if !line.contains("concise") {
            assert!(fs::read(&path).unwrap() != first, "{line}");
        }
        // a file that says in its first lines that it is generated is no place for changes
        if name != "od.h" {
            fs::write(&path, "changed by hand\n").unwrap();
            run(line, 2, &format!("`out/{name}` was changed after objdict wrote it\n"));
            assert_eq!(fs::read(&path).unwrap(), b"changed by hand\n", "{line}");
        }
        run(&format!("{line} --overwrite"), 0, "");
    }
}

/// `--force` goes on despite errors, and replaces nothing.
#[test]
fn nothing_is_written_beside_a_file_of_others() {
    let folder = folder();
    fs::create_dir(folder.path().join("gen")).unwrap();
    fs::write(folder.path().join("gen/od.c"), "/* by hand */\n").unwrap();
    let output = objdict(folder.path(), "generate a.eds --target c -o gen --force");
    assert_eq!(output.status.code(), Some(2), "{}", errors(&output));
    assert_eq!(names(&folder.path().join("gen")), ["od.c"]);
}

/// Windows cannot have files of these names: one that is given is refused, one that is made of the name of a node is another one.
#[test]
fn names_that_windows_reserves_are_not_written() {
    let folder = folder();
    for name in ["con.eds", "Aux.v2.eds", "what?.eds"] {
        fs::copy(SOURCE, folder.path().join(name)).unwrap();
        let output = objdict(folder.path(), &format!("convert {name} -o out/ --to json"));
        assert_eq!(output.status.code(), Some(2), "{name}");
        // Windows cannot read them either
        let is_refused = errors(&output).contains("is not a valid file name: Windows");
        assert!(is_refused || crate::is_for_windows(), "{}", errors(&output));
    }
    for (node, file) in [("nul", "_nul.dcf"), ("io:1", "io_1.dcf"), ("COM7", "_COM7.dcf"), ("com", "com.dcf")]
    {
        let network = format!("[manager]\nid = 1\n[node.\"{node}\"]\nfile = \"a.eds\"\nid = 2\n");
        fs::write(folder.path().join("network.toml"), network).unwrap();
        let output = objdict(folder.path(), "network build network.toml --target dcf -o built");
        assert_eq!(output.status.code(), Some(0), "{node}: {}", errors(&output));
        assert!(folder.path().join("built").join(file).exists(), "{node}");
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
    let mut names: Vec<String> = entries.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
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
    assert_eq!(names(&folder.path().join("built")), ["arm.cdcf", "drive.cdcf", "objdict.sha256"]);
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

/// The full report is that of `network check`: building and showing do not repeat it.
#[test]
fn a_build_lists_errors_and_counts_other_findings() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy("fixtures/network/island.eds", folder.path().join("island.eds")).unwrap();
    let node = "[node.left]\nfile = \"island.eds\"\nid = 11\n";
    fs::write(folder.path().join("network.toml"), node).unwrap();
    fs::write(folder.path().join("wrong.toml"), format!("{node}set = {{ \"1F00\" = 1 }}\n")).unwrap();
    let build =
        |name: &str| objdict(folder.path(), &format!("network build {name} --target concise -o built"));
    let output = build("network.toml");
    assert_eq!(output.status.code(), Some(0));
    let counts = "1 warning, 1 note in 1 file: `objdict network check network.toml` lists them\n";
    assert_eq!(errors(&output), counts);
    let output = build("wrong.toml");
    assert_eq!(output.status.code(), Some(1));
    let text = errors(&output);
    assert!(text.contains("the device has no object `1F00`"), "{text}");
    assert!(text.contains("1 error, 1 warning, 1 note in 1 file, so nothing is built"), "{text}");
    assert!(!text.contains("without-"), "{text}");
    let output = objdict(folder.path(), "network show network.toml");
    assert_eq!((output.status.code(), errors(&output).as_str()), (Some(0), ""));
}

/// The name of a node leads to no other folder.
#[test]
fn nodes_are_built_into_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy("fixtures/network/island.eds", folder.path().join("island.eds")).unwrap();
    for (name, stem) in [("../evil", ".._evil"), ("a/b", "a_b"), ("/tmp/evil", "_tmp_evil")] {
        let text = format!(
            "[manager]\nid = 1\n[node.\"{name}\"]\nfile = \"island.eds\"\nid = 2\nheartbeat = \"100ms\"\n"
        );
        fs::write(folder.path().join("network.toml"), text).unwrap();
        for (target, ending) in [("dcf", "dcf"), ("concise", "cdcf"), ("lely", "bin")] {
            let output =
                objdict(folder.path(), &format!("network build network.toml --target {target} -o a/built"));
            assert_eq!(output.status.code(), Some(0), "{name}, {target}: {}", errors(&output));
            assert!(folder.path().join("a/built").join(format!("{stem}.{ending}")).exists(), "{name}");
        }
        let output = objdict(folder.path(), "docs network.toml -o a/site");
        assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
        assert!(folder.path().join("a/site").join(format!("{stem}.html")).exists(), "{name}");
    }
    assert_eq!(names(folder.path()), ["a", "island.eds", "network.toml"]);
}

/// What has no device, no node-ID or not its text is not written as if it had.
#[test]
fn what_is_missing_is_said() {
    let folder = folder();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let container = "<ISO15745ProfileContainer xmlns='http://www.canopen.org/xml/1.1'/>";
    write("empty.xdd", container);
    write("empty.nxdd", "<CanOpenProject_1_1 version='1.1'/>");
    for name in ["empty.xdd", "empty.nxdd"] {
        for output in [
            "-o out.eds",
            "-o out --to eds",
            "--to eds",
            "--to json",
            "-o out.cdcf",
            "--to xdd",
            "-o out.nxdd.xdd",
        ] {
            let converted = objdict(folder.path(), &format!("convert {name} {output}"));
            assert_eq!((converted.status.code(), converted.stdout.len()), (Some(2), 0), "{name} {output}");
            assert!(errors(&converted).contains("does not describe a device"), "{}", errors(&converted));
        }
    }
    assert!(!folder.path().join("out.eds").exists());
    let dcf = fs::read_to_string("fixtures/dcf/io-401-node5.dcf").unwrap();
    for node_id in ["0", "200", ""] {
        write("node.dcf", &dcf.replace("NodeID=5\r\n", &format!("NodeID={node_id}\r\n")));
        let converted = objdict(folder.path(), "convert node.dcf --to xdc");
        let expected = match node_id {
            "" => "error: missing node-ID".to_owned(),
            node_id => format!("error: node-ID {node_id} is out of range"),
        };
        assert!(errors(&converted).starts_with(&expected), "{}", errors(&converted));
        if !node_id.is_empty() {
            for to in ["--to dcf", "--to dcf --canonical"] {
                let converted = objdict(folder.path(), &format!("convert node.dcf {to}"));
                let warning = format!("warning: `node.dcf` has the invalid node-ID {node_id}");
                assert!(converted.status.success() && errors(&converted).contains(&warning), "{to}");
            }
        }
        assert!(objdict(folder.path(), "convert node.dcf --to xdc --node-id 5").status.success());
    }
    let lamp = fs::read_to_string("fixtures/bases/lamp.xdd").unwrap();
    let declared = "<!DOCTYPE a [<!ENTITY b SYSTEM 'secret.txt'>]>\n<ISO15745ProfileContainer";
    let lamp = lamp.replacen("<ISO15745ProfileContainer", declared, 1);
    write("lamp.xdd", &lamp.replacen("</vendorName>", "&b;</vendorName>", 1));
    write("secret.txt", "secret");
    let converted = objdict(folder.path(), "convert lamp.xdd --to eds");
    assert!(
        errors(&converted).starts_with("error: `lamp.xdd` has 1 unknown entity"),
        "{}",
        errors(&converted)
    );
    assert_eq!((converted.status.code(), converted.stdout.len()), (Some(2), 0));
    let kept = objdict(folder.path(), "convert lamp.xdd --to xdc --node-id 5");
    assert!(String::from_utf8_lossy(&kept.stdout).contains("&b;</vendorName>"), "{}", errors(&kept));
}

/// A refused download is an exit code of 1, with `--force` too, and is reported once.
#[test]
fn a_refused_download_is_an_exit_code() {
    let folder = folder();
    let node = |more: &str| {
        format!("[bus]\nmanager = \"m\"\n[manager]\nid = 1\n[node.a]\nfile = \"a.eds\"\nid = 5\n{more}")
    };
    fs::write(folder.path().join("good.toml"), node("")).unwrap();
    fs::write(folder.path().join("bad.toml"), node("set = { \"1A00:0\" = 60 }\n")).unwrap();
    for target in ["concise", "dcf", "busyml"] {
        let line = |name: &str, more: &str| {
            let line = format!("network build {name} --target {target} --verify -o {target}-{name} {more}");
            objdict(folder.path(), &line)
        };
        assert_eq!(line("good.toml", "").status.code(), Some(0), "{target}");
        let refused = line("bad.toml", "--force");
        let text = errors(&refused);
        assert_eq!(refused.status.code(), Some(1), "{target}: {text}");
        assert_eq!(text.matches("error: `a` rejects download").count(), 1, "{target}: {text}");
        assert!(!text.contains("1F22h"), "{target}: {text}");
        assert!(folder.path().join(format!("{target}-bad.toml")).is_dir(), "{target}");
    }
    let missing = objdict(folder.path(), "network boot good.toml nowhere");
    assert_eq!(missing.status.code(), Some(2));
    assert!(errors(&missing).contains("`nowhere` does not exist"), "{}", errors(&missing));
}

/// Both commands count findings alike.
#[test]
fn build_counts_findings_as_check_does() {
    let fixture = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/network").join(name);
    let folder = folder();
    fs::copy(fixture("island.eds"), folder.path().join("island.eds")).unwrap();
    let node = |name: &str, id| format!("[node.{name}]\nfile = \"island.eds\"\nid = {id}\n");
    let text = format!(
        "[bus]\nmanager = \"p\"\n{}{}{}",
        node("p", 1).replace("island", "plc"),
        node("a", 5),
        node("b", 6)
    );
    fs::copy(fixture("plc.eds"), folder.path().join("plc.eds")).unwrap();
    fs::write(folder.path().join("n.toml"), text).unwrap();
    let check = objdict(folder.path(), "network check n.toml --format concise");
    let check = String::from_utf8_lossy(&check.stdout).into_owned();
    let count = check.lines().last().unwrap();
    let build = errors(&objdict(folder.path(), "network build n.toml --target concise -o out"));
    assert!(build.contains(count), "{count}: {build}");
}

/// A description is not written as XML into a DCF, nor as a text of CiA 306 into an XDC.
#[test]
fn a_node_keeps_the_syntax_of_its_description() {
    let folder = folder();
    fs::copy("fixtures/xdd/io-401.xdd", folder.path().join("b.xdd")).unwrap();
    for (line, ending) in [("b.xdd --node-id 5 -o x.dcf", "`.xdc`"), ("a.eds --node-id 5 -o x.xdc", "`.dcf`")]
    {
        let output = objdict(folder.path(), &format!("configure {line} --bit-rate 125"));
        assert_eq!(output.status.code(), Some(2), "{line}");
        assert!(errors(&output).contains(ending), "{}", errors(&output));
        assert!(fs::read_dir(folder.path()).unwrap().count() == 2, "{line}");
    }
}

/// As `dcf pack` and `network build` make it; the loss is said.
#[test]
fn a_concise_dcf_has_no_disabled_objects() {
    let folder = folder();
    let text = fs::read_to_string(SOURCE).unwrap();
    let marked = text.replacen(
        "[6200]",
        "[2F00]\nParameterName=Gain\nObjectType=0x7\nDataType=0x0006\nAccessType=rw\n\
        DefaultValue=5\nPDOMapping=0\n;CO_disabled=true\n\n[6200]",
        1,
    );
    assert_ne!(text, marked);
    fs::write(folder.path().join("a.eds"), marked).unwrap();
    let output = objdict(folder.path(), "convert a.eds -o a.cdcf.txt --node-id 3 --all");
    let told = crate::printed(&output.stdout);
    assert!(told.contains("left out: 0x2F00: the object is disabled"), "{told}{}", errors(&output));
    assert!(!fs::read_to_string(folder.path().join("a.cdcf.txt")).unwrap().contains("2F00:"));
}
