//! Flags: old spellings still work, and what is global works everywhere.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn run(folder: &Path, line: &str) -> Output {
    let fixtures = fs::canonicalize("fixtures").unwrap();
    let line = line.replace("FIXTURES", fixtures.to_str().unwrap());
    Command::new(crate::program()).args(line.split_whitespace()).current_dir(folder).output().unwrap()
}

/// The output of a command in a folder of its own, and the files that it wrote there.
fn result(line: &str) -> (Output, Vec<(String, Vec<u8>)>) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("node.toml"), "node-id = 7\nbaudrate = 125\n").unwrap();
    let output = run(folder.path(), line);
    let written = walk(folder.path());
    (
        output,
        written.into_iter().map(|path| (path.clone(), fs::read(folder.path().join(path)).unwrap())).collect(),
    )
}

fn walk(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        match path.is_dir() {
            true => names.extend(walk(&path).into_iter().map(|below| format!("{name}/{below}"))),
            false => names.push(name),
        }
    }
    names.sort();
    names
}

#[test]
fn a_link_to_a_workbench_leads_to_a_host_or_a_file() {
    let link =
        |address| run(Path::new("."), &format!("docs FIXTURES/eds/minimal.eds -o - --workbench {address}"));
    for address in ["https://example.com/workbench/", "../objdict-workbench.html", "workbench/#6041"] {
        let output = link(address);
        let page = String::from_utf8(output.stdout).unwrap();
        assert!(page.contains(&format!("<p><a href=\"{address}\">")), "{address}");
    }
    for address in ["javascript:alert(1)", "data:text/html,x", "ftp://example.com/", "a\"b", "<a>"] {
        let output = link(address);
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && message.contains("expected a URL such as"), "{message}");
    }
}

/// Each flag as it was called before, and as it is called now.
const RENAMED: [(&str, &str); 13] = [
    (
        "generate FIXTURES/eds/minimal.eds --target c --out gen",
        "generate FIXTURES/eds/minimal.eds --target c -o gen",
    ),
    ("docs FIXTURES/eds/minimal.eds --out page.html", "docs FIXTURES/eds/minimal.eds --output page.html"),
    (
        "docs FIXTURES/eds/minimal.eds -o - --format markdown",
        "docs FIXTURES/eds/minimal.eds -o - --to markdown",
    ),
    (
        "generate FIXTURES/eds/minimal.eds --target c -o gen --report size --report-format json",
        "generate FIXTURES/eds/minimal.eds --target c -o gen --report size --format json",
    ),
    (
        "convert FIXTURES/eds/minimal.eds -o a.dcf --node-id 5 --baudrate 125 --node-name pump",
        "convert FIXTURES/eds/minimal.eds -o a.dcf --node-id 5 --bit-rate 125 --name pump",
    ),
    (
        "configure FIXTURES/eds/minimal.eds -o a.dcf --node-id 5 --baudrate 125 --node-name pump",
        "configure FIXTURES/eds/minimal.eds -o a.dcf --node-id 5 --bit-rate 125 --name pump",
    ),
    (
        "configure FIXTURES/eds/minimal.eds --from node.toml",
        "configure FIXTURES/eds/minimal.eds --settings node.toml --from eds",
    ),
    (
        "dcf pack FIXTURES/dcf/encoder-406-node3.dcf --format hex",
        "dcf pack FIXTURES/dcf/encoder-406-node3.dcf --to hex",
    ),
    ("man pages", "man -o pages"),
    (
        "new --digital-inputs 8 --date 2026-11-21 -o node.toml --to eds --force",
        "new --digital-inputs 8 --date 2026-11-21 -o node.toml --to eds --overwrite",
    ),
    (
        "new --digital-inputs 8 --analogue-inputs 2 --date 2026-11-21 -o io.eds",
        "new --digital-inputs 8 --analog-inputs 2 --date 2026-11-21 --output io.eds",
    ),
    ("fmt --check FIXTURES/eds/minimal.eds", "fmt --check FIXTURES/eds/minimal.eds --from eds"),
    (
        "check FIXTURES/broken/octal.eds --severity cia306/octal-number=off",
        "check FIXTURES/broken/octal.eds --ignore cia306/octal-number",
    ),
];

#[test]
fn every_old_spelling_still_works() {
    for (old, new) in RENAMED {
        let (old_output, old_files) = result(old);
        let (output, files) = result(new);
        assert!(output.status.code() < Some(2), "{new}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(old_output == output, "`{old}`: {old_output:?}\n`{new}`: {output:?}");
        assert!(old_files == files, "`{old}` and `{new}` write different files");
    }
}

/// The same word is for the same thing in every command.
#[test]
fn a_new_description_has_the_format_that_is_asked_for() {
    let (output, _) = result("new --digital-inputs 8 --date 2026-11-21 --to xdd -o -");
    assert!(output.stdout.starts_with(b"<?xml"), "{output:?}");
    let (output, files) = result("new --digital-inputs 8 --date 2026-11-21 --to json -o device");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(files.iter().any(|(name, bytes)| name == "device" && bytes.starts_with(b"{")));
}

/// What a configuration switches off does not prevent a DCF.
#[test]
fn a_configuration_counts_for_configure() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("objdict.toml"), "[rules]\ncia301 = 'off'\n").unwrap();
    fs::copy("fixtures/eds/io-401.eds", folder.path().join("io.eds")).unwrap();
    let code = |options: &str| {
        let line = format!("configure io.eds --node-id 5 --bit-rate 250 --set 1800:1=0x601 {options}");
        run(folder.path(), &line).status.code()
    };
    assert_eq!((code("--no-config"), code(""), code("--config objdict.toml")), (Some(1), Some(0), Some(0)));
}

#[test]
fn quiet_and_verbose_are_global() {
    let errors = |line: &str| String::from_utf8(result(line).0.stderr).unwrap();
    let convert = "convert FIXTURES/eds/minimal.eds -o a.dcf --node-id 5";
    assert!(errors(convert).starts_with("note: "));
    assert_eq!(errors(&format!("{convert} -q")), "");
    assert_eq!(errors(&format!("--quiet {convert}")), "");
    // what became of files is said neither there nor on the standard output
    for line in [
        convert,
        "convert FIXTURES/eds/minimal.eds -o a.xdd",
        "convert FIXTURES/eds/minimal.eds FIXTURES/eds/io-401.eds -o out --to json",
        "convert FIXTURES/dcf/io-401-node5.dcf -o a.dbc",
        "configure FIXTURES/eds/minimal.eds --node-id 5 -o a.dcf",
        "generate FIXTURES/eds/minimal.eds --target c -o out",
        "docs FIXTURES/eds/minimal.eds -o a.html",
        "dcf pack FIXTURES/dcf/io-401-node5.dcf -o a.cdcf",
        "new --digital-inputs 8 -o new.eds",
        "network build FIXTURES/network/chapter4.toml --target dcf -o out",
    ] {
        assert!(!result(line).0.stdout.is_empty(), "{line}");
        let (output, files) = result(&format!("{line} -q"));
        assert_eq!((output.stdout, output.stderr), (Vec::new(), Vec::new()), "{line}");
        assert!(files.len() > 1, "{line}");
    }
    let (output, _) = result("convert FIXTURES/eds/minimal.eds --to xdd -q");
    assert!(output.stdout.starts_with(b"<?xml") && output.stderr.is_empty());
    assert!(errors(&format!("{convert} --verbose")).contains("eds/minimal.eds\nnote: "));
    assert!(errors("check -v FIXTURES/eds/minimal.eds --no-config").starts_with("reading "));
    assert!(errors("show -q no-such-file").starts_with("error: "), "errors are no notes");
}

#[test]
fn rules_are_selected_and_ignored() {
    let found = |options: &str| {
        let (output, _) = result(&format!("check FIXTURES/torture --no-config --format concise {options}"));
        let text = String::from_utf8(output.stdout).unwrap();
        let rule = |line: &str| Some(line.split(": ").nth(1)?.split_once(' ')?.1.to_owned());
        text.lines().filter_map(rule).collect::<Vec<String>>()
    };
    let all = found("");
    let has = |group: &str| all.iter().any(|rule| rule.starts_with(group));
    assert!(has("cia301/") && has("cia306/"), "{all:?}");
    let selected = found("--select cia306,cia301/no-such-object");
    assert!(selected.is_empty(), "an unknown rule is an error");
    let selected = found("--select cia306");
    assert!(!selected.is_empty() && selected.iter().all(|rule| rule.starts_with("cia306/")), "{selected:?}");
    let ignored = found("--ignore cia306");
    assert!(!ignored.is_empty() && !ignored.iter().any(|rule| rule.starts_with("cia306/")), "{ignored:?}");
    assert!(found("--select cia306 --ignore cia306").is_empty());
}

#[test]
fn a_severity_stops_the_generation() {
    let code = |deny: &str| {
        let line = format!("generate FIXTURES/torture/03_bom.eds --no-config --target concise -o gen{deny}");
        result(&line).0.status.code()
    };
    assert_eq!(code(""), Some(0));
    assert_eq!(code(" --deny warning"), Some(1));
    assert_eq!(code(" --deny warning --force"), Some(0));
}

#[test]
fn only_what_makes_a_table_wrong_stops_it() {
    let text = fs::read_to_string("fixtures/eds/minimal.eds").unwrap().replace('\r', "");
    let folder = tempfile::tempdir().unwrap();
    let vendor_id = "[1018sub1]\nParameterName=Vendor-ID\nObjectType=0x7\nDataType=0x0007\nAccessType=ro\n";
    let count = "[1018sub0]\nParameterName=Highest sub-index supported\nObjectType=0x7\nDataType=0x0005\n";
    let without_type =
        |section: &str| section.replace("DataType=0x0007\n", "").replace("DataType=0x0005\n", "");
    let type_1000 = "DataType=0x0007\nAccessType=ro\nDefaultValue=0x00000000\n";
    let cases = [
        (count, without_type(count), "", 0),
        // CiA 301 has one type for it
        (vendor_id, without_type(vendor_id), "", 0),
        (vendor_id, without_type(vendor_id).replace("[1018sub1]", "[1018sub7]"), "", 1),
        (vendor_id, vendor_id.replace("AccessType=ro", "AccessType=(ro)"), "", 0),
        (vendor_id, vendor_id.replace("AccessType=ro", "AccessType=yes"), "", 1),
        ("ObjectType=0x9\nSubNumber=5", "ObjectType=RECORD\nSubNumber=5".to_owned(), "", 1),
        (type_1000, type_1000.replace("0x0007\n", "0x0007\nDataType=0x0007\n"), "", 0),
        (type_1000, type_1000.replace("0x0007\n", "0x0007\nDataType=0x0005\n"), "", 1),
        // which line a tool reads makes a fix certain, but does not change what is read
        (type_1000, type_1000.replace("0x0007\n", "0x0007\nDataType=0x0005\n"), "compat = ['dcf-tools']", 1),
        // the next object is lost
        ("[1018]\n", String::new(), "", 1),
        ("[1000]\n", "[1000\n".to_owned(), "", 0),
        (type_1000, "DataType=0x000F\nAccessType=rw\nDefaultValue=0\n".to_owned(), "", 0),
        (
            "ObjectType=0x7\nDataType=0x0007\nAccessType=ro\nDefaultValue=0x00000000",
            "ObjectType=0x2\nDefaultValue=0".to_owned(),
            "",
            0,
        ),
        // no entry depends on these sections
        ("[FileInfo]\n", "from the archive\n[FileInfo]\nCreatedBy=another\njunk\n".to_owned(), "", 0),
        ("[FileInfo]\n", "[Comments]\nLines=0\n[Comments]\nLines=0\n[FileInfo]\n".to_owned(), "", 0),
        // a header that is malformed, or alone in its line; a merge
        ("[FileInfo]\n", "[FileInfo]\n2000]\n".to_owned(), "", 1),
        ("[FileInfo]\n", "[FileInfo]\n2000sub1\n".to_owned(), "", 1),
        ("[FileInfo]\n", "[FileInfo]\n<<<<<<< HEAD\n".to_owned(), "", 1),
        ("[1000]\n", "[1000]\njunk\n".to_owned(), "", 1),
    ];
    for (old, new, config, expected) in cases {
        assert!(text.contains(old), "{old}");
        fs::write(folder.path().join("d.eds"), text.replacen(old, &new, 1)).unwrap();
        fs::write(folder.path().join("objdict.toml"), config).unwrap();
        let output = run(folder.path(), "generate d.eds --target rust,c -o gen");
        assert_eq!(
            output.status.code(),
            Some(expected),
            "{new}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
    let text = fs::read_to_string("fixtures/xdd/valve.xdd").unwrap();
    for (index, expected) in [("0x1001", 0), ("10G1", 1)] {
        let new =
            text.replacen("<CANopenObject index=\"1001\"", &format!("<CANopenObject index=\"{index}\""), 1);
        assert_ne!(new, text);
        fs::write(folder.path().join("d.xdd"), new).unwrap();
        let output = run(folder.path(), "generate d.xdd --target rust --no-config -o gen");
        assert_eq!(output.status.code(), Some(expected), "{index}");
    }
    // one stack reads a mapping of the wrong length in another way than the others
    let text = fs::read_to_string("fixtures/eds/io-401.eds").unwrap();
    let new = text.replacen("=0x60000108", "=0x60000110", 1);
    assert_ne!(new, text);
    fs::write(folder.path().join("d.eds"), new).unwrap();
    for (target, expected) in [("c,canopennode", 0), ("c,canopen-stack", 1)] {
        let output = run(folder.path(), &format!("generate d.eds --target {target} --no-config -o gen"));
        assert_eq!(output.status.code(), Some(expected), "{target}");
    }
}

/// Tables that the stack does not start with are written, for it can be configured without the service, but not without an error.
#[test]
fn a_stack_that_does_not_start_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let eds = fs::read_to_string("fixtures/eds/io-401.eds").unwrap();
    let at = eds.find("[1017]").unwrap();
    let (before, behind) = eds.split_at(at);
    let wrong = format!("{before}{}", behind.replacen("DataType=0x0006", "DataType=0x0007", 1));
    fs::write(folder.path().join("d.eds"), wrong).unwrap();
    for (force, code) in [("", 1), (" --force", 0)] {
        let output = run(
            folder.path(),
            &format!("generate d.eds --target canopennode --no-config -o gen --overwrite{force}"),
        );
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{told}");
        let expected = "error: canopennode: 0x1017sub0: the entry has 4 bytes, but the stack reads 2; the stack does not start\n  help: use a data type of 2 bytes\n";
        assert!(told.contains(expected), "{told}");
        assert!(folder.path().join("gen/OD.c").exists());
    }
}

#[test]
fn objects_that_the_stack_needs_are_added_to_the_description() {
    let folder = tempfile::tempdir().unwrap();
    for (fixture, name) in [("eds/minimal.eds", "d.eds"), ("xdd/valve.xdd", "d.xdd")] {
        let old = fs::read_to_string(Path::new("fixtures").join(fixture)).unwrap();
        fs::write(folder.path().join(name), &old).unwrap();
        let line = format!("generate {name} --target canopennode --no-config -o gen --add-missing");
        let output = run(folder.path(), &line);
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains(&format!("note: added 1003h, 1014h to `{name}`")), "{said}");
        assert!(!said.contains("is missing"), "{said}");
        let new = fs::read_to_string(folder.path().join(name)).unwrap();
        let is_kept = |line: &&str| new.contains(line);
        let changed = old.lines().filter(|line| !is_kept(line)).count();
        assert!(changed <= 4, "{changed} lines are not as they were");
        let found = |options: &str| {
            let line =
                format!("check {name} --no-config --format concise --ignore cia306/file-name {options}");
            String::from_utf8(run(folder.path(), &line).stdout).unwrap()
        };
        assert!(!found("").contains(" error "), "{}", found(""));
        assert_eq!(found("--compat canopennode").matches("portability/no-error-history").count(), 0);
        let again = run(folder.path(), &line);
        assert!(!String::from_utf8(again.stderr).unwrap().contains("added"));
    }
    let output = run(folder.path(), "generate d.eds --target rust -o gen --add-missing");
    assert!(
        String::from_utf8(output.stderr).unwrap().contains("`--add-missing` is for the target `canopennode`")
    );
}

#[test]
fn a_cache_changes_no_report() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name);
    let minimal = fs::read_to_string("fixtures/eds/minimal.eds").unwrap();
    fs::write(file("minimal.eds"), &minimal).unwrap();
    fs::copy("fixtures/broken/mixed-eol.eds", file("mixed-eol.eds")).unwrap();
    // what a comment suppresses is counted in reports
    fs::write(file("renamed.eds"), format!("; objdict: allow cia306/file-name\r\n{minimal}")).unwrap();
    let check = |line: &str| {
        let Output { status, stdout, stderr } = run(folder.path(), line);
        (status.code(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
    };
    for format in ["text", "concise", "json", "sarif", "github", "gitlab", "junit"] {
        let line = format!("check --format {format}");
        let expected = check(&line);
        let cached = format!("{line} --cache known");
        assert_eq!((check(&cached), check(&cached)), (expected.clone(), expected), "{format}");
        assert_eq!(fs::read_to_string(file("known")).unwrap().lines().count(), 2, "the head and minimal.eds");
    }
    // a hash that no comment can give to another file; what an older objdict has written counts for nothing
    let known = fs::read_to_string(file("known")).unwrap();
    assert!(known.lines().last().is_some_and(|key| key.len() == 64));
    fs::write(file("known"), known.replace("objdict cache 2", "objdict cache 1")).unwrap();
    assert_eq!(check("check minimal.eds --cache known").0, Some(0));
    assert!(fs::read_to_string(file("known")).unwrap().starts_with("objdict cache 2\n"));
    // another setting, a configuration and another content count
    let found = |line: &str| {
        !check(&format!("check --format concise --cache known {line}")).1.starts_with("no findings")
    };
    assert!(!found("minimal.eds") && found("minimal.eds --profile 402"));
    assert!(!found("minimal.eds"));
    fs::write(file("objdict.toml"), "profiles = [\"402\"]\n").unwrap();
    assert!(found("minimal.eds"));
    fs::remove_file(file("objdict.toml")).unwrap();
    fs::write(file("minimal.eds"), minimal.replace("[1018sub1]", "[1018sub2]")).unwrap();
    assert!(found("minimal.eds"));
    // another file is not written over, and a cache that cannot be used makes the check slower alone
    for cache in ["minimal.eds", "mixed-eol.eds", "."] {
        let before = fs::read(file(cache)).ok();
        let (code, stdout, stderr) = check(&format!("check minimal.eds --cache {cache}"));
        let (expected, shown, _) = check("check minimal.eds");
        assert_eq!((code, &stdout), (expected, &shown), "{cache}");
        assert!(stderr.starts_with("note: ") && stderr.contains("so every file is checked"), "{stderr}");
        assert_eq!(fs::read(file(cache)).ok(), before);
    }
    fs::write(file("known"), b"objdict cache 2\n\xFF\x00garbage\n").unwrap();
    assert_eq!(check("check minimal.eds --cache known").0, check("check minimal.eds").0);
}

#[test]
fn a_configuration_is_checked_beside_its_eds() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name);
    let found = |line: &str| {
        let output = run(folder.path(), &format!("check --format concise {line}"));
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    fs::copy("fixtures/dcf/io-401-node5.dcf", file("io-401-node5.dcf")).unwrap();
    assert_eq!(found("io-401-node5.dcf --cache known").0, Some(0));
    let eds = fs::read_to_string("fixtures/eds/io-401.eds").unwrap();
    // another default in the EDS, which comes later; what is cached does not hide it
    let other = eds.replace("[6002sub1]\r\n", "[6002sub1]\r\nLowLimit=0\r\nHighLimit=4\r\n");
    let other = other.replace("[6002sub2]\r\n", "[6002sub2]\r\nLowLimit=0\r\nHighLimit=4\r\n");
    assert_ne!(other, eds);
    fs::write(file("io-401.eds"), &other).unwrap();
    let (code, text) = found("io-401-node5.dcf --cache known");
    assert_eq!((code, text.matches("configuration/value-outside-limits").count()), (Some(1), 1), "{text}");
    // the one that is named comes first, and must be of a type
    assert_eq!(found("io-401-node5.dcf --eds FIXTURES/eds/io-401.eds").0, Some(0));
    assert_eq!(found("io-401-node5.dcf --eds io-401-node5.dcf").0, Some(2));
    assert_eq!(found("io-401-node5.dcf --eds missing.eds").0, Some(2));
    // a link may lead out of the folder, and a DCF is the EDS of none
    #[cfg(unix)]
    {
        fs::rename(file("io-401.eds"), file("moved.eds")).unwrap();
        std::os::unix::fs::symlink("moved.eds", file("io-401.eds")).unwrap();
        assert_eq!(found("io-401-node5.dcf").0, Some(0));
        fs::remove_file(file("io-401.eds")).unwrap();
    }
    fs::copy("fixtures/dcf/drive-402-node8.dcf", file("io-401.eds")).unwrap();
    assert_eq!(found("io-401-node5.dcf").0, Some(0));
}

#[test]
fn what_was_found_at_a_revision_is_not_reported_again() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("firmware/drive.eds");
    let git = |line: &str| {
        let identity = ["-c", "user.name=a", "-c", "user.email=a@b", "-c", "core.autocrlf=false"];
        let output = Command::new("git")
            .args(identity)
            .args(line.split(' '))
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    };
    let check = |line: &str| {
        let output = run(folder.path(), &format!("check --format concise {line}"));
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let text = fs::read_to_string("fixtures/eds/drive-402.eds").unwrap().replace("\r\n", "\n");
    let with_mistakes = |count: usize| text.replacen("AccessType=rw\n", "AccessType=rq\n", count);
    fs::create_dir(folder.path().join("firmware")).unwrap();
    fs::write(&file, with_mistakes(2)).unwrap();
    git("init --quiet");
    git("add .");
    git("commit --quiet -m first");
    assert!(check("firmware --since HEAD").1.starts_with("nothing to report in 1 file"));
    // one more of a known kind, behind lines that moved
    fs::write(&file, format!("; moved\n{}", with_mistakes(3))).unwrap();
    let (code, text) = check("firmware --since HEAD");
    assert_eq!((code, text.matches("`rq` is not a valid").count()), (Some(1), 1), "{text}");
    // a file that is new, and a revision that is none
    fs::copy(&file, folder.path().join("firmware/other.eds")).unwrap();
    assert!(check("firmware/other.eds --since HEAD").1.contains("; 2 more like this"));
    assert_eq!(check("firmware --since nothing").0, Some(2));
    assert_eq!(check("firmware --since=--output=x").0, Some(2));
}

#[test]
fn services_get_paths_from_the_folder_of_the_repository() {
    let folder = tempfile::tempdir().unwrap();
    let below = folder.path().join("firmware");
    fs::create_dir(&below).unwrap();
    fs::copy("fixtures/broken/orphan-sub.eds", below.join("orphan-sub.eds")).unwrap();
    let told = |format: &str, line: &str, variables: &[(&str, &Path)]| {
        let line = format!("check --format {format} orphan-sub.eds {line}");
        let mut command = Command::new(crate::program());
        command.args(line.split_whitespace()).current_dir(&below);
        for variable in ["GITHUB_WORKSPACE", "CI_PROJECT_DIR"] {
            command.env_remove(variable);
        }
        command.envs(variables.iter().copied());
        String::from_utf8(command.output().unwrap().stdout).unwrap()
    };
    for (format, from_here, from_above) in [
        ("github", "file=orphan-sub.eds", "file=firmware/orphan-sub.eds"),
        ("gitlab", "\"path\":\"orphan-sub.eds\"", "\"path\":\"firmware/orphan-sub.eds\""),
        ("sarif", "\"uri\":\"orphan-sub.eds\"", "\"uri\":\"firmware/orphan-sub.eds\""),
        ("junit", "name=\"orphan-sub.eds\"", "name=\"firmware/orphan-sub.eds\""),
    ] {
        assert!(told(format, "", &[]).contains(from_here), "{format}");
        for variable in ["GITHUB_WORKSPACE", "CI_PROJECT_DIR"] {
            assert!(told(format, "", &[(variable, folder.path())]).contains(from_above), "{format}");
        }
        assert!(told(format, "--base ..", &[]).contains(from_above), "{format}");
        // a job of another folder
        assert!(told(format, "", &[("GITHUB_WORKSPACE", &folder.path().join("other"))]).contains(from_here));
    }
}
