//! Patches in commands and build scripts, from files that the tests write.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use objdict::build_script::Builder;
use tempfile::TempDir;

/// Corrects the analogue inputs; its last change has no effect.
const PATCH: &str = r#"format = "objdict-patch/1"
vendor-id = 0x3F9
product-code = 0x10

[[change]]
at = "6401:1"
expect = { type = "i16" }
set = { max = 4095 }
reason = "the converter has 12 bits"
source = "manual 1.4, p. 31"

[[change]]
at = "1017"
set = { type = "u16" }
"#;

/// What is reported of the last change, once.
const NO_EFFECT: &str = "fix.patch.toml:13:6: warning patch/no-effect";

/// A folder with a description, and the patch.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let eds = fs::read("fixtures/eds/io-401.eds").unwrap();
    fs::write(folder.path().join("io-401.eds"), eds).unwrap();
    fs::write(folder.path().join("fix.patch.toml"), PATCH).unwrap();
    folder
}

/// As [`folder`], with a configuration that names the patch.
fn project() -> TempDir {
    let folder = folder();
    fs::write(folder.path().join("objdict.toml"), "patches = [\"*.patch.toml\"]\n").unwrap();
    folder
}

fn run(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(crate::program());
    command.args(arguments.split_whitespace()).current_dir(folder).output().unwrap()
}

/// What a command tells that succeeds, standard output first.
fn told(folder: &Path, arguments: &str) -> String {
    let output = run(folder, arguments);
    let told = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    assert!(output.status.success(), "{arguments}: {told}");
    told
}

fn text(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// Each command that makes something of a description applies the patches of `objdict.toml`, and `--no-config` does not.
#[test]
fn commands_apply_the_patches_of_the_configuration() {
    for (arguments, file) in [
        ("convert io-401.eds -o new.xdd", "new.xdd"),
        ("convert io-401.eds -o new.dbc --node-id 5", "new.dbc"),
        ("convert io-401.eds -o folder/ --to json", "folder/io-401.json"),
        ("configure io-401.eds --node-id 5 -o new.dcf", "new.dcf"),
        ("docs io-401.eds -o new.html", "new.html"),
        ("generate io-401.eds --target rust --output folder", "folder/od.rs"),
    ] {
        let folder = project();
        let told = told(folder.path(), arguments);
        assert!(text(folder.path(), file).contains("4095"), "{arguments}");
        if !arguments.starts_with("generate") {
            assert_eq!(told.matches(NO_EFFECT).count(), 1, "{arguments}: {told}");
        }
        run(folder.path(), &format!("{arguments} --no-config"));
        assert!(!text(folder.path(), file).contains("4095"), "{arguments} --no-config");
    }
}

/// What is shown and packed is what is checked and converted.
#[test]
fn commands_that_show_a_device_apply_them_too() {
    let folder = project();
    assert!(told(folder.path(), "show io-401.eds 6401:1").contains("4095"));
    // what the patch changes is a change from the file without it
    let plain = folder.path().join("plain");
    fs::create_dir(&plain).unwrap();
    fs::write(plain.join("objdict.toml"), "").unwrap();
    fs::copy(folder.path().join("io-401.eds"), plain.join("io-401.eds")).unwrap();
    let changes = |arguments: &str| {
        String::from_utf8(run(folder.path(), &format!("diff plain/io-401.eds io-401.eds {arguments}")).stdout)
            .unwrap()
    };
    assert!(changes("").contains("4095"), "{}", changes(""));
    assert!(changes("--no-config").contains("no changes"), "{}", changes("--no-config"));
    let patch = PATCH.replace("set = { type = \"u16\" }", "set = { default = 500 }");
    fs::write(folder.path().join("fix.patch.toml"), patch).unwrap();
    told(folder.path(), "dcf pack io-401.eds --node-id 5 --all --to text -o new.txt");
    assert!(text(folder.path(), "new.txt").contains("1017:00  UNSIGNED16  500"));
    fs::write(folder.path().join("objdict.toml"), "patches = [\"missing.patch.toml\"]\n").unwrap();
    for command in [
        "show io-401.eds",
        "modules io-401.eds",
        "conformance io-401.eds",
        "dcf pack io-401.eds --node-id 5 -o new.cdcf",
        "convert io-401.eds -o new.xdd",
        "docs io-401.eds -o new.html",
        "configure io-401.eds --node-id 5 -o new.dcf",
        "generate io-401.eds --target c -o new",
    ] {
        let output = run(folder.path(), command);
        assert!(matches!(output.status.code(), Some(1 | 2)), "{command}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("objdict.toml"), "{command}");
    }
}

#[test]
fn check_reports_what_patches_of_the_configuration_do() {
    let folder = project();
    let all = told(folder.path(), "check io-401.eds --deny error");
    assert_eq!(all.matches("`type` of `0x1017` is already `u16`").count(), 1, "{all}");
    let off = told(folder.path(), "check io-401.eds --severity patch/no-effect=off");
    assert!(!off.contains("already"), "{off}");
    let eds = text(folder.path(), "io-401.eds").replace("[6401sub1]", "[6401sub3]");
    fs::write(folder.path().join("io-401.eds"), eds).unwrap();
    let refused = run(folder.path(), "check io-401.eds");
    assert_eq!(refused.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&refused.stdout).contains("patch/expect-not-met"));
    for arguments in ["convert io-401.eds -o new.xdd", "configure io-401.eds --node-id 5 -o new.dcf"] {
        assert_eq!(run(folder.path(), arguments).status.code(), Some(2), "{arguments}");
    }
}

/// A description in several places is one file, so what a patch does in it is reported once.
#[test]
fn networks_have_patched_descriptions() {
    let folder = folder();
    let network = "[bus]\nbit-rate = 250\nmanager = \"m\"\n\
        [node.m]\nfile = \"io-401.eds\"\nid = 1\n[node.a]\nfile = \"io-401.eds\"\nid = 5\n";
    fs::write(folder.path().join("network.toml"), network).unwrap();
    let commands =
        ["network build network.toml --target dcf -o built", "convert network.toml -o built/new.dbc"];
    for arguments in commands {
        let told = told(folder.path(), &format!("{arguments} -p fix.patch.toml"));
        assert_eq!(told.matches(NO_EFFECT).count(), 1, "{arguments}: {told}");
    }
    let built = fs::read_dir(folder.path().join("built")).unwrap();
    let built = built.map(|file| fs::read_to_string(file.unwrap().path()).unwrap());
    let of_nodes = built.filter(|text| text.contains("[DeviceComissioning]")).collect::<Vec<_>>();
    assert!(!of_nodes.is_empty() && of_nodes.iter().all(|text| text.contains("HighLimit=4095")));
    fs::write(folder.path().join("objdict.toml"), "patches = [\"*.patch.toml\"]\n").unwrap();
    for arguments in
        commands.into_iter().chain(["network boot network.toml --summary", "docs network.toml -o page.html"])
    {
        let of_config = told(folder.path(), arguments);
        assert_eq!(of_config.matches(NO_EFFECT).count(), 1, "{arguments}: {of_config}");
        let without = told(folder.path(), &format!("{arguments} --no-config"));
        assert!(!without.contains(NO_EFFECT), "{arguments}: {without}");
    }
}

/// A patch with several problems is refused with each of them, in lines that can be read.
#[test]
fn commands_print_what_is_wrong_in_a_patch() {
    let folder = folder();
    let wrong = "format = \"objdict-patch/1\"\n[[change]]\nat = \"1017\"\nsett = { min = 0 }\n";
    fs::write(folder.path().join("wrong.patch.toml"), wrong).unwrap();
    let network = "[bus]\nbit-rate = 250\nmanager = \"m\"\n[node.m]\nfile = \"io-401.eds\"\nid = 1\n";
    fs::write(folder.path().join("network.toml"), network).unwrap();
    for arguments in [
        "check io-401.eds --format concise",
        "show io-401.eds",
        "convert io-401.eds -o new.xdd",
        "generate io-401.eds --target c -o new",
        "network check network.toml --format concise",
        "network show network.toml",
    ] {
        let output = run(folder.path(), &format!("{arguments} -p wrong.patch.toml"));
        let told = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        assert!(matches!(output.status.code(), Some(1 | 2)), "{arguments}: {told}");
        assert!(told.contains("no key `sett`") && told.contains("changes nothing"), "{arguments}: {told}");
        assert!(!told.contains('\u{FFFD}'), "{arguments}: {told}");
    }
}

#[test]
fn a_node_that_is_changed_in_place_keeps_its_text() {
    let folder = project();
    told(folder.path(), "configure io-401.eds --node-id 5 -o node.dcf --no-config");
    told(folder.path(), "configure node.dcf --node-id 6 --in-place");
    assert!(!text(folder.path(), "node.dcf").contains("4095"));
    let refused = run(folder.path(), "configure node.dcf --node-id 7 --in-place -p fix.patch.toml");
    assert_eq!(refused.status.code(), Some(2));
    let told = String::from_utf8(refused.stderr).unwrap();
    assert!(told.contains("`--patch` does not") && !told.contains("none of the files"), "{told}");
}

#[test]
fn a_build_script_applies_patches() {
    let folder = folder();
    let eds = folder.path().join("io-401.eds");
    let generated = |builder: Builder| {
        let (out, mut cargo) = (tempfile::tempdir().unwrap(), Vec::new());
        let built = builder.out_dir(out.path()).generate_to(&mut cargo);
        built.map(|_| (text(out.path(), "od.rs"), String::from_utf8(cargo).unwrap()))
    };
    let patch = folder.path().join("fix.patch.toml");
    let (code, cargo) = generated(Builder::new(&eds).patch(&patch)).unwrap();
    assert!(code.contains("4095"));
    assert!(cargo.contains(&format!("cargo:rerun-if-changed={}\n", patch.display())), "{cargo}");
    assert_eq!(cargo.matches("patch/no-effect").count(), 1, "{cargo}");
    assert!(!generated(Builder::new(&eds)).unwrap().0.contains("4095"));
    fs::write(&patch, PATCH.replace("\"i16\"", "\"i32\"")).unwrap();
    let error = generated(Builder::new(&eds).patch(&patch)).unwrap_err().to_string();
    assert!(error.contains("patch/expect-not-met"), "{error}");
}

/// The page is about the file that the vendor has, and says what its problems do in other tools; the patch is the correction.
#[test]
fn the_report_to_the_vendor_is_about_the_file_of_the_vendor() {
    let folder = folder();
    let eds = text(folder.path(), "io-401.eds");
    let (before, after) = eds.split_once("[1017]").unwrap();
    let eds = format!("{before}[1017]{}", after.replacen("DataType=0x0006", "DataType=0x0007", 1));
    let line =
        1 + eds[..before.len() + "[1017]".len() + after.find("DataType").unwrap()].matches('\n').count();
    fs::write(folder.path().join("io-401.eds"), eds).unwrap();
    told(folder.path(), "check io-401.eds -p fix.patch.toml --vendor-report with.md");
    let page = text(folder.path(), "with.md");
    assert!(page.starts_with("# Problems in `io-401.eds`\n\n- Vendor: objdict fixtures\n"), "{page}");
    assert!(page.contains("1 error, 0 warnings. The most important problems:\n"), "{page}");
    let first = page.split("## ").nth(1).unwrap();
    assert!(first.starts_with("1. 1017h"), "{first}");
    for said in [
        &format!("\nLine {line}, error. "),
        "\nCorrection: write `DataType=0x0006`.",
        "\n- canopennode: the stack does not start",
        "\nSource: CiA 301",
    ] {
        assert!(first.contains(said), "{said}: {first}");
    }
    assert!(page.ends_with(&format!("```toml\n{}\n```\n", PATCH.trim_end())), "{page}");
    // without one, the patch has what can be fixed
    run(folder.path(), "check io-401.eds --vendor-report without.md");
    assert!(!text(folder.path(), "without.md").contains("12 bits"));
}

#[test]
fn a_patch_in_place_of_a_description_is_named() {
    let folder = folder();
    let found = told(folder.path(), "identify fix.patch.toml");
    assert!(found.starts_with("fix.patch.toml: patch (CANopen) – its first key is `format`"), "{found}");
    for command in ["check", "show", "configure --node-id 5", "convert --to json"] {
        let output = run(folder.path(), &format!("{command} fix.patch.toml"));
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{command}");
        assert!(told.contains("is a patch, which corrects descriptions and describes no device"), "{told}");
        assert!(told.contains("help: `objdict patch check` compares it"), "{told}");
    }
}

/// A device.toml is configured as one, and not as what another ending says.
#[test]
fn the_short_source_of_a_device_is_configured() {
    let folder = tempfile::tempdir().unwrap();
    let toml = "format = \"objdict-device/1\"\nprofile = \"301@1\"\n\n[device]\nvendor-name = \"V\" # ours\n\
        vendor-number = 1\nproduct-name = \"P\"\nproduct-number = 2\nrevision-number = 3\nbit-rates = [125]\n";
    fs::write(folder.path().join("device.toml"), toml).unwrap();
    told(folder.path(), "configure device.toml --node-id 5 --bit-rate 125 -o node.toml");
    let node = text(folder.path(), "node.toml");
    assert!(node.contains("vendor-name = \"V\" # ours"), "the text stays: {node}");
    assert!(node.contains("[node]\nnode-id = 5\n") && node.contains("file-name = \"node.toml\""), "{node}");
    for (file, output, help) in [
        ("device.toml", "node.dcf", "name a file `.toml`"),
        ("device.toml", "node.xdc", "name a file `.toml`"),
        ("device.eds", "other.toml", "name a file `.dcf`"),
        ("device.xdd", "other.toml", "name a file `.xdc`"),
    ] {
        if file != "device.toml" {
            told(folder.path(), &format!("convert device.toml -o {file}"));
        }
        let refused = run(folder.path(), &format!("configure {file} --node-id 5 -o {output}"));
        assert_eq!(refused.status.code(), Some(2), "{file} {output}");
        assert!(String::from_utf8_lossy(&refused.stderr).contains(help), "{file} {output}");
        assert!(!folder.path().join(output).exists());
    }
}
